//! From the ground outwards: how every body is turned, how fast, and what its velocities add to
//! the accelerations.

use super::hinge::{self, Freedom, WorkAxes};
use super::{Situation, Trace};
use crate::math::{Mat3, Motion, Rotation, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use crate::model::{Chain, Hinge, HingeKind, Link, Place};

/// The axes in which the equations of the links are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Axes fixed in each body, aligned with the hinge that it hangs on: inertias stay constant,
    /// what is transferred turns at every hinge.
    Body,
    /// The inertial axes: nothing turns at a hinge, the inertias do.
    Inertial,
}

/// A body in motion, in its link's work axes unless another frame is named.
#[derive(Clone, Debug)]
pub struct LinkMotion<S> {
    /// The name of the hinge.
    pub name: String,
    /// Index of the link of the body that it hangs on; none if that is the ground.
    pub parent: Option<usize>,
    /// Body axes to work axes.
    pub attitude: Mat3<S>,
    /// Work axes to those of the parent.
    pub to_parent: Rotation<S>,
    /// From the parent's point to this link's point, parent's work axes.
    pub arm: Vec3<S>,
    /// The part of `arm` that is the hinge's: from its parent's side to the point.
    pub offset: Vec3<S>,
    /// What the hinge leaves free.
    pub freedom: Freedom<S>,
    /// Angular velocity `Ω`.
    pub omega: Vec3<S>,
    /// Motion against the parent, at the point.
    pub relative: Motion<S>,
    /// What the velocities add to the acceleration of the point on the way from the parent's.
    pub drift: Motion<S>,
    /// Mass.
    pub mass: S,
    /// Centre of mass from the point.
    pub com: Vec3<S>,
    /// Inertia about the point.
    pub inertia: Sym3<S>,
}

impl<S: Scalar> LinkMotion<S> {
    /// The inertia that links `a` and `F` at the point.
    pub fn rigid(&self) -> SpatialInertia<S> {
        SpatialInertia::rigid(self.mass, self.com, self.inertia)
    }

    /// The load that the velocities take: `[m Ω̃Ω̃ r_C; Ω × J Ω]`, of [P, Eq. (20)] `−E_5` and, about
    /// the point, the gyroscopic part of `E_9`.
    pub fn velocity_load(&self) -> Wrench<S> {
        Wrench {
            force: (self.com * self.mass).centripetal(self.omega),
            moment: self.omega.cross(self.inertia * self.omega),
        }
    }

    /// The acceleration of the point, but for the hinge's own `q̈`, from that of the parent's point.
    pub fn carried(&self, parent: Motion<S>) -> Motion<S> {
        parent.carried_to(self.arm).turned_back(&self.to_parent) + self.drift
    }
}

/// All links, from the ground outwards.
pub fn motion<S: Scalar>(
    situation: &Situation<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<LinkMotion<S>> {
    let mut links: Vec<LinkMotion<S>> = Vec::new();
    for link in &situation.layout.links {
        let hinge = &situation.chain.hinges[link.hinge];
        let next = cross(situation, axes, link, link.parent.map(|parent| &links[parent]));
        trace.section(format!("Motion across `{}`", hinge.name), "[P, Eqs. (1), (13), (36)]");
        trace.matrix(&format!("{}_turn", hinge.name), next.to_parent.matrix());
        trace.matrix(&format!("{}_axes", hinge.name), next.attitude);
        trace.vector(&format!("{}_omega", hinge.name), next.omega);
        trace.motion(&format!("{}_drift", hinge.name), next.drift);
        links.push(next);
    }
    links
}

/// Crosses the hinge of `link` and comes to its body.
fn cross<S: Scalar>(
    situation: &Situation<S>,
    axes: Axes,
    link: &Link,
    parent: Option<&LinkMotion<S>>,
) -> LinkMotion<S> {
    let Situation { chain, layout, numbers, q, v, .. } = *situation;
    let hinge = &chain.hinges[link.hinge];
    let body = &chain.bodies[link.body];
    let (from, to) = sides(chain, link);
    let (from_origin, from_rotation) = numbers.place(chain, from);
    let (to_origin, to_rotation) = numbers.place(chain, to);
    let from_point = link.parent.map_or(Vec3::zero(), |parent| point_of(situation, parent));

    let crossing = crossing(situation, link, &hinge.kind, &q[layout.q[link.hinge].clone()]);
    let alignment = hinge::alignment(&hinge.kind, numbers);
    let parent_attitude = parent.map_or(Mat3::identity(), |parent| parent.attitude);
    let from_parent_side = parent_attitude * (from_rotation * alignment);
    let (to_parent, work) = match axes {
        Axes::Body => (
            crossing.mounted_on(from_parent_side),
            WorkAxes {
                aligned: true,
                from_parent: crossing.rotation.transposed(),
                from_child: Mat3::identity(),
            },
        ),
        Axes::Inertial => (
            Rotation::general(Mat3::identity()),
            WorkAxes {
                aligned: false,
                from_parent: from_parent_side,
                from_child: from_parent_side * crossing.rotation,
            },
        ),
    };
    let attitude = work.from_child * (to_rotation * alignment).transposed();
    let offset = from_parent_side * crossing.offset;
    let arm = parent_attitude * (from_origin - from_point) + offset;

    let freedom = hinge::freedom(&hinge.kind, numbers, work, link.reversed);
    let relative = freedom.motion(&v[layout.v[link.hinge].clone()]);
    let parent_omega = parent.map_or(Vec3::zero(), |parent| parent.omega);
    let carried_omega = to_parent.back(parent_omega);
    let (point_inertia, com) =
        (numbers.inertia_about(body, to, to_origin), numbers.vector(&body.com) - to_origin);
    let mass = numbers.scalar(&body.mass);
    LinkMotion {
        name: hinge.name.to_string(),
        parent: link.parent,
        attitude,
        to_parent,
        arm,
        offset,
        omega: carried_omega + relative.angular,
        relative,
        drift: drift(arm.centripetal(parent_omega), &to_parent, carried_omega, relative),
        freedom,
        mass,
        com: attitude * com,
        inertia: attitude.congruence(point_inertia),
    }
}

/// `[Ω_p × (Ω_p × arm) + 2 Ω_p × v_rel; Ω_p × ω_rel]`, as in [P, Eqs. (13), (36)].
fn drift<S: Scalar>(
    centripetal: Vec3<S>,
    to_parent: &Rotation<S>,
    parent_omega: Vec3<S>,
    relative: Motion<S>,
) -> Motion<S> {
    let coriolis = parent_omega.cross(relative.linear) * S::number(2.0);
    Motion {
        linear: to_parent.back(centripetal) + coriolis,
        angular: parent_omega.cross(relative.angular),
    }
}

/// The places of a link's hinge: the parent's, then the child's.
pub(super) fn sides<'a>(chain: &'a Chain, link: &Link) -> (&'a Place, &'a Place) {
    let Hinge { inboard, outboard, .. } = &chain.hinges[link.hinge];
    if link.reversed { (outboard, inboard) } else { (inboard, outboard) }
}

fn crossing<S: Scalar>(
    situation: &Situation<S>,
    link: &Link,
    kind: &HingeKind,
    q: &[S],
) -> hinge::Crossing<S> {
    let outwards = hinge::crossing(kind, situation.numbers, q);
    if link.reversed { outwards.reversed() } else { outwards }
}

/// Where, in its body's frame, the point of the link at `index` lies.
pub(super) fn point_of<S: Scalar>(situation: &Situation<S>, index: usize) -> Vec3<S> {
    let (_, to) = sides(situation.chain, &situation.layout.links[index]);
    situation.numbers.place(situation.chain, to).0
}
