//! Gradients of the accelerations, and the regressor.

use crate::products::{push, random_direction};
use crate::samples::{Kind, Sample, dot, largest, samples};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::model::{Answer, DynamicParameter, InertialParameter, PassiveElement};
use mstmm_codegen::program::Given as Vector;
use mstmm_reference::{Element, Group, Hinge};

/// Sums of at most some hundred terms, relative to the sum of their magnitudes.
const SUMS: f64 = 1e-12;
/// Solutions lose as many digits as the condition number of the mass matrix has, at most four here.
const SOLVED: f64 = 1e-11;

/// Returns the sum of the magnitudes of products.
fn size(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a * b).abs()).sum()
}

/// `yᵀ (J x) = (Jᵀ y)ᵀ x`, for all coordinates, rates, inputs and parameters.
fn pulled_and_pushed(sample: &Sample) {
    let (given, direction) = (sample.given::<f64>(), random_direction(sample, 1));
    let weights = sample.random_rates(21);
    let [accelerations, change] = push(sample, &given, &direction);
    let results = sample.all(&given, Answer::Pull, &[(Vector::Vector, &weights[..])]);
    let found = results.result(outputs::ACCELERATIONS);
    sample.check("v̇", (&found, &accelerations), largest(&accelerations), SOLVED);
    let parts = [
        (outputs::BY_COORDINATES, &direction.coordinates),
        (outputs::BY_RATES, &direction.rates),
        (outputs::BY_INPUTS, &direction.inputs),
        (outputs::BY_PARAMETERS, &direction.parameters),
    ];
    let (mut sum, mut scale) = (0.0, size(&weights, &change));
    for (id, along) in parts {
        let gradient = results.result(id);
        assert_eq!(gradient.len(), along.len(), "{}", sample.named(id.name));
        sum += dot(&gradient, along);
        scale += size(&gradient, along);
    }
    sample.check("(Jᵀ y)ᵀ x", (&[sum], &[dot(&weights, &change)]), scale.max(1.0), SOLVED);
}

#[test]
fn gradients() {
    let kinds = [
        (Kind::OpenRoute, 0..60),
        (Kind::OpenTree, 1000..1040),
        (Kind::Described, 2000..2030),
        (Kind::Lifted, 3000..3020),
    ];
    for (kind, seeds) in kinds {
        samples(kind, seeds, "[push, pull]").for_each(|sample| pulled_and_pushed(&sample));
    }
}

/// The column of each inertial parameter is that of the reference, in which this parameter is increased by one.
fn columns_of_bodies(sample: &Sample) {
    let accelerations = sample.random_rates(22);
    let vectors: [(Vector, &[f64]); 1] = [(Vector::Accelerations, &accelerations)];
    let entries =
        sample.ask(&sample.given::<f64>(), (Answer::Regressor, outputs::REGRESSOR), &vectors);
    let parameters = sample.chain.dynamic_parameters();
    let truth = sample.truth.answers(&sample.state, &sample.drives);
    let columns = truth.body_regressor(&accelerations);
    let mut bodies: Vec<_> = Vec::new();
    for (column, parameter) in entries.chunks(sample.rates().max(1)).zip(&parameters) {
        let DynamicParameter::Inertial(body, parameter) = *parameter else { continue };
        if !bodies.contains(&body) {
            bodies.push(body);
        }
        let number = match parameter {
            InertialParameter::Mass => 0,
            InertialParameter::FirstMoment(k) => 1 + k,
            InertialParameter::Inertia(i, j) if i == j => 4 + i,
            InertialParameter::Inertia(i, j) => 6 + i + j,
        };
        let expected = &columns[bodies.len() - 1][number];
        let name =
            sample.chain.name_of_dynamic_parameter(DynamicParameter::Inertial(body, parameter));
        sample.check(&name, (column, expected), largest(expected), SUMS);
    }
}

/// The column of each passive element of a hinge is the difference between the efforts of the reference with an element of unit
/// size and without the element. The three rotations of a quaternion share one element in the reference. The regressor has a
/// column for the effort along each of them.
///
/// Counts the columns that are not zero.
fn columns_of_passive_elements(sample: &Sample, tried: &mut [usize; 4]) {
    let accelerations = sample.random_rates(25);
    let vectors: [(Vector, &[f64]); 1] = [(Vector::Accelerations, &accelerations)];
    let entries =
        sample.ask(&sample.given::<f64>(), (Answer::Regressor, outputs::REGRESSOR), &vectors);
    let parameters = sample.chain.dynamic_parameters();
    for (column, parameter) in entries.chunks(sample.rates().max(1)).zip(&parameters) {
        let DynamicParameter::Passive(hinge, k, element) = *parameter else { continue };
        let name = sample.chain.hinges[hinge].name.to_string();
        let [one, none] = [1.0, 0.0].map(|size| {
            let mut truth = sample.truth.clone();
            set_element(hinge_mut(&mut truth, &name), k, element, size);
            truth.answers(&sample.state, &sample.drives).inverse_dynamics(&accelerations)
        });
        let mut expected: Vec<f64> = one.iter().zip(&none).map(|(a, b)| a - b).collect();
        let own = sample.truth.first_rate(&name);
        if is_shared(hinge_mut(&mut sample.truth.clone(), &name), k) {
            (0..expected.len()).filter(|&rate| rate != own + k).for_each(|at| expected[at] = 0.0);
        }
        let name = sample.chain.name_of_dynamic_parameter(*parameter);
        sample.check(&name, (column, &expected), largest(&none), SUMS);
        tried[element as usize] += usize::from(expected.iter().any(|entry| entry.abs() > 1e-3));
    }
}

fn hinge_mut<'a>(chain: &'a mut mstmm_reference::Chain, name: &str) -> &'a mut Hinge {
    let later = chain.later_routes.iter_mut().flat_map(|route| &mut route.elements);
    let mut hinges = chain.elements.iter_mut().chain(later).filter_map(|element| match element {
        Element::Hinge(hinge) => Some(hinge),
        Element::Body(_) => None,
    });
    hinges.find(|hinge| hinge.name == name).expect("a hinge of this name")
}

/// Returns whether a strain is a rotation of a quaternion.
fn is_shared(hinge: &Hinge, k: usize) -> bool {
    hinge.kind.has_quaternion() && hinge.kind.turning().contains(&k)
}

/// Sets the size of a passive element along a strain.
fn set_element(hinge: &mut Hinge, k: usize, element: PassiveElement, size: f64) {
    let (shared, turning) = (is_shared(hinge, k), hinge.kind.turning());
    let range = if turning.contains(&k) { turning.clone() } else { hinge.kind.linear() };
    let group: &mut Group =
        if turning.contains(&k) { &mut hinge.turning } else { &mut hinge.linear };
    // The list has one entry for all strains of the group, or one for each.
    let list = match element {
        PassiveElement::Friction => &mut group.friction,
        PassiveElement::Damping => &mut group.damping,
        PassiveElement::Armature => &mut group.armature,
        PassiveElement::Stiffness => &mut group.stiffness,
    };
    match list[..] {
        [_] if shared => list[0] = size,
        [value] => *list = vec![value; range.len()],
        _ => {}
    }
    if !shared {
        list[k - range.start] = size;
    }
}

/// The product of the regressor with the chain's own parameters, by the matrix and without it, is inverse dynamics less the
/// efforts of loads, springs between bodies and stops, which do not depend on the parameters: the same for other accelerations.
fn product_of_regressor(sample: &Sample) {
    let given = sample.given::<f64>();
    let own = sample.ask(&given, (Answer::DynamicParameters, outputs::DYNAMIC_PARAMETERS), &[]);
    let less = |number: u64| {
        let accelerations = sample.random_rates(number);
        let vectors: [(Vector, &[f64]); 2] =
            [(Vector::Accelerations, &accelerations), (Vector::DynamicParameters, &own)];
        let product = sample.ask(&given, (Answer::RegressorTimes, outputs::PRODUCT), &vectors);
        let efforts = sample.ask(&given, (Answer::InverseDynamics, outputs::EFFORTS), &vectors);
        let less = efforts.iter().zip(&product).map(|(a, b)| a - b).collect::<Vec<f64>>();
        if sample.chain.repeats.is_empty() {
            let entries = sample.ask(&given, (Answer::Regressor, outputs::REGRESSOR), &vectors);
            let mut sum = vec![0.0; sample.rates()];
            for (column, value) in entries.chunks(sample.rates().max(1)).zip(&own) {
                sum.iter_mut().zip(column).for_each(|(sum, entry)| *sum += entry * value);
            }
            sample.check("Y π", (&product, &sum), largest(&efforts), SUMS);
        }
        (less, largest(&efforts))
    };
    let ((one, scale), (other, _)) = (less(23), less(24));
    sample.check("ID − Y π", (&one, &other), scale, SUMS);
}

#[test]
fn regressors() {
    let kinds = [(Kind::Route, 0..40), (Kind::Tree, 1000..1030), (Kind::Lifted, 3000..3010)];
    let mut tried = [0; 4];
    for (kind, seeds) in kinds {
        for sample in samples(kind, seeds, "[inverse_dynamics, regressor]") {
            columns_of_bodies(&sample);
            columns_of_passive_elements(&sample, &mut tried);
            product_of_regressor(&sample);
        }
    }
    println!("friction, damping, armature, stiffness: {tried:?} columns");
    assert!(tried.iter().all(|count| *count > 20), "{tried:?}");
    samples(Kind::Described, 2000..2020, "[inverse_dynamics, regressor]")
        .for_each(|sample| product_of_regressor(&sample));
}
