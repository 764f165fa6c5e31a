//! The five integrators of the library with equal steps.

use mstmm::Error;
use mstmm::prelude::*;

use super::{Cubes, CubesState, END, difference};

/// An integrator and its order of convergence.
pub struct Method {
    pub name: &'static str,
    pub order: f64,
    steps: Steps,
}

/// Integrates a state to the end in a number of steps. Returns the number of evaluations of the
/// accelerations.
type Steps = fn(&Cubes<f64>, &mut CubesState<f64>, u32) -> Result<u64, Error>;

/// The result of a run.
#[derive(Clone, Copy)]
pub struct Run {
    pub step: f64,
    /// In rad and rad/s; NaN if the motion diverged.
    pub error: f64,
    pub evaluations: f64,
}

macro_rules! equal_steps {
    ($method:ident, $evaluations:literal) => {
        |chain, state, count| {
            let mut method = $method::new(END / f64::from(count));
            for _ in 0..count {
                method.step(chain, state, |_time, _state| chain.no_inputs())?;
            }
            Ok($evaluations * u64::from(count))
        }
    };
}

/// From the highest order to the lowest.
pub const ALL: [Method; 5] = [
    Method { name: "Dormand–Prince, equal h", order: 5.0, steps: dormand_prince },
    Method { name: "Runge–Kutta 4", order: 4.0, steps: equal_steps!(Rk4, 4) },
    Method { name: "Newmark", order: 2.0, steps: equal_steps!(Newmark, 4) },
    Method { name: "semi-implicit Euler", order: 1.0, steps: equal_steps!(SemiImplicitEuler, 1) },
    Method {
        name: "linearly implicit Euler",
        order: 1.0,
        steps: equal_steps!(LinearlyImplicitEuler, 1),
    },
];

/// Its steps are equal if the shortest and the longest step are the same and any error is accepted.
fn dormand_prince(
    chain: &Cubes<f64>,
    state: &mut CubesState<f64>,
    count: u32,
) -> Result<u64, Error> {
    let step = END / f64::from(count);
    let mut dopri5 = Dopri5::new(0.0, 1e9).with_first_step(step).with_step_limits(step, step);
    for _ in 0..count {
        dopri5.step(chain, state, |_time, _state| chain.no_inputs())?;
    }
    Ok(dopri5.statistics().evaluations)
}

impl Method {
    /// Runs the integrator with 2 to the power of `exponent` steps.
    pub fn run(&self, chain: &Cubes<f64>, exact: &CubesState<f64>, exponent: u32) -> Run {
        let mut state = chain.initial_state();
        let count = 1 << exponent;
        // A motion that diverges ends with an error.
        let (evaluations, error) = match (self.steps)(chain, &mut state, count) {
            Ok(evaluations) => (evaluations as f64, difference(&state, exact)),
            Err(_) => (f64::NAN, f64::NAN),
        };
        Run { step: END / f64::from(count), error, evaluations }
    }
}
