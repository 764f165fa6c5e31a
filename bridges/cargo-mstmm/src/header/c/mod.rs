//! The text of the header.

mod answers;
mod declarations;
mod structs;
mod tables;

use super::common::CODES;
use super::names::Constants;
use super::{Library, Model};

const TOP: &str = include_str!("../top.h.txt");

/// Returns the header around the declarations of its chains.
pub fn header(library: &Library, chains: &str) -> String {
    let guard = format!("{}_H", library.name.to_uppercase());
    let names: Vec<String> =
        library.chains.iter().map(|model| format!("`{}`", model.chain)).collect();
    let code = |(at, (name, meaning)): (usize, &(&str, &str))| {
        let comma = if at + 1 == CODES.len() { "" } else { "," };
        format!("    MSTMM_{name} = {at}{comma} /* {meaning} */\n")
    };
    let codes: String = CODES.iter().enumerate().map(code).collect();
    TOP.replace("{guard}", &guard)
        .replace("{names}", &names.join(", "))
        .replace("{real}", library.scalar.in_c())
        .replace("{codes}", &codes)
        .replace("{chains}", chains)
}

/// Returns the declarations of a chain.
pub fn chain(model: &Model, constants: &mut Constants) -> String {
    [
        overview(model),
        counts(model, constants),
        tables::of(model, constants),
        structs::of(model),
        declarations::always(model),
        declarations::parameters(model),
        model.functions.all.iter().map(|function| answers::declaration(model, function)).collect(),
        declarations::closing(model),
    ]
    .concat()
}

/// Returns a text that ends no comment and begins none.
fn comment(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *").replace("??", "? ?")
}

fn overview(model: &Model) -> String {
    let mut lines = vec![format!("Chain `{}`", model.chain), String::new()];
    if !model.tables.docs.is_empty() {
        lines.extend(model.tables.docs.iter().map(|line| comment(line.trim_end())));
        lines.push(String::new());
    }
    lines.extend(model.tables.routes.iter().map(|route| format!("    {}", comment(route))));
    let missing = &model.functions.missing;
    if !missing.is_empty() {
        lines.push(String::new());
        lines.push("Of what the chain has in Rust, this header does not have:".into());
        lines.extend(missing.iter().map(|name| format!("    {name}")));
    }
    let line = |line: String| if line.is_empty() { " *\n".into() } else { format!(" * {line}\n") };
    let lines: String = lines.into_iter().map(line).collect();
    format!("/*{}\n{lines} */\n\n", " -".repeat(38))
}

fn upper(model: &Model) -> String {
    model.prefix.to_uppercase()
}

fn counts(model: &Model, constants: &mut Constants) -> String {
    let tables = &model.tables;
    let mut counts = vec![
        ("coordinates", tables.coordinates.length),
        ("rates", tables.rates.length),
        ("inputs", tables.inputs.length),
        ("parameters", tables.parameters.length),
        ("hinges", tables.hinges.len()),
        ("points", tables.points.length),
    ];
    if model.functions.use_dynamic_parameters() {
        counts.push(("dynamic_parameters", tables.dynamic_parameters.length));
    }
    let mut line = |(at, (what, count)): (usize, &(&str, usize))| {
        let comma = if at + 1 == counts.len() { "" } else { "," };
        format!("    {} = {count}{comma}\n", constants.name(&upper(model), what))
    };
    let lines: String = counts.iter().enumerate().map(&mut line).collect();
    format!(
        "/* The number of each. Of a repeated part each repetition counts, except in the number of hinges. */\nenum {{\n{lines}}};\n\n"
    )
}
