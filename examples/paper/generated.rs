//! The motion by the code that `mstmm_chain!` generates.

use mstmm::prelude::*;
use mstmm::{Described, Energy, Error};
use mstmm_look::{Motion, Recording};

use crate::output::progress::Progress;
use crate::system::{DURATION, RECORDS_PER_SECOND, Record};

/// The steps of the integrator per second. The largest error of an angle within 5 s is 2e-8 rad with 1000
/// steps per second, 1e-9 rad with 2000 and 6e-11 rad with 4000; more than 8000 do not reduce it.
const STEPS_PER_SECOND: u32 = 4000;
const STEPS_PER_RECORD: u32 = STEPS_PER_SECOND / RECORDS_PER_SECOND;
/// The step of the integrator in s.
pub const STEP: f64 = 1.0 / STEPS_PER_SECOND as f64;

/// A generated chain with the values that are compared.
pub trait PaperChain: Described<Scalar = f64> {
    /// The angles in rad, in the order of [`crate::system::System::angles`].
    fn angles(&self, state: &Self::State) -> Result<Vec<f64>, Error>;

    /// The accelerations in rad/s² at the start, in the order of [`crate::system::System::start`].
    fn accelerations(&self, state: &Self::State) -> Result<Vec<f64>, Error>;
}

/// Integrates the motion with the classical method of order four and records it, also for a page.
pub fn motion<C: PaperChain>(
    chain: &C,
    progress: &Progress,
) -> Result<(Vec<Record>, Motion), Error> {
    let mut state = chain.initial_state();
    let mut integrator = Rk4::new(STEP);
    let mut records = vec![record(chain, &state, 0.0)?];
    let mut recording = Recording::new(chain);
    recording.record(&state, &chain.no_inputs())?;
    for count in 1..=DURATION * RECORDS_PER_SECOND {
        for _ in 0..STEPS_PER_RECORD {
            integrator.step(chain, &mut state, |_time, _state| chain.no_inputs())?;
        }
        // The nearest value to a whole number of hundredths, instead of the state's time.
        let time = f64::from(count) / f64::from(RECORDS_PER_SECOND);
        records.push(record(chain, &state, time)?);
        recording.record(&state, &chain.no_inputs())?;
        progress.reach(time);
    }
    Ok((records, recording.into_motion()))
}

fn record<C: PaperChain>(chain: &C, state: &C::State, time_s: f64) -> Result<Record, Error> {
    let Energy { kinetic, potential } = chain.energy(state);
    Ok(Record {
        time_s,
        angles_rad: chain.angles(state)?,
        kinetic_energy_j: kinetic,
        potential_energy_j: potential,
    })
}
