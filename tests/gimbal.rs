//! Gimbals against balls at the same orientation, after a map of rates and efforts; the closed form of a steady
//! precession is in `src/hinges/gimbal.md`. With the angular velocity `ω = E(q) q̇` in outboard axes and its
//! derivative `ω̇ = E q̈ + Ė q̇`, efforts along the angles are `Eᵀ` times the torque of a ball.

// A chain here starts at a singular pose, which gives a warning.
#![allow(deprecated)]

mod support;

use mstmm::prelude::*;
use mstmm::{Dual, Error};
use mstmm_reference::Random;
use nalgebra::{Matrix3, Rotation3, SMatrix, SVector, UnitQuaternion, UnitVector3, Vector3};
use support::difference;

const SEEDS: u64 = 30;

/// The axes of the gimbals below.
const AXES: [[f64; 3]; 3] = [[1.0, 2.0, 0.0], [0.0, 1.0, 0.3], [0.5, 0.0, -1.0]];

/// Two chains that differ only in a hinge.
macro_rules! twins {
    ($($gimbal:ident $ball:ident, [$($before:tt)*] [$($after:tt)*];)*) => { $(
        twins!(@chain $gimbal [$($before)* gimbal([1, 2, 0], [0, 1, 0.3], [0.5, 0, -1]) joint $($after)*]);
        twins!(@chain $ball [$($before)* ball joint $($after)*]);
    )* };
    (@chain $name:ident [$($route:tt)*]) => {
        mstmm_chain! {
            chain $name {
                answers = [basic, bias_efforts, coriolis_matrix, derivatives, linearize];
                gravity = [1, -9.8, 2] m/s^2;
                body Arm {
                    mass = 1.5 kg;
                    com = [0.2, -0.1, 0.3] m;
                    output = [0.4, 0.1, 0] m turned rpy(20, -30, 50) deg;
                    inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
                }
                $($route)*;
                hinge joint { torque = input; }
            }
        }
    };
}

twins! {
    Outward OutwardBall, [ground -> pin(z) near -> Arm first ->] [-> Arm second -> pin(y) far -> Arm third];
    // The route leads to the ground: the hinge is reversed.
    Inward InwardBall, [Arm third -> pin(z) near -> Arm second ->] [-> Arm first -> pin(y) far -> ground];
    Free FreeBall, [Arm first ->] [-> Arm second -> pin(y) far -> Arm third];
}

fn random_vector(random: &mut Random, size: f64) -> Vector3<f64> {
    Vector3::from_fn(|_, _| random.between(-size, size))
}

/// Returns the orientation at given angles.
fn orientation(angles: Vector3<f64>) -> UnitQuaternion<f64> {
    let [a, b, c] = [0, 1, 2].map(|k| {
        let axis = UnitVector3::new_normalize(AXES[k].into());
        UnitQuaternion::from_axis_angle(&axis, angles[k])
    });
    a * b * c
}

/// Returns `E`, and `Ė` at given rates. The axis of the third rotation is constant in outboard axes.
fn map(angles: Vector3<f64>, rates: Vector3<f64>) -> [Matrix3<f64>; 2] {
    let [a, b, c] = AXES.map(|axis| UnitVector3::new_normalize(axis.into()));
    let by_third = Rotation3::from_axis_angle(&c, angles.z).inverse();
    let by_second = by_third * Rotation3::from_axis_angle(&b, angles.y).inverse();
    let (first, second) = (by_second * *a, by_third * *b);
    let (third, still) = (*c, Vector3::zeros());
    // Seen from the outboard side, an axis rotates against the rotations that follow it.
    let of_first = first.cross(&(second * rates.y + third * rates.z));
    let of_second = second.cross(&(third * rates.z));
    [[first, second, third], [of_first, of_second, still]]
        .map(|columns| Matrix3::from_columns(&columns))
}

/// Returns random angles at which no rates are much higher than the angular velocity.
fn regular_angles(random: &mut Random) -> Vector3<f64> {
    loop {
        let angles = random_vector(random, 3.0);
        let [map, _] = map(angles, Vector3::zeros());
        if map.determinant().abs() > 0.3 {
            return angles;
        }
    }
}

/// Returns a matrix for all rates: the identity, and `block` for those of the hinge.
fn whole<const N: usize>(first: usize, block: &Matrix3<f64>) -> SMatrix<f64, N, N> {
    let mut whole = SMatrix::<f64, N, N>::identity();
    whole.fixed_view_mut::<3, 3>(first, first).copy_from(block);
    whole
}

macro_rules! compare {
    ($($test:ident $gimbal:ident $inputs:ident, $ball:ident $of_ball:ident, $rates:literal from $first:literal;)*) => { $(
        #[test]
        fn $test() -> Result<(), Error> {
            const N: usize = $rates;
            for seed in 0..SEEDS {
                let mut random = Random::new(seed);
                let (gimbal, ball) = ($gimbal::<f64>::new(), $ball::<f64>::new());
                let (mut state, mut same) = (gimbal.initial_state(), ball.initial_state());
                let coordinates = state.q.len();
                let start = coordinates - N + $first;
                // Quaternions of a floating base stay.
                state.q.iter_mut().skip(7 * (coordinates - N)).for_each(|q| *q = random.between(-3.0, 3.0));
                state.v.iter_mut().for_each(|v| *v = random.between(-2.0, 2.0));
                let angles = regular_angles(&mut random);
                state.joint_mut().set_angles(angles);
                for (k, q) in state.q.iter().enumerate() {
                    match k {
                        _ if k < start => same.q[k] = *q,
                        _ if k >= start + 3 => same.q[k + 1] = *q,
                        _ => {}
                    }
                }
                let [map, map_rate] = map(angles, state.joint().rates());
                let (e, change) = (whole::<N>($first, &map), whole::<N>($first, &map_rate));
                let change = change - whole::<N>($first, &Matrix3::zeros());
                same.v = e * state.v;
                same.joint_mut().set_orientation(orientation(angles));
                let torque = random_vector(&mut random, 5.0);
                let driven = $inputs { joint: torque };
                let likewise = $of_ball { joint: map.transpose().try_inverse().expect("regular") * torque };
                let close = |what: &str, found: &[f64], expected: &[f64]| {
                    let off = difference(found, expected);
                    // Matrices whose condition is some hundred, and sums of some hundred terms.
                    assert!(off < 3e-12, "seed {seed}, {what}: {found:?} is not {expected:?}, off by {off:e}");
                };

                let accelerations = gimbal.accelerations(&state, &driven)?;
                let expected = ball.accelerations(&same, &likewise)?;
                close("accelerations", (e * accelerations + change * state.v).as_slice(), expected.as_slice());
                let (mut at, mut there) = (gimbal.workspace(), ball.workspace());
                gimbal.solve_into(&state, &driven, &mut at)?;
                ball.solve_into(&same, &likewise, &mut there)?;
                close("efforts", at.joint().effort().as_slice(), torque.as_slice());
                for (point, other) in at.points().iter().zip(there.points()) {
                    close("positions", point.position().as_slice(), other.position().as_slice());
                    close("forces", point.force().as_slice(), other.force().as_slice());
                    close("moments", point.moment().as_slice(), other.moment().as_slice());
                }
                close("energies", &[at.kinetic_energy(), at.potential_energy()],
                    &[there.kinetic_energy(), there.potential_energy()]);

                let mass = gimbal.mass_matrix(&state, &driven)?;
                let expected = e.transpose() * ball.mass_matrix(&same, &likewise)? * e;
                close("mass matrix", mass.as_slice(), expected.as_slice());
                let given = SVector::<f64, N>::from_fn(|_, _| random.between(-3.0, 3.0));
                let efforts = gimbal.inverse_dynamics(&state, &given, &driven)?;
                let of_ball = ball.inverse_dynamics(&same, &(e * given + change * state.v), &likewise)?;
                close("inverse dynamics", efforts.as_slice(), (e.transpose() * of_ball).as_slice());
                let bias = gimbal.bias_efforts(&state, &driven)?;
                close("balance", (mass * given + bias).as_slice(), efforts.as_slice());
                let coriolis = gimbal.coriolis_matrix(&state, &driven)?;
                let of_ball = ball.coriolis_matrix(&same, &likewise)?;
                let expected = e.transpose() * (of_ball * e + ball.mass_matrix(&same, &likewise)? * change);
                close("Coriolis matrix", coriolis.as_slice(), expected.as_slice());

                let linear = gimbal.linearize(&state, &driven)?;
                let a = linear.a();
                close("accelerations of the linearization", linear.accelerations.as_slice(), accelerations.as_slice());
                for k in 0..3 {
                    // The coordinates change at the rates, along which they are displaced.
                    let unit = SVector::<f64, N>::from_fn(|row, _| f64::from(row == $first + k));
                    close("rows of coordinates", a.fixed_view::<N, 1>(0, $first + k).as_slice(), &[0.0; N]);
                    close("rows of rates", a.fixed_view::<N, 1>(0, N + $first + k).as_slice(), unit.as_slice());
                    let moving = $gimbal::<Dual<f64>>::new();
                    let along = |angle: f64, rate: f64| -> Result<Vec<f64>, Error> {
                        let mut moved = moving.initial_state();
                        moved.q = state.q.map(Dual::from);
                        moved.v = state.v.map(Dual::from);
                        moved.q[start + k].derivatives = [angle];
                        moved.v[$first + k].derivatives = [rate];
                        let driven = $inputs { joint: torque.map(Dual::from) };
                        let accelerations = moving.accelerations(&moved, &driven)?;
                        Ok(accelerations.iter().map(|it| it.derivative()).collect())
                    };
                    let by_angle = a.fixed_view::<N, 1>(N, $first + k);
                    close("derivatives by angles", by_angle.as_slice(), &along(1.0, 0.0)?);
                    let by_rate = a.fixed_view::<N, 1>(N, N + $first + k);
                    close("derivatives by rates", by_rate.as_slice(), &along(0.0, 1.0)?);
                }
            }
            Ok(())
        }
    )* };
}

compare! {
    outward Outward OutwardInputs, OutwardBall OutwardBallInputs, 5 from 1;
    inward Inward InwardInputs, InwardBall InwardBallInputs, 5 from 1;
    free Free FreeInputs, FreeBall FreeBallInputs, 10 from 6;
}

/// Two closed chains that differ only in the closing hinge.
macro_rules! closed {
    ($($name:ident [$($hinge:tt)*];)*) => { $(
        mstmm_chain! {
            chain $name {
                gravity = [1, -9.8, 2] m/s^2;
                body Arm {
                    mass = 1.5 kg;
                    com = [0.2, -0.1, 0.3] m;
                    output = [0.9, 0.1, 0] m turned rpy(20, -30, 50) deg;
                    inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
                }
                ground -> ball near -> Arm first -> ball far -> Arm second
                    -> $($hinge)* joint -> ground at [0.7, 0.8, 0.1] m;
                hinge joint { torque = input; }
            }
        }
    )* };
}

closed! {
    Closed [gimbal([1, 2, 0], [0, 1, 0.3], [0.5, 0, -1])];
    ClosedBall [ball];
}

/// The gimbal closes the chain, and leaves the bodies the same motion as a ball.
#[test]
fn closing_a_chain() -> Result<(), Error> {
    let (gimbal, ball) = (Closed::<f64>::new(), ClosedBall::<f64>::new());
    let mut compared = 0;
    for seed in 0..SEEDS {
        let mut random = Random::new(seed);
        let mut state = gimbal.initial_state();
        state.v.iter_mut().for_each(|v| *v = random.between(-2.0, 2.0));
        state.joint_mut().set_angles(regular_angles(&mut random));
        let driven = ClosedInputs { joint: random_vector(&mut random, 5.0) };
        let assembled = gimbal.assemble(&mut state, &driven);
        let [map, _] = map(state.joint().angles(), state.joint().rates());
        if assembled.is_err() || map.determinant().abs() < 0.3 {
            continue;
        }
        let mut same = ball.initial_state();
        for k in 0..8 {
            same.q[k] = state.q[k];
        }
        for k in 0..6 {
            same.v[k] = state.v[k];
        }
        let (angles, rates) = (state.joint().angles(), state.joint().rates());
        same.joint_mut().set_orientation(orientation(angles)).set_rate(map * rates);
        let torque = map.transpose().try_inverse().expect("regular") * driven.joint;
        let likewise = ClosedBallInputs { joint: torque };
        let (mut at, mut there) = (gimbal.workspace(), ball.workspace());
        gimbal.solve_into(&state, &driven, &mut at)?;
        ball.solve_into(&same, &likewise, &mut there)?;
        for (point, other) in at.points().iter().zip(there.points()) {
            let off = [
                difference(point.acceleration().as_slice(), other.acceleration().as_slice()),
                difference(point.force().as_slice(), other.force().as_slice()),
                difference(point.moment().as_slice(), other.moment().as_slice()),
            ];
            // States are closed up to some 1e-10.
            assert!(off.iter().all(|off| *off < 1e-8), "seed {seed}: {off:?}");
        }
        compared += 1;
    }
    assert!(compared > 10, "only {compared} chains are closed");
    Ok(())
}

mstmm_chain! {
    chain Locked {
        answers = basic;
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.3] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> gimbal joint -> Arm arm;
        hinge joint { start = [20, 90, 10] deg; start_rate = [1, 2, 3] rad/s; torque = input; }
    }

    /// A locked gimbal closes the chain.
    chain LockedLoop {
        body Rod {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com;
        }
        ground -> ball near -> Rod first -> ball far -> Rod second
            -> gimbal(x, y, z) joint -> ground at [1, 1, 0] m turned rpy(0, 90, 0) deg;
        hinge near { start = rpy(0, 0, 90) deg; }
        hinge far { start = rpy(0, 0, -90) deg; }
        hinge joint { start = [0, 90, 0] deg; }
    }

    chain Geared {
        answers = basic;
        body Arm {
            mass = 1.5 kg;
            com = [0.2, -0.1, 0.3] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> gimbal joint -> Arm arm;
        hinge joint { start = [20, 90, 10] deg; armature = 0.1; torque = input; }
    }
}

/// At a right angle two axes are parallel. Accelerations are undetermined, all else is defined; rotors make them regular.
#[test]
fn a_locked_gimbal_is_singular() -> Result<(), Error> {
    let locked = Locked::<f64>::new();
    let (state, inputs) = (locked.initial_state(), locked.no_inputs());
    let found = locked.accelerations(&state, &inputs);
    assert!(matches!(found, Err(Error::Singular { .. })), "{found:?}");
    let mass = locked.mass_matrix(&state, &inputs)?;
    // The axes a and c are the same.
    assert!(
        (mass[(0, 0)] - mass[(2, 2)]).abs() < 1e-14
            && (mass[(0, 2)].abs() - mass[(0, 0)]).abs() < 1e-14
    );
    let efforts = locked.inverse_dynamics(&state, &Vector3::new(1.0, 2.0, 3.0), &inputs)?;
    assert!(efforts.iter().all(|effort| effort.is_finite()));
    let closed = LockedLoop::<f64>::new();
    let found = closed.accelerations(&closed.initial_state(), &closed.no_inputs());
    assert!(found.is_err(), "{found:?}");
    let geared = Geared::<f64>::new();
    let accelerations = geared.accelerations(&geared.initial_state(), &geared.no_inputs())?;
    assert!(accelerations.norm() < 1e-12, "nothing drives it: {accelerations}");
    Ok(())
}
