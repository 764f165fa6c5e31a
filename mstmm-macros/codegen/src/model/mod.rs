//! What was meant: bodies joined by hinges, all names resolved, all numbers in SI units.
//!
//! The model is a graph: every hinge names the two places that it joins. A chain is the simplest
//! such graph; nothing here but [`Chain::route`] knows that each body has one input and one output.

mod check;
mod hinge;
mod layout;
mod lower;
#[cfg(test)]
mod tests;
mod value;

pub use hinge::{Coordinate, Group, Results, Shape, View};
pub use layout::{Layout, Link};
pub use value::{Symbol, Value};

use crate::diag::Diagnostics;
use crate::syntax::{ChainDef, Surface};
use proc_macro2::Ident;

/// Index into [`Chain::bodies`].
pub type BodyId = usize;
/// Index into [`Chain::hinges`].
pub type HingeId = usize;

/// A chain in SI units, free of user errors.
#[derive(Clone, Debug)]
pub struct Chain {
    /// The name of the generated type.
    pub name: Ident,
    /// Acceleration of free fall in m/s², inertial frame.
    pub gravity: [Value; 3],
    /// Numbers that may change at run time, in the order written.
    pub parameters: Vec<Parameter>,
    /// How many constants are given as Rust paths: [`Symbol::Constant`] indexes them.
    pub constants: usize,
    /// The bodies on the route, in the order written.
    pub bodies: Vec<Body>,
    /// The hinges on the route, in the order written. A chain that starts and ends with a body
    /// floats: its first hinge is then an implied [`HingeKind::Floating`] from the ground to the
    /// input of the first body, under the first body's name.
    pub hinges: Vec<Hinge>,
    /// The elements in the order written, without the implied hinge.
    pub route: Vec<Element>,
    /// The method that the user asked for, if any.
    pub method: Option<Method>,
}

/// What was meant by a description, checked. Nothing if it has a mistake, which is reported then.
pub fn lower(def: &ChainDef, diagnostics: &mut Diagnostics) -> Option<(Chain, Surface)> {
    let before = diagnostics.count();
    let (draft, surface) = lower::draft(def, diagnostics);
    check::check(&draft, diagnostics);
    if diagnostics.count() > before {
        return None;
    }
    Some((draft.finish()?, surface))
}

/// An element of the route.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Element {
    /// A body with an input and an output end.
    Body(BodyId),
    /// A hinge with an inboard and an outboard side.
    Hinge(HingeId),
}

/// How the accelerations are solved for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The forward product of transfer matrices from `z_{1,I}` and a boundary solve.
    Transfer,
    /// The Riccati transfer from the free end to the held one.
    Riccati,
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

/// A hinge between two places. It turns or moves the outboard frame against the inboard one.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The name on the route.
    pub name: Ident,
    /// What it lets free.
    pub kind: HingeKind,
    /// Where its inboard side sits.
    pub inboard: Place,
    /// Where its outboard side sits.
    pub outboard: Place,
    /// Start coordinates, as many as the kind has: see [`HingeKind`].
    pub start: Vec<Value>,
    /// Start rates, as many as the kind has degrees of freedom.
    pub start_rate: Vec<Value>,
    /// The effort that drives its coordinates.
    pub effort: Effort,
}

/// Where a hinge sits.
#[derive(Clone, Debug)]
// A chain has two places on the ground at most.
#[allow(clippy::large_enum_variant)]
pub enum Place {
    /// A frame fixed in the inertial frame.
    Ground(Frame),
    /// The input frame of a body.
    Input(BodyId),
    /// The output frame of a body.
    Output(BodyId),
}

/// What a hinge lets free.
#[derive(Clone, Debug)]
pub enum HingeKind {
    /// Nothing.
    Weld,
    /// A turn about an axis fixed on both sides; coordinate: the angle in rad.
    Pin {
        /// The axis as written (any length but zero), components the same on both sides.
        axis: [Value; 3],
    },
    /// All turns; coordinates: the unit quaternion (w, x, y, z) that turns outboard into inboard
    /// components; rates: angular velocity of the outboard side against the inboard one in
    /// rad/s, outboard frame.
    Ball,
    /// Everything. Coordinates: the outboard origin in m, inboard axes, then a quaternion as for
    /// a ball; rates: its velocity in m/s, inboard axes, then the angular velocity as for a ball.
    Floating,
}

/// The effort that drives a hinge's coordinates: power is effort times rate.
#[derive(Clone, Debug)]
pub enum Effort {
    /// None.
    Free,
    /// The same always, in N m (turns) or N (slides).
    Constant(Vec<Value>),
    /// Given by the caller at every step.
    Input,
}
