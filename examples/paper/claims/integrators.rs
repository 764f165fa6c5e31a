//! The same chain under five integrators: error against step.
//!
//! "The proposed approach also allows combining MSTMM with any general numerical integration
//! procedure" [P, Abstract]: accelerations are a function of the state, and whatever follows from them
//! is left to others. So each method must keep its own order on the chain.

mod methods;
mod order;
mod stiff;

use mstmm::Error;
use mstmm::prelude::*;

use crate::output::progress::Progress;
use crate::section::Outcome;

const SECTION: &str = "Section 2.4, any integrator";

/// Of the springs in N m s/rad.
const DAMPING: f64 = 0.5;

/// How many parts the progress counts: references and methods of both parts.
pub const MOTIONS: usize = 2 + 2 * methods::ALL.len();

mstmm_chain! {
    /// The cubes of section 4.1 with springs and dampers in two of the balls, so that the linearly
    /// implicit method has something to look ahead to; without, it is the semi-implicit one.
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

pub fn run(progress: &Progress) -> Result<Outcome, Error> {
    let mut outcome = order::outcome(progress)?;
    outcome.exhibits.push(stiff::exhibit(progress)?);
    Ok(outcome)
}

/// The end of all motions in s. Steps are powers of two of it, so that no time is rounded.
const END: f64 = 1.0;

/// The motion to its end with errors near rounding.
fn reference(chain: &Cubes<f64>, tolerance: f64) -> Result<CubesState<f64>, Error> {
    let mut state = chain.initial_state();
    let mut dopri5 = Dopri5::new(tolerance, tolerance);
    dopri5.advance_to(chain, &mut state, END, |_time, _state| chain.no_inputs())?;
    Ok(state)
}

/// The largest difference of any coordinate or rate.
fn apart<S: ChainState<Scalar = f64>>(a: &S, b: &S) -> f64 {
    let pairs = a.coordinates().iter().zip(b.coordinates()).chain(a.rates().iter().zip(b.rates()));
    // In this order NaN is the largest of all.
    pairs.map(|(a, b)| (a - b).abs()).max_by(f64::total_cmp).unwrap_or(f64::NAN)
}
