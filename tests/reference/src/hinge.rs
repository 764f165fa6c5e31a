//! The description of a hinge: what it lets free, and what acts along that.

use std::ops::Range;

/// A hinge from an inboard frame (ground, a moving frame, or the output frame of the body before it)
/// to an outboard frame (the body after it, ground, or a moving frame). At zero coordinates the two
/// frames coincide.
#[derive(Clone, Debug, PartialEq)]
pub struct Hinge {
    /// The snake_case name of the hinge.
    pub name: String,
    /// Which relative motion the hinge allows.
    pub kind: HingeKind,
    /// The coordinates at which springs carry nothing, empty where they are those of the zero
    /// position. Quaternions need not be normalised.
    pub rest: Vec<f64>,
    /// What acts along the rates of [`HingeKind::linear`].
    pub linear: Group,
    /// What acts along the rates of [`HingeKind::turning`].
    pub turning: Group,
    /// Whether the motion is prescribed, see [`crate::Drives::motions`]. The hinge has no entries in
    /// the state then.
    pub prescribed: bool,
}

/// The relative motion a hinge allows.
///
/// The rotation R turns outboard components into inboard ones; d is the outboard origin seen from
/// the inboard one, in inboard axes. Lengths are in m, angles in rad, and so on in SI units. Axes
/// have any length but zero; their components are the same on both sides unless said otherwise.
#[derive(Clone, Debug, PartialEq)]
pub enum HingeKind {
    /// No motion at all: the two frames are the same.
    Weld,
    /// A turn about an axis. The coordinate is the angle, right-handed, the rate its derivative,
    /// the effort a torque in N·m that acts positively on the outboard side.
    Pin {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A shift along an axis; the effort is a force in N.
    Slider {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A turn about an axis, and a shift along it in proportion. The coordinate is the angle.
    Screw {
        /// The direction of the axis.
        axis: [f64; 3],
        /// The shift for each turn, in m/rad.
        pitch: f64,
    },
    /// A shift along an axis, and a turn about it. The shift comes first.
    Cylindrical {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A turn about a first axis, then a turn about a second one that the first carries along.
    Universal {
        /// The first axis, in inboard components.
        first: [f64; 3],
        /// The second axis, in outboard components; not parallel to the first.
        second: [f64; 3],
    },
    /// Any turn. The coordinates are a quaternion (w, x, y, z) that turns outboard components into
    /// inboard ones. The rates are the angular velocity in rad/s of the outboard side relative to
    /// the inboard one, and the efforts a torque in N·m on the outboard side, both in
    /// outboard-frame components.
    Ball,
    /// Shifts along the two inboard axes that follow the normal cyclically, then the turn about
    /// the normal.
    Planar {
        /// The normal of the plane.
        normal: Axis,
    },
    /// Any motion. The coordinates are d and the quaternion of R; the rates the derivative of d
    /// (inboard axes) and the angular velocity (outboard axes); the efforts a force in N (inboard
    /// axes, at the outboard origin) and a torque in N·m (outboard axes).
    Floating,
    /// Any motion that turns little but about z, with R = Az(θ3) Ay(θ2) Ax(θ1), d = Az(θ3) Δ. The
    /// coordinates are Δ, θ1, θ2, θ3; rates and efforts are those of [`HingeKind::Floating`].
    Elastic,
    /// The word `floating` of a chain in the plane: the same as planar.
    PlaneFloating,
    /// The word `elastic` of a chain in the plane: d = Az(θ) Δ. The coordinates are Δx, Δy, θ; the
    /// rates the derivatives of d (inboard axes) and of θ.
    PlaneElastic,
    /// The word `floating` of a chain along a line: the same as a slider along x.
    LineFloating,
    /// The word `elastic` of a chain along a line: the same as a slider along x.
    LineElastic,
}

/// An axis of a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first axis.
    X,
    /// The second axis.
    Y,
    /// The third axis.
    Z,
}

/// What acts along one group of a hinge's rates: along shifts in N, kg and so on, along turns in
/// N·m, kg·m² and so on.
///
/// A list is empty for nothing, holds one number for all strains of the group, or one for each. For
/// the three turns of a ball or of a floating hinge there is only ever one number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// The stiffnesses against strains.
    pub stiffness: Vec<f64>,
    /// The damping constants against strain rates.
    pub damping: Vec<f64>,
    /// The inertias of rotors that move with the strains.
    pub armature: Vec<f64>,
    /// The friction at great speed.
    pub friction: Vec<f64>,
    /// The speed at which friction has about 0.7 of its full value.
    pub friction_speed: f64,
    /// The stops, if there are any.
    pub limits: Option<Limits>,
    /// The motor.
    pub motor: Source<Vec<f64>>,
}

/// Stops beyond which a further spring and a further damper act.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The lowest and the highest coordinate without them. For the turns of a ball or of a floating
    /// hinge the second is the greatest angle from rest, and the first does not count.
    pub range: [f64; 2],
    /// The stiffness against what is beyond.
    pub stiffness: f64,
    /// The damping constant while beyond.
    pub damping: f64,
}

/// Something that may be given once and for all or at every instant.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Source<T> {
    /// There is none.
    #[default]
    None,
    /// Always the same.
    Constant(T),
    /// Given at every instant, see [`crate::Drives`].
    Input,
}

impl Hinge {
    /// A hinge along which nothing acts.
    pub fn new(name: &str, kind: HingeKind) -> Hinge {
        Hinge {
            name: name.to_owned(),
            kind,
            rest: Vec::new(),
            linear: Group::default(),
            turning: Group::default(),
            prescribed: false,
        }
    }

    /// Returns how many coordinates the hinge has in a state.
    pub fn coordinates(&self) -> usize {
        if self.prescribed { 0 } else { self.kind.coordinates() }
    }

    /// Returns how many rates the hinge has in a state.
    pub fn freedoms(&self) -> usize {
        if self.prescribed { 0 } else { self.kind.freedoms() }
    }

    /// Returns the two groups with the rates they act along.
    pub fn groups(&self) -> [(&Group, Range<usize>); 2] {
        [(&self.linear, self.kind.linear()), (&self.turning, self.kind.turning())]
    }

    /// Returns the coordinates at rest, with those of the zero position where none are given.
    pub fn rest_coordinates(&self) -> Vec<f64> {
        if self.rest.is_empty() { self.kind.zero_position() } else { self.rest.clone() }
    }
}

impl HingeKind {
    /// Returns how many coordinates a hinge of this kind has.
    pub fn coordinates(&self) -> usize {
        self.freedoms() + usize::from(self.has_quaternion())
    }

    /// Returns how many rates, and efforts, a hinge of this kind has.
    pub fn freedoms(&self) -> usize {
        let (linear, turning) = self.group_sizes();
        linear + turning
    }

    /// Returns which of the rates are shifts.
    pub fn linear(&self) -> Range<usize> {
        0..self.group_sizes().0
    }

    /// Returns which of the rates are turns.
    pub fn turning(&self) -> Range<usize> {
        self.group_sizes().0..self.freedoms()
    }

    /// Returns whether the turns have a quaternion for their coordinates.
    pub fn has_quaternion(&self) -> bool {
        matches!(self, HingeKind::Ball | HingeKind::Floating)
    }

    /// Returns the coordinates at which the two frames coincide.
    pub fn zero_position(&self) -> Vec<f64> {
        let mut zero = vec![0.0; self.coordinates()];
        if self.has_quaternion() {
            zero[self.linear().end] = 1.0;
        }
        zero
    }

    fn group_sizes(&self) -> (usize, usize) {
        match self {
            HingeKind::Weld => (0, 0),
            HingeKind::Pin { .. } | HingeKind::Screw { .. } => (0, 1),
            HingeKind::Slider { .. } | HingeKind::LineFloating | HingeKind::LineElastic => (1, 0),
            HingeKind::Cylindrical { .. } => (1, 1),
            HingeKind::Universal { .. } => (0, 2),
            HingeKind::Ball => (0, 3),
            HingeKind::Planar { .. } | HingeKind::PlaneFloating | HingeKind::PlaneElastic => (2, 1),
            HingeKind::Floating | HingeKind::Elastic => (3, 3),
        }
    }
}

impl Axis {
    /// Returns the number of the axis, counted from zero.
    pub fn index(self) -> usize {
        match self {
            Axis::X => 0,
            Axis::Y => 1,
            Axis::Z => 2,
        }
    }
}

impl Group {
    /// Returns whether nothing acts along the group.
    pub fn is_empty(&self) -> bool {
        *self == Group::default()
    }

    /// Returns the entry of a list for one strain of the group, zero where the list is empty.
    pub(crate) fn entry(list: &[f64], k: usize) -> f64 {
        match list {
            [] => 0.0,
            [one] => *one,
            several => several[k],
        }
    }
}
