//! Chains of dual numbers whose state moves: exact rates of change in time.

use mstmm::{Chain, ChainState, Dual, GeneratedChain};

/// The rate of a chain's total energy, exact, with the state moving as the chain says. `C` and `D`
/// are the same chain.
pub fn energy_rate<C, D>(chain: &C, same: &D, state: &C::State, inputs: &C::Inputs) -> f64
where
    C: GeneratedChain<Scalar = f64>,
    D: GeneratedChain<Scalar = Dual<f64>>,
{
    same.energy(&moving(chain, same, state, inputs)).total().derivative()
}

/// The state as it moves.
pub fn moving<C, D>(chain: &C, same: &D, state: &C::State, inputs: &C::Inputs) -> D::State
where
    C: GeneratedChain<Scalar = f64>,
    D: GeneratedChain<Scalar = Dual<f64>>,
{
    let mut rate = chain.initial_state();
    Chain::derivative_into(chain, state, inputs, &mut rate).expect("a regular chain");
    let mut moving = same.initial_state();
    let join = |to: &mut [Dual<f64>], values: &[f64], rates: &[f64]| {
        for (to, (&value, &rate)) in to.iter_mut().zip(values.iter().zip(rates)) {
            *to = Dual::new(value, [rate]);
        }
    };
    join(moving.coordinates_mut(), state.coordinates(), rate.coordinates());
    join(moving.rates_mut(), state.rates(), rate.rates());
    moving
}
