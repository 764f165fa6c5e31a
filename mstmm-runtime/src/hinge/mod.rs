//! Views of hinges by name: their coordinates in a state, their motions, and their results.
//!
//! The methods of a generated state return these views, for example `state.elbow()` and `state.elbow_mut()`. Views for
//! reading have copies of the values, views for writing have references into the arrays of the state. Both use the
//! vectors and quaternions of nalgebra; in the arrays a quaternion is stored as w, x, y, z.
//!
//! nalgebra needs its feature `std` or `libm` to compose or apply these orientations; without these features their
//! components can still be read.

mod ball;
mod cylindrical;
mod elastic;
mod floating;
mod gimbal;
mod motion;
mod orientation;
mod pin;
mod planar;
mod plane_elastic;
mod result;
mod screw;
mod slider;
mod universal;

pub use ball::{BallState, BallStateMut};
pub use cylindrical::{CylindricalState, CylindricalStateMut};
pub use elastic::{ElasticState, ElasticStateMut};
pub use floating::{FloatingState, FloatingStateMut};
pub use gimbal::{GimbalState, GimbalStateMut};
pub use motion::HingeMotion;
pub use pin::{PinState, PinStateMut};
pub use planar::{PlanarState, PlanarStateMut};
pub use plane_elastic::{PlaneElasticState, PlaneElasticStateMut};
pub use result::HingeResult;
pub use screw::{ScrewState, ScrewStateMut};
pub use slider::{SliderState, SliderStateMut};
pub use universal::{UniversalState, UniversalStateMut};
