//! Vectors with three components.

use super::Scalar;
use std::ops::{Add, Index, Mul, Neg, Sub};

/// A vector; the context names its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<S>(pub [S; 3]);

impl<S: Scalar> Vec3<S> {
    /// The zero vector.
    pub fn zero() -> Self {
        Vec3([S::zero(); 3])
    }

    /// The vector with `entry(axis)`.
    pub fn from_fn(entry: impl Fn(usize) -> S) -> Self {
        // `map` costs several times as much without optimisation, as macros are built.
        Vec3([entry(0), entry(1), entry(2)])
    }

    /// The unit vector along axis `k`.
    pub fn unit(k: usize) -> Self {
        Vec3::from_fn(|i| if i == k { S::one() } else { S::zero() })
    }

    /// Returns `self · other`.
    pub fn dot(self, other: Self) -> S {
        self[0] * other[0] + self[1] * other[1] + self[2] * other[2]
    }

    /// Returns `self × other`.
    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Vec3([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    /// Returns the centripetal acceleration `Ω̃ Ω̃ r` of a point at `self`, relative to the origin
    /// of a body that rotates with `omega` [P, Eq. (13)]. This form shares `Ω̃ r` with the point's
    /// velocity.
    pub fn centripetal(self, omega: Self) -> Self {
        omega.cross(omega.cross(self))
    }

    /// Returns the same by products of rates, which all points of a body share.
    pub fn centripetal_by_products(self, omega: Self) -> Self {
        let product = |i: usize, j: usize| omega[i] * omega[j];
        Vec3::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let along = product(k, i) * self[i] + product(k, j) * self[j];
            along - (product(i, i) + product(j, j)) * self[k]
        })
    }
}

impl<S> Index<usize> for Vec3<S> {
    type Output = S;
    fn index(&self, k: usize) -> &S {
        &self.0[k]
    }
}

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Vec3::from_fn(|k| self[k] + other[k])
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Vec3::from_fn(|k| self[k] - other[k])
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    fn neg(self) -> Self {
        Vec3::from_fn(|k| -self[k])
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;
    fn mul(self, factor: S) -> Self {
        Vec3::from_fn(|k| self[k] * factor)
    }
}
