//! Lanes as lists of numbers.

use mstmm::wide::{f32x4, f32x8, f32x16, f64x2, f64x4, f64x8};
use mstmm::{ChainState, Scalar};
use std::fmt::Debug;

/// A number with lanes, or without: then it is its own only lane.
pub trait Lanes: Scalar<Real: Into<f64>> {
    /// How many there are.
    const COUNT: usize;

    /// From the number of each lane.
    fn from_lanes(lane: impl FnMut(usize) -> Self::Real) -> Self;

    /// The number of a lane.
    fn lane(self, index: usize) -> Self::Real;
}

macro_rules! lanes {
    ($($lanes:ident of $count:literal;)*) => { $(
        impl Lanes for $lanes {
            const COUNT: usize = $count;

            fn from_lanes(lane: impl FnMut(usize) -> Self::Real) -> Self {
                $lanes::new(std::array::from_fn(lane))
            }

            fn lane(self, index: usize) -> Self::Real {
                self.to_array()[index]
            }
        }
    )* };
}

lanes! {
    f32x4 of 4;
    f32x8 of 8;
    f32x16 of 16;
    f64x2 of 2;
    f64x4 of 4;
    f64x8 of 8;
}

macro_rules! alone {
    ($($real:ident)*) => { $(
        impl Lanes for $real {
            const COUNT: usize = 1;

            fn from_lanes(mut lane: impl FnMut(usize) -> Self) -> Self {
                lane(0)
            }

            fn lane(self, _: usize) -> Self {
                self
            }
        }
    )* };
}

alone! { f32 f64 }

/// A state in lanes from one for each of them.
pub fn pack<W, S>(states: &[S]) -> W
where
    W: ChainState<Scalar: Lanes> + Default,
    S: ChainState<Scalar = <W::Scalar as Scalar>::Real>,
{
    let mut packed = W::default();
    for (index, place) in packed.coordinates_mut().iter_mut().enumerate() {
        *place = W::Scalar::from_lanes(|lane| states[lane].coordinates()[index]);
    }
    for (index, place) in packed.rates_mut().iter_mut().enumerate() {
        *place = W::Scalar::from_lanes(|lane| states[lane].rates()[index]);
    }
    packed.set_time(W::Scalar::from_lanes(|lane| states[lane].time()));
    packed
}

/// Returns the numbers of any generated value in order, exact to the last bit, from its debug output. A value
/// in lanes prints all lanes of a number together.
pub fn numbers(of: &dyn Debug) -> Vec<f64> {
    let text = format!("{of:?}");
    let is_word = |c: char| c.is_alphanumeric() || "_-+.:".contains(c);
    text.split(|c: char| !is_word(c)).filter_map(|word| word.parse().ok()).collect()
}

/// Returns the numbers of one lane.
pub fn of_lane(numbers: &[f64], lane: usize, lanes: usize) -> Vec<f64> {
    numbers.iter().skip(lane).step_by(lanes).copied().collect()
}

/// Returns whether all bits are equal; all NaNs are equal.
pub fn same_bits(a: &[f64], b: &[f64]) -> bool {
    let same = |(a, b): (&f64, &f64)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    a.len() == b.len() && a.iter().zip(b).all(same)
}
