//! Arithmetic on whole states, entry by entry in place: states may be large, and never pass through
//! the stack.

use crate::{ChainState, Mask, Scalar};

/// Changes every coordinate and every rate of `state` by what stands at its place in `other`.
#[inline(always)]
fn change<S: ChainState>(state: &mut S, other: &S, change: impl Fn(&mut S::Scalar, S::Scalar)) {
    state
        .coordinates_mut()
        .iter_mut()
        .zip(other.coordinates())
        .for_each(|(entry, &given)| change(entry, given));
    state
        .rates_mut()
        .iter_mut()
        .zip(other.rates())
        .for_each(|(entry, &given)| change(entry, given));
}

/// `to` = `from`, with its time.
pub(super) fn copy<S: ChainState>(to: &mut S, from: &S) {
    change(to, from, |entry, given| *entry = given);
    to.set_time(from.time());
}

/// `sum` += weight · `rate`; its time stays.
pub(super) fn add_scaled<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    change(sum, rate, |entry, given| *entry = weight.mul_add(given, *entry));
}

/// `to` = `from` + factor · `rate`; its time stays.
pub(super) fn sum_scaled<S: ChainState>(to: &mut S, from: &S, factor: S::Scalar, rate: &S) {
    let sum = |((to, &from), &rate): ((&mut S::Scalar, &S::Scalar), &S::Scalar)| {
        *to = factor.mul_add(rate, from);
    };
    to.coordinates_mut().iter_mut().zip(from.coordinates()).zip(rate.coordinates()).for_each(sum);
    to.rates_mut().iter_mut().zip(from.rates()).zip(rate.rates()).for_each(sum);
}

/// The coordinates of `sum` += weight · those of `rate`; all else stays.
pub(super) fn add_scaled_coordinates<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    sum.coordinates_mut()
        .iter_mut()
        .zip(rate.coordinates())
        .for_each(|(entry, &given)| *entry = weight.mul_add(given, *entry));
}

/// The rates of `sum` += weight · those of `rate`; all else stays.
pub(super) fn add_scaled_rates<S: ChainState>(sum: &mut S, weight: S::Scalar, rate: &S) {
    sum.rates_mut()
        .iter_mut()
        .zip(rate.rates())
        .for_each(|(entry, &given)| *entry = weight.mul_add(given, *entry));
}

/// `sum` = Σ weight · rate; its time stays.
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

/// `end` = `start` + step · `end`; its time stays.
///
/// The mean rate is summed up first and `start` added last, so that `start` is rounded once.
pub(super) fn start_plus_scaled<S: ChainState>(end: &mut S, start: &S, step: S::Scalar) {
    change(end, start, |entry, given| *entry = step.mul_add(*entry, given));
}

/// Whether every coordinate, every rate and the time are finite, in every lane.
pub(super) fn is_finite<S: ChainState>(state: &S) -> bool {
    state.time().is_finite().all() && has_finite_entries(state)
}

/// Whether every coordinate and every rate is finite, in every lane; for rates of change, whose
/// time means nothing.
pub(super) fn has_finite_entries<S: ChainState>(state: &S) -> bool {
    entries(state)
        .fold(S::Scalar::default().is_finite(), |all, value| all & value.is_finite())
        .all()
}

/// All coordinates, then all rates.
pub(super) fn entries<S: ChainState>(state: &S) -> impl Iterator<Item = S::Scalar> {
    state.coordinates().iter().chain(state.rates()).copied()
}
