//! Random states and inputs of any chain, and its answers as matrices.

use mstmm::Answers;
use mstmm::description::{Answer, Dimension};
use mstmm::prelude::*;
use mstmm_reference::Random;
use nalgebra::{DMatrix, DVector};

/// A state of a chain with inputs.
pub struct Sample<C: Answers<Scalar = f64>> {
    pub chain: C,
    pub state: C::State,
    /// The values of the inputs.
    pub inputs: Vec<f64>,
    pub random: Random,
}

impl<C: Answers<Scalar = f64> + Clone> Sample<C> {
    /// Changes parameters by up to a fifth. Coordinates are about one off the start; quaternions of inputs stay one.
    pub fn new(mut chain: C, seed: u64) -> Self {
        let mut random = Random::new(seed);
        for index in 0..C::DESCRIPTION.parameters().len() {
            let value = chain.parameter(index).expect("a parameter");
            let changed = value * random.between(0.8, 1.2);
            chain.set_parameter(index, changed).expect("a physical value");
        }
        let state = chain.initial_state();
        let mut inputs = vec![0.0; C::DESCRIPTION.inputs().len()];
        C::inputs_to_slice(&chain.no_inputs(), &mut inputs).expect("all inputs");
        let mut sample = Self { chain, state, inputs, random };
        for index in 0..sample.inputs.len() {
            if !sample.is_orientation(index) {
                sample.inputs[index] += sample.random.between(-0.5, 0.5);
            }
        }
        for _ in 0..3 {
            let direction = sample.vector(0.5);
            sample.state = sample.moved(&direction, 1.0);
        }
        let rates = sample.vector(1.0);
        sample.state.rates_mut().copy_from_slice(rates.as_slice());
        sample
    }

    /// The number of rates.
    pub fn count(&self) -> usize {
        C::DESCRIPTION.rates().len()
    }

    pub fn input_name(&self, index: usize) -> String {
        C::DESCRIPTION.inputs().get(index).expect("an input").name.to_string()
    }

    /// Whether an input is an entry of a quaternion, which is not free.
    pub fn is_orientation(&self, index: usize) -> bool {
        self.input_name(index).contains("orientation")
    }

    /// A random vector of one entry per rate.
    pub fn vector(&mut self, size: f64) -> DVector<f64> {
        DVector::from_fn(self.count(), |_, _| self.random.between(-size, size))
    }

    /// The state with other coordinates, `h` along a direction of the rates.
    pub fn moved(&self, direction: &DVector<f64>, h: f64) -> C::State {
        let mut along = self.state.clone();
        along.rates_mut().copy_from_slice(direction.as_slice());
        let mut change = self.state.clone();
        self.chain.configuration_rate_into(&along, &mut change);
        let mut moved = self.state.clone();
        for (coordinate, change) in moved.coordinates_mut().iter_mut().zip(change.coordinates()) {
            *coordinate += h * change;
        }
        self.chain.normalize(&mut moved);
        moved
    }

    /// The same with another state.
    pub fn at(&self, state: C::State) -> Self {
        let (chain, inputs) = (self.chain.clone(), self.inputs.clone());
        Self { chain, state, inputs, random: self.random.clone() }
    }

    /// The same with an input changed.
    pub fn with_input(&self, index: usize, change: f64) -> Self {
        let mut changed = self.at(self.state.clone());
        changed.inputs[index] += change;
        changed
    }

    pub fn typed_inputs(&self) -> C::Inputs {
        C::inputs_from_slice(&self.inputs).expect("all inputs")
    }

    /// Forward dynamics.
    pub fn accelerations(&self) -> DVector<f64> {
        let mut rate = self.state.clone();
        self.chain
            .derivative_into(&self.state, &self.typed_inputs(), &mut rate)
            .expect("a regular chain");
        DVector::from_column_slice(rate.rates())
    }

    /// All values of an answer.
    pub fn answer(&self, answer: Answer, given: &[f64]) -> Vec<f64> {
        let mut result = vec![0.0; answer.len(C::DESCRIPTION, C::DYNAMIC_PARAMETER_COUNT)];
        let found =
            self.chain.answer(answer, &self.state, &self.typed_inputs(), given, &mut result);
        found.expect("an answer").expect("a regular chain");
        result
    }

    pub fn vector_of(&self, answer: Answer, given: &[f64]) -> DVector<f64> {
        DVector::from_vec(self.answer(answer, given))
    }

    /// An answer that is one matrix.
    pub fn matrix_of(&self, answer: Answer, given: &[f64]) -> DMatrix<f64> {
        let values = self.answer(answer, given);
        let part = answer.part(C::DESCRIPTION, C::DYNAMIC_PARAMETER_COUNT, 0).expect("a part");
        DMatrix::from_vec(part.rows, values.len() / part.rows.max(1), values)
    }

    /// The parts of an answer.
    pub fn parts_of(&self, answer: Answer, given: &[f64]) -> Vec<DMatrix<f64>> {
        let values = self.answer(answer, given);
        let mut rest = &values[..];
        let part = |index| answer.part(C::DESCRIPTION, C::DYNAMIC_PARAMETER_COUNT, index);
        let parts = (0..).map_while(part).map(|part| {
            let (values, behind) = rest.split_at(part.len());
            rest = behind;
            DMatrix::from_column_slice(part.rows, part.columns.unwrap_or(1), values)
        });
        parts.collect()
    }

    pub fn inverse_dynamics(&self, accelerations: &DVector<f64>) -> DVector<f64> {
        self.vector_of(Answer::InverseDynamics, accelerations.as_slice())
    }
}

/// The largest difference of entries, relative to the largest entry and one.
pub fn off(found: &DMatrix<f64>, expected: &DMatrix<f64>) -> f64 {
    let size = |matrix: &DMatrix<f64>| if matrix.is_empty() { 0.0 } else { matrix.amax() };
    size(&(found - expected)) / (1.0 + size(found).max(size(expected)))
}

/// The same for vectors.
pub fn off_by(found: &DVector<f64>, expected: &DVector<f64>) -> f64 {
    let columns =
        |vector: &DVector<f64>| DMatrix::from_column_slice(vector.len(), 1, vector.as_slice());
    off(&columns(found), &columns(expected))
}

/// The numbers of directions of translations and of rotations.
pub fn directions(dimension: Dimension) -> [usize; 2] {
    match dimension {
        Dimension::Space => [3, 3],
        Dimension::Plane => [2, 1],
        Dimension::Line => [1, 0],
    }
}
