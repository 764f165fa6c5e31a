//! The labels of the values of states, inputs and parameters.

use core::fmt::{self, Display};

use crate::description::{Description, Name, Quantities};

/// The names and units of the values of a state, of inputs or of parameters.
#[derive(Clone, Copy, Debug)]
pub struct Labels {
    description: &'static Description,
    of: Kind,
}

/// What the values are.
#[derive(Clone, Copy, Debug)]
enum Kind {
    /// Coordinates, rates, time.
    State,
    Inputs,
    Parameters,
}

/// The name of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Label {
    /// Of a quantity.
    Of(Name),
    /// The time.
    Time,
}

/// The name of the time.
pub const TIME: &str = "time";

impl Display for Label {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Label::Of(name) => name.fmt(f),
            Label::Time => f.write_str(TIME),
        }
    }
}

impl Labels {
    /// Returns the labels of a state: coordinates, rates, time.
    pub fn of_state(description: &'static Description) -> Self {
        Labels { description, of: Kind::State }
    }

    /// Returns the labels of inputs.
    pub fn of_inputs(description: &'static Description) -> Self {
        Labels { description, of: Kind::Inputs }
    }

    /// Returns the labels of parameters.
    pub fn of_parameters(description: &'static Description) -> Self {
        Labels { description, of: Kind::Parameters }
    }

    /// Returns all labels with their units, `1` for plain numbers.
    pub fn iter(self) -> impl Iterator<Item = (Label, &'static str)> {
        let of_list = |list: Quantities| list.iter().map(|each| (Label::Of(each.name), each.unit));
        let time = self.has_time().then_some((Label::Time, "s"));
        self.lists().flat_map(of_list).chain(time)
    }

    /// Returns the lists of quantities, one after the other.
    fn lists(self) -> impl Iterator<Item = Quantities> {
        let description = self.description;
        let (first, second) = match self.of {
            Kind::State => (description.coordinates(), Some(description.rates())),
            Kind::Inputs => (description.inputs(), None),
            Kind::Parameters => (description.parameters(), None),
        };
        [Some(first), second].into_iter().flatten()
    }

    /// Returns whether the time follows.
    fn has_time(self) -> bool {
        matches!(self.of, Kind::State)
    }
}

/// What reading by names needs.
#[cfg(feature = "serde")]
impl Labels {
    /// Returns what one of the values is and what all of them are: "an input", "inputs".
    pub fn what(self) -> [&'static str; 2] {
        match self.of {
            Kind::State => ["a coordinate or rate", "coordinates and rates"],
            Kind::Inputs => ["an input", "inputs"],
            Kind::Parameters => ["a parameter", "parameters"],
        }
    }

    /// Returns the name of the chain.
    pub fn chain(self) -> &'static str {
        self.description.name()
    }

    /// Returns the index of a name.
    pub fn index(self, name: &str) -> Option<usize> {
        let mut first = 0;
        for list in self.lists() {
            if let Some(index) = list.index(name) {
                return Some(first + index);
            }
            first += list.len();
        }
        (self.has_time() && name == TIME).then_some(first)
    }
}
