//! The interface between a kind of hinge and the equations.

use super::{HingeGeometry, StrainMap};
use crate::equations::SymbolValues;
use crate::math::{Mat3, Scalar};

/// The law of a kind of hinge. Every kind implements all functions, in this order.
pub trait HingeLaw<S: Scalar> {
    /// Returns the geometry at coordinates `q`, in aligned axes.
    fn geometry(&self, values: &SymbolValues<S>, q: &[S]) -> HingeGeometry<S>;
    /// Returns the rotation from aligned axes to the axes of the hinge's frames.
    fn alignment(&self, values: &SymbolValues<S>) -> Mat3<S>;
    /// Returns the time derivative of the coordinates at rates `v`.
    fn coordinate_rates(&self, q: &[S], v: &[S]) -> Vec<S>;
    /// Returns the coordinates with quaternions normalised to unit norm.
    fn normalized(&self, q: &[S]) -> Vec<S>;
    /// Returns the map from rates to strain rates.
    fn strains(&self, q: &[S]) -> StrainMap<S>;
}

/// The alignment of a hinge whose motion subspace lies along the axes of its frames.
pub fn identity_alignment<S: Scalar>() -> Mat3<S> {
    Mat3::identity()
}

/// The time derivative of coordinates whose derivatives are the rates, `q̇ = v`.
pub fn rates_are_coordinate_rates<S: Scalar>(v: &[S]) -> Vec<S> {
    v.to_vec()
}

/// Coordinates that contain no quaternion and need no normalisation.
pub fn without_quaternions<S: Scalar>(q: &[S]) -> Vec<S> {
    q.to_vec()
}
