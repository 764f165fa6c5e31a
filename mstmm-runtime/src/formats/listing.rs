//! The values of a state, of inputs or of parameters, with their labels.

use core::fmt;

use super::labels::Labels;
use super::table::{self, Row};
use crate::description::Description;
use crate::{ChainState, Described, Scalar};

/// The values of a state, of inputs or of parameters in the order of their labels.
#[derive(Clone, Debug)]
pub struct Listing<T, const N: usize> {
    labels: Labels,
    values: [T; N],
}

/// Parameters, by the rows of their table. Implemented by generated types.
pub trait ParameterRows<T> {
    /// Returns the values of a row, one for each repetition.
    fn row_(&self, row: usize) -> &[T] {
        let _ = row;
        &[]
    }
}

impl<T: Scalar, const N: usize> Listing<T, N> {
    /// Lists coordinates, rates and time.
    pub fn of_state<C: Described<Scalar = T>>(state: &C::State) -> Self {
        let mut listing = Self::new(Labels::of_state(C::DESCRIPTION));
        let values = state.coordinates().iter().chain(state.rates()).copied();
        listing.fill(values.chain([state.time()]));
        listing
    }

    /// Lists inputs.
    pub fn of_inputs<C: Described<Scalar = T>>(inputs: &C::Inputs) -> Self {
        let mut listing = Self::new(Labels::of_inputs(C::DESCRIPTION));
        // The number of values is that of the inputs.
        let _ = C::inputs_to_slice(inputs, &mut listing.values);
        listing
    }

    /// Lists parameters.
    pub fn of_parameters<C: Described<Scalar = T>>(parameters: &impl ParameterRows<T>) -> Self {
        let mut listing = Self::new(Labels::of_parameters(C::DESCRIPTION));
        listing.fill((0..N).map_while(|index| parameter(C::DESCRIPTION, parameters, index)));
        listing
    }

    fn new(labels: Labels) -> Self {
        Listing { labels, values: [T::default(); N] }
    }

    fn fill(&mut self, values: impl Iterator<Item = T>) {
        self.values.iter_mut().zip(values).for_each(|(place, value)| *place = value);
    }
}

impl<T, const N: usize> Listing<T, N> {
    /// Writes a table of labels, values and units.
    ///
    /// # Errors
    /// Those of the formatter.
    pub fn table(
        &self,
        f: &mut fmt::Formatter<'_>,
        show: fn(&T, &mut fmt::Formatter<'_>) -> fmt::Result,
    ) -> fmt::Result {
        table::write(f, show, || {
            self.entries().map(|(label, value, unit)| Row::one(label, value, unit))
        })
    }

    /// Returns labels, values and units.
    pub fn entries(&self) -> impl Iterator<Item = (super::labels::Label, &T, &'static str)> {
        self.labels.iter().zip(&self.values).map(|((label, unit), value)| (label, value, unit))
    }
}

/// Returns the value of a parameter by its index.
fn parameter<T: Copy>(
    description: &Description,
    parameters: &impl ParameterRows<T>,
    index: usize,
) -> Option<T> {
    let (row, repetition) = description.parameter_row(index)?;
    parameters.row_(row).get(repetition).copied()
}
