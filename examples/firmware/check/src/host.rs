//! The same motion on this machine.

use std::fmt;

use models::{Arm, Hash, INTERRUPT_STEPS, MOTION_STEPS, Model, Number};
use mstmm::ChainState;

use crate::case::{Case, Visitor};

/// The end of a motion.
#[derive(Clone, Debug)]
pub struct Motion {
    /// The bits of the coordinates and rates at its end.
    pub end: Vec<u64>,
    /// The bits of its results.
    pub results: Vec<u64>,
    /// The hash of the bits of all its states.
    pub hash: u64,
    shown: String,
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "after {MOTION_STEPS} steps {}; hash {:016x}", self.shown, self.hash)
    }
}

/// Simulates the motion from the start of the description.
pub fn simulate(case: Case) -> Motion {
    case.visit(Simulation { steps: MOTION_STEPS })
}

/// Returns the arm in single precision after the number of steps of the image `interrupt`.
pub fn arm_of_interrupt() -> Vec<u64> {
    Simulation { steps: INTERRUPT_STEPS as usize }.visit::<Arm<f32>>().end
}

struct Simulation {
    steps: usize,
}

impl Visitor for Simulation {
    type Result = Motion;

    fn visit<M: Model>(self) -> Motion {
        let (model, mut work) = (M::new(), M::work());
        let (mut state, mut hash) = (model.start(), Hash::default());
        for _ in 0..self.steps {
            let advanced = model.advance(&mut work, &mut state);
            advanced
                .and_then(|()| model.step(&mut work, &mut state))
                .expect("the motions are regular everywhere");
            hash.add_state(&state);
            M::add_results(&work, &mut hash);
        }
        let numbers = state.coordinates().iter().chain(state.rates());
        Motion {
            end: numbers.map(|number| number.bits()).collect(),
            results: M::results(&work).into_iter().map(Number::bits).collect(),
            hash: hash.value(),
            shown: format!("q = {:?}, v = {:?}", state.coordinates(), state.rates()),
        }
    }
}
