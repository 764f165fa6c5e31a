//! The outward sweep, from the ground to the free ends: equation (3).

use super::super::Trace;
use super::super::hinge::BasisVector;
use super::super::motion_problem::MotionProblem;
use super::super::sweep::PerLink;
use super::eliminated_dof::EliminatedDof;
use crate::ids::LinkId;
use crate::math::{Motion, Scalar};

/// Returns the accelerations `v̇` along the basis vectors of all hinges, and the accelerations of
/// all points.
pub(super) fn sweep_outward<S: Scalar>(
    problem: &MotionProblem<S>,
    eliminated: &PerLink<Vec<EliminatedDof<S>>>,
    trace: &mut Trace<S>,
) -> (PerLink<Vec<S>>, PerLink<Motion<S>>) {
    let (accelerations, rates) =
        problem.tree.outward(problem.base_acceleration, |link, &parent| {
            let hinge = &problem.links[link].hinge;
            trace.section(
                format!("{}_acceleration", hinge.name),
                format!("Acceleration of `{}`", hinge.name),
                "[P, Eqs. (13), (36), (44)]",
            );
            let inherited = problem.acceleration_from_parent(link, parent);
            let (rates, acceleration) = match &eliminated[link][..] {
                [step @ EliminatedDof { waiting_axis: Some(axis), .. }] => {
                    advance_early(problem, link, (parent, inherited), step, *axis)
                }
                steps => advance(inherited, steps, &hinge.basis.armature),
            };
            trace.motion(&format!("{}_acc", hinge.name), acceleration);
            (acceleration, rates)
        });
    (rates, accelerations)
}

/// Adds the hinge's own motion to `acceleration`; returns `v̇` and the sum.
fn advance<S: Scalar>(
    mut acceleration: Motion<S>,
    steps: &[EliminatedDof<S>],
    armatures: &[S],
) -> (Vec<S>, Motion<S>) {
    let mut rates = vec![S::zero(); steps.len()];
    for step in steps.iter().rev() {
        let before = acceleration;
        let rate = match step.direction {
            // The new component follows without the old one, which only affects `v̇`.
            BasisVector::Axis(axis) if armatures[step.column].vanishes() => {
                let new = step.u_over_d - before.power(step.gain_without(axis));
                acceleration = before.with_entry(axis, new);
                new - before.at(axis)
            }
            direction => {
                let rate = step.u_over_d - before.power(step.gain);
                acceleration = before + direction.motion().scaled(rate);
                rate
            }
        };
        rates[step.column] = rate;
    }
    (rates, acceleration)
}

/// Does the same for a single axis, with `Kᵀ a'` of equation (3) split. Most of it is known before
/// `a` of the parent, and does not wait for it.
fn advance_early<S: Scalar>(
    problem: &MotionProblem<S>,
    link: LinkId,
    (parent, inherited): (Motion<S>, Motion<S>),
    step: &EliminatedDof<S>,
    axis: usize,
) -> (Vec<S>, Motion<S>) {
    let gain = step.gain_without(axis);
    let hinge = &problem.links[link].hinge;
    let known = step.u_over_d - problem.bias_accelerations[link].power(&hinge.to_parent, gain);
    let new = known - parent.power(hinge.wrench_to_parent(gain));
    (vec![new - inherited.at(axis)], inherited.with_entry(axis, new))
}

#[cfg(test)]
mod tests {
    use super::super::eliminate::tests::{articulated_body, some};
    use super::super::eliminate::{HingeDof, eliminate};
    use super::{BasisVector, Motion, advance};
    use crate::math::{Scalar, Structured, Vec3};

    /// Checks `Sᵀ (I (a' + S v̇) + p) + H v̇ = τ` for all degrees of freedom of a hinge together.
    fn check(columns: &[usize], armatures: &[f64]) {
        let mut body = articulated_body();
        let (inertia, load) = (body.inertia, body.bias_force);
        let rotor = |number: usize| match armatures[number] {
            0.0 => Structured::zero(),
            armature => some(armature),
        };
        let dofs: Vec<HingeDof<Structured<f64>>> = columns
            .iter()
            .enumerate()
            .map(|(number, &axis)| HingeDof {
                column: number,
                direction: BasisVector::Axis(axis),
                effort: some(0.25 - 0.375 * number as f64),
                armature: rotor(number),
            })
            .collect();
        let steps = eliminate(&mut body, &dofs);
        let inherited = Motion {
            linear: Vec3([0.7, -0.2, 1.9].map(some)),
            angular: Vec3([-0.4, 0.6, 0.5].map(some)),
        };
        let rotors: Vec<Structured<f64>> = dofs.iter().map(|c| c.armature).collect();
        let (rates, acceleration) = advance(inherited, &steps, &rotors);
        let transmitted = inertia.times(acceleration) + load;
        for (dof, rate) in dofs.iter().zip(rates) {
            let found = dof.direction.motion().power(transmitted) + dof.armature * rate;
            // Sums of products up to 10, pivots above 0.1 of their terms: a hundred roundings.
            let error = (found - dof.effort).value().abs();
            assert!(error < 10.0 * 100.0 * f64::EPSILON, "{columns:?} {armatures:?}: {error:e}");
        }
    }

    #[test]
    fn the_outward_sweep_satisfies_all_hinge_conditions() {
        check(&[5], &[0.0]);
        check(&[3, 4, 5], &[0.0, 0.0, 0.0]);
        check(&[4, 5], &[0.0, 0.0]);
        check(&[2, 5], &[0.0, 0.0]);
        check(&[0, 1, 5], &[0.0, 0.0, 0.0]);
        check(&[0, 1, 2, 3, 4, 5], &[0.0; 6]);
        for armatures in [[0.7, 0.0, 0.0], [0.0, 0.7, 0.0], [0.0, 0.0, 0.7], [0.3, 0.5, 0.7]] {
            check(&[3, 4, 5], &armatures);
        }
    }
}
