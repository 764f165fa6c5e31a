//! Errors at run time.

use core::fmt;

use crate::origin::Origin;

/// An error at run time.
///
/// Functions that fail return one of these instead of panicking. Unless documented otherwise they leave states
/// unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The bodies outboard of a hinge have no inertia along one of its degrees of freedom, or rounding has lost it.
    ///
    /// The articulated inertia outboard of a hinge is a difference of larger values. It is lost if it is not larger
    /// than their rounding errors: with masses that differ by a factor of about 10⁶ in `f32`, about 10¹⁵ in `f64`.
    /// Then use `f64`, or masses, lengths and moments of inertia that differ less.
    ///
    /// Two degrees of freedom of a gimbal with the same motion, where its axes are in one plane, have no inertia between
    /// them either.
    Singular {
        /// The name of the hinge in the description.
        hinge: &'static str,
    },
    /// A value is NaN or infinite, or so large that results or their sum overflow.
    ///
    /// [`Description::name_of`](crate::description::Description::name_of) gives the name of a coordinate, a rate or an
    /// input, such as `elbow.angle`.
    NotFinite(
        /// The value: a coordinate, a rate, an input, the time, or an entry of an argument, by its index.
        Origin,
    ),
    /// The length of a quaternion of a state or of a prescribed motion is not between 0.9 and 1.1.
    ///
    /// Zero, very small and very large quaternions are among these.
    InvalidQuaternion {
        /// The name of the hinge, of the floating body or of the moving end.
        hinge: &'static str,
    },
    /// The value of a parameter, a tolerance or a step is refused. The previous value is kept.
    InvalidParameter {
        /// The name of the parameter.
        name: &'static str,
        /// The condition that the value does not meet, such as "must be positive".
        reason: &'static str,
    },
    /// The step size control cannot meet the tolerance with a step that still changes the time, and of which fewer than 10¹⁸
    /// lead to the end.
    StepTooSmall,
    /// The time to interpolate at is outside the last step, or there is no step yet.
    OutsideStep,
    /// Newton's method finds no coordinates near the given ones that satisfy the loop constraints; in a step, one
    /// correction would rotate a hinge by more than half a rad.
    NotAssembled,
    /// The loop constraints have a higher rank in this pose than around the start of the description.
    ///
    /// The rank is found in poses around the start. It can be too low if the mobility depends on the pose: give the
    /// description a start in a pose like those of the motion.
    ClosureRank {
        /// The name of the closing hinge in the description.
        hinge: &'static str,
    },
    /// A matrix is singular, or not positive definite where it must be, up to rounding.
    SingularMatrix,
    /// No gain was found that makes the closed loop of a regulator stable.
    ///
    /// An unstable or marginally stable motion is not changed by the inputs, or it has no weight in the cost.
    NotStabilizable,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::Singular { hinge } => write!(
                f,
                "the bodies outboard of hinge `{hinge}` have no inertia along one of its axes in this state, the \
                 three axes of a gimbal are in one plane, or rounding has lost the inertia next to much larger inertias: if so, use `f64`, or masses that differ less"
            ),
            Error::InvalidQuaternion { hinge } => write!(
                f,
                "the quaternion of `{hinge}` is not a rotation: its length must be between 0.9 and 1.1"
            ),
            Error::NotFinite(origin) => origin.fmt(f),
            Error::InvalidParameter { name, reason } => write!(f, "`{name}` {reason}"),
            Error::StepTooSmall => f.write_str(
                "the tolerance cannot be met, even with the smallest step: use a larger tolerance or `f64`",
            ),
            Error::OutsideStep => f.write_str("the time is outside the last step"),
            Error::NotAssembled => f.write_str(
                "the chain is not closed and cannot be closed from this state: call `assemble` before the first step, from a \
                 start closer to a pose in which the chain is closed, with its links bent",
            ),
            Error::SingularMatrix => {
                f.write_str("a matrix is singular, or not positive definite, up to rounding")
            }
            Error::NotStabilizable => f.write_str(
                "no gain was found that makes the closed loop stable: the inputs must act on each motion that does not \
                 decay, and the cost must have a weight for it",
            ),
            Error::ClosureRank { hinge } => write!(
                f,
                "the loop constraints of hinge `{hinge}` have a higher rank here than around the start of the \
                 description: write a start in a pose like this one"
            ),
        }
    }
}

impl core::error::Error for Error {}
