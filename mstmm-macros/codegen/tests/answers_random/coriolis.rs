//! The Coriolis matrix: against its definition in the reference, against the derivative of the mass matrix
//! along the motion, which is that of inverse dynamics, and against the velocity terms of the bias efforts.

use crate::differences::{Asked, Direction};
use crate::samples::{Kind, Sample, largest, samples, times};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::equations::hinge::coordinate_rates;
use mstmm_codegen::ids::InputId;
use mstmm_codegen::model::{Answer, InputKind, Layout};
use mstmm_codegen::program::{Argument, Given as Vector};

/// Entries are sums of at most some hundred terms, relative to the largest entry of the matrix or of its mass matrix. Rates are
/// at most some units.
const SUMS: f64 = 1e-12;

const ANSWERS: &str = "[coriolis_matrix, inverse_dynamics]";

#[test]
fn routes() {
    check(Kind::Route, 0..60);
    check(Kind::OpenRoute, 500..530);
}

#[test]
fn trees() {
    check(Kind::Tree, 1000..1040);
}

#[test]
fn parts_and_repeated_parts() {
    check(Kind::Described, 2000..2025);
}

#[test]
fn parameters() {
    check(Kind::Lifted, 3000..3020);
}

#[test]
fn moving_frames() {
    check(Kind::Carried, 4000..4020);
}

fn check(kind: Kind, seeds: std::ops::Range<u64>) {
    for sample in samples(kind, seeds, ANSWERS) {
        let rows = by_definition(&sample);
        along_the_motion(&sample, &rows);
    }
}

/// Returns the matrix of the reference by rows, after a comparison with the matrix, if the chain has it, and with
/// products.
fn by_definition(sample: &Sample) -> Vec<Vec<f64>> {
    let given = sample.given::<f64>();
    let answers = sample.truth.answers(&sample.state, &sample.drives);
    let truth = answers.coriolis_matrix();
    let scale = largest(&truth.concat()).max(largest(&answers.mass_matrix().concat()));
    if sample.compiled.find(Answer::CoriolisMatrix).is_some() {
        let found = sample.ask(&given, (Answer::CoriolisMatrix, outputs::MATRIX), &[]);
        let count = sample.rates();
        let expected: Vec<f64> = (0..count * count).map(|k| truth[k % count][k / count]).collect();
        sample.check("C", (&found, &expected), scale, SUMS);
    }
    let x = sample.random_rates(20);
    for vector in [&x, &sample.state.v] {
        let product = (Answer::CoriolisMatrixTimes, outputs::PRODUCT);
        let found = sample.ask(&given, product, &[(Vector::Vector, vector)]);
        sample.check("C x", (&found, &times(&truth, vector)), scale * largest(vector), SUMS);
    }
    truth
}

/// `Ṁ = C + Cᵀ`, also if ends move and hinges have a prescribed motion.
fn along_the_motion(sample: &Sample, matrix: &[Vec<f64>]) {
    let x = sample.random_rates(21);
    let transposed: Vec<Vec<f64>> =
        (0..matrix.len()).map(|k| matrix.iter().map(|row| row[k]).collect()).collect();
    let sum: Vec<f64> =
        times(matrix, &x).iter().zip(times(&transposed, &x)).map(|(a, b)| a + b).collect();
    // Inverse dynamics are M x and terms that do not depend on x.
    let zero = vec![0.0; x.len()];
    let [at_x, at_zero] = [&x, &zero].map(|accelerations| {
        let (answer, id) = (Answer::InverseDynamics, outputs::EFFORTS);
        let asked = Asked { answer, id, accelerations: Some(accelerations) };
        sample.difference(&asked, &along_motion(sample))
    });
    let expected: Vec<f64> = at_x.iter().zip(&at_zero).map(|(a, b)| a - b).collect();
    let scale = largest(&sum).max(largest(&at_x)).max(largest(&at_zero));
    sample.check("Ṁ x", (&sum, &expected), scale, SUMS);
}

/// Returns the direction along the motion of a chain: its rates, and those of prescribed hinges.
fn along_motion(sample: &Sample) -> Direction {
    let (layout, given) = (Layout::of(&sample.chain), sample.given::<f64>());
    let inputs = sample.joined_inputs(|id: InputId| {
        let input = &layout.inputs[id];
        let values = &given.arrays.arguments[&Argument::Input(id)];
        match input.what {
            InputKind::Motion(hinge) => {
                let kind = &sample.chain.hinges[hinge].kind;
                let count = input.range.len();
                let (coordinates, rates) = (kind.coordinates(), kind.dof_count());
                let of_one = |own: &[f64]| {
                    let mut change =
                        coordinate_rates(kind, &own[..coordinates], &own[coordinates..][..rates]);
                    change.resize(count, 0.0);
                    change
                };
                values.chunks(count.max(1)).flat_map(of_one).collect()
            }
            _ => vec![0.0; values.len()],
        }
    });
    Direction { coordinates: sample.state.v.clone(), inputs, ..sample.no_direction() }
}

/// `C v` are the bias efforts less those of gravity, if nothing but gravity and motors acts and nothing is prescribed.
#[test]
fn product_with_the_rates_is_in_the_bias_efforts() {
    for sample in samples(Kind::Bare, 5000..5060, ANSWERS) {
        let given = sample.given::<f64>();
        let product = (Answer::CoriolisMatrixTimes, outputs::PRODUCT);
        let found = sample.ask(&given, product, &[(Vector::Vector, &sample.state.v)]);
        let bias = sample.ask(&given, (Answer::BiasEfforts, outputs::BIAS_EFFORTS), &[]);
        let gravity = sample.ask(&given, (Answer::GravityEfforts, outputs::EFFORTS), &[]);
        let expected: Vec<f64> = bias.iter().zip(&gravity).map(|(b, g)| b - g).collect();
        sample.check("C v", (&found, &expected), largest(&bias).max(largest(&gravity)), SUMS);
    }
}
