//! The description of a chain and of its state, as plain data.

/// An open chain of rigid bodies and hinges.
///
/// The elements alternate between hinges and bodies. A chain that starts [`End::Held`] begins with
/// a hinge, one that starts [`End::Free`] begins with a body, and likewise at the finish. At least
/// one end must be free.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The CamelCase name of the chain in the description language.
    pub name: String,
    /// The acceleration of free fall in m/s², in inertial axes.
    pub gravity: [f64; 3],
    /// What the input of the first element is attached to.
    pub start: End,
    /// What the output of the last element is attached to.
    pub finish: End,
    /// The hinges and bodies in written order.
    pub elements: Vec<Element>,
}

/// What one end of a chain is attached to.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// The end carries no load and moves freely.
    Free,
    /// The end is a hinge to this frame, which is fixed in the inertial frame.
    Held(Frame),
}

/// A place: a position together with an orientation.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The position of the origin in m, in the axes of the frame this one is given in.
    pub position: [f64; 3],
    /// Roll, pitch and yaw in degrees. The matrix `Az(yaw) * Ay(pitch) * Ax(roll)` turns
    /// components in this frame into components in the frame it is given in.
    pub rpy_degrees: [f64; 3],
}

/// One element of a chain.
#[derive(Clone, Debug, PartialEq)]
pub enum Element {
    /// A rigid body.
    Body(Body),
    /// A hinge between two neighbours.
    Hinge(Hinge),
}

/// A rigid body. Its frame has its origin at the body's input point.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// The snake_case name of the body.
    pub name: String,
    /// The mass in kg.
    pub mass: f64,
    /// The centre of mass in m, in the body frame.
    pub com: [f64; 3],
    /// The output frame, in the body frame.
    pub output: Frame,
    /// The tensor entries xx, yy, zz, xy, xz and yz in kg·m², in body axes. The last three are
    /// entries of the tensor, that is, negative products of inertia.
    pub inertia: [f64; 6],
    /// The point the inertia is given about.
    pub about: About,
}

/// The point an inertia tensor is given about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum About {
    /// The input point of the body.
    Input,
    /// The centre of mass.
    Com,
}

/// A hinge from an inboard place (ground, or the output frame of the body before it) to an outboard
/// place (the body after it, or ground). The origins of the two places coincide.
#[derive(Clone, Debug, PartialEq)]
pub struct Hinge {
    /// The snake_case name of the hinge.
    pub name: String,
    /// Which relative motion the hinge allows.
    pub kind: HingeKind,
    /// Whether the description declares a torque input. The solver itself applies whatever effort
    /// it is given.
    pub motor: bool,
}

/// The relative motion a hinge allows.
#[derive(Clone, Debug, PartialEq)]
pub enum HingeKind {
    /// No motion at all: the two frames are the same.
    Weld,
    /// The outboard frame is turned against the inboard one about an axis, right-handed. The
    /// coordinate is the angle in rad, the rate its derivative, the effort a torque in N·m that
    /// acts positively on the outboard side.
    Pin {
        /// The direction of the axis, of any length but zero; its components are the same on both
        /// sides.
        axis: [f64; 3],
    },
    /// Any turn. The coordinates are a quaternion (w, x, y, z) that turns outboard components into
    /// inboard ones. The rates are the angular velocity in rad/s of the outboard side relative to
    /// the inboard one, and the efforts a torque in N·m on the outboard side, both in
    /// outboard-frame components.
    Ball,
}

/// The coordinates and rates of a chain.
///
/// A floating chain (both ends free) comes first with the pose of its first body: position of the
/// input point (m, inertial), then the quaternion (w, x, y, z) from body to inertial components.
/// Its rates are the velocity of the input point (m/s, inertial axes), then the angular velocity
/// (rad/s, body axes). The hinges follow in written order, also when the chain is held only at its
/// finish. Quaternions need not be normalised exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The coordinates, [`Chain::coordinates`] of them.
    pub q: Vec<f64>,
    /// The rates, [`Chain::freedoms`] of them.
    pub v: Vec<f64>,
}

impl Chain {
    /// Returns how many coordinates a state of this chain has.
    pub fn coordinates(&self) -> usize {
        let base = if self.floats() { 7 } else { 0 };
        base + self.hinges().map(|hinge| hinge.kind.coordinates()).sum::<usize>()
    }

    /// Returns how many rates a state of this chain has, which is the number of its freedoms.
    pub fn freedoms(&self) -> usize {
        let base = if self.floats() { 6 } else { 0 };
        base + self.hinges().map(|hinge| hinge.kind.freedoms()).sum::<usize>()
    }

    /// Returns whether both ends are free.
    pub fn floats(&self) -> bool {
        self.start == End::Free && self.finish == End::Free
    }

    /// Returns the bodies in written order.
    pub fn bodies(&self) -> impl Iterator<Item = &Body> {
        self.elements.iter().filter_map(|element| match element {
            Element::Body(body) => Some(body),
            Element::Hinge(_) => None,
        })
    }

    /// Returns the hinges in written order.
    pub fn hinges(&self) -> impl Iterator<Item = &Hinge> {
        self.elements.iter().filter_map(|element| match element {
            Element::Hinge(hinge) => Some(hinge),
            Element::Body(_) => None,
        })
    }
}

impl HingeKind {
    /// Returns how many coordinates a hinge of this kind has.
    pub fn coordinates(&self) -> usize {
        match self {
            HingeKind::Weld => 0,
            HingeKind::Pin { .. } => 1,
            HingeKind::Ball => 4,
        }
    }

    /// Returns how many rates, and efforts, a hinge of this kind has.
    pub fn freedoms(&self) -> usize {
        match self {
            HingeKind::Weld => 0,
            HingeKind::Pin { .. } => 1,
            HingeKind::Ball => 3,
        }
    }
}

impl Frame {
    /// The frame that coincides with the one it is given in.
    pub const IDENTITY: Frame = Frame { position: [0.0; 3], rpy_degrees: [0.0; 3] };

    /// Returns the frame at a position in m, not turned.
    pub fn at(position: [f64; 3]) -> Frame {
        Frame { position, rpy_degrees: [0.0; 3] }
    }

    /// Returns the matrix that turns components in this frame into components in the frame it is
    /// given in, row by row.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        crate::rotation::rows(&crate::rotation::from_rpy_degrees(&self.rpy_degrees))
    }
}
