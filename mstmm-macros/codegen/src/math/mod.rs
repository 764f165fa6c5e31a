//! Vectors, matrices and spatial algebra, generic over the scalar: the compiler runs them on
//! formulas, the tests on plain numbers.

mod dual;
mod matrix;
mod orientation;
mod rotation;
mod scalar;
mod spatial;
mod structured;
mod tolerances;
mod vector;

pub use dual::Dual;
pub use matrix::{Mat3, Sym3};
pub use orientation::FrameOrientation;
pub use rotation::{AxisRotation, PlaneFormula, Rotation};
pub use scalar::Scalar;
pub use spatial::{Motion, SpatialInertia, Wrench};
pub use structured::Structured;
pub use tolerances::{CORRECTIONS, LARGEST_ROTATION, PIVOT_ULPS, RANK_ULPS};
pub use vector::Vec3;
