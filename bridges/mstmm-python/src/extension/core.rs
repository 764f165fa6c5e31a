//! The base class of all models.

use std::num::NonZero;

use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};

use super::arrays::{inputs, read, rows, slice, write};
use super::describe::describe;
use super::errors::exception;
use super::job::{self, Job, state_len};
use super::recorder::Recorder;
use crate::batch::{Arrays, Batch, OnError, Threads};
use crate::blocks::Blocks;
use crate::record::Record;
use crate::work::Work;

/// Makes a chain: for computing, and for recording.
#[pyclass(frozen)]
#[derive(Clone, Copy)]
pub struct Maker {
    /// Makes the chain in lanes.
    pub blocks: fn() -> Box<dyn Blocks>,
    /// Makes the recorder of the chain.
    pub record: fn() -> Box<dyn Record>,
}

#[pymethods]
impl Maker {
    /// Returns the description of the chain.
    fn describe<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        describe(py, &*(self.blocks)())
    }

    /// Returns an empty recording of a chain with these parameters.
    fn recorder(&self, parameters: Vec<f64>, velocities: bool) -> PyResult<Recorder> {
        Recorder::new((self.record)(), &parameters, velocities)
    }
}

/// A model. Its classes in Python add names and shapes.
#[pyclass(subclass)]
pub struct Core(Box<dyn Blocks>);

/// How rows are computed.
#[derive(Clone, Copy)]
struct How {
    threads: Threads,
    on_error: OnError,
}

impl How {
    fn of(threads: usize, errors: &str) -> PyResult<Self> {
        let threads = NonZero::new(threads).map_or(Threads::Cores, Threads::Count);
        let on_error = match errors {
            "raise" => OnError::Fail,
            "nan" => OnError::Nan,
            _ => {
                let text = format!("errors must be 'raise' or 'nan', not '{errors}'");
                return Err(PyValueError::new_err(text));
            }
        };
        Ok(How { threads, on_error })
    }
}

/// The arguments that a computation reads.
struct Read<'a, 'py> {
    rows: usize,
    states: &'a [f64],
    inputs: Option<&'a PyReadonlyArrayDyn<'py, f64>>,
    given: &'a [f64],
    steps: usize,
}

#[pymethods]
impl Core {
    #[new]
    #[classmethod]
    #[pyo3(signature = (**_parameters))]
    fn new(class: &Bound<'_, PyType>, _parameters: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let maker = class.getattr("_maker")?;
        let maker = maker.cast::<Maker>()?;
        Ok(Core((maker.get().blocks)()))
    }

    fn _describe<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        describe(py, &*self.0)
    }

    fn _parameter(&self, index: usize) -> PyResult<f64> {
        self.0.parameter(index).ok_or_else(|| PyIndexError::new_err("no such parameter"))
    }

    fn _set_parameter(&mut self, index: usize, value: f64) -> PyResult<()> {
        self.0.set_parameter(index, value).map_err(|error| PyValueError::new_err(error.to_string()))
    }

    fn _start<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_vec(py, self.0.start())
    }

    /// Takes ``n`` steps of ``h`` seconds with all states ``x``, in place.
    ///
    /// States have the shape (nx,) or (rows, nx), in the units of `coordinates`, then of `rates`. Inputs have the shape (nu,),
    /// (rows, nu) or, for each step, (rows, n, nu), in the units of `inputs`; without them they are zero. They are held over a
    /// step.
    #[pyo3(signature = (x, inputs=None, h=1e-3, n=1, *, method="rk4", threads=0, errors="raise"))]
    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn step(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        inputs: Option<&Bound<'_, PyAny>>,
        h: f64,
        n: i64,
        method: &str,
        threads: i64,
        errors: &str,
    ) -> PyResult<()> {
        let (n, threads) = (job::count("n", n)?, job::count("threads", threads)?);
        let how = How::of(threads, errors)?;
        let work =
            Work::Steps { method: job::method(method)?, step: job::step(h)?, steps: n, every: 0 };
        let mut x = write("x", x)?;
        let count = self.rows("x", x.shape())?;
        let inputs = inputs.map(|inputs| read("inputs", inputs)).transpose()?;
        let x = x.as_slice_mut().map_err(|error| PyValueError::new_err(error.to_string()))?;
        // The states are unchanged if one of them fails.
        let mut results = vec![0.0; x.len()];
        let given = Read { rows: count, states: x, inputs: inputs.as_ref(), given: &[], steps: n };
        self.run(py, how, work, given, &mut results)?;
        x.copy_from_slice(&results);
        Ok(())
    }

    /// Computes a job for all states: its name and its own arguments. The result has a row for each state.
    #[pyo3(signature = (job, arguments, x, inputs=None, given=None, threads=0, errors="raise"))]
    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn _run<'py>(
        &self,
        py: Python<'py>,
        job: &str,
        arguments: &Bound<'py, PyTuple>,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        given: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let how = How::of(threads, errors)?;
        let job = Job::of(&*self.0, job, arguments)?;
        let x = read("x", x)?;
        let count = self.rows("x", x.shape())?;
        let inputs = inputs.map(|inputs| read("inputs", inputs)).transpose()?;
        let given = given.map(|given| read("given", given)).transpose()?;
        let given = given.as_ref().map(slice).transpose()?.unwrap_or_default();
        if given.len() != job.given * count {
            return Err(PyValueError::new_err(format!(
                "the given values must have the shape ({count}, {})",
                job.given
            )));
        }
        let results = PyArray2::zeros(py, [count, job.result], false);
        let steps = job.steps;
        let read = Read { rows: count, states: slice(&x)?, inputs: inputs.as_ref(), given, steps };
        {
            let mut write = results.readwrite();
            let to =
                write.as_slice_mut().map_err(|error| PyValueError::new_err(error.to_string()))?;
            self.run(py, how, job.work, read, to)?;
        }
        Ok(results)
    }
}

impl Core {
    fn state_len(&self) -> usize {
        state_len(self.0.description())
    }

    fn rows(&self, name: &str, shape: &[usize]) -> PyResult<usize> {
        rows(name, shape, self.state_len(), "coordinates, then rates, in each row")
    }

    /// Computes results without the interpreter's lock.
    fn run(
        &self,
        py: Python<'_>,
        how: How,
        work: Work,
        read: Read<'_, '_>,
        results: &mut [f64],
    ) -> PyResult<()> {
        let of = self.0.description();
        let inputs = inputs(read.inputs, of.inputs().len(), read.rows, read.steps)?;
        let arrays =
            Arrays { rows: read.rows, states: read.states, inputs, given: read.given, results };
        let batch = Batch { chain: &*self.0, on_error: how.on_error, threads: how.threads };
        let result = py.detach(move || batch.run(work, arrays));
        result.map_err(|failure| exception(of, &failure))
    }
}
