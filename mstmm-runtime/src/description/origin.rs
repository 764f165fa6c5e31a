//! The names of values that are not finite.

use super::{Description, Name};
use crate::ChainState;
use crate::origin::{Origin, is_not_finite, position};

impl Description {
    /// Returns the name of a value of a state or of inputs, such as `elbow.angle`, and `time` for the time. `None` for
    /// other origins, and if the chain has no such value.
    ///
    /// [`Error::NotFinite`](crate::Error::NotFinite) has the origin; see [`Origin`] for an example.
    #[must_use]
    pub fn name_of(&self, origin: Origin) -> Option<Name> {
        let (quantities, index) = match origin {
            Origin::Time => return Some(Name::new("time", 0)),
            Origin::Coordinate(index) => (self.coordinates(), index),
            Origin::Rate(index) => (self.rates(), index),
            Origin::Input(index) => (self.inputs(), index),
            Origin::Argument { .. } | Origin::End | Origin::Result => return None,
        };
        Some(quantities.get(index)?.name)
    }
}

/// Returns the first value of a state that is not finite.
#[cold]
#[inline(never)]
pub(crate) fn of_state<S: ChainState>(state: &S) -> Option<Origin> {
    let time = is_not_finite(&state.time()).then_some(Origin::Time);
    time.or_else(|| position(state.coordinates()).map(Origin::Coordinate))
        .or_else(|| position(state.rates()).map(Origin::Rate))
}
