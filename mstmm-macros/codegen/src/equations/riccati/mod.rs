//! Riccati transfer: from the free ends to the ground, the relation between `F` and `a` at every
//! point; from the ground outwards, the accelerations. In axes fixed in the parts it is the
//! articulated-body recursion (R. Featherstone, *Rigid Body Dynamics Algorithms*, section 7.3).
//!
//! # Notation
//!
//! All quantities belong to the point of a link, in its work axes, unless another frame is named.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `Iᴬ`, `pᴬ` | [`articulated_body::ArticulatedBody`] | articulated inertia and bias, `F = Iᴬ a + pᴬ` |
//! | `s`, `τ` | [`eliminate::HingeDof`] | a free direction of the link's hinge, `sᵀ F = τ` |
//! | `U`, `D`, `K`, `ε` | [`eliminated_dof::EliminatedDof`] | of the elimination of `s`, equation (1) |
//! | `a'` | `carried` | `a` but for the hinge's own rates, from `a` of the parent |
//! | `v̇` | `amounts` | accelerations along the free directions, `a = a' + Σ s v̇` |
//! | `T`, `λ` | `closing` | directions that the closing hinge holds, its reactions along them |
//! | `Tᴬ`, `γ`, `Λ` | [`loop_sums::LoopSums`] | `T` as it acts here, and the sums of equation (5) |
//!
//! # Equations
//!
//! Inwards, one free direction of a hinge after the other is eliminated:
//!
//! (1)  `U = Iᴬ s`, `D = sᵀ U`, `K = U / D`, `ε = τ − sᵀ pᴬ`
//! (2)  `Iᴬ ← Iᴬ − K Uᵀ`, `pᴬ ← pᴬ + K ε`
//!
//! and outwards
//!
//! (3)  `v̇ = ε / D − Kᵀ a'`
//!
//! What is left has `Iᴬ s = 0` and `sᵀ pᴬ = τ`. Where `s` is an axis both are set exactly, and `Iᴬ`
//! keeps one of each pair of entries only: without that, chains of balls lose all digits.
//!
//! A closing hinge acts on its link with unknown reactions, `F = Iᴬ a + pᴬ + Tᴬ λ`, and demands
//! what `a` of that link is to be along them. The same sweep carries both to the ground:
//!
//! (4)  `t = Tᴬᵀ s`, `Tᴬ ← Tᴬ − K tᵀ`, `γ ← γ + t ε / D`, `Λ ← Λ + t tᵀ / D`
//! (5)  `Tᵀ a = γ + Tᴬᵀ a_ground − Λ λ`
//!
//! Where what follows waits for `1 / D`, (2) is `Iᴬ ← Iᴬ − (U Uᵀ) / D`, and in (3) `Kᵀ a'` is taken
//! apart into what depends on the parent and what does not. The last of several axes of a hinge
//! need not wait for the one before: with what `Iᴬ` was before that one, `a` and `c` on its
//! diagonal for the two and `b` beside it, `D = c − b² / a`:
//!
//! (6)  `1 / D = a / (a c − b²)`

mod articulated_body;
mod eliminate;
mod eliminated_dof;
mod inward;
mod loop_sums;
mod outward;

use super::constraint_forces::ConstraintForces;
use super::motion_problem::{AffineWrench, MotionProblem, MotionSolution};
use super::sweep::PerLink;
use super::{HingePivot, Trace};
use crate::math::Scalar;
use inward::{InwardSweep, sweep_inward};
use outward::sweep_outward;

/// The movement, and the pivots `D`.
pub fn solve<S: Scalar>(
    problem: &MotionProblem<S>,
    trace: &mut Trace<S>,
) -> (MotionSolution<S>, Vec<HingePivot<S>>) {
    let InwardSweep { mut eliminated, affine_wrenches, loop_sums, pivots } =
        sweep_inward(problem, trace);
    let constraint_forces = loop_sums::solve_constraints(problem, loop_sums, trace);
    for step in eliminated.iter_mut().flatten() {
        step.add_reactions(&constraint_forces.reactions);
    }
    let (basis_accelerations, link_accelerations) = sweep_outward(problem, &eliminated, trace);
    (
        MotionSolution {
            basis_accelerations,
            link_accelerations,
            affine_wrenches,
            constraint_forces,
        },
        pivots,
    )
}

/// For methods that solve for the movement in another way: pivots, the reactions of a closing
/// hinge, and what hinges transmit.
pub fn pivots_and_constraint_forces<S: Scalar>(
    problem: &MotionProblem<S>,
    trace: &mut Trace<S>,
) -> (Vec<HingePivot<S>>, ConstraintForces<S>, PerLink<AffineWrench<S>>) {
    let InwardSweep { pivots, loop_sums, affine_wrenches, .. } =
        sweep_inward(problem, &mut Trace::silent());
    trace.section(
        "pivots",
        "Inertia beyond the hinges, to be divided by",
        "the pivots of the Riccati transfer",
    );
    for pivot in &pivots {
        trace.number(format!("{}_d", problem.links[pivot.link].hinge.name), pivot.value);
    }
    let constraint_forces = loop_sums::solve_constraints(problem, loop_sums, trace);
    (pivots, constraint_forces, affine_wrenches)
}
