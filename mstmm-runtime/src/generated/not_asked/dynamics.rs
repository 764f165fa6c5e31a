//! Dynamics: efforts, the mass matrix, the Coriolis matrix, the regressor.

use super::{NotAsked, Unanswered};

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
}

/// Open chains whose description asks for `inverse_dynamics`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `inverse_dynamics`, or the chain is closed",
    label = "needs `answers = inverse_dynamics;` and an open chain",
    note = "add `answers = inverse_dynamics;` or `answers = basic;` to the chain, or the word to its list: `answers = […, inverse_dynamics];`",
    note = "a closed chain does not have this method"
)]
pub trait AsksInverseDynamicsOfOpenChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn inverse_solve_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksInverseDynamicsOfOpenChain,
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

/// Chains whose description asks for `mass_matrix`, without `repeat` and with at most 40 rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `mass_matrix`, or the chain has `repeat` or more than 40 rates",
    label = "needs `answers = mass_matrix;`, no `repeat` and at most 40 rates",
    note = "add `answers = mass_matrix;` or `answers = basic;` to the chain, or the word to its list: `answers = […, mass_matrix];`",
    note = "a chain with `repeat` or more than 40 rates has `mass_matrix_into`, which writes to the caller's storage"
)]
pub trait AsksMassMatrixOfShortChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn mass_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrixOfShortChain,
    {
        Self::answer()
    }

    pub fn mass_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
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
}

/// Open chains whose description asks for `mass_matrix`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `mass_matrix`, or the chain is closed",
    label = "needs `answers = mass_matrix;` and an open chain",
    note = "add `answers = mass_matrix;` or `answers = basic;` to the chain, or the word to its list: `answers = […, mass_matrix];`",
    note = "a closed chain does not have this method"
)]
pub trait AsksMassMatrixOfOpenChain: Unanswered {}

/// Open chains whose description asks for `mass_matrix`, without `repeat` and with at most 40 rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `mass_matrix`, or the chain is closed, or has `repeat` or more than 40 rates",
    label = "needs `answers = mass_matrix;` and an open chain without `repeat`, with at most 40 rates",
    note = "add `answers = mass_matrix;` or `answers = basic;` to the chain, or the word to its list: `answers = […, mass_matrix];`",
    note = "a closed chain does not have this method",
    note = "a chain with `repeat` or more than 40 rates has `inverse_mass_matrix_into`, which writes to the caller's storage"
)]
pub trait AsksMassMatrixOfShortOpenChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn inverse_mass_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrixOfShortOpenChain,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrixOfOpenChain,
    {
        Self::answer()
    }

    pub fn inverse_mass_matrix_times<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksMassMatrixOfOpenChain,
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
        Self: AsksMassMatrixOfOpenChain,
    {
        Self::answer()
    }
}

/// Chains whose description asks for `coriolis_matrix`.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `coriolis_matrix`",
    label = "needs `answers = coriolis_matrix;`",
    note = "add `answers = coriolis_matrix;` to the chain, or the word to its list: `answers = […, coriolis_matrix];`"
)]
pub trait AsksCoriolisMatrix: Unanswered {}

/// Chains whose description asks for `coriolis_matrix`, without `repeat` and with at most 40 rates.
#[diagnostic::on_unimplemented(
    message = "the chain's setting `answers` omits `coriolis_matrix`, or the chain has `repeat` or more than 40 rates",
    label = "needs `answers = coriolis_matrix;`, no `repeat` and at most 40 rates",
    note = "add `answers = coriolis_matrix;` to the chain, or the word to its list: `answers = […, coriolis_matrix];`",
    note = "a chain with `repeat` or more than 40 rates has `coriolis_matrix_into`, which writes to the caller's storage"
)]
pub trait AsksCoriolisMatrixOfShortChain: Unanswered {}

impl<C> NotAsked<C> {
    pub fn coriolis_matrix<R>(&self, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksCoriolisMatrixOfShortChain,
    {
        Self::answer()
    }

    pub fn coriolis_matrix_into<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksCoriolisMatrix,
    {
        Self::answer()
    }

    pub fn coriolis_matrix_times<R>(&self, _: impl Sized, _: impl Sized, _: impl Sized) -> R
    where
        Self: AsksCoriolisMatrix,
    {
        Self::answer()
    }

    pub fn coriolis_matrix_times_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksCoriolisMatrix,
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

    pub fn regressor_times_into<R>(
        &self,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
        _: impl Sized,
    ) -> R
    where
        Self: AsksRegressor,
    {
        Self::answer()
    }

    pub fn dynamic_parameters<R>(&self) -> R
    where
        Self: AsksRegressor,
    {
        Self::answer()
    }
}
