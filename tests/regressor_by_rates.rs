//! Regressors of chains in space: a chain of `f64` or `f32` computes them for several rates at a time, a chain of lanes by
//! straight code. Both forms are different sums, and agree up to rounding.

use mstmm::lanes::{NativeF32, NativeF64};
use mstmm::{Columns, Error, HingeMotion, PinState, Scalar, mstmm_chain};

mstmm_chain! {
    /// A floating body with two legs and an arm, and 17 rates: the last pack has one rate.
    pub chain Walker {
        gravity = [0, 0, -9.81] m/s^2;
        answers = [inverse_dynamics, regressor];
        body Trunk {
            mass = 20 kg;
            com = [0.05, 0.02, 0.1] m;
            inertia = tensor(1.5, 2.5, 2.1, 0.02, -0.2, 0.1) kg*m^2 about com;
            point left = [0, 0.2, -0.1] m turned rpy(90, 0, 30) deg;
            point right = [0, -0.2, -0.1] m turned rpy(90, 0, -30) deg;
            output = [0.1, 0, 0.4] m;
        }
        part Leg(side) {
            body Thigh {
                mass = 3 kg;
                com = [0.2, side*0.02, 0.01] m;
                inertia = tensor(0.01, 0.05, 0.05, side*0.001, 0.002, 0) kg*m^2 about com;
                output = [0.4, 0, 0] m turned rpy(side*20, 0, 0) deg;
            }
            body Shank { mass = 1 kg; com = [0.2, 0, 0] m; inertia = diag(0.001, 0.02, 0.02) kg*m^2 about com; output = [0.4, 0, 0] m; }
            body Foot { mass = 0.2 kg; com = [0.05, 0, 0] m; inertia = diag(0.001, 0.001, 0.001) kg*m^2 about com; }
            ball hip -> Thigh thigh -> pin(y) knee -> Shank shank -> weld ankle -> Foot foot;
            hinge knee { torque = input; damping = 0.3 N*m*s/rad; armature = 0.01 kg*m^2; friction = 0.5 N*m; friction_speed = 0.1 rad/s; }
        }
        body Link { mass = 1 kg; com = [0.1, 0, 0] m; inertia = diag(0.001, 0.01, 0.01) kg*m^2 about com; output = [0.2, 0, 0.05] m; }
        Trunk trunk -> universal(x, z) shoulder -> Link upper -> slider([0.6, 0, 0.8]) rod -> Link lower;
        trunk.left -> Leg(1) left;
        trunk.right -> Leg(-1) right;
        hinge shoulder { damping = 0.1 N*m*s/rad; stiffness = 2 N*m/rad; }
    }

    /// An arm on a driven base, with a body that is fixed to the ground, and fourteen rates.
    pub chain Arm {
        gravity = [0, 0, -9.81] m/s^2;
        answers = [inverse_dynamics, regressor];
        body Base { mass = 5 kg; com = [0, 0, 0.1] m; inertia = diag(0.1, 0.1, 0.1) kg*m^2 about com; output = [0, 0.1, 0.3] m turned rpy(90, 0, 0) deg; }
        body Link { mass = 2 kg; com = [0.2, 0.01, 0] m; inertia = diag(0.01, 0.1, 0.1) kg*m^2 about com; output = [0.4, 0, 0.1] m turned rpy(0, 30, 0) deg; }
        ground at [1, 2, 3] m -> weld foot -> Base plate -> pin(z) turntable -> Base column -> pin(z) shoulder -> Link upper
            -> cylindrical(x) elbow -> Link fore -> universal(y, z) wrist -> Link hand
            -> ball flange -> Link tool -> ball tip -> Link pen -> pin(x) clip -> Link cap -> pin(y) hook -> Link tag
            -> slider(z) bolt -> Link nut;
        hinge turntable { motion = input; }
        hinge elbow { damping = 0.1 N*s/m; turning_damping = 0.2 N*m*s/rad; }
    }

    /// A body that turns about its input.
    pub chain Top {
        answers = [regressor];
        body Rotor { mass = 1 kg; com = [0, 0, 0.1] m; inertia = diag(0.1, 0.2, 0.3) kg*m^2 about com; }
        ground -> ball tip -> Rotor rotor;
    }
}

/// Returns the regressor, the efforts and the dynamic parameters at a state without symmetry.
macro_rules! regressor {
    ($chain:ident, $T:ty, |$inputs:pat_param, $number:pat_param| $set:expr) => {{
        let number = |k: usize| <$T>::constant((1.7 * k as f64).sin());
        let chain = $chain::<$T>::new();
        let mut state = chain.initial_state();
        for (k, q) in state.q.iter_mut().enumerate() {
            *q += number(k);
        }
        for (k, v) in state.v.iter_mut().enumerate() {
            *v = number(k + 40);
        }
        mstmm::Chain::normalize(&chain, &mut state);
        let mut accelerations = state.v;
        accelerations.iter_mut().enumerate().for_each(|(k, a)| *a = number(k + 80));
        let mut inputs = chain.no_inputs();
        let ($inputs, $number) = (&mut inputs, &number);
        $set;
        // Every entry is written.
        let mut regressor = chain.regressor(&state, &accelerations, &inputs)?;
        regressor.fill(<$T>::constant(f64::NAN));
        chain.regressor_into(&state, &accelerations, &inputs, &mut regressor)?;
        let efforts = chain.inverse_dynamics(&state, &accelerations, &inputs)?;
        (regressor, efforts, chain.dynamic_parameters())
    }};
}

/// Compares a chain by rates with a chain of lanes. The entries are sums of some tens of products, relative to the largest
/// entry.
macro_rules! compare {
    ($chain:ident, $T:ty, $L:ty, $tolerance:expr, |$inputs:pat_param, $number:pat_param| $set:expr) => {{
        assert_eq!(<<$T as Scalar>::Pack as Columns<$T>>::COUNT, 4, "rates are not side by side");
        let (found, efforts, parameters) = regressor!($chain, $T, |$inputs, $number| $set);
        let (expected, _, _) = regressor!($chain, $L, |$inputs, $number| $set);
        let expected: Vec<$T> = expected.iter().map(|it| Columns::<$T>::column(*it, 0)).collect();
        assert!(found.iter().ne(&expected), "both are straight code");
        let largest = expected.iter().fold(0.0, |largest: $T, it| largest.max(it.abs()));
        for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let error = (found - expected).abs();
            assert!(error <= $tolerance * largest, "entry {index}: {found} is not {expected}");
        }
        let difference = efforts - found * parameters;
        let scale = efforts.iter().fold(0.0, |largest: $T, it| it.abs().max(largest));
        assert!(difference.iter().all(|it| it.abs() <= 10.0 * $tolerance * scale), "{difference}");
    }};
}

#[test]
fn a_walker_has_the_regressor_of_straight_code() -> Result<(), Error> {
    compare!(Walker, f64, NativeF64, 1e-14, |_, _| {});
    compare!(Walker, f32, NativeF32, 5e-6, |_, _| {});
    Ok(())
}

#[test]
fn an_arm_on_a_driven_base_has_the_regressor_of_straight_code() -> Result<(), Error> {
    compare!(Arm, f64, NativeF64, 1e-14, |inputs, number| {
        let state = PinState::new(number(1), number(2));
        inputs.turntable = HingeMotion { state, acceleration: number(3) };
    });
    Ok(())
}

/// The motion is finite, products of its rates are not. The regressor of the top is straight code.
#[test]
fn entries_that_overflow_are_an_error() {
    macro_rules! overflow {
        ($chain:ident, $state:ty) => {{
            let chain = $chain::<f64>::new();
            let mut state = chain.initial_state();
            let regressor = |state: &$state| {
                let found = chain.regressor(state, &state.v, &chain.no_inputs());
                found.map(|regressor| regressor.sum())
            };
            state.v.fill(1e100);
            assert!(regressor(&state).is_ok_and(f64::is_finite));
            state.v.fill(1e160);
            assert!(matches!(regressor(&state), Err(Error::NotFinite(_))));
        }};
    }
    overflow!(Top, TopState<f64>);
    overflow!(Arm, ArmState<f64>);
}
