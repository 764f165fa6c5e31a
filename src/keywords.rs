//! The keywords of [`mstmm_chain!`](crate::mstmm_chain): kinds of hinges, settings, fields and units.
//!
//! Editors show these pages inside a description: hover over `pin`, `mass`, `torque` or `kg`, or go to
//! its definition. Generated code mentions each keyword as a type with the span of the text. The types
//! have no values and no other use.
//!
//! The pages are made from the tables of [the reference](crate::mstmm_chain) and from the compiler's
//! table of units.

// Keywords are written in lower case.
#![allow(non_camel_case_types)]

/// Fields of `body` blocks after the route: the start of a floating base.
pub mod base;
/// Fields of body types.
pub mod body;
/// Fields of `hinge` blocks.
pub mod hinge;
/// Kinds of hinges on a route.
pub mod kinds;
/// Fields of `load` blocks.
pub mod load;
/// Settings of a chain.
pub mod settings;
/// Fields of `spring` blocks.
pub mod spring;
/// Units of numbers.
pub mod units;

/// Keywords whose meaning does not depend on the block, for generated code.
#[doc(hidden)]
pub mod unique {
    pub use super::{body::*, hinge::*, kinds::*, settings::*, units::*};
}
