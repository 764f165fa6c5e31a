//! Weld (fixed joint): joins two frames rigidly.

use super::law::{HingeLaw, identity_alignment, rates_are_coordinate_rates, without_quaternions};
use super::{HingeGeometry, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};

/// A weld.
#[derive(Clone, Copy, Debug)]
pub struct Weld;

impl<S: Scalar> HingeLaw<S> for Weld {
    /// Both frames coincide; no degree of freedom.
    fn geometry(&self, _: &SymbolValues<S>, _: &[S]) -> HingeGeometry<S> {
        HingeGeometry::fixed()
    }

    fn alignment(&self, _: &SymbolValues<S>) -> Mat3<S> {
        identity_alignment()
    }

    fn coordinate_rates(&self, _: &[S], v: &[S]) -> Vec<S> {
        rates_are_coordinate_rates(v)
    }

    fn normalized(&self, q: &[S]) -> Vec<S> {
        without_quaternions(q)
    }

    fn strains(&self, _: &[S]) -> StrainMap<S> {
        StrainMap::identity(0)
    }
}
