//! Motion and internal loads at a connection point, in space, in the plane and along a line.

mod body_point;
mod line;
mod plane;
mod results;
mod rows;
mod slots;
mod space;

pub use body_point::BodyPoint;
pub use line::{LinePoint, LineStateVector};
pub use plane::{PlanePoint, PlaneStateVector};
pub use results::{AllResults, HasPoses, HasVelocities, HasZ, Results};
pub(crate) use rows::{Group, PointRow};
#[doc(hidden)]
pub use slots::{PointSlots, vector_at};
pub use space::{Point, StateVector};

/// A connection point of any kind of chain: [`Point`] in space, [`PlanePoint`] in the plane,
/// [`LinePoint`] along a line.
pub trait ConnectionPoint {
    /// The scalar type of the point's motion and loads.
    type Scalar;
    /// An array of the components of a vector, one per dimension of the chain.
    type Vector;
    /// The columns of a rotation matrix in space, the first column in the plane, nothing on a line.
    type Axes;
}

impl<T, R> ConnectionPoint for Point<T, R> {
    type Scalar = T;
    type Vector = [T; 3];
    type Axes = [[T; 3]; 3];
}

impl<T, R> ConnectionPoint for PlanePoint<T, R> {
    type Scalar = T;
    type Vector = [T; 2];
    type Axes = [[T; 2]; 1];
}

impl<T, R> ConnectionPoint for LinePoint<T, R> {
    type Scalar = T;
    type Vector = [T; 1];
    type Axes = [[T; 1]; 0];
}
