//! Strain rates: how the rates of a hinge change the measures that its springs act on.

use super::rows::{dot, identity};
use crate::math::Scalar;

/// How rates become strain rates.
#[derive(Clone, Debug)]
pub struct StrainMap<S> {
    /// `J` of `ṡ = J v`, by rows.
    pub jacobian: Vec<Vec<S>>,
    /// `J⁻¹`, by rows.
    pub inverse: Vec<Vec<S>>,
    /// Whether `J` is the same at all coordinates.
    pub is_constant: bool,
}

impl<S: Scalar> StrainMap<S> {
    /// Strains that change by so many rates, `J = 1`.
    pub fn identity(count: usize) -> Self {
        let (jacobian, inverse) = identity(count);
        StrainMap { jacobian, inverse, is_constant: true }
    }

    /// By `J` and `J⁻¹`, which depend on the coordinates.
    pub fn new(jacobian: Vec<Vec<S>>, inverse: Vec<Vec<S>>) -> Self {
        StrainMap { jacobian, inverse, is_constant: false }
    }
}

/// `ṡ = J v`
pub fn times<S: Scalar>(jacobian: &[Vec<S>], v: &[S]) -> Vec<S> {
    jacobian.iter().map(|row| dot(row, v)).collect()
}

/// `Jᵀ σ`: efforts along the rates from those along the strains.
pub fn transpose_times<S: Scalar>(jacobian: &[Vec<S>], along: &[S]) -> Vec<S> {
    let column = |j: usize| jacobian.iter().map(|row| row[j]).collect::<Vec<S>>();
    (0..jacobian.len()).map(|j| dot(&column(j), along)).collect()
}
