//! The linearisation of a chain of a hundred balls, against products in twice the precision.

use super::products::{at_pose, numbers};
use crate::double_double::DoubleDouble;
use crate::{Pose, error, with_room};
use mstmm::description::Answer;
use mstmm::{Described, mstmm_chain};

mstmm_chain! { chain Hundred {
    gravity = [0, -9.8, 0] m/s^2;
    answers = [linearize, push];
    body Cube {
        mass = 1 kg;
        com = [0.5, 0, 0] m;
        output = [1, 0, 0] m;
        inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
    }
    ground -> repeat 100 { ball a -> Cube b };
    hinge a { torque = input; }
} }

/// The rates, which are as many as the inputs.
const RATES: usize = 300;

/// A small motion of a ball changes the efforts that keep the accelerations by up to a thousand times the efforts between
/// neighbours, and these changes cancel. Their rounding errors of some units in the last place remain.
const BENT: f64 = 1e-11;

/// If all balls are in a row across gravity, such a change is that of the weight of all bodies times the length of the chain,
/// 1e5 N m, and all bodies together have small inertia against bending: rates change by up to 10 /s² for each N m. Errors of
/// some units in the last place become 1e5 · 10 · 1e-15 /s², relative to entries of about 10 /s².
const STRAIGHT: f64 = 1e-9;

/// Returns the columns of A and B that belong to the accelerations, by coordinates, rates and inputs.
fn columns(chain: &Hundred<f64>, pose: &Pose) -> Vec<Vec<f64>> {
    let values = at_pose(chain, pose, Answer::Linearize, &[]);
    let parts = 2 * RATES * (2 * RATES + RATES);
    let a_and_b = &values[values.len() - parts..];
    a_and_b.chunks(2 * RATES).map(|column| column[RATES..].to_vec()).collect()
}

/// Returns the change of the accelerations along a direction, in twice the precision.
fn change(exact: &Hundred<DoubleDouble>, pose: &Pose, direction: &[f64]) -> Vec<f64> {
    let pushed = at_pose(exact, pose, Answer::Push, direction);
    pushed[RATES..].iter().map(|entry| entry.high).collect()
}

/// Compares every seventh column, relative to the largest entry of all compared columns along coordinates, rates or inputs,
/// and the product of all columns with a random direction.
fn check(what: &str, pose: &Pose, tolerance: f64) {
    let (chain, exact) = (Hundred::<f64>::new(), Hundred::<DoubleDouble>::new());
    assert_eq!(Answer::Push.given(Hundred::<f64>::DESCRIPTION), 3 * RATES);
    let columns = columns(&chain, pose);
    for (block, name) in ["coordinates", "rates", "inputs"].into_iter().enumerate() {
        let (mut found, mut expected) = (Vec::new(), Vec::new());
        let own = block * RATES..(block + 1) * RATES;
        for k in own.clone().step_by(7) {
            let mut unit = vec![0.0; columns.len()];
            unit[k] = 1.0;
            found.extend(&columns[k]);
            expected.extend(change(&exact, pose, &unit));
        }
        if expected.iter().all(|entry| *entry == 0.0) {
            // At rest, rates do not change the accelerations.
            assert!(name == "rates" && found == expected, "{what}, along {name}");
            continue;
        }
        let off = error(&found, &expected);
        let mut direction = vec![0.0; columns.len()];
        direction[own.clone()].copy_from_slice(&numbers(RATES, 7));
        let along = change(&exact, pose, &direction);
        let sum = |row: usize| own.clone().map(|k| columns[k][row] * direction[k]).sum();
        let off_along = error(&(0..RATES).map(sum).collect::<Vec<f64>>(), &along);
        println!("{what}, along {name}: columns are off by {off:.1e}, products by {off_along:.1e}");
        assert!(off < tolerance, "{what}, along {name}: columns are off by {off:e}");
        assert!(off_along < tolerance, "{what}, along {name}: products are off by {off_along:e}");
    }
}

#[test]
fn a_and_b_of_a_hundred_balls_are_accurate() {
    with_room(|| {
        let chain = Hundred::<f64>::new();
        for seed in 0..2 {
            check(&format!("seed {seed}"), &Pose::random(&chain, seed), BENT);
        }
        check("straight", &Pose::straight(&chain, 0.0), STRAIGHT);
    });
}
