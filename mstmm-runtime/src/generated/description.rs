//! What descriptions of chains are made of.
//!
//! Generated code imports all names of this module. They end in an underscore, so they differ from the names of the
//! user's constants.

use crate::description::{
    Description, Dimension, Dofs, Geometry, HingeShape, Indices, Input, Parameter, QuantityKind,
    Shape, Spring, WrittenEnd, WrittenInertia, no_parameter,
};

pub use crate::description::{
    Arrays as Arrays_, HingeShape as Shape_, PointResult as PointResult_,
    WrittenInertia as Inertia_, WrittenVectors as Vectors_,
};

/// The result of setting a parameter.
pub type Set_ = Result<(), crate::Error>;

/// The shapes of a body.
pub type Visuals_ = &'static [Shape];

/// A value that is not known while the chain compiles, or a limit that does not exist.
pub const NAN_: f64 = f64::NAN;

/// Makes the description of a chain without elements, in this number of dimensions.
#[must_use]
pub const fn describe_(name: &'static str, docs: &'static str, dimensions: u8) -> Description {
    let dimension = match dimensions {
        1 => Dimension::Line,
        2 => Dimension::Plane,
        _ => Dimension::Space,
    };
    Description::new(name, docs, dimension)
}

/// Makes a kind of hinge.
#[must_use]
pub const fn shape_(keyword: &'static str, dofs: &'static [Dofs]) -> HingeShape {
    HingeShape::new(keyword, dofs)
}

/// Makes translations, from the accessors of coordinates and rates and the names of their components.
#[must_use]
pub const fn moving_(
    coordinates: &'static str,
    rates: &'static str,
    components: &'static str,
) -> Dofs {
    Dofs::moving(coordinates, rates, components)
}

/// Makes rotations by angles.
#[must_use]
pub const fn turning_(
    coordinates: &'static str,
    rates: &'static str,
    components: &'static str,
) -> Dofs {
    Dofs::turning(coordinates, rates, components)
}

/// Makes all rotations, with a quaternion.
#[must_use]
pub const fn orienting_(coordinates: &'static str, rates: &'static str) -> Dofs {
    Dofs::orienting(coordinates, rates)
}

/// Makes an inertia from mass, centre of mass, and the entries xx, yy, zz of a tensor about the centre of mass or the
/// input.
#[must_use]
pub const fn diag_(mass: f64, com: [f64; 3], diag: [f64; 3], about_com: bool) -> WrittenInertia {
    let [xx, yy, zz] = diag;
    WrittenInertia::new(mass, com, [xx, yy, zz, 0.0, 0.0, 0.0], about_com)
}

/// Makes an inertia from mass, centre of mass, and the entries xx, yy, zz, xy, xz, yz of a tensor.
#[must_use]
pub const fn tensor_(
    mass: f64,
    com: [f64; 3],
    tensor: [f64; 6],
    about_com: bool,
) -> WrittenInertia {
    WrittenInertia::new(mass, com, tensor, about_com)
}

/// Makes a shape from its geometry, and its position and its quaternion in the body frame.
#[must_use]
pub const fn visual_(geometry: Geometry, position: [f64; 3], orientation: [f64; 4]) -> Shape {
    Shape { geometry, position, orientation }
}

/// Makes a box from the lengths of its edges.
#[must_use]
pub const fn box_(edges: [f64; 3]) -> Geometry {
    Geometry::Box(edges)
}

/// Makes a cylinder.
#[must_use]
pub const fn cylinder_(radius: f64, length: f64) -> Geometry {
    Geometry::Cylinder { radius, length }
}

/// Makes a capsule.
#[must_use]
pub const fn capsule_(radius: f64, length: f64) -> Geometry {
    Geometry::Capsule { radius, length }
}

/// Makes a sphere.
#[must_use]
pub const fn sphere_(radius: f64) -> Geometry {
    Geometry::Sphere { radius }
}

/// Makes a mesh from the path of its file.
#[must_use]
pub const fn mesh_(file: &'static str) -> Geometry {
    Geometry::Mesh(file)
}

/// Makes a spring from its path and its ends.
#[must_use]
pub const fn spring_(path: &'static str, ends: [WrittenEnd; 2]) -> Spring {
    Spring::new(path, ends)
}

/// Makes an end of a spring on the ground.
#[must_use]
pub const fn grounded_(at: [f64; 3]) -> WrittenEnd {
    WrittenEnd::new(None, [at; 2])
}

/// Makes an end of a spring on a body.
#[must_use]
pub const fn fixed_(body: usize, at: [f64; 3]) -> WrittenEnd {
    WrittenEnd::new(Some(Indices::new([body, body, 0])), [at; 2])
}

/// Makes an end of a spring on a body of each repetition, from the indices of the body in the first and in the second
/// repetition, the difference from each later one to the next, and the points in the first and in the later ones.
#[must_use]
pub const fn fixed_each_(bodies: [usize; 3], at: [[f64; 3]; 2]) -> WrittenEnd {
    WrittenEnd::new(Some(Indices::new(bodies)), at)
}

/// Makes a parameter from its path, its unit and its default.
#[must_use]
pub const fn parameter_(path: &'static str, unit: &'static str, default: f64) -> Parameter {
    Parameter::new(path, unit, default)
}

/// Returns the error for a parameter that does not exist.
///
/// # Errors
/// Always.
pub const fn no_parameter_() -> Set_ {
    no_parameter()
}

/// Adds functions that each make inputs of one kind from their path and the names of their components.
macro_rules! inputs {
    ($($(#[$doc:meta])* $name:ident: $kind:ident,)*) => { $(
        $(#[$doc])*
        #[must_use]
        pub const fn $name(path: &'static str, components: &'static str) -> Input {
            Input::new(path, components, QuantityKind::$kind)
        }
    )* };
}

inputs! {
    /// Makes displacements.
    length_: Length,
    /// Makes angles.
    angle_: Angle,
    /// Makes components of a quaternion.
    orientation_: Quaternion,
    /// Makes velocities.
    velocity_: Velocity,
    /// Makes angular velocities.
    angular_velocity_: AngularVelocity,
    /// Makes accelerations.
    acceleration_: Acceleration,
    /// Makes angular accelerations.
    angular_acceleration_: AngularAcceleration,
    /// Makes forces.
    force_: Force,
    /// Makes torques.
    torque_: Torque,
}
