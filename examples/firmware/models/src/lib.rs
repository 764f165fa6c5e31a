//! The chains that the firmware steps, the same for the board and for the host.
#![no_std]

mod arm;
mod cart_pole;
mod computed_torque;
mod inverse_dynamics;
mod linear_arm;
mod number;
#[path = "../../../payload_control.rs"]
mod payload_control;
mod pendulum;
mod satellite;

pub use arm::{Arm, ArmState};
pub use cart_pole::CartPole;
pub use inverse_dynamics::InverseDynamics;
pub use linear_arm::LinearArm;
pub use number::{Hash, Number, Random};
pub use payload_control::{Arm as ComputedTorque, PRIOR_DEVIATIONS, TORQUE_DEVIATION};
pub use pendulum::{BallPendulum, BallPendulumState};
pub use satellite::{Satellite, SatelliteState};

use mstmm::{Chain, ChainState, Error, Rk4, Scalar};

/// The seed of all random states.
pub const SEED: u64 = 0x6d73_746d_6d20_3037;

/// The number of random states from which a step is measured.
pub const RANDOM_STATES: usize = 1000;

/// The number of steps that are compared bit by bit.
pub const MOTION_STEPS: usize = 10_000;

/// The number of steps in a timer's interrupt after which the state is compared.
pub const INTERRUPT_STEPS: u32 = 1000;

/// The payload of the arm in the case `computed_torque`, in kg, which its controller does not know, and its height in the
/// hand in m.
pub const PAYLOAD: f64 = 2.0;
pub const PAYLOAD_HEIGHT: f64 = 0.1;

/// A chain with its controller and step.
pub trait Model: Chain<Scalar: Number> + Sized {
    /// What a step needs between steps, and its results in addition to the state.
    type Work;

    /// The chain as described.
    fn new() -> Self;

    /// Returns the start of the motion.
    fn start(&self) -> Self::State;

    /// Returns the inputs of the chain in a state.
    fn inputs(&self, state: &Self::State) -> Self::Inputs;

    /// Returns a random state: any angles and orientations, rates up to 2 rad/s.
    fn random_state(&self, random: &mut Random) -> Self::State {
        let mut state = Self::State::zero_position();
        let pi = <Self::Scalar as Scalar>::constant(core::f64::consts::PI);
        let two = <Self::Scalar as Scalar>::constant(2.0);
        state
            .coordinates_mut()
            .iter_mut()
            .for_each(|q| *q = pi * random.between_minus_one_and_one());
        state.rates_mut().iter_mut().for_each(|v| *v = two * random.between_minus_one_and_one());
        self.normalize(&mut state);
        state
    }

    /// Calls a function with the start of the motion, with each of its numbers in turn replaced by each
    /// [bad](Number::BAD) number.
    fn for_each_bad_state(&self, mut work: impl FnMut(Self::State)) {
        let start = self.start();
        let coordinates = start.coordinates().len();
        for index in 0..coordinates + start.rates().len() {
            for bad in Self::Scalar::BAD {
                let mut state = start.clone();
                if let Some(number) = state.coordinates_mut().get_mut(index) {
                    *number = bad;
                } else if let Some(number) = state.rates_mut().get_mut(index - coordinates) {
                    *number = bad;
                }
                work(state);
            }
        }
    }

    /// Returns what the first step needs.
    fn work() -> Self::Work;

    /// Moves what the steps control, before each step; not part of the step.
    fn advance(&self, _: &mut Self::Work, _: &mut Self::State) -> Result<(), Error> {
        Ok(())
    }

    /// Takes one step, as a timer's interrupt does.
    fn step(&self, work: &mut Self::Work, state: &mut Self::State) -> Result<(), Error>;

    /// Adds the results of a step to a hash, apart from the state.
    fn add_results(_: &Self::Work, _: &mut Hash) {}

    /// Returns the results of a motion, apart from the state at its end.
    fn results(_: &Self::Work) -> impl IntoIterator<Item = Self::Scalar> {
        []
    }
}

/// The length of all steps in s.
pub const STEP: f64 = 1e-3;

/// Returns an integrator for a chain.
fn integrator<M: Model>() -> Rk4<M> {
    Rk4::new(<M::Scalar as Scalar>::constant(STEP))
}

/// Takes one step of the classical Runge–Kutta method.
fn simulate<M: Model>(model: &M, rk4: &mut Rk4<M>, state: &mut M::State) -> Result<(), Error> {
    rk4.step(model, state, |_, state| model.inputs(state))
}
