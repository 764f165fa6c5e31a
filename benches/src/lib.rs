//! The chains that are timed, the states they are timed in, and what both have in common.
//!
//! The letters are those of `benches/README.md`: A rods on parallel pins, B cubes on balls, C cubes on
//! crossed pins, D an arm.

mod lanes;
mod models;
mod states;

use mstmm::{Error, GeneratedChain};

pub use lanes::Lanes;
pub use models::{
    Balls3, Balls10, Balls100, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000, with_z,
};
pub use states::{
    numbers_of_state, random_angles, random_states, samples, samples_from, state_from,
};

/// A chain that is timed: every hinge of it has a motor.
pub trait Case: GeneratedChain<Scalar: Lanes, Inputs: Clone> + Default {
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

    /// All connection points of such results, with all their vectors in inertial axes.
    fn points_at(at: &Self::Workspace) -> impl Copy;

    /// The motors' torques, in the order of the rates.
    fn set_torques(inputs: &mut Self::Inputs, torques: &[Self::Scalar]);

    /// A state and inputs from [numbers](random_states).
    fn sample(&self, numbers: impl Iterator<Item = Self::Scalar>) -> (Self::State, Self::Inputs) {
        let (state, torques) = state_from(numbers);
        let mut inputs = self.no_inputs();
        Self::set_torques(&mut inputs, &torques);
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
