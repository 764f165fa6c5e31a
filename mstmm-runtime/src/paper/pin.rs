//! The smooth pin moving in space `[P, Section 3.3]`.

use nalgebra::{Matrix3, SVector, Vector3};

use super::TransferMatrix;
use super::algebra::{Times, block, entry, identity, solve, tilde, with, zeros};
use super::body::Rows;
use super::state;
use crate::Scalar;

/// A pin and its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin<T> {
    /// A_{j,O}, which takes components in the outboard frame, whose third axis ζ is the pin's, to
    /// inertial components.
    pub orientation: Matrix3<T>,
    /// Ω_{j,O} of the outboard frame in rad/s, inertial frame.
    pub angular_velocity: Vector3<T>,
    /// Θ̇ in rad/s, of the outboard frame relative to the inboard frame about ζ.
    pub rate: T,
}

impl<T: Scalar> Pin<T> {
    /// ω_r = \[0 0 Θ̇\] in inertial components, A_{j,O} ω_r.
    fn relative(&self) -> Vector3<T> {
        axis(&self.orientation) * self.rate
    }

    /// Ω̃_{j,O} A_{j,O} ω_r, the part of `[P, Eq. (36)]` that velocities make, in rad/s².
    fn bias(&self) -> Vector3<T> {
        tilde(&self.angular_velocity).times(&self.relative())
    }

    /// H₂ A_{j,O}ᵀ m in N m, zero for the moment that a smooth pin transmits `[P, Eq. (35)]`.
    pub fn axial_moment(&self, moment: &Vector3<T>) -> T {
        dot(&axis(&self.orientation), moment)
    }

    /// Ω̇_{j,O} = Ω̇_{j,I} + Ω̃_{j,O} A_{j,O} ω_r + A_{j,O} ω̇_r in rad/s² for Θ̈ in rad/s²
    /// `[P, Eq. (36)]`.
    pub fn output_angular_acceleration(
        &self,
        angular_acceleration: &Vector3<T>,
        acceleration: T,
    ) -> Vector3<T> {
        angular_acceleration + self.bias() + axis(&self.orientation) * acceleration
    }

    /// Θ̈ in rad/s² from the state vectors at the input and the output of the pin `[P, Eq. (44)]`.
    pub fn acceleration(&self, input: &SVector<T, 13>, output: &SVector<T, 13>) -> T {
        let [inboard, outboard] = [input, output].map(|z| state::blocks(z).angular_acceleration());
        dot(&axis(&self.orientation), &(outboard - inboard - self.bias()))
    }

    /// Returns the blocks of its equations `[P, Eq. (41)]`.
    ///
    /// `body` is the transfer matrix of its outboard body, and `next` is A_{j+1,O}: its third axis ζ₊
    /// is that of the next pin, which sits on that body. At a free end any axis is right, and this
    /// pin's own never singular.
    pub fn blocks(&self, body: &TransferMatrix<T>, next: &Matrix3<T>) -> Blocks<T> {
        let Rows { moment: [u31, u32, u33, u34], moment_constant: u35, .. } = Rows::of(body);
        let across = block::<T, 2, 3, 3, 3>(&self.orientation.transpose(), (0, 0)); // H₁ A_{j,O}ᵀ
        let along = axis(next).transpose(); // H₂ A_{j+1,O}ᵀ
        // [P, Eqs. (39), (40)], the third row of each
        let last = |u: &Matrix3<T>| with(zeros(), (2, 0), &along.times(u));
        // [P, Eq. (37)], the first two rows of each
        Blocks {
            e0: with(last(&-u32), (0, 0), &across),
            e1: last(&u31),
            e2: with(zeros(), (0, 0), &across),
            e3: last(&u33),
            e4: last(&u34),
            e5: with(
                with(zeros(), (0, 0), &across.times(&self.bias())),
                (2, 0),
                &along.times(&u35),
            ),
        }
    }
}

/// The pin's axis ζ in inertial components: the third column of the orientation.
pub(super) fn axis<T: Scalar>(orientation: &Matrix3<T>) -> Vector3<T> {
    block(orientation, (0, 2))
}

fn dot<T: Scalar>(a: &Vector3<T>, b: &Vector3<T>) -> T {
    let ([a0, a1, a2], [b0, b1, b2]): ([T; 3], [T; 3]) = ((*a).into(), (*b).into());
    a0 * b0 + a1 * b1 + a2 * b2
}

/// E₀ to E₅ of E₀ Ω̇_{j,O} = E₁ r̈_{j,I} + E₂ Ω̇_{j,I} + E₃ m_{j,I} + E₄ q_{j,I} + E₅
/// `[P, Eq. (41)]`.
///
/// Two rows are the accelerations across the axis `[P, Eq. (37)]`, without unit; the third is that
/// no moment acts along the **next** pin's axis `[P, Eqs. (38) to (40)]`, in N m. In (39) the text
/// has q̇ for q.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocks<T> {
    /// E₀.
    pub e0: Matrix3<T>,
    /// E₁.
    pub e1: Matrix3<T>,
    /// E₂.
    pub e2: Matrix3<T>,
    /// E₃.
    pub e3: Matrix3<T>,
    /// E₄.
    pub e4: Matrix3<T>,
    /// E₅.
    pub e5: Vector3<T>,
}

impl<T: Scalar> Blocks<T> {
    /// det E₀ = −ζ₊ · u₃₂ ζ in kg m². Where it is zero, `[P, Eq. (41)]` has no solution, although the
    /// pin moves as ever: it is only that the next pin's condition says nothing of this one's
    /// acceleration.
    pub fn determinant(&self) -> T {
        let e = |row: usize, column: usize| entry(&self.e0, (row, column));
        let minor = |a: usize, b: usize| e(1, a) * e(2, b) - e(1, b) * e(2, a);
        e(0, 0) * minor(1, 2) - e(0, 1) * minor(0, 2) + e(0, 2) * minor(0, 1)
    }

    /// The transfer matrix of the pin `[P, Eq. (43)]`: acceleration, force and moment pass
    /// unchanged `[P, Eqs. (32) to (34)]`, and the second row is `[P, Eq. (42)]`.
    pub fn transfer_matrix(&self) -> TransferMatrix<T> {
        let Self { e0, e1, e2, e3, e4, e5 } = self;
        let mut u = identity();
        u = with(u, (3, 0), &solve(*e0, *e1));
        u = with(u, (3, 3), &solve(*e0, *e2));
        u = with(u, (3, 6), &solve(*e0, *e3));
        u = with(u, (3, 9), &solve(*e0, *e4));
        with(u, (3, 12), &solve(*e0, *e5))
    }
}
