//! Kinematics: how every part is turned, how fast, and what its velocities add to the
//! accelerations, from the ground outwards; and where every part is.
//!
//! # Notation
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `Ω` | [`LinkKinematics::omega`] | angular velocity, work axes |
//! | `m`, `m r_C`, `J` | `mass`, `moment`, `inertia` | of a part about its point, work axes |
//! | `S` | [`HingeKinematics::subspace`] | motion of the child against the parent for each rate |
//! | `b` | [`BiasAcceleration`] | bias acceleration of the point against the parent's |
//!
//! Frames: the *work axes* of a link are those in which its equations are written ([`Axes`]); its
//! *attitude* leads from the axes of its part's frame to them, `to_parent` from them to the
//! parent's.

mod hinge_kinematics;
mod pose;

pub use hinge_kinematics::{BiasAcceleration, HingeKinematics, cross};
pub use pose::{Pose, poses};

use super::strategy::Axes;
use super::sweep::{Flatten, PerLink};
use super::{EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{Mat3, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use crate::model::{Attachment, Chain, Hinge, Link, MovesWith};

/// A part in motion, in its link's work axes unless another frame is named.
#[derive(Clone, Debug)]
pub struct LinkKinematics<S> {
    /// The name of the part's first body.
    pub name: String,
    /// The hinge that it hangs on.
    pub over: HingeKinematics<S>,
    /// Index of the link of the part that it hangs on; none if that is the ground.
    pub parent: Option<LinkId>,
    /// Where its point lies, in its own frame.
    pub point: Vec3<S>,
    /// Its frame's axes to work axes.
    pub attitude: Mat3<S>,
    /// Angular velocity `Ω`.
    pub omega: Vec3<S>,
    /// Mass.
    pub mass: S,
    /// First moment `m r_C` about the point.
    pub moment: Vec3<S>,
    /// Inertia about the point.
    pub inertia: Sym3<S>,
}

/// What the motion of a part means to what hangs on it.
#[derive(Clone, Copy, Debug)]
pub struct PartKinematics<S> {
    /// Axes of the part's frame to work axes.
    pub attitude: Mat3<S>,
    /// Where its point lies, in its own frame.
    pub point: Vec3<S>,
    /// Angular velocity `Ω`, work axes.
    pub omega: Vec3<S>,
}

impl<S: Scalar> PartKinematics<S> {
    /// The ground is at rest.
    pub fn ground() -> Self {
        let (point, omega) = (Vec3::zero(), Vec3::zero());
        PartKinematics { attitude: Mat3::identity(), point, omega }
    }
}

impl<S: Scalar> Flatten<S> for PartKinematics<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let attitude = self.attitude.visit(replace);
        PartKinematics { attitude, omega: self.omega.visit(replace), ..self }
    }
}

impl<S: Scalar> LinkKinematics<S> {
    /// The motion of its part.
    pub fn part(&self) -> PartKinematics<S> {
        PartKinematics { attitude: self.attitude, point: self.point, omega: self.omega }
    }

    /// The inertia that links `a` and `F` at the point.
    pub fn rigid(&self) -> SpatialInertia<S> {
        SpatialInertia::rigid(self.mass, self.moment, self.inertia)
    }

    /// The load that the velocities take: `[m Ω̃Ω̃ r_C; Ω × J Ω]`, of [P, Eq. (20)] `−E_5` and,
    /// about the point, the gyroscopic part of `E_9`.
    pub fn velocity_load(&self) -> Wrench<S> {
        let moment = self.inertia.gyroscopic(self.omega);
        Wrench { force: self.moment.centripetal_by_products(self.omega), moment }
    }

    /// The moment that turning takes about a point at rest: `J Ω̇ + Ω × J Ω`.
    pub fn turning_load(&self, acceleration: Vec3<S>) -> Vec3<S> {
        self.inertia * acceleration + self.inertia.gyroscopic(self.omega)
    }
}

/// All links, from the ground outwards.
pub fn motion<S: Scalar>(
    situation: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> PerLink<LinkKinematics<S>> {
    let (parts, links) = situation.tree.outward(PartKinematics::ground(), |index, parent| {
        let next = link_motion(situation, axes, &situation.layout.links[index], parent);
        let name = &next.over.name;
        trace.section(
            format!("{name}_kinematics"),
            format!("Motion across `{name}`"),
            "[P, Eqs. (1), (13), (36)]",
        );
        trace.matrix(&format!("{name}_turn"), next.over.to_parent.matrix());
        trace.matrix(&format!("{name}_axes"), next.attitude);
        trace.vector(&format!("{name}_omega"), next.omega);
        trace.vector(&format!("{name}_centripetal"), next.over.drift.on_parent);
        trace.motion(&format!("{name}_drift"), next.over.drift.in_hinge);
        trace.rigid_body(&next.name, next.mass, next.moment, next.inertia);
        (PartKinematics { attitude: next.attitude, point: next.point, omega: next.omega }, next)
    });
    let beyond = |(link, part): (LinkKinematics<S>, PartKinematics<S>)| LinkKinematics {
        attitude: part.attitude,
        omega: part.omega,
        ..link
    };
    links.into_iter().zip(parts).map(beyond).collect()
}

/// Crosses the hinge of `link` and comes to its part.
fn link_motion<S: Scalar>(
    situation: &EvalContext<S>,
    axes: Axes,
    link: &Link,
    parent: &PartKinematics<S>,
) -> LinkKinematics<S> {
    let over = cross(situation, axes, (link.hinge, link.reversed), parent);
    let (_, to) = sides(situation.chain, link);
    let (_, point, rotation) = situation.place(to);
    let alignment = situation.chain.hinges[link.hinge].kind.law().alignment(situation.numbers);
    let attitude = over.from_child * (rotation * alignment).transposed();
    let carried = over.to_parent.back(parent.omega);
    let rigid = rigid_part(situation, link, to, point);
    LinkKinematics {
        name: situation.chain.bodies[link.body].name.to_string(),
        parent: link.parent,
        point,
        attitude,
        omega: carried + over.relative.angular,
        mass: rigid.mass,
        moment: attitude * rigid.moment,
        inertia: attitude.rotated(rigid.inertia),
        over,
    }
}

/// Mass, first moment and inertia of a part about a point, in its own axes.
struct RigidInertia<S> {
    mass: S,
    moment: Vec3<S>,
    inertia: Sym3<S>,
}

fn rigid_part<S: Scalar>(
    situation: &EvalContext<S>,
    link: &Link,
    to: &Attachment,
    point: Vec3<S>,
) -> RigidInertia<S> {
    let numbers = situation.numbers;
    let mut all =
        RigidInertia { mass: S::zero(), moment: Vec3::zero(), inertia: Sym3([S::zero(); 6]) };
    for &member in &link.members {
        let body = &situation.chain.bodies[member];
        let (origin, rotation) = situation.frame(member);
        // The point as seen from the member.
        let seen = rotation.transposed() * (point - origin);
        let mass = numbers.scalar(&body.mass);
        let inertia = match to {
            Attachment::Input(input) if *input == member => numbers.inertia_about_input(body),
            _ => numbers.inertia_about(body, seen),
        };
        all.mass = all.mass + mass;
        all.moment = all.moment + rotation * ((numbers.vector(&body.com) - seen) * mass);
        all.inertia = all.inertia + rotation.rotated(inertia);
    }
    all
}

/// The places of a link's hinge: the parent's, then the child's.
pub(super) fn sides<'a>(chain: &'a Chain, link: &Link) -> (&'a Attachment, &'a Attachment) {
    let Hinge { inboard, outboard, .. } = &chain.hinges[link.hinge];
    if link.reversed { (outboard, inboard) } else { (inboard, outboard) }
}

/// The link that a part moves with; none on the ground.
pub(super) fn link_of(part: MovesWith) -> Option<LinkId> {
    match part {
        MovesWith::Ground => None,
        MovesWith::Link(link) => Some(link),
    }
}
