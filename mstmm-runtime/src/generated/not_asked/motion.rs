//! Motion without dynamics: kinematics and momentum.

use super::{NotAsked, Unanswered};

/// Chains whose description asks for `kinematics`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `kinematics`",
    label = "needs `answers = kinematics;`",
    note = "add `answers = kinematics;` or, with Jacobians, `answers = jacobian;` to the chain, or the word to its list: `answers = […, kinematics];`"
)]
pub trait AsksKinematics: Unanswered {}

impl<C> NotAsked<C> {
    pub fn kinematics<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksKinematics,
    {
        Self::answer()
    }

    pub fn kinematics_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksKinematics,
    {
        Self::answer()
    }
}

/// Open chains whose description asks for `jacobian` and `mass_matrix`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `jacobian` or `mass_matrix`, or the chain is closed",
    label = "needs `answers = [jacobian, mass_matrix];`",
    note = "add both words to the chain's list: `answers = […, jacobian, mass_matrix];`",
    note = "a closed chain does not have this method"
)]
pub trait AsksJacobianOfOpenChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn operational_space_inertia<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksJacobianOfOpenChain,
    {
        Self::answer()
    }

    pub fn inverse_operational_space_inertia<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksJacobianOfOpenChain,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `momentum`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `momentum`",
    label = "needs `answers = momentum;`",
    note = "add `answers = momentum;` to the chain, or the word to its list: `answers = […, momentum];`"
)]
pub trait AsksMomentum: Unanswered {}

impl<C> NotAsked<C> {
    pub fn momentum<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMomentum,
    {
        Self::answer()
    }

    pub fn momentum_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMomentum,
    {
        Self::answer()
    }

    pub fn momentum_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMomentum,
    {
        Self::answer()
    }
}
