//! Strain rates: how the rates of a hinge change the measures that its springs act on.

use super::rows::{dot, identity};
use crate::math::Scalar;

/// How rates become strain rates.
#[derive(Clone, Debug)]
pub struct StrainMap<S> {
    /// `J` of `ṡ = J v`, by rows.
    pub rows: Vec<Vec<S>>,
    /// `J⁻¹`, by rows.
    pub inverse: Vec<Vec<S>>,
    /// Whether `J` is the same at all coordinates.
    pub is_constant: bool,
}

impl<S: Scalar> StrainMap<S> {
    /// Strains that change by so many rates, `J = 1`.
    pub fn change_by_rates(count: usize) -> Self {
        let (rows, inverse) = identity(count);
        StrainMap { rows, inverse, is_constant: true }
    }

    /// By `J` and `J⁻¹`, which depend on the coordinates.
    pub fn of(rows: Vec<Vec<S>>, inverse: Vec<Vec<S>>) -> Self {
        StrainMap { rows, inverse, is_constant: false }
    }
}

/// `ṡ = J v`
pub fn rates<S: Scalar>(rows: &[Vec<S>], v: &[S]) -> Vec<S> {
    rows.iter().map(|row| dot(row, v)).collect()
}

/// `Jᵀ σ`: efforts along the rates from those along the strains.
pub fn returned<S: Scalar>(rows: &[Vec<S>], along: &[S]) -> Vec<S> {
    let column = |j: usize| rows.iter().map(|row| row[j]).collect::<Vec<S>>();
    (0..rows.len()).map(|j| dot(&column(j), along)).collect()
}
