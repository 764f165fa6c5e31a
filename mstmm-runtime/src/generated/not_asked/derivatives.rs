//! Derivatives, and products with them.

use super::{NotAsked, Unanswered};

/// Chains whose description asks for `derivatives`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `derivatives`",
    label = "needs `answers = derivatives;`",
    note = "add `answers = derivatives;` to the chain, or the word to its list: `answers = […, derivatives];`"
)]
pub trait AsksDerivatives: Unanswered {}

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
        Self: AsksDerivatives,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `linearize`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `linearize`",
    label = "needs `answers = linearize;`",
    note = "add `answers = linearize;` to the chain, or the word to its list: `answers = […, linearize];`"
)]
pub trait AsksLinearize: Unanswered {}

impl<C> NotAsked<C> {
    pub fn linearize_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksLinearize,
    {
        Self::answer()
    }

    pub fn linearize<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksLinearize,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `push`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `push`",
    label = "needs `answers = push;`",
    note = "add `answers = push;` to the chain, or the word to its list: `answers = […, push];`"
)]
pub trait AsksPush: Unanswered {}

impl<C> NotAsked<C> {
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
    message = "the chain's setting `answers` omits `pull`",
    label = "needs `answers = pull;`",
    note = "add `answers = pull;` to the chain, or the word to its list: `answers = […, pull];`"
)]
pub trait AsksPull: Unanswered {}

impl<C> NotAsked<C> {
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
