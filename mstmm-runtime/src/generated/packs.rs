//! Packs: values of limbs of one shape side by side.

use crate::{Columns, Scalar};

/// Returns a pack of scalars.
#[inline(always)]
pub fn pack<T: Scalar, C: Columns<T>>(values: [T; 4]) -> C {
    C::from_fn(|column| values.get(column).copied().unwrap_or_default())
}

/// Returns the value in a lane of a pack.
#[inline(always)]
pub fn lane<T: Scalar, C: Columns<T>>(pack: C, lane: usize) -> T {
    pack.column(lane)
}
