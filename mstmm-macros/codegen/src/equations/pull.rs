//! The gradient of forward dynamics, in O(n).
//!
//! With weights `y` and `z = M⁻¹ y`, the derivative of the weighted accelerations along any direction is
//!
//! ```text
//! yᵀ dv̇ = zᵀ (dτ − dID) = dP       P = zᵀ (τ − ID) at constant z and v̇
//! ```
//!
//! `P` is the virtual power that the drives supply beyond what the accelerations `v̇` need, for the virtual
//! rates `z`. It is zero at the solution; its gradient is that of the weighted accelerations.
//!
//! With the virtual motion `ζ` of a link's point, `ζ = X ζ_p + S z`, virtual power is a sum over the
//! links, which no wrench is passed on for:
//!
//! (1)  `P = Σ zᵀ (τ + τ_passive − H v̇) − ζᵀ (I a + p)`
//!
//! Differentiated in reverse, this sum needs a single sweep inward. In it the adjoint of `ζ` is the wrench
//! in the hinge.

use super::base_parameters::base_kinematics;
use super::hinge::{combine, dot};
use super::inverse_dynamics::{accelerations, own_efforts};
use super::kinematics::{HingeKinematics, LinkKinematics};
use super::loads::loads;
use super::sweep::PerLink;
use super::{Axes, EvalContext, Trace};
use crate::math::{Motion, Scalar};

/// Returns the virtual power `P` of an open chain for virtual rates `z`, at given accelerations: equation
/// (1).
pub fn virtual_power<S: Scalar>(context: &EvalContext<S>, z: &[S], axes: Axes) -> S {
    let trace = &mut Trace::silent();
    let links = base_kinematics(context, axes, trace);
    let external = loads(context, &links);
    let accelerations = accelerations(context, &links, context.base_acceleration(), trace);
    let virtual_motions = virtual_motions(context, &links, z);
    context.tree.total(S::zero(), |index, power| {
        let link = &links[index];
        let needed = link.spatial_inertia().times(accelerations[index]) + link.velocity_wrench()
            - external[index];
        power + hinge_power(context, &link.hinge, z) - virtual_motions[index].power(needed)
    })
}

/// Returns `ζ` of all links' points.
fn virtual_motions<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    z: &[S],
) -> PerLink<Motion<S>> {
    let (motions, _) = context.tree.outward(Motion::zero(), |link, parent| {
        let hinge = &links[link].hinge;
        let own = match context.layout.v[hinge.id].is_empty() {
            true => Motion::zero(),
            false => combine(hinge.subspace.iter(), &z[context.layout.v[hinge.id].clone()]),
        };
        (hinge.motion_from_parent(*parent) + own, ())
    });
    motions
}

/// Returns `zᵀ (τ + τ_passive − H v̇)` of a hinge; zero if its motion is prescribed.
fn hinge_power<S: Scalar>(context: &EvalContext<S>, hinge: &HingeKinematics<S>, z: &[S]) -> S {
    let Some(given) = context.given_accelerations(hinge.id) else { return S::zero() };
    let z = &z[context.layout.v[hinge.id].clone()];
    let motor = context.actuator_efforts(hinge.id);
    dot(z, &motor) + dot(z, &own_efforts(hinge, Some(given)))
}
