//! A robot arm follows a motion by computed torque at 1 kHz, and identifies the payload that it carries.
//!
//! `cargo run --release --example computed_torque`; with `-- --page computed_torque.html` it also writes a page that shows the motion.

mod page;
mod payload_control;
mod plot;

use mstmm::prelude::*;
use page::Page;
use payload_control::{Arm, ArmState, Control, TORQUE_DEVIATION, desired, inputs};
use plot::Plot;

type Joints = payload_control::Joints<f64>;

/// Moves an arm for 6 s, with torques of a controller that are held for 1 ms. Returns the largest error of an angle at
/// each step.
fn follow(arm: &Arm<f64>, control: &mut Control<f64>) -> Result<Vec<[f64; 2]>, mstmm::Error> {
    let mut state = start(arm);
    let (mut torques, mut rk4, mut errors) = (Joints::zeros(), Rk4::new(1e-3), Vec::new());
    for _ in 0..6000 {
        control.torques_into(&state, &mut torques)?;
        // What encoders and torque sensors measure.
        let accelerations = arm.accelerations(&state, &inputs(&torques))?;
        control.observe(&state, &accelerations, &torques)?;
        rk4.step_held(arm, &mut state, &inputs(&torques))?;
        errors.push([state.time(), (state.q - desired(state.time())[0]).amax()]);
    }
    Ok(errors)
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
    let (mut arm, mut control) = (Arm::<f64>::new(), Control::new());
    let (mut state, mut rk4) = (start(&arm), Rk4::new(2.5e-4));
    let mut page = Page::of(&arm, 80);
    let continuous = |state: &ArmState<f64>| {
        let mut torques = Joints::zeros();
        control.torques_into(state, &mut torques).map(|()| inputs(&torques))
    };
    for _ in 0..24_000 {
        page.record(&state, &continuous(&state)?)?;
        rk4.try_step(&arm, &mut state, |_time, state| continuous(state))?;
    }
    page.write();
    let error = (state.q - desired(state.time())[0]).amax();
    println!("continuous torques       {error:.1e} rad");
    assert!(error < 1e-12);

    let exact = follow(&arm, &mut control)?;
    println!("torques held for 1 ms    {:.1e} rad", largest(&exact));

    arm.set_payload(2.0)?;
    control = Control::new();
    let loaded = follow(&arm, &mut control)?;
    let ([mass, _, _, moment, ..], [deviation, ..]) = (control.payload(), control.deviations());
    println!("with an unknown payload  {:.1e} rad", largest(&loaded));
    println!("    the estimate is {mass:.6} kg at a height of {:.6} m", moment / mass);
    println!("    its deviation is {deviation:.0e} kg for torques with {TORQUE_DEVIATION} N m");
    assert!((mass - 2.0).abs() < 1e-6 && (moment / mass - 0.1).abs() < 1e-6);

    control.use_estimate()?;
    let known = follow(&arm, &mut control)?;
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
fn the_last_columns_are_those_of_the_hand() {
    let hand = Arm::<f64>::DYNAMIC_PARAMETERS.last_chunk::<10>().expect("ten columns");
    assert!(hand[0] == "hand.mass" && hand.iter().all(|name| name.starts_with("hand.")));
}

#[test]
fn payload_is_found() -> Result<(), mstmm::Error> {
    study()?.check("computed_torque");
    Ok(())
}
