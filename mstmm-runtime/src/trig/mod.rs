//! Sine and cosine of many angles side by side, and the angle of a point: without a branch, without
//! a table, without a fused operation.
//!
//! An angle is reduced to [−π/4, π/4] by subtracting the nearest multiple k of π/2, which is kept
//! as a sum of parts with so few digits that k times a part is exact (Cody and Waite 1980). What is
//! left is the sum of two numbers, the second one being what the first cannot hold. Two polynomials
//! give sine and cosine there, and the last two bits of k say which is which, and the signs. All of
//! it is plain arithmetic and operations on bits, so that a loop over angles becomes vector
//! instructions where the target has them and gives the same bits where it has not.
//!
//! The polynomials are minimax fits in relative error over |x| ≤ 1.0001 π/4, by Remez's exchange in
//! 80 digits. Coefficients were rounded one after the other, from the lowest power on, and those
//! left fitted again each time.

pub(crate) mod atan2;
pub(crate) mod double;
pub(crate) mod single;
