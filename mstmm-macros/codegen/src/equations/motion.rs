//! From the ground outwards: how every part is turned, how fast, and what its velocities add to
//! the accelerations.

use super::hinge::{self, Freedom, Passives, WorkAxes};
use super::sweep::{Flatten, PerLink};
use super::{Situation, Trace};
use crate::math::{Mat3, Motion, Rotation, Scalar, SpatialInertia, Sym3, Vec3, Wrench};
use crate::model::{Chain, Hinge, HingeId, Link, LinkId, Part, Place};

/// The axes in which the equations of the links are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// Axes fixed in each part, aligned with the hinge that it hangs on: inertias stay constant,
    /// what is transferred turns at every hinge.
    Body,
    /// The inertial axes: nothing turns at a hinge, the inertias do.
    Inertial,
}

/// A hinge that was crossed, in the work axes of its child unless another frame is named.
#[derive(Clone, Debug)]
pub struct Crossed<S> {
    /// The hinge.
    pub hinge: HingeId,
    /// Its name.
    pub name: String,
    /// Work axes to those of the parent.
    pub to_parent: Rotation<S>,
    /// From the parent's point to the child's, parent's work axes.
    pub arm: Vec3<S>,
    /// The part of `arm` that is the hinge's: from its parent's side to the point.
    pub offset: Vec3<S>,
    /// `S`, the motion of the child against the parent for each rate.
    pub subspace: Vec<Motion<S>>,
    /// The same in aligned child axes of the hinge, where it has most zeros.
    pub aligned: Vec<Motion<S>>,
    /// What the hinge leaves free.
    pub freedom: Freedom<S>,
    /// What acts along its free directions of itself.
    pub passives: Passives<S>,
    /// Efforts of motor and passive elements, one for each rate.
    pub efforts: Vec<S>,
    /// Angular velocity of the parent, in the parent's work axes.
    pub parent_omega: Vec3<S>,
    /// Motion against the parent, at the point.
    pub relative: Motion<S>,
    /// What joins the acceleration of the point on the way from the parent's.
    pub drift: Drift<S>,
    /// Aligned child axes of the hinge to work axes.
    pub from_child: Mat3<S>,
}

/// What velocities and prescribed accelerations add to the acceleration of a point on the way from its
/// parent's [P, Eqs. (13), (36)], each part in the axes in which it has most zeros.
#[derive(Clone, Copy, Debug)]
pub struct Drift<S> {
    /// Of the way on the parent to the hinge, `Ω_p × (Ω_p × arm)`; parent's work axes.
    pub on_parent: Vec3<S>,
    /// Of the hinge; work axes of its child.
    pub in_hinge: Motion<S>,
}

impl<S: Scalar> Drift<S> {
    /// Nothing joins.
    pub fn none() -> Self {
        Drift { on_parent: Vec3::zero(), in_hinge: Motion::zero() }
    }

    /// Power of a wrench on it, in the hinge's work axes, which `to_parent` leads to those of the
    /// parent.
    pub fn power(self, to_parent: &Rotation<S>, wrench: Wrench<S>) -> S {
        self.in_hinge.power(wrench) + self.on_parent.dot(to_parent.of_vector(wrench.force))
    }
}

/// A part in motion, in its link's work axes unless another frame is named.
#[derive(Clone, Debug)]
pub struct LinkMotion<S> {
    /// The name of the part's first body.
    pub name: String,
    /// The hinge that it hangs on.
    pub over: Crossed<S>,
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
pub struct PartMotion<S> {
    /// Axes of the part's frame to work axes.
    pub attitude: Mat3<S>,
    /// Where its point lies, in its own frame.
    pub point: Vec3<S>,
    /// Angular velocity `Ω`, work axes.
    pub omega: Vec3<S>,
}

impl<S: Scalar> PartMotion<S> {
    /// The ground is at rest.
    pub fn ground() -> Self {
        let (point, omega) = (Vec3::zero(), Vec3::zero());
        PartMotion { attitude: Mat3::identity(), point, omega }
    }
}

impl<S: Scalar> Flatten<S> for PartMotion<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let attitude = self.attitude.visit(replace);
        PartMotion { attitude, omega: self.omega.visit(replace), ..self }
    }
}

impl<S: Scalar> LinkMotion<S> {
    /// The motion of its part.
    pub fn part(&self) -> PartMotion<S> {
        PartMotion { attitude: self.attitude, point: self.point, omega: self.omega }
    }

    /// The inertia that links `a` and `F` at the point.
    pub fn rigid(&self) -> SpatialInertia<S> {
        SpatialInertia::rigid(self.mass, self.moment, self.inertia)
    }

    /// The load that the velocities take: `[m Ω̃Ω̃ r_C; Ω × J Ω]`, of [P, Eq. (20)] `−E_5` and, about
    /// the point, the gyroscopic part of `E_9`.
    pub fn velocity_load(&self) -> Wrench<S> {
        let moment = self.inertia.gyroscopic(self.omega);
        Wrench { force: self.moment.centripetal_by_products(self.omega), moment }
    }

    /// The moment that turning takes about a point at rest: `J Ω̇ + Ω × J Ω`.
    pub fn turning_load(&self, acceleration: Vec3<S>) -> Vec3<S> {
        self.inertia * acceleration + self.inertia.gyroscopic(self.omega)
    }
}

impl<S: Scalar> Crossed<S> {
    /// The part of the parent's motion, or acceleration, that comes over to the point.
    pub fn carried(&self, parent: Motion<S>) -> Motion<S> {
        parent.carried_to(self.arm).turned_back(&self.to_parent)
    }

    /// The same with what joins on the way.
    pub fn carried_with(&self, parent: Motion<S>, drift: Drift<S>) -> Motion<S> {
        let Motion { linear, angular } = parent.carried_to(self.arm);
        let at_hinge = Motion { linear: linear + drift.on_parent, angular };
        at_hinge.turned_back(&self.to_parent) + drift.in_hinge
    }

    /// Whether its sides are one point in all that the hinge does.
    pub fn keeps_the_point(&self) -> bool {
        let none = |vector: Vec3<S>| vector.0.iter().all(|entry| entry.vanishes());
        let shifts = self.subspace.iter().any(|motion| !none(motion.linear));
        !shifts && none(self.offset) && none(self.drift.in_hinge.linear)
    }

    /// A wrench on the child at the point, as one at the parent's point in its work axes.
    pub fn returned(&self, wrench: Wrench<S>) -> Wrench<S> {
        wrench.turned(&self.to_parent).moved_from(self.arm)
    }
}

/// All links, from the ground outwards.
pub fn motion<S: Scalar>(
    situation: &Situation<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> PerLink<LinkMotion<S>> {
    let (parts, links) = situation.tree.outward(PartMotion::ground(), |index, parent| {
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
        (PartMotion { attitude: next.attitude, point: next.point, omega: next.omega }, next)
    });
    let beyond = |(link, part): (LinkMotion<S>, PartMotion<S>)| LinkMotion {
        attitude: part.attitude,
        omega: part.omega,
        ..link
    };
    links.into_iter().zip(parts).map(beyond).collect()
}

/// Crosses the hinge of `link` and comes to its part.
fn link_motion<S: Scalar>(
    situation: &Situation<S>,
    axes: Axes,
    link: &Link,
    parent: &PartMotion<S>,
) -> LinkMotion<S> {
    let over = cross(situation, axes, (link.hinge, link.reversed), parent);
    let (_, to) = sides(situation.chain, link);
    let (_, point, rotation) = situation.place(to);
    let alignment = hinge::alignment(&situation.chain.hinges[link.hinge].kind, situation.numbers);
    let attitude = over.from_child * (rotation * alignment).transposed();
    let carried = over.to_parent.back(parent.omega);
    let rigid = rigid_part(situation, link, to, point);
    LinkMotion {
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
struct Rigid<S> {
    mass: S,
    moment: Vec3<S>,
    inertia: Sym3<S>,
}

fn rigid_part<S: Scalar>(
    situation: &Situation<S>,
    link: &Link,
    to: &Place,
    point: Vec3<S>,
) -> Rigid<S> {
    let numbers = situation.numbers;
    let mut all = Rigid { mass: S::zero(), moment: Vec3::zero(), inertia: Sym3([S::zero(); 6]) };
    for &member in &link.members {
        let body = &situation.chain.bodies[member];
        let (origin, rotation) = situation.frame(member);
        // The point as seen from the member.
        let seen = rotation.transposed() * (point - origin);
        let mass = numbers.scalar(&body.mass);
        let inertia = match to {
            Place::Input(input) if *input == member => numbers.inertia_about_input(body),
            _ => numbers.inertia_about(body, seen),
        };
        all.mass = all.mass + mass;
        all.moment = all.moment + rotation * ((numbers.vector(&body.com) - seen) * mass);
        all.inertia = all.inertia + rotation.rotated(inertia);
    }
    all
}

/// Crosses a hinge from the side of `parent`.
pub fn cross<S: Scalar>(
    situation: &Situation<S>,
    axes: Axes,
    (index, reversed): (HingeId, bool),
    parent: &PartMotion<S>,
) -> Crossed<S> {
    let numbers = situation.numbers;
    let hinge = &situation.chain.hinges[index];
    let from = if reversed { &hinge.outboard } else { &hinge.inboard };
    let (_, from_origin, from_rotation) = situation.place(from);
    let (q, v) = (situation.coordinates(index), situation.rates(index));
    let crossing = hinge::crossing(&hinge.kind, numbers, q, reversed);
    let alignment = hinge::alignment(&hinge.kind, numbers);
    let &PartMotion { attitude, point, omega } = parent;
    let from_parent_side = attitude * (from_rotation * alignment);
    let of_child =
        WorkAxes { from_parent: crossing.rotation.transposed(), from_child: Mat3::identity() };
    let (to_parent, work) = match axes {
        Axes::Body => (crossing.mounted_on(from_parent_side), of_child),
        Axes::Inertial => (
            Rotation::general(Mat3::identity()),
            WorkAxes {
                from_parent: from_parent_side,
                from_child: from_parent_side * crossing.rotation,
            },
        ),
    };
    let offset = from_parent_side * crossing.offset;
    let arm = attitude * (from_origin - point) + offset;
    let subspace = crossing.subspace(&work);
    let relative = hinge::combine(subspace.iter(), v);
    let own_drift = crossing.drift(&subspace, v, &work);
    let mut in_hinge = own_drift + hinge_drift(to_parent.back(omega), relative);
    let on_parent = arm.centripetal_by_products(omega);
    let passives = hinge::passives(hinge, numbers, q, v, situation.implicit);
    let freedom = match situation.prescribed_accelerations(index) {
        Some(accelerations) => {
            in_hinge = in_hinge + hinge::combine(subspace.iter(), accelerations);
            hinge::prescribed()
        }
        None => hinge::freedom(&subspace, &passives.strains, &passives.inertias),
    };
    let motor = situation.motor(index);
    let efforts = motor.iter().zip(&passives.efforts).map(|(&motor, &own)| motor + own).collect();
    Crossed {
        hinge: index,
        name: hinge.name.to_string(),
        to_parent,
        arm,
        offset,
        subspace,
        aligned: crossing.subspace(&of_child),
        freedom,
        passives,
        efforts,
        parent_omega: omega,
        relative,
        drift: Drift { on_parent, in_hinge },
        from_child: work.from_child,
    }
}

/// `[2 Ω_p × v_rel; Ω_p × ω_rel]`, as in [P, Eqs. (13), (36)].
fn hinge_drift<S: Scalar>(parent_omega: Vec3<S>, relative: Motion<S>) -> Motion<S> {
    Motion {
        linear: parent_omega.cross(relative.linear) * S::number(2.0),
        angular: parent_omega.cross(relative.angular),
    }
}

/// The places of a link's hinge: the parent's, then the child's.
pub(super) fn sides<'a>(chain: &'a Chain, link: &Link) -> (&'a Place, &'a Place) {
    let Hinge { inboard, outboard, .. } = &chain.hinges[link.hinge];
    if link.reversed { (outboard, inboard) } else { (inboard, outboard) }
}

/// The link that a part moves with; none on the ground.
pub(super) fn link_of(part: Part) -> Option<LinkId> {
    match part {
        Part::Ground => None,
        Part::Link(link) => Some(link),
    }
}
