//! `answers = bias_efforts`: generated methods against identities, in both precisions and in lanes.

// Closed chains here start with their links in line, which gives a warning; the tests bend them.
#![allow(deprecated)]

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Described, Error, HingeMotion, PinState, mstmm_chain};
use mstmm_reference::Random;

mstmm_chain! {
    chain Arm {
        gravity = [1, -9.8, 2] m/s^2;
        answers = [bias_efforts];
        param extra = 0.2 kg;
        body Rod {
            mass = 1 kg + extra;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
            point tip = [0.2, 0.5, -0.1] m;
        }
        ground -> pin a -> Rod b -> repeat 2 { pin(y) c -> Rod d } -> ball e -> Rod f;
        hinge a { torque = input; stiffness = 3; damping = 0.2; armature = 0.1; }
        hinge c { torque = input; friction = 0.4; friction_speed = 0.1; }
        hinge e { torque = input; damping = 0.1; }
        load push { on = f; at = tip; force = input; }
        spring s { on = d; at = tip; to = [0, 1, 2] m; stiffness = 5; length = 0.3; }
    }
    chain Told {
        gravity = [1, -9.8, 2] m/s^2;
        answers = bias_efforts;
        body Rod {
            mass = 1 kg;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        ground -> pin a -> Rod b -> pin(y) c -> Rod d -> slider(x) e -> Rod f;
        hinge c { motion = input; }
        hinge a { torque = input; }
        hinge e { force = input; }
    }
    plane chain FourBar {
        gravity = [0, -9.8] m/s^2;
        answers = bias_efforts;
        body Crank { mass = 1 kg; com = [0.1, 0] m; output = [0.2, 0] m; inertia = 0.01 kg*m^2 about com; }
        body Bar { mass = 1 kg; com = [0.4, 0] m; output = [0.8, 0] m; inertia = 0.05 kg*m^2 about com; }
        ground -> pin a -> Crank crank -> pin b -> Bar rod -> pin c -> Bar rocker -> pin d
            -> ground at [0.7, 0] m;
        hinge a { torque = input; }
        hinge d { stiffness = 2; rest = 0.3; damping = 0.1; }
    }
}

/// An arm in a random state under random loads, without motors.
fn arm<T: mstmm::Scalar>(random: &mut Random) -> (Arm<T>, ArmState<T>, ArmInputs<T>) {
    let arm = Arm::<T>::new();
    let mut state = arm.initial_state();
    let mut number = || T::constant(f64::from(random.between(-1.0, 1.0) as f32));
    state.coordinates_mut().iter_mut().for_each(|q| *q = number());
    state.rates_mut().iter_mut().for_each(|v| *v = number());
    arm.normalize(&mut state);
    let mut inputs = arm.no_inputs();
    inputs.push_force.iter_mut().for_each(|force| *force = number());
    (arm, state, inputs)
}

fn driven<T: mstmm::Scalar>(inputs: &ArmInputs<T>, efforts: &[T]) -> ArmInputs<T> {
    ArmInputs {
        a: efforts[0],
        c: [efforts[1], efforts[2]],
        e: [efforts[3], efforts[4], efforts[5]].into(),
        ..*inputs
    }
}

macro_rules! holds {
    ($($test:ident $scalar:ty;)*) => {$(
        #[test]
        fn $test() {
            for seed in 0..50 {
                let (arm, state, inputs) = arm::<$scalar>(&mut Random::new(seed));
                let efforts = arm.bias_efforts(&state, &inputs).expect("finite numbers");
                let inputs = driven(&inputs, efforts.as_slice());
                let accelerations = arm.accelerations(&state, &inputs).expect("a regular chain");
                let most = accelerations.amax();
                // Efforts of up to 100 N m, rounded a hundred times, over inertias from 0.05 kg m².
                let limit = 100.0 * 100.0 / 0.05 * <$scalar>::EPSILON;
                assert!(most < limit, "seed {seed}: {most:e}");
            }
        }
    )*};
}

holds! {
    motors_that_supply_them_hold_all_rates f64;
    motors_that_supply_them_hold_all_rates_in_single_precision f32;
}

/// Prescribed hinges report the efforts that they transmit; the other hinges need their bias efforts.
#[test]
fn a_prescribed_hinge_is_no_rate() {
    let told = Told::<f64>::new();
    let mut state = told.initial_state();
    state.coordinates_mut().copy_from_slice(&[0.3, 0.2]);
    state.rates_mut().copy_from_slice(&[-1.0, 0.7]);
    let mut inputs = told.no_inputs();
    inputs.c = HingeMotion { state: PinState::new(0.5, -2.0), acceleration: 3.0 };
    let efforts = told.bias_efforts(&state, &inputs).expect("finite numbers");
    let inputs = ToldInputs { a: efforts[0], e: efforts[1], ..inputs };
    assert!(told.accelerations(&state, &inputs).expect("a regular chain").amax() < 1e-12);
}

/// The closing hinge is open: its rate needs the efforts of its spring and damper, the others the bias efforts
/// of the chain without it.
#[test]
fn a_closed_chain_is_the_tree_of_its_hinges() {
    let four_bar = FourBar::<f64>::new();
    let mut state = four_bar.initial_state();
    state.a_mut().set_angle(0.4);
    state.d_mut().set_angle(0.1);
    state.d_mut().set_rate(0.5);
    let efforts = four_bar.bias_efforts(&state, &four_bar.no_inputs()).expect("finite numbers");
    assert!((efforts[3] - (2.0 * (0.1 - 0.3) + 0.1 * 0.5)).abs() < 1e-15);
    // At rest only the weights act on the crank, with their lever arms.
    let (crank, rod) = (0.4_f64.cos(), 0.4_f64.cos());
    let levers = 0.1 * crank + (0.2 * crank + 0.4 * rod) + (0.2 * crank + 0.8 * rod + 0.4 * rod);
    assert!((efforts[0] - 9.8 * levers).abs() < 1e-14, "{}", efforts[0]);
}

#[test]
fn values_that_are_not_finite_leave_the_efforts_unchanged() {
    let (arm, state, inputs) = arm::<f64>(&mut Random::new(1));
    let mut efforts = nalgebra::SVector::from([7.0; 6]);
    for number in [f64::NAN, f64::INFINITY] {
        let mut wrong = state.clone();
        wrong.rates_mut()[2] = number;
        assert_eq!(
            arm.bias_efforts_into(&wrong, &inputs, &mut efforts),
            Err(Error::NotFinite(Origin::Rate(2)))
        );
        let mut pushed = inputs;
        pushed.push_force[1] = number;
        let found = arm.bias_efforts_into(&state, &pushed, &mut efforts);
        let Err(Error::NotFinite(origin)) = found else { panic!("{found:?}") };
        let name = Arm::<f64>::DESCRIPTION.name_of(origin).expect("a name");
        assert_eq!(name.to_string(), "push.force.y");
        assert_eq!(efforts, nalgebra::SVector::from([7.0; 6]));
    }
    let mut zero = state.clone();
    zero.coordinates_mut()[3..].fill(0.0);
    assert!(matches!(arm.bias_efforts(&zero, &inputs), Err(Error::InvalidQuaternion { .. })));
}
