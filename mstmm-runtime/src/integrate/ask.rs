//! What acts on a chain during a step.

use crate::{Chain, Error};

/// The inputs at a time and a state, checked.
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

/// Inputs that cannot fail, as inputs that may.
#[inline(always)]
pub(super) fn always<C: Chain>(
    mut inputs: impl FnMut(C::Scalar, &C::State) -> C::Inputs,
) -> impl FnMut(C::Scalar, &C::State) -> Result<C::Inputs, Error> {
    move |time, state| Ok(inputs(time, state))
}
