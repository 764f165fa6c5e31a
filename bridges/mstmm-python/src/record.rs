//! Recordings of a chain of any type.

use mstmm::description::Description;
use mstmm::{ChainState, Described, Error};
use mstmm_look::{Group, Motion, Options, Recording};

use crate::batch::{Failure, Inputs};

/// Consecutive frames.
#[derive(Clone, Copy, Debug)]
pub struct Frames<'a> {
    /// The number of frames.
    pub count: usize,
    /// The time of each frame in s.
    pub times: &'a [f64],
    /// Coordinates and rates of each frame.
    pub states: &'a [f64],
    /// The inputs of each frame.
    pub inputs: Inputs<'a>,
}

/// A chain that records its states, of any type.
pub trait Record: Send + Sync {
    /// Returns the description.
    fn description(&self) -> &'static Description;

    /// Begins an empty motion of the chain with these parameters, with or without velocities of connection points.
    ///
    /// # Errors
    /// Those of [`Described::set_parameter`].
    fn begin(&mut self, parameters: &[f64], velocities: bool) -> Result<(), Error>;

    /// Records frames.
    ///
    /// # Errors
    /// The failure of the first frame that cannot be computed. The frames before it are recorded.
    fn record(&mut self, frames: Frames<'_>) -> Result<(), Failure>;

    /// Returns the motion.
    fn motion(&self) -> &Motion;
}

/// Records a chain of `f64`.
pub struct Recorder<C: Described + 'static>(Recording<'static, C>);

impl<C: Described<Scalar = f64> + Default + 'static> Default for Recorder<C> {
    fn default() -> Self {
        Recorder(Recording::owned(C::default(), Options::default()))
    }
}

impl<C> Record for Recorder<C>
where
    C: Described<Scalar = f64, Workspace: Send + Sync> + Default + Send + Sync + 'static,
{
    fn description(&self) -> &'static Description {
        C::DESCRIPTION
    }

    fn begin(&mut self, parameters: &[f64], velocities: bool) -> Result<(), Error> {
        let mut chain = C::default();
        for (index, value) in parameters.iter().enumerate() {
            chain.set_parameter(index, *value)?;
        }
        let options = Options::default();
        let options = if velocities { options.with(Group::Velocities) } else { options };
        self.0 = Recording::owned(chain, options);
        Ok(())
    }

    fn record(&mut self, frames: Frames<'_>) -> Result<(), Failure> {
        (0..frames.count).try_for_each(|row| {
            let (state, inputs) = frame::<C>(&frames, row);
            let failure = |error| Failure { row, step: None, error };
            self.0.record(&state, &inputs).map_err(failure)
        })
    }

    fn motion(&self) -> &Motion {
        &self.0
    }
}

/// Returns the state and the inputs of a frame.
fn frame<C: Described<Scalar = f64>>(frames: &Frames<'_>, row: usize) -> (C::State, C::Inputs) {
    let mut state = C::State::zero_position();
    let count = state.coordinates().len();
    let stride = count + state.rates().len();
    let values = frames.states.get(row * stride..).unwrap_or_default();
    let (coordinates, rates) = values.split_at(count.min(values.len()));
    state.coordinates_mut().iter_mut().zip(coordinates).for_each(|(to, value)| *to = *value);
    state.rates_mut().iter_mut().zip(rates).for_each(|(to, value)| *to = *value);
    state.set_time(frames.times.get(row).copied().unwrap_or_default());
    let len = C::DESCRIPTION.inputs().len();
    let first = row * frames.inputs.row_stride;
    let inputs = frames.inputs.values.get(first..first + len).and_then(C::inputs_from_slice);
    (state, inputs.unwrap_or_default())
}
