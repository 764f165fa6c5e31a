//! The exceptions of rows that cannot be computed.

use mstmm::Error;
use mstmm::description::{Description, Quantities};
use pyo3::PyErr;
use pyo3::exceptions::{PyFloatingPointError, PyValueError};

use super::job::state_len;
use crate::batch::{Failure, Inputs};

/// Returns the exception for a row that fails, with the quantity that is not finite.
pub fn exception(of: &Description, failure: &Failure, states: &[f64], inputs: Inputs<'_>) -> PyErr {
    let Failure { row, step, error } = failure;
    let place = match step {
        Some(step) => format!("row {row}, step {step}"),
        None => format!("row {row}"),
    };
    if *error == Error::NotFinite {
        let named = not_finite(of, [*row, step.unwrap_or(0)], states, inputs);
        let text = named.unwrap_or_else(|| error.to_string());
        return PyFloatingPointError::new_err(format!("{place}: {text}"));
    }
    PyValueError::new_err(format!("{place}: {error}"))
}

/// Returns the first quantity of a row that is not finite.
fn not_finite(
    of: &Description,
    [row, step]: [usize; 2],
    states: &[f64],
    inputs: Inputs<'_>,
) -> Option<String> {
    let first = |list: Quantities, values: &[f64]| {
        let (index, value) =
            values.iter().enumerate().take(list.len()).find(|(_, value)| !value.is_finite())?;
        let name = list.get(index)?.name;
        Some(format!("`{name}` is {}", if value.is_nan() { "nan" } else { "infinite" }))
    };
    let state = states.get(row * state_len(of)..)?;
    let (coordinates, rates) = state.split_at_checked(of.coordinates().len())?;
    first(of.coordinates(), coordinates).or_else(|| first(of.rates(), rates)).or_else(|| {
        let place = row * inputs.row_stride + step * inputs.step_stride;
        first(of.inputs(), inputs.values.get(place..)?)
    })
}
