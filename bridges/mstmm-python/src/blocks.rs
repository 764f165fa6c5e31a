//! States side by side in the lanes of registers.

use mstmm::description::{Answer, Answers, BodyFrame, Description};
use mstmm::{
    ChainState, Error, FrameMotion, GeneratedChain, LinearlyImplicitEuler, Rk4, SemiImplicitEuler,
};
use mstmm::{Described, Scalar};

use crate::Lanes;
use crate::batch::{Failure, Inputs, OnError};
use crate::gradients::{pullback, pushforward};
use crate::work::{Method, Work};

/// Consecutive rows of arrays.
#[derive(Debug)]
pub struct Rows<'a> {
    /// The number of rows.
    pub count: usize,
    /// Coordinates and rates of each state.
    pub states: &'a [f64],
    /// Inputs of each state.
    pub inputs: Inputs<'a>,
    /// Given values of each state.
    pub given: &'a [f64],
    /// Results of each state.
    pub results: &'a mut [f64],
}

/// A chain of any type, whose states are computed in lanes.
pub trait Blocks: Send + Sync + std::fmt::Debug {
    /// Returns the description.
    fn description(&self) -> &'static Description;

    /// Returns a copy.
    fn copy(&self) -> Box<dyn Blocks>;

    /// Returns the number of lanes.
    fn lanes(&self) -> usize;

    /// Returns a parameter; `None` if there is no such parameter.
    fn parameter(&self, index: usize) -> Option<f64>;

    /// Sets a parameter.
    ///
    /// # Errors
    /// Those of [`Described::set_parameter`].
    fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Error>;

    /// Returns coordinates and rates at the start.
    fn start(&self) -> Vec<f64>;

    /// Returns whether the chain has an answer.
    fn has(&self, answer: Answer) -> bool;

    /// Returns the number of dynamic parameters.
    fn dynamic_parameters(&self) -> usize;

    /// Returns the names of the frames of a body.
    fn frames(&self, body: usize) -> &'static [&'static str];

    /// Returns a frame of a body.
    fn frame(&self, body: usize, name: &str) -> Option<BodyFrame>;

    /// Computes rows.
    ///
    /// # Errors
    /// The failure of the first row that fails, unless [`OnError::Nan`] is set.
    fn run(&self, work: Work, rows: Rows<'_>, on_error: OnError) -> Result<(), Failure>;
}

/// A chain in [`Lanes`], whose lanes have the same parameters.
#[derive(Clone, Debug, Default)]
pub struct Model<C>(C);

/// Where a block fails.
pub struct Stop {
    /// The step, counted from zero, in an integration.
    pub step: Option<usize>,
    /// The error.
    pub error: Error,
}

impl From<Error> for Stop {
    fn from(error: Error) -> Self {
        Stop { step: None, error }
    }
}

/// Memory that all blocks of a thread use.
struct Memory<C: GeneratedChain> {
    at: Option<Box<C::Workspace>>,
    given: Vec<Lanes>,
    result: Vec<Lanes>,
    inputs: Vec<Lanes>,
}

impl<C> Blocks for Model<C>
where
    C: Answers<Scalar = Lanes> + Clone + Send + Sync + std::fmt::Debug + 'static,
{
    fn description(&self) -> &'static Description {
        C::DESCRIPTION
    }

    fn copy(&self) -> Box<dyn Blocks> {
        Box::new(Model(self.0.clone()))
    }

    fn lanes(&self) -> usize {
        Lanes::LANES
    }

    fn parameter(&self, index: usize) -> Option<f64> {
        self.0.parameter(index).map(|value| value.to_array()[0])
    }

    fn set_parameter(&mut self, index: usize, value: f64) -> Result<(), Error> {
        self.0.set_parameter(index, <Lanes as Scalar>::splat(value))
    }

    fn start(&self) -> Vec<f64> {
        let state = self.0.initial_state();
        let values = state.coordinates().iter().chain(state.rates());
        values.map(|value| value.to_array()[0]).collect()
    }

    fn has(&self, answer: Answer) -> bool {
        C::has(answer)
    }

    fn dynamic_parameters(&self) -> usize {
        C::DYNAMIC_PARAMETER_COUNT
    }

    fn frames(&self, body: usize) -> &'static [&'static str] {
        C::frames(body)
    }

    fn frame(&self, body: usize, name: &str) -> Option<BodyFrame> {
        C::frame(body, name)
    }

    fn run(&self, work: Work, mut rows: Rows<'_>, on_error: OnError) -> Result<(), Failure> {
        let mut memory = self.memory(&rows);
        let lanes = Lanes::LANES;
        for first in (0..rows.count).step_by(lanes) {
            let last = (first + lanes).min(rows.count);
            let together = self.block(work, &mut rows, [first, last], &mut memory);
            if together.is_err() {
                // One of the lanes fails: each row alone shows which one.
                for row in first..last {
                    match (self.block(work, &mut rows, [row, row + 1], &mut memory), on_error) {
                        (Ok(()), _) => {}
                        (Err(Stop { step, error }), OnError::Fail) => {
                            return Err(Failure { row, step, error });
                        }
                        (Err(_), OnError::Nan) => rows.result(row).fill(f64::NAN),
                    }
                }
            }
        }
        Ok(())
    }
}

impl Rows<'_> {
    fn result(&mut self, row: usize) -> &mut [f64] {
        let len = self.results.len() / self.count;
        &mut self.results[row * len..(row + 1) * len]
    }
}

impl<C: Answers<Scalar = Lanes>> Model<C> {
    fn memory(&self, rows: &Rows<'_>) -> Memory<C> {
        let zero = Lanes::default();
        let len = |values: &[f64]| values.len() / rows.count.max(1);
        Memory {
            at: None,
            given: vec![zero; len(rows.given)],
            result: vec![zero; len(rows.results)],
            inputs: vec![zero; C::DESCRIPTION.inputs().len()],
        }
    }

    /// Computes the rows of one block. If there are fewer rows than lanes, the other lanes repeat the first row.
    fn block(
        &self,
        work: Work,
        rows: &mut Rows<'_>,
        [first, last]: [usize; 2],
        memory: &mut Memory<C>,
    ) -> Result<(), Stop> {
        let row = |lane: usize| if first + lane < last { first + lane } else { first };
        let mut state = C::State::zero_position();
        let count = state.coordinates().len();
        let stride = count + state.rates().len();
        let entry = |index: usize| gather(rows.states, |lane| row(lane) * stride + index);
        state.coordinates_mut().iter_mut().enumerate().for_each(|(i, it)| *it = entry(i));
        state.rates_mut().iter_mut().enumerate().for_each(|(i, it)| *it = entry(count + i));
        let given_len = memory.given.len();
        for (index, value) in memory.given.iter_mut().enumerate() {
            *value = gather(rows.given, |lane| row(lane) * given_len + index);
        }
        let inputs = self.inputs(&rows.inputs, 0, row, &mut memory.inputs);
        if let Work::Steps { method, step, steps, every } = work {
            let span = Span { steps, every };
            return match method {
                Method::Rk4 => {
                    let mut rk4 = Rk4::new(<Lanes as Scalar>::splat(step));
                    let advance = |state: &mut C::State, inputs: &C::Inputs| {
                        rk4.step(&self.0, state, |_, _| inputs.clone())
                    };
                    self.steps(span, advance, state, rows, [first, last], memory)
                }
                Method::SemiImplicitEuler => {
                    let mut euler = SemiImplicitEuler::new(<Lanes as Scalar>::splat(step));
                    let advance = |state: &mut C::State, inputs: &C::Inputs| {
                        euler.step(&self.0, state, |_, _| inputs.clone())
                    };
                    self.steps(span, advance, state, rows, [first, last], memory)
                }
                Method::LinearlyImplicitEuler => {
                    let mut euler = LinearlyImplicitEuler::new(<Lanes as Scalar>::splat(step));
                    let advance = |state: &mut C::State, inputs: &C::Inputs| {
                        euler.step(&self.0, state, |_, _| inputs.clone())
                    };
                    self.steps(span, advance, state, rows, [first, last], memory)
                }
            };
        }
        match work {
            Work::Pullback(steps) => {
                let Memory { given, result, inputs: values, .. } = memory;
                let inputs = |step| self.inputs(&rows.inputs, step, row, values);
                pullback(&self.0, steps, inputs, given, result)?;
            }
            Work::Pushforward(steps) => {
                let Memory { given, result, inputs: values, .. } = memory;
                let inputs = |step| self.inputs(&rows.inputs, step, row, values);
                pushforward(&self.0, steps, inputs, state, (given, result))?;
            }
            _ => self.compute(work, &state, &inputs, memory)?,
        }
        for lane in 0..last - first {
            let to = rows.result(first + lane);
            for (place, value) in to.iter_mut().zip(&memory.result) {
                *place = value.as_array()[lane];
            }
        }
        Ok(())
    }

    /// Returns the inputs of a block in a step.
    fn inputs(
        &self,
        inputs: &Inputs<'_>,
        step: usize,
        row: impl Fn(usize) -> usize,
        memory: &mut [Lanes],
    ) -> C::Inputs {
        if inputs.values.is_empty() {
            return self.0.no_inputs();
        }
        for (index, value) in memory.iter_mut().enumerate() {
            let place = |lane| row(lane) * inputs.row_stride + step * inputs.step_stride + index;
            *value = gather(inputs.values, place);
        }
        C::inputs_from_slice(memory).unwrap_or_else(|| self.0.no_inputs())
    }

    /// Integrates the states of a block and writes them to the results.
    fn steps(
        &self,
        Span { steps, every }: Span,
        mut advance: impl FnMut(&mut C::State, &C::Inputs) -> Result<(), Error>,
        mut state: C::State,
        rows: &mut Rows<'_>,
        [first, last]: [usize; 2],
        memory: &mut Memory<C>,
    ) -> Result<(), Stop> {
        let row = |lane: usize| if first + lane < last { first + lane } else { first };
        let len = state.coordinates().len() + state.rates().len();
        let write = |state: &C::State, rows: &mut Rows<'_>, place: usize| {
            for lane in 0..last - first {
                let to = rows.result(first + lane).iter_mut().skip(place * len);
                let values = state.coordinates().iter().chain(state.rates());
                to.zip(values).for_each(|(to, value)| *to = value.as_array()[lane]);
            }
        };
        self.0.check_state(&state)?;
        if every > 0 {
            write(&state, rows, 0);
        }
        let mut inputs = self.inputs(&rows.inputs, 0, row, &mut memory.inputs);
        for step in 0..steps {
            if step > 0 && rows.inputs.step_stride > 0 {
                inputs = self.inputs(&rows.inputs, step, row, &mut memory.inputs);
            }
            let stop = |error| Stop { step: Some(step), error };
            advance(&mut state, &inputs).map_err(stop)?;
            if every > 0 && (step + 1) % every == 0 {
                write(&state, rows, (step + 1) / every);
            }
        }
        if every == 0 {
            write(&state, rows, 0);
        }
        Ok(())
    }

    /// Computes everything but integrations.
    fn compute(
        &self,
        work: Work,
        state: &C::State,
        inputs: &C::Inputs,
        memory: &mut Memory<C>,
    ) -> Result<(), Stop> {
        let chain = &self.0;
        let Memory { at, given, result, .. } = memory;
        chain.check_state(state)?;
        chain.check_inputs(inputs)?;
        match work {
            Work::Steps { .. } | Work::Pullback(_) | Work::Pushforward(_) => {}
            Work::Accelerations => {
                let mut rate = C::State::zero_position();
                chain.derivative_into(state, inputs, &mut rate)?;
                result.iter_mut().zip(rate.rates()).for_each(|(to, value)| *to = *value);
            }
            Work::Energies => {
                let energy = chain.energy(state);
                let values = [energy.kinetic, energy.potential];
                result.iter_mut().zip(values).for_each(|(to, value)| *to = value);
            }
            Work::Assembly => {
                let mut state = state.clone();
                chain.assemble(&mut state, inputs)?;
                let values = state.coordinates().iter().chain(state.rates());
                result.iter_mut().zip(values).for_each(|(to, value)| *to = *value);
            }
            Work::Solution => {
                let at = at.get_or_insert_with(|| Box::new(chain.workspace()));
                chain.solve_into(state, inputs, at)?;
                write_solution::<C>(at, result);
            }
            Work::Answer(answer) => {
                // The lengths are those of the description, so that a chain without the answer is the only other reason.
                chain.answer(answer, state, inputs, given, result).unwrap_or(Ok(()))?;
            }
            Work::Motion(frame) => {
                let len = result.len();
                let (values, jacobian) = result.split_at_mut(MOTION_VALUES.min(len));
                if let Some(motion) = chain.motion(state, inputs, frame, jacobian) {
                    let motion = motion_values(motion?);
                    values.iter_mut().zip(motion).for_each(|(to, value)| *to = value);
                }
            }
        }
        Ok(())
    }
}

/// The steps of an integration.
#[derive(Clone, Copy)]
struct Span {
    steps: usize,
    every: usize,
}

/// The number of values of a motion.
pub const MOTION_VALUES: usize = 24;

fn motion_values<T: Copy>(motion: FrameMotion<T>) -> impl Iterator<Item = T> {
    let [a, b, c] = motion.orientation;
    [
        motion.position,
        a,
        b,
        c,
        motion.velocity,
        motion.angular_velocity,
        motion.bias_acceleration,
        motion.angular_bias_acceleration,
    ]
    .into_iter()
    .flatten()
}

/// Writes accelerations, efforts, energies and the results at all points; NaN for what the chain does not compute.
fn write_solution<C: Described<Scalar = Lanes>>(at: &C::Workspace, result: &mut [Lanes]) {
    let nan = <Lanes as Scalar>::splat(f64::NAN);
    let mut places = result.iter_mut();
    let mut put = |values: &[Lanes]| {
        values.iter().for_each(|value| {
            if let Some(place) = places.next() {
                *place = *value;
            }
        });
    };
    put(C::accelerations(at));
    put(C::efforts(at));
    let energies = C::energies(at).map_or([nan; 2], |energy| [energy.kinetic, energy.potential]);
    put(&energies);
    for index in 0..C::DESCRIPTION.points().len() {
        let point = C::point(at, index).unwrap_or_default();
        put(&point.position.unwrap_or([nan; 3]));
        point.orientation.unwrap_or([[nan; 3]; 3]).iter().for_each(|row| put(row));
        for vector in [
            point.velocity,
            point.angular_velocity,
            point.acceleration,
            point.angular_acceleration,
            point.moment,
            point.force,
        ] {
            put(&vector.unwrap_or([nan; 3]));
        }
    }
}

/// Returns the values at an index for each lane; NaN beyond the end.
fn gather(values: &[f64], index: impl Fn(usize) -> usize) -> Lanes {
    Lanes::new(std::array::from_fn(|lane| values.get(index(lane)).copied().unwrap_or(f64::NAN)))
}
