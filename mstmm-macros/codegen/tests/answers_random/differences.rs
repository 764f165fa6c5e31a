//! Derivatives of compiled functions by central differences in twice the precision.

use crate::common::double_double::DoubleDouble;
use crate::common::given::Given;
use crate::samples::Sample;
use mstmm_codegen::compile::{layouts, outputs};
use mstmm_codegen::ids::{InputId, ParameterId};
use mstmm_codegen::model::{Answer, Layout};
use mstmm_codegen::program::{Argument, ArrayLayout, Given as Vector, OutputId};

type Real = DoubleDouble;

/// The longer of the two steps; a power of two, so that it has no rounding error.
const STEP: f64 = 1.0 / (1 << 20) as f64;

/// A direction in which a chain changes.
#[derive(Clone, Debug)]
pub struct Direction {
    /// A small motion along the rates.
    pub coordinates: Vec<f64>,
    pub rates: Vec<f64>,
    /// Of the accelerations that inverse dynamics are given.
    pub accelerations: Vec<f64>,
    /// In the order of the layout of all inputs.
    pub inputs: Vec<f64>,
    /// In the order of the layout of all parameters.
    pub parameters: Vec<f64>,
}

/// A function of a chain, one of its results, and the accelerations that it is given.
pub struct Asked<'a> {
    pub answer: Answer,
    pub id: OutputId,
    pub accelerations: Option<&'a [f64]>,
}

impl Sample {
    /// Returns the direction of no change.
    pub fn no_direction(&self) -> Direction {
        let none = vec![0.0; self.rates()];
        let layout = Layout::of(&self.chain);
        Direction {
            coordinates: none.clone(),
            rates: none.clone(),
            accelerations: none,
            inputs: vec![0.0; layouts::inputs(&self.chain, &layout).total],
            parameters: vec![0.0; layouts::parameters(&self.chain).total],
        }
    }

    /// Returns the derivative of a result along a direction, rounded to the nearest numbers.
    ///
    /// Central differences with two steps, extrapolated to a step of zero [Richardson]: the error is
    /// about 1e-24 for functions whose derivatives have the size of their values.
    pub fn difference(&self, asked: &Asked, direction: &Direction) -> Vec<f64> {
        let here = self.given::<Real>();
        let at = |step: f64| {
            let (given, a) = self.changed(&here, asked, direction, Real::new(step));
            let accelerations = a.as_ref().map(|a| (Vector::Accelerations, &a[..]));
            let vectors: Vec<(Vector, &[Real])> = accelerations.into_iter().collect();
            self.ask(&given, (asked.answer, asked.id), &vectors)
        };
        let difference = |step: f64| -> Vec<Real> {
            let (ahead, behind) = (at(step), at(-step));
            let scale = Real::new(0.5 / step);
            ahead.iter().zip(&behind).map(|(&a, &b)| (a - b) * scale).collect()
        };
        let (coarse, fine) = (difference(STEP), difference(0.5 * STEP));
        let third = Real::new(3.0).recip();
        let extrapolated = |(&fine, &coarse): (&Real, &Real)| fine + (fine - coarse) * third;
        fine.iter().zip(&coarse).map(extrapolated).map(|value| value.high).collect()
    }

    /// Returns the arguments after a step, and the accelerations that the function is given.
    fn changed<'a>(
        &'a self,
        here: &Given<'a, Real>,
        asked: &Asked,
        direction: &Direction,
        step: Real,
    ) -> (Given<'a, Real>, Option<Vec<Real>>) {
        let reals = |values: &[f64]| values.iter().copied().map(Real::new).collect::<Vec<_>>();
        let moved = |from: &[Real], by: &[Real]| -> Vec<Real> {
            from.iter().zip(by).map(|(&from, &by)| from + step * by).collect()
        };
        let mut given = Given { compiled: here.compiled, arrays: here.arrays.clone() };
        let arguments = &mut given.arrays.arguments;
        let mut along = Given { compiled: here.compiled, arrays: here.arrays.clone() };
        along.arrays.arguments.insert(Argument::Rates, reals(&direction.coordinates));
        let rates = (Answer::CoordinateRates, outputs::COORDINATE_RATES);
        let change = self.ask(&along, rates, &[]);
        let mut add = |argument: Argument, by: &[Real]| {
            let values = moved(&arguments[&argument], by);
            arguments.insert(argument, values);
        };
        add(Argument::Coordinates, &change);
        add(Argument::Rates, &reals(&direction.rates));
        let layout = Layout::of(&self.chain);
        let counts = layout.inputs.iter().map(|input| input.range.len());
        let inputs = layouts::inputs(&self.chain, &layout);
        for (number, values) in split(&inputs, counts, &direction.inputs).iter().enumerate() {
            add(Argument::Input(InputId(number)), &reals(values));
        }
        let counts = self.chain.parameters.iter().map(|_| 1);
        let parameters = layouts::parameters(&self.chain);
        for (number, values) in split(&parameters, counts, &direction.parameters).iter().enumerate()
        {
            add(Argument::Parameter(ParameterId(number)), &reals(values));
        }
        given.set_up();
        let accelerations = asked
            .accelerations
            .map(|accelerations| moved(&reals(accelerations), &reals(&direction.accelerations)));
        (given, accelerations)
    }

    /// Returns the entries of one input of a vector with the layout of all inputs.
    pub fn own_input(&self, all: &[f64], id: InputId) -> Vec<f64> {
        let layout = Layout::of(&self.chain);
        let counts = layout.inputs.iter().map(|input| input.range.len());
        split(&layouts::inputs(&self.chain, &layout), counts, all).swap_remove(id.index())
    }

    /// Returns the values of all inputs in the order of the layout of all inputs.
    pub fn joined_inputs(&self, of: impl Fn(InputId) -> Vec<f64>) -> Vec<f64> {
        let layout = Layout::of(&self.chain);
        let all = layouts::inputs(&self.chain, &layout);
        let mut joined = vec![0.0; all.total];
        let mut first = 0;
        for (id, input) in layout.inputs.enumerate() {
            let count = input.range.len();
            let places = places(&all, first, count);
            places.into_iter().zip(of(id)).for_each(|(place, value)| joined[place] = value);
            first += count;
        }
        joined
    }
}

/// Splits the values of all items into those of each, the repetitions one after the other.
fn split(
    layout: &ArrayLayout,
    counts: impl Iterator<Item = usize>,
    values: &[f64],
) -> Vec<Vec<f64>> {
    let mut first = 0;
    let of_item = |count: usize| {
        let places = places(layout, first, count);
        first += count;
        places.into_iter().map(|place| values[place]).collect()
    };
    counts.map(of_item).collect()
}

/// Returns the places of an item of `count` entries in all repetitions.
fn places(layout: &ArrayLayout, first: usize, count: usize) -> Vec<usize> {
    if count == 0 {
        return Vec::new();
    }
    let segment = layout.segment_of(first);
    let start = segment.offset + first - segment.first;
    let repetition = |k: usize| (0..count).map(move |entry| start + k * segment.count + entry);
    (0..segment.repetitions).flat_map(repetition).collect()
}
