//! The exceptions of rows that cannot be computed.

use mstmm::Error;
use mstmm::description::Description;
use pyo3::PyErr;
use pyo3::exceptions::{PyFloatingPointError, PyValueError};

use crate::batch::Failure;

/// Returns the exception for a row that fails, with the name of the quantity that is not finite.
pub fn exception(of: &Description, failure: &Failure) -> PyErr {
    let Failure { row, step, error } = failure;
    let place = match step {
        Some(step) => format!("row {row}, step {step}"),
        None => format!("row {row}"),
    };
    let Error::NotFinite(origin) = *error else {
        return PyValueError::new_err(format!("{place}: {error}"));
    };
    let text = match of.name_of(origin) {
        Some(name) => format!("`{name}` is not finite"),
        None => error.to_string(),
    };
    PyFloatingPointError::new_err(format!("{place}: {text}"))
}
