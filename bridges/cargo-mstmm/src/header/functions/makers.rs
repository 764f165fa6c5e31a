//! Arguments and functions in C that several answers have.

use super::{Argument, Function, Shape, Size};
use std::borrow::Cow;

pub(super) fn rates(name: &'static str, docs: &'static str) -> Argument {
    let value = format!("{name}.into()");
    Argument { name, docs, shape: Shape::Vector(Size::Rates), value }
}

/// Returns a matrix as a result; rows in C are columns in nalgebra.
pub(super) fn matrix(
    name: &'static str,
    docs: &'static str,
    size: [Size; 2],
    value: &str,
) -> Argument {
    let [rows, columns] = size;
    let value = format!("{value}.transpose().into()");
    Argument { name, docs, shape: Shape::Matrix(rows, columns), value }
}

pub(super) fn square(name: &'static str) -> Argument {
    matrix(name, "", [Size::Rates, Size::Rates], name)
}

pub(super) fn structure(name: &'static str, docs: &'static str, shape: Shape) -> Argument {
    Argument { name, docs, shape, value: format!("{name}.into()") }
}

/// Returns a struct as a result that the computation returns.
pub(super) fn found(name: &'static str, shape: Shape) -> Argument {
    Argument { name, docs: "", shape, value: "found.into()".into() }
}

pub(super) fn accelerations() -> Argument {
    rates("accelerations", "the time derivatives of the rates")
}

/// Returns a function with one vector as its result, which a method with the ending `_into` computes.
pub(super) fn to_rates(
    name: &'static str,
    docs: &'static str,
    given: Option<Argument>,
    result: &'static str,
) -> Function {
    let arguments = match &given {
        None => "&state, &inputs".to_owned(),
        // Accelerations precede inputs, other vectors follow them.
        Some(Argument { name: "accelerations", .. }) => {
            "&state, &(*accelerations).into(), &inputs".to_owned()
        }
        Some(Argument { name, .. }) => format!("&state, &inputs, &(*{name}).into()"),
    };
    Function {
        name: name.into(),
        docs: docs.into(),
        may_be_singular: false,
        of_state: true,
        given: given.into_iter().collect(),
        results: vec![rates(result, "")],
        compute: format!(
            "let mut {result} = SVector::zeros();\n    \
             let computed = chain.{name}_into({arguments}, &mut {result});"
        ),
    }
}

/// Returns a function with other results.
pub(super) fn function(
    name: impl Into<Cow<'static, str>>,
    docs: impl Into<Cow<'static, str>>,
    (given, results): (Vec<Argument>, Vec<Argument>),
    compute: &str,
) -> Function {
    let (may_be_singular, of_state, compute) = (false, true, compute.to_owned());
    let (name, docs) = (name.into(), docs.into());
    Function { name, docs, may_be_singular, of_state, given, results, compute }
}

pub(super) fn singular(function: Function) -> Function {
    Function { may_be_singular: true, ..function }
}

/// Returns the function for a matrix with a row and a column for each rate.
pub(super) fn of_matrix(name: &'static str, docs: &'static str) -> Function {
    let compute = format!(
        "let mut matrix = SMatrix::zeros();\n    \
         let computed = chain.{name}_into(&state, &inputs, &mut matrix);"
    );
    function(name, docs, (vec![], vec![square("matrix")]), &compute)
}
