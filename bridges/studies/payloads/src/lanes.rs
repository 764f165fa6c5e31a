//! Scalars of one lane or of several lanes.

use mstmm::Scalar;
use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};

/// A scalar of one lane or of several lanes.
pub trait Lanes: Scalar {
    /// Returns the scalar with the given value in each lane.
    fn from_lanes(lane: impl FnMut(usize) -> f64) -> Self;

    /// Returns the value of a lane.
    fn lane(self, index: usize) -> f64;
}

impl Lanes for f64 {
    fn from_lanes(mut lane: impl FnMut(usize) -> f64) -> Self {
        lane(0)
    }

    fn lane(self, _: usize) -> f64 {
        self
    }
}

macro_rules! lanes {
    ($($lanes:ident of $real:ident;)*) => { $(
        impl Lanes for $lanes {
            fn from_lanes(mut lane: impl FnMut(usize) -> f64) -> Self {
                $lanes::new(std::array::from_fn(|index| lane(index) as $real))
            }

            fn lane(self, index: usize) -> f64 {
                self.as_array()[index].into()
            }
        }
    )* };
}

lanes! {
    f32x4 of f32;
    f32x8 of f32;
    f32x16 of f32;
    f64x2 of f64;
    f64x4 of f64;
    f64x8 of f64;
}
