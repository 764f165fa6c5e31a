//! What was meant: bodies joined by hinges, all names resolved, all numbers in SI units.
//!
//! The model is a graph: every hinge names the two places that it joins. A chain is the simplest
//! such graph; nothing here but [`Chain::route`] knows that each body has one input and one output.

mod answer;
mod check;
mod condition;
mod hinge;
mod inertia;
mod layout;
mod load;
mod lower;
mod parameter_uses;
mod repeat_boundaries;
mod results;
mod rules;
#[cfg(test)]
mod tests;
mod unrolled;
mod value;

pub use crate::ids::{BodyId, HingeId, InputId, LinkId, LoadId, RepeatId};
pub use answer::Answer;
pub use condition::{Bound, Condition, Requirement};
pub use hinge::{
    Coordinate, DofGroup, Drive, Effort, Friction, Hinge, HingeKind, HingeSpec, Limits, Passive,
    Representation, StateView, ViewArgument,
};
pub use layout::{Input, InputKind, Layout, Link, MergedWeld, MovesWith};
pub use load::{Load, LoadAxes, Source, Spring};
pub(crate) use lower::listed;
pub use results::Results;
pub use rules::Check;
pub use value::{Symbol, Value};

use crate::diag::Diagnostics;
use crate::ids::{IdRange, IdVec};
use crate::syntax::{ChainSyntax, Passthrough};
use proc_macro2::Ident;
use std::ops::Range;

/// A chain in SI units, free of user errors.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The name of the generated type.
    pub name: Ident,
    /// In how many directions it moves.
    pub dimension: Dimension,
    /// Acceleration of free fall in m/s², inertial frame.
    pub gravity: Source,
    /// Numbers that may change at run time, in the order written.
    pub parameters: Vec<Parameter>,
    /// How many constants are given as Rust paths: [`Symbol::Constant`] indexes them.
    pub constants: usize,
    /// The bodies on the route, in the order written.
    pub bodies: IdVec<BodyId, Body>,
    /// The hinges on the route, in the order written, behind the implied ones. A chain that starts
    /// and ends with a body floats: an implied hinge from the ground to the input of the first
    /// body leaves it everything that its dimension has, under the first body's name. A moving end
    /// is a massless body behind an implied hinge from the ground that is driven by a prescribed
    /// motion, both under the end's name.
    pub hinges: IdVec<HingeId, Hinge>,
    /// The elements in the order written, without implied hinges and moving ends.
    pub route: Vec<Element>,
    /// What acts on bodies from outside, in the order written.
    pub loads: IdVec<LoadId, Load>,
    /// Springs from bodies to the ground, in the order written.
    pub springs: Vec<Spring>,
    /// Parts of the route that stand for several in a row, in the order written. Where one begins
    /// and where it ends a massless body is welded in, behind all other bodies and hinges.
    pub repeats: IdVec<RepeatId, Repeat>,
    /// The method that the user asked for, if any.
    pub method: Option<SolutionMethod>,
    /// What its solution says.
    pub results: Results,
    /// What is answered besides: nothing of it is generated unasked.
    pub answers: Vec<Answer>,
    /// What must hold of Rust constants: nothing but `rustc` knows.
    pub assertions: Vec<Requirement>,
}

/// What was meant by a description, checked; nothing where a mistake has been found, in this description
/// or before.
pub fn lower(def: &ChainSyntax, diagnostics: &mut Diagnostics) -> Option<(Chain, Passthrough)> {
    let (draft, passthrough) = lower::draft(def, diagnostics)?;
    let assertions = check::check(&draft, diagnostics);
    if !diagnostics.is_empty() {
        return None;
    }
    let Some(chain) = draft.finish() else {
        bug!("a part of chain `{}` is missing, and no mistake is reported", def.name)
    };
    let chain = Chain { assertions, ..chain };
    parameter_uses::repeated_parameters_stay_in_their_part(&chain, diagnostics);
    diagnostics.is_empty().then(|| (repeat_boundaries::with_repeat_boundaries(chain), passthrough))
}

/// In how many directions a chain moves. A model is spatial whatever its dimension: in a plane
/// chain nothing lies outside of the plane z = 0, in a line chain nothing off the x axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// In all of them.
    Space,
    /// Along x and y, and turning about z.
    Plane,
    /// Along x.
    Line,
}

impl Dimension {
    /// The directions of motion among the six of space: shifts along x, y, z, then turns about them.
    pub fn axes(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2, 3, 4, 5],
            Dimension::Plane => &[0, 1, 5],
            Dimension::Line => &[0],
        }
    }

    /// The axes that it moves along.
    pub fn shifts(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2],
            Dimension::Plane => &[0, 1],
            Dimension::Line => &[0],
        }
    }

    /// How many columns of a rotation's matrix tell an orientation.
    pub fn columns(self) -> usize {
        match self {
            Dimension::Space => 3,
            Dimension::Plane => 1,
            Dimension::Line => 0,
        }
    }

    /// The axes that it turns about.
    pub fn turns(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2],
            Dimension::Plane => &[2],
            Dimension::Line => &[],
        }
    }
}

/// An element of the route.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A body with an input and an output end.
    Body(BodyId),
    /// A hinge with an inboard and an outboard side.
    Hinge(HingeId),
}

/// A part of the route that stands for several in a row. Its elements are listed once: hinges and
/// bodies in turn, a hinge first and a body last.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Repeat {
    /// How many times, at least once.
    pub count: usize,
    /// Its hinges.
    pub hinges: IdRange<HingeId>,
    /// Its bodies.
    pub bodies: IdRange<BodyId>,
    /// Its elements in [`Chain::route`].
    pub route: Range<usize>,
}

/// How the accelerations are solved for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolutionMethod {
    /// The forward product of transfer matrices from `z_{1,I}` and a boundary solve.
    Transfer,
    /// The Riccati transfer from the free end to the held one.
    Riccati,
}

/// How many independent directions a closing hinge holds anywhere on the closure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClosureRank {
    /// Nobody knows: every state decides by the size of its pivots.
    #[default]
    Unknown,
    /// So many, whatever the parameters.
    Known {
        /// How many of them are independent.
        rank: usize,
        /// How many there are, those among them that the inertia of a rotor holds.
        directions: usize,
    },
    /// It is found when parameters are set; the hinge holds so many directions.
    FoundAtRunTime(usize),
}

/// A number that may change at run time.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: Ident,
    /// Its value unless set, in SI units. May use Rust paths, but no parameters.
    pub default: Value,
    /// Its SI unit as text, for the docs; empty for a plain number.
    pub unit: String,
    /// How many there are, if it is one for every time of a repeated part.
    pub repetitions: Option<usize>,
}

/// A rigid body. Its frame has its origin at the input point `I`.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name on the route.
    pub name: Ident,
    /// The name of the type that it is an instance of.
    pub type_name: Ident,
    /// Mass in kg.
    pub mass: Value,
    /// Centre of mass `r_IC` in m, body frame.
    pub com: [Value; 3],
    /// Inertia tensor in kg m², body frame axes.
    pub inertia: Inertia,
    /// The output point and the frame there.
    pub output: Frame,
    /// Points with a name, in the order written.
    pub points: Vec<NamedPoint>,
    /// Which optional points the description has.
    pub written: PresentPoints,
    /// What it stands for.
    pub role: Role,
}

impl Body {
    /// The points of the body that its results have by name, body frame: the centre of mass first.
    pub fn own_points(&self) -> impl Iterator<Item = &[Value; 3]> {
        std::iter::once(&self.com).chain(self.points.iter().map(|point| &point.position))
    }
}

/// A point of a body with a name.
#[derive(Clone, Debug)]
pub struct NamedPoint {
    /// The name.
    pub name: Ident,
    /// Where it is in m, body frame.
    pub position: [Value; 3],
}

/// Which optional points the description of a body has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PresentPoints {
    /// The output.
    pub output: bool,
    /// The centre of mass, which a line chain may omit.
    pub com: bool,
}

impl PresentPoints {
    /// All of them.
    pub const ALL: PresentPoints = PresentPoints { output: true, com: true };
}

/// What a body of the model stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A body on the route.
    Physical,
    /// A moving end; it has no mass.
    MovingEnd,
    /// A place where a repeated part begins or ends; it has no mass.
    RepeatBoundary(RepeatBoundary),
}

/// Where a repeated part begins, or where it ends. What lies between is the same every time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RepeatBoundary {
    /// The part.
    pub repeat: RepeatId,
    /// Whether the part ends there.
    pub at_end: bool,
}

/// An inertia tensor.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// xx, yy, zz, xy, xz, yz: the tensor's entries, so products of inertia carry their minus sign.
    pub tensor: [Value; 6],
    /// The point that it is taken about.
    pub about: About,
}

/// The point that an inertia tensor is taken about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The input point `I`.
    Input,
    /// The centre of mass `C`.
    Com,
}

/// A frame fixed in another one.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// Its origin in m.
    pub position: [Value; 3],
    /// Rows of the rotation matrix that turns components in this frame into those of the other.
    pub rotation: [[Value; 3]; 3],
}

impl Frame {
    /// The same frame: no shift, no turn.
    pub fn identity() -> Self {
        let entry = |on| Value::number(if on { 1.0 } else { 0.0 });
        Frame {
            position: [(); 3].map(|()| entry(false)),
            rotation: [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row == column))),
        }
    }
}

/// Where a hinge sits.
#[derive(Clone, Debug, PartialEq)]
// A chain has two places on the ground at most.
#[allow(clippy::large_enum_variant)]
pub enum Attachment {
    /// A frame fixed in the inertial frame.
    Ground(Frame),
    /// The input frame of a body.
    Input(BodyId),
    /// The output frame of a body.
    Output(BodyId),
}
