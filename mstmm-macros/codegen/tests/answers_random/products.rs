//! The derivative of the accelerations along a direction.

use crate::common::drives;
use crate::common::given::Given;
use crate::differences::{Asked, Direction};
use crate::samples::{Kind, Sample, dot, largest, samples};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::model::{Answer, InputKind, Layout};
use mstmm_codegen::program::{Argument, Given as Vector};
use mstmm_reference::{Change, Drives, LoadInput, Random};

/// The tolerance relative to the largest entry of the derivative and of the accelerations. Both lose as many
/// digits as the condition number of the mass matrix has, at most four here.
const TOLERANCE: f64 = 1e-11;

fn check(kind: Kind, seeds: std::ops::Range<u64>) {
    for sample in samples(kind, seeds, "push") {
        pushed_along(&sample);
        linear(&sample);
        by_definition(&sample);
    }
}

#[test]
fn routes() {
    check(Kind::OpenRoute, 0..60);
}

#[test]
fn trees() {
    check(Kind::OpenTree, 1000..1040);
}

#[test]
fn parts_and_repeated_parts() {
    check(Kind::Described, 2000..2020);
}

#[test]
fn parameters() {
    check(Kind::Lifted, 3000..3030);
}

/// Returns a random direction. Parameters change by a fraction of themselves.
pub fn random_direction(sample: &Sample, number: u64) -> Direction {
    let mut random = Random::new(77_000_000 + 1000 * sample.seed + number);
    let mut direction = sample.no_direction();
    let all = [&mut direction.coordinates, &mut direction.rates, &mut direction.inputs];
    all.into_iter().flatten().for_each(|entry| *entry = random.between(-1.0, 1.0));
    let parameters = crate::common::numbers::<f64>(&sample.chain).parameters;
    for (entry, parameter) in direction.parameters.iter_mut().zip(parameters) {
        *entry = parameter.value() * random.between(-0.5, 0.5);
    }
    keep_lengths(sample, &mut direction.inputs);
    direction
}

/// Removes the changes of prescribed quaternions that would change their lengths.
pub fn keep_lengths(sample: &Sample, direction: &mut Vec<f64>) {
    let given = sample.given::<f64>();
    let layout = Layout::of(&sample.chain);
    *direction = sample.joined_inputs(|id| {
        let mut own = sample.own_input(direction, id);
        let InputKind::Motion(hinge) = layout.inputs[id].what else { return own };
        let kind = &sample.chain.hinges[hinge].kind;
        let (coordinates, rates) = (kind.coordinates(), kind.dof_count());
        if coordinates > rates {
            let values = &given.arrays.arguments[&Argument::Input(id)];
            let count = coordinates + 2 * rates;
            for (own, values) in own.chunks_mut(count).zip(values.chunks(count)) {
                let range = coordinates - 4..coordinates;
                let (own, unit) = (&mut own[range.clone()], &values[range]);
                let along = dot(own, unit);
                own.iter_mut().zip(unit).for_each(|(own, unit)| *own -= along * unit);
            }
        }
        own
    });
}

/// Returns the accelerations and their derivative.
pub fn push(sample: &Sample, given: &Given<f64>, direction: &Direction) -> [Vec<f64>; 2] {
    let vectors: [(Vector, &[f64]); 4] = [
        (Vector::CoordinateDirection, &direction.coordinates),
        (Vector::RateDirection, &direction.rates),
        (Vector::InputDirection, &direction.inputs),
        (Vector::ParameterDirection, &direction.parameters),
    ];
    let results = sample.all(given, Answer::Push, &vectors);
    [outputs::ACCELERATIONS, outputs::CHANGE].map(|id| results.result(id))
}

/// Accelerations and derivative are those of the function for accelerations.
fn pushed_along(sample: &Sample) {
    let (answer, id) = (Answer::Accelerations, outputs::ACCELERATIONS);
    let accelerations = sample.ask(&sample.given::<f64>(), (answer, id), &[]);
    let all = random_direction(sample, 0);
    let none = sample.no_direction();
    let one_by_one = [
        ("coordinates", Direction { coordinates: all.coordinates.clone(), ..none.clone() }),
        ("rates", Direction { rates: all.rates.clone(), ..none.clone() }),
        ("inputs", Direction { inputs: all.inputs.clone(), ..none.clone() }),
        ("parameters", Direction { parameters: all.parameters.clone(), ..none }),
        ("everything", all),
    ];
    for (what, direction) in one_by_one {
        let [found, change] = push(sample, &sample.given(), &direction);
        let scale = largest(&accelerations);
        sample.check("accelerations", (&found, &accelerations), scale, TOLERANCE);
        let asked = Asked { answer, id, accelerations: None };
        let expected = sample.difference(&asked, &direction);
        let scale = scale.max(largest(&expected));
        sample.check(what, (&change, &expected), scale, TOLERANCE);
    }
}

/// The derivative is linear in the direction.
fn linear(sample: &Sample) {
    let [one, two] = [1, 2].map(|number| random_direction(sample, number));
    let sum = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| 2.0 * a - b).collect::<Vec<_>>();
    let both = Direction {
        coordinates: sum(&one.coordinates, &two.coordinates),
        rates: sum(&one.rates, &two.rates),
        inputs: sum(&one.inputs, &two.inputs),
        parameters: sum(&one.parameters, &two.parameters),
        ..one.clone()
    };
    let [[_, one], [_, two], [_, both]] =
        [one, two, both].map(|it| push(sample, &sample.given(), &it));
    let scale = largest(&one).max(largest(&two));
    sample.check("linear", (&both, &sum(&one, &two)), scale, TOLERANCE);
}

/// The derivative is that by the definition of the reference, along everything except prescribed motions.
fn by_definition(sample: &Sample) {
    let mut random = Random::new(88_000_000 + sample.seed);
    let mut list = |count: usize| (0..count).map(|_| random.between(-1.0, 1.0)).collect::<Vec<_>>();
    let truth = sample.truth.answers(&sample.state, &sample.drives);
    let vector = |values: Vec<f64>| [values[0], values[1], values[2]];
    let none = truth.no_change();
    let change = Change {
        coordinates: list(sample.rates()),
        rates: list(sample.rates()),
        efforts: list(sample.rates()),
        gravity: vector(list(3)),
        loads: none
            .loads
            .iter()
            .map(|_| LoadInput { force: vector(list(3)), torque: vector(list(3)) })
            .collect(),
        actuators: list(none.actuators.len()),
        ..none
    };
    // Inputs are linear in all drives except motions.
    let drives = Drives {
        efforts: change.efforts.clone(),
        loads: change.loads.clone(),
        springs: change.actuators.clone(),
        gravity: change.gravity,
        ..sample.drives.clone()
    };
    let state = (&sample.state, &drives);
    let arguments = drives::arguments(&sample.chain, &sample.compiled, &sample.truth, state);
    let layout = Layout::of(&sample.chain);
    let inputs = sample.joined_inputs(|id| {
        let found = arguments.iter().find(|(argument, _)| *argument == Argument::Input(id));
        let (_, values) = found.expect("the values of every input");
        match layout.inputs[id].what {
            InputKind::Motion(_) => vec![0.0; values.len()],
            _ => values.clone(),
        }
    });
    let direction = Direction {
        coordinates: change.coordinates.clone(),
        rates: change.rates.clone(),
        inputs,
        ..sample.no_direction()
    };
    let [accelerations, found] = push(sample, &sample.given(), &direction);
    let expected = truth.accelerations_along(&in_dimension(sample, change));
    let scale = largest(&accelerations).max(largest(&expected));
    sample.check("by definition", (&found, &expected), scale, TOLERANCE);
}

/// Removes what the dimension does not have.
fn in_dimension(sample: &Sample, mut change: Change) -> Change {
    let dimension = sample.chain.dimension;
    let keep = |vector: &mut [f64; 3], axes: &[usize]| {
        (0..3).filter(|axis| !axes.contains(axis)).for_each(|axis| vector[axis] = 0.0);
    };
    keep(&mut change.gravity, dimension.translations());
    for load in &mut change.loads {
        keep(&mut load.force, dimension.translations());
        keep(&mut load.torque, dimension.rotations());
    }
    change
}
