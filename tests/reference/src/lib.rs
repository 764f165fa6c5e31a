//! An independent truth for chains of rigid bodies, and random chains to test against it.
//!
//! The solver here is deliberately the most pedestrian one there is. It keeps six coordinates for
//! every body, writes Newton's and Euler's equations about every centre of mass, adds one row for
//! everything a hinge forbids, and hands the dense system to a pivoted LU factorisation. It shares
//! no equation and no line with the code it is compared with, so an agreement of the two means
//! something.
//!
//! * [`Chain`] describes a chain; [`Chain::solve`] gives accelerations, internal loads and energies
//!   at one instant.
//! * [`simulate()`] integrates the bodies' own motions, not the hinge coordinates.
//! * [`random_chain()`], [`random_state`] and [`random_efforts`] make repeatable test material.
//! * [`Chain::to_macro_text`] prints a chain in the description language of the project.
//!
//! All quantities are in SI units and angles in radians, except where a name says `degrees`.

mod chain;
mod extrapolation;
mod mechanism;
mod placement;
mod random;
mod random_chain;
mod rotation;
mod saddle;
mod simulate;
mod solve;
mod text;

pub use chain::{About, Body, Chain, Element, End, Frame, Hinge, HingeKind, State};
pub use random::Random;
pub use random_chain::{Ends, Joining, random_chain, random_efforts, random_state};
pub use simulate::{BodySample, Sample, simulate};
pub use solve::{Point, Solution};
