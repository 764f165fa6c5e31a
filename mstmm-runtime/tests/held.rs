//! Inputs that are held over a step or a sampling period.

mod common;

use common::{Pendulum, Spring};
use mstmm_runtime::description::Origin;
use mstmm_runtime::{Dopri5, Error, LinearlyImplicitEuler, Newmark, Rk4, SemiImplicitEuler};

/// Runs a test of every integrator, with a step of 0.1 s.
macro_rules! every {
    ($test:ident) => {
        $test!(Rk4::new(0.1));
        $test!(Newmark::new(0.1));
        $test!(SemiImplicitEuler::new(0.1));
        $test!(LinearlyImplicitEuler::new(0.1));
        $test!(Dopri5::new(1e-6, 1e-6).with_first_step(0.1));
    };
}

/// A proportional controller that samples the angle at the start of the step.
#[test]
fn a_held_input_is_that_of_the_start() -> Result<(), Error> {
    let chain = Pendulum::<f64>::new();
    let control = |state: &common::State<f64, 1, 1>| -5.0 * state.q[0];
    macro_rules! test {
        ($method:expr) => {
            let start = Pendulum::at(1.0, 0.5);
            let (mut held, mut constant, mut fed_back) =
                (start.clone(), start.clone(), start.clone());
            let input = control(&start);
            $method.step_held(&chain, &mut held, &input)?;
            $method.step(&chain, &mut constant, |_, _| input)?;
            assert_eq!(held, constant);
            $method.step(&chain, &mut fed_back, |_, state| control(state))?;
            let stages = !stringify!($method).contains("Euler");
            assert_eq!(held != fed_back, stages, "{}", stringify!($method));
        };
    }
    every!(test);
    Ok(())
}

/// A mass without a spring, under a sampled force. Over a period of length T with the force u its position gains
/// T v + T² u/2 and its velocity T u, exactly for methods of order two and higher.
#[test]
fn a_sampled_controller_follows_its_difference_equation() -> Result<(), Error> {
    let chain = Spring::<f64>::new(0.0, 0.0);
    let period = 0.25; // two steps and a half
    macro_rules! test {
        ($method:expr) => {
            let exact = !stringify!($method).contains("Euler");
            let (mut state, mut method) = (Spring::at(1.0, -0.5), $method);
            let ([mut x, mut v], mut largest) = ([1.0, -0.5], 0.0f64);
            for sample in 1..=20 {
                let force = -2.0 * x - 1.5 * v;
                (x, v) = (x + period * v + 0.5 * period * period * force, v + period * force);
                let held = -2.0 * state.q[0] - 1.5 * state.v[0];
                method.advance_held(&chain, &mut state, period, &held)?;
                assert!((state.t - f64::from(sample) * period).abs() < 1e-13);
                largest = largest.max((state.q[0] - x).abs()).max((state.v[0] - v).abs());
            }
            // Errors of rounding, or of order one in the step of 0.1.
            assert_eq!(largest < 1e-13, exact, "{}: {largest:e}", stringify!($method));
            assert!(largest < 0.1, "{}: {largest:e}", stringify!($method));
        };
    }
    every!(test);
    Ok(())
}

#[test]
fn errors_leave_the_state_unchanged() {
    let chain = Pendulum::<f64>::new();
    macro_rules! test {
        ($method:expr) => {
            let mut state = Pendulum::at(1.0, 0.5);
            let refused = $method.step_held(&chain, &mut state, &f64::NAN);
            assert_eq!((refused.is_err(), &state), (true, &Pendulum::at(1.0, 0.5)));
            let refused = $method.advance_held(&chain, &mut state, f64::INFINITY, &0.0);
            assert_eq!(
                (refused, &state),
                (Err(Error::NotFinite(Origin::End)), &Pendulum::at(1.0, 0.5))
            );
        };
    }
    every!(test);
}
