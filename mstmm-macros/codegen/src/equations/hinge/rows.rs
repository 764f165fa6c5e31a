//! Small dense matrices by rows, one row for each rate of a hinge.

use crate::math::Scalar;

/// Returns the identity and its inverse.
pub fn identity<S: Scalar>(count: usize) -> (Vec<Vec<S>>, Vec<Vec<S>>) {
    let entry = |on| if on { S::one() } else { S::zero() };
    let rows: Vec<Vec<S>> =
        (0..count).map(|i| (0..count).map(|j| entry(i == j)).collect()).collect();
    (rows.clone(), rows)
}

/// Returns `Σ a b`.
pub fn dot<S: Scalar>(a: &[S], b: &[S]) -> S {
    a.iter().zip(b).fold(S::zero(), |sum, (&a, &b)| sum + a * b)
}
