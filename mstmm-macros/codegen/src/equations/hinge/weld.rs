//! Weld: joins two frames for good.

use super::{Crossing, Freedom};
use crate::math::{Mat3, Scalar, Vec3};

/// Both frames coincide.
pub fn crossing<S: Scalar>() -> Crossing<S> {
    Crossing { rotation: Mat3::identity(), turn: None, offset: Vec3::zero() }
}

/// Nothing is free.
pub fn freedom<S: Scalar>() -> Freedom<S> {
    Freedom { columns: Vec::new(), basis: Vec::new() }
}
