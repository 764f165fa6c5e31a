//! Named views of hinges: their coordinates in a state, and what a solution says of them.
//!
//! The accessors of a generated state hand out these views, such as `state.elbow()` and
//! `state.elbow_mut()`. Views to read hold copies, views to write hold references into the state's
//! arrays. Both speak nalgebra's vectors and quaternions; in the arrays a quaternion lies as w, x,
//! y, z.
//!
//! To compose or apply the orientations they hand out, nalgebra needs its feature `std` or `libm`;
//! without either it still hands over their components.

mod ball;
mod cylindrical;
mod elastic;
mod floating;
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
pub use motion::HingeMotion;
pub use pin::{PinState, PinStateMut};
pub use planar::{PlanarState, PlanarStateMut};
pub use plane_elastic::{PlaneElasticState, PlaneElasticStateMut};
pub use result::HingeResult;
pub use screw::{ScrewState, ScrewStateMut};
pub use slider::{SliderState, SliderStateMut};
pub use universal::{UniversalState, UniversalStateMut};
