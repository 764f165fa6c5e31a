//! Riccati transfer: inward from the free ends, the relation between `F` and `a` at every point;
//! outward from the ground, the accelerations. In axes fixed in the parts this is the
//! articulated-body algorithm (R. Featherstone, *Rigid Body Dynamics Algorithms*, section 7.3).
//!
//! # Notation
//!
//! All quantities belong to the point of a link, in its work axes, unless another frame is named.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `Iᴬ`, `pᴬ` | [`articulated_body::ArticulatedBody`] | articulated inertia and bias force, `F = Iᴬ a + pᴬ` |
//! | `s`, `τ` | [`eliminate::HingeDof`] | a column of the motion subspace in the elimination basis and its effort, `sᵀ F = τ` |
//! | `U`, `D`, `K`, `u` | [`eliminated_dof::EliminatedDof`] | of the elimination of `s`, equation (1) |
//! | `a'` | `inherited` | `a` without the hinge's own accelerations: `X a_p + b` |
//! | `v̇` | `basis_accelerations` | accelerations along the directions `s`, `a = a' + Σ s v̇` |
//! | `T`, `λ` | `loop_hinge` | constraint wrenches of the loop hinge, constraint forces |
//! | `Tᴬ`, `γ`, `Λ` | [`loop_sums::LoopSums`] | `T` propagated to the link, and the sums of equation (5) |
//!
//! # Equations
//!
//! Inward, the degrees of freedom of each hinge are eliminated one after the other:
//!
//! (1)  `U = Iᴬ s`, `D = sᵀ U`, `K = U / D`, `u = τ − sᵀ pᴬ`
//! (2)  `Iᴬ ← Iᴬ − K Uᵀ`, `pᴬ ← pᴬ + K u`
//!
//! and outward
//!
//! (3)  `v̇ = u / D − Kᵀ a'`
//!
//! A rotor with inertia `H` along `s` adds `H` to `D`. Without a rotor, the result has `Iᴬ s = 0`
//! and `sᵀ pᴬ = τ`. If `s` is an axis, both are set exactly, and of each pair of symmetric entries
//! of `Iᴬ` only one is stored. Otherwise chains of balls would lose all digits.
//!
//! The axes of a free base are eliminated in any order. Those on which no child acts come first: their
//! entries of `Iᴬ` are those of the base itself, and (2) is then constant in part. A child on a ball
//! acts on no rotation, if the point of the base is at the ball.
//!
//! A loop hinge acts on its inboard link with unknown constraint forces, `F = Iᴬ a + pᴬ + Tᴬ λ`,
//! and prescribes `Tᵀ a` of that link. The same sweep propagates both to the ground:
//!
//! (4)  `t = Tᴬᵀ s`, `Tᴬ ← Tᴬ − K tᵀ`, `γ ← γ + t u / D`, `Λ ← Λ + t tᵀ / D`
//! (5)  `Tᵀ a = γ + Tᴬᵀ a_ground − Λ λ`
//!
//! If later computations would wait for `1 / D`, (2) is computed as `Iᴬ ← Iᴬ − (U Uᵀ) / D`, and `Kᵀ
//! a'` in
//! (3) is split into a part that depends on the parent and a part that does not. The last of several axes of
//! a hinge does not wait for the axis before it: with the entries `a` and `c` of the two axes on
//! the diagonal of `Iᴬ` and their coupling `b`, all before that axis is eliminated, `D = c − b² /
//! a` and
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

/// Solves the problem by the Riccati transfer. Returns the solution and the pivots `D`.
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

/// Returns pivots, constraint forces and affine wrenches, for methods that compute the
/// accelerations differently.
pub fn pivots_and_constraint_forces<S: Scalar>(
    problem: &MotionProblem<S>,
    trace: &mut Trace<S>,
) -> (Vec<HingePivot<S>>, ConstraintForces<S>, PerLink<AffineWrench<S>>) {
    let InwardSweep { pivots, loop_sums, affine_wrenches, .. } =
        sweep_inward(problem, &mut Trace::silent());
    trace.section(
        "pivots",
        "Pivots: inertia outboard of each degree of freedom",
        "of the Riccati transfer",
    );
    for pivot in &pivots {
        trace.number(format!("{}_d", problem.links[pivot.link].hinge.name), pivot.value);
    }
    let constraint_forces = loop_sums::solve_constraints(problem, loop_sums, trace);
    (pivots, constraint_forces, affine_wrenches)
}
