//! Chains closed over the ground, compared with independent solutions.
//!
//! "Closed-loop systems can be handled like chain systems" [P, section 2.4], but the paper has no example.
//! Two examples are computed here: a four-bar with one degree of freedom, compared with its one equation
//! of motion; and spatial links between two balls with nine degrees of freedom, compared with the
//! Newton–Euler equations.

mod between_balls;
mod comparison;
mod cost;
mod eksergian;
mod four_bar;

use mstmm::Error;

use crate::output::progress::Progress;
use crate::section::SectionResult;

/// The number of parts that the progress bar counts: both chains by both methods, and the cost of a loop.
pub const MOTIONS: usize = 4 + cost::LENGTHS;

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let mut result = four_bar::compare(progress)?.result();
    result.extend(between_balls::compare(progress)?.result());
    result.extend(cost::run(progress)?);
    Ok(result)
}
