//! A point fixed in a body.

use core::fmt::Debug;

/// The motion of a body as generated code stores it: [`SpaceMotion`](crate::SpaceMotion),
/// [`PlaneMotion`](crate::PlaneMotion) or [`LineMotion`](crate::LineMotion).
pub trait BodyMotion: Copy + Debug {
    /// The scalar type.
    type Scalar;
    /// An array of the components of a vector, one per dimension of the chain.
    type Vector: Copy + Debug;
    /// The rotation of a frame relative to its body.
    type Rotation: Copy + Debug;

    /// Returns the input of the body and the rotation of its frame.
    #[doc(hidden)]
    fn input() -> (Self::Vector, Self::Rotation);
}

/// The kinematics of a point fixed in a body: an input or output, a centre of mass, a named point, or any vector on the
/// body.
///
/// `M` is the motion of the body, `N` the number of free rates. `C` holds the columns of the Jacobian if the chain
/// computes them. Each method computes its value when it is called; a Jacobian and its products cost as many operations
/// as the path from the ground to the body has rates.
///
/// A Jacobian J has one column for each free rate, in the order of `v` of the state. J v is the velocity of the point
/// without prescribed motions; J v̇ plus the bias acceleration is its acceleration. A closed chain is treated as its
/// tree, with the closing hinge open.
#[doc(alias("frame", "site", "marker", "operational frame", "end effector", "tool centre point"))]
#[derive(Clone, Copy, Debug)]
pub struct PointKinematics<M: BodyMotion, const N: usize, C> {
    pub(super) motion: M,
    pub(super) place: M::Vector,
    pub(super) rotation: M::Rotation,
    pub(super) columns: C,
}

impl<M: BodyMotion, const N: usize, C> PointKinematics<M, N, C> {
    /// Makes the point at `place`, in m in the body frame, whose frame is rotated relative to the body.
    #[doc(hidden)]
    #[inline]
    pub fn new(motion: M, (place, rotation): (M::Vector, M::Rotation), columns: C) -> Self {
        Self { motion, place, rotation, columns }
    }
}
