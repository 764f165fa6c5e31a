//! What a kind of hinge is to the equations.

use super::{HingeGeometry, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};

/// The law of a kind of hinge. Every kind says all of it, in this order.
pub trait HingeLaw<S: Scalar> {
    /// The geometry at coordinates `q`, in aligned axes.
    fn geometry(&self, numbers: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S>;
    /// The rotation from aligned axes to those of the hinge's frames.
    fn alignment(&self, numbers: &SymbolValues<S>) -> Mat3<S>;
    /// The time derivative of the coordinates at rates `v`.
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S>;
    /// The coordinates with quaternions put back to unit length.
    fn normalized(&self, q: &[S]) -> Vec<S>;
    /// How rates become strain rates.
    fn strains(&self, q: &[S]) -> StrainMap<S>;
}

/// The alignment of a hinge whose free directions lie along the axes of its frames.
pub fn identity_alignment<S: Scalar>() -> Mat3<S> {
    Mat3::identity()
}

/// The rates of coordinates that change by the hinge's rates, `q̇ = v`.
pub fn rates_are_coordinate_rates<S: Scalar>(v: &[S]) -> Vec<S> {
    v.to_vec()
}

/// Coordinates with no quaternion among them, which have no length to keep.
pub fn without_quaternions<S: Scalar>(q: &[S]) -> Vec<S> {
    q.to_vec()
}
