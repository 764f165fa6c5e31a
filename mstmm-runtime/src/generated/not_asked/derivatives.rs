//! Derivatives, and products with them.

use super::{NotAsked, Unanswered};

/// Chains whose description asks for `derivatives`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `derivatives`, or the chain is closed",
    label = "needs `answers = derivatives;`",
    note = "add `answers = derivatives;` to the chain, or the word to its list: `answers = […, derivatives];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations"
)]
pub trait AsksDerivatives: Unanswered {}

/// Chains whose description asks for `derivatives`, without `repeat` and with at most 40 rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `derivatives`, or the chain is closed, or has `repeat` or more than 40 rates",
    label = "needs `answers = derivatives;`, no `repeat` and at most 40 rates",
    note = "add `answers = derivatives;` to the chain, or the word to its list: `answers = […, derivatives];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations",
    note = "a chain with `repeat` or more than 40 rates has `inverse_dynamics_derivatives_into`, which writes to the caller's storage"
)]
pub trait AsksDerivativesOfShortChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn inverse_dynamics_derivatives_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksDerivatives,
    {
        Self::answer()
    }

    pub fn inverse_dynamics_derivatives<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksDerivativesOfShortChain,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `linearize`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `linearize`, or the chain is closed",
    label = "needs `answers = linearize;`",
    note = "add `answers = linearize;` to the chain, or the word to its list: `answers = […, linearize];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations"
)]
pub trait AsksLinearize: Unanswered {}

/// Chains whose description asks for `linearize`, without `repeat` and with at most 40 rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `linearize`, or the chain is closed, or has `repeat` or more than 40 rates",
    label = "needs `answers = linearize;`, no `repeat` and at most 40 rates",
    note = "add `answers = linearize;` to the chain, or the word to its list: `answers = […, linearize];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations",
    note = "a chain with `repeat` or more than 40 rates has `linearize_into`, which writes to the caller's storage"
)]
pub trait AsksLinearizeOfShortChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn linearize_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksLinearize,
    {
        Self::answer()
    }

    pub fn linearize<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksLinearizeOfShortChain,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `push`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `push`, or the chain is closed",
    label = "needs `answers = push;`",
    note = "add `answers = push;` to the chain, or the word to its list: `answers = […, push];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations"
)]
pub trait AsksPush: Unanswered {}

impl<C> NotAsked<C> {
    pub fn push<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksPush,
    {
        Self::answer()
    }

    pub fn push_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksPush,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `pull`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `pull`, or the chain is closed",
    label = "needs `answers = pull;`",
    note = "add `answers = pull;` to the chain, or the word to its list: `answers = […, pull];`",
    note = "a closed chain does not have it; the scalar `mstmm::Dual` differentiates its accelerations"
)]
pub trait AsksPull: Unanswered {}

impl<C> NotAsked<C> {
    pub fn pull<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksPull,
    {
        Self::answer()
    }

    pub fn pull_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksPull,
    {
        Self::answer()
    }
}
