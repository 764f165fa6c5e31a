//! Evaluation of the inputs during a step.

use crate::{Chain, Error};

/// Evaluates the inputs at a time and a state, and checks them.
///
/// # Errors
/// Those of `inputs`, and of [`Chain::check_inputs`].
#[inline(always)]
pub(super) fn ask<C: Chain, E: From<Error>>(
    chain: &C,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, E>,
    time: C::Scalar,
    state: &C::State,
) -> Result<C::Inputs, E> {
    let acting = inputs(time, state)?;
    chain.check_inputs(&acting)?;
    Ok(acting)
}

/// Converts inputs that cannot fail to inputs that can.
#[inline(always)]
pub(super) fn always<C: Chain>(
    mut inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
) -> impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, Error> {
    move |time, state| Ok(inputs(time, state))
}
