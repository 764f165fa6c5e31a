//! Hinges: their degrees of freedom, the forces along them, and the properties of each kind that
//! all phases need: its coordinates and rates with their names, and the view that shows them. One
//! file for each kind.

mod ball;
mod cylindrical;
mod elastic;
mod floating;
mod gimbal;
mod pin;
mod planar;
mod plane_elastic;
mod screw;
mod slider;
mod spec;
mod universal;
mod weld;

pub use spec::{Coordinate, DofGroup, HingeSpec, Representation, StateView, ViewArgument};

use super::{Attachment, Value};
use proc_macro2::Ident;
use std::slice::from_ref;

/// A hinge between two attachments: a joint that moves the outboard frame relative to the inboard
/// frame.
#[derive(Clone, Debug)]
pub struct Hinge {
    /// The name on the route; in a part, the names of the path joined by `_`.
    pub name: Ident,
    /// The path as written, for messages and docs: `fl.knee`.
    pub path: String,
    /// Its kind.
    pub kind: HingeKind,
    /// The attachment of its inboard side.
    pub inboard: Attachment,
    /// The attachment of its outboard side.
    pub outboard: Attachment,
    /// Start coordinates, as many as the kind has: see [`HingeKind`].
    pub start: Vec<Value>,
    /// The name of the field `start` as written, for messages.
    pub start_field: Option<Ident>,
    /// Start rates, as many as the kind has degrees of freedom.
    pub start_rate: Vec<Value>,
    /// The coordinates at which its springs exert no effort.
    pub rest: Vec<Value>,
    /// What drives it.
    pub drive: Drive,
    /// The passive forces along each of its strains, as many as the kind has degrees of freedom.
    pub passive: Vec<Passive>,
}

/// The kind of a hinge. Axes are as written, of any length except zero.
#[derive(Clone, Debug, PartialEq)]
pub enum HingeKind {
    /// No degrees of freedom.
    Weld,
    /// Revolute: rotation about an axis fixed on both sides; coordinate: the angle in rad.
    Pin {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// Prismatic: translation along an axis fixed on both sides; coordinate: the displacement in m.
    Slider {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// Helical: rotation about an axis with a translation along it; coordinate: the angle in rad.
    Screw {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
        /// Translation in m for a rotation by one rad.
        pitch: Value,
    },
    /// Translation along and rotation about the same axis; coordinates: the displacement in m, the
    /// angle in rad.
    Cylindrical {
        /// The axis, components the same on both sides.
        axis: [Value; 3],
    },
    /// Rotation about an axis fixed on the inboard side, then about an axis fixed on the outboard
    /// side; coordinates: both angles in rad.
    Universal {
        /// The axis fixed on the inboard side, and the one fixed on the outboard side.
        axes: [[Value; 3]; 2],
    },
    /// Rotations about three axes, each of which the rotations before it move: the first is fixed on
    /// the inboard side, the last on the outboard side; coordinates: the angles in rad.
    Gimbal {
        /// The axes in the zero position, components the same on both sides.
        axes: [[Value; 3]; 3],
    },
    /// Spherical: all rotations; coordinates: the unit quaternion (w, x, y, z) that rotates
    /// outboard into inboard components; rates: angular velocity of the outboard side relative to
    /// the inboard side in rad/s, outboard frame.
    Ball,
    /// Translations in a plane and a rotation about its normal; coordinates: the displacements in m
    /// along the two inboard axes that follow the normal, and the angle in rad.
    Planar {
        /// Which axis the normal is.
        normal: usize,
    },
    /// Free: six degrees of freedom. Coordinates: the outboard origin in m, inboard axes, then a
    /// quaternion as for a ball; rates: its velocity in m/s, inboard axes, then the angular
    /// velocity as for a ball.
    Floating,
    /// Six degrees of freedom with springs [P, Sect. A.1]. Coordinates: the outboard origin in m
    /// along the axes of the intermediate frame, then the angles θ₁, θ₂, θ_r in rad; rates as for
    /// `Floating`.
    Elastic,
    /// Three degrees of freedom in a plane with springs [P, Sect. A.1]. Coordinates: the outboard
    /// origin in m along the two rotated axes, and the angle in rad; rates: its velocity in m/s
    /// along the inboard axes, and the angular velocity.
    PlaneElastic,
}

/// What drives a hinge.
#[derive(Clone, Debug, PartialEq)]
pub enum Drive {
    /// Efforts, one for each rate.
    Efforts(Vec<Effort>),
    /// A prescribed motion: the caller gives coordinates, rates and accelerations at every step;
    /// they are not part of the state.
    Prescribed,
}

/// The effort that drives a rate: power is effort times rate.
#[derive(Clone, Debug, PartialEq)]
pub enum Effort {
    /// None.
    Free,
    /// Constant, in N m (rotations) or N (translations).
    Constant(Value),
    /// Given by the caller at every step.
    Input,
}

/// The passive forces along a strain, which measures how far a hinge is from rest. Strains are the
/// coordinates minus their rest values; for a quaternion they are the rotation vector from rest,
/// outboard axes, and their rates are the angular velocity.
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

/// Smoothed dry friction: `−f ṡ / √(ṡ² + v²)`.
#[derive(Clone, Debug, PartialEq)]
pub struct Friction {
    /// The effort `f` at high speed, in N or N m.
    pub effort: Value,
    /// The speed `v` of the smoothing, in m/s or rad/s.
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
    /// Returns no passive forces.
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

    /// Returns whether there is any force except inertia.
    pub fn has_effort(&self) -> bool {
        !(self.stiffness.is_zero() && self.damping.is_zero())
            || self.friction.is_some()
            || self.limits.is_some()
    }
}

impl HingeKind {
    /// Returns the properties of this kind, its axes, and the pitch of a screw: the only match over all kinds in the model.
    fn parts(&self) -> (&'static HingeSpec, &[[Value; 3]], Option<&Value>) {
        match self {
            HingeKind::Weld => (&weld::SPEC, &[], None),
            HingeKind::Pin { axis } => (&pin::SPEC, from_ref(axis), None),
            HingeKind::Slider { axis } => (&slider::SPEC, from_ref(axis), None),
            HingeKind::Screw { axis, pitch } => (&screw::SPEC, from_ref(axis), Some(pitch)),
            HingeKind::Cylindrical { axis } => (&cylindrical::SPEC, from_ref(axis), None),
            HingeKind::Universal { axes } => (&universal::SPEC, axes, None),
            HingeKind::Gimbal { axes } => (&gimbal::SPEC, axes, None),
            HingeKind::Ball => (&ball::SPEC, &[], None),
            HingeKind::Planar { .. } => (&planar::SPEC, &[], None),
            HingeKind::Floating => (&floating::SPEC, &[], None),
            HingeKind::Elastic => (&elastic::SPEC, &[], None),
            HingeKind::PlaneElastic => (&plane_elastic::SPEC, &[], None),
        }
    }

    /// Returns its axes. If there are several, the first is fixed on the inboard side and the last on the outboard side.
    pub fn axes(&self) -> &[[Value; 3]] {
        self.parts().1
    }

    /// Returns the pairs of successive axes, which must not be parallel.
    pub fn successive_axes(&self) -> impl Iterator<Item = [&[Value; 3]; 2]> {
        self.axes().windows(2).map(|pair| [&pair[0], &pair[1]])
    }

    /// Returns all values of its description.
    pub fn values(&self) -> Vec<&Value> {
        let (_, axes, pitch) = self.parts();
        axes.iter().flatten().chain(pitch).collect()
    }

    /// Returns the coordinates and rates of this kind.
    pub fn spec(&self) -> &'static HingeSpec {
        self.parts().0
    }

    /// Returns the number of coordinates.
    pub fn coordinates(&self) -> usize {
        self.spec().coordinates.len()
    }

    /// Returns the number of degrees of freedom.
    pub fn dof_count(&self) -> usize {
        self.spec().rates.len()
    }

    /// Its coordinates in the zero position.
    pub fn zero_position(&self) -> Vec<Value> {
        self.spec().coordinates.iter().map(|c| Value::number(c.rest)).collect()
    }
}

impl Hinge {
    /// Returns whether its motion is prescribed: the caller gives its coordinates, and they are not
    /// part of the state.
    pub fn is_prescribed(&self) -> bool {
        self.drive == Drive::Prescribed
    }
}
