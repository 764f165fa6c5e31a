//! Identities between the answers.

use super::chains::{Line, Plane, Space};
use super::sample::{Sample, directions, off, off_by};
use mstmm::Answers;
use mstmm::description::Answer;
use mstmm::prelude::*;
use nalgebra::{DMatrix, DVector};

/// Sums of some hundred terms of sizes up to a hundred, and solutions that lose three digits.
const ROUNDING: f64 = 1e-11;

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
    for seed in 0..6 {
        println!("seed {seed}");
        let mut sample = Sample::new(chain.clone(), seed);
        mass_matrix(&mut sample);
        coriolis_matrix(&mut sample);
        motors(&sample);
        regressor(&mut sample);
        derivatives(&mut sample);
        momentum(&sample);
    }
}

#[track_caller]
fn assert_small(off: f64, what: &str) {
    assert!(off < ROUNDING, "{what} is off by {off:e}");
}

/// M is symmetric, M M⁻¹ = 1, M v̇ + bias = ID(v̇), and the products are those of the matrices.
pub(super) fn mass_matrix<C: Answers<Scalar = f64> + Clone>(sample: &mut Sample<C>) {
    let x = sample.vector(1.0);
    let matrix = sample.matrix_of(Answer::MassMatrix, &[]);
    assert_small(off(&matrix.transpose(), &matrix), "the transpose of M");
    let times = sample.vector_of(Answer::MassMatrixTimes, x.as_slice());
    assert_small(off_by(&times, &(&matrix * &x)), "M x");
    let efforts = &matrix * &x + sample.vector_of(Answer::BiasEfforts, &[]);
    assert_small(off_by(&sample.inverse_dynamics(&x), &efforts), "ID");
    if C::has(Answer::InverseMassMatrix) {
        let inverse = sample.matrix_of(Answer::InverseMassMatrix, &[]);
        let one = DMatrix::identity(sample.count(), sample.count());
        assert_small(off(&(&matrix * &inverse), &one), "M M⁻¹");
        let times = sample.vector_of(Answer::InverseMassMatrixTimes, x.as_slice());
        assert_small(off_by(&times, &(&inverse * &x)), "M⁻¹ x");
    }
}

/// C x is the product with the matrix.
pub(super) fn coriolis_matrix<C: Answers<Scalar = f64> + Clone>(sample: &mut Sample<C>) {
    let x = sample.vector(1.0);
    let matrix = sample.matrix_of(Answer::CoriolisMatrix, &[]);
    let times = sample.vector_of(Answer::CoriolisMatrixTimes, x.as_slice());
    assert_small(off_by(&times, &(&matrix * &x)), "C x");
}

/// At the accelerations of forward dynamics inverse dynamics returns the efforts of the motors: a change of the effort of a
/// motor changes its entry by as much, other inputs change none.
fn motors<C: Answers<Scalar = f64> + Clone>(sample: &Sample<C>) {
    let undone = |sample: &Sample<C>| sample.inverse_dynamics(&sample.accelerations());
    let efforts = undone(sample);
    let mut expected = DVector::zeros(sample.count());
    for input in (0..sample.inputs.len()).filter(|&input| !sample.is_orientation(input)) {
        let change = (undone(&sample.with_input(input, 0.125)) - &efforts) * 8.0;
        let rate = change.iamax();
        let mut of_motor = DVector::zeros(sample.count());
        if change[rate].abs() > 0.5 {
            of_motor[rate] = 1.0;
            expected[rate] += sample.inputs[input];
        }
        let name = sample.input_name(input);
        // The difference of efforts is divided by an eighth.
        assert!(off_by(&change, &of_motor) < 8.0 * ROUNDING, "{name} changes {change}");
    }
    assert_small(off_by(&efforts, &expected), "ID(FD)");
}

/// The regressor times the parameters differs from inverse dynamics by efforts that do not depend on the accelerations.
pub(super) fn regressor<C: Answers<Scalar = f64> + Clone>(sample: &mut Sample<C>) {
    let [x, y] = [sample.vector(1.0), sample.vector(1.0)];
    let parameters = sample.vector_of(Answer::DynamicParameters, &[]);
    let efforts =
        |given: &DVector<f64>| sample.matrix_of(Answer::Regressor, given.as_slice()) * &parameters;
    let expected = sample.inverse_dynamics(&x) - sample.inverse_dynamics(&y);
    assert_small(off_by(&(efforts(&x) - efforts(&y)), &expected), "Y π");
}

/// Derivatives of forward dynamics are −M⁻¹ times those of inverse dynamics, and the products are those of the matrices.
fn derivatives<C: Answers<Scalar = f64> + Clone>(sample: &mut Sample<C>) {
    let accelerations = sample.accelerations();
    let linear = sample.parts_of(Answer::Linearize, &[]);
    let [found, inverse, by_coordinates, by_rates, by_inputs, by_parameters, ..] = &linear[..]
    else {
        panic!("eight parts")
    };
    let columns =
        |vector: &DVector<f64>| DMatrix::from_column_slice(vector.len(), 1, vector.as_slice());
    assert_small(off(found, &columns(&accelerations)), "accelerations");
    let of_inverse = sample.parts_of(Answer::InverseDynamicsDerivatives, accelerations.as_slice());
    assert_small(off(&-(inverse * &of_inverse[0]), by_coordinates), "by coordinates");
    assert_small(off(&-(inverse * &of_inverse[1]), by_rates), "by rates");
    let matrix = sample.matrix_of(Answer::MassMatrix, &[]);
    assert_small(off(&of_inverse[2], &matrix), "by accelerations");
    let all = [by_coordinates, by_rates, by_inputs, by_parameters];
    let direction =
        all.map(|matrix| DVector::from_fn(matrix.ncols(), |_, _| sample.random.between(-1.0, 1.0)));
    let terms = all.iter().zip(&direction).map(|(matrix, along)| *matrix * along);
    let expected = terms.fold(DVector::zeros(sample.count()), |sum, term| sum + term);
    let along = direction.each_ref().map(|along| along.as_slice()).concat();
    let pushed = sample.parts_of(Answer::Push, &along);
    assert_small(off(&pushed[1], &columns(&expected)), "push");
    let weights = sample.vector(1.0);
    let pulled = sample.answer(Answer::Pull, weights.as_slice());
    let gradient = DVector::from_column_slice(&pulled[sample.count()..]);
    let expected = weights.dot(&expected);
    let scale = 1.0 + gradient.amax();
    assert_small((gradient.dot(&DVector::from_vec(along)) - expected) / scale, "pull");
}

/// The momentum is linear in the rates, if prescribed motions are subtracted.
pub(super) fn momentum<C: Answers<Scalar = f64> + Clone>(sample: &Sample<C>) {
    let [translations, _] = directions(C::DESCRIPTION.dimension());
    let mut state = sample.state.clone();
    state.rates_mut().fill(0.0);
    let of = |sample: &Sample<C>| {
        let values = sample.answer(Answer::Momentum, &[]);
        DVector::from_column_slice(&values[1 + translations..])
    };
    let expected = sample.matrix_of(Answer::MomentumMatrix, &[])
        * DVector::from_column_slice(sample.state.rates());
    assert_small(off_by(&(of(sample) - of(&sample.at(state))), &expected), "momentum");
}
