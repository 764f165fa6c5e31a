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
//! All quantities of a link belong to its point, in its work axes; those of composite bodies are in
//! [`composite`](super::composite).
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `δΩ`, `δα`, `δa` | [`FieldChange`] | changes of angular velocity, angular acceleration and acceleration of a link, in axes that move with it |
//! | `β = δα − δΩ × Ω` | `motion.angular` | angular part of the field |
//! | `w_a`, `w_β`, `w_ω` | [`EffortGradient`] | derivatives of an effort with respect to `δa`, `β` and `δΩ` of a link |
//!
//! # Equations
//!
//! The field at a mass at `r`, and the change of the wrench in the hinge that moves all masses:
//!
//! (1)  `δr̈ = δa + β × r + 2 δΩ × ṙ`
//! (2)  `δF = [m δa + β × h + 2 δΩ × P; h × δa + J β + B δΩ]`
//!
//! The effort of a hinge further outboard, with motion subspace `[s_v; s_ω]`, at that hinge and inward:
//!
//! (3)  `w_a = m s_v + s_ω × h`, `w_β = h × s_v + J s_ω`, `w_ω = 2 P × s_v + Bᵀ s_ω`
//! (4)  `w_β ← w_β + arm × w_a`, `w_ω ← w_ω + 2 u × w_a`
//!
//! `w_a` and `w_β` are also a column of the mass matrix. External loads and springs between bodies are
//! not part of the wrenches; their efforts are differentiated by sweeps on dual numbers.

use super::base_parameters::base_kinematics;
use super::composite::{CompositeBody, composite_bodies, of_composite_bodies, to_ground};
use super::composite::{twice_velocity, unit_vector};
use super::dense_matrix::DenseMatrix;
use super::hinge::combine;
use super::inverse_dynamics::{accelerations, external_efforts, hinge_wrenches, own_efforts};
use super::kinematics::{HingeKinematics, LinkKinematics, PartKinematics, hinge_kinematics};
use super::sweep::PerLink;
use super::tangent::{Direction, Tangent};
use super::{Axes, EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{Dual, FrameOrientation, Mat3, Motion, Scalar, Vec3, Wrench};
use crate::model::InputKind;

/// A change of the accelerations of all bodies outboard of a hinge, equation (1).
#[derive(Clone, Copy, Debug)]
struct FieldChange<S> {
    /// `δa` and `β`.
    motion: Motion<S>,
    /// `δΩ`
    omega: Vec3<S>,
}

/// The derivatives of an effort with respect to the field at a link, equation (3).
#[derive(Clone, Copy, Debug)]
struct EffortGradient<S> {
    /// `w_a` and `w_β`.
    wrench: Wrench<S>,
    /// `w_ω`
    omega: Vec3<S>,
}

impl<S: Scalar> EffortGradient<S> {
    /// Returns the gradient of the effort of the link's own hinge along a motion, equation (3).
    fn of(body: &CompositeBody<S>, motion: Motion<S>) -> Self {
        let spin = body.spin.transposed() * motion.angular;
        EffortGradient {
            wrench: body.wrench(motion),
            omega: body.twice_momentum.cross(motion.linear) + spin,
        }
    }

    /// Returns the gradient with respect to the field at the parent, equation (4).
    fn to_parent(self, hinge: &HingeKinematics<S>) -> Self {
        let wrench = hinge.wrench_to_parent(self.wrench);
        let omega = hinge.to_parent.rotate(self.omega);
        EffortGradient { wrench, omega: omega + twice_velocity(hinge).cross(wrench.force) }
    }

    /// Returns the change of the effort.
    fn change(&self, field: &FieldChange<S>) -> S {
        field.motion.power(self.wrench) + field.omega.dot(self.omega)
    }
}

impl<S: Scalar> FieldChange<S> {
    /// Returns the change of the wrench in the hinge of a composite body, equation (2).
    fn wrench(&self, body: &CompositeBody<S>) -> Wrench<S> {
        let Wrench { force, moment } = body.wrench(self.motion);
        Wrench {
            force: force + self.omega.cross(body.twice_momentum),
            moment: moment + body.spin * self.omega,
        }
    }
}

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
    /// The efforts of all hinges outboard of each link's hinge, by rate.
    outboard: PerLink<Vec<(usize, EffortGradient<S>)>>,
    /// The same for the ground.
    on_ground: Vec<(usize, EffortGradient<S>)>,
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
        let mut outboard = PerLink::filled(Vec::new(), links.len());
        let mut on_ground = Vec::new();
        links.enumerate().for_each(|(index, LinkKinematics { hinge, .. })| {
            trace.section(
                format!("{}_gradient", hinge.name),
                format!("Derivatives of the efforts in `{}` by motions inboard of it", hinge.name),
                "",
            );
            for (row, &motion) in context.layout.v[hinge.id].clone().zip(&hinge.subspace) {
                let start = EffortGradient::of(&bodies[index], motion);
                let mut visit = |at: LinkId, gradient: &EffortGradient<S>| {
                    if at != index {
                        outboard[at].push((row, *gradient));
                    }
                };
                let inward = |at: LinkId, here: EffortGradient<S>| here.to_parent(&links[at].hinge);
                on_ground.push((row, to_ground(context, index, start, &mut visit, inward)));
            }
        });
        InverseDynamicsTangent {
            context,
            axes,
            links,
            bodies,
            accelerations,
            wrenches,
            outboard,
            on_ground,
        }
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
        let field = FieldChange { motion: derivative(ground), omega: Vec3::zero() };
        let mut values = vec![S::zero(); self.context.layout.dof_count()];
        for (row, gradient) in &self.on_ground {
            values[*row] = gradient.change(&field);
        }
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
        for (row, gradient) in &self.outboard[index] {
            values[*row] = gradient.change(&field);
        }
        if let Some(parent) = link.parent {
            let change = hinge.wrench_to_parent(wrench);
            let change = Wrench::from_fn(|k| change.at(k).derivative());
            let visit = |at: LinkId, wrench: &Wrench<S>| {
                let LinkKinematics { hinge, .. } = &self.links[at];
                for (row, s) in context.layout.v[hinge.id].clone().zip(&hinge.subspace) {
                    values[row] = s.power(*wrench);
                }
            };
            let inward = |at: LinkId, wrench| self.links[at].hinge.wrench_to_parent(wrench);
            to_ground(context, parent, change, visit, inward);
        }
        values
    }

    /// Returns the change of the field outboard of a hinge, from angular velocity and acceleration of its link.
    fn field_change(
        &self,
        index: LinkId,
        omega: Vec3<Dual<S>>,
        acceleration: Motion<Dual<S>>,
    ) -> FieldChange<S> {
        let omega = Vec3::from_fn(|k| omega[k].derivative());
        let Motion { linear, angular } = derivative(acceleration);
        let angular = angular - omega.cross(self.links[index].omega);
        FieldChange { motion: Motion { linear, angular }, omega }
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
