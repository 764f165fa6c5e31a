//! A part of a plane chain on pins as a two-port, after Featherstone's articulated bodies by division
//! (Int. J. Robotics Research 18, 1999).
//!
//! The overall transfer matrix [P, Eq. (10)] maps accelerations and forces at one end of a part to
//! those at the other, and its product is associative, but it loses all digits in long chains. The
//! two-port says the same of the part in another order, accelerations at both ends from the forces at
//! both ends. Joining two of them is associative too, and inverts sums of positive definite matrices
//! only. Pins carry no moment, so forces and accelerations have two components.

use nalgebra::{Matrix2, Vector2};

use crate::rods::{INERTIA, LENGTH, MASS};

/// What passes from end to end of a part fades with every rod. Once it is smaller than this it changes
/// nothing, but soon it would be subnormal, with which processors compute slowly.
const FADED: f64 = 1e-200;

pub type Vector = Vector2<f64>;
type Matrix = Matrix2<f64>;

/// A part between its first and its last pin: with the forces f₁ and f₂ on it there,
/// a₁ = A f₁ + B f₂ + b₁ and a₂ = Bᵀ f₁ + C f₂ + b₂.
#[derive(Clone, Copy)]
pub struct TwoPort {
    a: Matrix,
    b: Matrix,
    c: Matrix,
    b1: Vector,
    b2: Vector,
}

/// The pin between two joined parts: the force there on the second one is G f₁ − H f₂ + g.
#[derive(Clone, Copy)]
pub struct Seam {
    by_first: Matrix,
    by_last: Matrix,
    own: Vector,
}

impl TwoPort {
    /// A rod along `direction` that turns at a rate: Newton's and Euler's equations about its centre.
    /// Gravity is left to the acceleration of the ground.
    #[inline]
    pub fn rod(direction: Vector, rate: f64) -> Self {
        let half = LENGTH / 2.0;
        let across = Vector::new(-direction.y, direction.x) * half;
        let turning = across * across.transpose() / INERTIA;
        let moving = Matrix::identity() / MASS;
        let towards_centre = direction * (half * rate * rate);
        TwoPort {
            a: moving + turning,
            b: moving - turning,
            c: moving + turning,
            b1: towards_centre,
            b2: -towards_centre,
        }
    }

    /// This part and the next one, joined by a pin.
    #[inline(always)]
    pub fn join(&self, next: &TwoPort) -> (TwoPort, Seam) {
        let compliance = inverse(&(self.c + next.a));
        let seam = Seam {
            by_first: compliance * self.b.transpose(),
            by_last: compliance * next.b,
            own: compliance * (self.b2 - next.b1),
        };
        let joined = TwoPort {
            a: self.a - self.b * seam.by_first,
            b: unless_faded(self.b * seam.by_last),
            c: next.c - next.b.transpose() * seam.by_last,
            b1: self.b1 - self.b * seam.own,
            b2: next.b2 + next.b.transpose() * seam.own,
        };
        (joined, seam)
    }

    /// The force on the first pin that moves it as told, while the last one is free.
    pub fn hold(&self, acceleration: Vector) -> Vector {
        inverse(&self.a) * (acceleration - self.b1)
    }
}

/// Joins parts in their order, and writes down the seams between them.
pub fn fold(mut parts: impl Iterator<Item = TwoPort>, seams: &mut Vec<Seam>) -> Option<TwoPort> {
    seams.clear();
    let first = parts.next()?;
    Some(parts.fold(first, |total, part| {
        let (joined, seam) = total.join(&part);
        seams.push(seam);
        joined
    }))
}

/// Goes back over the same seams: calls `part` with the forces on both ends of each part, the last one
/// first.
pub fn unfold(
    seams: &[Seam],
    [first, last]: [Vector; 2],
    mut part: impl FnMut(usize, [Vector; 2]),
) {
    let mut behind = last;
    for (before, seam) in seams.iter().enumerate().rev() {
        let between = seam.by_first * first - seam.by_last * behind + seam.own;
        part(before + 1, [between, behind]);
        behind = -between;
    }
    part(0, [first, behind]);
}

#[inline(always)]
fn unless_faded(matrix: Matrix) -> Matrix {
    let size = matrix.m11.abs() + matrix.m12.abs() + matrix.m21.abs() + matrix.m22.abs();
    if size < FADED { Matrix::zeros() } else { matrix }
}

/// Of a symmetric, positive definite matrix.
#[inline(always)]
fn inverse(matrix: &Matrix) -> Matrix {
    let scale = 1.0 / (matrix.m11 * matrix.m22 - matrix.m12 * matrix.m12);
    let side = -matrix.m12 * scale;
    Matrix::new(matrix.m22 * scale, side, side, matrix.m11 * scale)
}
