//! The table of a chain's functions: condition, equations and tests of each.

use super::compiler::{ChainCompiler, Traced};
use super::outputs;
use crate::equations::{takes_rates_together, writes_matrices_out};
use crate::examine::Findings;
use crate::model::{Answer, Chain, ClosureRank, Dimension, Layout, MovesWith, Passive, Request};
use crate::passes::Checks;
use crate::program::{Failure, OutputId};

/// The specification of a function.
pub(super) struct FunctionSpec {
    /// The answer that it computes.
    pub answer: Answer,
    /// Returns whether a chain has the function.
    pub when: fn(&Chain, &Findings, &Layout) -> bool,
    /// Traces its equations.
    pub trace: for<'a> fn(&ChainCompiler<'a>) -> Traced<'a>,
    /// The outputs that must be finite, and the contents of the results after a failure.
    pub checks: Option<Checks>,
}

/// Accelerations must be finite; after a failure the caller's vector is unchanged.
const SOLVED: Option<Checks> = checked(&[outputs::ACCELERATIONS]);

/// The tested results of a gradient. By rates and inputs it has no larger products than these, and testing all of it took
/// 1.15 of the time for three balls.
const GRADIENT: &[OutputId] = &[outputs::ACCELERATIONS, outputs::BY_COORDINATES];

impl FunctionSpec {
    /// Returns the tests of the function for a chain. Derivatives of dry friction and of springs between bodies may overflow
    /// where the efforts are finite: at a rate or a length near zero. They are tested then.
    pub fn checks_for(&self, chain: &Chain) -> Option<Checks> {
        let finite: &[OutputId] = match self.answer {
            Answer::InverseDynamicsDerivatives => &[outputs::BY_COORDINATES, outputs::BY_RATES],
            Answer::Linearization | Answer::Pull => &[
                outputs::ACCELERATIONS,
                outputs::BY_COORDINATES,
                outputs::BY_RATES,
                outputs::BY_PARAMETERS,
            ],
            _ => return self.checks,
        };
        let mut passives = chain.hinges.iter().flat_map(|hinge| &hinge.passive);
        let is_steep =
            !chain.springs.is_empty() || passives.any(|passive| passive.friction.is_some());
        match is_steep {
            true => self.checks.map(|checks| Checks { finite, ..checks }),
            false => self.checks,
        }
    }
}

/// All functions, in the order of [`Answer::ALL`].
pub(super) static FUNCTIONS: [FunctionSpec; 33] = [
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
        checks: Some(Checks {
            finite: &[outputs::ACCELERATIONS],
            failure: Failure::Reset,
            unread: true,
        }),
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
        when: |chain, _, _| {
            [Request::BiasEfforts, Request::InverseDynamics].iter().any(|&it| asks(chain, it))
        },
        trace: |chain| chain.bias_efforts(),
        checks: checked(&[outputs::BIAS_EFFORTS]),
    },
    FunctionSpec {
        answer: Answer::InverseDynamics,
        when: |chain, _, _| asks(chain, Request::InverseDynamics),
        trace: |chain| chain.inverse_dynamics(),
        checks: checked(&[outputs::EFFORTS]),
    },
    FunctionSpec {
        answer: Answer::GravityEfforts,
        when: |chain, _, _| asks(chain, Request::InverseDynamics),
        trace: |chain| chain.gravity_efforts(),
        checks: checked(&[outputs::EFFORTS]),
    },
    FunctionSpec {
        answer: Answer::PassiveEfforts,
        when: |chain, _, _| asks(chain, Request::InverseDynamics),
        trace: |chain| chain.passive_efforts(),
        checks: checked(&[outputs::EFFORTS]),
    },
    FunctionSpec {
        answer: Answer::InverseSolution,
        when: |chain, _, layout| {
            asks(chain, Request::InverseDynamics) && layout.loop_hinges.is_empty()
        },
        trace: |chain| chain.inverse_solution(),
        checks: Some(Checks { finite: &[outputs::EFFORTS], failure: Failure::Reset, unread: true }),
    },
    FunctionSpec {
        answer: Answer::MassMatrixTimes,
        when: |chain, _, layout| {
            asks(chain, Request::MassMatrix) || by_columns(chain, layout, Request::Derivatives)
        },
        trace: |chain| chain.mass_matrix_times(),
        checks: checked(&[outputs::PRODUCT]),
    },
    FunctionSpec {
        answer: Answer::InverseMassMatrixTimes,
        when: |chain, _, layout| {
            let is_asked = asks(chain, Request::MassMatrix) && layout.loop_hinges.is_empty();
            is_asked || by_columns(chain, layout, Request::Linearize)
        },
        trace: |chain| chain.inverse_mass_matrix_times(),
        checks: checked(&[outputs::PRODUCT]),
    },
    FunctionSpec {
        answer: Answer::Push,
        when: |chain, _, layout| {
            asks(chain, Request::Push) || by_columns(chain, layout, Request::Linearize)
        },
        trace: |chain| chain.push(),
        checks: checked(&[outputs::CHANGE]),
    },
    FunctionSpec {
        answer: Answer::EffortsChange,
        when: |chain, _, layout| by_columns(chain, layout, Request::Derivatives),
        trace: |chain| chain.efforts_change(),
        checks: checked(&[outputs::CHANGE]),
    },
    FunctionSpec {
        answer: Answer::Pull,
        when: |chain, _, _| asks(chain, Request::Pull),
        trace: |chain| chain.pull(),
        checks: checked(GRADIENT),
    },
    FunctionSpec {
        answer: Answer::ClosureJacobianTimes,
        when: |chain, _, layout| asks(chain, Request::Jacobian) && !layout.loop_hinges.is_empty(),
        trace: |chain| chain.closure_jacobian_times(),
        checks: checked(&[outputs::PRODUCT]),
    },
    FunctionSpec {
        answer: Answer::Regressor,
        when: |chain, _, layout| asks(chain, Request::Regressor) && is_dense(chain, layout),
        trace: |chain| chain.regressor(),
        checks: dense(&[outputs::REGRESSOR]),
    },
    FunctionSpec {
        answer: Answer::RegressorTimes,
        when: |chain, _, _| asks(chain, Request::Regressor),
        trace: |chain| chain.regressor_times(),
        checks: checked(&[outputs::PRODUCT]),
    },
    FunctionSpec {
        answer: Answer::DynamicParameters,
        when: |chain, _, _| asks(chain, Request::Regressor),
        trace: |chain| chain.dynamic_parameters(),
        checks: None,
    },
    FunctionSpec {
        answer: Answer::MassMatrix,
        when: |chain, _, layout| asks(chain, Request::MassMatrix) && is_dense(chain, layout),
        trace: |chain| chain.mass_matrix(),
        checks: dense(&[outputs::MATRIX]),
    },
    FunctionSpec {
        answer: Answer::InverseMassMatrix,
        when: |chain, _, layout| {
            asks(chain, Request::MassMatrix)
                && is_dense(chain, layout)
                && layout.loop_hinges.is_empty()
        },
        trace: |chain| chain.inverse_mass_matrix(),
        checks: dense(&[outputs::MATRIX]),
    },
    FunctionSpec {
        answer: Answer::InverseDynamicsDerivatives,
        when: |chain, _, layout| asks(chain, Request::Derivatives) && is_dense(chain, layout),
        trace: |chain| chain.inverse_dynamics_derivatives(),
        checks: dense(&[outputs::BY_COORDINATES]),
    },
    FunctionSpec {
        answer: Answer::Linearization,
        when: |chain, _, layout| asks(chain, Request::Linearize) && is_dense(chain, layout),
        trace: |chain| chain.linearization(),
        checks: dense(&[outputs::ACCELERATIONS]),
    },
    FunctionSpec {
        answer: Answer::Kinematics,
        when: |chain, _, _| {
            [Request::Kinematics, Request::Jacobian].iter().any(|&it| asks(chain, it))
        },
        trace: |chain| chain.kinematics(),
        checks: Some(Checks { finite: &[outputs::MOTIONS], failure: Failure::Reset, unread: true }),
    },
    FunctionSpec {
        answer: Answer::Momentum,
        when: |chain, _, _| asks(chain, Request::Momentum),
        trace: |chain| chain.momentum(),
        checks: checked(&[outputs::MOMENTUM]),
    },
    FunctionSpec {
        answer: Answer::MomentumMatrix,
        when: |chain, _, _| asks(chain, Request::Momentum),
        trace: |chain| chain.momentum_matrix(),
        checks: checked(&[outputs::MOMENTUM]),
    },
    FunctionSpec {
        answer: Answer::RegressorMotions,
        when: |chain, _, layout| {
            asks(chain, Request::Regressor) && has_regressor_by_rates(chain, layout)
        },
        trace: |chain| chain.regressor_motions(),
        checks: dense(&[outputs::MOTIONS]),
    },
    FunctionSpec {
        answer: Answer::CoriolisMatrixTimes,
        when: |chain, _, _| asks(chain, Request::CoriolisMatrix),
        trace: |chain| chain.coriolis_matrix_times(),
        checks: checked(&[outputs::PRODUCT]),
    },
    FunctionSpec {
        answer: Answer::CoriolisMatrix,
        when: |chain, _, layout| asks(chain, Request::CoriolisMatrix) && is_dense(chain, layout),
        trace: |chain| chain.coriolis_matrix(),
        checks: dense(&[outputs::MATRIX]),
    },
];

/// The outputs must be finite; after a failure the caller's storage is unchanged.
const fn checked(finite: &'static [OutputId]) -> Option<Checks> {
    Some(Checks { finite, failure: Failure::Untouched, unread: true })
}

/// The outputs must be finite; after a failure some entries may have been written.
const fn dense(finite: &'static [OutputId]) -> Option<Checks> {
    Some(Checks { finite, failure: Failure::PartlyWritten, unread: true })
}

/// The Jacobian of a point must be finite. Rates and other hinges do not matter, and to test them would take a part of the
/// time of a short function.
pub(super) const OF_POINT: Option<Checks> =
    Some(Checks { finite: &[outputs::MATRIX], failure: Failure::PartlyWritten, unread: false });

/// Returns whether the matrices of a chain are computed entry by entry, not column by column in loops.
fn is_dense(chain: &Chain, layout: &Layout) -> bool {
    writes_matrices_out(!chain.repeats.is_empty(), layout.dof_count())
}

/// Returns whether an answer of a chain is a product that a matrix is computed by, several columns at a time.
pub(super) fn is_by_columns(chain: &Chain, layout: &Layout, answer: Answer) -> bool {
    let lacks = |request| by_columns(chain, layout, request);
    match answer {
        Answer::MassMatrixTimes => lacks(Request::MassMatrix) || lacks(Request::Derivatives),
        Answer::InverseMassMatrixTimes => lacks(Request::MassMatrix) || lacks(Request::Linearize),
        Answer::CoriolisMatrixTimes => lacks(Request::CoriolisMatrix),
        Answer::EffortsChange => lacks(Request::Derivatives),
        Answer::Push => lacks(Request::Linearize),
        Answer::RegressorTimes => lacks(Request::Regressor),
        Answer::ClosureJacobianTimes => true,
        _ => false,
    }
}

/// Returns whether the regressor of a chain is computed with several rates at a time, by scalar types that have columns.
fn has_regressor_by_rates(chain: &Chain, layout: &Layout) -> bool {
    let lengths = layout.path_lengths();
    let moving = |body| match layout.parts[body] {
        MovesWith::Ground => 0,
        MovesWith::Link(link) => lengths[link],
    };
    let has_this_form = chain.dimension == Dimension::Space && is_dense(chain, layout);
    let pairs = chain.physical_bodies().map(moving).sum();
    has_this_form && takes_rates_together(layout.dof_count(), pairs)
}

/// Returns whether a chain is asked for matrices that are computed column by column.
fn by_columns(chain: &Chain, layout: &Layout, request: Request) -> bool {
    asks(chain, request) && !is_dense(chain, layout)
}

fn asks(chain: &Chain, request: Request) -> bool {
    chain.requests.contains(&request)
}

fn always(_: &Chain, _: &Findings, _: &Layout) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::FUNCTIONS;
    use crate::model::Answer;

    #[test]
    fn the_table_is_in_the_order_of_the_answers() {
        assert_eq!(FUNCTIONS.each_ref().map(|spec| spec.answer), Answer::ALL);
    }
}
