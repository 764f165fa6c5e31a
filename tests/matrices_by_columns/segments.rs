//! Inputs, parameters and dynamic parameters of a repeated part, with those of other elements between them.

use mstmm::nalgebra::SVector;
use mstmm::{Error, mstmm_chain};

mstmm_chain! {
    chain Split {
        answers = [inverse_dynamics, linearize, pull, regressor];
        gravity = [0, -9.8, 1] m/s^2;
        param knot[2] = 0.3 kg;
        param tip = 1.3 kg;
        param rigidity[2] = 3 N*m/rad;
        body Rod {
            mass = 1 kg + knot;
            com = [0.3, 0.1, 0] m;
            output = [0.6, 0, 0.2] m turned rpy(20, -30, 50) deg;
            inertia = tensor(0.1, 0.12, 0.09, 0.01, 0.02, -0.01) kg*m^2 about com;
        }
        body Tip {
            mass = tip;
            com = [0.2, 0, 0.1] m;
            inertia = diag(0.02, 0.03, 0.025) kg*m^2 about com;
        }
        ground -> repeat 2 { ball joint -> Rod rod } -> pin wrist -> Tip hand;
        hinge joint { torque = input; stiffness = rigidity; damping = 0.2; }
        hinge wrist { torque = input; damping = 0.1; }
        load push { on = rod; force = input; }
    }
}

const RATES: usize = 7;

/// Returns the largest magnitude.
fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// Sums of some hundred terms, and condition numbers of the mass matrix below 1000.
#[track_caller]
fn agree(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let off: Vec<f64> = found.iter().zip(expected).map(|(a, b)| a - b).collect();
    assert!(
        largest(expected) > 0.0 && largest(&off) < 1e5 * f64::EPSILON * largest(expected),
        "{off:?}"
    );
}

/// Returns a chain and a state in which all terms are there.
fn sample() -> Result<(Split<f64>, SplitState<f64>), Error> {
    let mut chain = Split::<f64>::new();
    chain.set_knot(|index| 0.1 + 0.3 * index as f64)?;
    chain.set_rigidity(|index| 2.0 + index as f64)?;
    let mut state = chain.initial_state();
    for (k, q) in state.q.iter_mut().enumerate() {
        *q += 0.05 * ((k * k) % 5) as f64;
    }
    state.v = SVector::from_fn(|k, _| 0.4 - 0.13 * k as f64);
    mstmm::Chain::normalize(&chain, &mut state);
    Ok((chain, state))
}

#[test]
fn gradients_are_products_with_the_columns() -> Result<(), Error> {
    let (chain, state) = sample()?;
    let mut inputs = chain.no_inputs();
    inputs.joint[1] = [0.7, -0.3, 0.2].into();
    inputs.push_force[0] = [1.0, 2.0, -3.0].into();
    inputs.wrist = 0.4;
    let mut linear = SplitLinearization::default();
    chain.linearize_into(&state, &inputs, &mut linear)?;
    let weights = SVector::<f64, RATES>::from_fn(|k, _| 0.3 * k as f64 - 1.0);
    let (mut accelerations, mut gradient) = (weights, SplitVariation::default());
    chain.pull_into(&state, &inputs, &weights, &mut accelerations, &mut gradient)?;
    agree(accelerations.as_slice(), linear.accelerations.as_slice());
    agree(gradient.coordinates.as_slice(), linear.by_coordinates.tr_mul(&weights).as_slice());
    agree(gradient.rates.as_slice(), linear.by_rates.tr_mul(&weights).as_slice());
    agree(gradient.inputs.as_slice(), linear.by_inputs.tr_mul(&weights).as_slice());
    agree(gradient.parameters.as_slice(), linear.by_parameters.tr_mul(&weights).as_slice());
    Ok(())
}

#[test]
fn dynamic_parameters_follow_their_setters() -> Result<(), Error> {
    let (chain, state) = sample()?;
    let accelerations = SVector::<f64, RATES>::from_fn(|k, _| 0.3 * k as f64 - 1.0);
    let regressor = chain.regressor(&state, &accelerations, &chain.no_inputs())?;
    let efforts = chain.inverse_dynamics(&state, &accelerations, &chain.no_inputs())?;
    agree((regressor * chain.dynamic_parameters()).as_slice(), efforts.as_slice());
    Ok(())
}
