//! The cart and the pole of the example `cart_pole`, with a regulator whose gain the board computes.

use mstmm::linear::{Lqr, discretize, lqr};
use mstmm::nalgebra::SMatrix;
use mstmm::{Error, Rk4, mstmm_chain};

use crate::{Hash, Model, Number};

mstmm_chain! {
    /// A cart on a rail and a pole, which hangs down at the angle zero.
    pub plane chain CartPole {
        gravity = [0, -9.81] m/s^2;
        answers = linearize;
        body Cart { mass = 1 kg; com = [0, 0] m; output = [0, 0] m; inertia = 0.01 kg*m^2 about com; }
        body Pole { mass = 0.2 kg; com = [0, -0.5] m; inertia = 0.2/3 kg*m^2 about input; }
        ground -> slider(x) rail -> Cart cart -> pin pivot -> Pole pole;
        hinge rail { force = input; }
        hinge pivot { start = 170 deg; }
    }
}

/// The period of the controller in s, in which it holds its force.
const PERIOD: f64 = 0.01;
/// The weights of position, tilt, velocity and rate, and of the force.
const STATE_WEIGHTS: [f64; 4] = [1.0, 10.0, 1.0, 1.0];
const FORCE_WEIGHT: f64 = 0.1;

/// The regulator, and the motion of the cart and the pole.
pub struct Regulator<T: Number> {
    /// The state about which the chain is linearised.
    upright: CartPoleState<T>,
    lqr: Lqr<T, 4, 1>,
    /// The force on the cart in N, which the motor holds until the next step.
    force: T,
    rk4: Rk4<CartPole<T>>,
}

impl<T: Number> Model for CartPole<T> {
    type Work = Regulator<T>;

    fn new() -> Self {
        CartPole::new()
    }

    fn start(&self) -> Self::State {
        self.initial_state()
    }

    fn inputs(&self, _: &Self::State) -> Self::Inputs {
        self.no_inputs()
    }

    fn work() -> Regulator<T> {
        let zero = T::constant(0.0);
        let mut upright = CartPoleState::default();
        upright.pivot_mut().set_angle(T::constant(core::f64::consts::PI));
        Regulator {
            upright,
            lqr: Lqr { gain: [[zero; 1]; 4].into(), cost: [[zero; 4]; 4].into() },
            force: zero,
            rk4: Rk4::new(T::constant(PERIOD)),
        }
    }

    /// The cart and the pole move under the held force.
    fn advance(&self, regulator: &mut Regulator<T>, state: &mut Self::State) -> Result<(), Error> {
        regulator.rk4.step_held(self, state, &CartPoleInputs { rail: regulator.force })
    }

    /// Linearises the upright chain, discretises it with the held force, computes the gain, and with it the force.
    fn step(&self, regulator: &mut Regulator<T>, state: &mut Self::State) -> Result<(), Error> {
        let Regulator { upright, .. } = regulator;
        let model = discretize(self, upright, &self.no_inputs(), T::constant(PERIOD))?;
        let mut weights = [[T::constant(0.0); 4]; 4];
        let diagonal = weights.iter_mut().enumerate().filter_map(|(k, column)| column.get_mut(k));
        diagonal.zip(STATE_WEIGHTS).for_each(|(entry, weight)| *entry = T::constant(weight));
        let force_weight = SMatrix::from([[T::constant(FORCE_WEIGHT)]]);
        regulator.lqr = lqr(&model.a(), &model.b(), &weights.into(), &force_weight)?;

        let gain = regulator.lqr.gain.iter();
        let deviation = state.q.iter().zip(&upright.q).chain(state.v.iter().zip(&upright.v));
        regulator.force = gain
            .zip(deviation)
            .fold(T::constant(0.0), |force, (&gain, (&x, &upright))| force - gain * (x - upright));
        Ok(())
    }

    fn add_results(regulator: &Regulator<T>, hash: &mut Hash) {
        let Regulator { lqr, force, .. } = regulator;
        hash.add(lqr.gain.iter().chain(&lqr.cost).copied().chain([*force]));
    }

    /// Returns the gain.
    fn results(regulator: &Regulator<T>) -> impl IntoIterator<Item = T> {
        regulator.lqr.gain.iter().copied()
    }
}
