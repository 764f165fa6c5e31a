//! Random states and inputs.

use std::f64::consts::{PI, TAU};

use mstmm::{ChainState, Error};
use mstmm_reference::Random;

use crate::description::{Description, Group, Hinge, InputKind, Settings};
use crate::scales::Scales;
use crate::subject::{Subject, doubles};

/// The largest rotation of closed chains from their start, and of elastic hinges, in rad.
const CLOSED: f64 = 0.5;
const ELASTIC: f64 = 0.3;

/// The largest translation of both, relative to the chain's size.
const NEAR: f64 = 0.1;

/// Components of an acceleration of free fall, in m/s².
const FALL: f64 = 9.81;

/// The distribution of states in words, of open chains and of closed chains.
pub const DISTRIBUTION: [&str; 2] = [
    "States are distributed uniformly: angles in ±π or between known limits, all orientations,\n\
     translations in ± the length about the start; elastic hinges in ±0.3 rad and ±0.1 of the length\n\
     about the start; rates in ± the rate, times the length for translations. Both precisions get the\n\
     same states, rounded to f32.",
    "States are distributed uniformly about the start: angles in ±0.5 rad, translations in ±0.1 of the\n\
     length, rates in ± the rate, times 0.1 of the length for translations; then closed in f64. Both\n\
     precisions get the same states, rounded to f32.",
];

/// The largest number of attempts to draw a state: not every state of a closed chain can be closed.
const ATTEMPTS: usize = 1000;

/// A state with its inputs.
#[derive(Clone, Debug)]
pub struct Sample {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    pub inputs: Vec<f64>,
}

impl Sample {
    /// Writes coordinates and rates.
    pub fn write(&self, state: &mut impl ChainState<Scalar = f64>) {
        state.coordinates_mut().copy_from_slice(&self.q);
        state.rates_mut().copy_from_slice(&self.v);
    }

    /// Returns the sample rounded to single precision.
    pub fn rounded(&self) -> Self {
        let round = |numbers: &[f64]| numbers.iter().map(|&number| single(number)).collect();
        Self { q: round(&self.q), v: round(&self.v), inputs: round(&self.inputs) }
    }
}

/// Returns a number rounded to single precision.
pub fn single(number: f64) -> f64 {
    f64::from(number as f32)
}

/// The start of a chain.
#[derive(Clone, Debug)]
pub struct Start {
    pub q: Vec<f64>,
    pub v: Vec<f64>,
    /// Whether the start is random, since the chain cannot be closed from that of the description.
    pub drawn: bool,
}

impl Start {
    /// Returns the start of the description, closed, or a start with random angles and orientations.
    ///
    /// # Errors
    /// If the chain cannot be closed from a random start either.
    pub fn of<C: Subject<Scalar = f64>>(
        chain: &C,
        description: &Description,
        settings: &Settings,
    ) -> Result<Self, Error> {
        let inputs = C::inputs(&description.no_inputs());
        let mut state = chain.initial_state();
        let mut random = Random::new(settings.seed);
        let mut closed = chain.assemble(&mut state, &inputs);
        let drawn = closed.is_err();
        for _ in 0..ATTEMPTS {
            if closed.is_ok() {
                break;
            }
            let mut q = doubles(state.coordinates());
            let mut start = 0;
            for group in description.groups() {
                let coordinates = &mut q[start..start + group.coordinates()];
                start += coordinates.len();
                match group.rotational {
                    true if group.quaternion => coordinates.copy_from_slice(&turn(&mut random)),
                    true => coordinates.fill_with(|| random.between(-PI, PI)),
                    false => {}
                }
            }
            state.coordinates_mut().copy_from_slice(&q);
            closed = chain.assemble(&mut state, &inputs);
        }
        closed.map(|()| Self { q: doubles(state.coordinates()), v: doubles(state.rates()), drawn })
    }
}

/// Draws states.
pub struct Sampler<'a> {
    description: &'a Description,
    start: &'a Start,
    scales: Scales,
    random_inputs: bool,
    random: Random,
    /// States that were drawn and could not be closed.
    pub given_up: usize,
}

impl<'a> Sampler<'a> {
    pub fn new(
        (description, start): (&'a Description, &'a Start),
        scales: Scales,
        settings: &Settings,
    ) -> Self {
        let (random_inputs, random) = (settings.random_inputs, Random::new(settings.seed));
        Self { description, start, scales, random_inputs, random, given_up: 0 }
    }

    /// Returns a random state, closed if the chain is closed.
    ///
    /// # Errors
    /// If no such state is found.
    pub fn draw<C: Subject<Scalar = f64>>(&mut self, chain: &C) -> Result<Sample, Error> {
        self.closed(chain, |sampler| {
            let inputs = sampler.inputs(true);
            Sample { inputs, ..sampler.around_start() }
        })
    }

    /// Returns the start with the inputs during a motion: prescribed motions are at rest.
    ///
    /// # Errors
    /// If the chain cannot be closed.
    pub fn begin<C: Subject<Scalar = f64>>(&mut self, chain: &C) -> Result<Sample, Error> {
        self.closed(chain, |sampler| {
            let (q, v) = (sampler.start.q.clone(), sampler.start.v.clone());
            Sample { q, v, inputs: sampler.inputs(false) }
        })
    }

    fn closed<C: Subject<Scalar = f64>>(
        &mut self,
        chain: &C,
        draw: impl Fn(&mut Self) -> Sample,
    ) -> Result<Sample, Error> {
        let mut failed = Error::NotAssembled;
        for _ in 0..ATTEMPTS {
            let mut sample = draw(self);
            let mut state = chain.initial_state();
            sample.write(&mut state);
            match chain.assemble(&mut state, &C::inputs(&sample.inputs)) {
                Ok(()) => {
                    (sample.q, sample.v) = (doubles(state.coordinates()), doubles(state.rates()));
                    return Ok(sample);
                }
                Err(error) => (failed, self.given_up) = (error, self.given_up + 1),
            }
        }
        Err(failed)
    }

    fn around_start(&mut self) -> Sample {
        let mut sample = Sample { q: Vec::new(), v: Vec::new(), inputs: Vec::new() };
        let (description, q) = (self.description, &self.start.q);
        for (_, hinge) in description.hinges() {
            for group in &hinge.groups {
                let first = sample.q.len();
                let start = &q[first..first + group.coordinates()];
                self.coordinates(hinge, group, start, &mut sample.q);
                self.rates(hinge, group, self.scales.rate, &mut sample.v);
            }
        }
        sample
    }

    /// Returns all numbers of the inputs, zero or random. Without `moving` prescribed motions are at rest.
    fn inputs(&mut self, moving: bool) -> Vec<f64> {
        let description = self.description;
        if !self.random_inputs {
            return description.no_inputs();
        }
        let mut numbers = Vec::new();
        for input in &description.inputs {
            for _ in 0..input.times {
                self.input(&input.what, moving, &mut numbers);
            }
        }
        numbers
    }

    fn input(&mut self, what: &InputKind, moving: bool, numbers: &mut Vec<f64>) {
        let Scales { rate, force, moment, .. } = self.scales;
        match what {
            InputKind::Gravity(count) => numbers.extend((0..*count).map(|_| self.within(FALL))),
            InputKind::Efforts(rotational) => numbers.extend(
                rotational
                    .iter()
                    .map(|&rotational| self.within(if rotational { moment } else { force })),
            ),
            InputKind::Motion(hinge) => {
                for group in &hinge.groups {
                    let zero = zero_position(group);
                    self.coordinates(hinge, group, &zero, numbers);
                }
                let moving = if moving { 1.0 } else { 0.0 };
                for bound in [moving * rate, moving * rate * rate] {
                    hinge.groups.iter().for_each(|group| self.rates(hinge, group, bound, numbers));
                }
            }
        }
    }

    fn coordinates(&mut self, hinge: &Hinge, group: &Group, start: &[f64], q: &mut Vec<f64>) {
        let closed = self.description.closed;
        if group.quaternion {
            let turn = if closed { self.turn_near() } else { turn(&mut self.random) };
            let from = if closed { [start[0], start[1], start[2], start[3]] } else { ONE };
            q.extend(product(from, turn));
            return;
        }
        let bound = match (group.rotational, closed, hinge.elastic) {
            (true, true, _) => CLOSED,
            (true, false, true) => ELASTIC,
            (true, false, false) => PI,
            (false, ..) => self.way(hinge),
        };
        for (&start, limits) in start.iter().zip(&group.limits) {
            q.push(match limits {
                Some([low, high]) if !closed => self.random.between(*low, *high),
                _ if group.rotational && !closed && !hinge.elastic => self.within(bound),
                _ => start + self.within(bound),
            });
        }
    }

    /// Adds rates, or their derivatives.
    fn rates(&mut self, hinge: &Hinge, group: &Group, bound: f64, v: &mut Vec<f64>) {
        let bound = if group.rotational { bound } else { bound * self.way(hinge) };
        v.extend(group.rates.iter().map(|_| self.within(bound)));
    }

    /// Returns the largest translation of a hinge.
    fn way(&self, hinge: &Hinge) -> f64 {
        let near = self.description.closed || hinge.elastic;
        self.scales.length * if near { NEAR } else { 1.0 }
    }

    fn within(&mut self, bound: f64) -> f64 {
        self.random.between(-bound, bound)
    }

    /// Returns a rotation by less than a right angle.
    fn turn_near(&mut self) -> [f64; 4] {
        let [x, y, z] = [(); 3].map(|()| self.within(CLOSED / 2.0));
        let size = (1.0 + x * x + y * y + z * z).sqrt();
        [1.0, x, y, z].map(|entry| entry / size)
    }
}

/// Returns a uniformly distributed rotation (Shoemake 1992).
fn turn(random: &mut Random) -> [f64; 4] {
    let [part, first, second] = [1.0, TAU, TAU].map(|high| random.between(0.0, high));
    let (small, large) = (part.sqrt(), (1.0 - part).sqrt());
    [large * first.sin(), large * first.cos(), small * second.sin(), small * second.cos()]
}

const ONE: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

/// Returns the product of two quaternions.
pub fn product([a, b, c, d]: [f64; 4], [w, x, y, z]: [f64; 4]) -> [f64; 4] {
    [
        a * w - b * x - c * y - d * z,
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ]
}

/// Returns the coordinates of a group in the zero position.
fn zero_position(group: &Group) -> Vec<f64> {
    if group.quaternion { ONE.to_vec() } else { vec![0.0; group.coordinates()] }
}

impl Description {
    /// Returns inputs that are zero, with prescribed motions at rest in the zero position.
    pub fn no_inputs(&self) -> Vec<f64> {
        let numbers = |what: &InputKind| match what {
            InputKind::Gravity(count) => vec![0.0; *count],
            InputKind::Efforts(rotational) => vec![0.0; rotational.len()],
            InputKind::Motion(hinge) => {
                let rates: usize = hinge.groups.iter().map(|group| group.rates.len()).sum();
                let zero = hinge.groups.iter().flat_map(zero_position);
                zero.chain(vec![0.0; 2 * rates]).collect()
            }
        };
        let each = |input: &crate::description::Input| numbers(&input.what).repeat(input.times);
        self.inputs.iter().flat_map(each).collect()
    }
}
