//! A four-bar in the plane, let go with its crank turning.

use mstmm::Error;
use mstmm::prelude::*;
use nalgebra::Vector2;

use super::beside::{
    Beside, Motion, Record, STEP, Shown, Start, Words, assembled, mark_times, motion,
};
use super::eksergian::{Bar, FourBar as OneEquation};
use crate::output::progress::Progress;
use crate::system::GRAVITY;

mstmm_chain! {
    /// A crank that can turn fully, a coupler and a rocker, none of the same length.
    plane chain FourBar {
        gravity = [0, -9.8] m/s^2;
        body Crank {
            mass = 1 kg; com = [0.15, 0] m; inertia = 0.02 kg*m^2 about com; output = [0.3, 0] m;
        }
        body Coupler {
            mass = 2 kg; com = [0.4, 0.1] m; inertia = 0.15 kg*m^2 about com; output = [0.8, 0] m;
        }
        body Rocker {
            mass = 1.5 kg; com = [0.3, 0] m; inertia = 0.1 kg*m^2 about com; output = [0.6, 0] m;
        }
        ground -> pin a -> Crank crank -> pin b -> Coupler coupler -> pin c -> Rocker rocker
               -> pin d -> ground at [0.8, 0] m;
        hinge a { start = 60 deg; start_rate = 3 rad/s; }
        hinge b { start = -50 deg; }
        hinge c { start = -120 deg; }
        hinge d { start = 100 deg; }
    }
}

/// From pin to pin on the ground in m.
const BASE: f64 = 0.8;
/// The steps of the rival in one of generated code.
const FINER: usize = 2;

pub fn beside(progress: &Progress) -> Result<Beside, Error> {
    let chain = FourBar::<f64>::new();
    let start = assembled(&chain)?;
    progress.begin("closed: four-bar, generated code");
    let mut at = chain.workspace();
    let generated = motion(&chain, &start, progress, |time, state| {
        chain.solve_into(state, &chain.no_inputs(), &mut at)?;
        let end = at.d().input();
        let record = Record {
            time,
            coordinates: angles(state).to_vec(),
            force: end.force().as_slice().into(),
        };
        Ok((record, (end.position() - Vector2::new(BASE, 0.0)).norm()))
    })?;
    progress.begin("closed: four-bar, one equation of motion");
    let one_equation = one_equation();
    let crank = [start.a().angle(), start.a().rate()];

    let accelerations = chain.accelerations(&start, &chain.no_inputs())?;
    Ok(Beside {
        name: "four-bar",
        rival: "one equation",
        start: Start {
            title: "four-bar, accelerations of its bars at the start in rad/s²",
            unit: "rad/s²",
            names: &["crank", "coupler", "rocker"],
            generated: sums([accelerations[0], accelerations[1], accelerations[2]]).to_vec(),
            rival: one_equation.at(crank).accelerations.to_vec(),
        },
        motion: Motion {
            title: "four-bar, angles of its bars in rad",
            unit: "rad",
            shown: &[Shown { place: 1, name: "coupler" }, Shown { place: 2, name: "rocker" }],
            generated,
            rival: moved(&one_equation, crank, progress),
        },
        words: Words {
            file_name: "four_bar.svg",
            figure: "A four-bar closed over ground: angles, and the force at the closing pin",
            figure_says: "Lines are generated code, crosses the four-bar's one equation of motion \
                          for the angle of its crank, with its bars placed by intersecting circles.",
            axis: "angle in rad",
            says: vec![
                "The rival has one unknown, the crank's acceleration, no hinges and no closure to",
                "drift from: J θ̈ + ½ J′ θ̇² + V′ = 0 with the bars placed by intersecting circles, and",
                "forces by Newton and Euler afterwards. Motion and force are the same.",
            ],
        },
    })
}

/// The same four-bar as its rival takes it.
fn one_equation() -> OneEquation {
    OneEquation {
        bars: [
            Bar { length: 0.3, mass: 1.0, com: [0.15, 0.0], inertia: 0.02 },
            Bar { length: 0.8, mass: 2.0, com: [0.4, 0.1], inertia: 0.15 },
            Bar { length: 0.6, mass: 1.5, com: [0.3, 0.0], inertia: 0.1 },
        ],
        base: BASE,
        gravity: GRAVITY,
    }
}

/// The rival's motion.
fn moved(four_bar: &OneEquation, start: [f64; 2], progress: &Progress) -> Vec<Record> {
    let mut crank = start;
    let h = STEP / FINER as f64;
    let mut done = 0;
    let mut records = Vec::new();
    for time in mark_times() {
        let due = (time / h).round() as usize;
        for _ in done..due {
            crank = four_bar.step(crank, h);
        }
        done = due;
        let instant = four_bar.at(crank);
        // The method's force is what the rocker does to the ground [P, Eq. (14)].
        let force = (-instant.force).as_slice().into();
        records.push(Record { time, coordinates: instant.angles.to_vec(), force });
        progress.reach(time);
    }
    records
}

/// Absolute angles of the bars.
fn angles(state: &FourBarState<f64>) -> [f64; 3] {
    sums([state.a().angle(), state.b().angle(), state.c().angle()])
}

/// From hinges to bars.
fn sums([a, b, c]: [f64; 3]) -> [f64; 3] {
    [a, a + b, a + b + c]
}
