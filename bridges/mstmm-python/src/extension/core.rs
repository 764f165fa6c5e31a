//! The base class of all models.

use std::num::NonZero;

use mstmm::Error;
use mstmm::description::{Answer, Quantities};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use pyo3::exceptions::{PyFloatingPointError, PyIndexError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyType};

use super::arrays::{read, rows, shown, slice, write};
use super::describe::describe;
use crate::batch::{Arrays, Batch, Failure, Inputs, OnError, Threads};
use crate::blocks::{Blocks, MOTION_VALUES};
use crate::work::{Method, POINT_VALUES, Work};

/// Makes a chain.
#[pyclass(frozen)]
#[derive(Clone, Copy)]
pub struct Maker(pub fn() -> Box<dyn Blocks>);

#[pymethods]
impl Maker {
    /// Returns the description of the chain.
    fn describe<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        describe(py, &*(self.0)())
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
        Ok(Core((maker.get().0)()))
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

    /// Takes `n` steps of `h` seconds with all states `x`, in place.
    #[pyo3(signature = (x, inputs=None, h=1e-3, n=1, *, method="rk4", threads=0, errors="raise"))]
    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn step(
        &self,
        py: Python<'_>,
        x: &Bound<'_, PyAny>,
        inputs: Option<&Bound<'_, PyAny>>,
        h: f64,
        n: usize,
        method: &str,
        threads: usize,
        errors: &str,
    ) -> PyResult<()> {
        let how = How::of(threads, errors)?;
        let work =
            Work::Steps { method: self::method(method)?, step: step(h)?, steps: n, every: 0 };
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

    #[pyo3(signature = (x, inputs, h, n, every, method, threads, errors))]
    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn _rollout<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        h: f64,
        n: usize,
        every: usize,
        method: &str,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        if every == 0 {
            return Err(PyValueError::new_err("every must be positive"));
        }
        let work = Work::Steps { method: self::method(method)?, step: step(h)?, steps: n, every };
        let how = How::of(threads, errors)?;
        let len = (n / every + 1) * self.state_len();
        self.computed(py, how, work, [Some(x), inputs, None], [len, 0, n])
    }

    fn _accelerations<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let len = self.0.description().rates().len();
        let how = How::of(threads, errors)?;
        self.computed(py, how, Work::Accelerations, [Some(x), inputs, None], [len, 0, 0])
    }

    fn _energies<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let how = How::of(threads, errors)?;
        self.computed(py, how, Work::Energies, [Some(x), None, None], [2, 0, 0])
    }

    fn _assemble<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let how = How::of(threads, errors)?;
        let len = self.state_len();
        self.computed(py, how, Work::Assembly, [Some(x), inputs, None], [len, 0, 0])
    }

    fn _solve<'py>(
        &self,
        py: Python<'py>,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let of = self.0.description();
        let len =
            of.accelerations().len() + of.efforts().len() + 2 + POINT_VALUES * of.points().len();
        let how = How::of(threads, errors)?;
        self.computed(py, how, Work::Solution, [Some(x), inputs, None], [len, 0, 0])
    }

    #[pyo3(signature = (answer, x, inputs, given, threads, errors))]
    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn _answer<'py>(
        &self,
        py: Python<'py>,
        answer: usize,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        given: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let answer = Answer::ALL.get(answer).copied();
        let answer = answer.ok_or_else(|| PyIndexError::new_err("no such answer"))?;
        let of = self.0.description();
        let len = answer.len(of, self.0.dynamic_parameters());
        let how = How::of(threads, errors)?;
        let lens = [len, answer.given(of), 0];
        self.computed(py, how, Work::Answer(answer), [Some(x), inputs, given], lens)
    }

    #[expect(clippy::too_many_arguments, reason = "the arguments of a Python function")]
    fn _motion<'py>(
        &self,
        py: Python<'py>,
        frame: (usize, String),
        jacobian_rows: usize,
        x: &Bound<'py, PyAny>,
        inputs: Option<&Bound<'py, PyAny>>,
        threads: usize,
        errors: &str,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let found = self.0.frame(frame.0, &frame.1);
        let frame = found.ok_or_else(|| PyIndexError::new_err("no such frame"))?;
        let len = MOTION_VALUES + jacobian_rows * self.0.description().rates().len();
        let how = How::of(threads, errors)?;
        self.computed(py, how, Work::Motion(frame), [Some(x), inputs, None], [len, 0, 0])
    }
}

impl Core {
    fn state_len(&self) -> usize {
        let of = self.0.description();
        of.coordinates().len() + of.rates().len()
    }

    fn rows(&self, name: &str, shape: &[usize]) -> PyResult<usize> {
        rows(name, shape, self.state_len(), "coordinates, then rates, in each row")
    }

    /// Computes results from states, inputs and given values, which have these lengths for each row.
    fn computed<'py>(
        &self,
        py: Python<'py>,
        how: How,
        work: Work,
        [x, inputs, given]: [Option<&Bound<'py, PyAny>>; 3],
        [len, given_len, steps]: [usize; 3],
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let x = x.ok_or_else(|| PyTypeError::new_err("x is missing"))?;
        let x = read("x", x)?;
        let count = self.rows("x", x.shape())?;
        let inputs = inputs.map(|inputs| read("inputs", inputs)).transpose()?;
        let given = given.map(|given| read("given", given)).transpose()?;
        let given = given.as_ref().map(slice).transpose()?.unwrap_or_default();
        if given.len() != given_len * count {
            return Err(PyValueError::new_err(format!(
                "the given values must have the shape ({count}, {given_len})"
            )));
        }
        let results = PyArray1::zeros(py, count * len, false);
        let read = Read { rows: count, states: slice(&x)?, inputs: inputs.as_ref(), given, steps };
        {
            let mut write = results.readwrite();
            let to =
                write.as_slice_mut().map_err(|error| PyValueError::new_err(error.to_string()))?;
            self.run(py, how, work, read, to)?;
        }
        Ok(results)
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
        let inputs = self.inputs(read.inputs, read.rows, read.steps)?;
        let arrays =
            Arrays { rows: read.rows, states: read.states, inputs, given: read.given, results };
        let batch = Batch { chain: &*self.0, on_error: how.on_error, threads: how.threads };
        let result = py.detach(move || batch.run(work, arrays));
        result.map_err(|failure| self.exception(&failure, read.states, inputs))
    }

    /// Returns the inputs of all rows and, in a rollout, all steps.
    fn inputs<'a>(
        &self,
        inputs: Option<&'a PyReadonlyArrayDyn<'_, f64>>,
        rows: usize,
        steps: usize,
    ) -> PyResult<Inputs<'a>> {
        let Some(inputs) = inputs else {
            return Ok(Inputs { values: &[], row_stride: 0, step_stride: 0 });
        };
        let len = self.0.description().inputs().len();
        let values = slice(inputs)?;
        let (row_stride, step_stride) = match *inputs.shape() {
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
                    shown(inputs.shape())
                )));
            }
        };
        Ok(Inputs { values, row_stride, step_stride })
    }

    /// Returns the exception for a row that fails, with the quantity that is not finite.
    fn exception(&self, failure: &Failure, states: &[f64], inputs: Inputs<'_>) -> PyErr {
        let Failure { row, step, error } = failure;
        let place = match step {
            Some(step) => format!("row {row}, step {step}"),
            None => format!("row {row}"),
        };
        if *error == Error::NotFinite {
            let named = self.not_finite(*row, step.unwrap_or(0), states, inputs);
            let text = named.unwrap_or_else(|| error.to_string());
            return PyFloatingPointError::new_err(format!("{place}: {text}"));
        }
        PyValueError::new_err(format!("{place}: {error}"))
    }

    /// Returns the first quantity of a row that is not finite.
    fn not_finite(
        &self,
        row: usize,
        step: usize,
        states: &[f64],
        inputs: Inputs<'_>,
    ) -> Option<String> {
        let of = self.0.description();
        let first = |list: Quantities, values: &[f64]| {
            let (index, value) =
                values.iter().enumerate().take(list.len()).find(|(_, value)| !value.is_finite())?;
            let name = list.get(index)?.name;
            Some(format!("`{name}` is {}", if value.is_nan() { "nan" } else { "infinite" }))
        };
        let state = states.get(row * self.state_len()..)?;
        let (coordinates, rates) = state.split_at_checked(of.coordinates().len())?;
        first(of.coordinates(), coordinates).or_else(|| first(of.rates(), rates)).or_else(|| {
            let place = row * inputs.row_stride + step * inputs.step_stride;
            first(of.inputs(), inputs.values.get(place..)?)
        })
    }
}

fn method(name: &str) -> PyResult<Method> {
    let found = Method::ALL.iter().find(|(known, _)| *known == name);
    found.map(|(_, method)| *method).ok_or_else(|| {
        let known: Vec<&str> = Method::ALL.iter().map(|(known, _)| *known).collect();
        PyValueError::new_err(format!("method must be one of {}, not '{name}'", known.join(", ")))
    })
}

fn step(h: f64) -> PyResult<f64> {
    match h.is_finite() && h != 0.0 {
        true => Ok(h),
        false => Err(PyValueError::new_err("h must be a finite step in s, and not zero")),
    }
}
