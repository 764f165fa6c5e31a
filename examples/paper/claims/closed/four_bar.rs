//! A planar four-bar that starts with a rotating crank.

use mstmm::Error;
use mstmm::prelude::*;
use nalgebra::Vector2;

use super::comparison::{
    ClosedChainComparison, Motion, Record, STEP, ShownCoordinate, Start, Texts, assembled,
    mark_times, motion,
};
use super::eksergian::{Bar, FourBar as OneEquation};
use crate::output::drawing::{Canvas, Drawing, FROM_BELOW, Point, Side};
use crate::output::progress::Progress;
use crate::system::GRAVITY;

mstmm_chain! {
    /// A crank that can rotate fully, a coupler and a rocker, all of different lengths.
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
/// The number of steps of the reference in one step of generated code.
const REFERENCE_STEPS: usize = 2;

pub fn compare(progress: &Progress) -> Result<ClosedChainComparison, Error> {
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
    let reference = reference();
    let crank = [start.a().angle(), start.a().rate()];

    let accelerations = chain.accelerations(&start, &chain.no_inputs())?;
    Ok(ClosedChainComparison {
        name: "four-bar",
        reference: "one equation",
        start: Start {
            title: "four-bar, accelerations of its bars at the start in rad/s²",
            unit: "rad/s²",
            names: &["crank", "coupler", "rocker"],
            generated: sums([accelerations[0], accelerations[1], accelerations[2]]).to_vec(),
            reference: reference.at(crank).accelerations.to_vec(),
        },
        motion: Motion {
            title: "four-bar, angles of its bars in rad",
            unit: "rad",
            shown: &[
                ShownCoordinate { index: 1, name: "coupler" },
                ShownCoordinate { index: 2, name: "rocker" },
            ],
            generated,
            reference: reference_motion(&reference, crank, progress),
        },
        texts: Texts {
            file_name: "four_bar.svg",
            figure: "Four-bar: angles, and the force at the closing pin",
            caption: "Lines: generated code. Crosses: the one equation of motion of the four-bar, for the \
                      crank angle, with the bars placed by intersecting two circles.",
            axis: "angle in rad",
            note: "The reference has one unknown, the crank's acceleration, no hinges and no loop constraint \
                   that can drift: J θ̈ + ½ J′ θ̇² + V′ = 0, with the bars placed by intersecting two circles. The \
                   force at the closing pin follows from the Newton–Euler equations of coupler and rocker.",
        },
        drawing: drawing(angles(&start)),
    })
}

/// The same four-bar for the reference.
fn reference() -> OneEquation {
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

/// The motion by the reference.
fn reference_motion(four_bar: &OneEquation, start: [f64; 2], progress: &Progress) -> Vec<Record> {
    let mut crank = start;
    let h = STEP / REFERENCE_STEPS as f64;
    let mut done = 0;
    let mut records = Vec::new();
    for time in mark_times() {
        let due = (time / h).round() as usize;
        for _ in done..due {
            crank = four_bar.step(crank, h);
        }
        done = due;
        let instant = four_bar.at(crank);
        // The internal force of the method is that of the rocker on the ground [P, Eq. (14)].
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

/// The absolute angles from the hinge angles.
fn sums([a, b, c]: [f64; 3]) -> [f64; 3] {
    [a, a + b, a + b + c]
}

/// Draws the bars at their absolute angles.
fn drawing(angles: [f64; 3]) -> Drawing {
    let mut canvas = Canvas::new([-0.25, 1.3], [-0.2, 0.75], 420.0);
    let bars = reference().bars;
    let mut points: Vec<Point> = vec![[0.0, 0.0]];
    let mut centres = Vec::new();
    for (k, (bar, angle)) in bars.iter().zip(angles).enumerate() {
        let (sine, cosine) = angle.sin_cos();
        let [x, y] = points[k];
        let at = |[along, across]: Point| {
            [x + along * cosine - across * sine, y + along * sine + across * cosine]
        };
        centres.push(at(bar.com));
        points.push(at([bar.length, 0.0]));
    }
    canvas.support(points[0], FROM_BELOW);
    canvas.support(points[3], FROM_BELOW);
    canvas.body(&[points[1], points[2], centres[1]]);
    points.windows(2).for_each(|ends| canvas.rod(ends[0], ends[1]));
    points.iter().for_each(|&point| canvas.pin(point));
    let names = ["crank", "coupler", "rocker"];
    for ((centre, name), side) in
        centres.iter().zip(names).zip([Side::Left, Side::Above, Side::Right])
    {
        canvas.centre(*centre);
        canvas.text(canvas.beside(*centre, [-2.0, 7.0]), side, name);
    }
    canvas.gravity([1.2, 0.65]);
    canvas.finish(
        "Closed chains: a four-bar",
        "Crank 0.3 m, coupler 0.8 m, rocker 0.6 m, 0.8 m between the pins on the ground. The crank starts with \
         about 3 rad/s.",
    )
}
