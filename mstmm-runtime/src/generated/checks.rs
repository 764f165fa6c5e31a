//! Checks of arguments and results. If one fails, its cause is found.

use core::convert::identity;

use crate::origin::{self, Origin};
use crate::{Described, Error, Mask, Scalar};

/// The number of units in the last place of its scale that a pivot must exceed to count as positive.
///
/// A pivot that is zero in exact arithmetic is computed as the difference of a few rounded products of that size.
pub const PIVOT_ULPS: f64 = 8.0;

/// The largest number of values that [`pivots_ok`] adds one after the other, in the order in which they are computed.
///
/// More values are mostly entries of a matrix, which are computed at about the same time: a single sum would then wait for
/// each addition. A processor holds about as many instructions as a call of a short function has, so that the next call
/// waits too. For the mass matrix of a quadruped with 18 rates a single sum took a third of the time, for the Jacobian of three
/// balls, with 27 values, a fifth.
const MAX_SEQUENTIAL: usize = 12;

/// Returns whether all pivots are positive beyond rounding and all values are finite.
///
/// A sum of the values that overflows counts as not finite. The value that is computed last should come last.
#[inline(always)]
pub fn pivots_ok<T: Scalar, const P: usize, const N: usize>(
    pivots: [T; P],
    scales: [T; P],
    values: [T; N],
) -> bool {
    let rounding = T::epsilon() * T::constant(PIVOT_ULPS);
    // The last two values are known at about the same time, with nothing else left to compute: they are added
    // first, so that only one addition to the sum of the others follows.
    let (first, last) = values.split_at(N.saturating_sub(2));
    let sum = |values: &[T]| values.iter().copied().reduce(|sum, value| sum + value);
    let (chunks, first) =
        if N > MAX_SEQUENTIAL { first.as_chunks::<8>() } else { (&[][..], first) };
    let partial = chunks.iter().copied().reduce(|mut sums, chunk| {
        sums.iter_mut().zip(chunk).for_each(|(sum, value)| *sum += value);
        sums
    });
    let sum = match (sum(first), sum(last)) {
        (Some(first), Some(last)) => first + last,
        (first, last) => first.or(last).unwrap_or(T::constant(0.0)),
    };
    let sum = match partial {
        Some([a, b, c, d, e, f, g, h]) => sum + (((a + b) + (c + d)) + ((e + f) + (g + h))),
        None => sum,
    };
    let mut ok = sum.is_finite();
    for (pivot, scale) in pivots.into_iter().zip(scales) {
        ok = ok & pivot.simd_gt(rounding * scale);
    }
    ok.all()
}

/// Returns whether the sum of the squares of all values is less than `square`, and so each of them less than its root.
///
/// It is false for dual numbers: bounds of their values say nothing about their derivatives.
#[inline(always)]
pub fn are_below<T: Scalar, const N: usize>(values: [T; N], square: f64) -> bool {
    if T::DERIVATIVE_ORDER > 0 {
        return false;
    }
    let mut sums = [T::constant(0.0); 4];
    for (number, value) in values.into_iter().enumerate() {
        if let Some(sum) = sums.get_mut(number % 4) {
            *sum = value.mul_add(value, *sum);
        }
    }
    let [a, b, c, d] = sums;
    T::constant(square).simd_gt((a + b) + (c + d)).all()
}

/// Returns the error if [`pivots_ok`] is false: the first hinge whose pivot vanishes, or a value that is not finite.
///
/// It is a separate function so that the compiler sees that only an error follows.
#[inline(always)]
pub fn pivot_error<C: Described, const P: usize>(
    hinges: &[&'static str; P],
    pivots: [C::Scalar; P],
    scales: [C::Scalar; P],
    state: &C::State,
    inputs: &C::Inputs,
) -> Error {
    // Copies: without them the arrays would be in memory even if there is no error.
    match singular_hinge(hinges, &pivots.map(identity), &scales.map(identity)) {
        Some(hinge) => Error::Singular { hinge },
        None => not_finite::<C>(state, inputs),
    }
}

/// Fails if one of these values, or their sum, is NaN or infinite: values of the state, of the inputs or of results.
///
/// The result of a chain need not depend on all of its inputs, so they are checked before it is computed.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn check_finite<C: Described, T: Scalar>(
    slices: &[&[T]],
    state: &C::State,
    inputs: &C::Inputs,
) -> Result<(), Error> {
    if T::sum(slices).is_finite().all() { Ok(()) } else { Err(not_finite::<C>(state, inputs)) }
}

/// Fails as [`check_finite`] does, for a slice that may be long.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn check_finite_slice<C: Described, T: Scalar>(
    values: &[T],
    state: &C::State,
    inputs: &C::Inputs,
) -> Result<(), Error> {
    if is_finite_slice(values) { Ok(()) } else { Err(not_finite::<C>(state, inputs)) }
}

/// Fails as [`check_finite`] does, for stored results of which some may not be finite.
///
/// # Errors
/// [`Error::NotFinite`].
#[cold]
#[inline(never)]
pub fn check_stored<C: Described, T: Scalar>(
    values: &[T],
    state: &C::State,
    inputs: &C::Inputs,
) -> Result<(), Error> {
    check_finite_slice::<C, T>(values, state, inputs)
}

/// Fails if an entry of an argument other than state and inputs, or the sum of all entries, is NaN or infinite.
///
/// # Errors
/// [`Error::NotFinite`].
#[inline]
pub fn check_argument<T: Scalar>(name: &'static str, values: &[T]) -> Result<(), Error> {
    if is_finite_slice(values) { Ok(()) } else { Err(argument_not_finite(name, values)) }
}

/// Returns whether all values and their sum are finite.
///
/// It adds up 16 partial sums: a single one would take as long as computing the chain.
#[inline]
fn is_finite_slice<T: Scalar>(values: &[T]) -> bool {
    let (chunks, rest) = values.as_chunks::<16>();
    let mut sums = [T::constant(0.0); 16];
    for chunk in chunks {
        for (sum, &value) in sums.iter_mut().zip(chunk) {
            *sum += value;
        }
    }
    T::sum(&[&sums, rest]).is_finite().all()
}

/// Returns the error for results that are not finite: the value of the state or of the inputs that caused it.
#[cold]
#[inline(never)]
pub(super) fn not_finite<C: Described>(state: &C::State, inputs: &C::Inputs) -> Error {
    Error::NotFinite(C::not_finite(state, inputs).unwrap_or(Origin::Result))
}

/// Returns the error for results that are not finite: the entry of an argument if state and inputs have no such value.
#[cold]
#[inline(never)]
pub fn or_argument<T: Scalar>(error: Error, name: &'static str, values: &[T]) -> Error {
    match error {
        Error::NotFinite(Origin::Result) => argument_not_finite(name, values),
        other => other,
    }
}

#[cold]
#[inline(never)]
fn argument_not_finite<T: Scalar>(name: &'static str, values: &[T]) -> Error {
    Error::NotFinite(origin::of_argument(name, values))
}

/// Returns the first hinge whose pivot vanishes; `None` if a value is not finite instead.
#[cold]
#[inline(never)]
fn singular_hinge<T: Scalar>(
    hinges: &[&'static str],
    pivots: &[T],
    scales: &[T],
) -> Option<&'static str> {
    let rounding = T::epsilon() * T::constant(PIVOT_ULPS);
    for ((&hinge, &pivot), &scale) in hinges.iter().zip(pivots).zip(scales) {
        // A state that is too large does not make a hinge singular.
        if (pivot.is_finite() & scale.is_finite()).all() && !pivot.simd_gt(rounding * scale).all() {
            return Some(hinge);
        }
    }
    None
}
