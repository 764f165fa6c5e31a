//! The five integrators of the library, each as a number of equal steps.

use mstmm::Error;
use mstmm::prelude::*;

use super::{Cubes, CubesState, END, apart};

/// An integrator, and what it promises.
pub struct Method {
    pub name: &'static str,
    pub order: f64,
    steps: Steps,
}

/// Takes a state over so many steps to the end and returns how often accelerations were computed.
type Steps = fn(&Cubes<f64>, &mut CubesState<f64>, u32) -> Result<u64, Error>;

/// What became of a run.
#[derive(Clone, Copy)]
pub struct Run {
    pub step: f64,
    /// In rad and rad/s; not a number where the motion grew beyond all bounds.
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

/// It chooses its own steps, unless its shortest and its longest one are the same and any error passes.
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
    /// Runs with 2 to the power of `exponent` steps.
    pub fn run(&self, chain: &Cubes<f64>, exact: &CubesState<f64>, exponent: u32) -> Run {
        let mut state = chain.initial_state();
        let count = 1 << exponent;
        // A motion that grows beyond all bounds ends in one error or another.
        let (evaluations, error) = match (self.steps)(chain, &mut state, count) {
            Ok(evaluations) => (evaluations as f64, apart(&state, exact)),
            Err(_) => (f64::NAN, f64::NAN),
        };
        Run { step: END / f64::from(count), error, evaluations }
    }
}
