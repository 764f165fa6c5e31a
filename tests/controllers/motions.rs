//! The effects of a step in which the controller fails, for every chain and every integrator.

use super::models::*;
use mstmm::Scalar;
use mstmm::prelude::*;

/// A controller that fails in the call with a given number.
fn failing<'a, C: Driven>(
    chain: &'a C,
    asked: &'a mut usize,
    at: usize,
) -> impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, Fault> + 'a {
    move |time, state| {
        *asked += 1;
        if *asked == at { Err(Fault::Sensor(at)) } else { Ok(chain.drive(time, state)) }
    }
}

/// Whichever call within a step fails, the step changes nothing: the following motion has the same bits as with
/// a controller that never fails.
fn a_failed_step_leaves_nothing<C: Driven, I: Integrator<C>>() {
    let chain = C::default();
    let (mut integrator, mut state) = (I::make(), chain.start());
    let good = |time: C::Scalar, state: &C::State| chain.drive(time, state);
    // Nothing is known at first; then there are a clock, a step size and a dense output.
    for number in 0..3 {
        let mut asked = 0;
        let (mut copy, mut moved) = (integrator.clone(), state.clone());
        copy.try_step(&chain, &mut moved, failing(&chain, &mut asked, 0)).expect("a step");
        let times = asked;
        assert!(times > 0);
        for at in 1..=times {
            let (before, seen) = (state.clone(), integrator.seen(&chain));
            let mut asked = 0;
            let result = integrator.try_step(&chain, &mut state, failing(&chain, &mut asked, at));
            assert_eq!(result, Err(Fault::Sensor(at)), "{number}");
            assert_eq!((asked, &state), (at, &before));
            assert!(integrator.seen(&chain) == seen, "step {number}, asked {at} times");
            // Of a step size control, there is a dense output to be lost.
            let is_dense = seen.iter().any(|seen| seen.starts_with("Ok"));
            assert!(is_dense || number == 0 || seen.len() == 1);
        }
        integrator.plain_step(&chain, &mut state, good).expect("a step");
        assert_eq!(state, moved);
        assert!(integrator.seen(&chain) == copy.seen(&chain));
    }
}

#[test]
fn failed_steps_leave_nothing() {
    on_everything!(a_failed_step_leaves_nothing);
}

/// `try_advance_to` keeps all complete steps, and the motion continues from there unchanged.
fn complete_steps_are_kept<C: Driven, I: Integrator<C>>() {
    let chain = C::default();
    // Rounding of this time is what the clock keeps.
    let end = C::Scalar::constant(0.1);
    let good = |time: C::Scalar, state: &C::State| chain.drive(time, state);
    let (mut whole, mut expected) = (I::make(), chain.start());
    let mut times = 0;
    let counted = |time: C::Scalar, state: &C::State| {
        times += 1;
        chain.drive(time, state)
    };
    whole.plain_advance(&chain, &mut expected, end, counted).expect("an interval");
    for at in (1..=times).step_by(7) {
        let (mut integrator, mut state) = (I::make(), chain.start());
        let mut asked = 0;
        let result =
            integrator.try_advance_to(&chain, &mut state, end, failing(&chain, &mut asked, at));
        assert_eq!((result, asked), (Err(Fault::Sensor(at)), at));
        assert!(state.time() < end);
        integrator.plain_advance(&chain, &mut state, end, good).expect("the rest");
        assert_eq!(state, expected, "asked {at} times");
        assert!(integrator.seen(&chain) == whole.seen(&chain));
    }
}

#[test]
fn complete_steps_are_kept_after_a_failure() {
    on_everything!(complete_steps_are_kept);
}

/// Inputs with and without a `Result` give the same bits.
fn inputs_in_a_result_are_the_same<C: Driven, I: Integrator<C>>() {
    let chain = C::default();
    let (mut one, mut other) = (I::make(), I::make());
    let (mut state, mut same) = (chain.start(), chain.start());
    let end = C::Scalar::constant(0.05);
    let good = |time: C::Scalar, state: &C::State| chain.drive(time, state);
    let fine = |time: C::Scalar, state: &C::State| Ok::<_, Fault>(chain.drive(time, state));
    one.plain_step(&chain, &mut state, good).expect("a step");
    other.try_step(&chain, &mut same, fine).expect("a step");
    assert_eq!(state, same);
    one.plain_advance(&chain, &mut state, end, good).expect("an interval");
    other.try_advance_to(&chain, &mut same, end, fine).expect("an interval");
    assert_eq!(state, same);
    assert!(one.seen(&chain) == other.seen(&chain));
}

#[test]
fn inputs_in_a_result_move_the_chain_the_same() {
    on_everything!(inputs_in_a_result_are_the_same);
}
