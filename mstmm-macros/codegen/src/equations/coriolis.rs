//! The Coriolis matrix `C(q, v)`, and its product with a vector.
//!
//! With the velocity `J_j` that a unit of rate `j` gives to a mass, and its time derivative `J̇_j` along the
//! motion,
//!
//! (1)  `C_ij = ∫ J_iᵀ J̇_j dm`
//!
//! Therefore `Ṁ = C + Cᵀ`, with the mass matrix `M = ∫ Jᵀ J dm`, and `Ṁ − 2 C` is skew-symmetric along all
//! motions. If nothing is prescribed, the acceleration of a mass at constant rates is `J̇ v`; thus `C v` are
//! the efforts that Coriolis and centrifugal forces require.
//!
//! # Notation
//!
//! All quantities of a link belong to its point, in its work axes. Time derivatives are those in axes that do
//! not rotate, also where the components are in work axes.
//!
//! | symbol | in code | meaning |
//! |---|---|---|
//! | `S = [s_v; s_ω]`, `Ṡ` | `subspace`, `subspace_rates()` | motion subspace of a hinge, and its time derivative |
//! | `[y; w]`, `[ẏ; ẇ]` | [`VelocityField`] | velocity of a link's point and angular velocity that the vector `x`, taken as rates, gives to the link; and their time derivatives |
//! | `u` | `point_velocity()` | velocity of a link's point relative to its parent's |
//!
//! # Equations
//!
//! A rate moves a mass at `r` outboard of its hinge by `s_v + s_ω × r`. The time derivative is a field of
//! [`acceleration_field`](super::acceleration_field) with `δa = ṡ_v`, `β = ṡ_ω` and `2 δΩ = s_ω`:
//!
//! (2)  `J̇_j = ṡ_v + ṡ_ω × r + s_ω × ṙ`
//!
//! The product with a vector is a sweep outward
//!
//! (3)  `[y; w] = X [y_p; w_p] + S x`, `[ẏ; ẇ] = X [ẏ_p; ẇ_p] + [w_p × u; 0] + Ṡ x`
//!
//! and the wrenches of the field `ẏ + ẇ × r + w × ṙ` inward. Rotors move along strains at the rates `J v`, and
//! add `Jᵀ R J̇` for their inertias `R`, which vanishes unless the strains of a hinge depend on its
//! coordinates. Base parameters change no integral over the masses, so they change no entry.

use super::acceleration_field::{AccelerationField, EffortGradients, set_inboard_efforts};
use super::base_parameters::base_kinematics;
use super::composite::{composite_bodies, entries_of_product};
use super::dense_matrix::DenseMatrix;
use super::hinge::{combine, rotor_coriolis};
use super::inverse_dynamics::{hinge_wrenches, with_efforts_of_hinges};
use super::kinematics::{HingeKinematics, LinkKinematics};
use super::loop_hinge::loop_hinge;
use super::sweep::Flatten;
use super::{Axes, EvalContext, Trace};
use crate::math::{Motion, Scalar, Wrench};

/// The velocity of a link that a vector gives, and its time derivative.
#[derive(Clone, Copy, Debug)]
struct VelocityField<S> {
    /// `[y; w]`
    velocity: Motion<S>,
    /// `[ẏ; ẇ]`
    derivative: Motion<S>,
}

impl<S: Scalar> VelocityField<S> {
    /// Returns the field of a link from that of its parent and from the entries of the vector for its hinge,
    /// equation (3).
    fn outboard_of(self, hinge: &HingeKinematics<S>, x: &[S]) -> Self {
        let VelocityField { velocity, derivative } = self;
        let Motion { linear, angular } = derivative.shifted_to(hinge.arm);
        let linear = linear + velocity.angular.cross(hinge.point_velocity());
        let carried = Motion { linear, angular }.rotated_back(&hinge.to_parent);
        VelocityField {
            velocity: hinge.motion_from_parent(velocity) + combine(hinge.subspace.iter(), x),
            derivative: carried + combine(hinge.subspace_rates().iter(), x),
        }
    }

    /// Returns the wrench that the field requires of a link's own part.
    fn wrench(&self, link: &LinkKinematics<S>) -> Wrench<S> {
        let rotating = link.rigid_inertia().coriolis_wrench(link.omega, self.velocity.angular);
        link.spatial_inertia().times(self.derivative) + rotating
    }
}

impl<S: Scalar> Flatten<S> for VelocityField<S> {
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self {
        let velocity = self.velocity.visit(replace);
        VelocityField { velocity, derivative: self.derivative.visit(replace) }
    }
}

/// Returns the product of the Coriolis matrix with the given accelerations of `context`, which may be any
/// vector. A closed chain is treated as its tree, with the loop hinge open.
pub fn coriolis_matrix_times<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> Vec<S> {
    let links = base_kinematics(context, axes, trace);
    let closed = loop_hinge(context, axes, &links);
    let given = |hinge: &HingeKinematics<S>| context.factors(hinge.id);
    let ground = VelocityField { velocity: Motion::zero(), derivative: Motion::zero() };
    let (fields, _) = context.tree.outward(ground, |link, parent| {
        let hinge = &links[link].hinge;
        (parent.outboard_of(hinge, given(hinge)), ())
    });
    let wrenches = links.iter().zip(&fields).map(|(link, field)| field.wrench(link)).collect();
    let wrenches = hinge_wrenches(context, &links, wrenches, trace);
    let rotors = |hinge: &HingeKinematics<S>| of_rotors(context, hinge, given(hinge));
    with_efforts_of_hinges(context, (&links, closed), &wrenches, rotors)
}

/// Returns the Coriolis matrix, with one row and column for each free rate. The chain must be written out. A
/// closed chain is treated as its tree, with the loop hinge open.
pub fn coriolis_matrix<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> DenseMatrix<S> {
    let links = base_kinematics(context, axes, trace);
    let closed = loop_hinge(context, axes, &links);
    let bodies = composite_bodies(context, &links, trace);
    let gradients = EffortGradients::new(context, &links, &bodies, trace);
    let count = context.layout.dof_count();
    let mut matrix = DenseMatrix::zero(count, count);
    links.enumerate().for_each(|(index, LinkKinematics { hinge, .. })| {
        trace.section(
            format!("{}_coriolis", hinge.name),
            format!("Columns of the Coriolis matrix for `{}`", hinge.name),
            "",
        );
        let rates = hinge.subspace_rates();
        let own = context.layout.v[hinge.id].clone();
        for ((column, motion), &rate) in own.zip(&hinge.subspace).zip(&rates) {
            let omega = motion.angular * S::number(0.5);
            let field = AccelerationField { motion: rate, omega };
            let mut efforts = vec![S::zero(); count];
            gradients.set_outboard(index, &field, &mut efforts);
            let wrench = field.wrench(&bodies[index]);
            trace.wrench(&format!("coriolis{column}"), wrench);
            set_inboard_efforts(context, &links, (index, wrench), &mut efforts);
            matrix.set_column(column, &efforts);
        }
        add_rotors(context, hinge, &mut matrix);
    });
    if let Some(closed) = closed {
        add_rotors(context, &closed.hinge, &mut matrix);
    }
    matrix
}

/// Adds the rotors of a hinge to the matrix.
fn add_rotors<S: Scalar>(
    context: &EvalContext<S>,
    hinge: &HingeKinematics<S>,
    matrix: &mut DenseMatrix<S>,
) {
    let range = context.layout.v[hinge.id].clone();
    for (row, column, effort) in entries_of_product(range, |unit| of_rotors(context, hinge, unit)) {
        let sum = matrix.at(row, column) + effort;
        matrix.set(row, column, sum);
    }
}

/// Returns the part of the product that is due to the rotors of a hinge.
fn of_rotors<S: Scalar>(context: &EvalContext<S>, hinge: &HingeKinematics<S>, x: &[S]) -> Vec<S> {
    let kind = &context.chain.hinges[hinge.id].kind;
    let state = (context.coordinates(hinge.id), context.rates(hinge.id));
    rotor_coriolis(kind, &hinge.passives, state, x)
}
