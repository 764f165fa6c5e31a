//! The smooth ball-and-socket hinge `[P, Section 3.2]`.

use super::TransferMatrix;
use super::algebra::{identity, solve, with, zeros};
use super::body::Rows;
use crate::Scalar;

/// The transfer matrix of a ball whose outboard body has the transfer matrix `body`
/// `[P, Eq. (31)]`.
///
/// Acceleration, force and moment pass unchanged `[P, Eqs. (22) to (24)]`. Ω̇_O follows from the
/// condition m = 0 at the **output of the body** `[P, Eq. (25)]`, which there is another ball's or
/// that of a free end, by the body's third row `[P, Eqs. (26) to (28)]`:
///
/// Ω̇_O = −u₃₂⁻¹ (u₃₁ r̈_I + u₃₃ m_I + u₃₄ q_I + u₃₅) `[P, Eqs. (29), (30)]`
///
/// The condition of this ball itself, m_I = 0, is not part of it: the inboard element must contain it,
/// otherwise the boundary `[P, Eq. (45)]` lacks it. Around (26) and (29) the text has "acceleration
/// hinge" for the ball, and Q̇ for Ω̇.
pub fn transfer_matrix<T: Scalar>(body: &TransferMatrix<T>) -> TransferMatrix<T> {
    let rows = Rows::of(body);
    let [u31, u32, u33, u34] = rows.moment;
    let mut u = with(identity(), (3, 3), &zeros::<T, 3, 3>());
    u = with(u, (3, 0), &solve(u32, -u31));
    u = with(u, (3, 6), &solve(u32, -u33));
    u = with(u, (3, 9), &solve(u32, -u34));
    with(u, (3, 12), &solve(u32, -rows.moment_constant))
}
