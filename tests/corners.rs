//! The smallest chains, and unusual chains.

mod support;

use mstmm::prelude::*;
use mstmm::{Error, Scalar};
use nalgebra::{UnitQuaternion, Vector3};
use support::mechanism::both;

both! { Statue StatueByTransfer [] {
    gravity = [0, 0, -10] m/s^2;
    body Block {
        mass = 2 kg;
        com = [0, 0, 0.5] m;
        output = [0, 0, 1] m;
        inertia = diag(0.2, 0.2, 0.1) kg*m^2 about com;
    }
    ground at [3, 0, 0] m -> weld foot -> Block lower -> weld waist -> Block upper;
} }

both! { Stone StoneByTransfer [Floating] {
    body Stone {
        mass = 2 kg;
        com = [0, 0, 0.5] m;
        output = [0, 0, 1] m;
        inertia = tensor(0.9, 0.8, 0.3, 0, 0.1, 0) kg*m^2 about com;
    }
    Stone stone;
    body stone {
        start = [1, 2, 3] m turned rpy(0, 0, 90) deg;
        start_velocity = [1, 0, 0] m/s;
        start_rate = [0, 0, 2] rad/s;
    }
} }

/// Runs a statement for both types of a description.
macro_rules! for_both {
    ($chain:ident in [$riccati:ident, $transfer:ident] $body:block) => {{
        {
            let $chain = $riccati::<f64>::new();
            $body
        }
        {
            let $chain = $transfer::<f64>::new();
            $body
        }
    }};
}

/// Nothing can move, so the welds carry the weight of the bodies on top of them.
#[test]
fn welds_carry_the_whole_weight() -> Result<(), Error> {
    for_both! { chain in [Statue, StatueByTransfer] {
        let mut state = chain.initial_state();
        let mut at = chain.workspace();
        chain.solve_into(&state, &chain.no_inputs(), &mut at)?;
        assert_eq!(at.accelerations().len(), 0);
        // On the upper body of a joint acts +q: up, with 10 N for each kilogram above.
        assert!((at.foot().output().force() - Vector3::new(0.0, 0.0, 40.0)).norm() < 1e-14);
        assert!((at.waist().output().force() - Vector3::new(0.0, 0.0, 20.0)).norm() < 1e-14);
        assert_eq!(at.upper().output().force(), Vector3::zeros());
        assert!(at.foot().output().moment().norm() < 1e-14);
        assert!((at.upper().output().position() - Vector3::new(3.0, 0.0, 2.0)).norm() < 1e-14);
        // Σ m g h above the origin.
        assert_eq!(chain.energy(&state).kinetic, 0.0);
        assert!((chain.energy(&state).potential - 2.0 * 10.0 * (0.5 + 1.5)).abs() < 1e-13);
        Rk4::new(0.1).step(&chain, &mut state, |_, _| chain.no_inputs())?;
        Dopri5::new(1e-6, 1e-6).advance_to(&chain, &mut state, 1.0, |_, _| chain.no_inputs())?;
        assert_eq!(state.t, 1.0);
    } }
    Ok(())
}

/// Without the setting `gravity`, a stone moves straight and keeps its spin.
#[test]
fn a_single_stone_flies_straight() -> Result<(), Error> {
    for_both! { chain in [Stone, StoneByTransfer] {
        let mut state = chain.initial_state();
        let turn = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), std::f64::consts::FRAC_PI_2);
        let com = |state: &_| -> Result<[Vector3<f64>; 3], Error> {
            let mut at = chain.workspace();
            chain.solve_into(state, &chain.no_inputs(), &mut at)?;
            let input = at.stone().input();
            let arm = input.orientation() * Vector3::new(0.0, 0.0, 0.5);
            let (spin, spin_rate) = (input.angular_velocity(), input.angular_acceleration());
            Ok([
                input.position() + arm,
                input.velocity() + spin.cross(&arm),
                input.acceleration() + spin_rate.cross(&arm) + spin.cross(&spin.cross(&arm)),
            ])
        };
        assert!(state.stone().orientation().angle_to(&turn) < 1e-15);
        let [place, velocity, _] = com(&state)?;
        let (mut dopri5, before) = (Dopri5::new(1e-12, 1e-12), chain.energy(&state));
        dopri5.advance_to(&chain, &mut state, 2.0, |_, _| chain.no_inputs())?;
        let [then, still, acceleration] = com(&state)?;
        // Some hundred steps of tolerance 1e-12.
        assert!((then - place - velocity * 2.0).norm() < 1e-9);
        assert!((still - velocity).norm() < 1e-10 && acceleration.norm() < 1e-13);
        let after = chain.energy(&state);
        assert!((after.kinetic - before.kinetic).abs() < 1e-10 && after.potential == 0.0);
    } }
    Ok(())
}

/// A chain can use constants of the function that contains it.
#[test]
fn a_chain_in_a_function_uses_its_constants() -> Result<(), Error> {
    const MASS: f64 = 1.5;
    const LENGTH: f64 = 0.8;
    mstmm_chain! {
        chain Local {
            gravity = [0, -9.8, 0] m/s^2;
            body Link {
                mass = MASS;
                com = [LENGTH / 2, 0, 0];
                inertia = diag(0.01, 0.08, 0.08) kg*m^2 about com;
            }
            ground -> pin(z) joint -> Link link;
        }
    }
    let chain = Local::<f64>::new();
    let state = chain.initial_state();
    // θ̈ = −m g l / (J + m l²) with l half the length.
    let expected = -1.5 * 9.8 * 0.4 / (0.08 + 1.5 * 0.4 * 0.4);
    assert!((chain.accelerations(&state, &chain.no_inputs())?[0] - expected).abs() < 1e-13);
    Ok(())
}

/// All features in single precision.
#[test]
fn small_chains_run_in_single_precision() -> Result<(), Error> {
    fn run<T: Scalar<Real = T, Mask = bool> + PartialOrd>() -> Result<(), Error> {
        let (statue, stone) = (Statue::<T>::new(), StoneByTransfer::<T>::new());
        let (mut still, mut flying) = (statue.initial_state(), stone.initial_state());
        let (step, tolerance) = (T::constant(0.125), T::constant(1e-4));
        Rk4::new(step).step(&statue, &mut still, |_, _| statue.no_inputs())?;
        let mut dopri5 = Dopri5::new(tolerance, tolerance);
        dopri5.advance_to(&stone, &mut flying, step, |_, _| stone.no_inputs())?;
        assert_eq!([still.t, flying.t], [step; 2]);
        let mut at = stone.workspace();
        stone.solve_into(&flying, &stone.no_inputs(), &mut at)?;
        let off = at.stone().output().force();
        assert!(off.iter().all(|&off| off.abs() < T::constant(1e-5)));
        Ok(())
    }
    run::<f32>()?;
    run::<f64>()
}
