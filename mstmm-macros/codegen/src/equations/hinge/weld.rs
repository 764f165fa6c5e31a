//! Weld: joins two frames for good.

use super::law::{HingeLaw, coordinates_change_by, free_of_quaternions, own_axes};
use super::{HingeGeometry, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};

/// A weld.
#[derive(Clone, Copy, Debug)]
pub struct Weld;

impl<S: Scalar> HingeLaw<S> for Weld {
    /// Both frames coincide, and nothing is free.
    fn geometry(&self, _: &SymbolValues<S>, _: &[S]) -> HingeGeometry<S> {
        HingeGeometry::fixed()
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        own_axes()
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        coordinates_change_by(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        free_of_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::change_by_rates(0)
    }
}
