//! The declarations of functions that depend on the description.

use super::super::Model;
use super::super::functions::{Argument, Function, Shape, Size};
use super::declarations::{errors, function};
use super::upper;

/// Returns the declaration of a function.
pub(super) fn declaration(model: &Model, of: &Function) -> String {
    let prefix = &model.prefix;
    let mut docs = of.docs.to_string();
    for argument in of.given.iter().chain(&of.results) {
        docs += &documented(model, argument);
    }
    let mut arguments = vec![format!("const {prefix} *chain")];
    if of.of_state {
        arguments.push(format!("const {prefix}_state *state"));
        arguments.push(format!("const {prefix}_inputs *inputs"));
    }
    arguments.extend(of.given.iter().map(|it| declared(model, it, "const ")));
    arguments.extend(of.results.iter().map(|it| declared(model, it, "")));
    let what = if of.results.len() == 1 { "the result is" } else { "the results are" };
    let index = match of.given.iter().any(|it| it.shape == Shape::Frame) {
        true => "MSTMM_INDEX, ",
        false => "",
    };
    let errors = match of.of_state {
        true => format!("{index}{}", errors(model, of.may_be_singular, what)),
        false => String::new(),
    };
    function(&docs, &errors, &format!("{prefix}_{}", of.name), &arguments)
}

fn declared(model: &Model, argument: &Argument, qualifier: &str) -> String {
    let Argument { name, shape, .. } = argument;
    match shape {
        Shape::Frame => format!("int32_t {name}"),
        Shape::Vector(_) | Shape::Matrix(..) => format!("{qualifier}mstmm_real *{name}"),
        Shape::Struct(ty, _) => format!("{qualifier}{}_{ty} *{name}", model.prefix),
    }
}

/// Returns what an argument is, and its size.
fn documented(model: &Model, argument: &Argument) -> String {
    let Argument { name, docs, shape, .. } = argument;
    let size = |size: Size| size.in_c(&upper(model), model.dimension());
    let what = if docs.is_empty() { String::new() } else { format!(" is {docs}") };
    match shape {
        Shape::Vector(of) if docs.is_empty() => format!("\n * `{name}` has {} numbers.", size(*of)),
        Shape::Vector(of) => {
            let count = size(*of);
            let ending = if count == "1" { "" } else { "s" };
            format!("\n * `{name}`{what}: {count} number{ending}.")
        }
        Shape::Matrix(rows, columns) => {
            let what = if docs.is_empty() { String::new() } else { format!("{what};") };
            let verb = if docs.is_empty() { "has" } else { "it has" };
            format!(
                "\n * `{name}`{what} {verb} {} rows with {} numbers each.",
                size(*rows),
                size(*columns)
            )
        }
        Shape::Frame => format!("\n * `{name}`{what}: {}_FRAME_...", upper(model)),
        Shape::Struct(..) if docs.is_empty() => String::new(),
        Shape::Struct(..) => format!("\n * `{name}`{what}."),
    }
}
