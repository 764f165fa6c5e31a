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
mod floating;
mod orientation;
mod pin;

pub use ball::{BallState, BallStateMut};
pub use floating::{FloatingState, FloatingStateMut};
pub use pin::{PinState, PinStateMut};

use crate::Point;

/// What a solution says of one hinge. `V` is a number for a hinge with one coordinate, a vector for
/// others.
#[derive(Clone, Copy, Debug)]
pub struct HingeResult<'a, T, V> {
    acceleration: V,
    effort: V,
    input: &'a Point<T>,
    output: &'a Point<T>,
}

impl<'a, T, V: Copy> HingeResult<'a, T, V> {
    /// Puts the result together; generated code does.
    #[inline]
    pub fn new(acceleration: V, effort: V, input: &'a Point<T>, output: &'a Point<T>) -> Self {
        Self { acceleration, effort, input, output }
    }

    /// The time derivative of the hinge's rates, in the frame of the rates: rad/s² and m/s².
    #[inline]
    pub fn acceleration(&self) -> V {
        self.acceleration
    }

    /// The torque (N·m) or force (N) along the hinge's free directions, positive where it drives
    /// the rates up.
    #[inline]
    pub fn effort(&self) -> V {
        self.effort
    }

    /// The hinge's input end, on the inboard side.
    #[inline]
    pub fn input(&self) -> &'a Point<T> {
        self.input
    }

    /// The hinge's output end, on the outboard side.
    #[inline]
    pub fn output(&self) -> &'a Point<T> {
        self.output
    }
}

/// What a solution says of one body.
#[derive(Clone, Copy, Debug)]
pub struct BodyResult<'a, T> {
    input: &'a Point<T>,
    output: &'a Point<T>,
}

impl<'a, T> BodyResult<'a, T> {
    /// Puts the result together; generated code does.
    #[inline]
    pub fn new(input: &'a Point<T>, output: &'a Point<T>) -> Self {
        Self { input, output }
    }

    /// The body's input end. The force on the body there is +q, the torque −m.
    #[inline]
    pub fn input(&self) -> &'a Point<T> {
        self.input
    }

    /// The body's output end. The force on the body there is −q, the torque +m.
    #[inline]
    pub fn output(&self) -> &'a Point<T> {
        self.output
    }
}
