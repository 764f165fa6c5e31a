//! Weld: joins two frames for good.

use super::law::{HingeLaw, coordinates_change_by, free_of_quaternions, own_axes};
use super::{Geometry, Strains};
use crate::equations::Numbers;
use crate::math::{Mat3, Scalar};

/// A weld.
#[derive(Clone, Copy, Debug)]
pub struct Weld;

impl<S: Scalar> HingeLaw<S> for Weld {
    /// Both frames coincide, and nothing is free.
    fn geometry(&self, _: &Numbers<S>, _: &[S]) -> Geometry<S> {
        Geometry::fixed()
    }

    fn alignment(&self, _: &Numbers<S>) -> Mat3<S> {
        own_axes()
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        coordinates_change_by(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        free_of_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> Strains<S> {
        Strains::change_by_rates(0)
    }
}
