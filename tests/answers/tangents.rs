//! Derivatives against dual numbers, and the workspace of inverse dynamics.

use super::asked::{Asked, Direction};
use super::chains::{Arm, Branched, Raft, Slides, Train};
use crate::numbers::numbers;
use crate::sample::{Case, each};
use mstmm::{ChainState, Dual, Scalar};
use mstmm_reference::Random;

/// Random cases of each chain.
const SEEDS: u64 = 30;

/// Accelerations and their derivatives lose as many digits as the condition number of the mass matrix has, at
/// most four here.
const TOLERANCE: f64 = 1e-11;

/// Returns the derivative of the accelerations by dual numbers.
fn by_dual_numbers<C, D>(case: &Case<C>, same: &Case<D>, direction: &Direction<f64>) -> Vec<f64>
where
    C: Asked<Scalar = f64>,
    D: Asked<Scalar = Dual<f64>>,
{
    let (mut moving, mut change) = (case.state.clone(), C::State::zero_position());
    moving.rates_mut().copy_from_slice(&direction.coordinates);
    case.chain.configuration_rate_into(&moving, &mut change);
    let mut state = same.state.clone();
    let dual = |(&value, &derivative): (&f64, &f64)| Dual::new(value, [derivative]);
    let along = case.state.coordinates().iter().zip(change.coordinates());
    state.coordinates_mut().iter_mut().zip(along.map(dual)).for_each(|(q, dual)| *q = dual);
    let along = case.state.rates().iter().zip(&direction.rates);
    state.rates_mut().iter_mut().zip(along.map(dual)).for_each(|(v, dual)| *v = dual);
    let accelerations = same.chain.forward(&state, &same.inputs);
    accelerations.iter().map(|entry| entry.derivative()).collect()
}

/// Returns the case of the same random numbers over dual numbers.
fn over_dual_numbers<C: Asked<Scalar = f64>, D: Asked<Scalar = Dual<f64>>>(seed: u64) -> Case<D> {
    let mut random = Random::new(1000 * seed);
    let mut draw = |low, high| D::Scalar::constant(random.between(low, high));
    let mut chain = D::default();
    chain.vary(&mut draw);
    let inputs = chain.inputs(&mut draw);
    let state = chain.initial_state();
    Case { chain, state, inputs, step: D::Scalar::constant(0.01) }
}

fn check<C: Asked<Scalar = f64>, D: Asked<Scalar = Dual<f64>>>() {
    for seed in 0..SEEDS {
        let case = each::<C>(seed, 1, 0.01).swap_remove(0);
        let same = over_dual_numbers::<C, D>(seed);
        let mut random = Random::new(2_000_000 + seed);
        let count = case.state.rates().len();
        let mut list = || (0..count).map(|_| random.between(-1.0, 1.0)).collect::<Vec<f64>>();
        let direction = Direction { coordinates: list(), rates: list() };
        let expected = by_dual_numbers(&case, &same, &direction);
        let [accelerations, change] = case.chain.push(&case.state, &case.inputs, &direction);
        let largest = |values: &[f64]| values.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
        let scale = largest(&expected).max(largest(&accelerations));
        for (found, expected) in change.iter().zip(&expected) {
            let off = (found - expected).abs() / scale;
            assert!(off <= TOLERANCE, "seed {seed}: {found} is not {expected}, off by {off:.1e}");
        }
        workspaces(seed, &case);
    }
}

/// At the accelerations of forward dynamics both workspaces are the same.
fn workspaces<C: Asked<Scalar = f64>>(seed: u64, case: &Case<C>) {
    let [forward, inverse] = case.chain.workspaces(&case.state, &case.inputs);
    let (forward, inverse) = (numbers(&forward), numbers(&inverse));
    assert_eq!(forward.len(), inverse.len());
    let scale = forward.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
    for (place, (found, expected)) in inverse.iter().zip(&forward).enumerate() {
        let off = (found - expected).abs() / scale;
        assert!(off <= TOLERANCE, "seed {seed}, {place}: {found} is not {expected}, {off:.1e}");
    }
}

macro_rules! chains {
    ($($test:ident: $name:ident;)*) => { $(
        #[test]
        fn $test() {
            check::<$name<f64>, $name<Dual<f64>>>();
        }
    )* };
}

chains! {
    pins: Arm;
    all_hinges_and_prescribed_motions: Slides;
    a_tree_with_parts_and_repetitions: Branched;
    a_floating_chain_in_a_plane: Raft;
    a_line: Train;
}
