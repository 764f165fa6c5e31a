//! An independent truth for chains of rigid bodies, and random chains to test against it.
//!
//! The solver here is deliberately the most pedestrian one there is. It keeps six coordinates for
//! every body, writes Newton's and Euler's equations about every centre of mass, adds for every hinge
//! the six equations that say how its two sides move relative to each other, and hands the dense
//! system to a pivoted LU factorisation. It shares no equation and no line with the code it is
//! compared with, so an agreement of the two means something.
//!
//! * [`Chain`] describes a chain, [`State`] and [`Drives`] what it is given at one instant.
//! * [`Chain::solve_driven`] gives accelerations, efforts, internal loads and energies at one
//!   instant; [`Chain::solve`] does where only efforts are given.
//! * [`Chain::inverse_dynamics`], [`Chain::bias_efforts`] and [`Chain::mass_matrix`] give the efforts
//!   that accelerations need.
//! * [`Chain::close`] finds states in which a closed chain closes.
//! * [`simulate()`] integrates the bodies' own motions, not the hinge coordinates.
//! * [`random_chain()`], [`random_mechanism`], [`random_state`], [`random_efforts`] and
//!   [`random_motion`] make repeatable test material.
//! * [`Chain::to_macro_text`] prints a chain in the description language of the project.
//!
//! All quantities are in SI units and angles in radians, except where a name says `degrees`.

mod chain;
mod closure;
mod drives;
mod equations;
mod extrapolation;
mod hinge;
mod inverse;
mod load;
mod mechanism;
mod moved;
mod outside;
mod passive;
mod placement;
mod random;
mod random_acting;
mod random_chain;
mod random_state;
mod recipe;
mod relative;
mod rotation;
mod saddle;
mod simulate;
mod solve;
mod strain;
mod text;
mod text_hinge;

pub use chain::{About, Body, Chain, Dimension, Element, End, Frame, Gravity, State};
pub use drives::{Drives, FrameMotion, HingeMotion, LoadInput};
pub use hinge::{Axis, Group, Hinge, HingeKind, Limits, Source};
pub use load::{Axes, Load, Spot, Spring};
pub use random::Random;
pub use random_chain::{random_chain, random_mechanism};
pub use random_state::{random_efforts, random_motion, random_state};
pub use recipe::{Ends, Joining, Recipe};
pub use simulate::{BodySample, Sample, simulate, simulate_driven};
pub use solve::{Point, Solution};
