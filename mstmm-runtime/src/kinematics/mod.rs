//! Kinematics of points on bodies: poses, velocities, bias accelerations and Jacobians, without dynamics.
//!
//! Vectors are in the inertial frame. The rows of a Jacobian are those of the motion of a point: its velocity ṙ, then
//! the angular velocity Ω of its body. In the plane the rows are x, y and the angle, on a line only x.

mod body;
mod columns;
mod frame;
mod inertia;
mod line;
mod plane;
mod point;
mod space;

pub use body::BodyKinematics;
pub use columns::{HasJacobian, NoColumns, RateColumns, RateRun};
pub use frame::{FrameMotion, JacobianSlice};
pub use inertia::{inverse_of_positive, inverse_operational_space_inertia};
pub use line::LineMotion;
pub use plane::PlaneMotion;
pub use point::{BodyMotion, PointKinematics};
pub use space::SpaceMotion;
