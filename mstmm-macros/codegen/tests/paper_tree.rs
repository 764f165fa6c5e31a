//! Compares the paper's matrices on a tree, a free hub with three arms of pins, with an independent solver.

mod common;

use common::paper::apart;
use common::paper_tree::{Elements, Tree};
use mstmm_reference::Random;

const CASES: u64 = 25;

/// The main transfer equation and the geometric equations hold for the state vectors of an independent solution.
#[test]
fn the_hub_transfers_the_independent_z() {
    for seed in 0..CASES {
        let tree = Tree::random(&mut Random::new(seed), 2);
        let state = tree.random_state(seed);
        let places = tree.independent(&state);
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

/// The overall equation of the tips has the independent solution, and so have the compiler's equations.
#[test]
fn the_overall_equation_of_three_arms() {
    for (count, seed) in
        [1, 2, 3].into_iter().flat_map(|count| (0..CASES).map(move |seed| (count, seed)))
    {
        for tree in [Tree::random(&mut Random::new(seed), count), Tree::of_cubes(count)] {
            let state = tree.random_state(seed);
            let places = tree.independent(&state);
            let expected = tree.states(&places);
            // Each body of an arm costs about one digit.
            let found = tree.elements(&places, &state.v).solve();
            let compiled = tree.states(&tree.riccati(&state));
            for (found, limit) in [(found, 1e-10), (compiled, 1e-13)] {
                let apart = found
                    .iter()
                    .zip(&expected)
                    .map(|(found, expected)| apart(found, expected))
                    .fold(0.0, f64::max);
                assert!(apart < limit, "{count} bodies an arm, seed {seed}: {apart:e}");
            }
        }
    }
}
