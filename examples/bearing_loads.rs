//! The loads on the two bearings of a rotor that runs up on a turntable.
//!
//! `cargo run --release --example bearing_loads`; with `-- --page bearing_loads.html` it also writes a page that shows the motion.

mod page;
mod plot;

use std::f64::consts::FRAC_PI_2;

use mstmm::nalgebra::{Vector2, Vector3};
use mstmm::prelude::*;
use page::Page;
use plot::Plot;

const MASS: f64 = 12.0; // kg
const ECCENTRICITY: f64 = 0.1e-3; // m, of the rotor's centre of mass
const POLAR: f64 = 0.06; // kg m^2, the rotor's moment of inertia about its axis
const HALF_SPAN: f64 = 0.15; // m, from the middle of the rotor to each bearing

mstmm_chain! {
    /// A turntable with a vertical axis, and a rotor with a horizontal axis and its centre over that of the table.
    chain Gyro {
        gravity = [0, 0, -9.81] m/s^2;
        answers = inverse_dynamics;

        body Table {
            mass = 30 kg;
            com = [0, 0, 0] m;
            output = [0, 0, 0.4] m;
            inertia = diag(1, 1, 2) kg*m^2 about com;
        }
        body Rotor {
            mass = MASS;
            com = [0, ECCENTRICITY, 0];
            inertia = diag(POLAR, 0.04 kg*m^2, 0.04 kg*m^2) about com;
        }

        ground -> pin(z) table -> Table plate -> pin(x) axle -> Rotor rotor;

        hinge table, axle { torque = input; }
    }
}

/// The table rotates at a constant rate, and the rotor runs up with a constant acceleration for 2 s.
const TABLE_RATE: f64 = 1.5; // rad/s
const ROTOR_ACCELERATION: f64 = 150.0; // rad/s^2
const RUN_UP: f64 = 2.0; // s

/// Returns state and accelerations at a time.
fn motion(gyro: &Gyro<f64>, time: f64) -> (GyroState<f64>, Vector2<f64>) {
    let mut state = gyro.initial_state();
    let (running, steady) = (time.min(RUN_UP), (time - RUN_UP).max(0.0));
    let rate = ROTOR_ACCELERATION * running;
    state.table_mut().set_angle(TABLE_RATE * time).set_rate(TABLE_RATE);
    state.axle_mut().set_angle(0.5 * rate * running + rate * steady).set_rate(rate);
    (state, Vector2::new(0.0, if time < RUN_UP { ROTOR_ACCELERATION } else { 0.0 }))
}

/// Returns the radial forces in N that the bearings exert on the rotor, from force and moment in the axle.
fn bearings(at: &GyroWorkspace<f64>) -> [f64; 2] {
    let axle = at.rotor().input();
    let axis = axle.orientation() * Vector3::x();
    // The forces F/2 ± D at the ends of the arms ± b have the moment 2 b axis × D. At its input -moment acts on a body.
    let difference = axis.cross(&axle.moment()) / (2.0 * HALF_SPAN);
    [1.0, -1.0].map(|side| {
        let force = axle.force() / 2.0 + difference * side;
        (force - axis * force.dot(&axis)).norm()
    })
}

/// Runs the study and returns its picture.
fn study() -> Result<Plot, mstmm::Error> {
    let gyro = Gyro::<f64>::new();
    let mut at = gyro.workspace();
    let mut loads = |time: f64| {
        let (state, accelerations) = motion(&gyro, time);
        gyro.inverse_solve_into(&state, &accelerations, &gyro.no_inputs(), &mut at)?;
        Ok::<_, mstmm::Error>((bearings(&at), state.axle().angle()))
    };

    // The page has the first tenth of the motion, with the torques that it needs.
    let mut page = Page::of(&gyro, 1);
    for frame in 0..500 {
        let (mut state, accelerations) = motion(&gyro, 5e-4 * frame as f64);
        state.set_time(5e-4 * frame as f64);
        let torques = gyro.inverse_dynamics(&state, &accelerations, &gyro.no_inputs())?;
        let [table, axle] = torques.into();
        page.record(&state, &GyroInputs { table, axle })?;
    }
    page.write();

    // The picture has the largest force of each bearing within 0.1 s, which is more than a revolution after 0.42 s.
    let mut curves = [Vec::new(), Vec::new()];
    let mut largest = (0.0, 0.0);
    for window in 0..25 {
        let mut within = [0.0, 0.0];
        for step in 0..800 {
            let (forces, angle) = loads(0.1 * window as f64 + 125e-6 * step as f64)?;
            for (force, within) in forces.into_iter().zip(&mut within) {
                *within = force.max(*within);
                if force > largest.0 {
                    largest = (force, angle);
                }
            }
        }
        let time = 0.1 * (window as f64 + 0.5);
        curves.iter_mut().zip(within).for_each(|(curve, force)| curve.push([time, force]));
    }
    println!("largest radial force {:.1} N", largest.0);

    // In closed form: half of weight and centrifugal force, and the gyroscopic moment over the span. Both are largest
    // when the centre of mass is below the axis.
    let (omega, eccentricity) = (ROTOR_ACCELERATION * RUN_UP, ECCENTRICITY);
    let gyroscopic = POLAR * omega * TABLE_RATE;
    let coriolis = 2.0 * MASS * eccentricity.powi(2) * omega * TABLE_RATE;
    let vertical = MASS * (9.81 + eccentricity * omega.powi(2));
    let expected = vertical / 2.0 + (gyroscopic + coriolis) / (2.0 * HALF_SPAN);
    println!("in closed form       {expected:.1} N");
    let turns = ((largest.1 + FRAC_PI_2) / std::f64::consts::TAU).round();
    let below = turns * std::f64::consts::TAU - FRAC_PI_2;
    let at_rate = RUN_UP + (below - 0.5 * omega * RUN_UP) / omega;
    let ([a, b], _) = loads(at_rate)?;
    assert!((a.max(b) - expected).abs() < 1e-9 * expected);
    // The samples are at most half a step away from this position.
    assert!(largest.0 <= a.max(b) && largest.0 > expected * f64::cos(omega * 63e-6));

    let [plus, minus] = curves;
    Ok(Plot::new("Radial forces of the bearings of a rotor", ["time in s", "largest force in N"])
        .curve("bearing at +x", plus)
        .curve("bearing at −x", minus))
}

fn main() -> Result<(), mstmm::Error> {
    study()?.save("bearing_loads");
    Ok(())
}

#[test]
fn largest_force_has_its_closed_form() -> Result<(), mstmm::Error> {
    study()?.check("bearing_loads");
    Ok(())
}
