//! Loads and springs on bodies.

use super::{BodyId, Effort, Frame, Value};
use proc_macro2::Ident;

/// Where a vector comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// There is none.
    Nothing,
    /// Constant.
    Constant([Value; 3]),
    /// Given by the caller at every step.
    Input,
}

/// A force and a torque on a body.
#[derive(Clone, Debug)]
pub struct Load {
    /// Its name; in a part, the names of the path joined by `_`.
    pub name: Ident,
    /// The path as written, for the description at run time: `fl.push`.
    pub path: String,
    /// The body that it acts on.
    pub body: BodyId,
    /// The point of application, body frame. Its axes are those of a load in body axes.
    pub at: Frame,
    /// The axes of force and torque.
    pub axes: LoadAxes,
    /// The force in N.
    pub force: Source,
    /// The torque in N m, in addition to the moment of the force.
    pub torque: Source,
}

/// The axes in which a load is given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadAxes {
    /// Those of the inertial frame.
    Inertial,
    /// Those of the body.
    Body,
}

/// A spring with a damper and an actuator, from a body to the ground or to another body.
#[derive(Clone, Debug)]
pub struct Spring {
    /// Its name; in a part, the names of the path joined by `_`.
    pub name: Ident,
    /// The path as written, for docs.
    pub path: String,
    /// The point where it is attached to its body.
    pub on: BodyPoint,
    /// Its other end.
    pub to: SpringEnd,
    /// Stiffness in N/m.
    pub stiffness: Value,
    /// Damping along the spring in N s/m.
    pub damping: Value,
    /// Its length without load in m.
    pub length: Value,
    /// The force of its actuator in N, which drives the rate of its length: positive if it pushes the ends apart.
    pub force: Effort,
}

/// A point of a body.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyPoint {
    /// The body.
    pub body: BodyId,
    /// The point in m, body frame.
    pub at: [Value; 3],
}

/// The other end of a spring.
#[derive(Clone, Debug, PartialEq)]
pub enum SpringEnd {
    /// A point on the ground in m, inertial frame.
    Ground([Value; 3]),
    /// A point of a body: of the same repetition if the body is repeated, else of a body outside.
    Body(BodyPoint),
    /// A point of a body of the previous repetition.
    Previous {
        /// The point.
        point: BodyPoint,
        /// What it is in the first repetition: a point of a body outside. In another repeated part
        /// this is the body of its last repetition.
        first: BodyPoint,
    },
}
