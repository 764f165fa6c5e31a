//! Compares the paper's matrices on a tree, a free hub with three arms of pins, with an independent solver.

mod common;

use common::paper::apart;
use common::paper_tree::{ARMS, ArmElements, Elements, Place, Tree};
use mstmm_reference::{Random, State};
use mstmm_runtime::nalgebra::SVector;
use mstmm_runtime::paper::TransferMatrix;
use mstmm_runtime::paper::chain::OutputEnd;
use mstmm_runtime::paper::tree::{self, Columns};

/// The number of unknowns: six at each tip, and Θ̈ of each pin at the hub.
const UNKNOWNS: usize = 7 * ARMS;

type Tip = Columns<f64, 13, UNKNOWNS>;

/// Returns the connection points as the reference solver computes them.
fn independent(tree: &Tree, state: &State) -> Vec<Place> {
    let chain = tree.reference();
    let efforts = vec![0.0; chain.dof_count()];
    chain.solve(state, &efforts).points.iter().map(Place::of_reference).collect()
}

/// Returns the matrices of an arm, except that of its last pin: body, pin, body, …, body.
fn matrices(arm: &ArmElements) -> Vec<TransferMatrix<f64>> {
    let ArmElements { bodies, pins } = arm;
    let mut elements = vec![bodies[0]];
    for (k, body) in bodies.iter().enumerate().skip(1) {
        let pin = pins[k - 1].blocks(body, &pins[k].orientation).transfer_matrix();
        elements.extend([pin, *body]);
    }
    elements
}

/// Returns the state vectors along the arms and at the output of the hub by the overall equation.
fn solve(elements: &Elements) -> ([Vec<SVector<f64, 13>>; ARMS], SVector<f64, 13>) {
    let arms: [_; ARMS] = std::array::from_fn(|arm| matrices(&elements.arms[arm]));
    let pins: [_; ARMS] = std::array::from_fn(|arm| &elements.arms[arm].pins);
    let (mut conditions, mut inputs, mut starts) = (Vec::new(), Vec::new(), Vec::new());
    for arm in 0..ARMS {
        let tip = Tip::free_tip(7 * arm);
        conditions.extend(tip.through(&arms[arm][0]).axial_moment(&pins[arm][0]).rows());
        let end = arms[arm].iter().fold(tip, |z, element| z.through(element));
        inputs.push(end.over_pin(&pins[arm][pins[arm].len() - 1], 7 * arm + 6));
        starts.push(tip);
    }
    let mut output = inputs[0].through(&elements.hub);
    for (further, input) in elements.further.iter().zip(&inputs[1..]) {
        conditions.extend(further.geometric_equations(&inputs[0], input).rows());
        output = output + input.through(&further.transfer_matrix());
    }
    conditions.extend(output.through(&OutputEnd::free().conditions).rows());
    let x = tree::solve::<f64, UNKNOWNS, UNKNOWNS>(conditions);
    let along = |arm: usize| {
        let mut states = vec![starts[arm].at(&x)];
        for element in &arms[arm] {
            states.push(element * states[states.len() - 1]);
        }
        let last = &pins[arm][pins[arm].len() - 1];
        let acceleration = x[7 * arm + 6];
        let mut input = states[states.len() - 1];
        let angular = input.fixed_rows::<3>(3).into_owned();
        let angular = last.output_angular_acceleration(&angular, acceleration);
        input.fixed_rows_mut::<3>(3).copy_from(&angular);
        states.push(input);
        states
    };
    (std::array::from_fn(along), output.at(&x))
}

/// The main transfer equation and the geometric equations hold for the state vectors of an independent solution.
#[test]
fn the_hub_transfers_the_independent_z() {
    for seed in 0..25 {
        let tree = Tree::random(&mut Random::new(seed), 2);
        let state = tree.random_state(seed);
        let places = independent(&tree, &state);
        let Elements { hub, further, .. } = tree.elements(&places, &state.v);
        let inputs = [0, 1, 2].map(|arm| places[2 + arm].z);
        let mut output = hub * inputs[0];
        for (further, input) in further.iter().zip(&inputs[1..]) {
            output += further.transfer_matrix() * input;
            let geometry = further.geometry() * inputs[0];
            let expected = input.fixed_rows::<6>(0).into_owned();
            assert!(apart(&geometry, &expected) < 1e-12, "seed {seed}: {geometry}{expected}");
        }
        assert!(apart(&output, &places[0].z) < 1e-12, "seed {seed}: {output}{}", places[0].z);
    }
}

/// Returns the largest difference of the overall equation's state vectors from an independent solution, relative to the largest
/// entry.
fn difference(tree: &Tree, places: &[Place], v: &[f64]) -> f64 {
    let (arms, output) = solve(&tree.elements(places, v));
    let (mut found, mut expected) = (vec![output], vec![places[0].z]);
    for (arm, states) in arms.into_iter().enumerate() {
        found.extend(states);
        expected.extend(tree.along(places, arm));
    }
    let [found, expected] = [found, expected]
        .map(|states| states.iter().flat_map(|z| z.iter().copied()).collect::<Vec<_>>());
    common::difference(&found, &expected)
}

/// The overall equation of the tips has the independent solution.
#[test]
fn the_overall_equation_of_three_arms() {
    for count in [1, 2, 3] {
        for seed in 0..10 {
            let random = Tree::random(&mut Random::new(seed), count);
            for (name, tree) in [("random", random), ("cubes", Tree::of_cubes(count))] {
                let state = tree.random_state(seed);
                let apart = difference(&tree, &independent(&tree, &state), &state.v);
                // Each body of an arm costs about one digit.
                assert!(apart < 1e-10, "{name}, {count} bodies an arm, seed {seed}: {apart:e}");
            }
        }
    }
}
