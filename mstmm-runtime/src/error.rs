//! What can go wrong at run time.

use core::fmt;

/// What can go wrong at run time.
///
/// Nothing panics: whatever fails says so with one of these and leaves the state as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// Nothing with inertia lies beyond the hinge in some direction in which it is free, so its
    /// acceleration has no answer.
    Singular {
        /// The hinge's name in the chain's description.
        hinge: &'static str,
    },
    /// A coordinate, a rate, an input or the time is NaN or infinite, or they are so large that the
    /// accelerations, or their sum, are beyond what a number can hold.
    NotFinite,
    /// A quaternion of a state or of a prescribed motion is not a rotation: its length is not
    /// between 0.9 and 1.1. Zero, very small and very large quaternions are among these.
    Quaternion {
        /// The name of the hinge, of the floating body or of the moving end.
        hinge: &'static str,
    },
    /// A value was refused; the one set before is kept.
    Parameter {
        /// The parameter's name.
        name: &'static str,
        /// What it must be, such as "must be positive".
        reason: &'static str,
    },
    /// Step size control could not reach the tolerance with any step that still moves the clock.
    StepTooSmall,
    /// The time asked for lies outside the last step, or no step was taken yet.
    OutsideStep,
    /// A chain that is held at both ends cannot be closed from the coordinates it was given.
    NotAssembled,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Singular { hinge } => {
                write!(f, "nothing with inertia lies beyond hinge `{hinge}`")
            }
            Error::Quaternion { hinge } => write!(
                f,
                "the quaternion of `{hinge}` is not a rotation: its length must be between 0.9 \
                 and 1.1"
            ),
            Error::NotFinite => {
                f.write_str("a coordinate, rate, input or time is not a finite number")
            }
            Error::Parameter { name, reason } => write!(f, "`{name}` {reason}"),
            Error::StepTooSmall => {
                f.write_str("the tolerance cannot be reached: the step became too small")
            }
            Error::OutsideStep => f.write_str("the time lies outside the last step"),
            Error::NotAssembled => f.write_str("the chain cannot be closed from this start"),
        }
    }
}

impl core::error::Error for Error {}
