//! What single precision loses in one evaluation: accelerations, forces and moments, at the same
//! random states.

use mstmm::{ChainState, Error};
use serde::Serialize;

use crate::description::{Description, Settings};
use crate::sample::{Sampler, Start};
use crate::scales::Scales;
use crate::statistics::{Spread, distance, largest, length, relative};
use crate::subject::{Reading, Subject, convert, doubles};

/// So many states are drawn for one that can be evaluated at most.
const SINGULAR: usize = 10;

/// An acceleration this small beside others is zero but for the rounding of double precision.
pub const NOTHING: f64 = 1e-12;

/// All that a chain computes at one instant.
pub struct Evaluation {
    pub accelerations: Vec<f64>,
    pub positions: Vec<[f64; 3]>,
    pub forces: Vec<[f64; 3]>,
    pub moments: Vec<[f64; 3]>,
}

/// Evaluates a chain: accelerations by the fast path, as integrators do.
pub fn evaluate<C: Subject>(
    chain: &C,
    state: &C::State,
    inputs: &[f64],
) -> Result<Evaluation, Error> {
    let inputs = C::inputs(inputs);
    let mut rate = C::State::default();
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

/// Relative errors over random states.
#[derive(Debug, Serialize)]
pub struct Errors {
    /// So many states were compared.
    pub states: usize,
    /// So many more could not be closed, and so many were singular in double precision.
    pub not_closed: usize,
    pub singular: usize,
    /// So many were refused in single precision only.
    pub refused: usize,
    /// Of the accelerations of a state the largest error by the largest acceleration, each for
    /// turns and shifts.
    pub accelerations: Option<Spread>,
    /// Of each acceleration by itself, but for those that are zero.
    pub each_acceleration: Option<Spread>,
    /// The worst of these.
    pub worst_acceleration: Option<String>,
    /// Of the forces and moments at connection points, by the largest of them.
    pub forces: Option<Spread>,
    pub moments: Option<Spread>,
    /// What rounding the state alone changes of the accelerations in double precision, by the
    /// largest of them.
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
    let mut state = D::State::default();
    let mut in_single = S::State::default();
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
    // Nothing accelerates where all motions are told.
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

/// The largest error by the largest acceleration, of turns and of shifts.
fn of_accelerations(found: &[f64], truth: &[f64], turning: &[bool], sizes: [f64; 2]) -> f64 {
    let errors: Vec<f64> = found.iter().zip(truth).map(|(found, truth)| found - truth).collect();
    let of_kind = |turns| relative(largest_of(&errors, turning, turns), sizes[usize::from(turns)]);
    largest([true, false].map(of_kind))
}

/// The largest acceleration among shifts, and among turns. Where those of one kind are zero but for
/// rounding, as in a closed chain that cannot turn, it follows from the other by the chain's size.
fn sizes(truth: &[f64], turning: &[bool], length: f64) -> [f64; 2] {
    let [shift, turn] = [false, true].map(|turns| largest_of(truth, turning, turns));
    let or = |own: f64, other: f64| if own <= NOTHING * other { other } else { own };
    [or(shift, turn * length), or(turn, shift / length)]
}

/// The largest of one kind.
fn largest_of(numbers: &[f64], turning: &[bool], turns: bool) -> f64 {
    let of_kind = numbers.iter().zip(turning).filter(|&(_, &turning)| turning == turns);
    largest(of_kind.map(|(number, _)| number.abs()))
}

/// The largest error by the largest vector; none if all are zero as they must be.
fn of_vectors(found: &[[f64; 3]], truth: &[[f64; 3]]) -> Option<f64> {
    let error = largest(found.iter().zip(truth).map(|(&found, &truth)| distance(found, truth)));
    let size = largest(truth.iter().copied().map(length));
    (error != 0.0 || size != 0.0).then(|| relative(error, size))
}
