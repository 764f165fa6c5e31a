//! Inverse dynamics and its parts, and the products with the mass matrix.

use crate::samples::{Kind, Sample, changed_samples, dot, largest, samples, times};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::model::{Answer, Chain, Drive, Effort};
use mstmm_codegen::program::{Given::Accelerations, Given::Vector, OutputId};

/// Efforts are sums of at most some hundred terms, relative to the largest one.
const SUMS: f64 = 1e-12;
/// A product with `M⁻¹` loses as many digits as the condition number of `M` has, at most four here.
const SOLVED: f64 = 1e-11;

const ANSWERS: &str = "[inverse_dynamics, mass_matrix]";

const INVERSE: (Answer, OutputId) = (Answer::InverseDynamics, outputs::EFFORTS);
const BIAS: (Answer, OutputId) = (Answer::BiasEfforts, outputs::BIAS_EFFORTS);
const MASS: (Answer, OutputId) = (Answer::MassMatrixTimes, outputs::PRODUCT);
const INVERSE_MASS: (Answer, OutputId) = (Answer::InverseMassMatrixTimes, outputs::PRODUCT);
const FORWARD: (Answer, OutputId) = (Answer::Accelerations, outputs::ACCELERATIONS);

fn check(kind: Kind, seeds: std::ops::Range<u64>) {
    for sample in samples(kind, seeds, ANSWERS) {
        by_definition(&sample);
        products(&sample);
        if !sample.truth.closed() {
            undone(&sample);
        }
    }
}

#[test]
fn routes() {
    check(Kind::Route, 0..80);
    check(Kind::OpenRoute, 500..540);
}

#[test]
fn trees() {
    check(Kind::Tree, 1000..1060);
}

#[test]
fn parts_and_repeated_parts() {
    check(Kind::Described, 2000..2030);
}

#[test]
fn parameters() {
    check(Kind::Lifted, 3000..3030);
}

/// All efforts are those by virtual power in twice the precision.
fn by_definition(sample: &Sample) {
    let (given, accelerations) = (sample.given::<f64>(), sample.random_rates(0));
    let truth = sample.truth.answers(&sample.state, &sample.drives);
    let zero = vec![0.0; sample.rates()];
    let inverse = truth.inverse_dynamics(&accelerations);
    let scale = largest(&inverse);
    let gravity = (Answer::GravityEfforts, outputs::EFFORTS);
    let passive = (Answer::PassiveEfforts, outputs::EFFORTS);
    for (what, found, expected) in [
        (
            "inverse dynamics",
            sample.ask(&given, INVERSE, &[(Accelerations, &accelerations)]),
            inverse,
        ),
        ("bias efforts", sample.ask(&given, BIAS, &[]), truth.inverse_dynamics(&zero)),
        ("gravity efforts", sample.ask(&given, gravity, &[]), truth.gravity_efforts()),
        ("passive efforts", sample.ask(&given, passive, &[]), truth.passive_efforts()),
    ] {
        sample.check(what, (&found, &expected), scale.max(largest(&expected)), SUMS);
    }
}

/// `M x` and `M⁻¹ x` by the dense matrix, `ID(a) = M a + bias`, and `vᵀ M v = 2 T` if nothing is
/// prescribed.
fn products(sample: &Sample) {
    let (given, x) = (sample.given::<f64>(), sample.random_rates(1));
    let matrix = sample.truth.answers(&sample.state, &sample.drives).mass_matrix();
    let scale = largest(&matrix.concat());
    let product = sample.ask(&given, MASS, &[(Vector, &x)]);
    sample.check("M x", (&product, &times(&matrix, &x)), scale, SUMS);
    let bias = sample.ask(&given, BIAS, &[]);
    let inverse = sample.ask(&given, INVERSE, &[(Accelerations, &x)]);
    let sum: Vec<f64> = product.iter().zip(&bias).map(|(a, b)| a + b).collect();
    sample.check("M a + bias", (&sum, &inverse), scale.max(largest(&bias)), SUMS);
    if !sample.is_prescribed() && !sample.truth.closed() {
        let v = &sample.state.v;
        let energy = 0.5 * dot(v, &sample.ask(&given, MASS, &[(Vector, v)]));
        let energies = sample.ask(&given, (Answer::Energy, outputs::ENERGIES), &[]);
        sample.check("vᵀ M v / 2", (&[energy], &energies[..1]), largest(&energies[..1]), SUMS);
    }
    if sample.truth.closed() {
        return;
    }
    let back = sample.ask(&given, INVERSE_MASS, &[(Vector, &product)]);
    sample.check("M⁻¹ M x", (&back, &x), 1.0, SOLVED);
    let solved = sample.ask(&given, INVERSE_MASS, &[(Vector, &x)]);
    let forth = sample.ask(&given, MASS, &[(Vector, &solved)]);
    sample.check("M M⁻¹ x", (&forth, &x), largest(&solved) * scale, SOLVED);
    let y = sample.random_rates(2);
    let other = sample.ask(&given, INVERSE_MASS, &[(Vector, &y)]);
    let (one, two) = (dot(&y, &solved), dot(&x, &other));
    sample.check("yᵀ M⁻¹ x", (&[one], &[two]), largest(&solved), SOLVED);
}

/// Inverse dynamics undo forward dynamics: at the accelerations of the motors' efforts, the drives must
/// supply these efforts, and nothing at a floating base.
fn undone(sample: &Sample) {
    let given = sample.given::<f64>();
    let accelerations = sample.ask(&given, FORWARD, &[]);
    let efforts = sample.ask(&given, INVERSE, &[(Accelerations, &accelerations)]);
    let solution = sample.truth.solve_driven(&sample.state, &sample.drives);
    let own = sample.truth.hinges().zip(&solution.efforts).filter(|(hinge, _)| !hinge.prescribed);
    let base = vec![0.0; sample.truth.base_dof_count()];
    let motors: Vec<f64> =
        base.into_iter().chain(own.flat_map(|(_, efforts)| efforts.iter().copied())).collect();
    let mass = sample.truth.answers(&sample.state, &sample.drives).mass_matrix();
    let scale = largest(&mass.concat()) * largest(&accelerations);
    sample.check("ID(FD(τ))", (&efforts, &motors), scale, SOLVED);
    let difference: Vec<f64> =
        motors.iter().zip(sample.ask(&given, BIAS, &[])).map(|(t, b)| t - b).collect();
    let back = sample.ask(&given, INVERSE_MASS, &[(Vector, &difference)]);
    sample.check("M⁻¹ (τ − bias)", (&back, &accelerations), largest(&accelerations), SOLVED);
}

/// Returns the same chain with an input for the effort of every rate, floating bases included.
fn driven(mut chain: Chain) -> Chain {
    for hinge in chain.hinges.iter_mut().filter(|hinge| !hinge.is_prescribed()) {
        hinge.drive = Drive::Efforts(vec![Effort::Input; hinge.kind.dof_count()]);
    }
    chain
}

/// Forward dynamics undo inverse dynamics: the efforts for any accelerations cause these accelerations.
#[test]
fn efforts_of_accelerations_cause_them() {
    let kinds = [
        (Kind::OpenRoute, 500..520),
        (Kind::OpenTree, 1000..1010),
        (Kind::Described, 2000..2006),
        (Kind::Bare, 5000..5008),
    ];
    for (kind, seeds) in kinds {
        changed_samples(kind, seeds, "inverse_dynamics", driven)
            .for_each(|sample| returned(&sample));
    }
}

/// The error of the accelerations is the error of the efforts multiplied by `M⁻¹`, whose entries are at most some hundred.
/// So the tolerance is relative to the largest effort.
fn returned(sample: &Sample) {
    let (mut given, wanted) = (sample.given::<f64>(), sample.random_rates(5));
    let efforts = sample.ask(&given, INVERSE, &[(Accelerations, &wanted)]);
    given.drive(&sample.chain, &efforts);
    let found = sample.ask(&given, FORWARD, &[]);
    sample.check("FD(ID(a))", (&found, &wanted), largest(&efforts), SOLVED);
}
