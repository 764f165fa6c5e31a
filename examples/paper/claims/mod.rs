//! The paper's claims beyond its examples, and the limits that it does not state, each with values.

pub mod closed;
pub mod integrators;
pub mod limits;
pub mod orientation;
pub mod parallel;
