//! The matrices of the paper as printed, to read and to call.
//!
//! `[P]` is Rui, Bestle, Zhang and Zhou, *A new version of transfer matrix method for multibody
//! systems*, Multibody System Dynamics, 2016. Chains of `mstmm_chain!` do not use this module, because
//! their equations have another form; the limits below show why. It serves for comparison.
//!
//! | module | content |
//! |---|---|
//! | [`rotation`] | the rotation matrix (1), and Ω and Ω̇ as functions of its angles |
//! | [`state`] | the state vectors (3) to (7) |
//! | [`body`](mod@body) | a rigid body, (12) to (21) |
//! | [`ball`] | the ball-and-socket hinge, (22) to (31) |
//! | [`pin`] | the pin, (32) to (44) |
//! | [`elastic`] | springs and dampers of an elastic hinge, (53) and (54) |
//! | [`acceleration_hinge`] | the acceleration hinge, (55) to (66) |
//! | [`plane`], [`line`](mod@line) | the same in a plane, 7×7, and on a line, 3×3, (47) to (52) |
//! | [`chain`] | the overall product and the boundary solve, (8) to (11) |
//! | [`lagrange`] | the plane pendulum's equations without the method, (46) |
//! | [`tree`] | trees: a body with several inputs, and the overall equation; not in the paper |
//!
//! If the paper has a misprint, the code has the corrected form and its documentation quotes the misprint. Vectors are
//! in the inertial frame, values in SI units. This module uses the letters of the paper: in the state vector
//! z = \[r̈, Ω̇, m, q, 1\], m is the internal moment and q the internal force, with the signs of
//! [`StateVector`](crate::StateVector).
//!
//! # Limits
//!
//! The compiler's test `paper_limits` shows them:
//!
//! - The matrices (31), (43), (66) of hinges hold only if the next hinge is of the same kind or if there is none,
//!   because they contain its condition on the body between them.
//! - The product (10) loses about one digit of accuracy per body; see the table.
//! - (41), hence (43), is singular where ζ₊ · u₃₂ ζ = 0 for the axes ζ of the pin and ζ₊ of the next
//!   one. For perpendicular neighbours on a body with principal axes along them, as on most
//!   robot arms, it is always singular; 10⁻⁴ rad away from such a pose four of sixteen digits are lost.
//! - (45) does not determine its six unknowns: its rank is 3 for balls and 5 for pins. [`chain`]
//!   explains the reason and the remedy.
//! - [`tree`] has a table for trees: with arms of 16 bodies no digit is left.
//!
//! Relative errors of r̈ and Ω̇ for n of the paper's cubes in random states, measured; for the
//! compiler, those of the less accurate of its two methods:
//!
//! | n | balls, `f64` | `f32` | parallel pins, `f64` | `f32` | compiler, `f64` | `f32` |
//! |---|---|---|---|---|---|---|
//! | 1 | 2e-15 | 1e-6 | 2e-15 | 4e-7 | 3e-16 | 2e-7 |
//! | 3 | 5e-14 | 8e-5 | 2e-13 | 1e-4 | 1e-15 | 1e-6 |
//! | 5 | 1e-11 | 7e-4 | 2e-11 | 6e-3 | 2e-15 | 1e-6 |
//! | 10 | 5e-8 | lost | 3e-7 | lost | 3e-15 | 4e-6 |
//! | 15 | 3e-3 | lost | 7e-3 | lost | 5e-15 | 6e-6 |
//! | 20 | lost | lost | lost | lost | 6e-15 | 4e-6 |
//! | 60 | lost | lost | lost | lost | 2e-14 | 1e-5 |
//!
//! Undetermined values are infinite or NaN, or meaningless large values if rounding hides a zero; nothing panics.
//!
//! # A pendulum by hand
//!
//! ```
//! use mstmm_runtime::nalgebra::{Matrix3, Vector3};
//! use mstmm_runtime::paper::body::{Body, Load, Motion};
//! use mstmm_runtime::paper::{ball, chain, state};
//!
//! let cube = Body {
//!     mass: 1.0,
//!     com: Vector3::new(0.5, 0.0, 0.0),
//!     output: Vector3::new(1.0, 0.0, 0.0),
//!     inertia: Matrix3::from_diagonal(&Vector3::new(1.0 / 6.0, 5.0 / 12.0, 5.0 / 12.0)),
//! };
//! let motion = Motion { orientation: Matrix3::identity(), angular_velocity: Vector3::zeros() };
//! let weight = Load { force: Vector3::new(0.0, -9.8, 0.0), moment: Vector3::zeros() };
//!
//! let body = cube.blocks(&motion, &weight).transfer_matrix(); // (21)
//! let hinge = ball::transfer_matrix(&body); // (31)
//! let z = chain::solve(&[hinge, body], &chain::InputEnd::ball(), &chain::OutputEnd::free());
//!
//! let tip = state::blocks(&z.outputs[1]); // at the free end
//! let turning = -9.8 * 0.5 / (5.0 / 12.0);
//! assert!((tip.acceleration() - Vector3::new(0.0, turning, 0.0)).norm() < 1e-12);
//! assert!(tip.force().norm() < 1e-12);
//! ```

pub mod acceleration_hinge;
mod algebra;
pub mod ball;
pub mod body;
pub mod chain;
pub mod elastic;
pub mod lagrange;
pub mod line;
pub mod pin;
pub mod plane;
pub mod rotation;
pub mod state;
pub mod tree;

use nalgebra::SMatrix;

/// The transfer matrix of an element, z_O = U z_I `[P, Eq. (8)]`: 13×13 in space, 7×7 in a plane,
/// 3×3 on a line. Its last row is \[0 … 0 1\].
pub type TransferMatrix<T, const D: usize = 13> = SMatrix<T, D, D>;
