//! Recordings of motions for Python.

use std::io;
use std::path::PathBuf;

use mstmm_look::PageOptions;
use numpy::{PyArray1, PyUntypedArrayMethods};
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;

use super::arrays::{inputs, read, rows, slice};
use super::errors::exception;
use super::job::state_len;
use crate::record::{Frames, Record};

/// A motion that grows. Its class in Python adds names and shapes.
#[pyclass]
pub struct Recorder(Box<dyn Record>);

/// A column: name and unit.
type Column = (String, &'static str);
/// A block: name, first column, shape, names of the entries with their array.
type Block = (&'static str, usize, Vec<usize>, Option<(&'static str, Vec<String>)>);

impl Recorder {
    /// Makes an empty recording of a chain with these parameters.
    pub fn new(mut record: Box<dyn Record>, values: &[f64], velocities: bool) -> PyResult<Self> {
        record
            .begin(values, velocities)
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok(Recorder(record))
    }
}

#[pymethods]
impl Recorder {
    /// Records all rows of `x` with their inputs and times.
    fn record(
        &mut self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        inputs: Option<&Bound<'_, PyAny>>,
        times: Vec<f64>,
    ) -> PyResult<()> {
        let of = self.0.description();
        let x = read("x", x)?;
        let entries = "coordinates, then rates, in each row";
        let count = rows("x", x.shape(), state_len(of), entries)?;
        if times.len() != count {
            let text = format!("{count} states need {count} times, not {}", times.len());
            return Err(PyValueError::new_err(text));
        }
        let given = inputs.map(|given| read("inputs", given)).transpose()?;
        let given = self::inputs(given.as_ref(), of.inputs().len(), count, 0)?;
        let (states, record) = (slice(&x)?, &mut self.0);
        let frames = Frames { count, times: &times, states, inputs: given };
        let result = py.detach(move || record.record(frames));
        result.map_err(|failure| exception(of, &failure))
    }

    fn len(&self) -> usize {
        self.0.motion().len()
    }

    fn columns(&self) -> Vec<Column> {
        let columns = self.0.motion().columns().iter();
        columns.map(|column| (column.name.clone(), column.unit)).collect()
    }

    fn blocks(&self) -> Vec<Block> {
        let blocks = self.0.motion().blocks().iter();
        blocks.map(|it| (it.name, it.first, it.shape.clone(), it.names.clone())).collect()
    }

    /// Returns the values of adjacent columns, frame by frame.
    fn values<'py>(
        &self,
        py: Python<'py>,
        first: usize,
        width: usize,
    ) -> Bound<'py, PyArray1<f64>> {
        let rows = self.0.motion().rows().filter_map(|row| row.get(first..first + width));
        PyArray1::from_vec(py, rows.flatten().copied().collect())
    }

    /// Returns the page as text.
    fn html(
        &self,
        py: Python<'_>,
        title: Option<String>,
        meshes: Option<PathBuf>,
    ) -> PyResult<String> {
        let options = options(title, meshes);
        let motion = self.0.motion();
        py.detach(|| motion.html(&options)).map_err(io_error)
    }

    /// Returns the still picture of a frame as text.
    fn svg(&self, frame: usize, meshes: Option<PathBuf>) -> PyResult<String> {
        self.0.motion().svg_with(frame, &options(None, meshes)).map_err(io_error)
    }

    fn write_csv(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let motion = self.0.motion();
        py.detach(|| motion.write_csv(path)).map_err(io_error)
    }

    fn write_npz(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let motion = self.0.motion();
        py.detach(|| motion.write_npz(path)).map_err(io_error)
    }
}

fn options(title: Option<String>, meshes: Option<PathBuf>) -> PageOptions {
    let mut options = PageOptions::default();
    if let Some(title) = title {
        options = options.title(title);
    }
    if let Some(folder) = meshes {
        options = options.meshes(folder);
    }
    options
}

/// Returns the exception of an error of writing; what the caller can change is a `ValueError`.
fn io_error(error: io::Error) -> PyErr {
    match error.kind() {
        io::ErrorKind::InvalidInput => PyValueError::new_err(error.to_string()),
        _ => PyOSError::new_err(error.to_string()),
    }
}
