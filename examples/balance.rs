//! A cart balances two poles, one on the other, with a linear-quadratic regulator at 100 Hz.
//!
//! `cargo run --release --example balance`; with `-- --page balance.html` it also writes a page that shows the motion.

mod page;
mod plot;

use mstmm::linear::{discretize, lqr};
use mstmm::nalgebra::{Matrix1, Matrix6, Vector6};
use mstmm::prelude::*;
use page::Page;
use plot::Plot;

mstmm_chain! {
    /// A cart on a rail and two poles, which stand upright at the angles zero.
    plane chain Balance {
        gravity = [0, -9.81] m/s^2;
        answers = linearize;

        body Cart { mass = 1 kg; com = [0, 0] m; output = [0, 0] m; inertia = 0.01 kg*m^2 about com; }
        body Pole { mass = 0.2 kg; com = [0, 0.25] m; output = [0, 0.5] m; inertia = 0.2/48 kg*m^2 about com; }

        ground -> slider(x) rail -> Cart cart
               -> pin lower -> Pole lower_pole -> pin upper -> Pole upper_pole;

        hinge rail { force = input; }
        hinge lower { start = 6 deg; }
        hinge upper { start = -3 deg; }
    }
}

/// The period of the controller in s, in which it holds its force.
const PERIOD: f64 = 0.01;

/// Runs the study and returns its picture.
fn study() -> Result<Plot, mstmm::Error> {
    // The linear model of a period about the upright pose, and the gain for it.
    let chain = Balance::<f64>::new();
    let upright = BalanceState::zero_position();
    let model = discretize(&chain, &upright, &chain.no_inputs(), PERIOD)?;
    let (a, b): (Matrix6<f64>, Vector6<f64>) = (model.a(), model.b());
    let weights = Matrix6::from_diagonal(&Vector6::new(10.0, 10.0, 10.0, 1.0, 1.0, 1.0));
    let regulator = lqr(&a, &b, &weights, &Matrix1::new(0.1))?;
    println!("gain {:.2?}", regulator.gain.as_slice());

    // Without control the poles fall, with control all motions decay.
    let [open, closed] = [a, a - b * regulator.gain].map(|matrix| spectral_radius(&matrix));
    println!("spectral radius {open:.4} without control, {closed:.4} with control");
    assert!(open > 1.0 && closed < 1.0);

    // The nonlinear chain comes to rest upright.
    let (mut state, mut rk4) = (chain.initial_state(), Rk4::new(PERIOD));
    let mut curves = [Vec::new(), Vec::new(), Vec::new()];
    let mut page = Page::of(&chain, 1);
    for step in 0..1000 {
        let tilts = [state.lower().angle(), state.lower().angle() + state.upper().angle()];
        let shown = [100.0 * state.rail().position(), tilts[0].to_degrees(), tilts[1].to_degrees()];
        if step < 400 {
            let time = state.time();
            curves.iter_mut().zip(shown).for_each(|(curve, value)| curve.push([time, value]));
        }
        let rail = -(regulator.gain * deviation(&state)).x;
        page.record(&state, &BalanceInputs { rail })?;
        rk4.step_held(&chain, &mut state, &BalanceInputs { rail })?;
    }
    page.write();
    println!(
        "after {:.0} s the state is {:.0e} from upright",
        state.time(),
        deviation(&state).norm()
    );
    assert!(deviation(&state).norm() < 1e-6);
    let energy = chain.energy(&state).total();
    assert!((energy - 0.2 * 9.81 * (0.25 + 0.75)).abs() < 1e-9);

    // From a small tilt the sum of all costs is that of the regulator, xᵀ P x.
    let mut state = upright.clone();
    state.lower_mut().set_angle(1e-3);
    let (start, mut cost) = (deviation(&state), 0.0);
    for _ in 0..1000 {
        let x = deviation(&state);
        let rail = -(regulator.gain * x).x;
        cost += x.dot(&(weights * x)) + 0.1 * rail * rail;
        rk4.step_held(&chain, &mut state, &BalanceInputs { rail })?;
    }
    let expected = start.dot(&(regulator.cost * start));
    println!("cost {cost:.6e}, by the regulator {expected:.6e}");
    assert!((cost - expected).abs() < 1e-4 * expected);

    let [cart, lower, upper] = curves;
    Ok(Plot::new("A cart that balances two poles", ["time in s", "cm, degrees"])
        .curve("cart in cm", cart)
        .curve("tilt of the lower pole in degrees", lower)
        .curve("tilt of the upper pole in degrees", upper))
}

/// Returns the state as a deviation from the upright pose: coordinates, then rates.
fn deviation(state: &BalanceState<f64>) -> Vector6<f64> {
    Vector6::from_iterator(state.q.iter().chain(&state.v).copied())
}

/// Returns the largest magnitude of the eigenvalues.
fn spectral_radius(matrix: &Matrix6<f64>) -> f64 {
    matrix.complex_eigenvalues().iter().map(|value| value.norm()).fold(0.0, f64::max)
}

fn main() -> Result<(), mstmm::Error> {
    study()?.save("balance");
    Ok(())
}

#[test]
fn poles_are_balanced() -> Result<(), mstmm::Error> {
    study()?.check("balance");
    Ok(())
}
