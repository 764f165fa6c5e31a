//! The matrices for motion in the x, y plane: 7×7, for
//! z = \[ẍ, ÿ, Ω̇_z, m_z, q_x, q_y, 1\] `[P, Eq. (6)]`.

use nalgebra::{SMatrix, Vector2};

use super::TransferMatrix;
use super::algebra::{block, entry, identity, pick, solve, with, zeros};
use crate::Scalar;

/// Which entries of the spatial z stay in a plane `[P, Eqs. (3), (6)]`.
const ENTRIES: [usize; 7] = [0, 1, 5, 8, 9, 10, 12];

/// The rows and columns of a spatial transfer matrix that stay in a plane. It is exact where nothing
/// leads out of the plane, since the others are then not coupled to them.
pub fn cut<T: Scalar>(u: &TransferMatrix<T>) -> TransferMatrix<T, 7> {
    pick(u, &ENTRIES)
}

/// The constant properties of a body in the plane, in its own frame with the origin at its input I.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body<T> {
    /// m in kg.
    pub mass: T,
    /// l_IC in m, the vector from I to the centre of mass.
    pub com: Vector2<T>,
    /// l_IO in m, the vector from I to the output.
    pub output: Vector2<T>,
    /// J_I about I in kg m².
    pub inertia: T,
}

/// The motion of a body in the plane, and the loads on it except the forces at its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Acting<T> {
    /// θ₃ of the body's frame in rad.
    pub angle: T,
    /// Ω_z in rad/s.
    pub angular_velocity: T,
    /// f_C in N at the centre of mass, inertial frame.
    pub force: Vector2<T>,
    /// m_C about z in N m.
    pub moment: T,
}

impl<T: Scalar> Body<T> {
    /// The transfer matrix of the body in the plane `[P, Eqs. (20), (21)]`.
    pub fn transfer_matrix(&self, acting: &Acting<T>) -> TransferMatrix<T, 7> {
        let ([sin], [cos]) = T::sin_cos([acting.angle]);
        let turned = |l: &Vector2<T>| {
            let [x, y] = (*l).into();
            [cos * x - sin * y, sin * x + cos * y]
        };
        let ([xo, yo], [xc, yc]) = (turned(&self.output), turned(&self.com));
        let ([fx, fy], omega) = (acting.force.into(), acting.angular_velocity);
        let (m, square, o, one) = (self.mass, omega * omega, T::default(), T::constant(1.0));
        let (e5x, e5y) = (fx + m * square * xc, fy + m * square * yc);
        let e9 = xc * -fy + yc * fx - acting.moment;
        let turning = self.inertia - m * (yo * yc + xo * xc);
        SMatrix::from([
            [one, o, o, m * (yo - yc), -m, o, o],
            [o, one, o, m * (xc - xo), o, -m, o],
            [-yo, xo, one, turning, m * yc, -(m * xc), o],
            [o, o, o, one, o, o, o],
            [o, o, o, -yo, one, o, o],
            [o, o, o, xo, o, one, o],
            [-(square * xo), -(square * yo), o, xo * e5y - yo * e5x + e9, e5x, e5y, one],
        ])
    }
}

/// The transfer matrix of a pin in the plane, which is the same as a ball's
/// `[P, Eqs. (31), (43)]`. `body` is that of its outboard body, whose output is another pin or a
/// free end.
///
/// Ω̇_O does not depend on Ω̇_I: the axes are all the same.
pub fn pin<T: Scalar>(body: &TransferMatrix<T, 7>) -> TransferMatrix<T, 7> {
    let rate = -entry(body, (3, 2)).recip();
    let row = SMatrix::<T, 1, 7>::from_fn(|_, column| {
        if column == 2 { T::default() } else { entry(body, (3, column)) * rate }
    });
    with(identity(), (2, 0), &row)
}

/// The transfer matrix of an acceleration hinge in the plane `[P, Eqs. (65), (66)]`. `body` is that of
/// its outboard body, whose output is another such hinge or a free end.
pub fn acceleration_hinge<T: Scalar>(body: &TransferMatrix<T, 7>) -> TransferMatrix<T, 7> {
    let u1 = block::<T, 3, 3, 7, 7>(body, (3, 0));
    let u2 = block::<T, 3, 3, 7, 7>(body, (3, 3));
    let u3 = block::<T, 3, 1, 7, 7>(body, (3, 6));
    let u = with(identity(), (0, 0), &zeros::<T, 3, 3>());
    with(with(u, (0, 3), &solve(u1, -u2)), (0, 6), &solve(u1, -u3))
}
