//! The equations of a plane pendulum of homogeneous rods by Lagrange's method, to which the paper
//! compares its own `[P, Section 4.3]`.

use nalgebra::{SMatrix, SVector};

use super::algebra::{solve, sum};
use crate::Scalar;

/// A rod of a plane pendulum, and its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rod<T> {
    /// m in kg.
    pub mass: T,
    /// l in m; the centre of mass lies in the middle.
    pub length: T,
    /// J_C about the centre of mass in kg m².
    pub inertia: T,
    /// θ in rad, from the horizontal.
    pub angle: T,
    /// θ̇ in rad/s.
    pub rate: T,
}

/// θ̈ in rad/s² of all rods, starting with the rod at the ground, under gravity g in m/s² along
/// −y: A θ̈ = −B θ̇² − \[g l_i (m_i/2 + m_{i+1} + … + m_n) cos θ_i\] `[P, Eq. (46)]`.
///
/// a_ij = l_i l_j (m_k/2 + m_{k+1} + … + m_n) cos(θ_i − θ_j) with k = max(i, j); the paper prints k = j,
/// which would leave A without symmetry. b_ij with sin(θ_i − θ_j) is the same otherwise.
pub fn pendulum<T: Scalar, const N: usize>(rods: &[Rod<T>; N], gravity: T) -> SVector<T, N> {
    let of = |k: usize, what: fn(&Rod<T>) -> T| rods.get(k).map_or(T::default(), what);
    let mass = |k: usize| of(k, |rod| rod.mass);
    let length = |k: usize| of(k, |rod| rod.length);
    let angle = |k: usize| of(k, |rod| rod.angle);
    let beyond = |k: usize| sum((k + 1..N).map(mass));
    let carried = |k: usize| mass(k) * T::constant(0.5) + beyond(k);
    let lever = |i: usize, j: usize| length(i) * length(j) * carried(i.max(j));
    let turned = |i: usize, j: usize| T::sin_cos([angle(i) - angle(j)]);
    let a = SMatrix::<T, N, N>::from_fn(|i, j| {
        if i == j {
            let quarter = mass(i) * T::constant(0.25);
            return (quarter + beyond(i)) * length(i) * length(i) + of(i, |rod| rod.inertia);
        }
        let (_, [cos]) = turned(i, j);
        lever(i, j) * cos
    });
    let right = SVector::<T, N>::from_fn(|i, _| {
        let turning = |j: usize| {
            let ([sin], _) = turned(i, j);
            lever(i, j) * sin * of(j, |rod| rod.rate * rod.rate)
        };
        let (_, [cos]) = T::sin_cos([angle(i)]);
        -sum((0..N).map(turning)) - gravity * length(i) * carried(i) * cos
    });
    solve(a, right)
}
