//! The way back, from the ground outwards: equation (3).

use super::super::Trace;
use super::super::hinge::Column;
use super::super::problem::Problem;
use super::direction::Eliminated;
use crate::math::{Motion, Scalar};

/// The amounts `β` and the accelerations of all points.
pub(super) fn recover<S: Scalar>(
    problem: &Problem<S>,
    eliminated: &[Vec<Eliminated<S>>],
    trace: &mut Trace<S>,
) -> (Vec<Vec<S>>, Vec<Motion<S>>) {
    let mut points: Vec<Motion<S>> = Vec::new();
    let mut amounts = Vec::new();
    for (index, (link, eliminated)) in problem.links.iter().zip(eliminated).enumerate() {
        let over = &link.over;
        trace.section(
            format!("{}_acceleration", over.name),
            format!("Acceleration of `{}`", over.name),
            "[P, Eqs. (13), (36), (44)]",
        );
        let carried = problem.carried(index, &points);
        let (betas, acceleration) = match &eliminated[..] {
            [step @ Eliminated { waiting: Some(axis), .. }] => {
                let parent = problem.parent(index, &points);
                advance_early(problem, index, (parent, carried), step, *axis)
            }
            steps => advance(carried, steps, &over.freedom.armature),
        };
        trace.motion(&format!("{}_a", over.name), acceleration);
        points.push(problem.passage.outwards(index, acceleration));
        amounts.push(betas);
    }
    (amounts, points)
}

/// Adds the parts of a hinge's free directions to `acceleration`; returns their amounts `β` as well.
fn advance<S: Scalar>(
    mut acceleration: Motion<S>,
    steps: &[Eliminated<S>],
    armatures: &[S],
) -> (Vec<S>, Motion<S>) {
    let mut betas = Vec::new();
    for (step, armature) in steps.iter().zip(armatures).rev() {
        let before = acceleration;
        let beta = match step.column {
            // The new component follows without the old one, which then matters to `β` alone.
            Column::Axis(axis) if armature.vanishes() => {
                let new = step.rest - before.power(step.beside(axis));
                acceleration = before.with(axis, new);
                new - before.at(axis)
            }
            column => {
                let beta = step.rest - before.power(step.gain);
                acceleration = before + column.motion().scaled(beta);
                beta
            }
        };
        betas.insert(0, beta);
    }
    (betas, acceleration)
}

/// The same for a single axis, with `zᵀ a'` of equation (3) taken apart: most of it is known before
/// `a` of the parent is, and need not wait for it.
fn advance_early<S: Scalar>(
    problem: &Problem<S>,
    index: usize,
    (parent, carried): (Motion<S>, Motion<S>),
    step: &Eliminated<S>,
    axis: usize,
) -> (Vec<S>, Motion<S>) {
    let beside = step.beside(axis);
    let over = &problem.links[index].over;
    let rest = step.rest - problem.drift[index].power(&over.to_parent, beside);
    let new = rest - parent.power(over.returned(beside));
    (vec![new - carried.at(axis)], carried.with(axis, new))
}

#[cfg(test)]
mod tests {
    use super::super::direction::tests::{carried, some};
    use super::super::direction::{Condition, eliminate};
    use super::{Column, Eliminated, Motion, advance};
    use crate::math::{Scalar, Structured, Vec3};

    /// `Sᵀ (A (a' + S β) + e) + H β = τ` for all directions of a hinge at once.
    fn check(columns: &[usize], armatures: &[f64]) {
        let mut here = carried();
        let (inertia, load) = (here.inertia, here.load);
        let rotor = |number: usize| match armatures[number] {
            0.0 => Structured::zero(),
            armature => some(armature),
        };
        let conditions: Vec<Condition<Structured<f64>>> = columns
            .iter()
            .enumerate()
            .map(|(number, &axis)| Condition {
                column: Column::Axis(axis),
                effort: some(0.25 - 0.375 * number as f64),
                armature: rotor(number),
            })
            .collect();
        let steps = eliminate(&mut here, &conditions);
        let steps: Vec<Eliminated<_>> = steps.into_iter().map(|(_, step)| step).collect();
        let carried = Motion {
            linear: Vec3([0.7, -0.2, 1.9].map(some)),
            angular: Vec3([-0.4, 0.6, 0.5].map(some)),
        };
        let rotors: Vec<Structured<f64>> = conditions.iter().map(|c| c.armature).collect();
        let (betas, acceleration) = advance(carried, &steps, &rotors);
        let transmitted = inertia.times(acceleration) + load;
        for (condition, beta) in conditions.iter().zip(betas) {
            let found = condition.column.motion().power(transmitted) + condition.armature * beta;
            // Sums of products up to 10, pivots above 0.1 of what they come from: a hundred roundings.
            let error = (found - condition.effort).value().abs();
            assert!(error < 10.0 * 100.0 * f64::EPSILON, "{columns:?} {armatures:?}: {error:e}");
        }
    }

    #[test]
    fn what_is_recovered_fulfils_the_conditions_of_all_directions() {
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
