//! The equations of a plane pendulum of homogeneous rods by Lagrange's method, to which the paper
//! compares its own `[P, Section 4.3]`.

use nalgebra::{SMatrix, SVector};

use super::algebra::{solve, sum};
use crate::Scalar;

/// A rod of a plane pendulum, and how it moves.
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

/// θ̈ in rad/s² of all rods, from the one that hangs on the ground on, under gravity g in m/s² along
/// −y: A θ̈ = −B θ̇² − \[g l_i (m_i/2 + m_{i+1} + … + m_n) cos θ_i\] `[P, Eq. (46)]`.
///
/// a_ij = l_i l_j (m_k/2 + m_{k+1} + … + m_n) cos(θ_i − θ_j) with k = max(i, j); the paper prints k = j,
/// which would leave A without symmetry. b_ij with sin(θ_i − θ_j) is the same otherwise.
pub fn pendulum<T: Scalar, const N: usize>(rods: &[Rod<T>; N], gravity: T) -> SVector<T, N> {
    let half = T::constant(0.5);
    let beyond = |k: usize| sum(rods.iter().skip(k + 1).map(|rod| rod.mass));
    let carried = |k: usize| rods[k].mass * half + beyond(k);
    let lever = |i: usize, j: usize| rods[i].length * rods[j].length * carried(i.max(j));
    let turned = |i: usize, j: usize| {
        let ([sin], [cos]) = T::sin_cos([rods[i].angle - rods[j].angle]);
        (sin, cos)
    };
    let a = SMatrix::<T, N, N>::from_fn(|i, j| {
        let rod = &rods[i];
        if i == j {
            let quarter = rod.mass * T::constant(0.25);
            (quarter + beyond(i)) * rod.length * rod.length + rod.inertia
        } else {
            lever(i, j) * turned(i, j).1
        }
    });
    let right = SVector::<T, N>::from_fn(|i, _| {
        let square = |j: usize| rods[j].rate * rods[j].rate;
        let turning = sum((0..N).map(|j| lever(i, j) * turned(i, j).0 * square(j)));
        let ([_], [cos]) = T::sin_cos([rods[i].angle]);
        -turning - gravity * rods[i].length * carried(i) * cos
    });
    solve(a, right)
}
