//! Bodies and their inertia.

use nalgebra::{Matrix3, Vector3};

use super::items::Element;
use super::{Dimension, Shape};
use crate::Scalar;

/// A body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    path: &'static str,
    type_name: &'static str,
    inertia: WrittenInertia,
    shapes: &'static [Shape],
}

impl Body {
    /// Returns the name of its type in the description.
    #[must_use]
    pub fn type_name(&self) -> &'static str {
        self.type_name
    }

    /// Returns its shapes for pictures, in the order of the description; empty if it has none.
    #[must_use]
    pub fn shapes(&self) -> &'static [Shape] {
        self.shapes
    }

    pub(super) fn inertia(&self) -> WrittenInertia {
        self.inertia
    }
}

#[doc(hidden)]
impl Body {
    /// Sets its shapes.
    #[must_use]
    pub const fn shaped(mut self, shapes: &'static [Shape]) -> Self {
        self.shapes = shapes;
        self
    }
}

impl Element for Body {
    fn path(&self) -> &'static str {
        self.path
    }
}

/// Mass, centre of mass and tensor as the description has them, with default parameters; for generated code.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenInertia<T = f64> {
    /// The row of the body in the table.
    pub row: usize,
    /// The repetition of the body.
    pub index: usize,
    /// Mass in kg.
    pub mass: T,
    /// Centre of mass in m, body frame.
    pub com: [T; 3],
    /// Entries xx, yy, zz, xy, xz, yz of the tensor in kg m².
    pub tensor: [T; 6],
    /// Whether the tensor is about the centre of mass; otherwise about the input.
    pub about_com: bool,
}

#[doc(hidden)]
impl WrittenInertia {
    /// Makes an inertia.
    pub(crate) const fn new(mass: f64, com: [f64; 3], tensor: [f64; 6], about_com: bool) -> Self {
        WrittenInertia { row: 0, index: 0, mass, com, tensor, about_com }
    }

    /// Makes a body with this inertia.
    #[must_use]
    pub const fn named(self, path: &'static str, type_name: &'static str) -> Body {
        Body { path, type_name, inertia: self, shapes: &[] }
    }

    /// Returns the inertia in a scalar type, for a row and a repetition.
    pub(super) fn of_scalar<T: Scalar>(self, row: usize, index: usize) -> WrittenInertia<T> {
        WrittenInertia {
            row,
            index,
            mass: T::constant(self.mass),
            com: self.com.map(T::constant),
            tensor: self.tensor.map(T::constant),
            about_com: self.about_com,
        }
    }
}

/// The inertia of a body. In plane and line chains, entries that the description does not have are zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyInertia<T> {
    /// Mass in kg.
    pub mass: T,
    /// Centre of mass in m, in the body frame, whose origin is the input.
    pub com: Vector3<T>,
    /// Inertia tensor about the centre of mass in kg m², in axes of the body frame. Its products of inertia are its
    /// entries: xy = −∫ x y dm.
    pub tensor: Matrix3<T>,
}

impl<T: Scalar> WrittenInertia<T> {
    /// Returns the inertia about the centre of mass: `I_C = I_I − m (|c|² 1 − c cᵀ)`.
    pub(super) fn about_com(self, dimension: Dimension) -> BodyInertia<T> {
        let WrittenInertia { mass, com, tensor, about_com, .. } = self;
        let [x, y, z] = com;
        let moved = [y * y + z * z, x * x + z * z, x * x + y * y, -(x * y), -(x * z), -(y * z)];
        let has_entry = |entry: usize| match dimension {
            Dimension::Space => true,
            Dimension::Plane => entry == ZZ,
            Dimension::Line => false,
        };
        let mut about = tensor;
        for (number, (entry, factor)) in about.iter_mut().zip(moved).enumerate() {
            if !about_com && has_entry(number) {
                *entry -= mass * factor;
            }
        }
        let [xx, yy, zz, xy, xz, yz] = about;
        let tensor = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        BodyInertia { mass, com: com.into(), tensor }
    }
}

/// The index of the entry zz.
const ZZ: usize = 2;
