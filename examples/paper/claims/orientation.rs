//! An orientation through θ₂ = 89.98°, in Bryan angles and in quaternions.
//!
//! The cube of section 4.1 hangs on a ball and swings under gravity along −z, so that θ₂ = 90° is
//! where it points straight down. It begins level with a little turn about z, by which it just misses
//! that.

mod bryan;
mod swing;

use mstmm::prelude::*;
use mstmm::{Chain, Error};

use bryan::{Angles, ByAngles};
use swing::{FALL, Pose, Reference, Swing};

use crate::output::exhibit::{Exhibit, KnownDifference, Row};
use crate::output::log_plot::{LogFigure, Series, Way};
use crate::output::progress::Progress;
use crate::section::Outcome;

mstmm_chain! {
    /// The cube on a ball.
    pub chain Top {
        gravity = [0, 0, -9.8] m/s^2;
        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }
        ground -> ball joint -> Cube cube;
    }
}

/// How many parts the progress counts.
pub const MOTIONS: usize = STEPS.len() + OTHERS;
const OTHERS: usize = 5;

/// The end of all swings in s: the cube has passed the lowest point twice.
const END: f64 = 2.0;
/// The largest θ₂ in degrees.
const HIGHEST: f64 = 89.98;
/// Steps in s, which divide the end.
const STEPS: [f64; 10] = [2e-2, 1e-2, 5e-3, 1e-3, 5e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6];
/// The step in s at which other swings are compared.
const STEP: f64 = 1e-3;

/// How far a way is off at the end; not numbers where its own ceased to be finite before.
#[derive(Clone, Copy)]
struct Off {
    /// In rad.
    orientation: f64,
    /// Of the angular velocity in rad/s.
    spin: f64,
    /// The largest change of the energy on the way, of the largest kinetic energy.
    energy: f64,
}

impl Off {
    const NOT_FINITE: Off = Off { orientation: f64::NAN, spin: f64::NAN, energy: f64::NAN };
}

/// The same swing by both ways.
struct Both {
    angles: Off,
    quaternions: Off,
}

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let swing = Swing::up_to(HIGHEST);
    let reference = swing.reference().ok_or(Error::NotFinite)?;
    let mut by_step = Vec::new();
    for step in STEPS {
        progress.begin(&format!("orientation: step {step} s"));
        by_step.push(both(&swing, &reference.end, step)?);
    }
    let figure = figure(&by_step);
    let exhibits = vec![by_steps(&by_step, &reference), by_swings(progress)?];
    Ok(Outcome { exhibits, log_figures: vec![figure], ..Outcome::default() })
}

/// A swing by both ways.
fn both(swing: &Swing, truth: &Pose, step: f64) -> Result<Both, Error> {
    let top = Top::new();
    let angles = Angles::level(swing.start);
    let mut state = top.initial_state();
    // Level, the axes of the body are the inertial ones.
    state.joint_mut().set_rate(swing.start);
    Ok(Both {
        angles: follow(&ByAngles(&top), angles, step, Angles::as_top, truth)?,
        quaternions: follow(&top, state, step, TopState::clone, truth)?,
    })
}

/// Integrates a swing in steps of a size and tells how far it is off.
fn follow<C: Chain<Scalar = f64, Inputs = TopInputs<f64>>>(
    chain: &C,
    mut state: C::State,
    step: f64,
    as_top: impl Fn(&C::State) -> TopState<f64>,
    truth: &Pose,
) -> Result<Off, Error> {
    let top = Top::new();
    let energy = |state: &C::State| top.energy(&as_top(state)).total();
    let (first, mut largest) = (energy(&state), 0.0_f64);
    let mut rk4 = Rk4::new(step);
    for _ in 0..(END / step).round() as usize {
        match rk4.step(chain, &mut state, |_time, _state| top.no_inputs()) {
            Ok(()) => (),
            Err(Error::NotFinite) => return Ok(Off::NOT_FINITE),
            Err(other) => return Err(other),
        }
        largest = largest.max((energy(&state) - first).abs());
    }
    let end = as_top(&state);
    let (orientation, rate) = (end.joint().orientation(), end.joint().rate());
    Ok(Off {
        orientation: orientation.angle_to(&truth.orientation),
        spin: (orientation * rate - truth.spin).norm(),
        energy: largest / FALL,
    })
}

fn by_steps(found: &[Both], reference: &Reference) -> Exhibit {
    let row = |name: &str, value: fn(&Both) -> f64| Row {
        name: name.to_owned(),
        values: found.iter().map(value).collect(),
    };
    let difference = |what: &str, size, unit| KnownDifference { what: what.into(), size, unit };
    let at_step = STEPS.iter().position(|step| *step == STEP).map(|k| &found[k]);
    let off = at_step.map_or(f64::NAN, |both| both.quaternions.orientation);
    Exhibit {
        section: "Orientation",
        title: "a swing through θ₂ = 89.98°, errors after 2 s against the step, Runge–Kutta 4",
        columns: STEPS.iter().map(|step| format!("{step:e} s")).collect(),
        rows: vec![
            row("orientation in rad, Bryan angles", |both| both.angles.orientation),
            row("orientation in rad, quaternions", |both| both.quaternions.orientation),
            row("angular velocity in rad/s, Bryan angles", |both| both.angles.spin),
            row("angular velocity in rad/s, quaternions", |both| both.quaternions.spin),
            row("energy drift, of the largest, Bryan angles", |both| both.angles.energy),
            row("energy drift, of the largest, quaternions", |both| both.quaternions.energy),
        ],
        says: vec![
            "Both ways take Ω̇ from the same generated code and steps from the same integrator. One keeps Bryan",
            "angles and their rates, as the paper does, the other a quaternion and the angular velocity. Near 90°",
            "two of the angles turn at up to 14 000 rad/s for about 0.1 ms, although the cube turns at 5 rad/s.",
            "With longer steps their numbers grow until they are finite no longer, and a step says so (–); with",
            "shorter ones they come out right, after thousands of times as many steps for the same error.",
        ],
        differences: vec![
            difference("quaternions, step 1 ms, to the reference", off, "rad"),
            difference("the reference's energy, from start to end", reference.energy, "J"),
            difference("the reference's momentum about z", reference.momentum, "N m s"),
        ],
        faults: Vec::new(),
    }
}

/// Swings near 90° and far from it, with the same step.
fn by_swings(progress: &Progress) -> Result<Exhibit, Error> {
    let mut rows = Vec::new();
    let mut differences = Vec::new();
    let upwards = [60.0, 89.0, HIGHEST].map(Swing::up_to);
    let swings = upwards.into_iter().chain([Swing::through(), Swing::in_plane()]);
    for swing in swings {
        progress.begin(&format!("orientation: {}", swing.name));
        let reference = swing.reference().ok_or(Error::NotFinite)?;
        let Both { angles, quaternions } = both(&swing, &reference.end, STEP)?;
        differences.push(KnownDifference {
            what: format!("quaternions, {}", swing.name),
            size: quaternions.orientation,
            unit: "rad",
        });
        rows.push(Row {
            name: swing.name,
            values: vec![
                angles.orientation,
                quaternions.orientation,
                angles.energy,
                quaternions.energy,
            ],
        });
    }
    let columns = ["angles", "quaternions", "drift, angles", "drift, quat."];
    Ok(Exhibit {
        section: "Orientation",
        title: "errors of the orientation in rad and energy drift, step 1 ms",
        columns: columns.map(str::to_owned).into(),
        rows,
        says: vec![
            "Up to 60° both ways do, the error of Bryan angles being twenty times as large. Through 90° they fail",
            "(–), but for a swing in a plane, where nothing else turns: there they are as good as quaternions.",
            "To quaternions all swings are alike.",
        ],
        differences,
        faults: Vec::new(),
    })
}

fn figure(found: &[Both]) -> LogFigure {
    let points = |error: fn(&Both) -> f64| {
        let all = STEPS.into_iter().zip(found.iter().map(error));
        all.filter(|(_, error)| *error > 0.0).collect()
    };
    LogFigure {
        file_name: "orientation.svg",
        title: "Error of the orientation after a swing through θ₂ = 89.98°",
        says: "Crosses are Bryan angles and their rates as the state, as in the paper, dots a quaternion, both with \
               the same integrator and the same generated code. Without a cross the run broke off: the numbers \
               were finite no longer.",
        x: "step in s",
        y: "error in rad",
        series: vec![
            Series {
                label: "Bryan angles (no cross: it broke off)",
                way: Way::Rival,
                points: points(|both| both.angles.orientation),
            },
            Series {
                label: "quaternions",
                way: Way::Method,
                points: points(|both| both.quaternions.orientation),
            },
        ],
    }
}
