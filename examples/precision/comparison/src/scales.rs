//! The characteristic length, rate and loads of a chain, from which random states are drawn.

use mstmm::{ChainState, Error};
use serde::Serialize;

use crate::description::{Description, Settings};
use crate::evaluation::{NOTHING, evaluate};
use crate::sample::{Sampler, Start};
use crate::statistics::{Spread, distance, largest, length};
use crate::subject::Subject;

/// The number of random positions at rest from which the characteristic rate is computed.
const TRIED: usize = 64;

/// The scales of random states and inputs.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Scales {
    /// The largest distance at the start from the first connection point to another, in m; 1 m if
    /// it is zero.
    pub length: f64,
    /// The larger of two rates in rad/s, or 1 rad/s if both are zero: the largest rate at the start,
    /// and √α, where α is the median over random positions at rest of the largest angular acceleration
    /// or acceleration divided by the length.
    pub rate: f64,
    /// The largest force at a connection point at the start, in N; 1 N if there is none.
    pub force: f64,
    /// The largest moment in N m; force times length if there is none.
    pub moment: f64,
}

impl Scales {
    /// Returns the scales of a chain.
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
        // Values below this are rounding errors of zero.
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
        let by_size =
            |numbers: &[f64]| {
                let each = numbers.iter().zip(&turning);
                largest(each.map(|(number, &rotational)| {
                    number.abs() / if rotational { 1.0 } else { size }
                }))
            };
        let at_start = by_size(&start.v);
        let still = Self { length: size, rate: 0.0, force, moment };
        let mut sampler = Sampler::new((description, start), still, settings);
        let mut at_rest = Vec::new();
        for _ in 0..TRIED {
            let sample = sampler.draw(chain)?;
            sample.write(&mut state);
            // No inputs: random prescribed motions would increase the rate.
            if let Ok(found) = evaluate(chain, &state, &inputs) {
                at_rest.push(by_size(&found.accelerations).sqrt());
            }
        }
        let by_itself = Spread::of(at_rest).map_or(0.0, |spread| spread.median);
        // Accelerations are rounding errors below `NOTHING`, so rates are below its root.
        let rate =
            if by_itself.max(at_start) > NOTHING.sqrt() { by_itself.max(at_start) } else { 1.0 };
        Ok(Self { rate, ..still })
    }
}
