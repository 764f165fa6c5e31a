//! A robot arm follows a motion by computed torque at 1 kHz, and identifies the payload that it carries.
//!
//! `cargo run --release --example computed_torque`; with `-- --page computed_torque.html` it also writes a page that shows the motion.

mod page;
mod plot;

use mstmm::linear::solve_positive_definite;
use mstmm::nalgebra::{SMatrix, SVector};
use mstmm::prelude::*;
use page::Page;
use plot::Plot;

include!("panda.rs");

panda! {
    /// The Franka Emika Panda with a hand, which holds a payload of small size at its centre of mass.
    pub chain Arm {
        bodies {
            answers = [inverse_dynamics, regressor];
            param payload = 0 kg;
            body Hand { mass = 0.7 kg + payload; com = [0, 0, 0.1] m; inertia = diag(2, 2, 1) g*m^2 about com; }
        }
        route { -> weld flange -> Hand hand }
    }
}

type Joints = SVector<f64, 7>;

/// The middle and the amplitude of the motion of each joint in rad.
const MIDDLE: [f64; 7] = [0.0, -0.5, 0.0, -2.0, 0.0, 1.6, 0.8];
const AMPLITUDE: [f64; 7] = [0.6, 0.4, 0.5, 0.4, 0.6, 0.5, 0.7];

/// Returns angles, rates and accelerations of the desired motion.
fn desired(time: f64) -> [Joints; 3] {
    let omega = |i: usize| 1.0 + 0.3 * i as f64;
    let phase = |i: usize| (omega(i) * time).sin_cos();
    [
        Joints::from_fn(|i, _| MIDDLE[i] + AMPLITUDE[i] * phase(i).0),
        Joints::from_fn(|i, _| AMPLITUDE[i] * omega(i) * phase(i).1),
        Joints::from_fn(|i, _| -AMPLITUDE[i] * omega(i).powi(2) * phase(i).0),
    ]
}

/// Returns the torques by which a model follows the desired motion: those of inverse dynamics for the desired
/// accelerations and a correction, by which an error decays as e^(-20 t).
fn control(model: &Arm<f64>, state: &ArmState<f64>) -> Result<Joints, mstmm::Error> {
    let [q, v, a] = desired(state.time());
    let commanded = a + (v - state.v) * 40.0 + (q - state.q) * 400.0;
    model.inverse_dynamics(state, &commanded, &model.no_inputs())
}

fn inputs(torques: Joints) -> ArmInputs<f64> {
    let [j1, j2, j3, j4, j5, j6, j7] = torques.into();
    ArmInputs { j1, j2, j3, j4, j5, j6, j7 }
}

/// Moves an arm for 6 s, with torques that a model computes and that are held for 1 ms. Returns the largest
/// error of an angle at each step, and the dynamic parameters that the hand of the model lacks, by least squares.
fn follow(
    arm: &Arm<f64>,
    model: &Arm<f64>,
) -> Result<(Vec<[f64; 2]>, SVector<f64, 10>), mstmm::Error> {
    // The columns of the hand: its mass, its first moments and its inertia.
    let names = Arm::<f64>::DYNAMIC_PARAMETERS;
    let hand = names.iter().take_while(|name| !name.starts_with("hand.")).count();
    let (mut normal, mut right) = (SMatrix::<f64, 10, 10>::zeros(), SVector::zeros());

    let mut state = start(arm);
    let (mut rk4, mut errors) = (Rk4::new(1e-3), Vec::new());
    for _ in 0..6000 {
        let torques = control(model, &state)?;
        // What encoders and torque sensors measure, compared with the model.
        let accelerations = arm.accelerations(&state, &inputs(torques))?;
        let expected = model.inverse_dynamics(&state, &accelerations, &model.no_inputs())?;
        let regressor = model.regressor(&state, &accelerations, &model.no_inputs())?;
        let columns = regressor.fixed_columns::<10>(hand);
        normal += columns.tr_mul(&columns);
        right += columns.tr_mul(&(torques - expected));

        rk4.step_held(arm, &mut state, &inputs(torques))?;
        errors.push([state.time(), (state.q - desired(state.time())[0]).amax()]);
    }
    Ok((errors, solve_positive_definite(&normal, &right)?))
}

/// Returns the state on the desired motion at the time 0.
fn start(arm: &Arm<f64>) -> ArmState<f64> {
    let mut state = arm.initial_state();
    [state.q, state.v, _] = desired(0.0);
    state
}

fn largest(errors: &[[f64; 2]]) -> f64 {
    errors.iter().fold(0.0, |largest, error| error[1].max(largest))
}

/// Runs the study and returns its picture.
fn study() -> Result<Plot, mstmm::Error> {
    // Computed torque cancels the dynamics: only the errors of the integrator remain.
    let mut model = Arm::<f64>::new();
    let (mut state, mut rk4) = (start(&model), Rk4::new(2.5e-4));
    let mut page = Page::of(&model, 80);
    for _ in 0..24_000 {
        page.record(&state, &inputs(control(&model, &state)?))?;
        rk4.try_step(&model, &mut state, |_time, state| control(&model, state).map(inputs))?;
    }
    page.write();
    let error = (state.q - desired(state.time())[0]).amax();
    println!("continuous torques       {error:.1e} rad");
    assert!(error < 1e-12);

    let (exact, _) = follow(&model, &model)?;
    println!("torques held for 1 ms    {:.1e} rad", largest(&exact));

    let mut arm = model.clone();
    arm.set_payload(2.0)?;
    let (loaded, found) = follow(&arm, &model)?;
    let (payload, height) = (found[0], found[3] / found[0]);
    println!("with an unknown payload  {:.1e} rad", largest(&loaded));
    println!("    the regressor finds {payload:.6} kg at a height of {height:.6} m");
    assert!((payload - 2.0).abs() < 1e-6 && (height - 0.1).abs() < 1e-6);

    model.set_payload(payload)?;
    let (known, _) = follow(&arm, &model)?;
    println!("with the payload known   {:.1e} rad", largest(&known));
    assert!(largest(&loaded) > 20.0 * largest(&known));

    let in_mrad = |errors: Vec<[f64; 2]>| {
        errors.iter().step_by(25).map(|[time, error]| [*time, 1e3 * error]).collect()
    };
    Ok(Plot::new("Largest error of an angle of the Panda", ["time in s", "error in mrad"])
        .curve("payload of 2 kg unknown", in_mrad(loaded))
        .curve("payload known", in_mrad(known)))
}

fn main() -> Result<(), mstmm::Error> {
    study()?.save("computed_torque");
    Ok(())
}

#[test]
fn payload_is_found() -> Result<(), mstmm::Error> {
    study()?.check("computed_torque");
    Ok(())
}
