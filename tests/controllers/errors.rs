//! Types of errors: those of the controller, those of the chain inside them, and boxed errors.

use super::models::*;
use mstmm::Error;
use mstmm::description::Origin;
use mstmm::prelude::*;

/// Errors of the chain are converted to the controller's type.
fn errors_of_the_chain_are_converted<C: Driven, I: Integrator<C>>() {
    let chain = C::default();
    let mut integrator = I::make();
    let fine = |time: C::Scalar, state: &C::State| Ok::<_, Fault>(chain.drive(time, state));
    let nan = mstmm::Scalar::constant(f64::NAN);
    let mut state = chain.start();
    state.rates_mut()[0] = nan;
    let result = integrator.try_step(&chain, &mut state, fine);
    assert_eq!(result, Err(Fault::Chain(Error::NotFinite(Origin::Rate(0)))));
    let result = integrator.try_advance_to(&chain, &mut chain.start(), nan, fine);
    assert_eq!(result, Err(Fault::Chain(Error::NotFinite(Origin::End))));
}

#[test]
fn errors_of_the_chain_arrive_in_the_controllers_type() {
    on_everything!(errors_of_the_chain_are_converted);
}

/// A typical controller: it reads a sensor, which may fail, and returns a torque.
fn read(angle: f64) -> Result<f64, std::num::ParseFloatError> {
    if angle < 100.0 { "0.5".parse() } else { "broken".parse() }
}

#[test]
fn question_marks_work_in_closures_and_around_steps() {
    fn run(start: f64) -> Result<ArmState<f64>, Box<dyn std::error::Error>> {
        let chain = Arm::<f64>::new();
        let mut state = chain.initial_state();
        state.b_mut().set_angle(start);
        let mut rk4 = Rk4::new(1e-3);
        let control =
            |_time: f64, state: &ArmState<f64>| -> Result<_, Box<dyn std::error::Error>> {
                Ok(ArmInputs { b: read(state.b().angle())?, ..chain.no_inputs() })
            };
        rk4.try_step(&chain, &mut state, control)?;
        // Inputs that cannot fail need nothing new.
        rk4.step(&chain, &mut state, |_time, _state| chain.no_inputs())?;
        rk4.step(&chain, &mut state, |_, _| Default::default())?;
        Ok(state)
    }
    assert!(run(0.0).is_ok());
    let error = run(200.0).expect_err("what is broken cannot be read");
    assert_eq!(error.to_string(), "invalid float literal");
    let error = run(f64::NAN).expect_err("a state that is not finite");
    assert!(error.is::<std::num::ParseFloatError>() || error.is::<Error>(), "{error}");
}

/// The chain's error type works, too, without a conversion.
#[test]
fn the_chains_own_error_can_be_returned() {
    let chain = Loop::<f64>::new();
    let mut state = chain.start();
    let before = state.clone();
    let refused = Error::InvalidParameter { name: "torque", reason: "must be known" };
    let result = Dopri5::new(1e-6, 1e-6).try_step(&chain, &mut state, |_, _| Err(refused));
    assert_eq!((result, state), (Err(refused), before));
}

/// `project` returns the error and leaves the state unchanged.
#[test]
fn closing_asks_inputs_that_may_fail() {
    let chain = Loop::<f64>::new();
    let mut state = chain.start();
    // The corrections of a step are small.
    state.coordinates_mut().iter_mut().for_each(|q| *q += 0.01);
    let before = state.clone();
    let result = chain.project(&mut state, |_| Err(Fault::Sensor(7)));
    assert_eq!((result, &state), (Err(Fault::Sensor(7)), &before));
    let result = chain.project(&mut state, |_| Ok::<_, Error>(chain.no_inputs()));
    assert_eq!(result, Ok(()));
    assert_ne!(state, before);
    // Open chains do not ask.
    let chain = Arm::<f64>::new();
    let asked = chain.project(&mut chain.initial_state(), |_| Err(Fault::Sensor(7)));
    assert_eq!(asked, Ok(()));
}
