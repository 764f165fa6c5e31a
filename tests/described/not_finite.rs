//! The names of values that are not finite.

use super::models::{Crawler, CrawlerInputs, CrawlerState, FourBar, Kinds, Raft, Rope, Train};
use mstmm::description::Origin;
use mstmm::{ChainState, Described, Dopri5, Error, Newmark, Rk4};

const WRONG: [f64; 3] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

/// A state and inputs.
struct Case<C: Described<Scalar = f64>> {
    chain: C,
    state: C::State,
    inputs: C::Inputs,
}

impl<C: Described<Scalar = f64>> Case<C> {
    /// Asserts that solutions and steps fail because of this value, and returns its name.
    #[track_caller]
    fn fails(&self, expected: Origin) -> String {
        let Case { chain, state, inputs } = self;
        let refused = Err(Error::NotFinite(expected));
        assert_eq!(chain.solve_into(state, inputs, &mut chain.workspace()), refused);
        assert_eq!(chain.derivative_into(state, inputs, &mut state.clone()), refused);
        let with = |_, _: &C::State| inputs.clone();
        assert_eq!(Rk4::new(1e-3).step(chain, &mut state.clone(), with), refused);
        assert_eq!(Dopri5::new(1e-6, 1e-6).step(chain, &mut state.clone(), with), refused);
        assert_eq!(Newmark::new(1e-3).step(chain, &mut state.clone(), with), refused);
        assert_eq!(C::not_finite(state, inputs), Some(expected));
        C::DESCRIPTION.name_of(expected).expect("a name").to_string()
    }
}

/// Makes each value of a state and of inputs not finite in turn.
fn check<C: Described<Scalar = f64>>(chain: impl Fn() -> C) {
    let it = C::DESCRIPTION;
    let new = || {
        let chain = chain();
        let (state, inputs) = (chain.initial_state(), chain.no_inputs());
        Case { chain, state, inputs }
    };
    let mut case = new();
    let right = case.state.clone();
    assert_eq!(C::not_finite(&right, &case.inputs), None);
    for wrong in WRONG {
        case.state.set_time(wrong);
        assert_eq!(case.fails(Origin::Time), "time");
        case.state = right.clone();
        for (index, quantity) in it.coordinates().iter().enumerate() {
            case.state.coordinates_mut()[index] = wrong;
            assert_eq!(case.fails(Origin::Coordinate(index)), quantity.name.to_string());
            case.state = right.clone();
        }
        for (index, quantity) in it.rates().iter().enumerate() {
            case.state.rates_mut()[index] = wrong;
            assert_eq!(case.fails(Origin::Rate(index)), quantity.name.to_string());
            case.state = right.clone();
        }
        let mut inputs = vec![0.0; it.inputs().len()];
        C::inputs_to_slice(&case.inputs, &mut inputs).expect("their number");
        for (index, quantity) in it.inputs().iter().enumerate() {
            let before = std::mem::replace(&mut inputs[index], wrong);
            case.inputs = C::inputs_from_slice(&inputs).expect("their number");
            assert_eq!(case.fails(Origin::Input(index)), quantity.name.to_string());
            inputs[index] = before;
        }
        case.inputs = C::inputs_from_slice(&inputs).expect("their number");
    }
    let ends = [
        Origin::Coordinate(it.coordinates().len()),
        Origin::Rate(it.rates().len()),
        Origin::Input(it.inputs().len()),
        Origin::Argument { name: "vector", index: 0 },
        Origin::End,
        Origin::Result,
    ];
    assert!(ends.iter().all(|end| it.name_of(*end).is_none()));
}

#[test]
fn every_value_is_found_by_its_name() {
    check(Kinds::<f64>::new);
    check(Crawler::<f64>::new);
    check(Raft::<f64>::new);
    check(Train::<f64>::new);
    check(Rope::<f64>::new);
    check(FourBar::<f64>::new);
}

/// Names that do not come from the lists.
#[test]
fn names_are_accessors() {
    let chain = Crawler::<f64>::new();
    let mut state = chain.initial_state();
    let mut inputs = chain.no_inputs();
    let name = |state: &CrawlerState<f64>, inputs: &CrawlerInputs<f64>| {
        let origin = Crawler::<f64>::not_finite(state, inputs).expect("a value");
        Crawler::<f64>::DESCRIPTION.name_of(origin).expect("a name").to_string()
    };
    inputs.left_kick_force.y = f64::NAN;
    assert_eq!(name(&state, &inputs), "left.kick.force.y");
    inputs.b[2] = f64::INFINITY;
    assert_eq!(name(&state, &inputs), "b[2]");
    state.b_mut(1).expect("three repetitions").set_rate(f64::NAN);
    assert_eq!(name(&state, &inputs), "b[1].rate");
    state.left_knee_mut().set_angle(f64::NEG_INFINITY);
    assert_eq!(name(&state, &inputs), "left.knee.angle");
}

/// A program that shows its user which value is wrong.
#[test]
fn errors_of_steps_have_names() {
    let chain = Crawler::<f64>::new();
    let mut state = chain.initial_state();
    let before = state.clone();
    // The input is wrong only at a later stage of the step.
    let late = |time: f64, _: &CrawlerState<f64>| {
        let mut inputs = chain.no_inputs();
        inputs.left_knee = if time > 0.0 { f64::INFINITY } else { 0.0 };
        inputs
    };
    let step = Rk4::new(1e-3).step(&chain, &mut state, late);
    let name = match step {
        Err(Error::NotFinite(origin)) => Crawler::<f64>::DESCRIPTION.name_of(origin),
        other => panic!("{other:?}"),
    };
    assert_eq!(name.expect("a name").to_string(), "left.knee");
    assert_eq!(state, before);
    let forever = Rk4::new(1e-3).advance_to(&chain, &mut state, f64::NAN, |_, _| chain.no_inputs());
    assert_eq!(forever, Err(Error::NotFinite(Origin::End)));
}

/// No value is found where finite values overflow.
#[test]
fn values_that_are_too_large_have_no_origin() {
    let chain = Train::<f64>::new();
    let mut state = chain.initial_state();
    state.v[0] = f64::MAX;
    state.v[1] = f64::MAX;
    let inputs = chain.no_inputs();
    let solved = mstmm::GeneratedChain::solve_into(&chain, &state, &inputs, &mut chain.workspace());
    assert_eq!(solved, Err(Error::NotFinite(Origin::Result)));
    assert_eq!(Train::<f64>::not_finite(&state, &inputs), None);
}
