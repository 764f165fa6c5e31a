//! Compares the derivatives by composite bodies with sweeps on dual numbers, which differentiate the same inverse and forward
//! dynamics operation by operation: random chains and trees of all hinges, ends, loads and dimensions, on plain numbers.

mod common;

use common::lifted::lifted;
use common::{drives, numbers, read, variables};
use mstmm_codegen::equations::{
    self, Axes, Direction, EvalContext, InverseDynamicsTangent, Tangent, Trace,
};
use mstmm_codegen::math::{Dual, Structured};
use mstmm_codegen::model::{Chain, InputKind, Layout, Representation, SolutionMethod};
use mstmm_reference::{Random, Recipe, TreeRecipe, random_mechanism, random_motion, random_tree};

type Plain = Structured<f64>;

/// The tolerance of derivatives of inverse dynamics, relative to the largest entry of a matrix. Both sides are sums of a few
/// hundred products of the same numbers.
const TOLERANCE: f64 = 1e-12;

/// The tolerance of derivatives of accelerations. Both sides are divided by pivots, which amplifies rounding by the
/// condition number of the mass matrix, up to some thousands.
const TOLERANCE_OF_ACCELERATIONS: f64 = 1e-10;

const BODY: Axes = Axes::Body;

/// A chain in a state.
struct Situation {
    chain: Chain,
    q: Vec<Plain>,
    v: Vec<Plain>,
    inputs: Vec<Plain>,
    accelerations: Vec<Plain>,
    what: String,
}

impl Situation {
    /// Returns the open chain that `draw` describes, if it is open and moves.
    fn draw(seed: u64, as_tree: bool) -> Option<Situation> {
        let mut random = Random::new(seed);
        let truth = if as_tree {
            let recipe = TreeRecipe::any(&mut random, 6);
            random_tree(&mut random, "Random", &recipe)
        } else {
            let recipe = Recipe::any(&mut random, 5);
            random_mechanism(&mut random, "Random", &recipe)
        };
        let (state, driven) = random_motion(&mut random, &truth);
        let text = truth.to_macro_text(None);
        let chain = read(&text);
        let layout = Layout::of(&chain);
        if !layout.loop_hinges.is_empty() || layout.dof_count() == 0 {
            return None;
        }
        let inputs = drives::inputs(&chain, &truth, &driven);
        let accelerations: Vec<f64> =
            (0..layout.dof_count()).map(|_| random.between(-2.0, 2.0)).collect();
        Some(Situation {
            chain,
            q: variables(&state.q),
            v: variables(&state.v),
            inputs: variables(&inputs),
            accelerations: variables(&accelerations),
            what: format!("seed {seed}\n{text}"),
        })
    }

    /// Compares columns of a matrix.
    fn compare(&self, name: &str, found: &[Vec<f64>], expected: &[Vec<f64>], tolerance: f64) {
        let all = expected.iter().flatten();
        let scale = all.fold(1.0_f64, |largest, x| largest.max(x.abs()));
        assert_eq!(found.len(), expected.len());
        for (column, (found, expected)) in found.iter().zip(expected).enumerate() {
            for (row, (found, expected)) in found.iter().zip(expected).enumerate() {
                let off = (found - expected).abs() / scale;
                assert!(
                    off < tolerance,
                    "{name} ({row}, {column}): {found} instead of {expected}, off by {off:e}; {}",
                    self.what
                );
            }
        }
    }
}

fn plain(values: &[Plain]) -> Vec<f64> {
    values.iter().map(|value| value.value()).collect()
}

fn slopes(values: &[Dual<Plain>]) -> Vec<f64> {
    values.iter().map(|value| value.derivative().value()).collect()
}

fn unit(count: usize, k: usize) -> Vec<Plain> {
    let entry = |i| Structured::variable(if i == k { 1.0 } else { 0.0 });
    (0..count).map(entry).collect()
}

fn columns(matrix: &equations::DenseMatrix<Plain>, count: usize) -> Vec<Vec<f64>> {
    (0..count).map(|column| plain(matrix.column(column))).collect()
}

fn inverse_dynamics(situation: &Situation) {
    let Situation { chain, q, v, inputs, accelerations, .. } = situation;
    let merged = Layout::merged(chain);
    let values = numbers::<f64>(chain);
    let context =
        EvalContext::new(chain, &merged, &values, (q, v, inputs)).with_accelerations(accelerations);
    let trace = &mut Trace::silent();
    let tangent = InverseDynamicsTangent::new(&context, BODY, trace);
    let (rates, entries) = (v.len(), inputs.len());
    let along = |count: usize, direction: &dyn Fn(Vec<Plain>) -> Direction<Plain>| {
        let column = |k: usize| {
            let moved = Tangent::new(&context, &direction(unit(count, k)));
            let dual = moved.context(&context);
            slopes(&equations::inverse_dynamics(&dual, BODY, &mut Trace::silent()))
        };
        (0..count).map(column).collect::<Vec<_>>()
    };
    let none = Direction::default;
    let found = columns(&tangent.by_coordinates(trace), rates);
    let expected = along(rates, &|coordinates| Direction { coordinates, ..none() });
    situation.compare("by coordinates", &found, &expected, TOLERANCE);
    let found = columns(&tangent.by_rates(trace), rates);
    let expected = along(rates, &|rates| Direction { rates, ..none() });
    situation.compare("by rates", &found, &expected, TOLERANCE);
    let found = columns(&tangent.by_accelerations(trace), rates);
    let expected = along(rates, &|accelerations| Direction { accelerations, ..none() });
    situation.compare("by accelerations", &found, &expected, TOLERANCE);
    let found: Vec<_> = (0..entries).map(|entry| plain(&tangent.by_input(entry, trace))).collect();
    let expected = along(entries, &|inputs| Direction { inputs, ..none() });
    situation.compare("by inputs", &found, &expected, TOLERANCE);
}

/// Runs a test for open chains and trees of many seeds.
fn for_all(seeds: u64, test: impl Fn(&Situation)) {
    let mut tested = 0;
    for seed in 0..seeds {
        for as_tree in [false, true] {
            if let Some(situation) = Situation::draw(seed, as_tree) {
                test(&situation);
                tested += 1;
            }
        }
    }
    assert!(tested > seeds / 2, "only {tested} chains are open");
}

#[test]
fn derivatives_of_inverse_dynamics_are_those_of_dual_numbers() {
    for_all(120, inverse_dynamics);
}

/// Returns the columns of `−M⁻¹ D`, where column `k` of `D` is the motor of rate `driven[k]` as it is.
fn product(
    inverse: &[Vec<f64>],
    columns: &[Vec<f64>],
    driven: impl Fn(usize) -> bool,
) -> Vec<Vec<f64>> {
    let times = |column: &Vec<f64>| {
        let entry = |row: usize| {
            let terms = inverse.iter().zip(column);
            -terms.map(|(of_inverse, x)| of_inverse[row] * x).sum::<f64>()
        };
        (0..column.len()).map(entry).collect()
    };
    let product = |(k, column): (usize, &Vec<f64>)| match driven(k) {
        true => column.clone(),
        false => times(column),
    };
    columns.iter().enumerate().map(product).collect()
}

/// Removes the part along a change of the length of quaternions of prescribed motions: forward and inverse dynamics continue
/// to other lengths in different ways.
fn with_unit_quaternions(
    chain: &Chain,
    inputs: &[f64],
    mut columns: Vec<Vec<f64>>,
) -> Vec<Vec<f64>> {
    for input in &Layout::of(chain).inputs {
        let InputKind::Motion(hinge) = input.what else { continue };
        let groups = chain.hinges[hinge].kind.spec().groups.iter();
        for group in groups.filter(|group| group.representation == Representation::Quaternion) {
            let first = input.range.start + group.coordinates.start;
            let places = first..first + 4;
            let square: f64 = places.clone().map(|k| inputs[k] * inputs[k]).sum();
            for row in 0..columns[first].len() {
                let along: f64 = places.clone().map(|k| inputs[k] * columns[k][row]).sum();
                places.clone().for_each(|k| columns[k][row] -= along * inputs[k] / square);
            }
        }
    }
    columns
}

fn linearization(situation: &Situation) {
    let Situation { chain, q, v, inputs, .. } = situation;
    let chain = &lifted(chain.clone());
    let merged = Layout::merged(chain);
    let values = numbers::<f64>(chain);
    let context = EvalContext::new(chain, &merged, &values, (q, v, inputs));
    let trace = &mut Trace::silent();
    let found = equations::linearization(&context, BODY, trace);
    let (rates, parameters) = (v.len(), values.parameters.len());
    let riccati = SolutionMethod::Riccati;
    let solved = equations::forward_dynamics(&context, riccati, BODY, trace);
    let accelerations = [plain(&solved.accelerations)];
    let loose = TOLERANCE_OF_ACCELERATIONS;
    situation.compare("accelerations", &[plain(&found.accelerations)], &accelerations, loose);
    let along = |count: usize, direction: &dyn Fn(Vec<Plain>) -> Direction<Plain>| {
        let column = |k: usize| {
            let moved = Tangent::new(&context, &direction(unit(count, k)));
            let dual = moved.context(&context);
            let solved = equations::forward_dynamics(&dual, riccati, BODY, &mut Trace::silent());
            slopes(&solved.accelerations)
        };
        (0..count).map(column).collect::<Vec<_>>()
    };
    let inverse = columns(&found.inverse, rates);
    let driven = context.layout.driven_rates(context.chain);
    let none = Direction::default;
    let never = |_| false;
    let products = |matrix, count| product(&inverse, &columns(matrix, count), never);
    let by_coordinates = along(rates, &|coordinates| Direction { coordinates, ..none() });
    let of_coordinates = products(&found.by_coordinates, rates);
    situation.compare("A by coordinates", &of_coordinates, &by_coordinates, loose);
    let by_rates = along(rates, &|rates| Direction { rates, ..none() });
    situation.compare("A by rates", &products(&found.by_rates, rates), &by_rates, loose);
    let by_inputs = along(inputs.len(), &|inputs| Direction { inputs, ..none() });
    let of_inputs =
        product(&inverse, &columns(&found.by_inputs, inputs.len()), |k| driven[k].is_some());
    let [of_inputs, by_inputs] =
        [of_inputs, by_inputs].map(|all| with_unit_quaternions(chain, &plain(inputs), all));
    situation.compare("B", &of_inputs, &by_inputs, loose);
    let by_parameters = along(parameters, &|parameters| Direction { parameters, ..none() });
    let of_parameters = products(&found.by_parameters, parameters);
    situation.compare("by parameters", &of_parameters, &by_parameters, loose);
}

#[test]
fn derivatives_of_accelerations_are_those_of_dual_numbers() {
    for_all(24, linearization);
}
