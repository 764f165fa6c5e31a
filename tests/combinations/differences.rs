//! Derivatives and Jacobians by central differences.

use super::chains::{Line, Plane, Space};
use super::sample::{Sample, directions, off_by};
use mstmm::Answers;
use mstmm::description::Answer;
use mstmm::prelude::*;
use nalgebra::{DMatrix, DVector};

/// The step of central differences. Their error is h² times a third derivative of up to 100, and the rounding of values of
/// up to 100 divided by h, each about 1e-8.
const H: f64 = 1e-5;
const TOLERANCE: f64 = 1e-7;

#[test]
fn in_space() {
    check(&Space::<f64>::new());
}

#[test]
fn in_a_plane() {
    check(&Plane::<f64>::new());
}

#[test]
fn on_a_line() {
    check(&Line::<f64>::new());
}

fn check<C: Answers<Scalar = f64> + Clone>(chain: &C) {
    for seed in 0..2 {
        println!("seed {seed}");
        let sample = Sample::new(chain.clone(), seed);
        linearization(&sample);
        jacobians(&sample);
    }
}

fn unit(count: usize, index: usize) -> DVector<f64> {
    DVector::from_fn(count, |row, _| if row == index { 1.0 } else { 0.0 })
}

/// Returns the central difference of a function at zero.
fn difference(of: impl Fn(f64) -> DVector<f64>) -> DVector<f64> {
    (of(H) - of(-H)) / (2.0 * H)
}

fn linearization<C: Answers<Scalar = f64> + Clone>(sample: &Sample<C>) {
    let parts = sample.parts_of(Answer::Linearize, &[]);
    let compare = |part: &DMatrix<f64>, index: usize, found: DVector<f64>, what: &str| {
        let off = off_by(&found, &part.column(index).into_owned());
        assert!(off < TOLERANCE, "column {index} by {what} is off by {off:e}");
    };
    for index in 0..sample.count() {
        let along = unit(sample.count(), index);
        let found = difference(|h| sample.at(sample.moved(&along, h)).accelerations());
        compare(&parts[2], index, found, "coordinates");
        let found = difference(|h| {
            let mut state = sample.state.clone();
            state.rates_mut()[index] += h;
            sample.at(state).accelerations()
        });
        compare(&parts[3], index, found, "rates");
    }
    for index in (0..sample.inputs.len()).filter(|&index| !sample.is_orientation(index)) {
        let found = difference(|h| sample.with_input(index, h).accelerations());
        compare(&parts[4], index, found, "inputs");
    }
    for index in 0..C::DESCRIPTION.parameters().len() {
        let value = sample.chain.parameter(index).expect("a parameter");
        let found = difference(|h| {
            let mut changed = sample.at(sample.state.clone());
            changed.chain.set_parameter(index, value + h).expect("a physical value");
            changed.accelerations()
        });
        compare(&parts[5], index, found, "parameters");
    }
}

/// The columns of the Jacobian of each frame are derivatives of its position, and J v is its velocity, if prescribed
/// motions are subtracted.
pub(super) fn jacobians<C: Answers<Scalar = f64> + Clone>(sample: &Sample<C>) {
    let [translations, rotations] = directions(C::DESCRIPTION.dimension());
    let inputs = sample.typed_inputs();
    let rates = DVector::from_column_slice(sample.state.rates());
    let mut at_rest = sample.state.clone();
    at_rest.rates_mut().fill(0.0);
    for body in 0..C::DESCRIPTION.bodies().len() {
        for name in C::frames(body) {
            let frame = C::frame(body, name).expect("a frame");
            let motion = |state: &C::State, jacobian: &mut [f64]| {
                let found = sample.chain.motion(state, &inputs, frame, jacobian);
                found.expect("kinematics").expect("finite numbers")
            };
            let mut entries = vec![0.0; (translations + rotations) * sample.count()];
            let found = motion(&sample.state, &mut entries);
            let jacobian = DMatrix::from_vec(translations + rotations, sample.count(), entries);
            let linear = jacobian.rows(0, translations);
            let vector = |values: [f64; 3]| DVector::from_column_slice(&values[..translations]);
            for index in 0..sample.count() {
                let along = unit(sample.count(), index);
                let position = |h: f64| vector(motion(&sample.moved(&along, h), &mut []).position);
                let off = off_by(&difference(position), &linear.column(index).into_owned());
                assert!(off < TOLERANCE, "column {index} of {name} of body {body}: {off:e}");
            }
            let velocity = vector(found.velocity) - vector(motion(&at_rest, &mut []).velocity);
            let off = off_by(&velocity, &(linear * &rates));
            assert!(off < 1e-12, "velocity of {name} of body {body}: {off:e}");
        }
    }
}
