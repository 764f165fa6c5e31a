//! Recordings: a chain that fills a motion.

use crate::layout::{Computed, Layout};
use crate::rotation::{nearer, quaternion};
use crate::{Mechanism, Motion, Options};
use mstmm_runtime::description::{Dimension, PointResult};
use mstmm_runtime::{ChainState, Described, Error};
use std::ops::Deref;

/// Records states of a chain with all its results: a [`Motion`] that grows.
///
/// It refers to the chain or owns it, so parameters do not change while a motion is recorded.
#[derive(Debug)]
pub struct Recording<'a, C: Described> {
    chain: Held<'a, C>,
    at: C::Workspace,
    inputs: Vec<C::Scalar>,
    options: Options,
    calls: usize,
    motion: Motion,
}

#[derive(Debug)]
enum Held<'a, C> {
    Borrowed(&'a C),
    Owned(Box<C>),
}

impl<C> Deref for Held<'_, C> {
    type Target = C;

    fn deref(&self) -> &C {
        match self {
            Held::Borrowed(chain) => chain,
            Held::Owned(chain) => chain,
        }
    }
}

impl<'a, C> Recording<'a, C>
where
    C: Described<Scalar: Into<f64>>,
{
    /// Makes an empty recording of all groups except velocities of connection points.
    #[must_use]
    pub fn new(chain: &'a C) -> Self {
        Self::with(chain, Options::default())
    }

    /// Makes an empty recording with options.
    #[must_use]
    pub fn with(chain: &'a C, options: Options) -> Self {
        Self::of(Held::Borrowed(chain), options)
    }

    /// Makes an empty recording that owns the chain, so that it can be kept.
    #[must_use]
    pub fn owned(chain: C, options: Options) -> Recording<'static, C> {
        Recording::of(Held::Owned(Box::new(chain)), options)
    }

    fn of(chain: Held<'a, C>, options: Options) -> Self {
        let (mechanism, at) = (Mechanism::of(&*chain), chain.workspace());
        let layout = Layout::new(C::DESCRIPTION, &mechanism, &options, computed::<C>(&at));
        let inputs = vec![C::Scalar::default(); C::DESCRIPTION.inputs().len()];
        Recording { chain, at, inputs, options, calls: 0, motion: Motion::new(mechanism, layout) }
    }

    /// Records a state, its time and the results with these inputs, unless the stride of the options skips it.
    ///
    /// # Errors
    /// Those of [`GeneratedChain::solve_into`](mstmm_runtime::GeneratedChain::solve_into). The state is not recorded
    /// then.
    pub fn record(&mut self, state: &C::State, inputs: &C::Inputs) -> Result<(), Error> {
        let is_skipped = !self.calls.is_multiple_of(self.options.every());
        if !is_skipped {
            self.chain.solve_into(state, inputs, &mut self.at)?;
            self.fill(state, inputs);
        }
        self.calls += 1;
        Ok(())
    }

    /// Returns the results of the last recorded state.
    #[must_use]
    pub fn results(&self) -> &C::Workspace {
        &self.at
    }

    /// Returns the motion.
    #[must_use]
    pub fn into_motion(self) -> Motion {
        self.motion
    }

    fn fill(&mut self, state: &C::State, inputs: &C::Inputs) {
        // The length is that of the description.
        let _ = C::inputs_to_slice(inputs, &mut self.inputs);
        let mut row = Vec::with_capacity(self.motion.columns().len());
        let (at, blocks) = (&self.at, self.motion.blocks());
        for block in blocks {
            let count = block.shape.first().copied().unwrap_or(1);
            match block.name {
                "time" => row.push(state.time().into()),
                "coordinates" => row.extend(floats(state.coordinates())),
                "rates" => row.extend(floats(state.rates())),
                "accelerations" => row.extend(floats(C::accelerations(at))),
                "efforts" => row.extend(floats(C::efforts(at))),
                "inputs" => row.extend(floats(&self.inputs)),
                "kinetic_energy" => row.extend(C::energies(at).map(|it| it.kinetic.into())),
                "potential_energy" => row.extend(C::energies(at).map(|it| it.potential.into())),
                "orientation" => self.orientations(block.first, count, &mut row),
                name if name.starts_with("spring_") => springs::<C>(at, (name, count), &mut row),
                name => points::<C>(at, (name, count), &mut row),
            }
        }
        self.motion.push_row(row);
    }

    /// Adds quaternions, with signs for which they change steadily.
    fn orientations(&self, first: usize, count: usize, row: &mut Vec<f64>) {
        for index in 0..count {
            let rows = C::point(&self.at, index).and_then(|point| point.orientation);
            let rows = rows.map(|rows| rows.map(|row| row.map(Into::into)));
            let mut unit = rows.map_or([1.0, 0.0, 0.0, 0.0], quaternion);
            let before = self.motion.last().and_then(|row| row.get(first + 4 * index..));
            if let Some(before) = before.and_then(|rest| rest.first_chunk()) {
                unit = nearer(unit, *before);
            }
            row.extend(unit);
        }
    }
}

/// The motion so far, with all functions that write it.
impl<C: Described> Deref for Recording<'_, C> {
    type Target = Motion;

    fn deref(&self) -> &Motion {
        &self.motion
    }
}

fn floats<T: Copy + Into<f64>>(values: &[T]) -> impl Iterator<Item = f64> {
    values.iter().map(|value| (*value).into())
}

/// Returns which results a chain computes.
fn computed<C: Described>(at: &C::Workspace) -> Computed {
    let point = C::point(at, 0);
    let has = |of: fn(&PointResult<C::Scalar>) -> bool| point.as_ref().is_some_and(of);
    Computed {
        poses: has(|point| point.position.is_some()),
        velocities: has(|point| point.velocity.is_some()),
        z: has(|point| point.force.is_some()),
        energies: C::energies(at).is_some(),
        springs: C::spring(at, 0).is_some(),
    }
}

fn points<C>(at: &C::Workspace, (name, count): (&str, usize), row: &mut Vec<f64>)
where
    C: Described<Scalar: Into<f64>>,
{
    for point in (0..count).filter_map(|index| C::point(at, index)) {
        let vector = match name {
            "position" => point.position,
            "velocity" => point.velocity,
            "angular_velocity" => point.angular_velocity,
            "force" => point.force,
            _ => point.moment,
        };
        row.extend(vector.unwrap_or_default().map(Into::into));
    }
}

fn springs<C>(at: &C::Workspace, (name, count): (&str, usize), row: &mut Vec<f64>)
where
    C: Described<Scalar: Into<f64>>,
{
    for spring in (0..count).filter_map(|index| C::spring(at, index)) {
        match name {
            "spring_length" => row.push(spring.length().into()),
            "spring_length_rate" => row.push(spring.length_rate().into()),
            "spring_tension" => row.push(spring.tension().into()),
            _ => row.extend(spring.force().map(Into::into)),
        }
    }
}

/// Returns the number of dimensions.
pub fn dimensions(dimension: Dimension) -> u8 {
    match dimension {
        Dimension::Space => 3,
        Dimension::Plane => 2,
        Dimension::Line => 1,
    }
}
