//! Arithmetic on whole states, entry by entry in place: states may be large and are never copied to the stack.

use crate::description::origin;
use crate::origin::Origin;
use crate::{ChainState, Error, Mask, Scalar};

/// Changes each coordinate and each rate of `state` by the same entry of `other`.
#[inline(always)]
fn change<S: ChainState>(state: &mut S, other: &S, change: impl Fn(&mut S::Scalar, S::Scalar)) {
    state
        .coordinates_mut()
        .iter_mut()
        .zip(other.coordinates())
        .for_each(|(entry, &other)| change(entry, other));
    state
        .rates_mut()
        .iter_mut()
        .zip(other.rates())
        .for_each(|(entry, &other)| change(entry, other));
}

/// `to` = `from`, with its time.
pub(super) fn copy<S: ChainState>(to: &mut S, from: &S) {
    change(to, from, |entry, other| *entry = other);
    to.set_time(from.time());
}

/// `sum` += weight · `rate`; the time is unchanged.
pub(super) fn add_scaled<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    change(sum, rate, |entry, other| *entry = weight.mul_add(other, *entry));
}

/// `to` = `from` + factor · `rate`; the time is unchanged.
pub(crate) fn sum_scaled<S: ChainState>(to: &mut S, from: &S, factor: S::Scalar, rate: &S) {
    let sum = |((to, &from), &rate): ((&mut S::Scalar, &S::Scalar), &S::Scalar)| {
        *to = factor.mul_add(rate, from);
    };
    to.coordinates_mut().iter_mut().zip(from.coordinates()).zip(rate.coordinates()).for_each(sum);
    to.rates_mut().iter_mut().zip(from.rates()).zip(rate.rates()).for_each(sum);
}

/// The coordinates of `sum` += weight · those of `rate`; all else is unchanged.
pub(super) fn add_scaled_coordinates<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    sum.coordinates_mut()
        .iter_mut()
        .zip(rate.coordinates())
        .for_each(|(entry, &other)| *entry = weight.mul_add(other, *entry));
}

/// The rates of `sum` += weight · those of `rate`; all else is unchanged.
pub(super) fn add_scaled_rates<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    sum.rates_mut()
        .iter_mut()
        .zip(rate.rates())
        .for_each(|(entry, &other)| *entry = weight.mul_add(other, *entry));
}

/// `sum` = Σ weight · rate; the time is unchanged.
#[inline(always)]
pub(super) fn weighted_sum<S: ChainState, const N: usize>(
    sum: &mut S,
    weights: [S::Scalar; N],
    rates: [&S; N],
) {
    let zero = S::Scalar::default();
    sum.coordinates_mut().iter_mut().for_each(|entry| *entry = zero);
    sum.rates_mut().iter_mut().for_each(|entry| *entry = zero);
    for (weight, rate) in weights.into_iter().zip(rates) {
        add_scaled(sum, weight, rate);
    }
}

/// `end` = `start` + step · `end`; the time is unchanged.
///
/// The mean rate is summed first and `start` is added last, so `start` is rounded once.
pub(super) fn start_plus_scaled<S: ChainState>(end: &mut S, start: &S, step: S::Scalar) {
    change(end, start, |entry, other| *entry = step.mul_add(*entry, other));
}

/// Returns whether all coordinates, all rates and the time are finite, in all lanes.
pub(super) fn is_finite<S: ChainState>(state: &S) -> bool {
    state.time().is_finite().all() && has_finite_entries(state)
}

/// Returns the error for a state that is not finite.
#[cold]
pub(super) fn not_finite<S: ChainState>(state: &S) -> Error {
    Error::NotFinite(origin::of_state(state).unwrap_or(Origin::Result))
}

/// Returns whether all coordinates and all rates are finite, in all lanes; for derivatives, whose time is unspecified.
pub(super) fn has_finite_entries<S: ChainState>(state: &S) -> bool {
    entries(state)
        .fold(S::Scalar::default().is_finite(), |all, value| all & value.is_finite())
        .all()
}

/// Returns all coordinates, then all rates.
pub(super) fn entries<S: ChainState>(state: &S) -> impl Iterator<Item = S::Scalar> {
    state.coordinates().iter().chain(state.rates()).copied()
}
