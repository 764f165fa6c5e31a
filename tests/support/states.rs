//! States of any chain.

use mstmm::{Chain, ChainState, Scalar};
use mstmm_reference::Random;

/// Any state: angles and rates of up to one and two, quaternions of unit length in double precision.
pub fn random_state<C: Chain>(random: &mut Random) -> C::State {
    let mut state = C::State::zero_position();
    let zero_position = state.coordinates().to_vec();
    let mut q: Vec<f64> = zero_position.iter().map(|_| random.between(-1.0, 1.0)).collect();
    for (at, &rest) in zero_position.iter().enumerate() {
        // In the zero position only the w of quaternions is not zero.
        if rest != C::Scalar::default() {
            let quaternion = &mut q[at..at + 4];
            quaternion[0] += 1.5;
            let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
            quaternion.iter_mut().for_each(|x| *x /= length);
        }
    }
    let constant = C::Scalar::constant;
    state.coordinates_mut().iter_mut().zip(q).for_each(|(to, from)| *to = constant(from));
    state.rates_mut().iter_mut().for_each(|rate| *rate = constant(random.between(-2.0, 2.0)));
    state
}

/// Gives the state of one chain to the other.
pub fn copied<A: ChainState, B: ChainState<Scalar = A::Scalar> + Default>(from: &A) -> B {
    let mut to = B::default();
    to.coordinates_mut().copy_from_slice(from.coordinates());
    to.rates_mut().copy_from_slice(from.rates());
    to.set_time(from.time());
    to
}
