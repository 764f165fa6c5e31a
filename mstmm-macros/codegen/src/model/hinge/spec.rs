//! The coordinates and rates of a kind of hinge, in groups, with their names and their view.

use std::ops::Range;

/// The coordinates and rates of a kind of hinge.
#[derive(Debug)]
pub struct HingeSpec {
    /// Its keyword.
    pub word: &'static str,
    /// Its coordinates.
    pub coordinates: &'static [Coordinate],
    /// Names of its rates; as many as it has degrees of freedom.
    pub rates: &'static [&'static str],
    /// Its degrees of freedom in groups: translations first, then rotations. Each group has as many
    /// strains as rates.
    pub groups: &'static [DofGroup],
    /// The view of its coordinates and rates, unless it has none.
    pub view: Option<StateView>,
}

impl HingeSpec {
    /// Returns which of its coordinates are a quaternion, if it has one.
    pub fn quaternion(&self) -> Option<Range<usize>> {
        let mut groups = self.groups.iter();
        let group = groups.find(|group| group.representation == Representation::Quaternion);
        group.map(|group| group.coordinates.clone())
    }
}

/// Degrees of freedom of one type.
#[derive(Debug, PartialEq)]
pub struct DofGroup {
    /// The accessors of the coordinates and of the rates in the view.
    pub names: [&'static str; 2],
    /// Whether they are rotations; translations otherwise.
    pub rotational: bool,
    /// The representation of their coordinates.
    pub representation: Representation,
    /// Which of the hinge's coordinates.
    pub coordinates: Range<usize>,
    /// Which of the hinge's rates, efforts and strains.
    pub rates: Range<usize>,
}

impl DofGroup {
    /// Returns the index of the pitch angle among the hinge's coordinates, if they are angles of a rotation in space.
    pub fn pitch(&self) -> Option<usize> {
        (self.representation == Representation::Angles).then_some(self.coordinates.start + 1)
    }
}

/// The representation of coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representation {
    /// Scalars, each of them a strain.
    Numbers,
    /// A unit quaternion.
    Quaternion,
    /// The angles roll, pitch, yaw. The rates are an angular velocity.
    Angles,
}

/// A coordinate.
#[derive(Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: &'static str,
    /// Its value in the zero position.
    pub rest: f64,
}

/// A type of the runtime that shows coordinates and rates. A second one, with the suffix `Mut`,
/// changes them.
#[derive(Debug)]
pub struct StateView {
    /// Its name.
    pub name: &'static str,
    /// The arguments of its constructor: each a number or an array.
    pub groups: &'static [ViewArgument],
}

/// An argument of the constructor of a view.
#[derive(Debug)]
pub enum ViewArgument {
    /// Some of the coordinates.
    Coordinates(Range<usize>),
    /// Some of the rates.
    Rates(Range<usize>),
}

/// A coordinate that is zero in the zero position.
pub(super) const fn zero(name: &'static str) -> Coordinate {
    Coordinate { name, rest: 0.0 }
}

/// A coordinate that is one in the zero position.
pub(super) const fn one(name: &'static str) -> Coordinate {
    Coordinate { name, rest: 1.0 }
}

/// Translations: the first coordinates and rates of a hinge.
pub(super) const fn translations(count: usize) -> DofGroup {
    DofGroup {
        names: ["position", "velocity"],
        rotational: false,
        representation: Representation::Numbers,
        coordinates: 0..count,
        rates: 0..count,
    }
}

/// The translations of an elastic hinge.
pub(super) const fn displacements(count: usize) -> DofGroup {
    DofGroup { names: ["displacement", "velocity"], ..translations(count) }
}

/// Rotations after `translations` translations, each a scalar.
pub(super) const fn rotations(translations: usize, count: usize) -> DofGroup {
    let range = translations..translations + count;
    DofGroup {
        names: if count == 1 { ["angle", "rate"] } else { ["angles", "rates"] },
        rotational: true,
        representation: Representation::Numbers,
        coordinates: translations..translations + count,
        rates: range,
    }
}

/// All rotations after `translations` translations, as a quaternion.
pub(super) const fn quaternion(translations: usize) -> DofGroup {
    let rates = translations..translations + 3;
    DofGroup {
        names: ["orientation", "rate"],
        rotational: true,
        representation: Representation::Quaternion,
        coordinates: translations..translations + 4,
        rates,
    }
}
