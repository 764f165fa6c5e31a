//! The matrices for motion along x: 3×3, for z = \[ẍ, q_x, 1\] `[P, Eq. (7)]`, and
//! the masses between springs of `[P, Section 4.4]`.

use nalgebra::Matrix3;

use super::TransferMatrix;
use super::algebra::pick;
use crate::Scalar;

/// Which entries of the spatial z stay on a line `[P, Eqs. (3), (7)]`.
const ENTRIES: [usize; 3] = [0, 9, 12];

/// The rows and columns of a spatial transfer matrix that stay on a line.
pub fn cut<T: Scalar>(u: &TransferMatrix<T>) -> TransferMatrix<T, 3> {
    pick(u, &ENTRIES)
}

/// The transfer matrix of a body of the given mass (kg) on which the load F (N) acts, the springs at
/// its sides included `[P, Eq. (47)]`.
pub fn body<T: Scalar>(mass: T, load: T) -> TransferMatrix<T, 3> {
    let (o, one) = (T::default(), T::constant(1.0));
    Matrix3::new(one, o, o, -mass, one, load, o, o, one)
}

/// The transfer matrix of an acceleration hinge before a body of the given mass (kg) on which the
/// load F (N) acts, as printed `[P, Eq. (52)]`: ẍ_O = F/m `[P, Eq. (50)]`, and q passes unchanged
/// `[P, Eq. (51)]`.
///
/// It holds because q is zero at such a hinge. The line cut of (66) is
/// [`acceleration_hinge_for_any_force`].
pub fn acceleration_hinge<T: Scalar>(mass: T, load: T) -> TransferMatrix<T, 3> {
    let (o, one) = (T::default(), T::constant(1.0));
    Matrix3::new(o, o, load * mass.recip(), o, one, o, o, o, one)
}

/// The line cut of `[P, Eq. (66)]`, with ẍ_O = (q + F)/m in place of (52)'s F/m.
pub fn acceleration_hinge_for_any_force<T: Scalar>(mass: T, load: T) -> TransferMatrix<T, 3> {
    let (o, one, inverse) = (T::default(), T::constant(1.0), mass.recip());
    Matrix3::new(o, inverse, load * inverse, o, one, o, o, o, one)
}

/// A mass between springs, and its motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass<T> {
    /// x in m.
    pub position: T,
    /// ẋ in m/s.
    pub velocity: T,
    /// The force f in N, without springs and dampers.
    pub force: T,
    /// k in N/m of the spring at its inboard side; the first one leads to a wall at x = 0.
    pub stiffness: T,
    /// c in N s/m of the damper at its inboard side.
    pub damping: T,
}

/// F in N of each mass: its own force and those of springs and dampers at both sides
/// `[P, Eq. (48)]`; the last one has none at its outboard side `[P, Eq. (49)]`.
///
/// The springs have no length without load. (48) is printed for the first mass as well; for it,
/// x₀ = ẋ₀ = 0 is the wall.
pub fn loads<T: Scalar, const N: usize>(masses: &[Mass<T>; N]) -> [T; N] {
    let mut loads = masses.map(|mass| mass.force);
    let (mut before, mut velocity_before) = (T::default(), T::default());
    let mut inboard: Option<&mut T> = None;
    for (load, mass) in loads.iter_mut().zip(masses) {
        let pull = mass.stiffness * (before - mass.position)
            + mass.damping * (velocity_before - mass.velocity);
        *load += pull;
        if let Some(inboard) = inboard {
            *inboard -= pull;
        }
        (before, velocity_before, inboard) = (mass.position, mass.velocity, Some(load));
    }
    loads
}
