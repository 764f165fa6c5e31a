//! The chains that are timed, their states, and common items.
//!
//! The letters are those of `benches/README.md`: A rods on parallel pins, B cubes on balls, C cubes on
//! crossed pins, D an arm. Robots that branch have their names.

mod lanes;
mod models;
mod states;
mod timing;

use mstmm::{Error, GeneratedChain};

pub use lanes::Lanes;
pub use models::{
    Balls3, Balls10, Balls100, G1, Hyq, Panda, Pins7, Pins30, Rods3, Rods10, Rods100, Rods1000,
    with_z,
};
pub use states::{
    numbers_of_state, random_angles, random_states, samples, samples_from, state_from,
};
pub use timing::{Times, from_bytes, to_bytes};

/// A chain that is timed. Every hinge has a motor.
pub trait Case: GeneratedChain<Scalar: Lanes, Inputs: Clone> + Default {
    /// Its letter and the number of its hinges, or the name of the robot.
    const NAME: &'static str;

    /// Returns the chain that is timed: no other tool has dampers.
    fn undamped() -> Self {
        Self::default()
    }

    /// Computes only the accelerations, into the rates of `rate`.
    ///
    /// # Errors
    /// Those of [`mstmm::Chain::derivative_into`].
    fn accelerations_into(
        &self,
        state: &Self::State,
        inputs: &Self::Inputs,
        rate: &mut Self::State,
    ) -> Result<(), Error>;

    /// Returns the accelerations in the results of [`GeneratedChain::solve_into`].
    fn accelerations_at(at: &Self::Workspace) -> &[Self::Scalar];

    /// Reads all vectors of all connection points of such results, in inertial axes.
    fn points_at(at: &Self::Workspace) -> impl Copy;

    /// Returns the inputs with the motors' torques, in the order of the rates.
    fn set_torques(inputs: &mut Self::Inputs, torques: &[Self::Scalar]);

    /// Returns a state and inputs from [numbers](random_states).
    fn sample(&self, numbers: impl Iterator<Item = Self::Scalar>) -> (Self::State, Self::Inputs) {
        let (state, torques) = state_from(numbers);
        let mut inputs = self.no_inputs();
        Self::set_torques(&mut inputs, &torques);
        (state, inputs)
    }
}

/// Calls a macro with the types of all cases except the robots that branch.
#[macro_export]
macro_rules! with_cases {
    ($call:ident) => {
        $call! { Rods3 Rods10 Rods100 Rods1000 Balls3 Balls10 Balls100 Pins7 Pins30 Panda }
    };
}
