//! The table of a chain's functions: when there is one, its equations, and what is tested of it.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::examine::Findings;
use crate::model::{Answer, Chain, ClosureRank, Layout, Passive};
use crate::passes::Checks;
use crate::program::Failure;

/// A function of a chain.
pub(super) struct FunctionSpec {
    /// What it answers.
    pub answer: Answer,
    /// Whether a chain has it.
    pub when: fn(&Chain, &Findings, &Layout) -> bool,
    /// Runs its equations.
    pub trace: for<'a> fn(&ChainCompiler<'a>) -> Traced<'a>,
    /// Which output has to be finite, and what a failure leaves.
    pub checks: Option<Checks>,
}

/// Accelerations must be finite; where they are not, what the caller gave stays as it was.
const SOLVED: Option<Checks> =
    Some(Checks { finite: outputs::ACCELERATIONS, failure: Failure::Untouched });

/// All specs, in the order of [`Answer::ALL`].
pub(super) static FUNCTIONS: [FunctionSpec; 10] = [
    FunctionSpec {
        answer: Answer::Accelerations,
        when: always,
        trace: |chain| chain.accelerations(),
        checks: SOLVED,
    },
    FunctionSpec {
        answer: Answer::ImplicitAccelerations,
        when: |chain, _, _| {
            chain.hinges.iter().flat_map(|hinge| &hinge.passive).any(Passive::has_effort)
        },
        trace: |chain| chain.implicit_accelerations(),
        checks: SOLVED,
    },
    FunctionSpec {
        answer: Answer::Solution,
        when: always,
        trace: |chain| chain.solution(),
        checks: Some(Checks { finite: outputs::ACCELERATIONS, failure: Failure::Reset }),
    },
    FunctionSpec {
        answer: Answer::Energy,
        when: always,
        trace: |chain| chain.energy(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::CoordinateRates,
        when: always,
        trace: |chain| chain.coordinate_rates(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::Normalized,
        when: always,
        trace: |chain| chain.normalized(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::Correction,
        when: |_, _, layout| !layout.loop_hinges.is_empty(),
        trace: |chain| chain.correction(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::ClosurePivots,
        when: |_, findings, _| matches!(findings.closure_rank, ClosureRank::FoundAtRunTime(_)),
        trace: |chain| chain.closure_pivots(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::Start,
        when: always,
        trace: |chain| chain.start(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::BiasEfforts,
        when: |chain, _, _| chain.answers.contains(&Answer::BiasEfforts),
        trace: |chain| chain.bias_efforts(),
        checks: Some(Checks { finite: outputs::BIAS_EFFORTS, failure: Failure::Untouched }),
    },
];

fn always(_: &Chain, _: &Findings, _: &Layout) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::FUNCTIONS;
    use crate::model::Answer;

    #[test]
    fn every_answer_has_a_row_in_its_place() {
        assert_eq!(FUNCTIONS.each_ref().map(|spec| spec.answer), Answer::ALL);
    }
}
