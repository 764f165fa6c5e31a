//! Newmark's method.

use super::ask::{always, ask};
use super::combine::{add_scaled_coordinates, add_scaled_rates, copy};
use super::fixed_step::{self, FixedStep, Pace, Span, arrive, clone_and_debug, fixed_step_methods};
use super::held::held_methods;
use crate::{Chain, ChainState, Error, Scalar};

/// Newmark's method (J. Eng. Mech. Div. ASCE 85, 1959) with a fixed step: order two.
///
/// With the accelerations a at both ends of a step,
///
/// - v ← v + h ((1 − γ) aₙ + γ aₙ₊₁),
/// - q ← q + h v̄ with the mean rate v̄ = vₙ + h ((½ − β) aₙ + β aₙ₊₁);
///
/// If q̇ is not v, as for quaternions, q̇ is evaluated for v̄ in the middle of the step, at qₙ + ½ h q̇(qₙ, v̄). Then
/// [`Chain::normalize`].
///
/// aₙ₊₁ is found by a fixed number of fixed-point iterations, each with one evaluation, after one evaluation at the
/// start. One iteration is enough for order two. The default of three is the largest number that is worth its cost: an
/// undamped spring with the angular frequency ω then loses (hω)⁸/128 of its energy per step, and steps up to 2/ω, and
/// up to 2 m/c for a damper, are stable. An even number of iterations would gain energy. The iterations do not have the
/// unconditional stability of the implicit method, so use [`LinearlyImplicitEuler`](super::LinearlyImplicitEuler) for
/// stiff springs.
///
/// The default β = ¼, γ = ½ is the mean acceleration, which keeps the energy of a spring. β = ⅙ makes the acceleration
/// linear in time, β = 0 is the method of central differences. With γ ≠ ½ the order is one, and γ > ½ adds damping.
///
/// Times are summed with compensation as in [`Rk4`](super::Rk4).
pub struct Newmark<C: Chain> {
    pace: Pace<C::Scalar>,
    beta: C::Scalar,
    gamma: C::Scalar,
    iterations: u32,
    first: C::State,
    last: C::State,
    mean: C::State,
    result: C::State,
}

fixed_step_methods!(Newmark);

held_methods!(Newmark);

clone_and_debug!(Newmark { beta, gamma, iterations, first, last, mean, result });

impl<C: Chain> Newmark<C> {
    /// Makes an integrator with a step of `step` seconds; a negative step goes back in time.
    pub fn new(step: C::Scalar) -> Self {
        Self {
            pace: Pace::new(step),
            beta: C::Scalar::constant(0.25),
            gamma: C::Scalar::constant(0.5),
            iterations: 3,
            first: C::State::zero_position(),
            last: C::State::zero_position(),
            mean: C::State::zero_position(),
            result: C::State::zero_position(),
        }
    }

    /// Sets β and γ.
    pub fn with_parameters(mut self, beta: C::Scalar, gamma: C::Scalar) -> Self {
        (self.beta, self.gamma) = (beta, gamma);
        self
    }

    /// Sets the number of fixed-point iterations, at least one.
    pub fn with_iterations(mut self, iterations: u32) -> Self {
        self.iterations = iterations;
        self
    }

    /// Integrates `state` over one step.
    ///
    /// `inputs` is evaluated at the start and in each iteration at the end of the step. Its arguments are the time in s
    /// and the state there, whose quaternions have unit length up to the error of the state.
    ///
    /// # Errors
    /// Those of [`Chain::check_state`], [`Chain::check_inputs`], [`Chain::derivative_into`] and
    /// [`Chain::project`], and [`Error::NotFinite`] if the result is not finite.
    /// `state` is then unchanged.
    #[doc(alias("mj_step"))]
    pub fn step(
        &mut self,
        chain: &C,
        state: &mut C::State,
        inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    ) -> Result<(), Error> {
        fixed_step::step(self, chain, state, always::<C>(inputs))
    }

    /// Computes the end of a step from `state` into `self.result`, with the accelerations in `self.first` and
    /// `self.last`.
    fn reach(&mut self, chain: &C, state: &C::State, Span { step, end }: Span<C::Scalar>) {
        let (half, one) = (C::Scalar::constant(0.5), C::Scalar::constant(1.0));
        let Self { beta, gamma, first, last, mean, result, .. } = self;

        // `result` has the mean rate, first at the coordinates of the start and then at those of the middle.
        copy(result, state);
        add_scaled_rates(result, step * (half - *beta), first);
        add_scaled_rates(result, step * *beta, last);
        chain.configuration_rate_into(result, mean);
        add_scaled_coordinates(result, step * half, mean);
        chain.configuration_rate_into(result, mean);

        copy(result, state);
        add_scaled_coordinates(result, step, mean);
        add_scaled_rates(result, step * (one - *gamma), first);
        add_scaled_rates(result, step * *gamma, last);
        result.set_time(end);
    }
}

impl<C: Chain> FixedStep<C> for Newmark<C> {
    fn pace(&mut self) -> &mut Pace<C::Scalar> {
        &mut self.pace
    }

    fn take<E: From<Error>>(
        &mut self,
        chain: &C,
        state: &mut C::State,
        span: Span<C::Scalar>,
        inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    ) -> Result<(), E> {
        let acting = ask(chain, inputs, state.time(), state)?;
        chain.derivative_into(state, &acting, &mut self.first)?;
        copy(&mut self.last, &self.first);
        self.reach(chain, state, span);
        for _ in 0..self.iterations.max(1) {
            let acting = ask(chain, inputs, span.end, &self.result)?;
            chain.derivative_into(&self.result, &acting, &mut self.last)?;
            self.reach(chain, state, span);
        }
        arrive(chain, &mut self.result, span.end, state, inputs)
    }
}
