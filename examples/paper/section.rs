//! The sections of the paper that the program computes, and the results of a section.

use clap::ValueEnum;

use crate::claims::{closed, integrators, limits, orientation, parallel};
use crate::compare::Comparison;
use crate::output::drawing::Drawing;
use crate::output::log_figure::LogFigure;
use crate::output::progress::Progress;
use crate::output::result_table::ResultTable;
use crate::output::time_figure::TimeFigure;
use crate::verdict::Verdict;
use crate::{compare, figure_8, section_4_1, section_4_2, section_4_3, section_4_4};

/// A section of the paper, or one of its claims.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub enum Section {
    /// Three cubes on ball-and-socket hinges
    #[value(name = "4.1")]
    BallHinges,
    /// Three cubes on pin hinges, for two choices of axes
    #[value(name = "4.2")]
    PinHinges,
    /// Pendulum: errors of single steps (Table 1), cost for 1 to 500 rods (Figure 8)
    #[value(name = "4.3")]
    Pendulum,
    /// Five masses in a row on springs
    #[value(name = "4.4")]
    Springs,
    /// Accuracy of the product of the printed matrices: by length, and for pins at right angles
    #[value(name = "limits")]
    Limits,
    /// Chains closed over the ground: a four-bar, and links between two balls
    #[value(name = "closed")]
    Closed,
    /// The overall product in parts that are computed in parallel
    #[value(name = "parallel")]
    Parallel,
    /// One chain with five integrators
    #[value(name = "integrators")]
    Integrators,
    /// A swing up to θ₂ = 89.98°, in Bryan angles and in quaternions
    #[value(name = "orientation")]
    Orientation,
}

/// The results of a section.
#[derive(Default)]
pub struct SectionResult {
    pub drawings: Vec<Drawing>,
    pub comparisons: Vec<Comparison>,
    pub tables: Vec<ResultTable>,
    pub figures: Vec<TimeFigure>,
    pub log_figures: Vec<LogFigure>,
    pub measurements: Vec<Measurement>,
}

/// A result that depends on the machine or is not bounded: it is reported and not judged.
pub struct Measurement {
    pub text: String,
    /// The file of the figure that shows it.
    pub figure: Option<&'static str>,
}

/// The results of a run, in the order of the sections.
pub type Results = Vec<(Section, SectionResult)>;

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

    /// The section's number in the paper, or the name of the claim on the command line.
    pub fn label(self) -> &'static str {
        match self {
            Section::BallHinges => "4.1",
            Section::PinHinges => "4.2",
            Section::Pendulum => "4.3",
            Section::Springs => "4.4",
            Section::Limits => "limits",
            Section::Closed => "closed",
            Section::Parallel => "parallel",
            Section::Integrators => "integrators",
            Section::Orientation => "orientation",
        }
    }

    pub fn title(self) -> &'static str {
        match self {
            Section::BallHinges => "Three cubes on ball-and-socket hinges",
            Section::PinHinges => "Three cubes on pin hinges, axes z z z (A) and z y z (B)",
            Section::Pendulum => "Pendulum of rods: errors of single steps, cost of an evaluation",
            Section::Springs => "Five masses in a row on springs",
            Section::Limits => "Accuracy of the product of the printed matrices",
            Section::Closed => "Closed chains are solved like open chains (claim)",
            Section::Parallel => "The overall product in parallel (claim)",
            Section::Integrators => "Any integrator can be used (claim)",
            Section::Orientation => "Bryan angles and quaternions near θ₂ = 90°",
        }
    }

    /// Describes the computation and its reference.
    pub fn about(self) -> &'static str {
        match self {
            Section::BallHinges => {
                "Three unit cubes of 1 kg fall from a straight, level row; the third cube rotates about y with \
                 0.1 rad/s. The motion over 5 s by generated code is compared with that of a Newton–Euler \
                 solver in absolute coordinates with Lagrange multipliers, the methods riccati and transfer \
                 with each other, and the accelerations at the start with their closed forms."
            }
            Section::PinHinges => {
                "The cubes of section 4.1 on pins; the second pin starts with 1 rad/s. The paper does not give \
                 the axes of the pins, so two systems are computed: A with the axes z, z, z, and B with the axes \
                 z, y, z. The comparisons are those of section 4.1."
            }
            Section::Pendulum => {
                "Table 1: the errors of three steps of 0.1 s of a rod on a pin, by the paper's method and by the \
                 original discrete-time method (MSDTTMM), compared with the published errors. Figure 8: the time \
                 for one evaluation of all accelerations of 1 to 500 rods, by generated code, by Lagrange's \
                 equations and by a recursion of order n; their accelerations are compared with each other."
            }
            Section::Springs => {
                "Five masses of 0.1 kg on springs of 1000 N/m; a force of 100 N pulls the first mass. Equation (48) \
                 of the paper does not give the unstressed length of the springs, so two readings are computed: \
                 zero, as printed, and 0.1 m. Positions by generated code and by the paper's matrices (47) and \
                 (52) are compared with the exact solution by modes."
            }
            Section::Limits => {
                "The accelerations of chains of 1 to 100 cubes by the product of the paper's matrices as printed, \
                 and by generated code, compared with a solution of the Newton–Euler equations with 160 binary \
                 digits; the pin matrix (43) near right angles; the rank of the overall equation (45)."
            }
            Section::Closed => {
                "Section 2.4 of the paper claims that closed chains can be handled like open chains. A four-bar is \
                 compared with its one equation of motion, and three spatial links between two balls are compared \
                 with the Newton–Euler equations, over 5 s. The time of closed chains is compared with that of \
                 open ones."
            }
            Section::Parallel => {
                "Section 2.4 of the paper claims that the overall transfer matrix can be computed in parallel. A \
                 pendulum of 10 to 100 000 rods is computed by two-ports, which can be joined in any grouping, \
                 serially and on several threads; times and accelerations are compared with generated code."
            }
            Section::Integrators => {
                "The paper's abstract claims that the method can be combined with any integrator. The cubes of \
                 section 4.1 with springs are integrated by the five integrators of the library. The fitted order \
                 of convergence is compared with the theoretical one, and the reference with Newton–Euler."
            }
            Section::Orientation => {
                "A cube on a ball swings up to θ₂ = 89.98°, where Bryan angles are nearly singular. Its orientation \
                 is kept in Bryan angles, as in the paper, and in quaternions, with the same integrator and steps \
                 of 20 ms to 5 µs. The results are compared with a Newton–Euler solver."
            }
        }
    }

    /// Whether the paper makes a claim without an example, or does not treat the subject.
    pub fn is_claim(self) -> bool {
        !matches!(
            self,
            Section::BallHinges | Section::PinHinges | Section::Pendulum | Section::Springs
        )
    }

    /// The number of motions that the section computes, for the progress bar.
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

    pub fn run(self, progress: &Progress) -> Result<SectionResult, mstmm::Error> {
        match self {
            Section::BallHinges => section_4_1::run(progress),
            Section::PinHinges => section_4_2::run(progress),
            Section::Pendulum => {
                let mut result = section_4_3::run(progress)?;
                result.extend(figure_8::run(progress)?);
                Ok(result)
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

impl SectionResult {
    pub fn extend(&mut self, other: SectionResult) {
        self.drawings.extend(other.drawings);
        self.comparisons.extend(other.comparisons);
        self.tables.extend(other.tables);
        self.figures.extend(other.figures);
        self.log_figures.extend(other.log_figures);
        self.measurements.extend(other.measurements);
    }

    pub fn verdicts(&self) -> impl Iterator<Item = &Verdict> {
        let comparisons = self.comparisons.iter().flat_map(|comparison| &comparison.verdicts);
        comparisons.chain(self.tables.iter().flat_map(|table| &table.verdicts))
    }
}

/// Describes each check of a run that fails.
pub fn complaints(results: &Results, tolerance: f64) -> Vec<String> {
    let verdicts = results
        .iter()
        .flat_map(|(section, result)| result.verdicts().map(|verdict| (section.label(), verdict)));
    verdicts
        .flat_map(|(label, verdict)| {
            let complaints = verdict.complaints(tolerance).into_iter();
            complaints.map(move |complaint| format!("{label}: {complaint}"))
        })
        .collect()
}
