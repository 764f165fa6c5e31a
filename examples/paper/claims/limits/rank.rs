//! How many of its unknowns the paper's overall equation (45) determines.

use mstmm::paper::chain::{InputEnd, OutputEnd, boundary, overall};
use nalgebra::{DMatrix, Matrix3, SMatrix};

use super::pose::Pose;
use super::product::Product;
use crate::output::exhibit::{Exhibit, Row};

/// Singular values below this, relative to the largest one, are rounding: the product of three bodies
/// is off by 1e-13 of its largest entries.
const ROUNDING: f64 = 1e-10;

/// The unknowns of (45).
const UNKNOWNS: usize = 6;

/// The equations for the unknowns of a chain.
struct Boundary {
    name: &'static str,
    matrix: DMatrix<f64>,
    /// The rank that theory gives it.
    rank: usize,
}

pub fn exhibit() -> Exhibit {
    let all = boundaries();
    let (rows, faults): (Vec<Row>, Vec<Option<String>>) =
        all.iter().map(Boundary::row_and_fault).unzip();
    Exhibit {
        section: "Limits",
        title: "equation (45) for three cubes, singular values over the largest one",
        columns: (1..=UNKNOWNS).map(|k| format!("σ{k}")).collect(),
        rows,
        says: vec![
            "As printed, (45) begins behind the first hinge, at z_{2,I} with six unknowns. It determines three",
            "of them for balls and five for pins: the condition of hinge 3 at body 2, which U₁ would bring in, is",
            "missing. The product that begins at the ground, with U₁, determines all of its unknowns.",
        ],
        differences: Vec::new(),
        faults: faults.into_iter().flatten().collect(),
    }
}

/// (45) as printed, and with U₁, in a state like any other.
fn boundaries() -> [Boundary; 4] {
    let free = OutputEnd::free();
    let balls = Product::<f64>::new(&Pose::of_balls(3, 0)).elements();
    let product = Product::<f64>::new(&Pose::of_pins([[0.0, 0.0, 1.0]; 3], 0));
    let (pins, frame) = (product.elements(), product.first_frame());
    let at_ground = InputEnd::pin(&frame.unwrap_or_else(Matrix3::identity));
    let of_balls = boundary(&overall(&balls[1..]), &InputEnd::behind_ball(), &free).0;
    let of_all_balls = boundary(&overall(&balls), &InputEnd::ball(), &free).0;
    let of_pins = boundary(&overall(&pins[1..]), &InputEnd::behind_pin(), &free).0;
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

    fn row_and_fault(&self) -> (Row, Option<String>) {
        let Boundary { name, matrix, rank: known } = self;
        let unknowns = matrix.ncols();
        let singular = matrix.singular_values();
        let mut values: Vec<f64> = singular.iter().map(|value| value / singular.max()).collect();
        values.sort_by(|a, b| b.total_cmp(a));
        let rank = values.iter().filter(|&&value| value > ROUNDING).count();
        let fault = (rank != *known).then(|| format!("{name}: rank {rank}, not {known}"));
        values.resize(UNKNOWNS, f64::NAN);
        (Row { name: format!("{name}: rank {rank} of {unknowns}"), values }, fault)
    }
}
