//! The state vectors at a connection point as columns.
//!
//! [`StateVector`], [`PlaneStateVector`](crate::PlaneStateVector) and
//! [`LineStateVector`](crate::LineStateVector) are the same with names; their `to_vector` makes the
//! columns `[P, Eqs. (3), (6), (7)]`. The paper's (2), with positions in place of accelerations, is
//! of the method that it replaces.

use nalgebra::{SVector, Vector3};

use super::algebra::block;
use crate::{Scalar, StateVector};

/// z = \[r̈, Ω̇, m, q, 1\] in m/s², rad/s², N·m and N, inertial frame `[P, Eq. (4)]`.
pub fn column<T: Scalar>(
    acceleration: &Vector3<T>,
    angular_acceleration: &Vector3<T>,
    moment: &Vector3<T>,
    force: &Vector3<T>,
) -> SVector<T, 13> {
    let [acceleration, angular_acceleration, moment, force] =
        [acceleration, angular_acceleration, moment, force].map(|vector| (*vector).into());
    StateVector::new(acceleration, angular_acceleration, moment, force).to_vector()
}

/// The blocks r̈, Ω̇, m and q of z `[P, Eq. (5)]`.
pub fn blocks<T: Scalar>(z: &SVector<T, 13>) -> StateVector<T> {
    let [acceleration, angular_acceleration, moment, force] =
        [0, 3, 6, 9].map(|row| block::<T, 3, 1, 13, 1>(z, (row, 0)).into());
    StateVector::new(acceleration, angular_acceleration, moment, force)
}
