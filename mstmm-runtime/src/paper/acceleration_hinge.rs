//! The acceleration hinge moving in space `[P, Appendix A.2]`: it constrains nothing, and its
//! springs act as loads on the bodies at its sides.

use nalgebra::{Matrix6, Vector6};

use super::TransferMatrix;
use super::algebra::{identity, solve, with, zeros};
use super::body::Rows;
use crate::Scalar;

/// û₁, û₂ and û₃ of the outboard body: m and q at its output are û₁ \[r̈; Ω̇\] + û₂ \[m; q\] + û₃ of
/// those at its input `[P, Eqs. (61) to (63), (65)]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocks<T> {
    /// û₁ = \[u₃₁ u₃₂; u₄₁ u₄₂\].
    pub u1: Matrix6<T>,
    /// û₂ = \[u₃₃ u₃₄; u₄₃ u₄₄\].
    pub u2: Matrix6<T>,
    /// û₃ = \[u₃₅; u₄₅\].
    pub u3: Vector6<T>,
}

impl<T: Scalar> Blocks<T> {
    /// Those of a body with the transfer matrix `body` `[P, Eqs. (59), (60), (65)]`.
    pub fn of(body: &TransferMatrix<T>) -> Self {
        let Rows { moment, moment_constant, force, force_constant } = Rows::of(body);
        let square = |from: usize| {
            let upper = with(with(zeros(), (0, 0), &moment[from]), (0, 3), &moment[from + 1]);
            with(with(upper, (3, 0), &force[from]), (3, 3), &force[from + 1])
        };
        let constant = with(with(zeros(), (0, 0), &moment_constant), (3, 0), &force_constant);
        Blocks { u1: square(0), u2: square(2), u3: constant }
    }

    /// The transfer matrix of the hinge `[P, Eq. (66)]`.
    ///
    /// Force and moment pass unchanged `[P, Eqs. (55), (56)]`. The accelerations outboard of the hinge
    /// are −û₁⁻¹ û₂ \[m; q\] − û₁⁻¹ û₃ `[P, Eq. (64)]`, since both vanish at the **output of the
    /// body** `[P, Eqs. (57), (58)]`, where there is another acceleration hinge or a free end. û₁ is
    /// never singular for a body with mass and inertia.
    pub fn transfer_matrix(&self) -> TransferMatrix<T> {
        let Self { u1, u2, u3 } = *self;
        let u = with(identity(), (0, 0), &zeros::<T, 6, 6>());
        with(with(u, (0, 6), &solve(u1, -u2)), (0, 12), &solve(u1, -u3))
    }
}
