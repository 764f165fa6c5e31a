//! Loads and springs to the ground in closed form, gravity as an input.

mod support;

use mstmm::prelude::*;
use mstmm::{Dual, Point};
use mstmm_reference::Random;
use nalgebra::{Matrix3, UnitQuaternion, Vector2, Vector3};
use support::mechanism::random_quaternion;
use support::moving::energy_rate;
use support::{difference, worst};

const STATES: u64 = 50;

/// A closed form takes some tens of operations; a block's tensor has a condition of ten.
const TOLERANCE: f64 = 1e-13;

mstmm_chain! {
    /// A free block with all kinds of loads.
    chain Pushed {
        gravity = input;
        body Block {
            mass = 2 kg;
            com = [0.1, 0.2, -0.1] m;
            inertia = tensor(0.5, 0.6, 0.7, 0.05, -0.02, 0.1) kg*m^2 about com;
            output = [0.3, 0, 0.1] m turned rpy(10, 20, 30) deg;
            point tip = [1, -0.5, 0.2] m;
        }
        Block block;
        load wind { on = block; force = input; torque = input; }
        load push { on = block; at = tip; force = input; }
        load thrust {
            on = block; at = [0.2, 0.3, 0.4] m; axes = body; force = [1, -2, 3] N; torque = input;
        }
        load jet { on = block; at = output; axes = body; force = input; }
        load foot { on = block; at = input; force = [0.5, 0.6, 0.7] N; torque = [1, 2, 3] N*m; }
    }
}

const COM: Vector3<f64> = Vector3::new(0.1, 0.2, -0.1);

/// Newton's and Euler's laws about the centre of mass: forces act at their points, torques
/// anywhere.
#[test]
fn loads_act_at_their_points_along_their_axes() {
    let chain = Pushed::<f64>::new();
    let mut at = chain.workspace();
    let tensor = Matrix3::new(0.5, 0.05, -0.02, 0.05, 0.6, 0.1, -0.02, 0.1, 0.7);
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let [w, x, y, z] = random_quaternion(&mut random);
        let turn = UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(w, x, y, z));
        let mut any = |size: f64| Vector3::from_fn(|_, _| random.between(-size, size));
        let (place, velocity, spin) = (any(2.0), any(2.0), any(2.0));
        let mut state = chain.initial_state();
        let mut block = state.block_mut();
        block.set_position(place).set_orientation(turn).set_velocity(velocity).set_rate(spin);
        let inputs = PushedInputs {
            gravity: any(9.0),
            wind_force: any(9.0),
            wind_torque: any(9.0),
            push_force: any(9.0),
            thrust_torque: any(9.0),
            jet_force: any(9.0),
        };
        chain.solve_into(&state, &inputs, &mut at).expect("a regular chain");

        let forces = [
            (COM, inputs.wind_force),
            (Vector3::new(1.0, -0.5, 0.2), inputs.push_force),
            (Vector3::new(0.2, 0.3, 0.4), turn * Vector3::new(1.0, -2.0, 3.0)),
            (Vector3::new(0.3, 0.0, 0.1), turn * inputs.jet_force),
            (Vector3::zeros(), Vector3::new(0.5, 0.6, 0.7)),
        ];
        let couples =
            inputs.wind_torque + turn * inputs.thrust_torque + Vector3::new(1.0, 2.0, 3.0);
        let total: Vector3<f64> = forces.iter().map(|(_, force)| force).sum();
        let moments: Vector3<f64> =
            forces.iter().map(|(point, force)| (turn * (point - COM)).cross(force)).sum();
        let torque = turn.inverse() * (moments + couples);
        let turning =
            tensor.try_inverse().expect("a body") * (torque - spin.cross(&(tensor * spin)));
        let from_com = -COM;
        let seen = turning.cross(&from_com) + spin.cross(&spin.cross(&from_com));
        let linear = inputs.gravity + total / 2.0 + turn * seen;
        let expected = [linear.as_slice(), turning.as_slice()].concat();
        let fast = chain.accelerations(&state, &inputs).expect("a regular chain");
        let off = [
            difference(at.accelerations().as_slice(), &expected),
            difference(fast.as_slice(), &expected),
            // Free ends carry no load, whatever acts between them.
            ends(&at.points()) / total.norm(),
            difference(&[at.potential_energy()], &[0.0]),
        ]
        .into_iter()
        .fold(0.0, worst);
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

fn ends(points: &[Point<f64>]) -> f64 {
    let carried = |point: &Point<f64>| point.force().norm().max(point.moment().norm());
    points.iter().map(carried).fold(0.0, worst)
}

mstmm_chain! {
    /// A welded block, so that the hinge transmits all loads.
    chain Held {
        gravity = [0, 0, -10] m/s^2;
        body Arm {
            mass = 2 kg; com = [0.5, 0, 0] m; inertia = diag(0.1, 0.2, 0.2) kg*m^2 about com;
            output = [1, 0, 0] m;
        }
        ground -> weld root -> Arm near -> weld middle -> Arm far;
        load hook { on = near; at = output; force = [0, 3, 0] N; torque = [0, 7, 0] N*m; }
    }
}

/// A load changes the wrench inboard of its body and not outboard of it, [P, Eqs. (14), (15)].
#[test]
fn a_load_shows_in_z_before_its_body() {
    let chain = Held::<f64>::new();
    let mut at = chain.workspace();
    chain.solve_into(&chain.initial_state(), &chain.no_inputs(), &mut at).expect("a held chain");
    let same = |found: Vector3<f64>, expected: [f64; 3]| {
        assert!((found - Vector3::from(expected)).norm() < 1e-13, "{found} not {expected:?}");
    };
    // The force on a body at its input is +q, the torque −m.
    same(at.far().input().force(), [0.0, 0.0, 20.0]);
    same(-at.far().input().moment(), [0.0, -10.0, 0.0]);
    same(at.near().output().force(), [0.0, 0.0, 20.0]);
    same(at.near().input().force(), [0.0, -3.0, 40.0]);
    same(-at.near().input().moment(), [0.0, -40.0 - 7.0, -3.0]);
}

mstmm_chain! {
    /// A point mass on a spring without length, which is isotropic.
    chain Mass {
        body Drop { mass = 2 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        Drop drop;
        spring rope { on = drop; to = [1, 2, 3] m; stiffness = 18 N/m; damping = 0.8 N*s/m; }
    }
    chain Undamped {
        body Drop { mass = 2 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        Drop drop;
        spring rope { on = drop; to = [1, 2, 3] m; stiffness = 18 N/m; }
    }
    chain Long {
        body Drop { mass = 2 kg; com = [0, 0, 0] m; inertia = diag(1, 1, 1) kg*m^2 about com; }
        Drop drop;
        spring rope {
            on = drop; to = [1, 2, 3] m; stiffness = 18 N/m; damping = 0.8; length = 0.7 m;
        }
    }
    plane chain LongInPlane {
        body Drop { mass = 2 kg; com = [0, 0] m; inertia = 1 kg*m^2 about com; }
        Drop drop;
        spring rope { on = drop; to = [1, 2] m; stiffness = 18 N/m; damping = 0.8; length = 0.7 m; }
    }
    line chain LongOnLine {
        body Drop { mass = 2 kg; }
        Drop drop;
        spring rope { on = drop; to = 1 m; stiffness = 18 N/m; damping = 0.8; length = 0.7 m; }
    }
}

/// −(k (l − l₀) + c l̇) n
fn pulled<const D: usize>(
    from: nalgebra::SVector<f64, D>,
    velocity: nalgebra::SVector<f64, D>,
    length: f64,
) -> nalgebra::SVector<f64, D> {
    let direction = from.normalize();
    -direction * (18.0 * (from.norm() - length) + 0.8 * velocity.dot(&direction)) / 2.0
}

#[test]
fn springs_pull_along_themselves() {
    let (mass, long) = (Mass::<f64>::new(), Long::<f64>::new());
    let (plane, line) = (LongInPlane::<f64>::new(), LongOnLine::<f64>::new());
    let ground = Vector3::new(1.0, 2.0, 3.0);
    let mut largest = 0.0;
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let mut any = |size: f64| Vector3::from_fn(|_, _| random.between(-size, size));
        let (from, velocity) = (any(2.0), any(3.0));
        let (from2, velocity2) = (from.xy(), velocity.xy());
        let mut state = mass.initial_state();
        state.drop_mut().set_position(ground + from).set_velocity(velocity);
        let mut same = long.initial_state();
        same.drop_mut().set_position(ground + from).set_velocity(velocity);
        let mut flat = plane.initial_state();
        flat.drop_mut().set_position(Vector2::new(1.0, 2.0) + from2).set_velocity(velocity2);
        let mut along = line.initial_state();
        along.drop_mut().set_position(1.0 + from.x).set_velocity(velocity.x);
        let stored = 9.0 * (from.norm() - 0.7).powi(2);
        let taken = 0.8 * velocity.dot(&from.normalize()).powi(2);
        let power = energy_rate(&long, &Long::<Dual<f64>>::new(), &same, &long.no_inputs());
        let accelerations = mass.accelerations(&state, &mass.no_inputs()).expect("regular");
        let of_long = long.accelerations(&same, &long.no_inputs()).expect("regular");
        let of_flat = plane.accelerations(&flat, &plane.no_inputs()).expect("regular");
        let of_line = line.accelerations(&along, &line.no_inputs()).expect("regular");
        let expected =
            pulled(from.fixed_rows::<1>(0).into(), velocity.fixed_rows::<1>(0).into(), 0.7);
        let off = [
            difference(&accelerations.as_slice()[..3], pulled(from, velocity, 0.0).as_slice()),
            difference(&of_long.as_slice()[..3], pulled(from, velocity, 0.7).as_slice()),
            difference(&of_flat.as_slice()[..2], pulled(from2, velocity2, 0.7).as_slice()),
            difference(of_line.as_slice(), expected.as_slice()),
            difference(&[long.energy(&same).potential], &[stored]),
            difference(&[power], &[-taken]),
        ]
        .into_iter()
        .fold(0.0, worst);
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

/// ω² = k/m: after a whole period in an ellipse the mass is back, after a quarter on the other
/// axis.
#[test]
fn a_spring_without_length_is_harmonic_in_all_directions() {
    let chain = Undamped::<f64>::new();
    let (place, velocity) = (Vector3::new(0.5, -0.2, 0.1), Vector3::new(1.0, 2.0, -1.0));
    let ground = Vector3::new(1.0, 2.0, 3.0);
    let mut state = chain.initial_state();
    state.drop_mut().set_position(ground + place).set_velocity(velocity);
    let mut dopri5 = Dopri5::new(1e-13, 1e-13);
    for quarter in 1..=8 {
        let (sine, cosine) = (f64::from(quarter) * std::f64::consts::FRAC_PI_2).sin_cos();
        let time = f64::from(quarter) * std::f64::consts::FRAC_PI_2 / 3.0;
        dopri5.advance_to(&chain, &mut state, time, |_, _| chain.no_inputs()).expect("steps");
        let expected = ground + place * cosine + velocity * (sine / 3.0);
        // Some hundred steps, each within the tolerance.
        let off = (state.drop().position() - expected).norm();
        assert!(off < 1e-11, "after {quarter} quarters: {off:e}");
    }
}

/// Where a spring has no direction, nothing damps, and nothing is NaN.
#[test]
fn a_spring_at_its_foot_is_finite() {
    macro_rules! check {
        ($name:ident $set:expr) => {
            let chain = $name::<f64>::new();
            let mut state = chain.initial_state();
            #[allow(clippy::redundant_closure_call)]
            $set(&mut state);
            let found = chain.accelerations(&state, &chain.no_inputs()).expect("regular");
            assert!(found.iter().all(|a| a.abs() < 10.0), "{found}");
            assert!(chain.energy(&state).total().is_finite());
            Rk4::new(1e-3)
                .advance_to(&chain, &mut state, 0.1, |_, _| chain.no_inputs())
                .expect("steps that pass");
        };
    }
    let (ground, velocity) = (Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.1, 0.2, 0.3));
    check!(Mass |state: &mut MassState<f64>| {
        state.drop_mut().set_position(ground).set_velocity(velocity);
    });
    check!(Long |state: &mut LongState<f64>| {
        state.drop_mut().set_position(ground).set_velocity(velocity);
    });
    check!(LongInPlane |state: &mut LongInPlaneState<f64>| {
        state.drop_mut().set_position(ground.xy()).set_velocity(velocity.xy());
    });
    check!(LongOnLine |state: &mut LongOnLineState<f64>| {
        state.drop_mut().set_position(1.0).set_velocity(0.1);
    });
    // Without length nothing at all acts there.
    let chain = Mass::<f64>::new();
    let mut state = chain.initial_state();
    state.drop_mut().set_position(ground).set_velocity(velocity);
    let found = chain.accelerations(&state, &chain.no_inputs()).expect("regular");
    assert_eq!(found.norm(), 0.0);
}

macro_rules! arm {
    ($name:ident $($gravity:tt)*) => {
        mstmm_chain! { chain $name {
            gravity = $($gravity)*;
            body Link {
                mass = 1.5 kg;
                com = [0.2, -0.1, 0.1] m;
                output = [0.5, 0.1, -0.2] m turned rpy(20, -30, 50) deg;
                inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            }
            ground -> ball a -> Link first -> pin(y) b -> Link second;
        } }
    };
}

arm! { Given input }
arm! { Constant [1, -9.8, 2] m/s^2 }

/// The same motion and the same loads; but what is given anew at each step has no potential.
#[test]
fn gravity_may_be_an_input() {
    let (given, constant) = (Given::<f64>::new(), Constant::<f64>::new());
    let inputs = GivenInputs { gravity: Vector3::new(1.0, -9.8, 2.0) };
    let (mut found, mut expected) = (given.workspace(), constant.workspace());
    for seed in 0..STATES {
        let mut random = Random::new(seed);
        let (mut state, mut same) = (given.initial_state(), constant.initial_state());
        state.coordinates_mut()[..4].copy_from_slice(&random_quaternion(&mut random));
        state.coordinates_mut()[4] = random.between(-3.0, 3.0);
        state.rates_mut().iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
        same.coordinates_mut().copy_from_slice(state.coordinates());
        same.rates_mut().copy_from_slice(state.rates());
        given.solve_into(&state, &inputs, &mut found).expect("regular");
        constant.solve_into(&same, &constant.no_inputs(), &mut expected).expect("regular");
        let off = difference(found.accelerations().as_slice(), expected.accelerations().as_slice());
        let loads = |points: &[Point<f64>]| -> Vec<f64> {
            points
                .iter()
                .flat_map(|p| [p.force().data.0[0], p.moment().data.0[0]].concat())
                .collect()
        };
        let off = worst(off, difference(&loads(&found.points()), &loads(&expected.points())));
        assert!(off < TOLERANCE, "seed {seed}: {off:e}");
        assert_eq!(found.potential_energy(), 0.0);
        assert_eq!(found.kinetic_energy(), expected.kinetic_energy());
    }
}
