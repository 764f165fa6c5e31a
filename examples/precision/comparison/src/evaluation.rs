//! The errors of single precision in one evaluation: accelerations, forces and moments at the same
//! random states.

use mstmm::{ChainState, Error};
use serde::Serialize;

use crate::description::{Description, Settings};
use crate::sample::{Sampler, Start};
use crate::scales::Scales;
use crate::statistics::{Spread, distance, largest, length, relative};
use crate::subject::{Reading, Subject, convert, doubles};

/// The largest number of states drawn for one state that can be evaluated.
const SINGULAR: usize = 10;

/// Accelerations below this, relative to others, are rounding errors of double precision.
pub const NOTHING: f64 = 1e-12;

/// All results of a chain in one state.
pub struct Evaluation {
    pub accelerations: Vec<f64>,
    pub positions: Vec<[f64; 3]>,
    pub forces: Vec<[f64; 3]>,
    pub moments: Vec<[f64; 3]>,
}

/// Evaluates a chain; accelerations by `derivative_into`, as integrators do.
pub fn evaluate<C: Subject>(
    chain: &C,
    state: &C::State,
    inputs: &[f64],
) -> Result<Evaluation, Error> {
    let inputs = C::inputs(inputs);
    let mut rate = C::State::zero_position();
    chain.derivative_into(state, &inputs, &mut rate)?;
    let mut at = chain.workspace();
    chain.solve_into(state, &inputs, &mut at)?;
    let points = C::points(&at);
    Ok(Evaluation {
        accelerations: doubles(rate.rates()),
        positions: points.iter().map(Reading::position).collect(),
        forces: points.iter().map(Reading::force).collect(),
        moments: points.iter().map(Reading::moment).collect(),
    })
}

/// Relative errors at random states.
#[derive(Debug, Serialize)]
pub struct Errors {
    /// The number of states that were compared.
    pub states: usize,
    /// The numbers of states that could not be closed, and that were singular in double precision.
    pub not_closed: usize,
    pub singular: usize,
    /// The number of states that failed only in single precision.
    pub refused: usize,
    /// The largest error of a state's accelerations, relative to the largest acceleration, rotational
    /// and translational ones separately.
    pub accelerations: Option<Spread>,
    /// The relative error of each acceleration, except those that are zero.
    pub each_acceleration: Option<Spread>,
    /// The name of the acceleration with the largest error.
    pub worst_acceleration: Option<String>,
    /// The errors of the forces and moments at connection points, relative to the largest.
    pub forces: Option<Spread>,
    pub moments: Option<Spread>,
    /// The change of the accelerations in double precision if only the state is rounded, relative to
    /// the largest acceleration.
    pub state: Option<Spread>,
}

/// Compares both precisions.
pub fn errors<D, S>(
    (double, single): (&D, &S),
    (description, start): (&Description, &Start),
    scales: Scales,
    settings: &Settings,
) -> Result<Errors, Error>
where
    D: Subject<Scalar = f64>,
    S: Subject<Scalar = f32>,
{
    let turning = description.turning();
    let mut sampler = Sampler::new((description, start), scales, settings);
    let [mut accelerations, mut each, mut forces, mut moments, mut rounded] =
        [(); 5].map(|()| Vec::new());
    let (mut singular, mut refused, mut worst) = (0, 0, (0.0, None));
    let mut state = D::State::zero_position();
    let mut in_single = S::State::zero_position();
    let mut states = 0;
    for _ in 0..settings.states.saturating_mul(SINGULAR) {
        if states + refused == settings.states {
            break;
        }
        let drawn = sampler.draw(double)?;
        let sample = drawn.rounded();
        drawn.write(&mut state);
        let unrounded = evaluate(double, &state, &drawn.inputs);
        sample.write(&mut state);
        convert(&state, &mut in_single);
        let truth = evaluate(double, &state, &sample.inputs);
        let (Ok(unrounded), Ok(truth)) = (unrounded, truth) else {
            singular += 1;
            continue;
        };
        let Ok(found) = evaluate(single, &in_single, &sample.inputs) else {
            refused += 1;
            continue;
        };
        states += 1;
        let sizes = sizes(&truth.accelerations, &turning, scales.length);
        let of_list = |found: &Evaluation, truth: &Evaluation| {
            of_accelerations(&found.accelerations, &truth.accelerations, &turning, sizes)
        };
        accelerations.push(of_list(&found, &truth));
        rounded.push(of_list(&truth, &unrounded));
        forces.extend(of_vectors(&found.forces, &truth.forces));
        moments.extend(of_vectors(&found.moments, &truth.moments));
        for number in 0..turning.len() {
            let (found, truth) = (found.accelerations[number], truth.accelerations[number]);
            if truth.abs() <= NOTHING * sizes[usize::from(turning[number])] {
                continue;
            }
            let error = relative((found - truth).abs(), truth.abs());
            each.push(error);
            if error > worst.0 {
                worst = (error, Some(number));
            }
        }
    }
    // There are no accelerations if all motions are prescribed.
    let moves = !turning.is_empty();
    let of_moving = |errors| if moves { Spread::of(errors) } else { None };
    Ok(Errors {
        states,
        not_closed: sampler.given_up,
        singular,
        refused,
        accelerations: of_moving(accelerations),
        each_acceleration: of_moving(each),
        worst_acceleration: worst.1.map(|number| description.rate_name(number)),
        forces: Spread::of(forces),
        moments: Spread::of(moments),
        state: of_moving(rounded),
    })
}

/// Returns the largest error relative to the largest acceleration, of rotations and of translations.
fn of_accelerations(found: &[f64], truth: &[f64], turning: &[bool], sizes: [f64; 2]) -> f64 {
    let errors: Vec<f64> = found.iter().zip(truth).map(|(found, truth)| found - truth).collect();
    let of_kind = |rotational| {
        relative(largest_of(&errors, turning, rotational), sizes[usize::from(rotational)])
    };
    largest([true, false].map(of_kind))
}

/// Returns the largest translational and the largest rotational acceleration. If one kind is zero up to
/// rounding, as in a closed chain that cannot rotate, it follows from the other by the chain's size.
fn sizes(truth: &[f64], turning: &[bool], length: f64) -> [f64; 2] {
    let [shift, turn] = [false, true].map(|rotational| largest_of(truth, turning, rotational));
    let or = |own: f64, other: f64| if own <= NOTHING * other { other } else { own };
    [or(shift, turn * length), or(turn, shift / length)]
}

/// Returns the largest acceleration of one kind.
fn largest_of(numbers: &[f64], turning: &[bool], rotational: bool) -> f64 {
    let of_kind = numbers.iter().zip(turning).filter(|&(_, &turning)| turning == rotational);
    largest(of_kind.map(|(number, _)| number.abs()))
}

/// Returns the largest error relative to the largest vector; none if all vectors are zero.
fn of_vectors(found: &[[f64; 3]], truth: &[[f64; 3]]) -> Option<f64> {
    let error = largest(found.iter().zip(truth).map(|(&found, &truth)| distance(found, truth)));
    let size = largest(truth.iter().copied().map(length));
    (error != 0.0 || size != 0.0).then(|| relative(error, size))
}
