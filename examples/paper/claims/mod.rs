//! What the paper claims beyond its examples, and what it does not say, each with numbers.

pub mod closed;
pub mod integrators;
pub mod limits;
pub mod orientation;
pub mod parallel;
