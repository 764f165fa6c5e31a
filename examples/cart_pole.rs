//! A cart swings its pole up and balances it.
//!
//! `cargo run --release --example cart_pole`; with `-- --page cart_pole.html` it also writes a page that shows the motion.

mod page;

use std::f64::consts::PI;

use mstmm::linear::{discretize, lqr};
use mstmm::nalgebra::{Matrix1, Matrix4, RowVector4, Vector4};
use mstmm::prelude::*;
use page::Page;

mstmm_chain! {
    /// A cart on a rail and a pole, which hangs down at the angle zero.
    plane chain CartPole {
        gravity = [0, -9.81] m/s^2;
        answers = linearize;

        body Cart { mass = 1 kg; com = [0, 0] m; output = [0, 0] m; inertia = 0.01 kg*m^2 about com; }
        body Pole { mass = 0.2 kg; com = [0, -0.5] m; inertia = 0.2/3 kg*m^2 about input; }

        ground -> slider(x) rail -> Cart cart -> pin pivot -> Pole pole;

        hinge rail { force = input; }
        hinge pivot { start = 5 deg; }
    }
}

/// The period of the controller in s.
const PERIOD: f64 = 1e-3;

/// Returns the gain of the linear-quadratic regulator for the upright pose.
fn gain(cart_pole: &CartPole<f64>) -> Result<RowVector4<f64>, mstmm::Error> {
    let mut upright = cart_pole.initial_state();
    upright.pivot_mut().set_angle(PI);
    let model = discretize(cart_pole, &upright, &cart_pole.no_inputs(), PERIOD)?;
    // The weights of position, tilt, velocity and rate, and of the force.
    let states = Matrix4::from_diagonal(&Vector4::new(1.0, 10.0, 1.0, 1.0));
    Ok(lqr(&model.a(), &model.b(), &(states * PERIOD), &Matrix1::new(0.1 * PERIOD))?.gain)
}

/// Returns the force on the cart in N.
fn control(gain: &RowVector4<f64>, state: &CartPoleState<f64>) -> CartPoleInputs<f64> {
    let (x, velocity) = (state.rail().position(), state.rail().velocity());
    let (angle, rate) = (state.pivot().angle(), state.pivot().rate());

    let tilt = angle.rem_euclid(2.0 * PI) - PI; // from the upright pose
    let force = if tilt.abs() < 0.4 {
        -(gain * Vector4::new(x, tilt, velocity, rate)).x
    } else {
        // Gives the pole the energy of the upright pose (Åström and Furuta 2000), and keeps the cart near zero.
        let energy = 0.5 * (0.2 / 3.0) * rate.powi(2) - 0.2 * 9.81 * 0.5 * angle.cos();
        let missing = 0.2 * 9.81 * 0.5 - energy;
        (-20.0 * missing * rate * angle.cos()).clamp(-5.0, 5.0) - 2.0 * x - 2.0 * velocity
    };
    CartPoleInputs { rail: force }
}

fn main() -> Result<(), mstmm::Error> {
    let cart_pole = CartPole::<f64>::new();
    let mut state = cart_pole.initial_state();
    let gain = gain(&cart_pole)?;
    let mut page = Page::of(&cart_pole, 20);
    let mut rk4 = Rk4::new(PERIOD);
    for step in 0..15_000 {
        let force = control(&gain, &state);
        page.record(&state, &force)?;
        rk4.step_held(&cart_pole, &mut state, &force)?;
        if step % 1000 == 999 {
            println!(
                "{:3.0} s   cart at {:6.3} m   pole at {:8.2}°",
                state.time(),
                state.rail().position(),
                state.pivot().angle().to_degrees(),
            );
        }
    }

    // The cart is back, and the pole rests upright with the energy m g l of this pose.
    let energy = cart_pole.energy(&state);
    assert!(state.rail().position().abs() < 1e-3);
    assert!((state.pivot().angle().cos() + 1.0).abs() < 1e-6);
    assert!((energy.total() - 0.2 * 9.81 * 0.5).abs() < 1e-5);
    page.write();
    Ok(())
}

#[test]
fn pole_is_balanced() -> Result<(), mstmm::Error> {
    main()
}
