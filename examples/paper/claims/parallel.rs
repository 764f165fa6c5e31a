//! The overall product in parts: the two-port form of a part is associative.

use mstmm::Error;

use crate::output::progress::Progress;
use crate::section::Outcome;

/// How many parts the progress counts.
pub const MOTIONS: usize = 0;

pub fn run(_progress: &Progress) -> Result<Outcome, Error> {
    Ok(Outcome::default())
}
