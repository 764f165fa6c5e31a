//! A chain whose state has one precision and whose rates are computed in another, which separates the
//! rounding errors of the step from those of the model.

use mstmm::{Chain, ChainState, Error};

use crate::subject::{Subject, convert};

/// A chain with the state of `kept` and the equations of `computed`.
pub struct Mixed<'a, K, C> {
    pub kept: &'a K,
    pub computed: &'a C,
}

impl<K: Subject, C: Subject> Chain for Mixed<'_, K, C> {
    type Scalar = K::Scalar;
    type State = K::State;
    type Inputs = (K::Inputs, C::Inputs);

    fn derivative_into(
        &self,
        state: &K::State,
        (_, inputs): &Self::Inputs,
        rate: &mut K::State,
    ) -> Result<(), Error> {
        let (mut at, mut found) = (C::State::zero_position(), C::State::zero_position());
        convert(state, &mut at);
        self.computed.derivative_into(&at, inputs, &mut found)?;
        convert(&found, rate);
        Ok(())
    }

    fn configuration_rate_into(&self, state: &K::State, rate: &mut K::State) {
        self.kept.configuration_rate_into(state, rate);
    }

    fn normalize(&self, state: &mut K::State) {
        self.kept.normalize(state);
    }

    fn project<E: From<Error>>(
        &self,
        state: &mut K::State,
        inputs: impl FnOnce(&K::State) -> Result<Self::Inputs, E>,
    ) -> Result<(), E> {
        self.kept.project(state, |state| inputs(state).map(|(inputs, _)| inputs))
    }
}
