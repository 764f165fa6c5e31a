//! Springs and dampers of an elastic hinge `[P, Appendix A.1]`. Its transfer matrix is that of an
//! [`acceleration_hinge`](super::acceleration_hinge) between bodies on which these act as loads.

use nalgebra::{Matrix3, Vector3};

use super::algebra::Times;
use super::rotation;
use crate::Scalar;

/// A₁₂ = A₀₁ᵀ A₀₂, which takes components in the outboard frame to the inboard frame
/// `[P, Eq. (53)]`.
pub fn relative<T: Scalar>(inboard: &Matrix3<T>, outboard: &Matrix3<T>) -> Matrix3<T> {
    inboard.transpose().times(outboard)
}

/// θ_x, θ_y and θ_r of A₁₂ in rad: the large rotation θ_r about the inboard ζ axis, the third of the
/// angles `[P, Eqs. (1), (53)]`, and the two small ones from the intermediate frame on. It is the
/// paper's suggestion, and θ_y is within ±90°.
pub fn turns<T: Scalar>(relative: &Matrix3<T>) -> Vector3<T> {
    rotation::angles(relative)
}

/// Six springs with a damper each, along and about the axes of the intermediate frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Springs<T> {
    /// k_x, k_y, k_z in N/m.
    pub stiffness: Vector3<T>,
    /// c_x, c_y, c_z in N s/m.
    pub damping: Vector3<T>,
    /// k′_x, k′_y, k′_z in N m/rad.
    pub turning_stiffness: Vector3<T>,
    /// c′_x, c′_y, c′_z in N m s/rad.
    pub turning_damping: Vector3<T>,
}

impl<T: Scalar> Springs<T> {
    /// The torque m = \[k′_x θ_x + c′_x θ̇_x, k′_y θ_y + c′_y θ̇_y, k′_z θ_r + c′_z θ̇_r\] in N m, axes of the
    /// intermediate frame, that acts on the **inboard** body, its opposite on the outboard one
    /// `[P, Eq. (54)]`.
    ///
    /// The equation treats the efforts along the three angles as a moment about the axes of the intermediate frame. That is exact for θ_y = 0, k_x = k_y and c_x = c_y = 0. Otherwise conservation of energy requires
    /// m_z − (ζ × Δr) · f in place of m_z, and then for (m_x + m_z sin θ_y)/cos θ_y in place of
    /// m_x; the compiler's elastic hinge has these.
    pub fn torque(&self, turns: &Vector3<T>, rates: &Vector3<T>) -> Vector3<T> {
        along(&self.turning_stiffness, turns) + along(&self.turning_damping, rates)
    }

    /// The force f = \[k_x Δx + c_x Δẋ, …\] in N, axes of the intermediate frame, that acts on the
    /// **outboard** body at O, its opposite on the inboard one at the same point `[P, Eq. (54)]`.
    ///
    /// Δr and its rate, in m and m/s, lead from O to I in these axes. The third entry has k_z and
    /// c_z, where the paper prints k_y and c_y. If the two forces acted at O and at I, springs of
    /// different stiffness would make angular momentum of nothing.
    pub fn force(&self, shift: &Vector3<T>, rate: &Vector3<T>) -> Vector3<T> {
        along(&self.stiffness, shift) + along(&self.damping, rate)
    }
}

fn along<T: Scalar>(factors: &Vector3<T>, values: &Vector3<T>) -> Vector3<T> {
    factors.zip_map(values, |factor, value| factor * value)
}
