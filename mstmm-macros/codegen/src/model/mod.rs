//! The model: bodies connected by hinges, with all names resolved and all values in SI units.
//!
//! The model is a graph: every hinge has two attachments. A chain is the simplest such graph, a tree the
//! usual one.

mod answer;
mod body_frames;
mod check;
mod condition;
mod connection_points;
mod driven_rates;
mod dynamic_parameters;
mod hinge;
mod inertia;
mod layout;
mod length;
mod limbs;
mod load;
mod lower;
mod parameter_uses;
mod repeat_boundaries;
mod request;
mod results;
mod rotations;
mod rules;
mod shape;
#[cfg(test)]
mod tests;
mod unrolled;
mod value;

pub use crate::ids::{
    BodyId, ChannelId, HingeId, InputId, LinkId, LoadId, ParameterId, PointId, RepeatId, SpringId,
};
pub use answer::Answer;
pub use body_frames::{BodyFrame, FrameValues};
pub use condition::{Bound, Condition, Requirement};
pub use connection_points::{ConnectionPoint, ConnectionPoints, ElementPoints, Transmitted};
pub use dynamic_parameters::{DynamicParameter, InertialParameter, PassiveElement};
pub use hinge::{
    Coordinate, DofGroup, Drive, Effort, Friction, Hinge, HingeKind, HingeSpec, Limits, Passive,
    Representation, StateView, ViewArgument,
};
pub use layout::{Input, InputKind, Layout, Link, MergedWeld, MovesWith};
pub use limbs::{LimbGroup, limb_groups};
pub use load::{BodyPoint, Load, LoadAxes, Source, Spring, SpringEnd};
pub use lower::RESERVED_NAMES;
pub(crate) use lower::listed;
pub use request::{ANSWER_WORDS, Foreign, OTHER_ANSWERS, Request};
pub use results::Results;
pub use rotations::{RotationCoordinates, rotation_coordinates};
pub use rules::Check;
pub use shape::{Geometry, Shape};
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
    /// The dimension of the space that it moves in.
    pub dimension: Dimension,
    /// Acceleration of free fall in m/s², inertial frame.
    pub gravity: Source,
    /// The parameters, in the order written.
    pub parameters: IdVec<ParameterId, Parameter>,
    /// How many constants are given as Rust paths: [`Symbol::Constant`] indexes them.
    pub constants: usize,
    /// The bodies on the routes, in the order written.
    pub bodies: IdVec<BodyId, Body>,
    /// The hinges: implied ones first, then those on the routes in the order written. A chain whose
    /// first route begins and ends with a body has a floating base: an implied floating hinge from
    /// the ground to the input of the first body, with the name of that body. A moving end is a
    /// massless body with an implied hinge from the ground whose motion is prescribed; both have
    /// the name of the end.
    pub hinges: IdVec<HingeId, Hinge>,
    /// The elements of all routes in the order of the text, without implied hinges and moving ends:
    /// route by route; in a repeated part its first route, then its branches.
    pub elements: Vec<Element>,
    /// What acts on bodies from outside, in the order written.
    pub loads: IdVec<LoadId, Load>,
    /// Springs, in the order written.
    pub springs: IdVec<SpringId, Spring>,
    /// Repeated parts of routes, in the order written. Wherever something crosses the beginning or the end
    /// of a part, a massless body is welded in; these bodies and welds follow all other bodies and
    /// hinges.
    pub repeats: IdVec<RepeatId, Repeat>,
    /// The method that the user asked for, if any.
    pub method: Option<SolutionMethod>,
    /// The results of its solution.
    pub results: Results,
    /// What the description asks for beside the functions that every chain has, each once.
    pub requests: Vec<Request>,
    /// The squared lengths of the quaternions written, as far as they are not known.
    pub quaternions: Vec<Value>,
    /// Requirements on Rust constants, whose values only `rustc` knows.
    pub assertions: Vec<Requirement>,
}

/// Lowers a description to its model and checks it. Returns `None` if there is an error in this
/// description or in an earlier one.
pub fn lower(def: &ChainSyntax, diagnostics: &mut Diagnostics) -> Option<(Chain, Passthrough)> {
    let written = lower::write_out(def, diagnostics);
    let (draft, passthrough) = lower::draft(def, &written, diagnostics)?;
    let assertions = check::check(&draft, diagnostics);
    if !diagnostics.is_empty() {
        return None;
    }
    lower::warn_of_unused(&draft.unused_parameters, diagnostics);
    let Some(chain) = draft.finish() else {
        bug!("a part of chain `{}` is missing, and no error is reported", def.name)
    };
    let chain = Chain { assertions, ..chain };
    parameter_uses::repeated_parameters_stay_in_their_part(&chain, diagnostics);
    diagnostics.is_empty().then(|| (repeat_boundaries::with_repeat_boundaries(chain), passthrough))
}

/// The dimension of the space that a chain moves in. Models of all dimensions are spatial: a plane
/// chain has z = 0, and a line chain is on the x axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Six directions.
    Space,
    /// Translation along x and y, rotation about z.
    Plane,
    /// Translation along x.
    Line,
}

impl Dimension {
    /// Returns the directions of motion among the six of space: translations along x, y, z, then
    /// rotations about them.
    pub fn axes(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2, 3, 4, 5],
            Dimension::Plane => &[0, 1, 5],
            Dimension::Line => &[0],
        }
    }

    /// Returns the axes of translations.
    pub fn translations(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2],
            Dimension::Plane => &[0, 1],
            Dimension::Line => &[0],
        }
    }

    /// Returns how many columns of the rotation matrix determine an orientation.
    pub fn columns(self) -> usize {
        match self {
            Dimension::Space => 3,
            Dimension::Plane => 1,
            Dimension::Line => 0,
        }
    }

    /// Returns the axes of rotations.
    pub fn rotations(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2],
            Dimension::Plane => &[2],
            Dimension::Line => &[],
        }
    }
}

/// An element of a route.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A body with an input and an output end.
    Body(BodyId),
    /// A hinge with an inboard and an outboard side.
    Hinge(HingeId),
}

/// A repeated part of a route: a route from one repetition to the next, and its branches. Its elements
/// are listed once.
#[derive(Clone, Debug, PartialEq)]
pub struct Repeat {
    /// The number of repetitions, at least one.
    pub count: usize,
    /// Its hinges.
    pub hinges: IdRange<HingeId>,
    /// Its bodies.
    pub bodies: IdRange<BodyId>,
    /// Its elements in [`Chain::elements`].
    pub elements: Range<usize>,
    /// The last body of its first route: the next repetition, or what follows the part, begins at its
    /// output.
    pub last_body: BodyId,
    /// Its hinges that leave a body of the previous repetition, other than the first hinge.
    pub from_previous: Vec<FromPrevious>,
}

/// A hinge of a repeated part that leaves a body of the previous repetition. In the hinge, the inboard
/// attachment is that of the first repetition.
#[derive(Clone, Debug, PartialEq)]
pub struct FromPrevious {
    /// The hinge.
    pub hinge: HingeId,
    /// Its inboard attachment in all repetitions but the first: a place of the repetition before.
    pub previous: Attachment,
}

/// The method that solves for the accelerations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolutionMethod {
    /// The forward product of transfer matrices from `z_{1,I}` and a boundary solve.
    Transfer,
    /// The Riccati transfer from the free end to the held one.
    Riccati,
}

/// The rank of the loop constraints in all closed poses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ClosureRank {
    /// Unknown: each state determines the rank by the size of its pivots.
    #[default]
    Unknown,
    /// Known, for all values of the parameters.
    Known {
        /// The number of independent constraint directions.
        rank: usize,
        /// The number of constraint directions, including those along which a rotor has inertia.
        directions: usize,
    },
    /// Determined when parameters are set; the number of constraint directions.
    FoundAtRunTime(usize),
}

/// A parameter: a value that may change at run time.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: Ident,
    /// Its default in SI units. It may depend on Rust constants, but not on parameters.
    pub default: Value,
    /// Its SI unit as text, for the docs; empty for a plain number.
    pub unit: String,
    /// The number of values, if there is one for each repetition of a part.
    pub repetitions: Option<usize>,
}

/// A rigid body. Its frame has its origin at the input point `I`.
#[derive(Clone, Debug)]
pub struct Body {
    /// The name on its route; in a part, the names of the path joined by `_`.
    pub name: Ident,
    /// The path as written, for messages and docs: `fl.thigh`.
    pub path: String,
    /// The name of the type that it is an instance of.
    pub type_name: Ident,
    /// The beginning of the name of the Rust type of its results: that of its type, after the name of the
    /// part that describes the type.
    pub result_name: Ident,
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
    /// Its shapes for pictures, in the order written.
    pub shapes: Vec<Shape>,
    /// Which optional points the description has.
    pub present: PresentPoints,
    /// Its role.
    pub role: Role,
}

/// A point of a body with a name.
#[derive(Clone, Debug)]
pub struct NamedPoint {
    /// The name.
    pub name: Ident,
    /// The frame there, in the body frame.
    pub frame: Frame,
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

/// The role of a body of the model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// A body on a route.
    Physical,
    /// A moving end; it has no mass.
    MovingEnd,
    /// The beginning or the end of a repeated part; it has no mass.
    RepeatBoundary(RepeatBoundary),
}

/// The beginning or the end of a repeated part, where one channel crosses it. Everything between them
/// is the same for every repetition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RepeatBoundary {
    /// The part.
    pub repeat: RepeatId,
    /// The channel.
    pub channel: ChannelId,
    /// Whether it is the end of the part.
    pub at_end: bool,
}

/// An inertia tensor.
#[derive(Clone, Debug)]
pub struct Inertia {
    /// xx, yy, zz, xy, xz, yz: entries of the tensor, so the products of inertia include their
    /// minus sign.
    pub tensor: [Value; 6],
    /// Its reference point.
    pub about: About,
}

/// The reference point of an inertia tensor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The input point `I`.
    Input,
    /// The centre of mass `C`.
    Com,
}

/// A frame fixed in another one.
#[derive(Clone, Debug)]
pub struct Frame {
    /// Its origin in m.
    pub position: [Value; 3],
    /// Rows of the rotation matrix that rotates components in this frame into components in the
    /// other.
    pub rotation: [[Value; 3]; 3],
    /// Roll, pitch and yaw in rad as written, if the rotation is written so.
    pub angles: Option<[Value; 3]>,
}

/// Frames are equal if their origins and rotations are.
impl PartialEq for Frame {
    fn eq(&self, other: &Self) -> bool {
        self.position == other.position && self.rotation == other.rotation
    }
}

impl Frame {
    /// Returns the identity.
    pub fn identity() -> Self {
        let entry = |on| Value::number(if on { 1.0 } else { 0.0 });
        Frame {
            position: [(); 3].map(|()| entry(false)),
            rotation: [0, 1, 2].map(|row| [0, 1, 2].map(|column| entry(row == column))),
            angles: None,
        }
    }
}

/// The attachment of one side of a hinge.
#[derive(Clone, Debug, PartialEq)]
// Few attachments are on the ground.
#[allow(clippy::large_enum_variant)]
pub enum Attachment {
    /// A frame fixed in the inertial frame.
    Ground(Frame),
    /// The input frame of a body.
    Input(BodyId),
    /// The output frame of a body.
    Output(BodyId),
    /// The frame at a named point of a body, by its index in [`Body::points`].
    Point(BodyId, usize),
}
