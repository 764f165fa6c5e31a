//! How large and how fast a chain is, so that random states suit it.

use mstmm::{ChainState, Error};
use serde::Serialize;

use crate::description::{Description, Settings};
use crate::evaluation::{NOTHING, evaluate};
use crate::sample::{Sampler, Start};
use crate::statistics::{Spread, distance, largest, length};
use crate::subject::Subject;

/// So many random positions at rest tell how fast a chain moves by itself.
const TRIED: usize = 64;

/// What random numbers are measured by.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Scales {
    /// The largest way at the start from the first connection point to another, in m; 1 m if there
    /// is none.
    pub length: f64,
    /// The root of the largest angular acceleration, or acceleration by length, in the median of
    /// random positions at rest, and no less than what turns at the start, in rad/s; 1 rad/s if
    /// that is none.
    pub rate: f64,
    /// The largest force at a connection point at the start, in N; 1 N if there is none.
    pub force: f64,
    /// The largest moment in N m; force by length if there is none.
    pub moment: f64,
}

impl Scales {
    /// Of a chain.
    pub fn of<C: Subject<Scalar = f64>>(
        chain: &C,
        description: &Description,
        start: &Start,
        settings: &Settings,
    ) -> Result<Self, Error> {
        let inputs = description.no_inputs();
        let mut state = chain.initial_state();
        state.coordinates_mut().copy_from_slice(&start.q);
        state.rates_mut().copy_from_slice(&start.v);
        let found = evaluate(chain, &state, &inputs)?;
        // What is this much smaller is the rounding of what should be zero.
        let or = |found: f64, otherwise: f64| {
            if found > NOTHING * otherwise && found.is_finite() { found } else { otherwise }
        };
        let of = |vectors: &[[f64; 3]]| largest(vectors.iter().copied().map(length));
        let size = largest(found.positions.iter().map(|&at| distance(at, found.positions[0])));
        let size = or(size, 1.0);
        let (force, moment) = (of(&found.forces), of(&found.moments));
        let force = or(or(force, moment / size), 1.0);
        let moment = or(moment, force * size);

        let turning = description.turning();
        let by_size = |numbers: &[f64]| {
            let each = numbers.iter().zip(&turning);
            largest(each.map(|(number, &turns)| number.abs() / if turns { 1.0 } else { size }))
        };
        let at_start = by_size(&start.v);
        let still = Self { length: size, rate: 0.0, force, moment };
        let mut sampler = Sampler::new((description, start), still, settings);
        let mut at_rest = Vec::new();
        for _ in 0..TRIED {
            let sample = sampler.draw(chain)?;
            sample.write(&mut state);
            // No inputs: motions told at random would make it fast.
            if let Ok(found) = evaluate(chain, &state, &inputs) {
                at_rest.push(by_size(&found.accelerations).sqrt());
            }
        }
        let by_itself = Spread::of(at_rest).map_or(0.0, |spread| spread.median);
        // The root of a rounding error.
        let rate =
            if by_itself.max(at_start) > NOTHING.sqrt() { by_itself.max(at_start) } else { 1.0 };
        Ok(Self { rate, ..still })
    }
}
