//! The arm: its chain, and the simulation of samples.

use crate::{Lanes, RESULTS, Sample};
use mstmm::prelude::*;
use mstmm::{ChainState, Error};

include!("../../loaded_panda.chain");

/// The step of the classical Runge-Kutta method in s.
pub const STEP: f64 = 4e-3;
/// The number of steps.
pub const STEPS: u32 = 250;

/// Simulates samples, one per lane at a time, in steps of `STEP / finer`. Returns the results of each in the order of
/// [`RESULTS`].
///
/// # Errors
/// Those of the chain.
pub fn simulate<T: Lanes>(
    samples: &[Sample],
    finer: u32,
) -> Result<Vec<[f64; RESULTS.len()]>, Error> {
    // The controller holds the target with the payload of the description.
    let nominal = LoadedPanda::<T>::new();
    let target = nominal.initial_state();
    let torques = nominal.gravity_efforts(&target, &nominal.no_inputs())?;
    let [j1, j2, j3, j4, j5, j6, j7] = torques.into();
    let inputs = LoadedPandaInputs { j1, j2, j3, j4, j5, j6, j7 };
    let mut at = nominal.workspace();
    nominal.solve_into(&target, &nominal.no_inputs(), &mut at)?;
    let goal = at.load().input().position();
    let mut ends = Vec::with_capacity(samples.len());
    for samples in samples.chunks(T::LANES) {
        let (arm, mut state) = loaded::<T>(samples)?;
        let mut rk4 = Rk4::new(T::constant(STEP / f64::from(finer)));
        for _ in 0..STEPS * finer {
            rk4.step(&arm, &mut state, |_, _| inputs)?;
        }
        arm.solve_into(&state, &arm.no_inputs(), &mut at)?;
        let offset = at.load().input().position() - goal;
        let [x, y, z] = offset.into();
        let distance = (x * x + y * y + z * z).sqrt();
        ends.extend((0..samples.len()).map(|lane| [distance.lane(lane), z.lane(lane)]));
    }
    Ok(ends)
}

/// Returns a chain with one sample per lane, and its start. If there are fewer samples than lanes, the last one fills the
/// other lanes.
fn loaded<T: Lanes>(samples: &[Sample]) -> Result<(LoadedPanda<T>, LoadedPandaState<T>), Error> {
    let lanes = |number: &dyn Fn(&Sample) -> f64| {
        T::from_lanes(|lane| number(&samples[lane.min(samples.len() - 1)]))
    };
    let moment = |a: usize, b: usize| {
        lanes(&|it| it.mass / 12.0 * (it.edges[a] * it.edges[a] + it.edges[b] * it.edges[b]))
    };
    let mut arm = LoadedPanda::new();
    arm.set_payload(lanes(&|it| it.mass))?;
    arm.set_x(lanes(&|it| it.centre[0]))?;
    arm.set_y(lanes(&|it| it.centre[1]))?;
    arm.set_z(lanes(&|it| it.centre[2]))?;
    arm.set_xx(moment(1, 2))?;
    arm.set_yy(moment(2, 0))?;
    arm.set_zz(moment(0, 1))?;
    let mut state = arm.initial_state();
    for (joint, angle) in state.coordinates_mut().iter_mut().enumerate() {
        *angle += lanes(&|it| it.start[joint]);
    }
    Ok((arm, state))
}
