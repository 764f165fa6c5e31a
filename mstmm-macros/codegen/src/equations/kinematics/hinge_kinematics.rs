//! Over one hinge, from the parent's side to the child's.

use super::super::EvalContext;
use super::super::hinge::{self, PassiveElements, SubspaceBasis, ToWorkAxes};
use super::super::strategy::Axes;
use super::PartKinematics;
use crate::math::{Mat3, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::HingeId;

/// A hinge that was crossed, in the work axes of its child unless another frame is named.
#[derive(Clone, Debug)]
pub struct HingeKinematics<S> {
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
    pub freedom: SubspaceBasis<S>,
    /// What acts along its free directions of itself.
    pub passives: PassiveElements<S>,
    /// Efforts of motor and passive elements, one for each rate.
    pub efforts: Vec<S>,
    /// Angular velocity of the parent, in the parent's work axes.
    pub parent_omega: Vec3<S>,
    /// Motion against the parent, at the point.
    pub relative: Motion<S>,
    /// What joins the acceleration of the point on the way from the parent's.
    pub drift: BiasAcceleration<S>,
    /// Aligned child axes of the hinge to work axes.
    pub from_child: Mat3<S>,
}

/// What velocities and prescribed accelerations add to the acceleration of a point on the way from
/// its parent's [P, Eqs. (13), (36)], each part in the axes in which it has most zeros.
#[derive(Clone, Copy, Debug)]
pub struct BiasAcceleration<S> {
    /// Of the way on the parent to the hinge, `Ω_p × (Ω_p × arm)`; parent's work axes.
    pub on_parent: Vec3<S>,
    /// Of the hinge; work axes of its child.
    pub in_hinge: Motion<S>,
}

impl<S: Scalar> BiasAcceleration<S> {
    /// Nothing joins.
    pub fn none() -> Self {
        BiasAcceleration { on_parent: Vec3::zero(), in_hinge: Motion::zero() }
    }

    /// Power of a wrench on it, in the hinge's work axes, which `to_parent` leads to those of the
    /// parent.
    pub fn power(self, to_parent: &Rotation<S>, wrench: Wrench<S>) -> S {
        self.in_hinge.power(wrench) + self.on_parent.dot(to_parent.of_vector(wrench.force))
    }
}

impl<S: Scalar> HingeKinematics<S> {
    /// The part of the parent's motion, or acceleration, that comes over to the point.
    pub fn carried(&self, parent: Motion<S>) -> Motion<S> {
        parent.carried_to(self.arm).turned_back(&self.to_parent)
    }

    /// The same with what joins on the way.
    pub fn carried_with(&self, parent: Motion<S>, drift: BiasAcceleration<S>) -> Motion<S> {
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

/// Crosses a hinge from the side of `parent`.
pub fn cross<S: Scalar>(
    situation: &EvalContext<S>,
    axes: Axes,
    (index, reversed): (HingeId, bool),
    parent: &PartKinematics<S>,
) -> HingeKinematics<S> {
    let numbers = situation.numbers;
    let hinge = &situation.chain.hinges[index];
    let from = if reversed { &hinge.outboard } else { &hinge.inboard };
    let (_, from_origin, from_rotation) = situation.place(from);
    let (q, v) = (situation.coordinates(index), situation.rates(index));
    let crossing = hinge::crossing(&hinge.kind, numbers, q, reversed);
    let alignment = hinge.kind.law().alignment(numbers);
    let &PartKinematics { attitude, point, omega } = parent;
    let from_parent_side = attitude * (from_rotation * alignment);
    let of_child =
        ToWorkAxes { from_parent: crossing.rotation.transposed(), from_child: Mat3::identity() };
    let (to_parent, work) = match axes {
        Axes::Body => (crossing.mounted_on(from_parent_side), of_child),
        Axes::Inertial => (
            Rotation::general(Mat3::identity()),
            ToWorkAxes {
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
    HingeKinematics {
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
        drift: BiasAcceleration { on_parent, in_hinge },
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
