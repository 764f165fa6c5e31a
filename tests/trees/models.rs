//! The texts of robots and machines, as users write them.

use mstmm::{ChainState, GeneratedChain, mstmm_chain};

include!("models/hyq.chain");
include!("models/g1.chain");
include!("models/panda_with_fingers.chain");
include!("models/satellite.chain");
include!("models/rope_ladder.chain");
include!("models/car.chain");

/// Returns how many rates a chain has, after it has been evaluated at its start.
fn rates<C: GeneratedChain<Scalar = f64>>(chain: &C) -> usize {
    let state = chain.initial_state();
    let mut rate = state.clone();
    chain.derivative_into(&state, &chain.no_inputs(), &mut rate).expect("a regular chain");
    assert!(rate.rates().iter().all(|rate| rate.is_finite()));
    rate.rates().len()
}

#[test]
fn models_have_their_degrees_of_freedom() {
    assert_eq!(rates(&Hyq::<f64>::new()), 18);
    assert_eq!(rates(&G1::<f64>::new()), 35);
    assert_eq!(rates(&PandaWithFingers::<f64>::new()), 9);
    assert_eq!(rates(&Satellite::<f64>::new()), 15);
    assert_eq!(rates(&RopeLadder::<f64>::new()), 183);
    // Steering is prescribed.
    assert_eq!(rates(&Car::<f64>::new()), 20);
}
