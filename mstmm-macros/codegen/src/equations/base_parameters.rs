//! Base parameters: inertia that is transferred from a link to its parent without changing the
//! motion.
//!
//! A thin rod along the axis of a pin moves as the parent does. Its mass `m`, its first moment `m
//! z_C` and its moment of inertia across the axis can therefore be the parent's. The link's own
//! inertia then has zeros in their place, and the parent's inertia stays constant. `Iᴬ` of the link
//! lacks what was transferred; inboard of its hinge `Iᴬ` is complete again.
//!
//! All quantities of a link belong to its point, in its work axes.

use super::kinematics::{LinkKinematics, RigidInertia};
use super::strategy;
use super::sweep::{Flatten, PerLink};
use super::{Axes, EvalContext, Trace, kinematics};
use crate::ids::LinkId;
use crate::math::{Mat3, Scalar, SpatialInertia, Sym3, Vec3};
use crate::model::SolutionMethod;

/// The inertia of a link before the change to base parameters.
#[derive(Clone, Copy, Debug)]
pub struct OriginalInertia<S> {
    /// The mass that was transferred to the parent.
    pub transferred_mass: S,
    /// Mass, and trace of the inertia, before the transfer: the scales of pivots.
    pub scales: (S, S),
}

/// Returns the kinematics of all links with base parameters, if functions other than forward dynamics use
/// them.
pub fn base_kinematics<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> PerLink<LinkKinematics<S>> {
    let mut links = kinematics(context, axes, trace);
    let is_closed = !context.layout.loop_hinges.is_empty();
    if strategy::uses_base_parameters(SolutionMethod::Riccati, axes, is_closed) {
        to_base_parameters(context, &mut links, trace);
    }
    links
}

/// Transfers inertia from the free ends to the ground, over every hinge that rotates about one axis
/// except at the boundaries of repeated parts, if this saves operations
/// ([`strategy::operation_count`]).
pub fn to_base_parameters<S: Scalar>(
    context: &EvalContext<S>,
    links: &mut PerLink<LinkKinematics<S>>,
    trace: &mut Trace<S>,
) -> PerLink<OriginalInertia<S>> {
    let scales = |link: &LinkKinematics<S>| (link.mass, link.inertia.trace());
    let scales: Vec<(S, S)> = links.iter().map(scales).collect();
    let inertias: PerLink<RigidInertia<S>> =
        links.iter().map(LinkKinematics::rigid_inertia).collect();
    let step = |index: LinkId, own: RigidInertia<S>, of_parent: &mut RigidInertia<S>| {
        let link = &links[index];
        let stays = context.layout.is_at_repeat_boundary(index) || link.parent.is_none();
        if stays || !link.hinge.is_concentric() {
            return (own, S::zero());
        }
        let ((left, with_rod), given) = cheapest(link, (own, *of_parent));
        *of_parent = with_rod;
        (left, given)
    };
    let ground = RigidInertia::zero();
    let (left, _) = context.tree.inward(inertias, ground, step);
    let (left, masses): (Vec<RigidInertia<S>>, Vec<S>) = left.into_iter().unzip();
    trace.section("base", "Base parameters", "");
    links.iter_mut().zip(left).for_each(|(link, rigid)| {
        rigid.write_to(link);
        trace.rigid_body(
            &format!("{}_base", link.name),
            link.mass,
            link.first_moment,
            link.inertia,
        );
    });
    let original = |(transferred_mass, scales)| OriginalInertia { transferred_mass, scales };
    masses.into_iter().zip(scales).map(original).collect()
}

/// Returns the inertias of a link and its parent that need the fewest operations, and the
/// transferred mass.
fn cheapest<S: Scalar>(
    link: &LinkKinematics<S>,
    (own, of_parent): (RigidInertia<S>, RigidInertia<S>),
) -> ((RigidInertia<S>, RigidInertia<S>), S) {
    let operations = |(own, of_parent): &(RigidInertia<S>, RigidInertia<S>)| {
        own.operation_count() + of_parent.operation_count()
    };
    let (mut best, mut given) = ((own, of_parent), S::zero());
    for rod in transferable(link, own) {
        let to_parent = rod.rotated(link.hinge.to_parent.matrix()).shifted_from(link.hinge.arm);
        let pair = (own.minus(rod), of_parent.plus(to_parent));
        if operations(&pair) < operations(&best) {
            (best, given) = (pair, rod.mass);
        }
    }
    (best, given)
}

/// Returns what a link can transfer to its parent, if the link rotates about one of its axes: a rod
/// along this axis, without and with a moment of inertia.
fn transferable<S: Scalar>(link: &LinkKinematics<S>, own: RigidInertia<S>) -> Vec<RigidInertia<S>> {
    let Some(axis) = rotation_axis(link) else { return Vec::new() };
    let first_moment = Vec3::from_fn(|k| if k == axis { own.first_moment[k] } else { S::zero() });
    let across = own.inertia.at((axis + 2) % 3, (axis + 2) % 3);
    let is_across = |i: usize, j: usize| i == j && i != axis;
    let inertia = Sym3::from_fn(|i, j| if is_across(i, j) { across } else { S::zero() });
    let without = RigidInertia { mass: own.mass, first_moment, inertia: Sym3([S::zero(); 6]) };
    vec![without, RigidInertia { inertia, ..without }]
}

/// Returns the axis that a link's hinge rotates about, if it is a coordinate axis of the link.
fn rotation_axis<S: Scalar>(link: &LinkKinematics<S>) -> Option<usize> {
    let [motion] = &link.hinge.subspace[..] else { return None };
    let present = |&k: &usize| !motion.angular[k].vanishes();
    let axes: Vec<usize> = (0..3).filter(present).collect();
    let [axis] = axes[..] else { return None };
    Some(axis)
}

impl<S: Scalar> RigidInertia<S> {
    pub(super) fn write_to(self, link: &mut LinkKinematics<S>) {
        (link.mass, link.first_moment, link.inertia) = (self.mass, self.first_moment, self.inertia);
    }

    pub(super) fn plus(self, other: Self) -> Self {
        RigidInertia {
            mass: self.mass + other.mass,
            first_moment: self.first_moment + other.first_moment,
            inertia: self.inertia + other.inertia,
        }
    }

    fn minus(self, other: Self) -> Self {
        RigidInertia {
            mass: self.mass - other.mass,
            first_moment: self.first_moment - other.first_moment,
            inertia: self.inertia - other.inertia,
        }
    }

    /// Returns a rod's inertia in the axes that `rotation` leads to. It is constant, since
    /// `rotation` about the rod does not change the rod.
    fn rotated(self, rotation: Mat3<S>) -> Self {
        let Some(axis) = (0..3).find(|&k| self.inertia.at(k, k).vanishes()) else {
            bug!("a rod has a moment of inertia about its axis")
        };
        let across = self.inertia.at((axis + 2) % 3, (axis + 2) % 3);
        let direction = Vec3::from_fn(|k| rotation[k][axis]);
        let inertia = Sym3::from_fn(|i, j| {
            let even = if i == j { across } else { S::zero() };
            even - across * (direction[i] * direction[j])
        });
        RigidInertia { mass: self.mass, first_moment: rotation * self.first_moment, inertia }
    }

    /// Returns the inertia about the origin of a body whose point is at `arm`.
    pub(super) fn shifted_from(self, arm: Vec3<S>) -> Self {
        let shifted =
            SpatialInertia::rigid(self.mass, self.first_moment, self.inertia).shifted_from(arm);
        RigidInertia {
            first_moment: self.first_moment + arm * self.mass,
            inertia: shifted.angular,
            ..self
        }
    }

    fn operation_count(&self) -> usize {
        strategy::operation_count(self.mass, self.first_moment, self.inertia)
    }
}

/// No values cross a boundary.
impl<S: Scalar> Flatten<S> for RigidInertia<S> {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        self
    }
}
