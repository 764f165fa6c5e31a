//! Constraint forces that do not change the motion: equation (4) of [`super`].

use super::super::hinge::dot;
use super::factorization::{FactorStep, RemainingRows};
use super::{plus_scaled, project_out};
use crate::math::Scalar;

/// Returns the null directions of equation (4), one for each row; zero if the pivot of its step is
/// not a rounding error.
pub(super) fn null_directions<S: Scalar>(
    pivots: &[FactorStep<S>],
    left: RemainingRows<S>,
) -> Vec<Vec<S>> {
    let mut directions = Vec::new();
    for (k, pivot) in pivots.iter().enumerate() {
        let is_rounding = S::one() - pivot.pivot * pivot.inverse;
        let start = pivot.selector.iter().map(|&x| x * is_rounding).collect();
        directions.push(null_direction(&pivots[..k], start));
    }
    let mut unused: Vec<S> = left.candidates.iter().map(|&row| left.unused[row]).collect();
    for _ in pivots.len()..unused.len() {
        let first = first(&unused);
        unused = plus_scaled(unused, &first, -S::one());
        directions.push(null_direction(pivots, left.scatter(first)));
    }
    let count = left.unused.len();
    for row in (0..count).filter(|row| !left.candidates.contains(row)) {
        let entry = |k| if k == row { S::one() } else { S::zero() };
        directions.push((0..count).map(entry).collect());
    }
    directions
}

/// Returns `start` plus the combination of selected rows for which `l_kᵀ x = 0`.
fn null_direction<S: Scalar>(pivots: &[FactorStep<S>], start: Vec<S>) -> Vec<S> {
    pivots.iter().rev().fold(start, |x, pivot| {
        let step = -dot(&pivot.column, &x);
        plus_scaled(x, &pivot.selector, step)
    })
}

/// Returns the first weight that is one, of weights that are zero or one.
fn first<S: Scalar>(weights: &[S]) -> Vec<S> {
    let mut found = S::zero();
    let selected = |&weight: &S| {
        let first = weight * (S::one() - found);
        found = found + first;
        first
    };
    weights.iter().map(selected).collect()
}

/// Returns the directions orthonormalised; zero stays zero.
pub(super) fn orthonormal<S: Scalar>(directions: Vec<Vec<S>>) -> Vec<Vec<S>> {
    let mut units: Vec<Vec<S>> = Vec::new();
    for direction in directions {
        let rest = units.iter().fold(direction, |x, unit| project_out(x, unit));
        let length = dot(&rest, &rest).recip_above(S::one()).sqrt();
        units.push(rest.iter().map(|&x| x * length).collect());
    }
    units
}
