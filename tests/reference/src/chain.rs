//! The description of a chain and of its state, as plain data.

use crate::hinge::Hinge;
use crate::load::{Load, Spring};
use crate::route::{NamedPoint, Place, Route};

/// A chain of rigid bodies and hinges: one route, or a tree or several trees of routes.
///
/// The elements of a route alternate between hinges and bodies. An end that is [`End::Free`] is a
/// body, any other end is a hinge. A chain with both ends of its first route attached is closed: its
/// last hinge has coordinates and rates, too, which have to agree with those of the other hinges.
///
/// In a plane chain all vectors have a z component of zero, all rotations are about z, and only the
/// entry zz of an inertia is used. In a line chain all vectors are along x, nothing rotates, and
/// inertias are ignored.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// The CamelCase name of the chain in the description language.
    pub name: String,
    /// The space in which the chain moves.
    pub dimension: Dimension,
    /// The acceleration of free fall.
    pub gravity: Gravity,
    /// What the input of the first element of the first route is attached to.
    pub start: End,
    /// What the output of the last element of the first route is attached to.
    pub finish: End,
    /// The hinges and bodies of the first route in written order.
    pub elements: Vec<Element>,
    /// The other routes in written order.
    pub later_routes: Vec<Route>,
    /// The external loads on bodies.
    pub loads: Vec<Load>,
    /// The springs between bodies, or between bodies and the ground.
    pub springs: Vec<Spring>,
}

/// The space in which a chain moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Anywhere.
    Space,
    /// In the plane of x and y, with rotations about z.
    Plane,
    /// Along x, without rotations.
    Line,
}

/// The acceleration of free fall in m/s², in inertial axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Gravity {
    /// Constant.
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
    /// The end is a hinge to a frame with a prescribed motion, [`crate::Drives::start`],
    /// [`crate::Drives::finish`] or one of [`crate::Drives::route_starts`].
    Moving {
        /// The snake_case name of the frame.
        name: String,
    },
    /// The end is a hinge to a body of an earlier route.
    Place(Place),
}

/// A position and an orientation.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The position of the origin in m, in the axes of the frame this one is given in.
    pub position: [f64; 3],
    /// Roll, pitch and yaw in degrees. The matrix `Az(yaw) * Ay(pitch) * Ax(roll)` transforms
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
    /// The named points at which hinges may join the body.
    pub points: Vec<NamedPoint>,
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
/// The pose of the first body comes first if the chain floats (both ends of its first route are
/// free): the position of
/// its input point (m, inertial axes), then the quaternion (w, x, y, z) from body to inertial
/// components. Its rates are the velocity of the input point (m/s, inertial axes), then the angular
/// velocity (rad/s, body axes). In the plane these are x, y and the angle, and their derivatives;
/// along a line they are x and its derivative. The hinges follow in written order, also if the chain
/// is held only at its finish. Hinges with prescribed motions have no entries. Quaternions need not
/// be normalised exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The coordinates, [`Chain::coordinates`] of them.
    pub q: Vec<f64>,
    /// The rates, [`Chain::dof_count`] of them.
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
            later_routes: Vec::new(),
            loads: Vec::new(),
            springs: Vec::new(),
        }
    }

    /// Returns the number of coordinates in a state of this chain.
    pub fn coordinates(&self) -> usize {
        self.base_coordinates() + self.hinges().map(Hinge::coordinates).sum::<usize>()
    }

    /// Returns the number of rates in a state of this chain: the number of degrees of freedom if the
    /// chain is not closed.
    pub fn dof_count(&self) -> usize {
        self.base_dof_count() + self.hinges().map(Hinge::dof_count).sum::<usize>()
    }

    /// Returns the number of coordinates of the floating base, 0 if the chain does not float.
    pub fn base_coordinates(&self) -> usize {
        match self.dimension {
            _ if !self.floats() => 0,
            Dimension::Space => 7,
            Dimension::Plane => 3,
            Dimension::Line => 1,
        }
    }

    /// Returns the number of rates of the floating base, 0 if the chain does not float.
    pub fn base_dof_count(&self) -> usize {
        if self.floats() { self.dimension.directions().len() } else { 0 }
    }

    /// Returns whether both ends are free, so that the first body floats.
    pub fn floats(&self) -> bool {
        self.start == End::Free && *self.attached_finish() == End::Free
    }

    /// Returns whether neither end is free.
    pub fn closed(&self) -> bool {
        self.start != End::Free && *self.attached_finish() != End::Free
    }

    /// Returns the bodies in written order.
    pub fn bodies(&self) -> impl Iterator<Item = &Body> {
        self.all_elements().filter_map(|element| match element {
            Element::Body(body) => Some(body),
            Element::Hinge(_) => None,
        })
    }

    /// Returns the hinges in written order.
    pub fn hinges(&self) -> impl Iterator<Item = &Hinge> {
        self.all_elements().filter_map(|element| match element {
            Element::Hinge(hinge) => Some(hinge),
            Element::Body(_) => None,
        })
    }
}

impl Dimension {
    /// Returns the components of velocities and angular velocities (x, y, z, about x, about y,
    /// about z) that can differ from zero.
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

    /// Returns the frame at a position in m, without a rotation.
    pub fn at(position: [f64; 3]) -> Frame {
        Frame { position, rpy_degrees: [0.0; 3] }
    }

    /// Returns the matrix that transforms components in this frame into components in the frame it
    /// is given in, row by row.
    pub fn rotation(&self) -> [[f64; 3]; 3] {
        crate::rotation::rows(&crate::rotation::from_rpy_degrees(&self.rpy_degrees))
    }
}
