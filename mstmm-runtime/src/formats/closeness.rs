//! Approximate equality of states.

use crate::description::QuantityKind;
use crate::{ChainState, Described};

/// Returns whether all coordinates, rates and times of two states are close. A quaternion is close to another or to
/// its negative, as in nalgebra.
pub fn are_close<C: Described>(
    [a, b]: [&C::State; 2],
    close: impl Fn(&C::Scalar, &C::Scalar) -> bool,
) -> bool {
    let all = |[a, b]: [&[C::Scalar]; 2]| a.iter().zip(b).all(|(a, b)| close(a, b));
    let [qa, qb] = [a.coordinates(), b.coordinates()];
    let mut is_close = all([a.rates(), b.rates()]) && close(&a.time(), &b.time());
    // The components of a quaternion follow each other, w first.
    let mut rest = 0;
    for (index, quantity) in C::DESCRIPTION.coordinates().iter().enumerate() {
        if index < rest {
            continue;
        }
        rest = index + if quantity.kind == QuantityKind::Quaternion { 4 } else { 1 };
        let (Some(a), Some(b)) = (qa.get(index..rest), qb.get(index..rest)) else { return false };
        let negative = || a.iter().zip(b).all(|(a, b)| close(a, &-*b));
        let is_rotation = quantity.kind == QuantityKind::Quaternion;
        is_close &= all([a, b]) || (is_rotation && negative());
    }
    is_close
}
