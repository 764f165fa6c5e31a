//! A part of a plane chain on pins as a two-port, after Featherstone's articulated bodies by division
//! (Int. J. Robotics Research 18, 1999).
//!
//! The overall transfer matrix [P, Eq. (10)] maps the accelerations and forces at one end of a part to
//! those at the other end. Its product is associative, but it loses all digits in long chains. The
//! two-port solves the same equations for the accelerations at both ends, given the forces at both ends.
//! Joining two-ports is associative, too, and inverts only sums of positive definite matrices. Pins
//! transmit no moment, so forces and accelerations have two components.

use nalgebra::{Matrix2, Vector2};

use crate::rods::{INERTIA, LENGTH, MASS};

/// The coupling between the ends of a part decreases with every rod. Below this size it has no effect and
/// is set to zero, because it would become subnormal, and processors compute slowly with subnormal values.
const NEGLIGIBLE: f64 = 1e-200;

pub type Vector = Vector2<f64>;
type Matrix = Matrix2<f64>;

/// A part between its first and its last pin. With the forces f₁ and f₂ on the part at these pins,
/// a₁ = A f₁ + B f₂ + b₁ and a₂ = Bᵀ f₁ + C f₂ + b₂.
#[derive(Clone, Copy)]
pub struct TwoPort {
    a: Matrix,
    b: Matrix,
    c: Matrix,
    b1: Vector,
    b2: Vector,
}

/// The pin between two joined parts. The force on the second part there is G f₁ − H f₂ + g.
#[derive(Clone, Copy)]
pub struct Joint {
    /// G
    by_first: Matrix,
    /// H
    by_last: Matrix,
    /// g
    bias: Vector,
}

impl TwoPort {
    /// A rod along `direction` that rotates at `rate`: the Newton–Euler equations about its centre. Gravity is
    /// not included; it is an acceleration of the ground.
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

    /// Joins this part and the next one by a pin.
    #[inline(always)]
    pub fn join(&self, next: &TwoPort) -> (TwoPort, Joint) {
        let compliance = inverse(&(self.c + next.a));
        let joint = Joint {
            by_first: compliance * self.b.transpose(),
            by_last: compliance * next.b,
            bias: compliance * (self.b2 - next.b1),
        };
        let joined = TwoPort {
            a: self.a - self.b * joint.by_first,
            b: unless_negligible(self.b * joint.by_last),
            c: next.c - next.b.transpose() * joint.by_last,
            b1: self.b1 - self.b * joint.bias,
            b2: next.b2 + next.b.transpose() * joint.bias,
        };
        (joined, joint)
    }

    /// The force on the first pin for an acceleration of this pin, while the last pin is free.
    pub fn force_for(&self, acceleration: Vector) -> Vector {
        inverse(&self.a) * (acceleration - self.b1)
    }
}

/// Joins parts in their order and stores the joints between them.
pub fn fold(mut parts: impl Iterator<Item = TwoPort>, joints: &mut Vec<Joint>) -> Option<TwoPort> {
    joints.clear();
    let first = parts.next()?;
    Some(parts.fold(first, |total, part| {
        let (joined, joint) = total.join(&part);
        joints.push(joint);
        joined
    }))
}

/// Goes back over the joints: calls `part` with the forces on both ends of each part, the last part first.
pub fn unfold(
    joints: &[Joint],
    [first, last]: [Vector; 2],
    mut part: impl FnMut(usize, [Vector; 2]),
) {
    let mut outboard = last;
    for (inboard, joint) in joints.iter().enumerate().rev() {
        let between = joint.by_first * first - joint.by_last * outboard + joint.bias;
        part(inboard + 1, [between, outboard]);
        outboard = -between;
    }
    part(0, [first, outboard]);
}

#[inline(always)]
fn unless_negligible(matrix: Matrix) -> Matrix {
    let size = matrix.m11.abs() + matrix.m12.abs() + matrix.m21.abs() + matrix.m22.abs();
    if size < NEGLIGIBLE { Matrix::zeros() } else { matrix }
}

/// The inverse of a symmetric, positive definite matrix.
#[inline(always)]
fn inverse(matrix: &Matrix) -> Matrix {
    let scale = 1.0 / (matrix.m11 * matrix.m22 - matrix.m12 * matrix.m12);
    let side = -matrix.m12 * scale;
    Matrix::new(matrix.m22 * scale, side, side, matrix.m11 * scale)
}
