//! Closed spatial chains: a gate between two balls, a chain with
//! five degrees of freedom, ends that constrain nothing and ends that are held by springs.

mod support;

use mstmm::prelude::*;
use mstmm::{Error, GeneratedChain};
use mstmm_reference::Random;
use nalgebra::{UnitQuaternion, Vector3};
use support::mechanism::random_quaternion;
use support::{difference, worst};

mstmm_chain! {
    /// A gate whose hinges are two balls; gravity leans.
    chain Gate {
        gravity = [3, 0, -9] m/s^2;
        body Door {
            mass = 20 kg;
            com = [0.6, 0, 1] m;
            output = [0, 0, 2] m;
            inertia = tensor(3, 4, 1.5, 0.1, 0.2, -0.1) kg*m^2 about com;
        }
        ground -> ball lower -> Door door -> ball upper -> ground at [0, 0, 2] m;
        hinge lower { torque = input; }
    }
}

/// The gate rotates about the line through both balls like a pendulum; the force along this line is
/// undetermined.
#[test]
fn a_gate_swings_about_its_balls() {
    let chain = Gate::<f64>::new();
    let mut at = chain.workspace();
    let mut largest = 0.0;
    for seed in 0..50 {
        let mut random = Random::new(seed);
        let (angle, rate) = (random.between(-3.0, 3.0), random.between(-3.0, 3.0));
        let torque = random.between(-9.0, 9.0);
        let turn = |angle| UnitQuaternion::from_axis_angle(&Vector3::z_axis(), angle);
        let mut state = chain.initial_state();
        let spin = Vector3::new(0.0, 0.0, rate);
        state.lower_mut().set_orientation(turn(angle)).set_rate(spin);
        state.upper_mut().set_orientation(turn(-angle)).set_rate(-spin);
        let inputs = GateInputs { lower: Vector3::new(0.0, 0.0, torque) };
        chain.solve_into(&state, &inputs, &mut at).expect("a regular gate");
        let inertia = 1.5 + 20.0 * 0.6 * 0.6;
        let acceleration = (torque - 20.0 * 0.6 * 3.0 * angle.sin()) / inertia;
        let expected = [0.0, 0.0, acceleration, 0.0, 0.0, -acceleration];
        let off = difference(at.accelerations().as_slice(), &expected);
        assert!(off < 1e-13, "seed {seed}: {off:e}");
        assert_eq!(at.closure().redundant(), 1);
        let open: Vec<_> = at.closure().undetermined().iter().filter(|w| w[2] != 0.0).collect();
        let [[fx, fy, fz, mx, my, mz]] = open[..] else { panic!("{open:?}") };
        let rest = [fx, fy, mx, my, mz].map(|x| x.abs());
        assert!((fz.abs() - 1.0).abs() < 1e-12 && rest.into_iter().fold(0.0, f64::max) < 1e-12);
        largest = worst(largest, off);
    }
    println!("off by {largest:.1e}");
}

mstmm_chain! {
    /// Three bars between balls and a universal hinge: of 11 rates five are free.
    chain Rope {
        gravity = [0, 0, -9.8] m/s^2;
        body Bar {
            mass = 1 kg;
            com = [0.3, 0, 0] m;
            output = [0.6, 0, 0] m;
            inertia = diag(0.01, 0.03, 0.04) kg*m^2 about com;
        }
        ground -> ball a -> Bar first -> universal(y, z) b -> Bar second -> ball c -> Bar third
            -> ball d -> ground at [1.5, 0, 0] m;
        hinge a { start = rpy(0, -30, 10) deg; start_rate = [1, 2, -1] rad/s; }
        hinge b { start = [30, 20] deg; }
        hinge c { start = rpy(0, 40, 10) deg; }
    }
}

/// No hinge does work: the energy is the method's only loss; both ends stay where they are.
#[test]
fn a_chain_between_balls_keeps_its_energy() {
    let chain = Rope::<f64>::new();
    let mut state = chain.initial_state();
    chain.assemble(&mut state, &chain.no_inputs()).expect("bars that reach");
    let before = chain.energy(&state).total();
    let mut at = chain.workspace();
    let mut dopri5 = Dopri5::new(1e-11, 1e-11);
    for second in 1..=10 {
        dopri5
            .advance_to(&chain, &mut state, f64::from(second), |_, _| chain.no_inputs())
            .expect("steps");
        chain.solve_into(&state, &chain.no_inputs(), &mut at).expect("a regular chain");
        let off = difference(&[chain.energy(&state).total()], &[before]);
        let gap = (at.d().input().position() - Vector3::new(1.5, 0.0, 0.0)).norm();
        // About a thousand steps, each within the tolerance.
        assert!(off < 1e-8 && gap < 1e-9, "after {second} s: {off:e}, gap {gap:e}");
        assert_eq!(at.closure().redundant(), 0);
        let turned = at.d().output().orientation().angle();
        assert!(turned < 1e-9, "after {second} s: {turned:e}");
    }
}

macro_rules! arm {
    ($name:ident { $($rest:tt)* }) => {
        mstmm_chain! { chain $name {
            gravity = [1, -9.8, 2] m/s^2;
            body Link {
                mass = 1.5 kg;
                com = [0.2, -0.1, 0.1] m;
                output = [0.5, 0.1, -0.2] m turned rpy(20, -30, 50) deg;
                inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            }
            $($rest)*
        } }
    };
}

arm! { Loose { ground -> ball a -> Link first -> pin(y) b -> Link second; } }
arm! { Floating {
    ground -> ball a -> Link first -> pin(y) b -> Link second -> floating end
        -> ground at [0.5, 0.6, 0.7] m turned rpy(10, 20, 30) deg;
} }
arm! { Elastic {
    ground -> ball a -> Link first -> pin(y) b -> Link second -> elastic end
        -> ground at [0.5, 0.6, 0.7] m turned rpy(10, 20, 30) deg;
    hinge end { stiffness = 40 N/m; }
} }
arm! { Sprung {
    ground -> ball a -> Link first -> pin(y) b -> Link second;
    spring end { on = second; at = output; to = [0.5, 0.6, 0.7] m; stiffness = 40 N/m; }
} }

/// Sets the hinges that all arms have, at random, and the rest so that the chain closes.
fn set<C: GeneratedChain<Scalar = f64>>(chain: &C, seed: u64) -> Result<C::State, Error> {
    let mut random = Random::new(seed);
    let mut state = chain.initial_state();
    state.coordinates_mut()[..4].copy_from_slice(&random_quaternion(&mut random));
    state.coordinates_mut()[4] = random.between(-3.0, 3.0);
    state.rates_mut()[..4].iter_mut().for_each(|rate| *rate = random.between(-2.0, 2.0));
    chain.assemble(&mut state, &chain.no_inputs())?;
    Ok(state)
}

/// A floating hinge at the end holds nothing; an elastic one with a single stiffness is a spring to
/// the ground. The coordinates of the end follow by assembly, which may move all others: the open
/// chains are put where the closed ones came to be.
#[test]
fn ends_without_reactions_or_with_springs() {
    fn check<C: GeneratedChain<Scalar = f64>, O: GeneratedChain<Scalar = f64>>(
        name: &str,
        closed: &C,
        open: &O,
    ) {
        let (mut largest, mut found) = (0.0, 0);
        for seed in 0..50 {
            let Ok(state) = set(closed, seed) else { continue };
            found += 1;
            let mut same = open.initial_state();
            let (coordinates, rates) = (same.coordinates().len(), same.rates().len());
            same.coordinates_mut().copy_from_slice(&state.coordinates()[..coordinates]);
            same.rates_mut().copy_from_slice(&state.rates()[..rates]);
            let mut expected = open.initial_state();
            open.derivative_into(&same, &open.no_inputs(), &mut expected).expect("regular");
            let mut rate = closed.initial_state();
            closed.derivative_into(&state, &closed.no_inputs(), &mut rate).expect("regular");
            let energies = [closed.energy(&state).total(), open.energy(&same).total()].map(|e| [e]);
            let off = difference(&rate.rates()[..rates], expected.rates());
            let off = worst(off, difference(&energies[0], &energies[1]));
            // The condition of these chains is some hundreds.
            assert!(off < 1e-11, "{name}, seed {seed}: {off:e}");
            largest = worst(largest, off);
        }
        println!("{name}: off by {largest:.1e}, {found} of 50 closed");
        assert!(found >= 40, "{name}: {found} of 50 closed");
    }
    check("floating", &Floating::<f64>::new(), &Loose::<f64>::new());
    check("elastic", &Elastic::<f64>::new(), &Sprung::<f64>::new());
}
