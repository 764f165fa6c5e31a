//! Chains closed over ground, beside an independent solution.
//!
//! "Closed-loop systems can be handled like chain systems" [P, section 2.4], but the paper shows none.
//! Here are two: a four-bar, which has one freedom, beside its one equation of motion; and links in
//! space between two balls, with nine freedoms, beside Newton's and Euler's equations.

mod beside;
mod between_balls;
mod cost;
mod eksergian;
mod four_bar;

use mstmm::Error;

use crate::output::progress::Progress;
use crate::section::Outcome;

/// How many parts the progress counts: both chains by both ways, and what a closure costs.
pub const MOTIONS: usize = 4 + cost::LENGTHS;

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let mut outcome = four_bar::beside(progress)?.outcome();
    outcome.extend(between_balls::beside(progress)?.outcome());
    outcome.exhibits.push(cost::exhibit(progress)?);
    Ok(outcome)
}
