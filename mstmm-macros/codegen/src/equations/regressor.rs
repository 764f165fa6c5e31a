//! The regressor: efforts of inverse dynamics as a linear function of inertias and passive elements.
//!
//! ```text
//! Y(q, v, v̇) π = ID(q, v, v̇) − e        π: parameters of all bodies and passive elements
//! ```
//!
//! `e` are the efforts against loads, springs between bodies and stops, which do not depend on `π`.
//!
//! With the virtual motion `ζ_i` of a body at unit rate `i` (see [`super::pull`]), the entry for a
//! parameter of a body is `ζ_iᵀ (I a + p)`, for the body's inertia with this parameter one and all others
//! zero. Motions are those of the body's input, in its axes, where these inertias have most zeros.

use super::hinge::{PassiveElements, passive_elements};
use super::inverse_dynamics::{accelerations, along_rates, by_rates, hinge_wrenches};
use super::kinematics::{LinkKinematics, RigidInertia, link_of};
use super::sweep::{Flatten, PerLink};
use super::{Axes, EvalContext, Trace, kinematics};
use crate::ids::HingeId;
use crate::math::{Mat3, Motion, Scalar, Sym3, Vec3};
use crate::model::{
    BodyId, DynamicParameter, Hinge, InertialParameter, LinkId, Passive, PassiveElement, Value,
};

/// Returns the columns of `Y`, one for each of the chain's dynamic parameters, with one entry for each
/// free rate in the layout's order.
pub fn regressor<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<Vec<S>> {
    let links = kinematics(context, axes, trace);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let unit_motions = unit_motions(context, &links);
    let parameters = context.chain.dynamic_parameters();
    let column = |&parameter: &DynamicParameter| match parameter {
        DynamicParameter::Inertial(body, parameter) => {
            let Some(link) = link_of(context.layout.parts[body]) else {
                return vec![S::zero(); context.layout.dof_count()];
            };
            let to_body = ToBody::new(context, &links[link], body);
            let acceleration = to_body.acceleration(&links[link], accelerations[link]);
            let omega = to_body.rotation * links[link].omega;
            let needed = inertia_of(parameter, S::one()).needed_wrench(acceleration, omega);
            let mut column = vec![S::zero(); context.layout.dof_count()];
            for &(rate, motion) in &unit_motions[link].0 {
                column[rate] = to_body.motion(motion).power(needed);
            }
            column
        }
        DynamicParameter::Passive(hinge, k, element) => {
            let mut column = vec![S::zero(); context.layout.dof_count()];
            let own = of_element(context, hinge, (k, element));
            column[context.layout.v[hinge].clone()].copy_from_slice(&own);
            column
        }
    };
    let columns: Vec<Vec<S>> = parameters.iter().map(column).collect();
    trace.section("regressor", "Regressor", "");
    for (number, column) in columns.iter().enumerate() {
        for (row, &entry) in column.iter().enumerate() {
            trace.number(format!("regressor{row}_{number}"), entry);
        }
    }
    columns
}

/// Returns the product `Y π` with any values of the dynamic parameters, at all free rates in the layout's
/// order.
pub fn regressor_times<S: Scalar>(
    context: &EvalContext<S>,
    values: &[S],
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = kinematics(context, axes, trace);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let given = |(index, link): (LinkId, &LinkKinematics<S>)| {
        of_bodies(context, (index, link), values).needed_wrench(accelerations[index], link.omega)
    };
    let needed = links.enumerate().map(given).collect();
    let wrenches = hinge_wrenches(context, &links, needed, trace);
    let mut product = by_rates(context, &links, &wrenches, along_rates);
    let parameters = context.chain.dynamic_parameters().into_iter();
    for (parameter, &value) in parameters.zip(values) {
        if let DynamicParameter::Passive(hinge, k, element) = parameter {
            let column = of_element(context, hinge, (k, element));
            let range = context.layout.v[hinge].clone();
            for (sum, entry) in product[range].iter_mut().zip(column) {
                *sum = *sum + entry * value;
            }
        }
    }
    product
}

/// Returns the inertia of a link about its point, in work axes, with these values of the parameters of its
/// bodies.
fn of_bodies<S: Scalar>(
    context: &EvalContext<S>,
    (index, link): (LinkId, &LinkKinematics<S>),
    values: &[S],
) -> RigidInertia<S> {
    let of_member = |total: RigidInertia<S>, &member: &BodyId| {
        let mut own = RigidInertia::zero();
        for (parameter, &value) in context.chain.dynamic_parameters().iter().zip(values) {
            if let DynamicParameter::Inertial(body, parameter) = parameter
                && *body == member
            {
                own = own.plus(inertia_of(*parameter, value));
            }
        }
        let (origin, rotation) = context.frame(member);
        let arm = link.part_to_work * (origin - link.point);
        let rotation = link.part_to_work * rotation;
        let own = RigidInertia {
            first_moment: rotation * own.first_moment,
            inertia: rotation.rotate_tensor(own.inertia),
            ..own
        };
        total.plus(own.shifted_from(arm))
    };
    context.layout.links[index].members.iter().fold(RigidInertia::zero(), of_member)
}

/// Returns the dynamic parameters `π`.
pub fn dynamic_parameters<S: Scalar>(context: &EvalContext<S>) -> Vec<S> {
    let values = context.values;
    let parameters = context.chain.dynamic_parameters().into_iter();
    let value = |parameter| match parameter {
        DynamicParameter::Inertial(id, parameter) => {
            let body = &context.chain.bodies[id];
            match parameter {
                InertialParameter::Mass => values.scalar(&body.mass),
                InertialParameter::FirstMoment(k) => {
                    values.scalar(&body.mass) * values.scalar(&body.com[k])
                }
                InertialParameter::Inertia(i, j) => values.inertia_about_input(body).at(i, j),
            }
        }
        DynamicParameter::Passive(hinge, k, element) => {
            let passive = &context.chain.hinges[hinge].passive[k];
            match (element, &passive.friction) {
                (PassiveElement::Friction, Some(friction)) => values.scalar(&friction.effort),
                (PassiveElement::Friction, None) => S::zero(),
                (PassiveElement::Damping, _) => values.scalar(&passive.damping),
                (PassiveElement::Armature, _) => values.scalar(&passive.armature),
                (PassiveElement::Stiffness, _) => values.scalar(&passive.stiffness),
            }
        }
    };
    parameters.map(value).collect()
}

/// The motions of a link's point at unit rates, each with the index of its rate: those of all hinges from
/// the ground to the link.
#[derive(Clone)]
struct UnitMotions<S>(Vec<(usize, Motion<S>)>);

/// The columns of a chain with repeated parts follow from products.
impl<S: Scalar> Flatten<S> for UnitMotions<S> {
    fn visit(self, _: &mut dyn FnMut(S) -> S) -> Self {
        bug!("motions at unit rates reach the boundary of a repeated part")
    }
}

fn unit_motions<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
) -> PerLink<UnitMotions<S>> {
    let (motions, _) = context.tree.outward(UnitMotions(Vec::new()), |index: LinkId, parent| {
        let hinge = &links[index].hinge;
        let carried =
            parent.0.iter().map(|&(rate, motion)| (rate, hinge.motion_from_parent(motion)));
        let own = context.layout.v[hinge.id].clone().zip(hinge.subspace.iter().copied());
        (UnitMotions(carried.chain(own).collect()), ())
    });
    motions
}

/// From a link's point in work axes to a body's input in body axes.
pub(super) struct ToBody<S> {
    pub rotation: Mat3<S>,
    /// From the link's point to the body's input, work axes.
    pub arm: Vec3<S>,
}

impl<S: Scalar> ToBody<S> {
    pub fn new(context: &EvalContext<S>, link: &LinkKinematics<S>, body: BodyId) -> Self {
        let (origin, rotation) = context.frame(body);
        ToBody {
            rotation: (link.part_to_work * rotation).transposed(),
            arm: link.part_to_work * (origin - link.point),
        }
    }

    fn motion(&self, motion: Motion<S>) -> Motion<S> {
        motion.shifted_to(self.arm).rotated(self.rotation)
    }

    /// Returns the acceleration of the body's input from that of the link's point.
    pub fn acceleration(&self, link: &LinkKinematics<S>, acceleration: Motion<S>) -> Motion<S> {
        let Motion { linear, angular } = acceleration.shifted_to(self.arm);
        let linear = linear + self.arm.centripetal_by_products(link.omega);
        Motion { linear, angular }.rotated(self.rotation)
    }
}

/// Returns the inertia of a body of which one parameter has this value and all others are zero.
fn inertia_of<S: Scalar>(parameter: InertialParameter, value: S) -> RigidInertia<S> {
    let zero = RigidInertia::zero();
    match parameter {
        InertialParameter::Mass => RigidInertia { mass: value, ..zero },
        InertialParameter::FirstMoment(k) => {
            RigidInertia { first_moment: Vec3::unit(k) * value, ..zero }
        }
        InertialParameter::Inertia(row, column) => {
            let is_it = |i: usize, j: usize| (i, j) == (row, column);
            let inertia = Sym3::from_fn(|i, j| if is_it(i, j) { value } else { S::zero() });
            RigidInertia { inertia, ..zero }
        }
    }
}

/// Returns the entries of a passive element's column at the rates of its hinge: minus its efforts, with its
/// number one and all other elements of the hinge removed.
pub(super) fn of_element<S: Scalar>(
    context: &EvalContext<S>,
    id: HingeId,
    (k, element): (usize, PassiveElement),
) -> Vec<S> {
    let mut hinge: Hinge = context.chain.hinges[id].clone();
    let speed = hinge.passive[k].friction.clone();
    let none = Passive {
        stiffness: Value::Number(0.0),
        damping: Value::Number(0.0),
        armature: Value::Number(0.0),
        friction: None,
        limits: None,
    };
    hinge.passive.iter_mut().for_each(|passive| *passive = none.clone());
    let one = Value::Number(1.0);
    match (element, speed) {
        (PassiveElement::Friction, Some(mut friction)) => {
            friction.effort = one;
            hinge.passive[k].friction = Some(friction);
        }
        (PassiveElement::Friction, None) => bug!("a hinge without friction has a column for it"),
        (PassiveElement::Damping, _) => hinge.passive[k].damping = one,
        (PassiveElement::Armature, _) => hinge.passive[k].armature = one,
        (PassiveElement::Stiffness, _) => hinge.passive[k].stiffness = one,
    }
    let (q, v) = (context.coordinates(id), context.rates(id));
    let passives: PassiveElements<S> = passive_elements(&hinge, context.values, q, v, None);
    let rotors = match context.given_accelerations(id) {
        Some(given) => passives.rotor_efforts(given),
        None => vec![S::zero(); v.len()],
    };
    rotors.iter().zip(&passives.efforts).map(|(&rotor, &effort)| rotor - effort).collect()
}
