//! An orientation up to θ₂ = 89.98°, in Bryan angles and in quaternions.
//!
//! The cube of section 4.1 swings on a ball under gravity along −z: at θ₂ = 90° it points
//! straight down. It starts level with a small angular velocity about z, so that it just misses 90°.

mod bryan;
mod swing;

use std::f64::consts::PI;

use mstmm::description::Origin;
use mstmm::prelude::*;
use mstmm::{Chain, Error};

use bryan::{Angles, ByAngles};
use swing::{FALL, Pose, Reference, Swing};

use crate::output::drawing::{Canvas, Drawing, FROM_LEFT, Side};
use crate::output::log_figure::{LogFigure, Series, SeriesStyle};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::section::{Measurement, SectionResult};
use crate::verdict::{Bound, Check, Verdict};

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

/// The number of parts that the progress bar counts.
pub const MOTIONS: usize = STEPS.len() + OTHERS;
const OTHERS: usize = 5;

const FIGURE: &str = "orientation.svg";

/// The end of all swings in s. By then the cube has passed the lowest point twice.
const END: f64 = 2.0;
/// The largest θ₂ in degrees.
const HIGHEST: f64 = 89.98;
/// Steps in s. All divide [`END`].
const STEPS: [f64; 10] = [2e-2, 1e-2, 5e-3, 1e-3, 5e-4, 1e-4, 5e-5, 2e-5, 1e-5, 5e-6];
/// The step in s for the comparison of swings.
const STEP: f64 = 1e-3;

/// The errors at the end; NaN if the run stopped because a value was not finite.
#[derive(Clone, Copy)]
struct Errors {
    /// In rad.
    orientation: f64,
    /// The error of the angular velocity in rad/s.
    angular_velocity: f64,
    /// The largest energy drift, relative to the largest kinetic energy.
    energy: f64,
}

impl Errors {
    const NOT_FINITE: Errors =
        Errors { orientation: f64::NAN, angular_velocity: f64::NAN, energy: f64::NAN };
}

/// The errors of the same swing in both representations.
struct SwingErrors {
    angles: Errors,
    quaternions: Errors,
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let swing = Swing::up_to(HIGHEST);
    let reference = swing.reference().ok_or(Error::NotFinite(Origin::Result))?;
    let mut by_step = Vec::new();
    for step in STEPS {
        progress.begin(&format!("orientation: step {step} s"));
        by_step.push(swing_errors(&swing, &reference.end, step)?);
    }
    let figure = figure(&by_step);
    let tables = vec![by_steps(&by_step, &reference), by_swings(progress)?];
    let measurements =
        vec![Measurement { text: longest_finite_step(&by_step), figure: Some(FIGURE) }];
    Ok(SectionResult {
        drawings: vec![drawing()],
        tables,
        log_figures: vec![figure],
        measurements,
        ..SectionResult::default()
    })
}

/// States the longest step at which Bryan angles stay finite, and their error there.
fn longest_finite_step(by_step: &[SwingErrors]) -> String {
    let finished =
        STEPS.iter().zip(by_step).find(|(_, errors)| errors.angles.orientation.is_finite());
    match finished {
        Some((step, errors)) => format!(
            "Bryan angles: not finite for steps > {step:e} s; error there {:.1} rad",
            errors.angles.orientation
        ),
        None => "Bryan angles fail for all steps".into(),
    }
}

/// Computes a swing in both representations.
fn swing_errors(swing: &Swing, reference: &Pose, step: f64) -> Result<SwingErrors, Error> {
    let top = Top::new();
    let angles = Angles::level(swing.start);
    let mut state = top.initial_state();
    // In the level position, the body's axes are the inertial axes.
    state.joint_mut().set_rate(swing.start);
    Ok(SwingErrors {
        angles: integrate(&ByAngles(&top), angles, step, Angles::as_top, reference)?,
        quaternions: integrate(&top, state, step, TopState::clone, reference)?,
    })
}

/// Integrates a swing in equal steps and returns its errors.
fn integrate<C: Chain<Scalar = f64, Inputs = TopInputs<f64>>>(
    chain: &C,
    mut state: C::State,
    step: f64,
    as_top: impl Fn(&C::State) -> TopState<f64>,
    reference: &Pose,
) -> Result<Errors, Error> {
    let top = Top::new();
    let energy = |state: &C::State| top.energy(&as_top(state)).total();
    let (first, mut largest) = (energy(&state), 0.0_f64);
    let mut rk4 = Rk4::new(step);
    for _ in 0..(END / step).round() as usize {
        match rk4.step(chain, &mut state, |_time, _state| top.no_inputs()) {
            Ok(()) => (),
            Err(Error::NotFinite(_)) => return Ok(Errors::NOT_FINITE),
            Err(other) => return Err(other),
        }
        largest = largest.max((energy(&state) - first).abs());
    }
    let end = as_top(&state);
    let (orientation, rate) = (end.joint().orientation(), end.joint().rate());
    Ok(Errors {
        orientation: orientation.angle_to(&reference.orientation),
        angular_velocity: (orientation * rate - reference.angular_velocity).norm(),
        energy: largest / FALL,
    })
}

fn by_steps(errors: &[SwingErrors], reference: &Reference) -> ResultTable {
    let row = |name: &str, value: fn(&SwingErrors) -> f64| Row {
        name: name.to_owned(),
        values: errors.iter().map(value).collect(),
    };
    let check =
        |what: &str, size, unit| Check { what: what.into(), size, unit, bound: Bound::Tolerance };
    let at_step = STEPS.iter().position(|step| *step == STEP).map(|k| &errors[k]);
    let error = at_step.map_or(f64::NAN, |errors| errors.quaternions.orientation);
    ResultTable {
        section: "Orientation",
        title: "a swing through θ₂ = 89.98°, errors after 2 s against the step, Runge–Kutta 4",
        columns: STEPS.iter().map(|step| format!("{step:e} s")).collect(),
        rows: vec![
            row("orientation in rad, Bryan angles", |errors| errors.angles.orientation),
            row("orientation in rad, quaternions", |errors| errors.quaternions.orientation),
            row("angular velocity in rad/s, Bryan angles", |errors| errors.angles.angular_velocity),
            row("angular velocity in rad/s, quaternions", |errors| {
                errors.quaternions.angular_velocity
            }),
            row("energy drift, of the largest, Bryan angles", |errors| errors.angles.energy),
            row("energy drift, of the largest, quaternions", |errors| errors.quaternions.energy),
        ],
        note: "Both representations use Ω̇ from the same generated code and the same integrator. The state of one is \
               the Bryan angles and their rates, as in the paper; the state of the other is a quaternion and the \
               angular velocity. Near 90° the rates of two Bryan angles reach 14 000 rad/s for about 0.1 ms, although \
               the cube rotates at 5 rad/s. With long steps the values grow until they are not finite, and the step \
               returns an error (–). With short steps they are correct, with thousands of times as many steps for \
               the same error.",
        verdicts: vec![
            Verdict {
                compared: "quaternions – Newton–Euler, 89.98°".into(),
                figure: Some(FIGURE),
                checks: vec![check("quaternions, step 1 ms, to the reference", error, "rad")],
            },
            Verdict {
                compared: "Newton–Euler: energy, angular momentum about z".into(),
                figure: None,
                checks: vec![
                    check("the reference's energy, from start to end", reference.energy, "J"),
                    check("the reference's momentum about z", reference.momentum, "N m s"),
                ],
            },
        ],
    }
}

/// The errors of swings near 90° and far from it, with the same step.
fn by_swings(progress: &Progress) -> Result<ResultTable, Error> {
    let mut rows = Vec::new();
    let mut checks = Vec::new();
    let upwards = [60.0, 89.0, HIGHEST].map(Swing::up_to);
    let swings = upwards.into_iter().chain([Swing::through(), Swing::in_plane()]);
    for swing in swings {
        progress.begin(&format!("orientation: {}", swing.name));
        let reference = swing.reference().ok_or(Error::NotFinite(Origin::Result))?;
        let SwingErrors { angles, quaternions } = swing_errors(&swing, &reference.end, STEP)?;
        checks.push(Check {
            what: format!("quaternions, {}", swing.name),
            size: quaternions.orientation,
            unit: "rad",
            bound: Bound::Tolerance,
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
    Ok(ResultTable {
        section: "Orientation",
        title: "errors of the orientation in rad and energy drift, step 1 ms",
        columns: columns.map(str::to_owned).into(),
        rows,
        note: "Up to 60° both representations are accurate; the error of Bryan angles is twenty times as large. Through \
               90° Bryan angles fail (–), except in a planar swing, where only one angle changes: there they are as \
               accurate as quaternions. Quaternions have the same accuracy for all swings.",
        verdicts: vec![Verdict {
            compared: "quaternions – Newton–Euler, five swings".into(),
            figure: None,
            checks,
        }],
    })
}

fn figure(errors: &[SwingErrors]) -> LogFigure {
    let points = |error: fn(&SwingErrors) -> f64| {
        let points = STEPS.into_iter().zip(errors.iter().map(error));
        points.filter(|(_, error)| *error > 0.0).collect()
    };
    LogFigure {
        file_name: FIGURE,
        title: "Error of the orientation after a swing through θ₂ = 89.98°",
        caption: "Crosses: Bryan angles and their rates as the state, as in the paper. Line: quaternions. Both with \
                  the same integrator and the same generated code. Without a cross the run stopped, because a value \
                  was not finite.",
        x: "step in s",
        y: "error in rad",
        series: vec![
            Series {
                label: "Bryan angles (no cross: the run stopped)",
                style: SeriesStyle::Crosses,
                points: points(|errors| errors.angles.orientation),
            },
            Series {
                label: "quaternions",
                style: SeriesStyle::Line,
                points: points(|errors| errors.quaternions.orientation),
            },
        ],
    }
}

fn drawing() -> Drawing {
    let mut canvas = Canvas::new([-1.2, 1.9], [-1.2, 0.75], 420.0);
    let hinge = [0.0, 0.0];
    canvas.support(hinge, FROM_LEFT);
    canvas.dashed(&[[-0.5, 0.0], [0.5, 0.0], [0.5, -1.0], [-0.5, -1.0], [-0.5, 0.0]]);
    canvas.text([0.0, -0.6], Side::Centre, "θ₂ = 90°");
    canvas.body(&[[0.0, -0.5], [1.0, -0.5], [1.0, 0.5], [0.0, 0.5]]);
    canvas.centre([0.5, 0.0]);
    canvas.ball(hinge);
    canvas.rotation(hinge, [24.0, 24.0], [-0.1 * PI, -0.4 * PI]);
    canvas.text([0.22, -0.22], Side::Right, "θ₂");
    canvas.gravity([1.5, 0.2]);
    canvas.finish(
        "Orientation: a cube on a ball",
        "The cube of section 4.1 starts level, with a small angular velocity about the vertical axis z; x is to the \
         right. Dashed: the lowest position, θ₂ = 90°.",
    )
}
