//! The origins of values that are not finite.

use core::fmt;

use crate::{Mask, Scalar};

/// The origin of [`Error::NotFinite`](crate::Error::NotFinite): a value of a state or of inputs, by its index in the
/// lists of a [`Description`](crate::description::Description), an argument, or a result.
///
/// Indices begin at 0. [`Description::name_of`](crate::description::Description::name_of) gives the name of a value of a state or of inputs.
///
/// ```
/// use mstmm_runtime::{Described, Error, Rk4};
///
/// /// Takes a step, and prints the name of the value that stops it.
/// fn step<C: Described>(rk4: &mut Rk4<C>, chain: &C, state: &mut C::State) {
///     match rk4.step(chain, state, |_, _| chain.no_inputs()) {
///         Err(Error::NotFinite(origin)) => match C::DESCRIPTION.name_of(origin) {
///             Some(name) => println!("{name} is not finite"),
///             None => println!("{origin}"),
///         },
///         Err(error) => println!("{error}"),
///         Ok(()) => {}
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Origin {
    /// The time of a state.
    Time,
    /// An entry of [`Description::coordinates`](crate::description::Description::coordinates).
    ///
    /// An integrator returns coordinates and rates of the given state, of a stage of the step, or of its end.
    Coordinate(usize),
    /// An entry of [`Description::rates`](crate::description::Description::rates).
    Rate(usize),
    /// An entry of [`Description::inputs`](crate::description::Description::inputs).
    Input(usize),
    /// An entry of another argument: given accelerations, a direction, a matrix, the components of a quaternion.
    Argument {
        /// The name of the argument.
        name: &'static str,
        /// The index of the entry, column by column for a matrix.
        index: usize,
    },
    /// The end time of an integration.
    End,
    /// A result, or a sum that it needs, although all arguments are finite: it overflows.
    Result,
}

/// Writes what is not finite, as in "rate 2 (counted from 0) is not finite".
impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (quantity, index) = match *self {
            Origin::Time => return f.write_str("the time is not finite"),
            Origin::End => return f.write_str("the end time is not finite"),
            Origin::Result => {
                return f.write_str(
                    "a result overflows: a value of the state, the inputs, the step or another argument is too \
                     large",
                );
            }
            Origin::Argument { name, index } => {
                return write!(f, "entry {index} (counted from 0) of `{name}` is not finite");
            }
            Origin::Coordinate(index) => ("coordinate", index),
            Origin::Rate(index) => ("rate", index),
            Origin::Input(index) => ("input", index),
        };
        write!(f, "{quantity} {index} (counted from 0) is not finite")
    }
}

/// Returns the origin of an argument of which an entry is not finite, or of which a sum overflows.
pub(crate) fn of_argument<T: Scalar>(name: &'static str, values: &[T]) -> Origin {
    position(values).map_or(Origin::Result, |index| Origin::Argument { name, index })
}

/// Returns the index of the first value that is not finite.
// Not inlined, and without the length of a vector: it is for failures, where code should be small.
#[cold]
#[inline(never)]
pub(crate) fn position<T: Scalar>(values: &[T]) -> Option<usize> {
    values.iter().position(is_not_finite)
}

/// Returns whether a value is NaN or infinite, in any lane.
pub(crate) fn is_not_finite<T: Scalar>(value: &T) -> bool {
    !value.is_finite().all()
}
