//! Values that are not finite.

use super::{Description, Name};
use crate::{ChainState, Mask, Scalar};

/// A value of a state or of inputs, by its index in the lists of a [`Description`].
///
/// [`Described::not_finite`](super::Described::not_finite) finds it, [`Description::name_of`] gives its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// The time of the state.
    Time,
    /// An entry of [`Description::coordinates`].
    Coordinate(usize),
    /// An entry of [`Description::rates`].
    Rate(usize),
    /// An entry of [`Description::inputs`].
    Input(usize),
}

impl Description {
    /// Returns the name of a value, such as `elbow.angle`, and `time` for the time. `None` if the chain has no such value.
    ///
    /// ```
    /// use mstmm_runtime::Described;
    ///
    /// /// Prints why accelerations are [not finite](mstmm_runtime::Error::NotFinite).
    /// fn explain<C: Described>(state: &C::State, inputs: &C::Inputs) {
    ///     match C::not_finite(state, inputs).and_then(|origin| C::DESCRIPTION.name_of(origin)) {
    ///         Some(name) => println!("{name} is not finite"),
    ///         None => println!("a value is too large"),
    ///     }
    /// }
    /// ```
    #[must_use]
    pub fn name_of(&self, origin: Origin) -> Option<Name> {
        let (quantities, index) = match origin {
            Origin::Time => return Some(Name::new("time", 0)),
            Origin::Coordinate(index) => (self.coordinates(), index),
            Origin::Rate(index) => (self.rates(), index),
            Origin::Input(index) => (self.inputs(), index),
        };
        Some(quantities.get(index)?.name)
    }
}

/// Returns the first value of a state that is not finite.
pub(super) fn of_state<S: ChainState>(state: &S) -> Option<Origin> {
    let first = |values: &[S::Scalar]| values.iter().position(is_not_finite);
    let time = is_not_finite(&state.time()).then_some(Origin::Time);
    time.or_else(|| first(state.coordinates()).map(Origin::Coordinate))
        .or_else(|| first(state.rates()).map(Origin::Rate))
}

/// Returns whether a value is NaN or infinite, in any lane.
pub(super) fn is_not_finite<T: Scalar>(value: &T) -> bool {
    !value.is_finite().all()
}
