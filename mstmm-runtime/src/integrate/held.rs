//! Inputs that are held over a step, as those of a digital controller are.

/// The methods of an integrator whose inputs are held: `step_held` and `advance_held`.
macro_rules! held_methods {
    ($method:ident) => {
        impl<C: Chain> $method<C>
        where
            C::Inputs: Clone,
        {
            /// Takes one step as [`step`](Self::step) does, with inputs that are held over the step (zero-order hold).
            ///
            /// A digital controller holds its outputs between two samples. A prescribed motion that is an input keeps
            /// its position, rate and acceleration over the step; use [`step`](Self::step) for those that move.
            /// [`discretize`](crate::linear::discretize) computes the linear model of a step of
            /// [`Rk4`](crate::Rk4) with held inputs.
            ///
            /// # Errors
            /// Those of [`step`](Self::step).
            #[doc(alias(
                "zero-order hold",
                "ZeroOrderHold",
                "ZOH",
                "sample and hold",
                "held inputs"
            ))]
            pub fn step_held(
                &mut self,
                chain: &C,
                state: &mut C::State,
                inputs: &C::Inputs,
            ) -> Result<(), Error> {
                self.step(chain, state, |_time, _state| inputs.clone())
            }

            /// Integrates `state` over `duration` in s as [`advance_by`](Self::advance_by) does, with inputs that are
            /// held (zero-order hold).
            ///
            /// `duration` is the sampling period of a digital controller if that is longer than the step.
            ///
            /// # Errors
            /// Those of [`advance_by`](Self::advance_by).
            #[doc(alias("zero-order hold", "ZOH", "sample and hold", "sampling period"))]
            pub fn advance_held(
                &mut self,
                chain: &C,
                state: &mut C::State,
                duration: $crate::integrate::Real<C>,
                inputs: &C::Inputs,
            ) -> Result<(), Error> {
                self.advance_by(chain, state, duration, |_time, _state| inputs.clone())
            }
        }
    };
}
pub(super) use held_methods;
