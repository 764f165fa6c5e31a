//! Floating (free flyer): no constraint; the paper's acceleration hinge [P, Sect. A.2].
//!
//! Coordinates: the outboard origin in m, inboard axes, then the quaternion as for a ball. Rates:
//! the velocity of that origin in m/s, inboard axes, then the angular velocity as for a ball.

use super::ball::{self, Ball};
use super::law::{HingeLaw, identity_alignment};
use super::{HingeGeometry, StrainMap, SubspaceColumn};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar, Vec3};

/// A floating hinge.
#[derive(Clone, Copy, Debug)]
pub struct Floating;

impl<S: Scalar> HingeLaw<S> for Floating {
    /// A translation and a rotation, both free: `m = 0` and `q = 0` [P, Eqs. (57), (58)].
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S> {
        HingeGeometry {
            offset: Vec3([q[0], q[1], q[2]]),
            columns: columns(),
            ..Ball.geometry(values, &q[3..])
        }
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    /// The rates of the origin and of the quaternion.
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S> {
        let mut rates = v[..3].to_vec();
        rates.extend(Ball.coordinate_rates(&q[3..], &v[3..]));
        rates
    }

    /// The coordinates with the quaternion divided by its norm.
    fn normalized(&self, q: &[S]) -> Vec<S> {
        let mut coordinates = q[..3].to_vec();
        coordinates.extend(Ball.normalized(&q[3..]));
        coordinates
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::identity(6)
    }
}

/// Returns the translations along the inboard axes, then the rotations about the outboard axes.
pub fn columns<S: Scalar>() -> Vec<SubspaceColumn<S>> {
    let translations = (0..3).map(|k| SubspaceColumn::translation(Vec3::unit(k)));
    translations.chain(ball::rotations()).collect()
}
