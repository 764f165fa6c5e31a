//! The sections of the paper that the program knows, and what each one comes to.

use clap::ValueEnum;

use crate::claims::{closed, integrators, limits, orientation, parallel};
use crate::compare::Comparison;
use crate::output::exhibit::Exhibit;
use crate::output::log_plot::LogFigure;
use crate::output::plot::Figure;
use crate::output::progress::Progress;
use crate::{compare, figure_8, section_4_1, section_4_2, section_4_3, section_4_4};

/// A section of the paper.
#[derive(Clone, Copy, ValueEnum)]
pub enum Section {
    /// Three cubes on ball-and-socket hinges
    #[value(name = "4.1")]
    BallHinges,
    /// Three cubes on pin hinges, with two choices of axes
    #[value(name = "4.2")]
    PinHinges,
    /// Errors of single steps of a pendulum (Table 1), and what longer ones cost (Figure 8)
    #[value(name = "4.3")]
    Pendulum,
    /// Five masses in a row on springs
    #[value(name = "4.4")]
    Springs,
    /// How long, and for which hinges, the product of the printed matrices can be trusted
    #[value(name = "limits")]
    Limits,
    /// Chains closed over ground: a four-bar, and a spatial chain between two balls
    #[value(name = "closed")]
    Closed,
    /// The overall product in parts, in parallel
    #[value(name = "parallel")]
    Parallel,
    /// One chain under five integrators
    #[value(name = "integrators")]
    Integrators,
    /// An orientation through θ₂ = 89.98°, in Bryan angles and in quaternions
    #[value(name = "orientation")]
    Orientation,
}

/// What a section comes to.
#[derive(Default)]
pub struct Outcome {
    pub comparisons: Vec<Comparison>,
    pub exhibits: Vec<Exhibit>,
    pub figures: Vec<Figure>,
    pub log_figures: Vec<LogFigure>,
}

impl Section {
    pub const ALL: [Section; 9] = [
        Section::BallHinges,
        Section::PinHinges,
        Section::Pendulum,
        Section::Springs,
        Section::Limits,
        Section::Closed,
        Section::Parallel,
        Section::Integrators,
        Section::Orientation,
    ];

    /// How many motions it computes.
    pub fn motions(self) -> usize {
        match self {
            Section::BallHinges => compare::MOTIONS_PER_SYSTEM,
            Section::PinHinges => 2 * compare::MOTIONS_PER_SYSTEM,
            Section::Pendulum => 1 + figure_8::LENGTHS,
            Section::Springs => 2,
            Section::Limits => limits::MOTIONS,
            Section::Closed => closed::MOTIONS,
            Section::Parallel => parallel::MOTIONS,
            Section::Integrators => integrators::MOTIONS,
            Section::Orientation => orientation::MOTIONS,
        }
    }

    pub fn run(self, progress: &Progress) -> Result<Outcome, mstmm::Error> {
        match self {
            Section::BallHinges => section_4_1::run(progress),
            Section::PinHinges => section_4_2::run(progress),
            Section::Pendulum => {
                let mut outcome = section_4_3::run(progress)?;
                outcome.extend(figure_8::run(progress)?);
                Ok(outcome)
            }
            Section::Springs => section_4_4::run(progress),
            Section::Limits => limits::run(progress),
            Section::Closed => closed::run(progress),
            Section::Parallel => parallel::run(progress),
            Section::Integrators => integrators::run(progress),
            Section::Orientation => orientation::run(progress),
        }
    }
}

impl Outcome {
    pub fn extend(&mut self, other: Outcome) {
        self.comparisons.extend(other.comparisons);
        self.exhibits.extend(other.exhibits);
        self.figures.extend(other.figures);
        self.log_figures.extend(other.log_figures);
    }

    /// What does not come out as it must.
    pub fn complaints(&self, tolerance: f64) -> Vec<String> {
        let comparisons = self.comparisons.iter().flat_map(|one| one.complaints(tolerance));
        comparisons.chain(self.exhibits.iter().flat_map(|one| one.complaints(tolerance))).collect()
    }
}
