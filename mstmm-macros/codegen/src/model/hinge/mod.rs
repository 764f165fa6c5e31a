//! What all phases need to know of each kind of hinge, besides its words and its equations: how many
//! numbers it has, what they are called, and how they are handed out. A file each.

mod ball;
mod floating;
mod pin;
mod weld;

use super::HingeKind;
use std::ops::Range;

/// The numbers of a kind of hinge.
#[derive(Debug)]
pub struct Shape {
    /// The word for it.
    pub word: &'static str,
    /// Its coordinates.
    pub coordinates: &'static [Coordinate],
    /// Names of its rates; as many as it has degrees of freedom.
    pub rates: &'static [&'static str],
    /// How its coordinates and rates are handed out, unless it has none.
    pub view: Option<View>,
    /// How its acceleration and its effort are handed out.
    pub results: Results,
    /// What drives it, for the docs.
    pub effort: &'static str,
}

/// A coordinate.
#[derive(Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: &'static str,
    /// Its value in the zero position.
    pub rest: f64,
}

/// A type of the runtime that shows coordinates and rates. A second one with `Mut` behind its name
/// lets them be changed.
#[derive(Debug)]
pub struct View {
    /// Its name.
    pub name: &'static str,
    /// The arguments that it is made from: one number each, or an array.
    pub groups: &'static [Group],
}

/// Numbers that a view takes together.
#[derive(Debug)]
pub enum Group {
    /// Some of the coordinates.
    Coordinates(Range<usize>),
    /// Some of the rates.
    Rates(Range<usize>),
}

/// The type of an acceleration or an effort.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Results {
    /// There is none.
    Nothing,
    /// A number.
    Number,
    /// A vector.
    Vector,
}

impl HingeKind {
    /// The numbers of this kind.
    pub fn shape(&self) -> &'static Shape {
        match self {
            HingeKind::Weld => &weld::SHAPE,
            HingeKind::Pin { .. } => &pin::SHAPE,
            HingeKind::Ball => &ball::SHAPE,
            HingeKind::Floating => &floating::SHAPE,
        }
    }

    /// How many coordinates it has.
    pub fn coordinates(&self) -> usize {
        self.shape().coordinates.len()
    }

    /// How many degrees of freedom it has.
    pub fn freedoms(&self) -> usize {
        self.shape().rates.len()
    }
}

/// A coordinate that is zero in the zero position.
const fn zero(name: &'static str) -> Coordinate {
    Coordinate { name, rest: 0.0 }
}

/// A coordinate that is one in the zero position.
const fn one(name: &'static str) -> Coordinate {
    Coordinate { name, rest: 1.0 }
}
