//! The keywords of [`mstmm_chain!`](crate::mstmm_chain): kinds of hinges, settings, fields, units, and words of `answers`.
//!
//! Editors show these pages inside a description: hover over `pin`, `mass`, `torque`, `jacobian` or `kg`, or go to
//! its definition. Generated code mentions each keyword as a type with the span of the text. The types
//! have no values and no other use.
//!
//! The pages are made from the tables of [the reference](crate::mstmm_chain) and from the compiler's
//! table of units. Those of [`answers`] and [`hinge`](mod@hinge) are found by the names in
//! [`terms`](crate::terms), too.

// Keywords are written in lower case.
#![allow(non_camel_case_types)]

/// Words of the setting `answers`: the functions that a chain can have.
pub mod answers;
/// Fields of `body` blocks after the route: the start of a floating base.
pub mod base;
/// Fields of body types.
#[doc(alias("RigidBody", "inertial", "SpatialInertia", "Inertia"))]
#[doc(alias("geom", "RegisterVisualGeometry", "GeometryObject"))]
pub mod body;
/// Fields of `hinge` blocks.
pub mod hinge;
/// Kinds of hinges on a route.
pub mod kinds;
/// Fields of `load` blocks.
#[doc(alias("xfrc_applied", "ExternallyAppliedSpatialForce", "fext", "external force", "wrench"))]
pub mod load;
/// Settings of a chain.
#[doc(alias("UniformGravityFieldElement", "Model::gravity"))]
pub mod settings;
/// Fields of `spring` blocks.
#[doc(alias("LinearSpringDamper", "AddForceElement", "tendon", "tendon/spatial", "springlength"))]
pub mod spring;
/// Units of numbers.
pub mod units;

/// Keywords whose meaning does not depend on the block, for generated code.
#[doc(hidden)]
pub mod unique {
    pub use super::{answers::*, body::*, hinge::*, kinds::*, settings::*, units::*};
}
