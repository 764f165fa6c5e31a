//! Chains with random parameters, states and inputs, in lanes and one by one.

use mstmm::{Chain, ChainState, GeneratedChain, Scalar};
use mstmm_reference::Random;
use std::fmt::Debug;

use super::numbers::{Lanes, pack};

/// The largest distance of coordinates from the start, in rad and m, and the largest rate.
const FAR: f64 = 0.4;
const FAST: f64 = 2.0;

/// Draws a number between two.
pub type Draw<'a, T> = &'a mut dyn FnMut(f64, f64) -> T;

/// A chain to be tried in lanes.
pub trait Sample:
    GeneratedChain<Inputs: Clone, State: Debug + PartialEq, Workspace: Debug + PartialEq> + Default
{
    /// Sets parameters.
    fn vary(&mut self, draw: Draw<Self::Scalar>);

    /// Returns the inputs.
    fn inputs(&self, draw: Draw<Self::Scalar>) -> Self::Inputs;
}

/// A chain with what it is evaluated in.
pub struct Case<C: Chain> {
    pub chain: C,
    pub state: C::State,
    pub inputs: C::Inputs,
    pub step: C::Scalar,
}

/// Returns a case for each lane, with slightly longer steps from lane to lane.
pub fn each<C: Sample>(seed: u64, count: usize, step: f64) -> Vec<Case<C>>
where
    C::Scalar: Scalar<Real = C::Scalar>,
{
    let case = |(lane, mut random): (usize, Random)| {
        let mut draw = |low, high| C::Scalar::constant(random.between(low, high));
        let mut chain = C::default();
        chain.vary(&mut draw);
        let inputs = chain.inputs(&mut draw);
        let state = state(&chain, &inputs, &mut draw);
        let step = C::Scalar::constant(step * (1.0 + 0.1 * lane as f64));
        Case { chain, state, inputs, step }
    };
    randoms(seed, count).into_iter().enumerate().map(case).collect()
}

/// The same cases in lanes.
pub fn wide<W, C>(seed: u64, each: &[Case<C>]) -> Case<W>
where
    W: Sample<Scalar: Lanes>,
    C: Sample<Scalar = <W::Scalar as Scalar>::Real>,
{
    let mut randoms = randoms(seed, W::Scalar::COUNT);
    let mut draw = |low, high| {
        let mut lane = |lane: usize| Scalar::constant(randoms[lane].between(low, high));
        W::Scalar::from_lanes(&mut lane)
    };
    let mut chain = W::default();
    chain.vary(&mut draw);
    let inputs = chain.inputs(&mut draw);
    let states: Vec<_> = each.iter().map(|case| case.state.clone()).collect();
    let step = W::Scalar::from_lanes(|lane| each[lane].step);
    Case { chain, state: pack(&states), inputs, step }
}

fn randoms(seed: u64, count: usize) -> Vec<Random> {
    (0..count).map(|lane| Random::new(1000 * seed + lane as u64)).collect()
}

/// A state near the start, closed where the chain is.
fn state<C: Sample>(chain: &C, inputs: &C::Inputs, draw: Draw<C::Scalar>) -> C::State {
    let mut state = chain.initial_state();
    state.coordinates_mut().iter_mut().for_each(|q| *q += draw(-FAR, FAR));
    state.rates_mut().iter_mut().for_each(|v| *v += draw(-FAST, FAST));
    state.set_time(draw(0.0, 10.0));
    // Once is enough for what a step does to quaternions.
    (0..8).for_each(|_| chain.normalize(&mut state));
    chain.assemble(&mut state, inputs).expect("a chain that can be closed");
    state
}
