//! What acts on a chain during a step.

use crate::{Chain, Error};

/// The inputs at a time and a state, checked.
///
/// # Errors
/// Those of [`Chain::check_inputs`].
#[inline(always)]
pub(super) fn ask<C: Chain>(
    chain: &C,
    inputs: &mut impl FnMut(C::Scalar, &C::State) -> C::Inputs,
    time: C::Scalar,
    state: &C::State,
) -> Result<C::Inputs, Error> {
    let acting = inputs(time, state);
    chain.check_inputs(&acting)?;
    Ok(acting)
}
