//! What can go wrong at run time.

use core::fmt;

/// What can go wrong at run time.
///
/// Nothing panics: whatever fails says so with one of these and leaves the state as it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// Along some direction in which the hinge is free, no inertia beyond it is left: nothing there
    /// has any in this state, or rounding has lost it.
    ///
    /// The inertia beyond a hinge is found as a difference of larger numbers. It is lost if it is
    /// not larger than their rounding: with masses about 10⁶ apart in `f32`, about 10¹⁵ in `f64`.
    /// Then take `f64`, or masses, lengths and inertias closer together.
    Singular {
        /// The hinge's name in the chain's description.
        hinge: &'static str,
    },
    /// A coordinate, a rate, an input or the time is NaN or infinite, or they are so large that the
    /// accelerations, or their sum, are beyond what a number can hold.
    NotFinite,
    /// A quaternion of a state or of a prescribed motion is not a rotation: its length is not
    /// between 0.9 and 1.1. Zero, very small and very large quaternions are among these.
    InvalidQuaternion {
        /// The name of the hinge, of the floating body or of the moving end.
        hinge: &'static str,
    },
    /// A value was refused; the one set before is kept.
    InvalidParameter {
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
    /// The closing hinge holds more independent directions in this pose than the rank that was found for
    /// its closure.
    ///
    /// The rank is found in poses around the start of the description. It can be too low if the mobility
    /// depends on the pose: write a start in a pose like those of the motion.
    ClosureRank {
        /// The hinge's name in the chain's description.
        hinge: &'static str,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Singular { hinge } => {
                write!(
                    f,
                    "no inertia is left beyond hinge `{hinge}` in a direction in which it is free: \
                     nothing there has any in this state, or rounding has lost it next to much \
                     larger inertias; if so, use `f64`, or masses closer together"
                )
            }
            Error::InvalidQuaternion { hinge } => write!(
                f,
                "the quaternion of `{hinge}` is not a rotation: its length must be between 0.9 \
                 and 1.1"
            ),
            Error::NotFinite => {
                f.write_str("a coordinate, rate, input or time is not a finite number")
            }
            Error::InvalidParameter { name, reason } => write!(f, "`{name}` {reason}"),
            Error::StepTooSmall => {
                f.write_str("the tolerance cannot be reached: the step became too small")
            }
            Error::OutsideStep => f.write_str("the time lies outside the last step"),
            Error::NotAssembled => f.write_str("the chain cannot be closed from this start"),
            Error::ClosureRank { hinge } => write!(
                f,
                "the closure of hinge `{hinge}` has a higher rank here than around the start of the \
                 description: write a start in a pose like this one"
            ),
        }
    }
}

impl core::error::Error for Error {}
