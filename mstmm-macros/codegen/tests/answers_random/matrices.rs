//! The mass matrix, its inverse, and the derivatives of inverse dynamics and of the accelerations as matrices.

use crate::differences::{Asked, Direction};
use crate::samples::{Kind, Sample, dot, largest, samples, times};
use mstmm_codegen::compile::outputs;
use mstmm_codegen::model::{Answer, Input, InputKind, Layout};
use mstmm_codegen::program::{Given as Vector, OutputId};
use mstmm_reference::Change;

/// Efforts and entries of the mass matrix are sums of at most some hundred terms, relative to the largest entry.
const SUMS: f64 = 1e-12;
/// The tolerance relative to the largest entry of a column and of the accelerations: a solution loses as many digits
/// as the condition number of the mass matrix has, at most four here.
const SOLVED: f64 = 1e-11;

/// A matrix by columns.
struct Columns(Vec<Vec<f64>>);

impl Columns {
    fn new(sample: &Sample, entries: Vec<f64>) -> Columns {
        Columns(entries.chunks(sample.rates().max(1)).map(<[f64]>::to_vec).collect())
    }

    fn largest(&self) -> f64 {
        self.0.iter().map(|column| largest(column)).fold(1.0, f64::max)
    }

    fn rows(&self) -> Vec<Vec<f64>> {
        let count = self.0.first().map_or(0, Vec::len);
        (0..count).map(|row| self.0.iter().map(|column| column[row]).collect()).collect()
    }
}

/// Returns a matrix among the results of a function.
fn matrix(sample: &Sample, asked: (Answer, OutputId), vectors: &[(Vector, &[f64])]) -> Columns {
    Columns::new(sample, sample.ask(&sample.given::<f64>(), asked, vectors))
}

fn unit(count: usize, k: usize) -> Vec<f64> {
    (0..count).map(|j| f64::from(u8::from(j == k))).collect()
}

#[test]
fn mass_matrices() {
    let kinds = [(Kind::Route, 0..40), (Kind::Tree, 1000..1040), (Kind::Lifted, 3000..3020)];
    for (kind, seeds) in kinds {
        for sample in samples(kind, seeds, "mass_matrix") {
            mass_matrix(&sample);
        }
    }
}

fn mass_matrix(sample: &Sample) {
    let truth = sample.truth.answers(&sample.state, &sample.drives).mass_matrix();
    let found = matrix(sample, (Answer::MassMatrix, outputs::MATRIX), &[]);
    let (rows, scale) = (found.rows(), found.largest());
    sample.check("M", (&rows.concat(), &truth.concat()), scale, SUMS);
    assert_eq!(rows, found.0, "{}", sample.named("M is not symmetric"));
    for k in 0..sample.rates() {
        let product = (Answer::MassMatrixTimes, outputs::PRODUCT);
        let unit = unit(sample.rates(), k);
        let column = sample.ask(&sample.given(), product, &[(Vector::Vector, &unit)]);
        sample.check("column of M", (&found.0[k], &column), scale, SUMS);
    }
    if sample.truth.closed() || sample.rates() == 0 {
        return;
    }
    let x = sample.random_rates(6);
    assert!(dot(&x, &times(&rows, &x)) > 0.0, "{}", sample.named("M is not positive"));
    let inverse = matrix(sample, (Answer::InverseMassMatrix, outputs::MATRIX), &[]);
    assert_eq!(inverse.rows(), inverse.0, "{}", sample.named("M⁻¹ is not symmetric"));
    for (k, column) in inverse.0.iter().enumerate() {
        let back = times(&rows, column);
        let scale = scale * largest(column);
        sample.check("M M⁻¹", (&back, &unit(sample.rates(), k)), scale, SUMS);
    }
}

#[test]
fn derivatives_of_inverse_dynamics() {
    let kinds =
        [(Kind::OpenRoute, 0..40), (Kind::OpenTree, 1000..1030), (Kind::Lifted, 3000..3010)];
    for (kind, seeds) in kinds {
        for sample in samples(kind, seeds, "[inverse_dynamics, derivatives]") {
            by_differences(&sample);
            by_definition(&sample);
        }
    }
}

/// Returns the derivatives of inverse dynamics by coordinates, rates and accelerations.
fn derivatives(sample: &Sample, accelerations: &[f64]) -> [Columns; 3] {
    let vectors: [(Vector, &[f64]); 1] = [(Vector::Accelerations, accelerations)];
    [outputs::BY_COORDINATES, outputs::BY_RATES, outputs::BY_ACCELERATIONS]
        .map(|id| matrix(sample, (Answer::InverseDynamicsDerivatives, id), &vectors))
}

/// Returns the three directions along a rate.
fn along_rate(sample: &Sample, k: usize) -> [Direction; 3] {
    let (unit, none) = (unit(sample.rates(), k), sample.no_direction());
    [
        Direction { coordinates: unit.clone(), ..none.clone() },
        Direction { rates: unit.clone(), ..none.clone() },
        Direction { accelerations: unit, ..none },
    ]
}

/// Every column is the difference of efforts along it.
fn by_differences(sample: &Sample) {
    let accelerations = sample.random_rates(7);
    let found = derivatives(sample, &accelerations);
    let names = ["∂ID/∂q", "∂ID/∂v", "∂ID/∂v̇"];
    for k in 0..sample.rates() {
        for ((direction, found), name) in along_rate(sample, k).iter().zip(&found).zip(names) {
            let asked = Asked {
                answer: Answer::InverseDynamics,
                id: outputs::EFFORTS,
                accelerations: Some(&accelerations),
            };
            let expected = sample.difference(&asked, direction);
            let scale = largest(&expected).max(found.largest());
            sample.check(name, (&found.0[k], &expected), scale, SUMS);
        }
    }
}

/// Along a random direction the derivative is that of the reference.
fn by_definition(sample: &Sample) {
    let accelerations = sample.random_rates(8);
    let truth = sample.truth.answers(&sample.state, &sample.drives);
    let change = Change {
        coordinates: sample.random_rates(9),
        rates: sample.random_rates(10),
        accelerations: sample.random_rates(11),
        ..truth.no_change()
    };
    let expected = truth.inverse_dynamics_along(&accelerations, &change);
    let found = derivatives(sample, &accelerations);
    let vectors = [&change.coordinates, &change.rates, &change.accelerations];
    let mut sum = vec![0.0; expected.len()];
    for (columns, vector) in found.iter().zip(vectors) {
        let product = times(&columns.rows(), vector);
        sum.iter_mut().zip(product).for_each(|(sum, entry)| *sum += entry);
    }
    let scale = found.iter().map(Columns::largest).fold(largest(&expected), f64::max);
    sample.check("∂ID by definition", (&sum, &expected), scale, SUMS);
}

/// At rest, `∂ID/∂q` is the stiffness of a potential. It is symmetric, except for the rotations of a ball, whose
/// displacements do not commute: `K − Kᵀ = [τ]×` with the torque `τ` of the drive.
#[test]
fn stiffness_is_that_of_a_potential() {
    use mstmm_codegen::model::HingeKind::{Ball, Elastic, Floating};
    use mstmm_codegen::model::Source;
    let mut balls = 0;
    for mut sample in samples(Kind::Bare, 1100..1160, "[inverse_dynamics, derivatives]") {
        let is_input = sample.chain.gravity == Source::Input;
        if sample.is_prescribed() || is_input || !sample.truth.loads.is_empty() {
            continue;
        }
        sample.state.v.fill(0.0);
        let zero = vec![0.0; sample.rates()];
        let [stiffness, ..] = derivatives(&sample, &zero);
        let inverse = (Answer::InverseDynamics, outputs::EFFORTS);
        let vectors: [(Vector, &[f64]); 1] = [(Vector::Accelerations, &zero)];
        let efforts = sample.ask(&sample.given(), inverse, &vectors);
        let rows = stiffness.rows();
        let mut expected = vec![zero.clone(); sample.rates()];
        let layout = Layout::of(&sample.chain);
        for (id, hinge) in sample.chain.hinges.enumerate() {
            if matches!(hinge.kind, Ball | Floating | Elastic) {
                let first = layout.v[id].end - 3;
                for k in 0..3 {
                    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
                    expected[first + j][first + i] = efforts[first + k];
                    expected[first + i][first + j] = -efforts[first + k];
                }
                balls += 1;
            }
        }
        for (row, expected) in expected.iter().enumerate() {
            let columns = &stiffness.0[row];
            let found: Vec<f64> = rows[row].iter().zip(columns).map(|(a, b)| a - b).collect();
            sample.check("K − Kᵀ", (&found, expected), stiffness.largest(), SUMS);
        }
    }
    assert!(balls > 20, "{balls} hinges with a rotation of three degrees of freedom");
}

#[test]
fn derivatives_of_accelerations() {
    let kinds =
        [(Kind::OpenRoute, 0..30), (Kind::OpenTree, 1000..1020), (Kind::Lifted, 3000..3010)];
    for (kind, seeds) in kinds {
        for sample in samples(kind, seeds, "linearize") {
            linearization(&sample);
        }
    }
}

/// Returns the derivative of the accelerations of which the function reports the derivative of efforts.
fn solved(inverse: &[Vec<f64>], efforts: &[f64]) -> Vec<f64> {
    times(inverse, efforts).iter().map(|entry| -entry).collect()
}

/// Returns whether an entry of the inputs is the effort of a motor.
fn is_effort(sample: &Sample, entry: usize) -> bool {
    let layout = Layout::of(&sample.chain);
    let is_it = |input: &Input| input.range.contains(&entry);
    layout
        .inputs
        .iter()
        .find(|&input| is_it(input))
        .is_some_and(|input| matches!(input.what, InputKind::Efforts(_)))
}

fn linearization(sample: &Sample) {
    let results = sample.all(&sample.given::<f64>(), Answer::Linearization, &[]);
    let columns = |id| Columns::new(sample, results.result(id));
    let inverse = columns(outputs::INVERSE_MASS_MATRIX).rows();
    let accelerations = results.result(outputs::ACCELERATIONS);
    let asked = (Answer::Accelerations, outputs::ACCELERATIONS);
    let expected = sample.ask(&sample.given(), asked, &[]);
    let size = largest(&expected);
    sample.check("accelerations", (&accelerations, &expected), size, SOLVED);
    let none = sample.no_direction();
    type Along = fn(&mut Direction) -> &mut Vec<f64>;
    let groups: [(&str, OutputId, Along); 4] = [
        ("∂v̇/∂q", outputs::BY_COORDINATES, |it| &mut it.coordinates),
        ("∂v̇/∂v", outputs::BY_RATES, |it| &mut it.rates),
        ("∂v̇/∂u", outputs::BY_INPUTS, |it| &mut it.inputs),
        ("∂v̇/∂p", outputs::BY_PARAMETERS, |it| &mut it.parameters),
    ];
    for (name, id, along) in groups {
        let mut columns = columns(id);
        // The columns of motors are those of the inverse; the others are derivatives of efforts.
        let is_solved = |entry: usize| id == outputs::BY_INPUTS && is_effort(sample, entry);
        for (entry, column) in columns.0.iter_mut().enumerate() {
            if !is_solved(entry) {
                *column = solved(&inverse, column);
            }
        }
        let count = along(&mut none.clone()).len();
        assert_eq!(columns.0.len(), if sample.rates() == 0 { 0 } else { count }, "{name}");
        let asked = Asked {
            answer: Answer::Accelerations,
            id: outputs::ACCELERATIONS,
            accelerations: None,
        };
        // One random combination of columns, and some single columns.
        let singles = (0..count).step_by(1 + count / 8).map(|k| unit(count, k));
        for mut entries in singles {
            if id == outputs::BY_INPUTS {
                crate::products::keep_lengths(sample, &mut entries);
            }
            let mut direction = none.clone();
            *along(&mut direction) = entries.clone();
            let expected = sample.difference(&asked, &direction);
            let found = times(&columns.rows(), &entries);
            let scale = size.max(largest(&expected));
            sample.check(name, (&found, &expected), scale, SOLVED);
        }
    }
}
