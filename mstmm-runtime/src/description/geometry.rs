//! Where things are on a chain: the ends of springs, and the axes of hinges.

use nalgebra::Vector3;

use super::items::Element;
use crate::Scalar;

/// An end of a spring: a point that is fixed in a body or on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringEnd<T> {
    /// The index of its body in [`Description::bodies`](super::Description::bodies); `None` on the ground.
    pub body: Option<usize>,
    /// The point in m: in the frame of its body, on the ground in the inertial frame. In plane and line chains, entries
    /// that the description does not have are zero.
    pub position: Vector3<T>,
}

/// An axis of a hinge.
///
/// It passes through the origin of a connection point of the hinge. A slider translates along its axis, a pin rotates
/// about its axis, a screw and a cylindrical hinge do both. A universal hinge rotates about its first axis, which is fixed
/// on the inboard side, then about its second axis, which is fixed on the outboard side. Of a gimbal these are the first
/// and the third axis; the axis between them is fixed on neither side. A planar hinge rotates about its normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HingeAxis<T> {
    /// The index of the connection point in [`Description::points`](super::Description::points) whose frame it is fixed
    /// in.
    pub point: usize,
    /// The direction, a unit vector in the frame of the connection point.
    pub direction: Vector3<T>,
}

/// A spring between two bodies, or between a body and the ground.
///
/// [`Described::spring_ends`](super::Described::spring_ends) returns its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    path: &'static str,
    ends: [WrittenEnd; 2],
}

impl Spring {
    pub(crate) const fn new(path: &'static str, ends: [WrittenEnd; 2]) -> Self {
        Spring { path, ends }
    }

    pub(super) fn ends(&self) -> [WrittenEnd; 2] {
        self.ends
    }
}

impl Element for Spring {
    fn path(&self) -> &'static str {
        self.path
    }
}

/// An end of a spring with default parameters, for generated code.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenEnd {
    /// The bodies; `None` on the ground.
    bodies: Option<Indices>,
    /// The points in the first repetition and in later ones.
    at: [[f64; 3]; 2],
}

impl WrittenEnd {
    pub(crate) const fn new(bodies: Option<Indices>, at: [[f64; 3]; 2]) -> Self {
        WrittenEnd { bodies, at }
    }

    pub(super) fn body(&self, repetition: usize) -> Option<usize> {
        self.bodies.map(|bodies| bodies.at(repetition))
    }

    pub(super) fn position(&self, repetition: usize) -> [f64; 3] {
        let [first, later] = self.at;
        if repetition == 0 { first } else { later }
    }
}

/// The index of an element in each repetition, for generated code.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Indices {
    /// The index in the first repetition.
    first: usize,
    /// The index in the second repetition.
    second: usize,
    /// The difference of the indices in two successive later repetitions.
    stride: usize,
}

impl Indices {
    pub(crate) const fn new([first, second, stride]: [usize; 3]) -> Self {
        Indices { first, second, stride }
    }

    pub(super) fn at(self, repetition: usize) -> usize {
        match repetition.checked_sub(1) {
            None => self.first,
            Some(later) => self.second + later * self.stride,
        }
    }
}

/// Two vectors that parameters may change, for generated code: the ends of a spring or the axes of a hinge.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenVectors<T> {
    /// The row of the spring or the hinge in its table.
    pub row: usize,
    /// The repetition.
    pub index: usize,
    /// The components.
    pub vectors: [[T; 3]; 2],
}

impl<T: Scalar> WrittenVectors<T> {
    /// Returns vectors in a scalar type, for a row and a repetition.
    pub(super) fn new(row: usize, index: usize, vectors: [[f64; 3]; 2]) -> Self {
        WrittenVectors { row, index, vectors: vectors.map(|vector| vector.map(T::constant)) }
    }
}

/// Returns the direction of a vector that is not zero.
pub(super) fn direction<T: Scalar>([x, y, z]: [T; 3]) -> Vector3<T> {
    let inverse = (x * x + y * y + z * z).sqrt().recip();
    Vector3::new(x * inverse, y * inverse, z * inverse)
}
