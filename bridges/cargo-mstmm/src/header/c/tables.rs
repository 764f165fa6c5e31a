//! The constants of a header: indices and numbers.

use super::super::Model;
use super::super::functions::Shape;
use super::super::names::Constants;
use super::{comment, upper};
use mstmm_codegen::emit::{Entry, NamedArray};

/// Returns the constants of a chain.
pub(super) fn of(model: &Model, constants: &mut Constants) -> String {
    let (upper, tables) = (upper(model), &model.tables);
    let mut text = table(
        "The indices of coordinates: the entries of `q`. The components w, x, y, z of a unit quaternion rotate\n * components in the outboard frame to components in the inboard frame.",
        &format!("{upper}_Q"),
        &tables.coordinates,
        constants,
    );
    text += &table(
        "The indices of rates: the entries of `v`, of accelerations and of efforts. The rates of a quaternion are\n * the angular velocity of the outboard frame relative to the inboard frame, in the outboard frame.",
        &format!("{upper}_V"),
        &tables.rates,
        constants,
    );
    text += &table(
        "The indices of inputs: the entries of `u`. The effort of a motor increases its rate if it is positive.\n * Forces and torques of loads have the axes that the description states.",
        &format!("{upper}_U"),
        &tables.inputs,
        constants,
    );
    if model.has_points() {
        text += &table(
            "The indices of connection points. The input of an element is the output of the previous one.",
            &format!("{upper}_AT"),
            &tables.points,
            constants,
        );
    }
    let last = tables.hinges.len().saturating_sub(1);
    let lines = tables.hinges.iter().enumerate().map(|(at, hinge)| {
        let name = constants.name(&format!("{upper}_HINGE"), &hinge.path);
        let comma = if at == last { "" } else { "," };
        let mut what = format!("{}, {}", comment(&hinge.path), hinge.keyword);
        if hinge.repetitions > 1 {
            what += &format!(", {} times", hinge.repetitions);
        }
        if hinge.is_prescribed {
            what += ", prescribed motion";
        }
        if hinge.has_motor {
            what += ", motor";
        }
        format!("    {name} = {at}{comma} /* {what} */\n")
    });
    let lines: String = lines.collect();
    if !lines.is_empty() {
        text += &format!(
            "/* The hinges, for `hinge` of a status. All repetitions of a hinge are one. */\nenum {{\n{lines}}};\n\n"
        );
    }
    text += &frames(model, constants);
    if model.functions.use_dynamic_parameters() {
        text += &table(
            "The indices of dynamic parameters: the columns of the regressor. First moments are mass times centre of mass,\n * inertias are about the input of the body.",
            &format!("{upper}_DYNAMIC"),
            &tables.dynamic_parameters,
            constants,
        );
    }
    text
}

/// Returns the constants of an array: an enumerator for each entry, a macro with the repetition for entries of a repeated
/// part.
fn table(docs: &str, prefix: &str, array: &NamedArray, constants: &mut Constants) -> String {
    let (mut single, mut macros) = (Vec::new(), String::new());
    for entry in &array.entries {
        let name = constants.name(prefix, &entry.path);
        let what = described(entry);
        match entry.repeated {
            None => single.push((format!("    {name} = {}", entry.index), what)),
            Some([count, stride]) => {
                let range = format!("i from 0 to {}", count - 1);
                macros += &format!(
                    "#define {name}(i) ({} + {stride} * (i)) /* {what}; {range} */\n",
                    entry.index
                );
            }
        }
    }
    if array.length == 0 {
        return String::new();
    }
    let last = single.len().saturating_sub(1);
    let line = |(at, (text, what)): (usize, (String, String))| {
        format!("{text}{} /* {what} */\n", if at == last { "" } else { "," })
    };
    let lines: String = single.into_iter().enumerate().map(line).collect();
    let lines = if lines.is_empty() { lines } else { format!("enum {{\n{lines}}};\n") };
    format!("/* {docs} */\n{lines}{macros}\n")
}

fn described(entry: &Entry) -> String {
    let path = comment(&entry.path.replace("[]", "[i]"));
    let unit = match &*entry.unit {
        "" | "1" => String::new(),
        unit => format!(", {unit}"),
    };
    let start = match entry.start {
        Some(start) if start != 0.0 => format!("; starts at {start}"),
        _ => String::new(),
    };
    format!("{path}{unit}{start}")
}

/// Returns the constants of frames on bodies: body by body, all frames of a repetition before those of the next one.
fn frames(model: &Model, constants: &mut Constants) -> String {
    if !model.functions.use_shape(Shape::Frame) {
        return String::new();
    }
    let prefix = format!("{}_FRAME", upper(model));
    let (mut single, mut macros) = (String::new(), String::new());
    for (first, body) in model.frames() {
        for (number, frame) in body.frames.iter().enumerate() {
            let index = first + number;
            let path = comment(&format!("{}.{frame}", body.path));
            let name = constants.name(&prefix, &format!("{}.{frame}", body.path));
            match body.repetitions {
                None => single += &format!("    {name} = {index}, /* {path} */\n"),
                Some(count) => {
                    let (stride, last) = (body.frames.len(), count - 1);
                    macros += &format!(
                        "#define {name}(i) ({index} + {stride} * (i)) /* {path} of repetition i from 0 to {last} */\n"
                    );
                }
            }
        }
    }
    let count =
        format!("    {} = {}\n", constants.name(&upper(model), "frames"), model.frame_count());
    format!(
        "/* The indices of frames on bodies: inputs, outputs, centres of mass and named points, and their number. */\n\
         enum {{\n{single}{count}}};\n{macros}\n"
    )
}
