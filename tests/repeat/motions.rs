//! Prescribed motions from lists of numbers.

use super::twins::Number;
use mstmm::{BallState, FloatingState, HingeMotion, PinState, PlanarState};
use nalgebra::SVector;

/// Returns numbers as a vector.
pub fn vector<T: Number, const N: usize>(x: &[T]) -> SVector<T, N> {
    array(x).into()
}

fn array<T: Number, const N: usize>(x: &[T]) -> [T; N] {
    std::array::from_fn(|k| x[k])
}

/// Returns a unit quaternion of a rotation by less than a right angle.
fn quaternion<T: Number>(x: &[T]) -> [T; 4] {
    let [a, b, c] = array(x);
    let two = T::constant(2.0);
    let shorter = (two * two + a * a + b * b + c * c).sqrt().recip();
    [two, a, b, c].map(|x| x * shorter)
}

/// From three numbers.
pub fn pin<T: Number>(x: &[T]) -> HingeMotion<PinState<T>, T> {
    HingeMotion { state: PinState::new(x[0], x[1]), acceleration: x[2] }
}

/// From nine numbers.
pub fn ball<T: Number>(x: &[T]) -> HingeMotion<BallState<T>, SVector<T, 3>> {
    let state = BallState::new(quaternion(x), array(&x[3..]));
    HingeMotion { state, acceleration: vector(&x[6..]) }
}

/// From nine numbers.
pub fn planar<T: Number>(x: &[T]) -> HingeMotion<PlanarState<T>, SVector<T, 3>> {
    let state = PlanarState::new(array(x), x[2], array(&x[3..]), x[5]);
    HingeMotion { state, acceleration: vector(&x[6..]) }
}

/// From eighteen numbers.
pub fn floating<T: Number>(x: &[T]) -> HingeMotion<FloatingState<T>, SVector<T, 6>> {
    let state = FloatingState::new(array(x), quaternion(&x[3..]), array(&x[6..]), array(&x[9..]));
    HingeMotion { state, acceleration: vector(&x[12..]) }
}
