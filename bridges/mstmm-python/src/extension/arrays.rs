//! Arguments that are arrays.

use numpy::{PyArrayDyn, PyReadonlyArrayDyn, PyUntypedArray, PyUntypedArrayMethods};
use numpy::{PyArrayMethods, PyReadwriteArrayDyn};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;

use crate::batch::Inputs;

/// Returns an argument as an array of float64.
fn checked<'py>(name: &str, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArrayDyn<f64>>> {
    let Ok(array) = value.cast::<PyUntypedArray>() else {
        let what = value.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "{name} must be a numpy array of float64, not {what}: use np.array({name}, dtype=np.float64)"
        )));
    };
    let Ok(array) = array.cast::<PyArrayDyn<f64>>() else {
        let dtype = array.dtype();
        return Err(PyTypeError::new_err(format!(
            "{name} must be an array of float64, not {dtype}: use {name}.astype(np.float64)"
        )));
    };
    Ok(array.clone())
}

/// Returns an array that is read, in C order: a copy of an array with another order, such as a transposed one.
pub fn read<'py>(name: &str, value: &Bound<'py, PyAny>) -> PyResult<PyReadonlyArrayDyn<'py, f64>> {
    let mut array = checked(name, value)?;
    if !array.is_c_contiguous() {
        let copy = array.call_method1("copy", ("C",))?;
        array = checked(name, &copy)?;
    }
    array.try_readonly().map_err(|_| PyValueError::new_err(format!("{name} is being written")))
}

/// Returns an array that is written, which must be in C order.
pub fn write<'py>(
    name: &str,
    value: &Bound<'py, PyAny>,
) -> PyResult<PyReadwriteArrayDyn<'py, f64>> {
    let array = checked(name, value)?;
    if !array.is_c_contiguous() {
        return Err(PyValueError::new_err(format!(
            "{name} must be contiguous, with its last axis first in memory: use np.ascontiguousarray({name})"
        )));
    }
    array.try_readwrite().map_err(|_| {
        PyValueError::new_err(format!("{name} is read-only, or another thread uses it"))
    })
}

/// The slice of an array in C order.
pub fn slice<'a>(array: &'a PyReadonlyArrayDyn<'_, f64>) -> PyResult<&'a [f64]> {
    array.as_slice().map_err(|error| PyValueError::new_err(error.to_string()))
}

/// Returns the number of rows of states: of an array of two axes, or one for an array of one axis.
pub fn rows(name: &str, shape: &[usize], len: usize, entries: &str) -> PyResult<usize> {
    match *shape {
        [columns] if columns == len => Ok(1),
        [rows, columns] if columns == len => Ok(rows),
        _ => Err(PyValueError::new_err(format!(
            "{name} must have the shape ({len},) or (rows, {len}), with {entries}; its shape is {}",
            shown(shape)
        ))),
    }
}

/// Returns the inputs of all rows and, in a rollout, all steps.
pub fn inputs<'a>(
    array: Option<&'a PyReadonlyArrayDyn<'_, f64>>,
    len: usize,
    rows: usize,
    steps: usize,
) -> PyResult<Inputs<'a>> {
    let Some(array) = array else {
        return Ok(Inputs { values: &[], row_stride: 0, step_stride: 0 });
    };
    let values = slice(array)?;
    let (row_stride, step_stride) = match *array.shape() {
        [columns] if columns == len => (0, 0),
        [all, columns] if columns == len && all == rows => (len, 0),
        [all, each, columns] if columns == len && all == rows && each == steps && steps > 0 => {
            (len * steps, len)
        }
        _ => {
            let in_steps = match steps {
                0 => String::new(),
                _ => format!(" or ({rows}, {steps}, {len})"),
            };
            return Err(PyValueError::new_err(format!(
                "inputs must have the shape ({len},) or ({rows}, {len}){in_steps}; their shape is {}",
                shown(array.shape())
            )));
        }
    };
    Ok(Inputs { values, row_stride, step_stride })
}

/// Returns a shape as Python writes it.
pub fn shown(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => {
            let lengths: Vec<String> = shape.iter().map(ToString::to_string).collect();
            format!("({})", lengths.join(", "))
        }
    }
}
