//! Strains: the measures of deformation that springs act on, and how the rates of a hinge change
//! them.

use super::rows::{dot, identity};
use crate::math::Scalar;

/// The map from rates to strain rates, `ṡ = J v`.
#[derive(Clone, Debug)]
pub struct StrainMap<S> {
    /// `J`, by rows.
    pub jacobian: Vec<Vec<S>>,
    /// `J⁻¹`, by rows.
    pub inverse: Vec<Vec<S>>,
    /// Whether `J` is the same for all coordinates.
    pub is_constant: bool,
}

impl<S: Scalar> StrainMap<S> {
    /// The map of strains whose rates are the rates of the hinge, `J = 1`.
    pub fn identity(count: usize) -> Self {
        let (jacobian, inverse) = identity(count);
        StrainMap { jacobian, inverse, is_constant: true }
    }

    /// A map that depends on the coordinates.
    pub fn new(jacobian: Vec<Vec<S>>, inverse: Vec<Vec<S>>) -> Self {
        StrainMap { jacobian, inverse, is_constant: false }
    }
}

/// Returns `J v`.
pub fn times<S: Scalar>(jacobian: &[Vec<S>], v: &[S]) -> Vec<S> {
    jacobian.iter().map(|row| dot(row, v)).collect()
}

/// Returns `Jᵀ σ`: efforts along the rates, from efforts along the strains.
pub fn transpose_times<S: Scalar>(jacobian: &[Vec<S>], along: &[S]) -> Vec<S> {
    let column = |j: usize| jacobian.iter().map(|row| row[j]).collect::<Vec<S>>();
    (0..jacobian.len()).map(|j| dot(&column(j), along)).collect()
}
