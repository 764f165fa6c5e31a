//! Sine and cosine of many angles side by side, and the angle of a point: without a branch and
//! without a table.
//!
//! All of it is plain arithmetic and operations on bits, so that a loop over angles becomes vector
//! instructions where the target has them and gives the same bits where it has not. Products are
//! fused with sums only where [`Scalar::mul_add`](crate::Scalar::mul_add) is.

pub(crate) mod atan2;
mod side_by_side;
pub(crate) mod sin_cos;
