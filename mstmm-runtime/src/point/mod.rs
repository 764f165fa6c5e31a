//! Motion and internal loads at a connection point, in space, in the plane and along a line.

mod line;
mod places;
mod plane;
mod space;

pub use line::{LinePoint, LineStateVector};
#[doc(hidden)]
pub use places::Places;
pub use plane::{PlanePoint, PlaneStateVector};
pub use space::{Point, StateVector};

/// A connection point of any kind of chain: [`Point`] in space, [`PlanePoint`] in the plane,
/// [`LinePoint`] along a line.
pub trait ConnectionPoint {
    /// The numbers the point's motion and loads are kept in.
    type Scalar;
}

impl<T> ConnectionPoint for Point<T> {
    type Scalar = T;
}

impl<T> ConnectionPoint for PlanePoint<T> {
    type Scalar = T;
}

impl<T> ConnectionPoint for LinePoint<T> {
    type Scalar = T;
}
