//! Derivatives of inverse dynamics with respect to coordinates, rates, accelerations and inputs, by
//! composite bodies.
//!
//! A change in one hinge, with everything else held, changes the motion of all bodies outboard of it as
//! one field of accelerations. A change of this field changes the efforts of all hinges outboard of the
//! hinge and the wrench in the hinge itself, from which the efforts of all hinges inboard of it follow.
//! The change in the hinge is computed on dual numbers, so all kinds of hinges are alike. Coordinates
//! change along the rates, as in [`tangent`](super::tangent).
//!
//! # Notation
//!
//! All quantities of a link belong to its point, in its work axes. The change of the accelerations is an
//! [`AccelerationField`], whose angular part is `β = δα − δΩ × Ω` for the changes `δα` of the angular
//! acceleration and `δΩ` of the angular velocity of a link, in axes that move with it. The wrenches and the
//! efforts of fields are in [`acceleration_field`](super::acceleration_field).
//!
//! External loads and springs between bodies are not part of the wrenches; their efforts are differentiated
//! by sweeps on dual numbers.

use super::acceleration_field::{AccelerationField, EffortGradients, set_inboard_efforts};
use super::base_parameters::base_kinematics;
use super::composite::{CompositeBody, composite_bodies, of_composite_bodies, unit_vector};
use super::dense_matrix::DenseMatrix;
use super::hinge::combine;
use super::inverse_dynamics::{accelerations, external_efforts, hinge_wrenches, own_efforts};
use super::kinematics::{LinkKinematics, PartKinematics, hinge_kinematics};
use super::sweep::PerLink;
use super::tangent::{Direction, Tangent};
use super::{Axes, EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{Dual, FrameOrientation, Mat3, Motion, Scalar, Vec3, Wrench};
use crate::model::InputKind;

/// The state of a chain from which all derivatives of inverse dynamics follow.
#[derive(Debug)]
pub struct InverseDynamicsTangent<'a, S> {
    context: &'a EvalContext<'a, S>,
    axes: Axes,
    links: PerLink<LinkKinematics<S>>,
    bodies: PerLink<CompositeBody<S>>,
    /// Accelerations of all links' points.
    accelerations: PerLink<Motion<S>>,
    /// Wrenches in all hinges, without loads and springs.
    wrenches: PerLink<Wrench<S>>,
    gradients: EffortGradients<S>,
}

impl<'a, S: Scalar> InverseDynamicsTangent<'a, S> {
    /// Returns the state of an open chain at the given accelerations of `context`. The chain must be
    /// written out.
    pub fn new(context: &'a EvalContext<'a, S>, axes: Axes, trace: &mut Trace<S>) -> Self {
        let links = base_kinematics(context, axes, trace);
        let bodies = composite_bodies(context, &links, trace);
        let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
        let wrenches = links.enumerate().map(|(index, link)| {
            link.spatial_inertia().times(accelerations[index]) + link.velocity_wrench()
        });
        let wrenches = hinge_wrenches(context, &links, wrenches.collect(), trace);
        let gradients = EffortGradients::new(context, &links, &bodies, trace);
        InverseDynamicsTangent { context, axes, links, bodies, accelerations, wrenches, gradients }
    }

    /// Returns the derivatives with respect to the accelerations: the mass matrix.
    pub fn by_accelerations(&self, trace: &mut Trace<S>) -> DenseMatrix<S> {
        of_composite_bodies(self.context, &self.links, &self.bodies, trace)
    }

    /// Returns the derivatives with respect to the coordinates, along the rates.
    pub fn by_coordinates(&self, trace: &mut Trace<S>) -> DenseMatrix<S> {
        self.along_rates(trace, "coordinates", |coordinates| Direction {
            coordinates,
            ..Direction::default()
        })
    }

    /// Returns the derivatives with respect to the rates.
    pub fn by_rates(&self, trace: &mut Trace<S>) -> DenseMatrix<S> {
        self.along_rates(trace, "rates", |rates| Direction { rates, ..Direction::default() })
    }

    /// Returns the derivatives along the direction that `direction` makes of each unit vector of rates.
    fn along_rates(
        &self,
        trace: &mut Trace<S>,
        what: &str,
        direction: impl Fn(Vec<S>) -> Direction<S>,
    ) -> DenseMatrix<S> {
        let count = self.context.layout.dof_count();
        let mut matrix = DenseMatrix::zero(count, count);
        self.links.enumerate().for_each(|(index, LinkKinematics { hinge, .. })| {
            trace.section(
                format!("{}_by_{what}", hinge.name),
                format!("Derivatives by the {what} of `{}`", hinge.name),
                "",
            );
            for column in self.context.layout.v[hinge.id].clone() {
                let direction = direction(unit_vector(count, column));
                let mut values = self.in_hinge(index, &direction, trace);
                self.add_external(&direction, &mut values);
                matrix.set_column(column, &values);
            }
        });
        matrix
    }

    /// Returns the derivatives with respect to an entry of the inputs. Motors are not part of inverse
    /// dynamics.
    pub fn by_input(&self, entry: usize, trace: &mut Trace<S>) -> Vec<S> {
        let EvalContext { layout, inputs, .. } = self.context;
        let mut of_entry = layout.inputs.iter().filter(|input| input.range.contains(&entry));
        let Some(input) = of_entry.next() else { bug!("no input has entry {entry}") };
        let inputs = unit_vector(inputs.len(), entry);
        let direction = Direction { inputs, ..Direction::default() };
        let mut values = match input.what {
            InputKind::Motion(moved) => {
                let link = self.links.position(|link| link.hinge.id == moved);
                let Some(link) = link else { bug!("a prescribed hinge has no link") };
                self.in_hinge(link, &direction, trace)
            }
            InputKind::Gravity => self.by_gravity(&direction),
            InputKind::Force(_)
            | InputKind::Torque(_)
            | InputKind::SpringForce(_)
            | InputKind::Efforts(_) => {
                vec![S::zero(); layout.dof_count()]
            }
        };
        self.add_external(&direction, &mut values);
        values
    }

    /// Returns the derivatives along a direction of gravity, without loads and springs.
    fn by_gravity(&self, direction: &Direction<S>) -> Vec<S> {
        let tangent = Tangent::new(self.context, direction);
        let ground = tangent.context(self.context).base_acceleration();
        let field = AccelerationField { motion: derivative(ground), omega: Vec3::zero() };
        let mut values = vec![S::zero(); self.context.layout.dof_count()];
        self.gradients.set_all(&field, &mut values);
        values
    }

    /// Returns the derivatives along a direction in which only one hinge changes, without loads and springs.
    fn in_hinge(&self, index: LinkId, direction: &Direction<S>, trace: &mut Trace<S>) -> Vec<S> {
        let context = self.context;
        let tangent = Tangent::new(context, direction);
        let dual = tangent.context(context);
        let link = &context.layout.links[index];
        let parent = link.parent.map_or(PartKinematics::ground(), |it| self.links[it].part());
        let parent = lifted(parent);
        let hinge = hinge_kinematics(&dual, self.axes, (link.hinge, link.reversed), &parent);
        let of_parent = link
            .parent
            .map_or_else(|| context.base_acceleration(), |parent| self.accelerations[parent]);
        let bias = hinge.acceleration_from_parent(constant(of_parent), hinge.bias_acceleration);
        let acceleration = match dual.given_accelerations(hinge.id) {
            Some(given) => bias + combine(hinge.subspace.iter(), given),
            None => bias,
        };
        let omega = hinge.to_parent.rotate_back(parent.omega) + hinge.relative_velocity.angular;
        let field = self.field_change(index, omega, acceleration);
        let body = &self.bodies[index];
        let change = field.wrench(body);
        trace.motion(&format!("{}_change", hinge.name), field.motion);
        trace.vector(&format!("{}_change_omega", hinge.name), field.omega);
        trace.wrench(&format!("{}_change_wrench", hinge.name), change);
        let wrench = self.wrenches[index];
        let wrench = Wrench::from_fn(|k| Dual::new(wrench.at(k), change.at(k)));
        let mut values = vec![S::zero(); context.layout.dof_count()];
        let own = own_efforts(&hinge, dual.given_accelerations(link.hinge));
        let own_rows = context.layout.v[link.hinge].clone().zip(&hinge.subspace).zip(own);
        for ((row, column), own) in own_rows {
            values[row] = (column.power(wrench) - own).derivative();
        }
        self.gradients.set_outboard(index, &field, &mut values);
        if let Some(parent) = link.parent {
            let change = hinge.wrench_to_parent(wrench);
            let change = Wrench::from_fn(|k| change.at(k).derivative());
            set_inboard_efforts(context, &self.links, (parent, change), &mut values);
        }
        values
    }

    /// Returns the change of the field outboard of a hinge, from angular velocity and acceleration of its link.
    fn field_change(
        &self,
        index: LinkId,
        omega: Vec3<Dual<S>>,
        acceleration: Motion<Dual<S>>,
    ) -> AccelerationField<S> {
        let omega = Vec3::from_fn(|k| omega[k].derivative());
        let Motion { linear, angular } = derivative(acceleration);
        let angular = angular - omega.cross(self.links[index].omega);
        AccelerationField { motion: Motion { linear, angular }, omega }
    }

    /// Adds the derivatives of the efforts that balance loads and springs.
    fn add_external(&self, direction: &Direction<S>, values: &mut [S]) {
        let chain = self.context.chain;
        if chain.loads.is_empty() && chain.springs.is_empty() {
            return;
        }
        let tangent = Tangent::new(self.context, direction);
        let dual = tangent.context(self.context);
        let changes = external_efforts(&dual, self.axes, &mut Trace::silent());
        values.iter_mut().zip(changes).for_each(|(value, change)| {
            *value = *value + change.derivative();
        });
    }
}

/// Returns a motion that does not change.
fn constant<S: Scalar>(motion: Motion<S>) -> Motion<Dual<S>> {
    Motion::from_fn(|k| Dual::new(motion.at(k), S::zero()))
}

/// Returns the derivative of a motion.
fn derivative<S: Scalar>(motion: Motion<Dual<S>>) -> Motion<S> {
    Motion::from_fn(|k| motion.at(k).derivative())
}

/// Returns the kinematics of a part that does not change.
fn lifted<S: Scalar>(part: PartKinematics<S>) -> PartKinematics<Dual<S>> {
    let constant = |value: S| Dual::new(value, S::zero());
    let matrix = part.part_to_work.matrix();
    PartKinematics {
        part_to_work: FrameOrientation::from_matrix(Mat3::from_fn(|i, j| constant(matrix[i][j]))),
        point: Vec3(part.point.0.map(constant)),
        omega: Vec3(part.omega.0.map(constant)),
    }
}
