//! Prescribed motions of hinges.

/// A prescribed motion of a hinge, or of a frame that an end of the chain is fixed to.
///
/// The default is rest at the zero position.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct HingeMotion<S, A> {
    /// Coordinates and rates, such as a [`PinState`](super::PinState).
    pub state: S,
    /// The time derivatives of the rates, in the order and the frames of the rates: rad/s² and
    /// m/s².
    pub acceleration: A,
}
