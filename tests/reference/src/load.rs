//! External loads, and springs between two bodies or between a body and the ground.

use crate::hinge::Source;

/// A force at a point of a body and a pure couple.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// The snake_case name of the load.
    pub name: String,
    /// The name of the body it acts on.
    pub body: String,
    /// The point the force acts at.
    pub at: BodyPoint,
    /// The force in N.
    pub force: Source<[f64; 3]>,
    /// The couple in N·m.
    pub torque: Source<[f64; 3]>,
    /// The axes both are given in.
    pub axes: Axes,
}

/// A spring with a damper from a point of a body to a point of the ground or of another body.
#[derive(Clone, Debug, PartialEq)]
pub struct Spring {
    /// The snake_case name of the spring.
    pub name: String,
    /// The name of the body it acts on.
    pub body: String,
    /// The point of the body.
    pub at: BodyPoint,
    /// The other end.
    pub to: SpringEnd,
    /// The stiffness in N/m.
    pub stiffness: f64,
    /// The damping constant in N·s/m, along the spring.
    pub damping: f64,
    /// The length without force in m.
    pub length: f64,
    /// The force of an actuator in N that pushes the ends apart.
    pub force: Source<f64>,
}

/// The end of a spring that is not on its own body.
#[derive(Clone, Debug, PartialEq)]
pub enum SpringEnd {
    /// A point of the ground in m, inertial.
    Ground([f64; 3]),
    /// A point of a body.
    Body {
        /// The name of the body.
        body: String,
        /// The point of the body.
        at: BodyPoint,
    },
}

/// A point of a body.
#[derive(Clone, Debug, PartialEq)]
pub enum BodyPoint {
    /// The centre of mass.
    Com,
    /// The input.
    Input,
    /// The output.
    Output,
    /// A position in m, in the body frame.
    At([f64; 3]),
    /// A named point of the body's type.
    Named {
        /// The snake_case name.
        name: String,
        /// The position in m, in the body frame. It is ignored if the body has a point of this name.
        position: [f64; 3],
    },
}

/// The axes of a load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axes {
    /// The inertial axes.
    Inertial,
    /// The axes of the body.
    Body,
}
