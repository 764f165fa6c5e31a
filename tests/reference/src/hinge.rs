//! The description of a hinge: its degrees of freedom, and the springs, dampers and motors in it.

use std::ops::Range;

/// A hinge from an inboard frame (ground, a moving frame, or the output frame of the body before it)
/// to an outboard frame (the body after it, ground, or a moving frame). At zero coordinates the two
/// frames coincide.
#[derive(Clone, Debug, PartialEq)]
pub struct Hinge {
    /// The snake_case name of the hinge.
    pub name: String,
    /// The kind, which defines the relative motion that the hinge allows.
    pub kind: HingeKind,
    /// The coordinates at which springs carry no load; empty for the zero position. Quaternions need
    /// not be normalised.
    pub rest: Vec<f64>,
    /// The springs, dampers and so on along the rates of [`HingeKind::linear`].
    pub linear: Group,
    /// The springs, dampers and so on along the rates of [`HingeKind::turning`].
    pub turning: Group,
    /// Whether the motion is prescribed, see [`crate::Drives::motions`]. The hinge has no entries in
    /// the state then.
    pub prescribed: bool,
}

/// The relative motion that a hinge allows.
///
/// The rotation R transforms outboard components into inboard components; d is the vector from the
/// inboard to the outboard origin, in inboard axes. Units are SI units, angles are in rad. Axes have
/// any length except zero; their components are the same on both sides unless stated otherwise.
#[derive(Clone, Debug, PartialEq)]
pub enum HingeKind {
    /// No motion at all: the two frames are the same.
    Weld,
    /// A rotation about an axis. The coordinate is the angle, right-handed, the rate is its
    /// derivative, and the effort is a torque in N·m that acts positively on the outboard side.
    Pin {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A translation along an axis; the effort is a force in N.
    Slider {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A rotation about an axis with a proportional translation along it. The coordinate is the angle.
    Screw {
        /// The direction of the axis.
        axis: [f64; 3],
        /// The translation per angle, in m/rad.
        pitch: f64,
    },
    /// A translation along an axis and a rotation about it. The translation comes first.
    Cylindrical {
        /// The direction of the axis.
        axis: [f64; 3],
    },
    /// A rotation about a first axis, then a rotation about a second axis that moves with the first.
    Universal {
        /// The first axis, in inboard components.
        first: [f64; 3],
        /// The second axis, in outboard components; not parallel to the first.
        second: [f64; 3],
    },
    /// Three rotations, each about an axis that moves with the rotations before it. The coordinates are
    /// the angles, the rates are their derivatives, and each effort is a torque about its axis.
    Gimbal {
        /// The axes in the position where all angles are zero; successive ones are not parallel.
        axes: [[f64; 3]; 3],
    },
    /// Any rotation. The coordinates are a quaternion (w, x, y, z) that transforms outboard
    /// components into inboard components. The rates are the angular velocity in rad/s of the
    /// outboard side relative to the inboard side, and the efforts are a torque in N·m on the
    /// outboard side, both in outboard components.
    Ball,
    /// Translations along the two inboard axes that follow the normal cyclically, then the rotation
    /// about the normal.
    Planar {
        /// The normal of the plane.
        normal: Axis,
    },
    /// Any motion. The coordinates are d and the quaternion of R. The rates are the derivative of d
    /// (inboard axes) and the angular velocity (outboard axes). The efforts are a force in N (inboard
    /// axes, at the outboard origin) and a torque in N·m (outboard axes).
    Floating,
    /// Any motion with small rotations about x and y: R = Az(θ3) Ay(θ2) Ax(θ1), d = Az(θ3) Δ. The
    /// coordinates are Δ, θ1, θ2, θ3; rates and efforts are those of [`HingeKind::Floating`].
    Elastic,
    /// The keyword `floating` in a plane chain: the same as planar.
    PlaneFloating,
    /// The keyword `elastic` in a plane chain: d = Az(θ) Δ. The coordinates are Δx, Δy, θ; the
    /// rates are the derivatives of d (inboard axes) and of θ.
    PlaneElastic,
    /// The keyword `floating` in a line chain: the same as a slider along x.
    LineFloating,
    /// The keyword `elastic` in a line chain: the same as a slider along x.
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

/// The springs, dampers, rotors, friction, limits and motors of one group of a hinge's rates, for
/// translations in N, kg and so on, for rotations in N·m, kg·m² and so on.
///
/// A list is empty for nothing, or holds one number for all strains of the group, or one number for
/// each. The three rotations of a ball or of a floating hinge always share one number.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// The stiffnesses against strains.
    pub stiffness: Vec<f64>,
    /// The damping constants against strain rates.
    pub damping: Vec<f64>,
    /// The inertias of rotors that move with the strains.
    pub armature: Vec<f64>,
    /// The friction at high speed.
    pub friction: Vec<f64>,
    /// The speed at which friction has about 0.7 of its full value.
    pub friction_speed: f64,
    /// The stops, if there are any.
    pub limits: Option<Limits>,
    /// The motor.
    pub motor: Source<Vec<f64>>,
}

/// Limits beyond which an additional spring and an additional damper act.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The lowest and the highest coordinate at which they do not act. For the rotations of a ball or
    /// of a floating hinge, the second is the largest angle from rest, and the first is ignored.
    pub range: [f64; 2],
    /// The stiffness beyond the limits.
    pub stiffness: f64,
    /// The damping constant beyond the limits.
    pub damping: f64,
}

/// A value that is constant or an input.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Source<T> {
    /// No value.
    #[default]
    None,
    /// Constant.
    Constant(T),
    /// Given at every instant, see [`crate::Drives`].
    Input,
}

impl Hinge {
    /// Returns a hinge without springs, dampers or motors.
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

    /// Returns the number of the hinge's coordinates in a state.
    pub fn coordinates(&self) -> usize {
        if self.prescribed { 0 } else { self.kind.coordinates() }
    }

    /// Returns the number of the hinge's rates in a state.
    pub fn dof_count(&self) -> usize {
        if self.prescribed { 0 } else { self.kind.dof_count() }
    }

    /// Returns the two groups with the rates they act along.
    pub fn groups(&self) -> [(&Group, Range<usize>); 2] {
        [(&self.linear, self.kind.linear()), (&self.turning, self.kind.turning())]
    }

    /// Returns the coordinates at rest; the zero position if none are specified.
    pub fn rest_coordinates(&self) -> Vec<f64> {
        if self.rest.is_empty() { self.kind.zero_position() } else { self.rest.clone() }
    }
}

impl HingeKind {
    /// Returns the number of coordinates of a hinge of this kind.
    pub fn coordinates(&self) -> usize {
        self.dof_count() + usize::from(self.has_quaternion())
    }

    /// Returns the number of rates, and of efforts, of a hinge of this kind.
    pub fn dof_count(&self) -> usize {
        let (linear, turning) = self.group_sizes();
        linear + turning
    }

    /// Returns the rates that are translational.
    pub fn linear(&self) -> Range<usize> {
        0..self.group_sizes().0
    }

    /// Returns the rates that are rotational.
    pub fn turning(&self) -> Range<usize> {
        self.group_sizes().0..self.dof_count()
    }

    /// Returns whether the coordinates of the rotations are a quaternion.
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
            HingeKind::Ball | HingeKind::Gimbal { .. } => (0, 3),
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
    /// Returns whether the group has no springs, dampers, motors and so on.
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
