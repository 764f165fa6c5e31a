//! The way back, from the ground outwards: equation (3).

use super::super::Trace;
use super::super::hinge::Column;
use super::super::problem::Problem;
use super::Eliminated;
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
        trace.section(format!("Acceleration of `{}`", over.name), "[P, Eqs. (13), (36), (44)]");
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
    let rest = step.rest - problem.drift[index].power(beside);
    let new = rest - parent.power(problem.links[index].over.returned(beside));
    (vec![new - carried.at(axis)], carried.with(axis, new))
}
