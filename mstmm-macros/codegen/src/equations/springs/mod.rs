//! Springs with dampers and actuators, from a body to the ground or to another body.
//!
//! | symbol | meaning |
//! |---|---|
//! | `r`, `l` | vector from the end `to` to the end `on`, and its length |
//! | `k`, `c`, `l₀` | stiffness, damping, length without load |
//! | `f` | force of the actuator, which pushes the ends apart |
//! | `k (l − l₀) + c l̇ − f` | tension, which pulls the ends together |
//!
//! A spring with one moving end is evaluated in the work axes of the link there. A spring between two
//! links is evaluated in the axes of their last common link, relative to which `l` and `l̇` are the same,
//! or in inertial axes if many hinges or the boundary of a repeated part are between them.

mod far_ends;
mod report;

pub use report::{SpringReport, spring_report};

use super::EvalContext;
use super::kinematics::{LinkKinematics, Pose, link_of};
use super::strategy::MAX_SPRING_PATH;
use super::sweep::PerLink;
use crate::ids::{IdVec, LinkId, SpringId};
use crate::math::{Rotation, Scalar, Vec3, Wrench};
use crate::model::{BodyPoint, Spring, SpringEnd};
use far_ends::PointMotion;

/// The springs of a chain in a state.
pub struct Springs<'a, S> {
    context: &'a EvalContext<'a, S>,
    links: &'a PerLink<LinkKinematics<S>>,
    poses: &'a PerLink<Pose<S>>,
    /// What each spring acts on.
    spans: IdVec<SpringId, SpringSpan<S>>,
    /// Whether actuators act.
    actuated: bool,
}

/// What a spring acts on.
enum SpringSpan<S> {
    /// Both ends are at rest.
    AtRest,
    /// One end is on a link; it is the end `to` if `reversed`.
    OneLink { link: LinkId, reversed: bool },
    /// The ends are on two links. The paths lead from the last common link, `None` for the ground, to
    /// the links of `on` and `to`.
    TwoLinks { common: Option<LinkId>, paths: [Vec<LinkId>; 2] },
    /// The ends are evaluated in the inertial frame: the end `on`, and the motion of the end `to`.
    Far(PointMotion<S>),
}

/// The motion of one end of a spring relative to the other.
struct SpringMotion<S> {
    /// The vector `r` in m, negated for a reversed spring.
    displacement: Vec3<S>,
    /// The relative velocity in m/s, in axes that may rotate: only its component along `r` counts.
    velocity: Vec3<S>,
}

/// A force on a link.
#[derive(Clone, Copy)]
struct PointForce<S> {
    link: LinkId,
    /// From the link's point to the point of application, work axes.
    arm: Vec3<S>,
    /// The force in N, work axes.
    force: Vec3<S>,
}

impl<'a, S: Scalar> Springs<'a, S> {
    /// Returns the springs of a chain whose links have these kinematics and poses.
    pub fn new(
        context: &'a EvalContext<'a, S>,
        links: &'a PerLink<LinkKinematics<S>>,
        poses: &'a PerLink<Pose<S>>,
    ) -> Self {
        let mut springs = Springs { context, links, poses, spans: IdVec::new(), actuated: true };
        let far_ends = springs.far_ends().into_iter();
        springs.spans = context
            .chain
            .springs
            .iter()
            .zip(far_ends)
            .map(|(spring, end)| end.map_or_else(|| springs.span(spring), SpringSpan::Far))
            .collect();
        springs
    }

    /// Returns the springs and dampers without their actuators.
    pub fn passive(self) -> Self {
        Springs { actuated: false, ..self }
    }

    /// Adds the wrenches of all springs to those of the links, about their points, in work axes.
    pub fn add_to(&self, wrenches: &mut PerLink<Wrench<S>>) {
        let mut add = |PointForce { link, arm, force }: PointForce<S>| {
            let wrench = Wrench { force, moment: Vec3::zero() };
            wrenches[link] = wrenches[link] + wrench.shifted_from(arm);
        };
        for (id, spring, span) in self.all() {
            match span {
                SpringSpan::AtRest | SpringSpan::Far(_) => {}
                &SpringSpan::OneLink { link, reversed } => {
                    let (arm, _, motion) = self.on_one_link(spring, link, reversed);
                    add(PointForce { link, arm, force: self.force(id, &motion) });
                }
                SpringSpan::TwoLinks { paths, .. } => {
                    self.forces_on_two_links(id, paths).into_iter().for_each(&mut add);
                }
            }
        }
        self.far_forces().into_iter().for_each(add);
    }

    /// Returns the energy in J of the springs that this link accounts for: the link of the moving end, or
    /// that of the end `on` if both ends move; `None` for those at rest.
    pub fn energy(&self, on: Option<LinkId>) -> S {
        let mut energy = S::zero();
        for (_, spring, span) in self.all() {
            let link = match span {
                SpringSpan::OneLink { link, .. } => Some(*link),
                _ => self.link_at(&spring.on),
            };
            if link != on {
                continue;
            }
            let values = self.context.values;
            let displacement = self.inertial_displacement(spring, span);
            let stretch = if spring.length.is_zero() {
                displacement.dot(displacement)
            } else {
                let elongation = length(displacement) - values.scalar(&spring.length);
                elongation * elongation
            };
            energy = energy + values.scalar(&spring.stiffness) * stretch * S::number(0.5);
        }
        energy
    }

    /// Returns the vector between the ends of a spring in inertial axes, or in others if it is shorter
    /// to compute.
    fn inertial_displacement(&self, spring: &Spring, span: &SpringSpan<S>) -> Vec3<S> {
        match span {
            SpringSpan::AtRest => self.at_rest(spring).displacement,
            SpringSpan::OneLink { link, reversed } => {
                let [moving, fixed] = self.ends(spring, *reversed);
                self.inertial_position(*link, moving) - fixed
            }
            SpringSpan::TwoLinks { paths, .. } => self.on_two_links(spring, paths).displacement,
            SpringSpan::Far(end) => self.far(spring, end).displacement,
        }
    }

    /// Iterates over all springs with what they act on.
    fn all(&self) -> impl Iterator<Item = (SpringId, &'a Spring, &SpringSpan<S>)> {
        let springs = self.context.chain.springs.enumerate();
        springs.zip(&self.spans).map(|((id, spring), span)| (id, spring, span))
    }

    /// Returns what a spring acts on whose ends are in the same repetition.
    fn span(&self, spring: &Spring) -> SpringSpan<S> {
        let to = match &spring.to {
            SpringEnd::Ground(_) => None,
            SpringEnd::Body(point) | SpringEnd::Previous { point, .. } => self.link_at(point),
        };
        match (self.link_at(&spring.on), to) {
            (None, None) => SpringSpan::AtRest,
            (Some(link), None) => SpringSpan::OneLink { link, reversed: false },
            (None, Some(link)) => SpringSpan::OneLink { link, reversed: true },
            (Some(on), Some(to)) => match self.paths(on, to) {
                Some((common, paths)) => SpringSpan::TwoLinks { common, paths },
                None => SpringSpan::Far(self.motion_of(to_point(spring))),
            },
        }
    }

    /// Returns the last common link of two links and the paths from there, if these are short and cross
    /// no boundary of a repeated part.
    fn paths(&self, on: LinkId, to: LinkId) -> Option<(Option<LinkId>, [Vec<LinkId>; 2])> {
        let tree = &self.context.tree;
        let [mut on, mut to] = [on, to].map(|link| tree.path_to(link));
        let common = on.iter().zip(&to).take_while(|(a, b)| a == b).count();
        let last = common.checked_sub(1).map(|index| on[index]);
        let paths = [on.split_off(common), to.split_off(common)];
        let crosses = paths.iter().flatten().any(|&link| tree.is_boundary(link));
        let hinges: usize = paths.iter().map(Vec::len).sum();
        (!crosses && hinges <= MAX_SPRING_PATH).then_some((last, paths))
    }

    /// Returns the link that a point moves with; `None` for the ground.
    fn link_at(&self, point: &BodyPoint) -> Option<LinkId> {
        link_of(self.context.layout.parts[point.body])
    }

    /// Returns the position of a point in the frame of its part.
    fn position_in_part(&self, point: &BodyPoint) -> Vec3<S> {
        let (origin, rotation) = self.context.frame(point.body);
        origin + rotation * self.context.values.vector(&point.at)
    }

    /// Returns the ends `on` and `to` in the frames of their parts, exchanged if `reversed`.
    fn ends(&self, spring: &Spring, reversed: bool) -> [Vec3<S>; 2] {
        let on = self.position_in_part(&spring.on);
        let to = match &spring.to {
            SpringEnd::Ground(point) => self.context.values.vector(point),
            SpringEnd::Body(point) | SpringEnd::Previous { point, .. } => {
                self.position_in_part(point)
            }
        };
        if reversed { [to, on] } else { [on, to] }
    }

    /// Returns the vector from a link's point to another of its points, work axes.
    fn arm(&self, link: LinkId, point: Vec3<S>) -> Vec3<S> {
        let link = &self.links[link];
        link.part_to_work * (point - link.point)
    }

    /// Returns the position of a link's point in the inertial frame.
    fn inertial_position(&self, link: LinkId, point: Vec3<S>) -> Vec3<S> {
        let pose = &self.poses[link];
        pose.position + pose.to_inertial * self.arm(link, point)
    }

    fn at_rest(&self, spring: &Spring) -> SpringMotion<S> {
        let [on, to] = self.ends(spring, false);
        SpringMotion { displacement: on - to, velocity: Vec3::zero() }
    }

    /// Returns the arm of the moving end, the vector between the ends in the inertial frame, and the
    /// motion in work axes.
    fn on_one_link(
        &self,
        spring: &Spring,
        index: LinkId,
        reversed: bool,
    ) -> (Vec3<S>, Vec3<S>, SpringMotion<S>) {
        let (link, pose) = (&self.links[index], &self.poses[index]);
        let [moving, fixed] = self.ends(spring, reversed);
        let arm = self.arm(index, moving);
        let inertial = pose.position + pose.to_inertial * arm - fixed;
        let displacement = Rotation::from_matrix(pose.to_inertial).rotate_back(inertial);
        let velocity = pose.velocity + link.omega.cross(arm);
        (arm, inertial, SpringMotion { displacement, velocity })
    }

    /// Returns the motion of a spring between two links, in the work axes of their last common link.
    fn on_two_links(&self, spring: &Spring, paths: &[Vec<LinkId>; 2]) -> SpringMotion<S> {
        let [on, to] = self.ends_on_two_links(spring, paths).map(|(arm, path)| {
            let start = SpringMotion { displacement: arm, velocity: Vec3::zero() };
            self.context.tree.carry_inward(path, start, |link, it| it.across(&self.links[link]))
        });
        SpringMotion {
            displacement: on.displacement - to.displacement,
            velocity: on.velocity - to.velocity,
        }
    }

    /// Returns the arms of the ends `on` and `to`, with the paths to them.
    fn ends_on_two_links<'p>(
        &self,
        spring: &Spring,
        [on, to]: &'p [Vec<LinkId>; 2],
    ) -> [(Vec3<S>, &'p [LinkId]); 2] {
        let arm = |point: &BodyPoint| {
            let position = self.position_in_part(point);
            self.link_at(point).map_or(position, |link| self.arm(link, position))
        };
        [(arm(&spring.on), on), (arm(to_point(spring)), to)]
    }

    /// Returns the forces on both links; none if both ends are on the same link.
    fn forces_on_two_links(&self, id: SpringId, paths: &[Vec<LinkId>; 2]) -> Vec<PointForce<S>> {
        if paths.iter().all(Vec::is_empty) {
            return Vec::new();
        }
        let spring = &self.context.chain.springs[id];
        let force = self.force(id, &self.on_two_links(spring, paths));
        let [on, to] = self.ends_on_two_links(spring, paths);
        let points = [(&spring.on, on, force), (to_point(spring), to, -force)];
        let on_link = |(point, (arm, path), force): (&BodyPoint, (Vec3<S>, &[LinkId]), Vec3<S>)| {
            let to_child =
                |link: LinkId, force| self.links[link].hinge.to_parent.rotate_back(force);
            let force = self.context.tree.carry_outward(path, force, to_child);
            Some(PointForce { link: self.link_at(point)?, arm, force })
        };
        points.into_iter().filter_map(on_link).collect()
    }

    /// Returns the motion of a spring in inertial axes, from the motion of its end `to`.
    fn far(&self, spring: &Spring, to: &PointMotion<S>) -> SpringMotion<S> {
        let on = self.motion_of(&spring.on);
        SpringMotion {
            displacement: on.position - to.position,
            velocity: on.velocity - to.velocity,
        }
    }

    /// Returns `−(k (l − l₀) + c l̇ − f) r / l`: the force on the end `on`, for a reversed spring on the
    /// end `to`.
    fn force(&self, id: SpringId, motion: &SpringMotion<S>) -> Vec3<S> {
        -(motion.displacement * self.tension_per_length(id, motion))
    }

    /// Returns the tension divided by the length. Its product with `r` is zero if the length is zero.
    fn tension_per_length(&self, id: SpringId, motion: &SpringMotion<S>) -> S {
        let (spring, values) = (&self.context.chain.springs[id], self.context.values);
        let &SpringMotion { displacement, velocity } = motion;
        let [stiffness, damping, length] =
            [&spring.stiffness, &spring.damping, &spring.length].map(|value| values.scalar(value));
        let inverse = inverse_length(displacement);
        let damped = damping * displacement.dot(velocity) * (inverse * inverse);
        let tension = stiffness - stiffness * length * inverse + damped;
        match self.actuator_force(id) {
            None => tension,
            Some(force) => tension - force * inverse,
        }
    }

    /// Returns the force `f` of an actuator that acts.
    fn actuator_force(&self, id: SpringId) -> Option<S> {
        self.actuated.then(|| self.context.spring_force(id)).flatten()
    }
}

impl<S: Scalar> SpringMotion<S> {
    /// Returns the motion of a point relative to a link's parent, from its motion relative to the link.
    /// Positions are those from the points of link and parent.
    fn across(self, link: &LinkKinematics<S>) -> Self {
        let hinge = &link.hinge;
        let relative = hinge.relative_velocity;
        let velocity = self.velocity + relative.linear + relative.angular.cross(self.displacement);
        SpringMotion {
            displacement: hinge.arm + hinge.to_parent.rotate(self.displacement),
            velocity: hinge.to_parent.rotate(velocity),
        }
    }
}

/// Returns the end `to` of a spring between two bodies.
fn to_point(spring: &Spring) -> &BodyPoint {
    match &spring.to {
        SpringEnd::Ground(_) => bug!("spring `{}` ends on the ground", spring.path),
        SpringEnd::Body(point) | SpringEnd::Previous { point, .. } => point,
    }
}

/// Returns `|r|`.
fn length<S: Scalar>(displacement: Vec3<S>) -> S {
    displacement.dot(displacement) * inverse_length(displacement)
}

/// Returns `1 / |r|`, which is finite for a length of zero.
fn inverse_length<S: Scalar>(displacement: Vec3<S>) -> S {
    displacement.dot(displacement).divisible_root().recip()
}
