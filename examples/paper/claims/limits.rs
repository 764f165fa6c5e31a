//! The accuracy of the product of the printed matrices: by length, and for pins at right angles.

mod by_length;
mod errors;
mod pose;
mod product;
mod rank;
mod reference;
mod right_angles;

use mstmm::Error;

use crate::output::progress::Progress;
use crate::section::SectionResult;

/// The binary digits of the reference solution (48 decimal digits).
const DIGITS: usize = 160;

/// The number of parts that the progress bar counts.
pub const MOTIONS: usize = by_length::MOTIONS + right_angles::MOTIONS;

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let mut result = by_length::run(progress)?;
    result.tables.push(right_angles::table(progress)?);
    result.tables.push(rank::table());
    Ok(result)
}
