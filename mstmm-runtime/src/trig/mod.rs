//! Sine and cosine of many angles side by side, and the angle of a point: without a branch and
//! without a table.
//!
//! They use only arithmetic and operations on bits, so that a loop over angles becomes vector instructions if the target
//! has them, with the same bits as without. Products and sums are fused only if
//! [`Scalar::mul_add`](crate::Scalar::mul_add) fuses them.

pub(crate) mod atan2;
mod side_by_side;
pub(crate) mod sin_cos;
