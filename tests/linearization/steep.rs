//! Derivatives of efforts that are steep: finite, or an error.

use mstmm::nalgebra::SVector;
use mstmm::{Error, mstmm_chain};

mstmm_chain! {
    line chain Rubbing {
        answers = [linearize, pull, derivatives];
        body Block { mass = 1 kg; }
        ground -> slider x -> Block block;
        hinge x { friction = 1 N; friction_speed = 1e-20 m/s; }
    }

    /// The ends of the spring may meet.
    chain Meeting {
        answers = [linearize, pull, derivatives];
        param length = 0.1 m;
        body Link {
            mass = 1 kg;
            com = [0.1, 0, 0] m;
            output = [0.3, 0, 0] m;
            inertia = diag(0.01, 0.02, 0.025) kg*m^2 about com;
        }
        ground -> pin(z) a -> Link one -> slider(x) b -> Link two;
        spring s { on = one.output; to = two.input; stiffness = 1e4 N/m; length = length; damping = 300; }
    }
}

/// Tests the derivatives of functions that are `Ok`; returns whether one is an error.
fn any_error(results: [Result<Vec<f32>, Error>; 3]) -> bool {
    for numbers in results.iter().flatten() {
        assert!(numbers.iter().all(|number| number.is_finite()), "{numbers:?}");
    }
    results.iter().any(Result::is_err)
}

#[test]
fn derivatives_of_friction_are_finite_or_an_error() {
    let chain = Rubbing::<f32>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    let ones = SVector::<f32, 1>::repeat(1.0);
    let failed = [0.0_f32, 1e-30, 1e-10, 1.0].map(|rate| {
        state.v[0] = rate;
        any_error([
            chain.linearize(&state, &inputs).map(|it| it.by_rates.as_slice().to_vec()),
            chain.pull(&state, &inputs, &ones).map(|(_, it)| it.rates.as_slice().to_vec()),
            chain
                .inverse_dynamics_derivatives(&state, &ones, &inputs)
                .map(|it| it.by_rates.as_slice().to_vec()),
        ])
    });
    assert!(failed[0] && !failed[3], "{failed:?}");
}

#[test]
fn derivatives_of_springs_are_finite_or_an_error() {
    let chain = Meeting::<f32>::new();
    let (mut state, inputs) = (chain.initial_state(), chain.no_inputs());
    let ones = SVector::<f32, 2>::repeat(1.0);
    state.q[0] = 0.3;
    for x in [0.0_f32, 1e-20, 1e-17, 1e-16, 1e-15, 1e-12, 1e-3] {
        for rate in [0.0, 0.5, 1e3] {
            (state.q[1], state.v[0], state.v[1]) = (x, 0.7, rate);
            let all = |parts: &[&[f32]]| parts.concat();
            let failed = any_error([
                chain.linearize(&state, &inputs).map(|it| {
                    all(&[
                        it.by_coordinates.as_slice(),
                        it.by_rates.as_slice(),
                        it.by_parameters.as_slice(),
                    ])
                }),
                chain.pull(&state, &inputs, &ones).map(|(_, it)| {
                    all(&[it.coordinates.as_slice(), it.rates.as_slice(), it.parameters.as_slice()])
                }),
                chain
                    .inverse_dynamics_derivatives(&state, &ones, &inputs)
                    .map(|it| all(&[it.by_coordinates.as_slice(), it.by_rates.as_slice()])),
            ]);
            assert!(!failed || x < 1e-3, "{x:e}, {rate}");
        }
    }
}
