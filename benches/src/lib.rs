//! The chains that are timed, the states they are timed in, and what both have in common.
//!
//! The letters are those of `benches/README.md`: A rods on parallel pins, B cubes on balls, C cubes on
//! crossed pins, D an arm.

mod models;
mod states;

use mstmm::{ChainState, Error, GeneratedChain, Scalar};

pub use models::{
    Balls3, Balls10, Balls100, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000,
};
pub use states::{numbers_of_state, random_states};

/// A chain that is timed: every hinge of it has a motor.
pub trait Case: GeneratedChain<Inputs: Clone> + Default {
    /// Its letter and the number of its hinges.
    const NAME: &'static str;

    /// The accelerations alone, into the rates of `rate`.
    ///
    /// # Errors
    /// Those of [`mstmm::Chain::derivative_into`].
    fn accelerations_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        rate: &mut Self::State,
    ) -> Result<(), Error>;

    /// The accelerations among the results of [`GeneratedChain::solve_into`].
    fn accelerations_at(at: &Self::Workspace) -> &[Self::Scalar];

    /// The motors' torques, in the order of the rates.
    fn set_torques(inputs: &mut Self::Inputs, torques: &[Self::Scalar]);

    /// A state and inputs from [numbers](numbers_of_state) in the order `q`, `v`, torques.
    fn sample(&self, numbers: &[f64]) -> (Self::State, Self::Inputs) {
        let (mut state, mut inputs) = (Self::State::default(), self.no_inputs());
        let numbers: Vec<_> = numbers.iter().map(|&number| Scalar::constant(number)).collect();
        let (q, rest) = numbers.split_at(state.q().len());
        let (v, torques) = rest.split_at(state.v().len());
        state.q_mut().copy_from_slice(q);
        state.v_mut().copy_from_slice(v);
        Self::set_torques(&mut inputs, torques);
        (state, inputs)
    }
}

/// Calls a macro with the types of all cases.
#[macro_export]
macro_rules! with_cases {
    ($call:ident) => {
        $call! { Rods3 Rods10 Rods100 Rods1000 Balls3 Balls10 Balls100 Pins7 Pins30 Panda }
    };
}
