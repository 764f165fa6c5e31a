//! The description of a chain for Python.

use mstmm::description::{Answer, Quantities};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::blocks::Blocks;

/// Returns names, units and sizes of a chain.
pub fn describe<'py>(py: Python<'py>, chain: &dyn Blocks) -> PyResult<Bound<'py, PyDict>> {
    let of = chain.description();
    let all = PyDict::new(py);
    all.set_item("name", of.name())?;
    all.set_item("docs", of.docs())?;
    for (key, list) in [
        ("coordinates", of.coordinates()),
        ("rates", of.rates()),
        ("accelerations", of.accelerations()),
        ("efforts", of.efforts()),
        ("inputs", of.inputs()),
        ("parameters", of.parameters()),
    ] {
        all.set_item(key, quantities(list))?;
    }
    let points: Vec<String> = of.points().iter().map(|point| point.name().to_string()).collect();
    all.set_item("points", points)?;
    let bodies: Vec<(String, &[&str])> = of
        .bodies()
        .iter()
        .enumerate()
        .map(|(index, body)| (body.name().to_string(), chain.frames(index)))
        .collect();
    all.set_item("bodies", bodies)?;
    let hinges: Vec<(String, &str, bool)> = of
        .hinges()
        .iter()
        .map(|hinge| (hinge.name().to_string(), hinge.keyword(), hinge.is_prescribed()))
        .collect();
    all.set_item("hinges", hinges)?;
    all.set_item("answers", of.answers())?;
    all.set_item("dimension", format!("{:?}", of.dimension()).to_lowercase())?;
    all.set_item("lanes", chain.lanes())?;
    all.set_item("methods", answers(py, chain)?)?;
    Ok(all)
}

/// A quantity: name, unit, start, limits, kind.
type Row = (String, &'static str, Option<f64>, Option<(f64, f64)>, String);

fn quantities(list: Quantities) -> Vec<Row> {
    list.iter()
        .map(|quantity| {
            let limits = quantity.limits.map(|[low, high]| (low, high));
            let kind = format!("{:?}", quantity.kind);
            (quantity.name.to_string(), quantity.unit, quantity.start, limits, kind)
        })
        .collect()
}

/// Returns all answers: name, keyword, whether the chain has it, number of given values, parts.
fn answers<'py>(py: Python<'py>, chain: &dyn Blocks) -> PyResult<Bound<'py, PyList>> {
    let (of, parameters) = (chain.description(), chain.dynamic_parameters());
    let all = PyList::empty(py);
    for answer in Answer::ALL {
        let part = |index| answer.part(of, parameters, index);
        let parts: Vec<(&str, usize, Option<usize>)> =
            (0..).map_while(part).map(|part| (part.name, part.rows, part.columns)).collect();
        let row = (answer.name(), answer.keyword(), chain.has(answer), answer.given(of), parts);
        all.append(row)?;
    }
    Ok(all)
}
