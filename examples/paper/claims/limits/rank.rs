//! The number of unknowns that the paper's overall equation (45) determines.

use mstmm::paper::chain::{InputEnd, OutputEnd, boundary, overall};
use nalgebra::{DMatrix, Matrix3, SMatrix};

use super::pose::Pose;
use super::product::Product;
use crate::output::result_table::{ResultTable, Row};
use crate::verdict::{Bound, Check, Verdict};

/// Singular values below this fraction of the largest one are rounding errors: the product of three
/// bodies has a relative error of 1e-13.
const ROUNDING: f64 = 1e-10;

/// The unknowns of (45).
const UNKNOWNS: usize = 6;

/// The equations for the unknowns of a chain.
struct Boundary {
    name: &'static str,
    matrix: DMatrix<f64>,
    /// The rank by theory.
    rank: usize,
}

pub fn table() -> ResultTable {
    let (rows, checks): (Vec<Row>, Vec<Check>) =
        boundaries().iter().map(Boundary::row_and_check).unzip();
    ResultTable {
        section: "Limits",
        title: "equation (45) for three cubes, singular values over the largest one",
        columns: (1..=UNKNOWNS).map(|k| format!("σ{k}")).collect(),
        rows,
        note: "As printed, (45) starts outboard of the first hinge, with the six unknowns at the input of body 2. It determines \
               three of them for balls and five for pins: the condition of hinge 3 at body 2, which U₁ would \
               add, is missing. The product that starts at the ground, with U₁, determines all its unknowns.",
        verdicts: vec![Verdict {
            compared: "rank of equation (45) – theory, 4 cases".into(),
            figure: None,
            checks,
        }],
    }
}

/// Equation (45) as printed, and with U₁, in a state without symmetry.
fn boundaries() -> [Boundary; 4] {
    let free = OutputEnd::free();
    let balls = Product::<f64>::new(&Pose::of_balls(3, 0)).elements();
    let product = Product::<f64>::new(&Pose::of_pins([[0.0, 0.0, 1.0]; 3], 0));
    let (pins, frame) = (product.elements(), product.first_frame());
    let at_ground = InputEnd::pin(&frame.unwrap_or_else(Matrix3::identity));
    let of_balls = boundary(&overall(&balls[1..]), &InputEnd::outboard_of_ball(), &free).0;
    let of_all_balls = boundary(&overall(&balls), &InputEnd::ball(), &free).0;
    let of_pins = boundary(&overall(&pins[1..]), &InputEnd::outboard_of_pin(), &free).0;
    let of_all_pins = boundary(&overall(&pins), &at_ground, &free).0;
    [
        Boundary::new("balls, (45) as printed", &of_balls, 3),
        Boundary::new("balls, with U₁", &of_all_balls, 3),
        Boundary::new("parallel pins, (45) as printed", &of_pins, 5),
        Boundary::new("parallel pins, with U₁", &of_all_pins, 5),
    ]
}

impl Boundary {
    fn new<const M: usize, const K: usize>(
        name: &'static str,
        matrix: &SMatrix<f64, M, K>,
        rank: usize,
    ) -> Self {
        Boundary { name, matrix: DMatrix::from_column_slice(M, K, matrix.as_slice()), rank }
    }

    fn row_and_check(&self) -> (Row, Check) {
        let Boundary { name, matrix, rank: known } = self;
        let unknowns = matrix.ncols();
        let singular = matrix.singular_values();
        let mut values: Vec<f64> = singular.iter().map(|value| value / singular.max()).collect();
        values.sort_by(|a, b| b.total_cmp(a));
        let rank = values.iter().filter(|&&value| value > ROUNDING).count();
        let check = Check {
            what: format!("{name}: rank {rank}, by theory {known}"),
            size: rank.abs_diff(*known) as f64,
            unit: "",
            bound: Bound::Fixed(0.0),
        };
        values.resize(UNKNOWNS, f64::NAN);
        (Row { name: format!("{name}: rank {rank} of {unknowns}"), values }, check)
    }
}
