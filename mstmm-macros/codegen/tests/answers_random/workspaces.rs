//! The workspace of inverse dynamics.

use crate::common::points::{OfElement, element_points};
use crate::samples::{Kind, Sample, largest, samples};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::model::Answer;
use mstmm_codegen::program::Given::Accelerations;

/// The accelerations lose as many digits as the condition number of the mass matrix has, at most four here.
const SOLVED: f64 = 1e-11;

/// At the accelerations of forward dynamics, the workspace of inverse dynamics is that of forward
/// dynamics.
fn check(sample: &Sample) {
    let given = sample.given::<f64>();
    let forward = sample.all(&given, Answer::Solution, &[]);
    let accelerations = forward.result(outputs::ACCELERATIONS);
    let vectors: [(_, &[f64]); 1] = [(Accelerations, &accelerations)];
    let inverse = sample.all(&given, Answer::InverseSolution, &vectors);
    let matrix = sample.truth.answers(&sample.state, &sample.drives).mass_matrix();
    let stiff = largest(&matrix.concat()) * largest(&accelerations);
    for (&id, _) in forward.results.iter() {
        if [outputs::UNDETERMINED, outputs::POINT_NUMBERS].contains(&id) {
            continue;
        }
        let (found, expected) = (inverse.result(id), forward.result(id));
        let scale = largest(&expected).max(stiff);
        sample.check(id.name, (&found, &expected), scale, SOLVED);
    }
    let points = |arrays| -> Vec<f64> {
        let elements = element_points(&sample.chain, &sample.compiled, arrays);
        let of_element = |it: OfElement<f64>| [it.input, it.output].concat();
        elements.into_iter().flat_map(of_element).collect()
    };
    let (found, expected) = (points(&inverse), points(&forward));
    sample.check("points", (&found, &expected), largest(&expected).max(stiff), SOLVED);
}

#[test]
fn open_routes() {
    samples(Kind::OpenRoute, 0..60, "inverse_dynamics").for_each(|sample| check(&sample));
}

#[test]
fn parameters() {
    samples(Kind::Lifted, 3000..3020, "inverse_dynamics").for_each(|sample| check(&sample));
}

#[test]
fn trees_with_repeated_parts() {
    samples(Kind::Described, 2000..2060, "inverse_dynamics").for_each(|sample| check(&sample));
}
