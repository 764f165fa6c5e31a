//! Scalars of one lane or of several lanes.

use mstmm::Scalar;
use mstmm::wide::{f32x16, f64x8};

/// A scalar that chains are timed in, of one lane or of several lanes.
pub trait Lanes: Scalar {
    /// The number of lanes.
    const COUNT: usize;

    /// Returns the scalar with the given value in each lane.
    fn from_lanes(lane: impl FnMut(usize) -> f64) -> Self;

    /// Returns the value of a lane.
    fn lane(self, index: usize) -> f64;
}

macro_rules! one_lane {
    ($($real:ident)*) => { $(
        impl Lanes for $real {
            const COUNT: usize = 1;

            fn from_lanes(mut lane: impl FnMut(usize) -> f64) -> Self {
                lane(0) as $real
            }

            fn lane(self, _: usize) -> f64 {
                self.into()
            }
        }
    )* };
}

macro_rules! lanes {
    ($($lanes:ident of $count:literal $real:ident;)*) => { $(
        impl Lanes for $lanes {
            const COUNT: usize = $count;

            fn from_lanes(mut lane: impl FnMut(usize) -> f64) -> Self {
                $lanes::new(std::array::from_fn(|index| lane(index) as $real))
            }

            fn lane(self, index: usize) -> f64 {
                self.as_array()[index].into()
            }
        }
    )* };
}

one_lane! { f32 f64 }
lanes! {
    f32x16 of 16 f32;
    f64x8 of 8 f64;
}
