//! Virtual work: the efforts `Jᵀ f` of a force or a torque on a body are those by which a load with this value changes
//! inverse dynamics, and they accelerate the chain as the load does.

use crate::Moving;
use crate::common::given::Given;
use crate::common::numbers;
use crate::points::{Asked, bodies};
use crate::samples::{Kind, Sample, largest, samples};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::ids::{InputId, LoadId};
use mstmm_codegen::model::{Answer, InputKind, Layout, LoadAxes, Value};
use mstmm_codegen::program::{Argument, Given as Vector};

/// Efforts are sums of at most some hundred terms, relative to the largest one.
const SUMS: f64 = 1e-12;
/// Accelerations lose as many digits as the condition number of the mass matrix has, at most four here.
const SOLVED: f64 = 1e-11;

const ANSWERS: &str = "[jacobian, inverse_dynamics, mass_matrix]";

/// Returns the products of the transposed Jacobians with the forces or torques of an input, in all its repetitions.
fn efforts_of_load(moving: &Moving, (load, is_force): (LoadId, bool), values: &[f64]) -> Vec<f64> {
    let Moving { sample, .. } = moving;
    let (chain, numbers) = (&sample.chain, numbers::<f64>(&sample.chain));
    let number = |value: &Value| numbers.scalar(value).value();
    let (translations, rotations) = (chain.dimension.translations(), chain.dimension.rotations());
    let load = &chain.loads[load];
    let place: Vec<f64> = translations.iter().map(|&k| number(&load.at.position[k])).collect();
    let axes = if is_force { translations } else { rotations };
    let mut sum = vec![0.0; sample.rates()];
    for at in bodies(chain).iter().filter(|at| at.body == load.body) {
        let mut vector = [0.0; 3];
        let own = values[axes.len() * at.repetition..].iter();
        axes.iter().zip(own).for_each(|(&axis, value)| vector[axis] = *value);
        if load.axes == LoadAxes::Body {
            let of_body = load.at.rotation.each_ref().map(|row| row.each_ref().map(number));
            let seen = moving.see(at, place.clone(), &Asked::default());
            vector = rotated(&matrix(&seen.orientation), rotated(&of_body, vector));
        }
        let before = if is_force { 0 } else { translations.len() };
        let entries = axes.iter().map(|&axis| vector[axis]);
        let wrench = vec![0.0; before].into_iter().chain(entries).collect();
        let asked = Asked { wrench, ..Asked::default() };
        let efforts = moving.see(at, place.clone(), &asked).transpose_times_wrench;
        sum.iter_mut().zip(efforts).for_each(|(sum, effort)| *sum += effort);
    }
    sum
}

/// Returns the rotation matrix of an orientation: a matrix by columns in space, cosine and sine in a plane.
fn matrix(orientation: &[f64]) -> [[f64; 3]; 3] {
    match *orientation {
        [cosine, sine] => [[cosine, -sine, 0.0], [sine, cosine, 0.0], [0.0, 0.0, 1.0]],
        [] => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        _ => [0, 1, 2].map(|row| [0, 1, 2].map(|column| orientation[3 * column + row])),
    }
}

fn rotated(matrix: &[[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| (0..3).map(|k| row[k] * vector[k]).sum())
}

/// Returns the arguments with an input of zero.
fn without<'a>(sample: &'a Sample, input: InputId) -> Given<'a, f64> {
    let mut given = sample.given::<f64>();
    let values = given.arrays.arguments.get_mut(&Argument::Input(input)).expect("its values");
    values.fill(0.0);
    given
}

/// Checks every load that is an input, and returns the number of loads that change efforts.
fn virtual_work(sample: &Sample) -> usize {
    let (with, a) = (sample.given::<f64>(), sample.random_rates(30));
    let moving = Moving::new(sample, None);
    let mut loads = 0;
    for (id, input) in Layout::of(&sample.chain).inputs.enumerate() {
        let (load, is_force) = match input.what {
            InputKind::Force(load) => (load, true),
            InputKind::Torque(load) => (load, false),
            _ => continue,
        };
        let values = &with.arrays.arguments[&Argument::Input(id)];
        let found = efforts_of_load(&moving, (load, is_force), values);
        let name = sample.chain.loads[load].name.to_string();
        // Drives supply what the load does not.
        let inverse = (Answer::InverseDynamics, outputs::EFFORTS);
        let vectors: [(Vector, &[f64]); 1] = [(Vector::Accelerations, &a)];
        let [loaded, unloaded] =
            [&with, &without(sample, id)].map(|given| sample.ask(given, inverse, &vectors));
        let expected: Vec<f64> = unloaded.iter().zip(&loaded).map(|(a, b)| a - b).collect();
        let scale = largest(&unloaded).max(largest(&found));
        sample.check(&format!("Jᵀ f of {name}"), (&found, &expected), scale, SUMS);
        loads += usize::from(expected.iter().any(|effort| effort.abs() > 1e-3));
        if sample.truth.closed() {
            continue;
        }
        let forward = (Answer::Accelerations, outputs::ACCELERATIONS);
        let [loaded, unloaded] =
            [&with, &without(sample, id)].map(|given| sample.ask(given, forward, &[]));
        let expected: Vec<f64> = loaded.iter().zip(&unloaded).map(|(a, b)| a - b).collect();
        let product = (Answer::InverseMassMatrixTimes, outputs::PRODUCT);
        let moved = sample.ask(&with, product, &[(Vector::Vector, &found)]);
        let scale = largest(&loaded).max(largest(&unloaded));
        sample.check(&format!("M⁻¹ Jᵀ f of {name}"), (&moved, &expected), scale, SOLVED);
    }
    loads
}

#[test]
fn loads_do_the_work_of_their_jacobians() {
    let kinds = [
        (Kind::Route, 0..24),
        (Kind::Tree, 1000..1010),
        (Kind::Described, 2000..2008),
        (Kind::Lifted, 3000..3008),
    ];
    let of_kind = |(kind, seeds)| -> usize {
        samples(kind, seeds, ANSWERS).map(|sample| virtual_work(&sample)).sum()
    };
    let loads: usize = kinds.map(of_kind).into_iter().sum();
    assert!(loads > 25, "{loads} loads");
}
