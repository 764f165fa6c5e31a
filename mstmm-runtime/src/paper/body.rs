//! A rigid body moving in space, from its input end I to its output end O `[P, Section 3.1]`.

use nalgebra::{Matrix3, Vector3};

use super::TransferMatrix;
use super::algebra::{Times, block, identity, tilde, with};
use crate::Scalar;

/// The properties of a body, in the body frame with the origin I.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<T> {
    /// m in kg.
    pub mass: T,
    /// l_IC, the centre of mass relative to I, in m.
    pub com: Vector3<T>,
    /// l_IO, the output relative to I, in m.
    pub output: Vector3<T>,
    /// J_I, the inertia about I, in kg m².
    pub inertia: Matrix3<T>,
}

/// The orientation and the angular velocity of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T> {
    /// A_I, which takes components in the body frame to inertial components.
    pub orientation: Matrix3<T>,
    /// Ω_I in rad/s, inertial frame.
    pub angular_velocity: Vector3<T>,
}

/// The loads on a body in addition to the forces at its ends, inertial frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load<T> {
    /// f_C in N, at the centre of mass; weight belongs here.
    pub force: Vector3<T>,
    /// m_C in N m.
    pub moment: Vector3<T>,
}

impl<T: Scalar> Body<T> {
    /// r_O = r_I + A_I l_IO in m `[P, Eq. (12)]`, where the text has r₀ for r_O.
    pub fn output_position(&self, input: &Vector3<T>, orientation: &Matrix3<T>) -> Vector3<T> {
        input + orientation.times(&self.output)
    }

    /// Returns the coefficients of the equations of the body `[P, Eq. (20)]`.
    pub fn blocks(&self, motion: &Motion<T>, load: &Load<T>) -> Blocks<T> {
        let Motion { orientation: a, angular_velocity: omega } = motion;
        let (r_io, r_ic) = (tilde(&a.times(&self.output)), tilde(&a.times(&self.com)));
        let centripetal = tilde(omega).times(&tilde(omega));
        let own = a.transpose().times(omega);
        let gyroscopic = a.times(&tilde(&own)).times(&self.inertia).times(&own);
        Blocks {
            e1: -r_io,
            e2: centripetal.times(&a.times(&self.output)),
            e3: identity::<T, 3>() * -self.mass,
            e4: r_ic * self.mass,
            e5: load.force - centripetal.times(&a.times(&self.com)) * self.mass,
            e6: r_io,
            e7: r_ic * self.mass,
            e8: a.times(&self.inertia).times(&a.transpose()),
            e9: -load.moment - r_ic.times(&load.force) + gyroscopic,
        }
    }
}

/// E₁ to E₉ `[P, Eq. (20)]`, inertial frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocks<T> {
    /// E₁ = −r̃_IO in m.
    pub e1: Matrix3<T>,
    /// E₂ = Ω̃ Ω̃ r_IO in m/s².
    pub e2: Vector3<T>,
    /// E₃ = −m I₃ in kg.
    pub e3: Matrix3<T>,
    /// E₄ = m r̃_IC in kg m.
    pub e4: Matrix3<T>,
    /// E₅ = f_C − m Ω̃ Ω̃ r_IC in N.
    pub e5: Vector3<T>,
    /// E₆ = r̃_IO in m.
    pub e6: Matrix3<T>,
    /// E₇ = m r̃_IC in kg m.
    pub e7: Matrix3<T>,
    /// E₈ = A_I J_I A_Iᵀ in kg m².
    pub e8: Matrix3<T>,
    /// E₉ = −m_C − r̃_IC f_C + A_I ω̃_I J_I ω_I in N m.
    pub e9: Vector3<T>,
}

impl<T: Scalar> Blocks<T> {
    /// r̈_O = r̈_I + E₁ Ω̇_I + E₂ in m/s² `[P, Eqs. (13), (17)]`. The last term of (13) is
    /// Ω̃ Ω̃ r_IO, which the text has as Ω̃ Ω̃ with an index for r; in the line above it, Ã_I stands for
    /// Ω̃_I.
    pub fn output_acceleration(
        &self,
        acceleration: &Vector3<T>,
        angular_acceleration: &Vector3<T>,
    ) -> Vector3<T> {
        acceleration + self.e1.times(angular_acceleration) + self.e2
    }

    /// Newton's law `[P, Eq. (14)]` as q_O = q_I + E₃ r̈_I + E₄ Ω̇_I + E₅ in N `[P, Eq. (18)]`.
    pub fn output_force(
        &self,
        acceleration: &Vector3<T>,
        angular_acceleration: &Vector3<T>,
        input_force: &Vector3<T>,
    ) -> Vector3<T> {
        let inertial = self.e3.times(acceleration) + self.e4.times(angular_acceleration);
        input_force + inertial + self.e5
    }

    /// Euler's law about I `[P, Eq. (15)]` as m_O = m_I + E₆ q_O + E₇ r̈_I + E₈ Ω̇_I + E₉ in N m
    /// `[P, Eq. (19)]`.
    pub fn output_moment(
        &self,
        acceleration: &Vector3<T>,
        angular_acceleration: &Vector3<T>,
        input_moment: &Vector3<T>,
        output_force: &Vector3<T>,
    ) -> Vector3<T> {
        let inertial = self.e7.times(acceleration) + self.e8.times(angular_acceleration);
        input_moment + self.e6.times(output_force) + inertial + self.e9
    }

    /// The transfer matrix of the body `[P, Eq. (21)]`; its second row is Ω̇_O = Ω̇_I
    /// `[P, Eq. (16)]`. Its determinant is 1.
    pub fn transfer_matrix(&self) -> TransferMatrix<T> {
        let Self { e1, e2, e3, e4, e5, e6, e7, e8, e9 } = self;
        let mut u = identity();
        u = with(with(u, (0, 3), e1), (0, 12), e2);
        u = with(u, (6, 0), &(e6.times(e3) + e7));
        u = with(u, (6, 3), &(e6.times(e4) + e8));
        u = with(u, (6, 9), e6);
        u = with(u, (6, 12), &(e6.times(e5) + e9));
        with(with(with(u, (9, 0), e3), (9, 3), e4), (9, 12), e5)
    }
}

/// The third and fourth rows of blocks of a body's transfer matrix, which its inboard hinge needs
/// `[P, Eqs. (27), (60)]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rows<T> {
    /// u₃₁ to u₃₄: the coefficients of r̈_I, Ω̇_I, m_I and q_I in m_O `[P, Eqs. (28), (61)]`.
    pub moment: [Matrix3<T>; 4],
    /// u₃₅.
    pub moment_constant: Vector3<T>,
    /// u₄₁ to u₄₄: the same coefficients in q_O `[P, Eq. (62)]`.
    pub force: [Matrix3<T>; 4],
    /// u₄₅.
    pub force_constant: Vector3<T>,
}

impl<T: Scalar> Rows<T> {
    pub fn of(u: &TransferMatrix<T>) -> Self {
        let row = |row: usize| [0, 3, 6, 9].map(|column| block(u, (row, column)));
        Rows {
            moment: row(6),
            moment_constant: block(u, (6, 12)),
            force: row(9),
            force_constant: block(u, (9, 12)),
        }
    }
}
