//! Kinematics across one hinge, from its parent to its child.

use super::super::EvalContext;
use super::super::hinge::{self, HingeTransform, PassiveElements, SubspaceBasis, ToWorkAxes};
use super::super::strategy::Axes;
use super::PartKinematics;
use crate::math::{FrameOrientation, Motion, Rotation, Scalar, Vec3, Wrench};
use crate::model::HingeId;

/// The kinematics of a hinge, in the work axes of its child unless another frame is named.
#[derive(Clone, Debug)]
pub struct HingeKinematics<S> {
    /// The hinge.
    pub id: HingeId,
    /// Its name.
    pub name: String,
    /// Rotation from the child's work axes to those of the parent.
    pub to_parent: Rotation<S>,
    /// From the parent's point to the child's, parent's work axes, in m.
    pub arm: Vec3<S>,
    /// The part of `arm` inside the hinge: from the hinge's parent side to the child's point.
    pub offset: Vec3<S>,
    /// The motion subspace `S`: the motion of the child relative to the parent for each rate.
    pub subspace: Vec<Motion<S>>,
    /// The same in aligned child axes of the hinge, where it has the most zeros.
    pub aligned_subspace: Vec<Motion<S>>,
    /// A basis of the motion subspace for the elimination.
    pub basis: SubspaceBasis<S>,
    /// Springs, dampers, friction, stops and rotors of the hinge.
    pub passives: PassiveElements<S>,
    /// Efforts of actuator and passive elements, one for each rate.
    pub efforts: Vec<S>,
    /// Angular velocity of the parent, in the parent's work axes.
    pub parent_omega: Vec3<S>,
    /// The rates.
    pub rates: Vec<S>,
    /// Velocity relative to the parent, at the child's point.
    pub relative_velocity: Motion<S>,
    /// Bias acceleration of the child's point relative to the parent's.
    pub bias_acceleration: BiasAcceleration<S>,
    /// Rotation from aligned child axes of the hinge to work axes.
    pub child_to_work: FrameOrientation<S>,
    /// The transform across the hinge, and the rotations from its aligned axes to work axes.
    transform: (HingeTransform<S>, ToWorkAxes<S>),
}

/// The bias acceleration `b` of a hinge: the acceleration of the child's point that velocities and
/// prescribed accelerations add to the parent's [P, Eqs. (13), (36)]. Each part is in the axes
/// where it has the most zeros.
#[derive(Clone, Copy, Debug)]
pub struct BiasAcceleration<S> {
    /// Of the arm on the parent, `Ω_p × (Ω_p × arm)`; parent's work axes.
    pub on_parent: Vec3<S>,
    /// Of the hinge; child's work axes.
    pub in_hinge: Motion<S>,
}

impl<S: Scalar> BiasAcceleration<S> {
    /// No bias acceleration.
    pub fn zero() -> Self {
        BiasAcceleration { on_parent: Vec3::zero(), in_hinge: Motion::zero() }
    }

    /// Returns `bᵀ F` for a wrench in the hinge's work axes; `to_parent` rotates these axes to the
    /// parent's.
    pub fn power(self, to_parent: &Rotation<S>, wrench: Wrench<S>) -> S {
        self.in_hinge.power(wrench) + self.on_parent.dot(to_parent.rotate(wrench.force))
    }
}

impl<S: Scalar> HingeKinematics<S> {
    /// Returns `X a_p`: the motion of the child's point if the hinge were rigid.
    pub fn motion_from_parent(&self, parent: Motion<S>) -> Motion<S> {
        parent.shifted_to(self.arm).rotated_back(&self.to_parent)
    }

    /// Returns the velocity `u` of the child's point relative to the parent's, in axes that do not rotate;
    /// parent's work axes.
    pub fn point_velocity(&self) -> Vec3<S> {
        let relative = self.to_parent.rotate(self.relative_velocity.linear);
        self.parent_omega.cross(self.arm) + relative
    }

    /// Returns `Ṡ`: the time derivatives of the columns of the motion subspace, in axes that do not rotate.
    pub fn subspace_rates(&self) -> Vec<Motion<S>> {
        let (transform, work) = &self.transform;
        let parent = self.to_parent.rotate_back(self.parent_omega);
        let omega = [parent, parent + self.relative_velocity.angular];
        let subspace = (&self.subspace[..], &self.rates[..]);
        transform.subspace_rates(subspace, (omega, self.relative_velocity), work)
    }

    /// Returns `X a_p + b`.
    pub fn acceleration_from_parent(
        &self,
        parent: Motion<S>,
        bias: BiasAcceleration<S>,
    ) -> Motion<S> {
        let Motion { linear, angular } = parent.shifted_to(self.arm);
        let at_hinge = Motion { linear: linear + bias.on_parent, angular };
        at_hinge.rotated_back(&self.to_parent) + bias.in_hinge
    }

    /// Whether both sides of the hinge are the same point in all coordinates of the hinge.
    pub fn is_concentric(&self) -> bool {
        let vanishes = |vector: Vec3<S>| vector.0.iter().all(|entry| entry.vanishes());
        let translates = self.subspace.iter().any(|motion| !vanishes(motion.linear));
        !translates && vanishes(self.offset) && vanishes(self.bias_acceleration.in_hinge.linear)
    }

    /// Returns a wrench on the child, about its point, as a wrench about the parent's point in the
    /// parent's work axes.
    pub fn wrench_to_parent(&self, wrench: Wrench<S>) -> Wrench<S> {
        wrench.rotated(&self.to_parent).shifted_from(self.arm)
    }
}

/// Returns the kinematics across a hinge, from the kinematics of `parent`.
pub fn hinge_kinematics<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    (index, reversed): (HingeId, bool),
    parent: &PartKinematics<S>,
) -> HingeKinematics<S> {
    let values = context.values;
    let hinge = &context.chain.hinges[index];
    let from = if reversed { &hinge.outboard } else { &hinge.inboard };
    let (_, from_origin, from_rotation) = context.frame_of(from);
    let (q, v) = (context.coordinates(index), context.rates(index));
    let displaced = (q, context.displacement(index));
    let transform = hinge::hinge_transform(&hinge.kind, values, displaced, reversed);
    let alignment = hinge.kind.law().alignment(values);
    let &PartKinematics { part_to_work, point, omega } = parent;
    let parent_side = part_to_work.then(FrameOrientation::from_matrix(from_rotation * alignment));
    let HingeAxes { to_parent, to_work, to_child, child_to_work } =
        HingeAxes::of(axes, parent_side, &transform);
    let offset = parent_side.matrix() * transform.offset;
    let arm = part_to_work.matrix() * (from_origin - point) + offset;
    let subspace = transform.subspace(&to_work);
    let relative_velocity = hinge::combine(subspace.iter(), v);
    let hinge_bias = transform.bias_acceleration(&subspace, v, &to_work);
    let mut in_hinge =
        hinge_bias + coriolis_acceleration(to_parent.rotate_back(omega), relative_velocity);
    let on_parent = arm.centripetal_by_products(omega);
    let passives = passives(context, index);
    let basis = match context.prescribed_accelerations(index) {
        Some(accelerations) => {
            in_hinge = in_hinge + hinge::combine(subspace.iter(), accelerations);
            hinge::empty_basis()
        }
        None => {
            let subspace = (&subspace[..], transform.has_orthogonal_rotations());
            hinge::subspace_basis(subspace, &passives.strains, &passives.inertias)
        }
    };
    let motor = context.actuator_efforts(index);
    let efforts = motor.iter().zip(&passives.efforts).map(|(&motor, &own)| motor + own).collect();
    HingeKinematics {
        id: index,
        name: hinge.name.to_string(),
        to_parent,
        arm,
        offset,
        subspace,
        aligned_subspace: transform.subspace(&to_child),
        transform: (transform, to_work),
        basis,
        passives,
        efforts,
        parent_omega: omega,
        rates: v.to_vec(),
        relative_velocity,
        bias_acceleration: BiasAcceleration { on_parent, in_hinge },
        child_to_work,
    }
}

/// The rotations between the axes of a hinge.
struct HingeAxes<S> {
    /// From the child's work axes to those of the parent.
    to_parent: Rotation<S>,
    /// From the aligned axes of both sides to the child's work axes.
    to_work: ToWorkAxes<S>,
    /// From the aligned axes of both sides to aligned child axes.
    to_child: ToWorkAxes<S>,
    /// From aligned child axes to the child's work axes.
    child_to_work: FrameOrientation<S>,
}

impl<S: Scalar> HingeAxes<S> {
    /// Returns the rotations; `parent_side` is from aligned parent axes to the parent's work axes.
    fn of(
        axes: Axes,
        parent_side: FrameOrientation<S>,
        transform: &HingeTransform<S>,
    ) -> HingeAxes<S> {
        let (identity, inverse) = (FrameOrientation::identity(), transform.rotation.inverse());
        let to_child = ToWorkAxes::new(inverse, identity);
        let (to_parent, to_work, child_to_work) = match axes {
            Axes::Body => {
                let to_parent = transform.rotation_to_parent(parent_side.matrix());
                (to_parent, to_child, identity)
            }
            Axes::Inertial => {
                let child = parent_side.then(transform.rotation);
                let to_parent = Rotation::from_matrix(identity.matrix());
                (to_parent, ToWorkAxes::new(parent_side, child), child)
            }
        };
        HingeAxes { to_parent, to_work, to_child, child_to_work }
    }
}

/// Returns the passive elements of a hinge, at a displacement from its coordinates if one is given.
fn passives<S: Scalar>(context: &EvalContext<S>, index: HingeId) -> PassiveElements<S> {
    let hinge = &context.chain.hinges[index];
    let (q, v) = (context.coordinates(index), context.rates(index));
    let displaced =
        context.displacement(index).map(|along| hinge::displaced(&hinge.kind, q, along));
    let q = displaced.as_deref().unwrap_or(q);
    hinge::passive_elements(hinge, context.values, q, v, context.implicit)
}

/// Returns the Coriolis terms `[2 Ω_p × v_rel; Ω_p × ω_rel]`, as in [P, Eqs. (13), (36)].
fn coriolis_acceleration<S: Scalar>(parent_omega: Vec3<S>, relative: Motion<S>) -> Motion<S> {
    Motion {
        linear: parent_omega.cross(relative.linear) * S::number(2.0),
        angular: parent_omega.cross(relative.angular),
    }
}
