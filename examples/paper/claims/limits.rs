//! What the product of the printed matrices loses with length, and where it is singular.

mod by_length;
mod measure;
mod pose;
mod product;
mod rank;
mod right_angles;
mod truth;

use mstmm::Error;

use crate::output::progress::Progress;
use crate::section::Outcome;

/// Binary digits of the reference, 48 decimal ones.
const DIGITS: usize = 160;

/// How many parts the progress counts.
pub const MOTIONS: usize = by_length::MOTIONS + right_angles::MOTIONS;

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let mut outcome = by_length::run(progress)?;
    outcome.exhibits.push(right_angles::exhibit(progress)?);
    outcome.exhibits.push(rank::exhibit());
    Ok(outcome)
}
