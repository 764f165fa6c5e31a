//! The formats of states, inputs, parameters and points: tables, `serde`, `defmt`, `approx`.
//!
//! The implementations for generated types are in the macros of `generated::formats`.

#[cfg(feature = "approx")]
pub mod closeness;
mod labels;
mod listing;
#[cfg(feature = "defmt")]
mod log;
#[cfg(feature = "serde")]
pub mod maps;
mod point_tables;
mod table;

pub use listing::{Listing, ParameterRows};
