//! The derivative of forward dynamics along one direction, in O(n).
//!
//! With `ID(q, v, v̇)` of inverse dynamics, forward dynamics solves `ID(q, v, v̇) = τ`. Along a direction
//!
//! ```text
//! M dv̇ + dID = dτ        dID: at constant v̇
//! ```
//!
//! so `dv̇ = M⁻¹ (dτ − dID)`. The derivative of inverse dynamics follows from its equations on dual
//! numbers, the product with `M⁻¹` from the factors of forward dynamics.

use super::inverse_dynamics::inverse_dynamics;
use super::motion_problem::HingePivot;
use super::open_chain::OpenChain;
use super::tangent::{Direction, Tangent};
use super::{Axes, EvalContext, Trace};
use crate::ids::HingeId;
use crate::math::{Dual, Scalar};

/// The accelerations, and their derivative along a direction.
#[derive(Clone, Debug)]
pub struct PushedDynamics<S> {
    /// `v̇` of all free rates, in the layout's order.
    pub accelerations: Vec<S>,
    /// The derivative of `v̇`.
    pub change: Vec<S>,
    /// The pivots of forward dynamics.
    pub pivots: Vec<HingePivot<S>>,
}

/// Returns the accelerations of an open chain, and their derivative along a direction.
pub fn push<S: Scalar>(
    context: &EvalContext<S>,
    direction: &Direction<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> PushedDynamics<S> {
    let chain = OpenChain::new(context, axes, trace);
    let (accelerations, pivots) = chain.accelerations(trace);
    let mut held = context.clone();
    held.accelerations = Some(&accelerations);
    let missing = missing_efforts(&held, direction, axes);
    trace.section("change", "Efforts that a change of the accelerations needs", "");
    missing.iter().enumerate().for_each(|(k, &effort)| trace.number(format!("missing{k}"), effort));
    let (change, _) = chain.inverse_mass_matrix_times(&missing, trace);
    PushedDynamics { accelerations, change, pivots }
}

/// Returns `dτ − dID` along a direction at given accelerations: what the drives supply in addition, less
/// what the given accelerations need.
pub fn missing_efforts<S: Scalar>(
    context: &EvalContext<S>,
    direction: &Direction<S>,
    axes: Axes,
) -> Vec<S> {
    let tangent = Tangent::new(context, direction);
    let along = tangent.context(context);
    let needed = inverse_dynamics(&along, axes, &mut Trace::silent());
    let supplied = |hinge: HingeId| match along.layout.v[hinge].is_empty() {
        true => Vec::new(),
        false => along.actuator_efforts(hinge),
    };
    let supplied = along.chain.hinges.ids().into_iter().flat_map(supplied);
    let difference = |(supplied, needed): (Dual<S>, Dual<S>)| (supplied - needed).derivative();
    supplied.zip(needed).map(difference).collect()
}
