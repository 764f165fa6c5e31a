//! Springs whose ends are not in the same repetition of a part.
//!
//! The motion of an end crosses the boundaries of repeated parts outward, in the inertial frame: from
//! one repetition to the next, or from the last repetition to what is outside. Its force crosses them
//! inward. Bodies outside of a repeated part are the same for all repetitions, and the forces of all
//! repetitions on them are added up.

use super::super::sweep::Flatten;
use super::{PointForce, SpringSpan, Springs, to_point};
use crate::ids::{IdVec, SpringId};
use crate::math::{Rotation, Scalar, Vec3};
use crate::model::{BodyPoint, RepeatId, Spring, SpringEnd};

/// The motion of a point.
#[derive(Clone, Copy)]
pub(super) struct PointMotion<S> {
    /// Its position in m, inertial frame.
    pub position: Vec3<S>,
    /// Its velocity in m/s, inertial axes.
    pub velocity: Vec3<S>,
}

impl<S: Scalar> Flatten<S> for PointMotion<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let position = self.position.visit(replace);
        PointMotion { position, velocity: self.velocity.visit(replace) }
    }
}

const OUTWARD: bool = false;
const INWARD: bool = true;

impl<S: Scalar> Springs<'_, S> {
    /// Returns the motion of a point that moves with its part in the same repetition.
    pub(super) fn motion_of(&self, point: &BodyPoint) -> PointMotion<S> {
        let position = self.position_in_part(point);
        let Some(index) = self.link_at(point) else {
            return PointMotion { position, velocity: Vec3::zero() };
        };
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let arm = self.arm(index, position);
        PointMotion {
            position: pose.position + pose.to_inertial * arm,
            velocity: pose.to_inertial * (pose.velocity + link.omega.cross(arm)),
        }
    }

    /// Returns the force on a point in inertial axes as a force on its link; `None` on the ground.
    fn on_link(&self, point: &BodyPoint, force: Vec3<S>) -> Option<PointForce<S>> {
        let link = self.link_at(point)?;
        let to_inertial = Rotation::from_matrix(self.poses[link].to_inertial);
        let arm = self.arm(link, self.position_in_part(point));
        Some(PointForce { link, arm, force: to_inertial.rotate_back(force) })
    }

    /// Returns the end of a spring outside of the repeated part of its end `on`: its end `to`, or the
    /// first one.
    fn outside<'s>(&self, spring: &'s Spring) -> Option<&'s BodyPoint> {
        let chain = self.context.chain;
        let repeat = |point: &BodyPoint| chain.repeat_of_body(point.body);
        match &spring.to {
            SpringEnd::Ground(_) => None,
            SpringEnd::Body(to) => {
                let is_at_rest = self.link_at(to).is_none();
                (repeat(to) != repeat(&spring.on) && !is_at_rest).then_some(to)
            }
            SpringEnd::Previous { first, .. } => Some(first),
        }
    }

    /// Returns the indices of the springs that a repeated part has in every repetition, and that end
    /// outside of the repetition.
    fn leaving(&self, repeat: RepeatId) -> Vec<SpringId> {
        let springs = self.context.chain.springs.enumerate();
        let leaves = |spring: &Spring| {
            self.context.chain.repeat_of_body(spring.on.body) == Some(repeat)
                && self.outside(spring).is_some()
        };
        springs.filter(|(_, spring)| leaves(spring)).map(|(index, _)| index).collect()
    }

    /// Returns the indices of the springs from outside to the last repetition of a part.
    fn entering(&self, repeat: RepeatId) -> Vec<SpringId> {
        let springs = self.context.chain.springs.enumerate();
        let enters = |spring: &Spring| {
            let outside = self.outside(spring);
            outside.is_some_and(|to| self.context.chain.repeat_of_body(to.body) == Some(repeat))
        };
        springs.filter(|(_, spring)| enters(spring)).map(|(index, _)| index).collect()
    }

    /// Returns the end of a spring outside, which exists.
    fn outside_of(&self, index: SpringId) -> &BodyPoint {
        let outside = self.outside(&self.context.chain.springs[index]);
        outside.unwrap_or_else(|| bug!("spring {index:?} has no end outside"))
    }

    /// Returns the point of the previous repetition at which a spring ends.
    fn previous(&self, index: SpringId) -> Option<&BodyPoint> {
        match &self.context.chain.springs[index].to {
            SpringEnd::Previous { point, .. } => Some(point),
            SpringEnd::Ground(_) | SpringEnd::Body(_) => None,
        }
    }

    /// Returns the motions of the ends `to` that are not in the same repetition as the ends `on`, by
    /// springs.
    pub(super) fn far_ends(&self) -> IdVec<SpringId, Option<PointMotion<S>>> {
        let chain = self.context.chain;
        let mut ends: IdVec<SpringId, Option<PointMotion<S>>> = chain
            .springs
            .iter()
            .map(|spring| Some(self.motion_of(self.outside(spring)?)))
            .collect();
        for repeat in chain.repeats.ids() {
            let entering = self.entering(repeat);
            let last = entering.iter().map(|&index| self.motion_of(self.outside_of(index)));
            let unknown = entering
                .iter()
                .map(|_| PointMotion { position: Vec3::zero(), velocity: Vec3::zero() });
            let last: Vec<PointMotion<S>> = last.collect();
            let (last, ()) =
                self.context
                    .tree
                    .through((repeat, OUTWARD), unknown.collect(), |_: Vec<_>| (last, ()));
            entering.into_iter().zip(last).for_each(|(index, motion)| ends[index] = Some(motion));
        }
        for repeat in chain.repeats.ids() {
            let leaving = self.leaving(repeat).into_iter();
            let points: Vec<(SpringId, &BodyPoint)> =
                leaving.filter_map(|index| Some((index, self.previous(index)?))).collect();
            let first = points.iter().filter_map(|&(index, _)| ends[index]).collect();
            let next = points.iter().map(|(_, point)| self.motion_of(point)).collect();
            let (_, here): (Vec<PointMotion<S>>, Vec<PointMotion<S>>) =
                self.context.tree.through((repeat, OUTWARD), first, |here| (next, here));
            points.into_iter().zip(here).for_each(|((index, _), here)| ends[index] = Some(here));
        }
        ends
    }

    /// Returns the forces of the springs that are evaluated in the inertial frame.
    pub(super) fn far_forces(&self) -> Vec<PointForce<S>> {
        let chain = self.context.chain;
        let mut forces = Vec::new();
        // The reactions on the ends outside, inertial axes.
        let mut reactions = IdVec::filled(Vec3::zero(), chain.springs.len());
        for (index, spring, span) in self.all() {
            let SpringSpan::Far(end) = span else { continue };
            let force = self.force(index, &self.far(spring, end));
            forces.extend(self.on_link(&spring.on, force));
            if self.outside(spring).is_some() {
                reactions[index] = -force;
            } else {
                forces.extend(self.on_link(to_point(spring), -force));
            }
        }
        for repeat in chain.repeats.ids() {
            let leaving = self.leaving(repeat);
            let (previous, others): (Vec<SpringId>, Vec<SpringId>) =
                leaving.into_iter().partition(|&index| self.previous(index).is_some());
            self.add_up(repeat, &others, &mut reactions);
            let next: Vec<Vec3<S>> = previous.iter().map(|&index| reactions[index]).collect();
            let none = vec![Vec3::zero(); next.len()];
            let (on_first, here) =
                self.context.tree.through((repeat, INWARD), none, |here: Vec<_>| (next, here));
            for ((&index, on_first), here) in previous.iter().zip(on_first).zip(here) {
                reactions[index] = on_first;
                let point = self.previous(index);
                forces.extend(point.and_then(|point| self.on_link(point, here)));
            }
        }
        for repeat in chain.repeats.ids() {
            let entering = self.entering(repeat);
            let last: Vec<Vec3<S>> = entering.iter().map(|&index| reactions[index]).collect();
            let others = vec![Vec3::zero(); last.len()];
            let (_, here): (_, Vec<_>) =
                self.context.tree.through((repeat, INWARD), last, |here| (others, here));
            entering.iter().zip(here).for_each(|(&index, here)| reactions[index] = here);
        }
        for (index, spring) in chain.springs.enumerate() {
            let outside = self.outside(spring);
            forces.extend(outside.and_then(|point| self.on_link(point, reactions[index])));
        }
        forces
    }

    /// Replaces reactions in any repetition by their sums over all repetitions.
    fn add_up(
        &self,
        repeat: RepeatId,
        springs: &[SpringId],
        reactions: &mut IdVec<SpringId, Vec3<S>>,
    ) {
        let none = vec![Vec3::zero(); springs.len()];
        let (sums, ()) =
            self.context.tree.through((repeat, OUTWARD), none, |sums: Vec<Vec3<S>>| {
                let next = sums.into_iter().zip(springs);
                (next.map(|(sum, &index)| sum + reactions[index]).collect(), ())
            });
        springs.iter().zip(sums).for_each(|(&index, sum)| reactions[index] = sum);
    }
}
