//! The inverse of the mass matrix of an open chain, by its factors.
//!
//! The rates are eliminated from the free ends to the ground, so that zeros of pairs on different branches
//! stay zero (R. Featherstone, *Rigid Body Dynamics Algorithms*, section 6.5). With the rates ordered from
//! the ground outward:
//!
//! (1)  `M = Lᵀ D L`, with `L` unit lower triangular
//! (2)  `L M⁻¹ = D⁻¹ L⁻ᵀ`, which is zero below its diagonal `D⁻¹`
//!
//! Each `D` is the pivot of the Riccati transfer. From (2) follow the rows of `M⁻¹` from the ground outward.

use super::EvalContext;
use super::composite::{mass_matrix, outward_rates};
use super::dense_matrix::DenseMatrix;
use super::motion_problem::HingePivot;
use super::open_chain::OpenChain;
use super::strategy::factorizes_mass_matrix;
use super::{Axes, Trace};
use crate::math::Scalar;
use crate::model::{Layout, LinkId};

/// Returns `M⁻¹` of an open chain, with the pivots.
pub fn inverse_mass_matrix<S: Scalar>(
    context: &EvalContext<S>,
    axes: Axes,
    trace: &mut Trace<S>,
) -> (DenseMatrix<S>, Vec<HingePivot<S>>) {
    if factorizes_mass_matrix(context.layout) {
        let matrix = mass_matrix(context, axes, trace);
        return inverse(context.layout, matrix, trace);
    }
    OpenChain::new(context, axes, trace).inverse_mass_matrix(trace)
}

/// Returns the inverse of a mass matrix by equations (1) and (2), with the pivots.
pub(super) fn inverse<S: Scalar>(
    layout: &Layout,
    mut matrix: DenseMatrix<S>,
    trace: &mut Trace<S>,
) -> (DenseMatrix<S>, Vec<HingePivot<S>>) {
    let rates = outward_rates(layout);
    trace.section("inverse", "Inverse of the mass matrix by its factors", "");
    let scales: Vec<S> = (0..rates.len()).map(|k| matrix.at(k, k)).collect();
    let (mut pivots, mut divided) = (Vec::new(), Vec::new());
    for (number, &(link, k)) in rates.iter().enumerate().rev() {
        let inner = &rates[..number];
        let reciprocal = matrix.at(k, k).recip();
        trace.number(format!("pivot{k}"), matrix.at(k, k));
        pivots.push(HingePivot { link, value: matrix.at(k, k), scale: scales[k] });
        let factors: Vec<S> = inner.iter().map(|&(_, i)| matrix.at(k, i) * reciprocal).collect();
        for (position, &(_, i)) in inner.iter().enumerate() {
            for &(_, j) in &inner[..=position] {
                let value = matrix.at(i, j) - factors[position] * matrix.at(k, j);
                matrix.set(i, j, value);
                matrix.set(j, i, value);
            }
        }
        divided.push((reciprocal, factors));
    }
    divided.reverse();
    pivots.reverse();
    (outward_rows(&rates, &divided, trace), pivots)
}

/// Returns the inverse by equation (2), from the reciprocal pivots and the rows of `L`.
fn outward_rows<S: Scalar>(
    rates: &[(LinkId, usize)],
    divided: &[(S, Vec<S>)],
    trace: &mut Trace<S>,
) -> DenseMatrix<S> {
    let mut inverse = DenseMatrix::zero(rates.len(), rates.len());
    for (number, (&(_, i), (reciprocal, factors))) in rates.iter().zip(divided).enumerate() {
        for &(_, j) in &rates[..=number] {
            let start = if i == j { *reciprocal } else { S::zero() };
            let terms = rates[..number].iter().zip(factors);
            let entry =
                terms.fold(start, |sum, (&(_, k), &factor)| sum - factor * inverse.at(k, j));
            trace.number(format!("inverse{i}_{j}"), entry);
            inverse.set(i, j, entry);
            inverse.set(j, i, entry);
        }
    }
    inverse
}
