//! The description of a chain and of its state, as plain data.

use crate::hinge::Hinge;
use crate::load::{Load, Spring};

/// A chain of rigid bodies and hinges.
///
/// The elements alternate between hinges and bodies. At an end that is [`End::Free`] stands a body,
/// at any other end a hinge. Both ends may be attached: the chain is closed then, and its last hinge
/// has coordinates and rates of its own that have to agree with those of the others.
///
/// In a chain of the plane all vectors have a z component of zero and all turns are about z; of an
/// inertia only the entry zz counts. In a chain along a line all vectors lie along x, nothing turns,
/// and inertias do not count.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The CamelCase name of the chain in the description language.
    pub name: String,
    /// Where the chain moves.
    pub dimension: Dimension,
    /// The acceleration of free fall.
    pub gravity: Gravity,
    /// What the input of the first element is attached to.
    pub start: End,
    /// What the output of the last element is attached to.
    pub finish: End,
    /// The hinges and bodies in written order.
    pub elements: Vec<Element>,
    /// The loads from outside on bodies.
    pub loads: Vec<Load>,
    /// The springs between bodies and the ground.
    pub springs: Vec<Spring>,
}

/// Where a chain moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Anywhere.
    Space,
    /// In the plane of x and y, turning about z.
    Plane,
    /// Along x, without turning.
    Line,
}

/// The acceleration of free fall in m/s², in inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gravity {
    /// Always the same.
    Constant([f64; 3]),
    /// Given at every instant, [`crate::Drives::gravity`]; it has no potential.
    Input,
}

/// What one end of a chain is attached to.
#[derive(Clone, Debug, PartialEq)]
pub enum End {
    /// The end carries no load and moves freely.
    Free,
    /// The end is a hinge to this frame, which is fixed in the inertial frame.
    Held(Frame),
    /// The end is a hinge to a frame that moves as it is told, [`crate::Drives::start`] or
    /// [`crate::Drives::finish`].
    Moving {
        /// The snake_case name of the frame.
        name: String,
    },
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
#[expect(clippy::large_enum_variant, reason = "chains have few elements, and tests many literals")]
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

/// The coordinates and rates of a chain.
///
/// A floating chain (both ends free) comes first with the pose of its first body: position of the
/// input point (m, inertial), then the quaternion (w, x, y, z) from body to inertial components.
/// Its rates are the velocity of the input point (m/s, inertial axes), then the angular velocity
/// (rad/s, body axes). In the plane these are x, y and the angle, and their derivatives; along a
/// line x and its derivative. The hinges follow in written order, also when the chain is held only
/// at its finish; hinges with prescribed motions have no entries. Quaternions need not be
/// normalised exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The coordinates, [`Chain::coordinates`] of them.
    pub q: Vec<f64>,
    /// The rates, [`Chain::freedoms`] of them.
    pub v: Vec<f64>,
}

impl Chain {
    /// An open chain in space, without loads and springs: held at the inertial frame and free at
    /// its finish.
    pub fn new(name: &str, gravity: [f64; 3], elements: Vec<Element>) -> Chain {
        Chain {
            name: name.to_owned(),
            dimension: Dimension::Space,
            gravity: Gravity::Constant(gravity),
            start: End::Held(Frame::IDENTITY),
            finish: End::Free,
            elements,
            loads: Vec::new(),
            springs: Vec::new(),
        }
    }

    /// Returns how many coordinates a state of this chain has.
    pub fn coordinates(&self) -> usize {
        self.base_coordinates() + self.hinges().map(Hinge::coordinates).sum::<usize>()
    }

    /// Returns how many rates a state of this chain has. It is the number of its freedoms where the
    /// chain is not closed.
    pub fn freedoms(&self) -> usize {
        self.base_freedoms() + self.hinges().map(Hinge::freedoms).sum::<usize>()
    }

    /// Returns how many coordinates come before those of the hinges: some where the chain floats.
    pub fn base_coordinates(&self) -> usize {
        match self.dimension {
            _ if !self.floats() => 0,
            Dimension::Space => 7,
            Dimension::Plane => 3,
            Dimension::Line => 1,
        }
    }

    /// Returns how many rates come before those of the hinges: some where the chain floats.
    pub fn base_freedoms(&self) -> usize {
        if self.floats() { self.dimension.directions().len() } else { 0 }
    }

    /// Returns whether both ends are free.
    pub fn floats(&self) -> bool {
        self.start == End::Free && self.finish == End::Free
    }

    /// Returns whether neither end is free.
    pub fn closed(&self) -> bool {
        self.start != End::Free && self.finish != End::Free
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

impl Dimension {
    /// Returns which components of velocities and angular velocities (x, y, z, about x, about y,
    /// about z) can be other than zero.
    pub(crate) fn directions(self) -> &'static [usize] {
        match self {
            Dimension::Space => &[0, 1, 2, 3, 4, 5],
            Dimension::Plane => &[0, 1, 5],
            Dimension::Line => &[0],
        }
    }
}

impl From<[f64; 3]> for Gravity {
    fn from(acceleration: [f64; 3]) -> Gravity {
        Gravity::Constant(acceleration)
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
