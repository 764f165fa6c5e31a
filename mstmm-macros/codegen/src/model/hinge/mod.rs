//! Hinges: what they let free, what acts along it, and what all phases need to know of each kind
//! besides its words and its equations: how many numbers it has, what they are called, and how they
//! are handed out. A file each.

mod ball;
mod cylindrical;
mod elastic;
mod floating;
mod pin;
mod planar;
mod plane_elastic;
mod screw;
mod slider;
mod universal;
mod weld;

use super::{Attachment, Value};
use proc_macro2::Ident;
use std::ops::Range;

/// A hinge between two places. It turns or moves the outboard frame against the inboard one.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The name on the route.
    pub name: Ident,
    /// What it lets free.
    pub kind: HingeKind,
    /// Where its inboard side sits.
    pub inboard: Attachment,
    /// Where its outboard side sits.
    pub outboard: Attachment,
    /// Start coordinates, as many as the kind has: see [`HingeKind`].
    pub start: Vec<Value>,
    /// Start rates, as many as the kind has degrees of freedom.
    pub start_rate: Vec<Value>,
    /// The coordinates in which its springs are at rest.
    pub rest: Vec<Value>,
    /// What moves it.
    pub drive: Drive,
    /// What acts on each of its strains, as many as the kind has degrees of freedom.
    pub passive: Vec<Passive>,
}

/// What a hinge lets free. Axes are as written, of any length but zero.
#[derive(Clone, Debug, PartialEq)]
pub enum HingeKind {
    /// Nothing.
    Weld,
    /// A turn about an axis fixed on both sides; coordinate: the angle in rad.
    Pin {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// A shift along an axis fixed on both sides; coordinate: the way in m.
    Slider {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// A turn about an axis that shifts along it; coordinate: the angle in rad.
    Screw {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
        /// Shift in m for a turn by one rad.
        pitch: Value,
    },
    /// A shift along and a turn about the same axis; coordinates: the way in m, the angle in rad.
    Cylindrical {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// A turn about an axis fixed on the inboard side, then one about an axis fixed on the outboard
    /// side; coordinates: both angles in rad.
    Universal {
        /// The axis fixed on the inboard side, and the one fixed on the outboard side.
        axes: [[Value; 3]; 2],
    },
    /// All turns; coordinates: the unit quaternion (w, x, y, z) that turns outboard into inboard
    /// components; rates: angular velocity of the outboard side against the inboard one in
    /// rad/s, outboard frame.
    Ball,
    /// Shifts in a plane and a turn about its normal; coordinates: the ways in m along the two
    /// inboard axes that follow the normal, and the angle in rad.
    Planar {
        /// Which axis the normal is.
        normal: usize,
    },
    /// Everything. Coordinates: the outboard origin in m, inboard axes, then a quaternion as for
    /// a ball; rates: its velocity in m/s, inboard axes, then the angular velocity as for a ball.
    Floating,
    /// Everything, held by springs [P, Sect. A.1]. Coordinates: the outboard origin in m along the
    /// axes of the intermediate frame, then the angles θ₁, θ₂, θ_r in rad; rates as for `Floating`.
    Elastic,
    /// Everything in the plane, held by springs [P, Sect. A.1]. Coordinates: the outboard origin in
    /// m along the two turned axes, and the angle in rad; rates: its velocity in m/s along the
    /// inboard axes, and the angular velocity.
    PlaneElastic,
}

/// What moves a hinge.
#[derive(Clone, Debug, PartialEq)]
pub enum Drive {
    /// Efforts, one for each rate.
    Efforts(Vec<Effort>),
    /// Its coordinates, their rates and accelerations are given by the caller at every step; they
    /// are no part of the state.
    Prescribed,
}

/// The effort that drives a rate: power is effort times rate.
#[derive(Clone, Debug, PartialEq)]
pub enum Effort {
    /// None.
    Free,
    /// The same always, in N m (turns) or N (shifts).
    Constant(Value),
    /// Given by the caller at every step.
    Input,
}

/// What acts on a strain: a measure of how far a hinge is from rest. Strains are the coordinates
/// less their rest values; for a quaternion they are the rotation vector from rest, outboard axes,
/// and their rates the angular velocity.
#[derive(Clone, Debug, PartialEq)]
pub struct Passive {
    /// Effort per strain, in N/m or N m/rad.
    pub stiffness: Value,
    /// Effort per strain rate, in N s/m or N m s/rad.
    pub damping: Value,
    /// Inertia of a rotor along the strain, in kg or kg m².
    pub armature: Value,
    /// Dry friction.
    pub friction: Option<Friction>,
    /// One-sided springs.
    pub limits: Option<Limits>,
}

/// Dry friction, made smooth: `−f ṡ / √(ṡ² + v²)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// The effort `f` at high speed, in N or N m.
    pub effort: Value,
    /// The speed `v` that makes it smooth, in m/s or rad/s.
    pub speed: Value,
}

/// One-sided springs. For a quaternion only `high` counts, the largest angle from rest.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The smallest coordinate without load.
    pub low: Value,
    /// The largest coordinate without load.
    pub high: Value,
    /// Effort per overshoot.
    pub stiffness: Value,
    /// Effort per rate while there is overshoot.
    pub damping: Value,
}

impl Passive {
    /// Nothing acts.
    pub fn none() -> Self {
        let zero = || Value::number(0.0);
        Passive {
            stiffness: zero(),
            damping: zero(),
            armature: zero(),
            friction: None,
            limits: None,
        }
    }

    /// Whether anything acts but inertia.
    pub fn has_effort(&self) -> bool {
        !(self.stiffness.is_zero() && self.damping.is_zero())
            || self.friction.is_some()
            || self.limits.is_some()
    }
}

/// The numbers of a kind of hinge.
#[derive(Debug)]
pub struct HingeSpec {
    /// The word for it.
    pub word: &'static str,
    /// Its coordinates.
    pub coordinates: &'static [Coordinate],
    /// Names of its rates; as many as it has degrees of freedom.
    pub rates: &'static [&'static str],
    /// Its degrees of freedom by groups: shifts first, then turns. As many strains as rates each.
    pub groups: &'static [DofGroup],
    /// How its coordinates and rates are handed out, unless it has none.
    pub view: Option<StateView>,
}

/// Degrees of freedom of one sort.
#[derive(Debug, PartialEq)]
pub struct DofGroup {
    /// Whether they are turns; shifts otherwise.
    pub turns: bool,
    /// How their coordinates are kept.
    pub representation: Representation,
    /// Which of the hinge's coordinates.
    pub coordinates: Range<usize>,
    /// Which of the hinge's rates, efforts and strains.
    pub rates: Range<usize>,
}

/// How coordinates are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Representation {
    /// As numbers, each a strain.
    Numbers,
    /// As a unit quaternion.
    Quaternion,
    /// As the angles of three turns: roll, pitch, yaw. The rates are an angular velocity.
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

/// A type of the runtime that shows coordinates and rates. A second one with `Mut` behind its name
/// lets them be changed.
#[derive(Debug)]
pub struct StateView {
    /// Its name.
    pub name: &'static str,
    /// The arguments that it is made from: one number each, or an array.
    pub groups: &'static [ViewArgument],
}

/// Numbers that a view takes together.
#[derive(Debug)]
pub enum ViewArgument {
    /// Some of the coordinates.
    Coordinates(Range<usize>),
    /// Some of the rates.
    Rates(Range<usize>),
}

impl HingeKind {
    /// The axes that it is described by.
    pub fn axes(&self) -> &[[Value; 3]] {
        match self {
            HingeKind::Pin { axis }
            | HingeKind::Slider { axis }
            | HingeKind::Screw { axis, .. }
            | HingeKind::Cylindrical { axis } => std::slice::from_ref(axis),
            HingeKind::Universal { axes } => axes,
            HingeKind::Weld
            | HingeKind::Ball
            | HingeKind::Planar { .. }
            | HingeKind::Floating
            | HingeKind::Elastic
            | HingeKind::PlaneElastic => &[],
        }
    }

    /// All numbers that it is described by.
    pub fn values(&self) -> Vec<&Value> {
        let axes = self.axes().iter().flatten();
        match self {
            HingeKind::Screw { pitch, .. } => axes.chain([pitch]).collect(),
            HingeKind::Weld
            | HingeKind::Pin { .. }
            | HingeKind::Slider { .. }
            | HingeKind::Cylindrical { .. }
            | HingeKind::Universal { .. }
            | HingeKind::Ball
            | HingeKind::Planar { .. }
            | HingeKind::Floating
            | HingeKind::Elastic
            | HingeKind::PlaneElastic => axes.collect(),
        }
    }

    /// The numbers of this kind.
    pub fn spec(&self) -> &'static HingeSpec {
        match self {
            HingeKind::Weld => &weld::SHAPE,
            HingeKind::Pin { .. } => &pin::SHAPE,
            HingeKind::Slider { .. } => &slider::SHAPE,
            HingeKind::Screw { .. } => &screw::SHAPE,
            HingeKind::Cylindrical { .. } => &cylindrical::SHAPE,
            HingeKind::Universal { .. } => &universal::SHAPE,
            HingeKind::Ball => &ball::SHAPE,
            HingeKind::Planar { .. } => &planar::SHAPE,
            HingeKind::Floating => &floating::SHAPE,
            HingeKind::Elastic => &elastic::SHAPE,
            HingeKind::PlaneElastic => &plane_elastic::SHAPE,
        }
    }

    /// How many coordinates it has.
    pub fn coordinates(&self) -> usize {
        self.spec().coordinates.len()
    }

    /// How many degrees of freedom it has.
    pub fn dof_count(&self) -> usize {
        self.spec().rates.len()
    }

    /// Its coordinates in the zero position.
    pub fn zero_position(&self) -> Vec<Value> {
        self.spec().coordinates.iter().map(|c| Value::number(c.rest)).collect()
    }
}

impl Hinge {
    /// Whether its coordinates are given by the caller, and no part of the state.
    pub fn is_prescribed(&self) -> bool {
        self.drive == Drive::Prescribed
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

/// Shifts, each a number: the first coordinates and rates of a hinge.
const fn shifts(count: usize) -> DofGroup {
    DofGroup {
        turns: false,
        representation: Representation::Numbers,
        coordinates: 0..count,
        rates: 0..count,
    }
}

/// Turns behind as many shifts, each kept as a number.
const fn turns(shifts: usize, count: usize) -> DofGroup {
    let range = shifts..shifts + count;
    DofGroup {
        turns: true,
        representation: Representation::Numbers,
        coordinates: shifts..shifts + count,
        rates: range,
    }
}

/// All turns behind as many shifts, kept as a quaternion.
const fn quaternion(shifts: usize) -> DofGroup {
    let rates = shifts..shifts + 3;
    DofGroup {
        turns: true,
        representation: Representation::Quaternion,
        coordinates: shifts..shifts + 4,
        rates,
    }
}
