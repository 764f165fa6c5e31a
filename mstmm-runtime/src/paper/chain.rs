//! The overall product of a chain and the boundary solve `[P, Section 2.3]`.
//!
//! # Where the product begins
//!
//! The paper's examples begin outboard of the first hinge, z_{6,O} = U₆U₅U₄U₃U₂ z_{2,I} `[P, Eq. (45)]`,
//! with the six unknowns of [`InputEnd::outboard_of_ball`] or [`InputEnd::outboard_of_pin`]. That does not
//! determine them: U₅ has taken in the condition at the end of body 6, and hinge 3's own condition on
//! body 2, which U₁ would have taken in, is missing. Of the six equations 3 are independent for balls
//! and 5 for pins. The product that begins with U₁, at the ground, has the unknowns of
//! [`InputEnd::ball`] or [`InputEnd::pin`], and determines them.

use nalgebra::{Matrix3, SMatrix, SVector};

use super::TransferMatrix;
use super::algebra::{Times, block, identity, solve as least, with, zeros};
use crate::Scalar;

/// The boundary conditions at the input z_{1,I} of a chain: z_{1,I} = `known` + `unknown` x for any K numbers x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputEnd<T, const D: usize, const K: usize> {
    /// z_{1,I} for x = 0; its last entry is 1.
    pub known: SVector<T, D>,
    /// One column for each unknown.
    pub unknown: SMatrix<T, D, K>,
}

impl<T: Scalar, const D: usize, const K: usize> InputEnd<T, D, K> {
    /// The entries of z, counted from 0, that are unknown; the others are zero except the last.
    pub fn entries(unknown: [usize; K]) -> Self {
        let one = T::constant(1.0);
        InputEnd {
            known: SVector::from_fn(|row, _| if row + 1 == D { one } else { T::default() }),
            unknown: SMatrix::from_fn(|row, column| {
                if unknown.get(column) == Some(&row) { one } else { T::default() }
            }),
        }
    }
}

impl<T: Scalar> InputEnd<T, 13, 3> {
    /// The ground's side of a ball: no acceleration, no moment, q unknown.
    pub fn ball() -> Self {
        Self::entries([9, 10, 11])
    }
}

impl<T: Scalar> InputEnd<T, 13, 5> {
    /// The ground's side of a pin, whose axis is the third column of `orientation`: no
    /// acceleration, no moment about the axis; q and the moment about the first two columns are
    /// unknown.
    pub fn pin(orientation: &Matrix3<T>) -> Self {
        let end = Self::entries([6, 7, 9, 10, 11]);
        let across = block::<T, 3, 2, 3, 3>(orientation, (0, 0));
        InputEnd { unknown: with(end.unknown, (6, 0), &across), ..end }
    }
}

impl<T: Scalar> InputEnd<T, 13, 6> {
    /// The input of a free body: r̈ and Ω̇ are unknown.
    pub fn free() -> Self {
        Self::entries([0, 1, 2, 3, 4, 5])
    }

    /// z_{2,I} outboard of a ball on the ground as the paper has it, Ω̇ and q unknown
    /// `[P, Eq. (45)]`. It leaves a chain of balls undetermined.
    pub fn outboard_of_ball() -> Self {
        Self::entries([3, 4, 5, 9, 10, 11])
    }

    /// z_{2,I} outboard of a pin about z on the ground as the paper has it, Ω̇_z, m_x, m_y and q unknown
    /// `[P, Eq. (45)]`. It leaves a chain of pins undetermined.
    pub fn outboard_of_pin() -> Self {
        Self::entries([5, 6, 7, 9, 10, 11])
    }
}

/// The boundary conditions at the output z_{n,O} of a chain: `conditions` z_{n,O} = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutputEnd<T, const D: usize, const M: usize> {
    /// One row for each condition.
    pub conditions: SMatrix<T, M, D>,
}

impl<T: Scalar, const D: usize, const M: usize> OutputEnd<T, D, M> {
    /// The entries of z, counted from 0, that vanish.
    pub fn entries(vanishing: [usize; M]) -> Self {
        let one = T::constant(1.0);
        OutputEnd {
            conditions: SMatrix::from_fn(|row, column| {
                if vanishing.get(row) == Some(&column) { one } else { T::default() }
            }),
        }
    }
}

impl<T: Scalar> OutputEnd<T, 13, 6> {
    /// A free end in space: no moment, no force.
    pub fn free() -> Self {
        Self::entries([6, 7, 8, 9, 10, 11])
    }
}

/// U_{1−n} = U_n ⋯ U₂ U₁ `[P, Eq. (10)]`, of which z_{n,O} = U_{1−n} z_{1,I} `[P, Eq. (9)]`;
/// `elements` are U₁ to U_n in this order.
pub fn overall<T: Scalar, const D: usize>(
    elements: &[TransferMatrix<T, D>],
) -> TransferMatrix<T, D> {
    elements.iter().fold(identity(), |product, element| element.times(&product))
}

/// The equations that the boundary leaves, Ū \[x; 1\] = 0 `[P, Eq. (11)]`, as the matrix of the
/// unknowns x of the input and the negative column of the 1.
///
/// The paper counts the unknowns of z_{n,O} as well and has a row for each; those rows give them
/// once x is known.
pub fn boundary<T: Scalar, const D: usize, const K: usize, const M: usize>(
    overall: &TransferMatrix<T, D>,
    input: &InputEnd<T, D, K>,
    output: &OutputEnd<T, D, M>,
) -> (SMatrix<T, M, K>, SVector<T, M>) {
    let rows = output.conditions.times(overall);
    (rows.times(&input.unknown), -rows.times(&input.known))
}

/// The state vector at every connection point of a chain of N elements.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct States<T, const D: usize, const N: usize> {
    /// z_{1,I}.
    pub input: SVector<T, D>,
    /// z_{j,O} of each element, which is the next one's z_I.
    pub outputs: [SVector<T, D>; N],
}

/// Steps (iii) to (v) of `[P, Section 2.4]`: the overall product, the boundary solve
/// `[P, Eqs. (9) to (11)]` and all state vectors one after the other `[P, Eq. (8)]`.
///
/// There may be more conditions than unknowns; in a chain of pins one condition follows from the others. The unknowns
/// are those with the least sum of squares of the residuals. They are not finite if they are undetermined, unless
/// rounding hides it.
pub fn solve<T: Scalar, const D: usize, const N: usize, const K: usize, const M: usize>(
    elements: &[TransferMatrix<T, D>; N],
    input: &InputEnd<T, D, K>,
    output: &OutputEnd<T, D, M>,
) -> States<T, D, N> {
    let (matrix, right) = boundary(&overall(elements), input, output);
    let unknowns: SVector<T, K> = least(matrix, right);
    let first = input.known + input.unknown.times(&unknowns);
    let (mut z, mut outputs) = (first, [zeros(); N]);
    for (output, element) in outputs.iter_mut().zip(elements) {
        z = element.times(&z);
        *output = z;
    }
    States { input: first, outputs }
}
