//! What a function of Python computes.

use mstmm::description::{Answer, Description};
use pyo3::exceptions::{PyIndexError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use crate::blocks::{Blocks, MOTION_VALUES};
use crate::gradients::Steps;
use crate::work::{Method, POINT_VALUES, Work};

/// A computation with the lengths of its arrays.
pub struct Job {
    /// The computation.
    pub work: Work,
    /// The number of results of each row.
    pub result: usize,
    /// The number of given values of each row.
    pub given: usize,
    /// The number of steps whose inputs may differ, zero if there are no steps.
    pub steps: usize,
}

impl Job {
    /// Returns the job of a name with its arguments.
    pub fn of(chain: &dyn Blocks, name: &str, arguments: &Bound<'_, PyTuple>) -> PyResult<Self> {
        let of = chain.description();
        let plain = |work, result| Job { work, result, given: 0, steps: 0 };
        Ok(match name {
            "rollout" => {
                let (name, h, n, every): (String, f64, usize, usize) = arguments.extract()?;
                if every == 0 {
                    return Err(PyValueError::new_err("every must be positive"));
                }
                let work = Work::Steps { method: method(&name)?, step: step(h)?, steps: n, every };
                Job { steps: n, ..plain(work, (n / every + 1) * state_len(of)) }
            }
            "pullback" => {
                let (h, count): (f64, usize) = arguments.extract()?;
                let work = Work::Pullback(Steps { step: step(h)?, count });
                let state = state_len(of);
                let result = state + count * of.inputs().len() + of.parameters().len();
                Job { steps: count, given: 2 * (count + 1) * state, ..plain(work, result) }
            }
            "pushforward" => {
                let (h, count): (f64, usize) = arguments.extract()?;
                let work = Work::Pushforward(Steps { step: step(h)?, count });
                let given = 2 * of.rates().len() + of.parameters().len();
                Job { steps: count, given, ..plain(work, (count + 1) * state_len(of)) }
            }
            "accelerations" => plain(Work::Accelerations, of.rates().len()),
            "energies" => plain(Work::Energies, 2),
            "assembly" => plain(Work::Assembly, state_len(of)),
            "solution" => {
                let points = POINT_VALUES * of.points().len();
                plain(Work::Solution, of.accelerations().len() + of.efforts().len() + 2 + points)
            }
            "answer" => {
                let (index,): (usize,) = arguments.extract()?;
                let answer = Answer::ALL.get(index).copied();
                let answer = answer.ok_or_else(|| PyIndexError::new_err("no such answer"))?;
                let result = answer.len(of, chain.dynamic_parameters());
                Job { given: answer.given(of), ..plain(Work::Answer(answer), result) }
            }
            "motion" => {
                let (body, frame, rows): (usize, String, usize) = arguments.extract()?;
                let frame = chain.frame(body, &frame);
                let frame = frame.ok_or_else(|| PyIndexError::new_err("no such frame"))?;
                plain(Work::Motion(frame), MOTION_VALUES + rows * of.rates().len())
            }
            _ => return Err(PyValueError::new_err(format!("no job '{name}'"))),
        })
    }
}

/// Returns the number of coordinates and rates.
pub fn state_len(of: &Description) -> usize {
    of.coordinates().len() + of.rates().len()
}

/// Returns the method of integration of a name.
pub fn method(name: &str) -> PyResult<Method> {
    let found = Method::ALL.iter().find(|(known, _)| *known == name);
    found.map(|(_, method)| *method).ok_or_else(|| {
        let known: Vec<&str> = Method::ALL.iter().map(|(known, _)| *known).collect();
        PyValueError::new_err(format!("method must be one of {}, not '{name}'", known.join(", ")))
    })
}

/// Returns a count that is not negative.
pub fn count(name: &str, value: i64) -> PyResult<usize> {
    let refused = |_| PyValueError::new_err(format!("{name} must not be negative, not {value}"));
    usize::try_from(value).map_err(refused)
}

/// Returns a step that is checked.
pub fn step(h: f64) -> PyResult<f64> {
    match h.is_finite() && h != 0.0 {
        true => Ok(h),
        false => Err(PyValueError::new_err("h must be a finite step in s, and not zero")),
    }
}
