//! The sections of the paper that the program knows, and what each one comes to.

use clap::ValueEnum;

use crate::compare::Comparison;
use crate::plot::Figure;
use crate::progress::Progress;
use crate::{section_4_1, section_4_2};

/// A section of the paper.
#[derive(Clone, Copy, ValueEnum)]
pub enum Section {
    /// Three cubes on ball-and-socket hinges
    #[value(name = "4.1")]
    BallHinges,
    /// Three cubes on pin hinges, with two choices of axes
    #[value(name = "4.2")]
    PinHinges,
}

/// What a section comes to.
#[derive(Default)]
pub struct Outcome {
    pub comparisons: Vec<Comparison>,
    pub figures: Vec<Figure>,
}

impl Section {
    pub const ALL: [Section; 2] = [Section::BallHinges, Section::PinHinges];

    /// How many systems it compares.
    pub fn systems(self) -> usize {
        match self {
            Section::BallHinges => 1,
            Section::PinHinges => 2,
        }
    }

    pub fn run(self, progress: &Progress) -> Result<Outcome, mstmm::Error> {
        match self {
            Section::BallHinges => section_4_1::run(progress),
            Section::PinHinges => section_4_2::run(progress),
        }
    }
}

impl Outcome {
    pub fn extend(&mut self, other: Outcome) {
        self.comparisons.extend(other.comparisons);
        self.figures.extend(other.figures);
    }
}
