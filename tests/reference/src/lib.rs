//! An independent reference solver for chains and trees of rigid bodies, and random ones to test with.
//!
//! The solver is deliberately simple. It uses six coordinates for every body, writes Newton's and
//! Euler's equations about every centre of mass, adds six equations for the relative motion at every
//! hinge, and solves the dense system by a pivoted LU factorisation, refined with residuals in twice
//! the precision. It shares no equation and no line of code with the library, so the two results are
//! independent.
//!
//! A chain is one route or a graph of routes: hinges join frames of any two bodies, or a body and the
//! ground or a moving frame.
//!
//! * [`Chain`] describes a chain; [`State`] and [`Drives`] are its state and inputs at one instant.
//! * [`Chain::solve_driven`] computes accelerations, efforts, internal loads and energies;
//!   [`Chain::solve`] does so if efforts are the only inputs.
//! * [`Chain::inverse_dynamics`], [`Chain::bias_efforts`] and [`Chain::mass_matrix`] compute the
//!   efforts for given accelerations.
//! * [`Chain::answers`] computes all of these, Jacobians, momenta, regressors and derivatives by their
//!   definitions, in twice the working precision.
//! * [`Chain::close`] finds states in which a closed chain fulfils its loop constraint.
//! * [`simulate()`] integrates the motions of the bodies instead of the hinge coordinates.
//! * [`random_chain()`], [`random_mechanism`], [`random_tree()`], [`random_described_tree`],
//!   [`random_state`], [`random_efforts`] and [`random_motion`] make repeatable test material.
//! * [`Chain::to_macro_text`] prints a chain in the description language of the project.
//!
//! All quantities are in SI units and angles in radians, except where a name says `degrees`.

mod answers;
mod assembly;
mod chain;
mod closure;
mod described;
#[path = "../../support/double_double.rs"]
mod double_double;
mod drives;
mod equations;
mod external_load;
mod extrapolation;
mod hinge;
mod inverse;
mod load;
mod mechanism;
mod moved;
mod passive;
mod paths;
mod placement;
mod random;
mod random_chain;
mod random_described;
mod random_forces;
mod random_state;
mod random_tree;
mod recipe;
mod relative;
mod rotation;
mod route;
mod saddle;
mod simulate;
mod solve;
mod strain;
mod text;
mod text_hinge;
mod written_out;

pub use answers::{Answers, Change, Momentum};
pub use chain::{About, Body, Chain, Dimension, Element, End, Frame, Gravity, State};
pub use drives::{Drives, FrameMotion, HingeMotion, LoadInput};
pub use hinge::{Axis, Group, Hinge, HingeKind, Limits, Source};
pub use load::{Axes, BodyPoint, Load, Spring, SpringEnd};
pub use random::Random;
pub use random_chain::{random_chain, random_mechanism};
pub use random_described::{Features, random_described_tree};
pub use random_state::{random_efforts, random_motion, random_state};
pub use random_tree::{TreeRecipe, random_tree};
pub use recipe::{Ends, HingeChoice, Recipe};
pub use route::{NamedPoint, Place, Route};
pub use simulate::{BodySample, Sample, simulate, simulate_driven};
pub use solve::{ElementPoints, HingeLoad, Point, Solution, SpringState};
