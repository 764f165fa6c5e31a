//! Derivatives of the accelerations of an open chain, by those of inverse dynamics.
//!
//! With the efforts `ID(q, v, v̇, w)` that inverse dynamics requires, efforts `τ` of the motors and
//! parameters or other inputs `w`, forward dynamics is `ID(q, v, v̇(q, v, τ, w), w) = τ`. Therefore
//!
//! ```text
//! ∂v̇/∂q = −M⁻¹ ∂ID/∂q    ∂v̇/∂v = −M⁻¹ ∂ID/∂v    ∂v̇/∂τ = M⁻¹    ∂v̇/∂w = −M⁻¹ ∂(ID − τ)/∂w
//! ```
//!
//! The products with `−M⁻¹` are not part of the equations here: they are loops.

use super::composite::{mass_matrix, unit_vector};
use super::dense_matrix::DenseMatrix;
use super::derivatives::InverseDynamicsTangent;
use super::inverse_dynamics::inverse_dynamics;
use super::inverse_mass_matrix::inverse;
use super::motion_problem::HingePivot;
use super::open_chain::OpenChain;
use super::strategy::factorizes_mass_matrix;
use super::tangent::{Direction, Tangent};
use super::{Axes, EvalContext, Trace};
use crate::ids::ParameterId;
use crate::math::Scalar;

/// Accelerations, the inverse of the mass matrix, and derivatives that are to be multiplied by `−M⁻¹`.
#[derive(Clone, Debug)]
pub struct Linearization<S> {
    /// The accelerations `v̇`.
    pub accelerations: Vec<S>,
    /// `M⁻¹`
    pub inverse: DenseMatrix<S>,
    /// `∂ID/∂q`, along the rates.
    pub by_coordinates: DenseMatrix<S>,
    /// `∂ID/∂v`
    pub by_rates: DenseMatrix<S>,
    /// For each entry of the inputs, `∂ID/∂w`; but for the effort of a motor its column of `M⁻¹`.
    pub by_inputs: DenseMatrix<S>,
    /// `∂(ID − τ)/∂w` for each parameter.
    pub by_parameters: DenseMatrix<S>,
    /// The pivots.
    pub pivots: Vec<HingePivot<S>>,
}

/// Returns the derivatives of the accelerations at a state. The chain must be open and written out.
pub fn linearization<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Linearization<S> {
    let (accelerations, inverse, pivots) = solved(context, axes, trace);
    let at = context.clone().with_accelerations(&accelerations);
    let tangent = InverseDynamicsTangent::new(&at, axes, trace);
    let (by_coordinates, by_rates) = (tangent.by_coordinates(trace), tangent.by_rates(trace));
    let count = accelerations.len();
    let mut by_inputs = DenseMatrix::zero(count, context.inputs.len());
    trace.section("inputs", "Derivatives by inputs", "");
    for (entry, driven) in context.layout.driven_rates(context.chain).into_iter().enumerate() {
        match driven {
            Some(rate) => by_inputs.set_column(entry, inverse.column(rate)),
            None => by_inputs.set_column(entry, &tangent.by_input(entry, trace)),
        }
    }
    let parameters = context.values.parameters.len();
    let mut by_parameters = DenseMatrix::zero(count, parameters);
    trace.section("parameters", "Derivatives by parameters", "");
    for parameter in context.chain.parameters.ids() {
        by_parameters.set_column(parameter.index(), &by_parameter(&at, axes, parameter));
    }
    Linearization {
        accelerations: accelerations.clone(),
        inverse,
        by_coordinates,
        by_rates,
        by_inputs,
        by_parameters,
        pivots,
    }
}

/// Returns the accelerations, the inverse of the mass matrix and the pivots.
fn solved<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (Vec<S>, DenseMatrix<S>, Vec<HingePivot<S>>) {
    if !factorizes_mass_matrix(context.layout) {
        let chain = OpenChain::new(context, axes, trace);
        let (accelerations, pivots) = chain.accelerations(trace);
        return (accelerations, chain.inverse_mass_matrix(trace).0, pivots);
    }
    let bias = inverse_dynamics(context, axes, trace);
    let matrix = mass_matrix(context, axes, trace);
    let (inverse, pivots) = inverse(context.layout, matrix, trace);
    let motors = motor_efforts(context);
    let efforts: Vec<S> = motors.iter().zip(bias).map(|(&motor, bias)| motor - bias).collect();
    let accelerations = inverse.times(&efforts);
    trace.section("accelerations", "Accelerations", "");
    for (k, &acceleration) in accelerations.iter().enumerate() {
        trace.number(format!("acceleration{k}"), acceleration);
    }
    (accelerations, inverse, pivots)
}

/// Returns the efforts of the motors at all free rates.
fn motor_efforts<S: Scalar>(context: &EvalContext<S>) -> Vec<S> {
    let mut efforts = vec![S::zero(); context.layout.dof_count()];
    for hinge in context.chain.hinges.ids() {
        let range = context.layout.v[hinge].clone();
        if !range.is_empty() {
            efforts[range].copy_from_slice(&context.actuator_efforts(hinge));
        }
    }
    efforts
}

/// Returns `∂(ID − τ)/∂w` for a parameter.
fn by_parameter<S: Scalar>(context: &EvalContext<S>, axes: Axes, parameter: ParameterId) -> Vec<S> {
    let parameters = unit_vector(context.values.parameters.len(), parameter.index());
    let direction = Direction { parameters, ..Direction::default() };
    let tangent = Tangent::new(context, &direction);
    let dual = tangent.context(context);
    let required = inverse_dynamics(&dual, axes, &mut Trace::silent());
    let motors = motor_efforts(&dual);
    required.iter().zip(motors).map(|(&all, motor)| (all - motor).derivative()).collect()
}
