//! The constraint Jacobian of closed chains.

use super::{NotAsked, Unanswered};

/// Closed chains whose description asks for `jacobian`.
#[diagnostic::on_unimplemented(
    message = "only a closed chain whose setting `answers` has `jacobian` has a constraint Jacobian",
    label = "needs `answers = jacobian;` and a loop",
    note = "add `answers = jacobian;` or `answers = basic;` to the closed chain, or the word to its list: `answers = […, jacobian];`"
)]
pub trait AsksJacobian: Unanswered {}

impl<C> NotAsked<C> {
    pub fn closure_jacobian<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksJacobian,
    {
        Self::answer()
    }

    pub fn closure_jacobian_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksJacobian,
    {
        Self::answer()
    }

    pub fn closure_jacobian_times_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksJacobian,
    {
        Self::answer()
    }
}
