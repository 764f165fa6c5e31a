//! Fields of accelerations that all bodies outboard of a hinge have in common, and the efforts that they
//! require.
//!
//! # Notation
//!
//! All quantities of a link belong to its point, in its work axes; those of composite bodies are in
//! [`composite`](super::composite).
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `δa`, `β`, `δΩ` | [`AccelerationField`] | the three vectors of a field, for the point of a link |
//! | `w_a`, `w_β`, `w_ω` | [`EffortGradient`] | derivatives of an effort with respect to `δa`, `β` and `δΩ` of a link |
//!
//! # Equations
//!
//! The field at a mass at `r`, and the wrench in the hinge that gives it to all masses:
//!
//! (1)  `δr̈ = δa + β × r + 2 δΩ × ṙ`
//! (2)  `δF = [m δa + β × h + 2 δΩ × P; h × δa + J β + B δΩ]`
//!
//! The effort of a hinge further outboard, with motion subspace `[s_v; s_ω]`, at that hinge and inward:
//!
//! (3)  `w_a = m s_v + s_ω × h`, `w_β = h × s_v + J s_ω`, `w_ω = 2 P × s_v + Bᵀ s_ω`
//! (4)  `w_β ← w_β + arm × w_a`, `w_ω ← w_ω + 2 u × w_a`
//!
//! `w_a` and `w_β` are also a column of the mass matrix.

use super::composite::{CompositeBody, to_ground, twice_velocity};
use super::kinematics::{HingeKinematics, LinkKinematics};
use super::sweep::PerLink;
use super::{EvalContext, Trace};
use crate::ids::LinkId;
use crate::math::{Motion, Scalar, Vec3, Wrench};

/// A field of accelerations of all bodies outboard of a hinge, equation (1).
#[derive(Clone, Copy, Debug)]
pub(super) struct AccelerationField<S> {
    /// `δa` and `β`.
    pub motion: Motion<S>,
    /// `δΩ`
    pub omega: Vec3<S>,
}

impl<S: Scalar> AccelerationField<S> {
    /// Returns the wrench in the hinge of a composite body, equation (2).
    pub fn wrench(&self, body: &CompositeBody<S>) -> Wrench<S> {
        let Wrench { force, moment } = body.wrench(self.motion);
        Wrench {
            force: force + self.omega.cross(body.twice_momentum),
            moment: moment + body.spin * self.omega,
        }
    }
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

    /// Returns the effort that a field requires.
    fn effort(&self, field: &AccelerationField<S>) -> S {
        field.motion.power(self.wrench) + field.omega.dot(self.omega)
    }
}

/// The gradients of the efforts of all hinges, each by its rate.
#[derive(Debug)]
pub(super) struct EffortGradients<S> {
    /// Of all hinges outboard of each link's hinge.
    outboard: PerLink<Vec<(usize, EffortGradient<S>)>>,
    /// Of all hinges, for a field of the ground.
    on_ground: Vec<(usize, EffortGradient<S>)>,
}

impl<S: Scalar> EffortGradients<S> {
    /// Returns the gradients of a chain, which must be written out.
    pub fn new(
        context: &EvalContext<S>,
        links: &PerLink<LinkKinematics<S>>,
        bodies: &PerLink<CompositeBody<S>>,
        trace: &mut Trace<S>,
    ) -> Self {
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
        EffortGradients { outboard, on_ground }
    }

    /// Sets the efforts of all hinges outboard of a link's hinge to those that a field at the link requires.
    pub fn set_outboard(&self, link: LinkId, field: &AccelerationField<S>, efforts: &mut [S]) {
        for (row, gradient) in &self.outboard[link] {
            efforts[*row] = gradient.effort(field);
        }
    }

    /// Sets the efforts of all hinges to those that a field of the ground requires.
    pub fn set_all(&self, field: &AccelerationField<S>, efforts: &mut [S]) {
        for (row, gradient) in &self.on_ground {
            efforts[*row] = gradient.effort(field);
        }
    }
}

/// Sets the efforts of a link's hinge and of all hinges inboard of it, from the wrench in the link's hinge.
pub(super) fn set_inboard_efforts<S: Scalar>(
    context: &EvalContext<S>,
    links: &PerLink<LinkKinematics<S>>,
    (from, wrench): (LinkId, Wrench<S>),
    efforts: &mut [S],
) {
    let visit = |at: LinkId, wrench: &Wrench<S>| {
        let LinkKinematics { hinge, .. } = &links[at];
        for (row, s) in context.layout.v[hinge.id].clone().zip(&hinge.subspace) {
            efforts[row] = s.power(*wrench);
        }
    };
    let inward = |at: LinkId, wrench| links[at].hinge.wrench_to_parent(wrench);
    to_ground(context, from, wrench, visit, inward);
}
