//! Section 4.3, Table 1: the errors of the first steps of a pendulum, by the paper's method and by the
//! original discrete-time method (MSDTTMM) that it replaces.

use std::f64::consts::PI;

use mstmm::Error;
use mstmm::prelude::*;

use crate::msdttmm::Rod;
use crate::output::drawing::{Canvas, Drawing, FROM_ABOVE, Side};
use crate::output::progress::Progress;
use crate::output::result_table::{ResultTable, Row};
use crate::section::SectionResult;
use crate::system::GRAVITY;
use crate::verdict::{Bound, Check, Verdict};

mstmm_chain! {
    /// A homogeneous rod of 1 m and 1 kg.
    pub plane chain Pendulum {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1/3 kg*m^2 about input; }
        ground -> pin joint -> Rod rod;
    }
}

/// The steps of the reference and of the compared methods in s.
const FINE: f64 = 1e-3;
const COARSE: f64 = 0.1;
/// The number of steps of the compared methods.
const STEPS: usize = 3;

const START: f64 = -std::f64::consts::FRAC_PI_2;
const START_RATE: f64 = -5.4;

/// As printed in the paper. The heading there says rad/s, but the values are errors of the angle in rad.
const PUBLISHED: [f64; STEPS] = [-1.21e-4, -1.84e-4, -1.95e-4];
const PUBLISHED_MSDTTMM: [f64; STEPS] = [-1.05e-2, -2.44e-2, -3.59e-2];

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    progress.begin("4.3: Table 1");
    let reference = by_runge_kutta(FINE)?;
    let method = by_runge_kutta(COARSE)?;
    let mut rod = Rod::new(1.0, 1.0, GRAVITY, START, START_RATE);
    let original = [(); STEPS].map(|()| {
        rod.step(COARSE);
        rod.angle()
    });
    let errors = |angles: [f64; STEPS]| -> Vec<f64> {
        reference.iter().zip(angles).map(|(reference, angle)| reference - angle).collect()
    };
    let (method, original) = (errors(method), errors(original));
    let verdict = Verdict {
        compared: "errors of Table 1 – published, printed digits".into(),
        figure: None,
        checks: vec![Check {
            what: "errors whose printed digits differ".into(),
            size: different_digits(&method) as f64,
            unit: "of 3",
            bound: Bound::Fixed(0.0),
        }],
    };
    let table = ResultTable {
        section: "Section 4.3",
        title: "Table 1, errors of the angle in rad (reference less computed), h = 0.1 s",
        columns: (1..=STEPS).map(|step| format!("e({:.1} s)", step as f64 * COARSE)).collect(),
        rows: vec![
            row("method, Runge–Kutta 4", method),
            row("  as published", PUBLISHED.to_vec()),
            row("MSDTTMM, Newmark β = 1/4, first order, predicted", original),
            row("  as published", PUBLISHED_MSDTTMM.to_vec()),
        ],
        note: "The errors of the method are those of the integrator. The linearisation of the original method \
               costs two digits. The paper does not state which variant of the original method it uses; the \
               variant here is the plain one, and its errors differ from the published ones.",
        verdicts: vec![verdict],
    };
    let drawings = vec![drawing()];
    Ok(SectionResult { drawings, tables: vec![table], ..SectionResult::default() })
}

/// The angle after each of the coarse steps, computed in steps of the given size.
fn by_runge_kutta(step: f64) -> Result<[f64; STEPS], Error> {
    let chain = Pendulum::<f64>::new();
    let mut state = chain.initial_state();
    state.joint_mut().set_angle(START).set_rate(START_RATE);
    let mut rk4 = Rk4::new(step);
    let count = (COARSE / step).round() as usize;
    let mut angles = [0.0; STEPS];
    for angle in &mut angles {
        for _ in 0..count {
            rk4.step(&chain, &mut state, |_time, _state| chain.no_inputs())?;
        }
        *angle = state.joint().angle();
    }
    Ok(angles)
}

fn row(name: &str, values: Vec<f64>) -> Row {
    Row { name: name.to_owned(), values }
}

/// Counts the errors that differ from the published ones in any digit that the paper prints.
fn different_digits(errors: &[f64]) -> usize {
    let printed = |value: f64| format!("{value:.2E}");
    let pairs = errors.iter().zip(PUBLISHED);
    pairs.filter(|(error, published)| printed(**error) != printed(*published)).count()
}

fn drawing() -> Drawing {
    let mut canvas = Canvas::new([-1.2, 1.2], [-1.15, 0.22], 420.0);
    let (hinge, end) = ([0.0, 0.0], [0.0, -1.0]);
    canvas.support(hinge, FROM_ABOVE);
    canvas.rod(hinge, end);
    canvas.pin(hinge);
    canvas.centre([0.0, -0.5]);
    canvas.text([0.0, -0.5], Side::Right, "1 kg, 1 m");
    canvas.rotation([0.0, -0.12], [34.0, 34.0], [-0.2 * PI, -0.8 * PI]);
    canvas.text([-0.2, -0.25], Side::Left, "5.4 rad/s");
    canvas.gravity([0.8, -0.2]);
    canvas.finish(
        "Section 4.3, Table 1: a rod on a pin",
        "A homogeneous rod that starts vertically, with −5.4 rad/s about z.",
    )
}
