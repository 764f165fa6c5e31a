#![doc = include_str!("../README.md")]
#![deny(missing_docs)]

mod csv;
mod encode;
mod layout;
mod mechanism;
mod mesh;
mod motion;
mod npz;
mod page;
mod picture;
mod recording;
mod rotation;

pub use layout::{Block, Column, Group, Options};
pub use mechanism::{Axis, Body, BodyPoint, Mechanism, Place, Spring, SpringEnd};
pub use motion::Motion;
pub use page::PageOptions;
pub use recording::Recording;
