//! The same chain with five integrators: error against step.
//!
//! "The proposed approach also allows combining MSTMM with any general numerical integration
//! procedure" [P, Abstract]: the accelerations are a function of the state. Each integrator must
//! therefore have its order of convergence on the chain.

mod methods;
mod order;
mod stiff;

use mstmm::Error;
use mstmm::prelude::*;

use crate::output::drawing::{Drawing, Side, cubes};
use crate::output::progress::Progress;
use crate::section::SectionResult;

const SECTION: &str = "Section 2.4, any integrator";

/// The damping of the springs in N m s/rad.
const DAMPING: f64 = 0.5;

/// The number of parts that the progress bar counts: references and integrators of both parts.
pub const MOTIONS: usize = 2 + 2 * methods::ALL.len();

mstmm_chain! {
    /// The cubes of section 4.1 with springs and dampers in two of the balls. Without springs and dampers,
    /// the linearly implicit integrator would be the semi-implicit one.
    pub chain Cubes {
        gravity = [0, -9.8, 0] m/s^2;
        param stiffness = 10 N*m/rad;

        body Cube {
            mass = 1 kg;
            com = [0.5, 0, 0] m;
            output = [1, 0, 0] m;
            inertia = diag(1/6, 5/12, 5/12) kg*m^2 about input;
        }

        ground -> ball shoulder -> Cube upper
               -> ball elbow    -> Cube middle
               -> ball wrist    -> Cube lower;

        hinge shoulder { start_rate = [0.5, 1, 0] rad/s; }
        hinge elbow, wrist { stiffness = stiffness; damping = DAMPING; }
    }
}

pub fn run(progress: &Progress) -> Result<SectionResult, Error> {
    let mut result = order::run(progress)?;
    result.tables.push(stiff::table(progress)?);
    result.drawings.push(drawing());
    Ok(result)
}

/// The end of all motions in s. Steps are its fractions by powers of two, so that no time is rounded.
const END: f64 = 1.0;

/// The state at the end, with errors near the rounding errors.
fn reference(chain: &Cubes<f64>, tolerance: f64) -> Result<CubesState<f64>, Error> {
    let mut state = chain.initial_state();
    let mut dopri5 = Dopri5::new(tolerance, tolerance);
    dopri5.advance_to(chain, &mut state, END, |_time, _state| chain.no_inputs())?;
    Ok(state)
}

/// The largest difference of a coordinate or rate.
fn difference<S: ChainState<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let pairs = a.coordinates().iter().zip(b.coordinates()).chain(a.rates().iter().zip(b.rates()));
    // In this order NaN is the largest of all.
    pairs.map(|(a, b)| (a - b).abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}

fn drawing() -> Drawing {
    let (mut canvas, hinges) = cubes::in_a_row([cubes::Symbol::Ball; 3]);
    for hinge in &hinges[1..] {
        canvas.coil(*hinge);
    }
    canvas.text([1.5, 0.62], Side::Centre, "springs and dampers");
    canvas.finish(
        "Any integrator: cubes on balls with springs",
        "The cubes of section 4.1 with springs of 10 N m/rad and dampers of 0.5 N m s/rad in two balls. The first \
         ball starts with 0.5 rad/s about x and 1 rad/s about y.",
    )
}
