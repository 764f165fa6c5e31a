//! Methods that a chain does not have because its description does not ask for them.
//!
//! A generated chain dereferences to [`NotAsked`], which has the methods of all words of the setting `answers`. A method
//! that the chain has is found first, also one that the user's crate adds to it. The methods here cannot be called:
//! the traits that they need have no implementations, so rustc reports the word to add.

use core::marker::PhantomData;

/// The methods that a chain `C` does not have.
#[derive(Clone, Copy, Debug)]
pub struct NotAsked<C>(PhantomData<C>);

impl<C> NotAsked<C> {
    /// Returns the methods of the chain.
    #[inline]
    pub const fn of(_: &C) -> &Self {
        const { &NotAsked(PhantomData) }
    }
}

/// Stands for the results of the methods; without implementations.
pub trait Unanswered {
    /// Returns any result.
    fn answer<R>() -> R;
}

/// Chains whose description asks for `inverse_dynamics`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `inverse_dynamics`",
    label = "needs `answers = inverse_dynamics;`",
    note = "add `answers = inverse_dynamics;` or `answers = basic;` to the chain, or the word to its list: `answers = […, inverse_dynamics];`"
)]
pub trait AsksInverseDynamics: Unanswered {}

impl<C> NotAsked<C> {
    pub fn inverse_dynamics<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn inverse_dynamics_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn gravity_efforts<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn gravity_efforts_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn passive_efforts<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn passive_efforts_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }

    pub fn inverse_solve_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksInverseDynamics,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `bias_efforts`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `bias_efforts`",
    label = "needs `answers = bias_efforts;`",
    note = "add `answers = bias_efforts;` to the chain, or the word to its list: `answers = […, bias_efforts];`"
)]
pub trait AsksBiasEfforts: Unanswered {}

impl<C> NotAsked<C> {
    pub fn bias_efforts<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksBiasEfforts,
    {
        Self::answer()
    }

    pub fn bias_efforts_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksBiasEfforts,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `mass_matrix`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `mass_matrix`",
    label = "needs `answers = mass_matrix;`",
    note = "add `answers = mass_matrix;` or `answers = basic;` to the chain, or the word to its list: `answers = […, mass_matrix];`"
)]
pub trait AsksMassMatrix: Unanswered {}

impl<C> NotAsked<C> {
    pub fn mass_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn mass_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn mass_matrix_times<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn mass_matrix_times_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix_times<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix_times_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksMassMatrix,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `kinematics`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `kinematics`",
    label = "needs `answers = kinematics;`",
    note = "add `answers = kinematics;` or, with Jacobians, `answers = jacobian;` to the chain, or the word to its list: `answers = […, kinematics];`"
)]
pub trait AsksKinematics: Unanswered {}

impl<C> NotAsked<C> {
    pub fn kinematics_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksKinematics,
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

/// Chains whose description asks for `regressor`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `regressor`",
    label = "needs `answers = regressor;`",
    note = "add `answers = regressor;` to the chain, or the word to its list: `answers = […, regressor];`"
)]
pub trait AsksRegressor: Unanswered {}

impl<C> NotAsked<C> {
    pub fn regressor<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksRegressor,
    {
        Self::answer()
    }

    pub fn regressor_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksRegressor,
    {
        Self::answer()
    }

    pub fn inertial_parameters<R>(&self) -> R
    where
        Self: AsksRegressor,
    {
        Self::answer()
    }
}

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
