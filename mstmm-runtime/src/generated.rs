//! What generated code calls besides the public items: the parts of it that are the same for every chain.
//!
//! Not for use by hand; it may change with every version.

use crate::{Error, Mask, Scalar};

/// How many units in the last place of its scale a pivot must exceed to count as positive: a pivot that should vanish is
/// the difference of a few rounded products of that size.
const NOISE: f64 = 8.0;

/// Whether all pivots are positive beyond rounding, and all results finite.
#[inline]
fn is_regular<T: Scalar, const P: usize, const N: usize>(
    pivots: [T; P],
    scales: [T; P],
    results: [T; N],
) -> bool {
    let noise = T::epsilon() * T::constant(NOISE);
    let mut regular = T::Mask::splat(true);
    for (pivot, scale) in pivots.into_iter().zip(scales) {
        regular = regular & pivot.greater(noise * scale);
    }
    results.into_iter().fold(regular, |all, result| all & result.finite()).all()
}

/// Fails if any of the numbers is NaN or infinite. What a chain computes need not depend on all of them.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn finite<T: Scalar>(numbers: &[&[T]]) -> Result<(), Error> {
    let all = numbers.iter().copied().flatten();
    if all.fold(T::Mask::splat(true), |all, number| all & number.finite()).all() {
        Ok(())
    } else {
        Err(Error::NotFinite)
    }
}

/// Fails with the name of the first hinge whose pivot vanishes, or because something is not finite.
///
/// # Errors
/// [`Error::Singular`], [`Error::NotFinite`].
#[inline]
pub fn regular<T: Scalar, const P: usize, const N: usize>(
    hinges: &[&'static str; P],
    pivots: [T; P],
    scales: [T; P],
    results: [T; N],
) -> Result<(), Error> {
    if is_regular(pivots, scales, results) {
        Ok(())
    } else {
        Err(diagnosis(hinges, pivots, scales))
    }
}

/// Why a chain has no accelerations.
#[cold]
fn diagnosis<T: Scalar, const P: usize>(
    hinges: &[&'static str; P],
    pivots: [T; P],
    scales: [T; P],
) -> Error {
    let noise = T::epsilon() * T::constant(NOISE);
    for ((&hinge, pivot), scale) in hinges.iter().zip(pivots).zip(scales) {
        if pivot.finite().all() && !pivot.greater(noise * scale).all() {
            return Error::Singular { hinge };
        }
    }
    Error::NotFinite
}

/// Whether a parameter may be set: to a finite number that leaves everything derived from it finite and all masses
/// positive.
///
/// # Errors
/// [`Error::Parameter`] with the reason that belongs to the first mass that is not positive.
#[cold]
pub fn check_parameter<T: Scalar>(
    name: &'static str,
    value: T,
    derived: &[T],
    masses: &[T],
    reasons: &[&'static str],
) -> Result<(), Error> {
    if !value.finite().all() {
        return Err(Error::Parameter { name, reason: "must be a finite number" });
    }
    if finite(&[derived]).is_err() {
        return Err(Error::Parameter {
            name,
            reason: "must leave all quantities derived from it finite",
        });
    }
    for (mass, &reason) in masses.iter().zip(reasons) {
        if !(mass.greater(T::constant(0.0)) & mass.finite()).all() {
            return Err(Error::Parameter { name, reason });
        }
    }
    Ok(())
}

/// Square root of a number in a chain's description.
pub fn sqrt(value: f64) -> f64 {
    Scalar::sqrt(value)
}

/// Sine of an angle in rad in a chain's description.
pub fn sin(value: f64) -> f64 {
    let ([sine], _) = <f64 as Scalar>::sin_cos([value]);
    sine
}

/// Cosine of an angle in rad in a chain's description.
pub fn cos(value: f64) -> f64 {
    let (_, [cosine]) = <f64 as Scalar>::sin_cos([value]);
    cosine
}

/// A vector of nalgebra's from its entries.
#[inline]
pub fn vector<T: Scalar, const N: usize>(entries: [T; N]) -> nalgebra::SVector<T, N> {
    nalgebra::SVector::from(entries)
}
