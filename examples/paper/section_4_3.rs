//! Section 4.3, Table 1: the errors that single steps of a pendulum make, by the method and by the
//! one that it replaces.

use mstmm::Error;
use mstmm::prelude::*;

use crate::msdttmm::Rod;
use crate::output::exhibit::{Exhibit, Row};
use crate::output::progress::Progress;
use crate::section::Outcome;
use crate::system::GRAVITY;

mstmm_chain! {
    /// A homogeneous rod of 1 m and 1 kg.
    pub plane chain Pendulum {
        gravity = [0, -9.8] m/s^2;
        body Rod { mass = 1 kg; com = [0.5, 0] m; inertia = 1/3 kg*m^2 about input; }
        ground -> pin joint -> Rod rod;
    }
}

/// The step of the reference in s, and that of the methods compared.
const FINE: f64 = 1e-3;
const COARSE: f64 = 0.1;
/// Steps of the methods compared.
const STEPS: usize = 3;

const START: f64 = -std::f64::consts::FRAC_PI_2;
const START_RATE: f64 = -5.4;

/// As printed in the paper. Its heading says rad/s; they are errors of the angle in rad.
const PUBLISHED: [f64; STEPS] = [-1.21e-4, -1.84e-4, -1.95e-4];
const PUBLISHED_MSDTTMM: [f64; STEPS] = [-1.05e-2, -2.44e-2, -3.59e-2];

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
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
    let exhibit = Exhibit {
        section: "Section 4.3",
        title: "Table 1, errors of the angle in rad (reference less computed), h = 0.1 s",
        columns: (1..=STEPS).map(|step| format!("e({:.1} s)", step as f64 * COARSE)).collect(),
        faults: digits_that_differ(&method),
        rows: vec![
            row("method, Runge–Kutta 4", method),
            row("  as published", PUBLISHED.to_vec()),
            row("MSDTTMM, Newmark β = 1/4, first order, predicted", original),
            row("  as published", PUBLISHED_MSDTTMM.to_vec()),
        ],
        says: vec![
            "The method's errors are those of the integrator alone; linearising costs the original",
            "method two digits. The paper does not say which variant of that it took: this one is as",
            "it comes out.",
        ],
        differences: Vec::new(),
    };
    Ok(Outcome { exhibits: vec![exhibit], ..Outcome::default() })
}

/// The angle after each of the coarse steps.
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

/// The method's errors must be those of the paper in all digits that it prints.
fn digits_that_differ(found: &[f64]) -> Vec<String> {
    let printed = |value: f64| format!("{value:.2E}");
    let pairs = found.iter().zip(PUBLISHED).enumerate();
    let differ = pairs.filter(|(_, (found, published))| printed(**found) != printed(*published));
    differ
        .map(|(step, (&found, published))| {
            let (found, published) = (printed(found), printed(published));
            format!("error {} of Table 1 is {found}, published {published}", step + 1)
        })
        .collect()
}
