//! The text of the header.

use super::common::CODES;
use super::functions::{Function, is_closed, linearizes};
use super::names::Constants;
use super::{Library, Model};
use mstmm_codegen::emit::{Entry, NamedArray};
use mstmm_codegen::model::{Dimension, Results};

const TOP: &str = include_str!("top.h.txt");

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
        tables(model, constants),
        structs(model),
        functions(model),
        parameters(model),
        model.functions.iter().map(|function| answer(model, function)).collect(),
        closing(model),
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
    let missing = model.missing_answers();
    if !missing.is_empty() {
        lines.push(String::new());
        lines.push(format!("Answers without functions in C: {}.", missing.join(", ")));
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
    let counts = [
        ("coordinates", tables.coordinates.length),
        ("rates", tables.rates.length),
        ("inputs", tables.inputs.length),
        ("parameters", tables.parameters.length),
        ("hinges", tables.hinges.len()),
        ("points", tables.points.length),
    ];
    let mut line = |(at, (what, count)): (usize, &(&str, usize))| {
        let comma = if at + 1 == counts.len() { "" } else { "," };
        format!("    {} = {count}{comma}\n", constants.name(&upper(model), what))
    };
    let lines: String = counts.iter().enumerate().map(&mut line).collect();
    format!(
        "/* The number of each. Of a repeated part each repetition counts, except in the number of hinges. */\nenum {{\n{lines}}};\n\n"
    )
}

fn tables(model: &Model, constants: &mut Constants) -> String {
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

/// Returns a field with a comment.
fn field(ty: &str, name: &str, comment: &str) -> String {
    format!("    {ty} {name}; /* {comment} */\n")
}

fn structs(model: &Model) -> String {
    let (prefix, upper, tables) = (&model.prefix, upper(model), &model.tables);
    let length = |array: &NamedArray, name: &str| match array.length {
        0 => ("1".to_owned(), "unused; "),
        _ => (format!("{upper}_{name}"), ""),
    };
    let (q, no_q) = length(&tables.coordinates, "COORDINATES");
    let (v, no_v) = length(&tables.rates, "RATES");
    let (u, no_u) = length(&tables.inputs, "INPUTS");
    let mut text = format!(
        "/* The chain with its parameters and its integrator. The contents are private; it may be copied by assignment. */\n\
         typedef struct {prefix} {{\n    mstmm_real numbers[{}];\n}} {prefix};\n\n\
         typedef struct {prefix}_state {{\n{}{}{}}} {prefix}_state;\n\n\
         typedef struct {prefix}_inputs {{\n{}}} {prefix}_inputs;\n\n",
        model.size(),
        field("mstmm_real", &format!("q[{q}]"), &format!("{no_q}coordinates")),
        field("mstmm_real", &format!("v[{v}]"), &format!("{no_v}rates")),
        field("mstmm_real", "t", "time, s"),
        field("mstmm_real", &format!("u[{u}]"), &format!("{no_u}all inputs")),
    );
    if model.has_points() {
        text += &format!(
            "/* A connection point and the frame that moves with it. */\n\
             typedef struct {prefix}_point {{\n{}}} {prefix}_point;\n\n",
            point(model)
        );
    }
    let mut results = field(
        "mstmm_real",
        &format!("accelerations[{v}]"),
        &format!("{no_v}time derivatives of the rates"),
    );
    if model.results().energies {
        results += &field("mstmm_real", "kinetic_energy", "J");
        results += &field(
            "mstmm_real",
            "potential_energy",
            "J, of gravity and springs; that of gravity is zero with all masses at the origin",
        );
    }
    if model.has_points() {
        results += &format!("    {prefix}_point points[{upper}_POINTS];\n");
    }
    text + &format!("typedef struct {prefix}_results {{\n{results}}} {prefix}_results;\n\n")
}

fn point(model: &Model) -> String {
    let Results { poses, velocities, z, .. } = model.results();
    let space = model.dimension() == Dimension::Space;
    let vector = |name: &str| match model.dimension() {
        Dimension::Space => format!("{name}[3]"),
        Dimension::Plane => format!("{name}[2]"),
        Dimension::Line => name.to_owned(),
    };
    let angular = |name: &str, comment: &str| match model.dimension() {
        Dimension::Space => field("mstmm_real", &format!("{name}[3]"), comment),
        Dimension::Plane => field("mstmm_real", name, comment),
        Dimension::Line => String::new(),
    };
    let mut text = String::new();
    if poses {
        text += &field("mstmm_real", &vector("position"), "m");
        if space {
            text += &field(
                "mstmm_real",
                "orientation[3][3]",
                "rows of the rotation matrix from components in the frame of the point to inertial components",
            );
        } else if model.dimension() == Dimension::Plane {
            text += &field(
                "mstmm_real",
                "cos_sin[2]",
                "cosine and sine of the angle of the frame of the point",
            );
        }
    }
    if velocities {
        text += &field("mstmm_real", &vector("velocity"), "m/s");
        text += &angular("angular_velocity", "rad/s");
    }
    if z {
        text += &field(
            "mstmm_real",
            &vector("acceleration"),
            "m/s^2, relative to the inertial frame: zero at rest",
        );
        text += &angular("angular_acceleration", "rad/s^2");
        text += &angular(
            "moment",
            "N m, acts on the part inboard of the point; its opposite acts on the part outboard of it",
        );
        text += &field(
            "mstmm_real",
            &vector("force"),
            "N, acts on the part outboard of the point; its opposite acts on the part inboard of it",
        );
    }
    text
}

/// Returns a declaration with its documentation and its errors.
fn function(docs: &str, errors: &str, name: &str, arguments: &[String]) -> String {
    let errors = if errors.is_empty() { String::new() } else { format!("\n *\n * {errors}") };
    let line = format!("mstmm_status {name}({});", arguments.join(", "));
    let indent = format!(",\n{}", " ".repeat("mstmm_status (".len() + name.len()));
    let declaration = match line.len() {
        ..=100 => line,
        _ => format!("mstmm_status {name}({});", arguments.join(&indent)),
    };
    format!("/* {docs}{errors} */\n{declaration}\n\n")
}

/// Returns the errors of a function that uses a state.
fn errors(model: &Model, may_be_singular: bool, what: &str) -> String {
    let quaternions =
        model.tables.coordinates.entries.iter().any(|entry| entry.path.ends_with(".w"))
            || model.tables.inputs.entries.iter().any(|entry| entry.path.ends_with(".w"));
    let mut codes = vec!["MSTMM_NOT_FINITE"];
    codes.extend(may_be_singular.then_some("MSTMM_SINGULAR"));
    codes.extend(quaternions.then_some("MSTMM_QUATERNION"));
    format!("{}; {what} then unchanged.", codes.join(", "))
}

fn functions(model: &Model) -> String {
    let prefix = &model.prefix;
    let own = |name: &str| format!("{prefix} *{name}");
    let (constant, state, inputs) = (
        format!("const {prefix} *chain"),
        format!("{prefix}_state *state"),
        format!("const {prefix}_inputs *inputs"),
    );
    let mut text = function(
        "Initialises a chain with default parameters and a step of `step` seconds; a negative step goes back in time.\n \
         * Must be called before any other function with this chain.",
        "MSTMM_NOT_FINITE if the step is NaN or infinite.",
        &format!("{prefix}_init"),
        &[own("chain"), "mstmm_real step".into()],
    );
    text += &function(
        "Sets the step in seconds.",
        "MSTMM_NOT_FINITE if the step is NaN or infinite.",
        &format!("{prefix}_set_step"),
        &[own("chain"), "mstmm_real step".into()],
    );
    text += &function(
        "Writes inputs that are zero; prescribed motions are at rest in the zero position.",
        "",
        &format!("{prefix}_no_inputs"),
        &[format!("{prefix}_inputs *inputs")],
    );
    text += &function(
        "Writes the start that the description gives, at time zero.",
        "",
        &format!("{prefix}_initial_state"),
        &[constant.clone(), state.clone()],
    );
    if is_closed(&model.tables) {
        text += &function(
            "Closes the loop: moves a state to nearby coordinates and rates that satisfy the loop constraints.",
            &format!(
                "MSTMM_NOT_ASSEMBLED, MSTMM_CLOSURE_RANK, {}",
                errors(model, false, "the state is")
            ),
            &format!("{prefix}_assemble"),
            &[constant.clone(), state.clone(), inputs.clone()],
        );
    }
    let closure = if is_closed(&model.tables) { "MSTMM_CLOSURE_RANK, " } else { "" };
    text += &function(
        &format!(
            "Takes one step by {}, with constant inputs. Quaternions have unit\n * length afterwards.",
            model.method.in_words()
        ),
        &format!("{closure}{}", errors(model, true, "the state is")),
        &format!("{prefix}_step"),
        &[own("chain"), state.clone(), inputs.clone()],
    );
    text + &function(
        "Computes the results in a state with these inputs.",
        &errors(model, true, "the results are"),
        &format!("{prefix}_solve"),
        &[
            constant,
            format!("const {prefix}_state *state"),
            inputs,
            format!("{prefix}_results *results"),
        ],
    )
}

fn parameters(model: &Model) -> String {
    let prefix = &model.prefix;
    let entries = model.tables.parameters.entries.iter().zip(&model.parameters);
    let text = entries.map(|(entry, name)| {
        let path = comment(entry.path.trim_end_matches("[]"));
        let unit = match &*entry.unit {
            "1" => String::new(),
            unit => format!(" in {unit}"),
        };
        let default = entry.start.map_or(String::new(), |default| format!(", initially {default}"));
        let (what, errors, index) = match entry.repeated {
            None => ("the parameter".to_owned(), "", None),
            Some([count, _]) => (
                format!("the value in repetition `index`, from 0 to {}, of the parameter", count - 1),
                "MSTMM_INDEX, ",
                Some("int32_t index".to_owned()),
            ),
        };
        let arguments = |chain: String, value: &str| -> Vec<String> {
            std::iter::once(chain).chain(index.clone()).chain([value.to_owned()]).collect()
        };
        function(
            &format!("Sets {what} `{path}`{unit}{default}."),
            &format!("{errors}MSTMM_PARAMETER if the chain cannot have this value; the old value is then kept."),
            &format!("{prefix}_set_{name}"),
            &arguments(format!("{prefix} *chain"), "mstmm_real value"),
        ) + &function(
            &format!("Reads {what} `{path}`{unit}."),
            errors.trim_end_matches(", "),
            &format!("{prefix}_get_{name}"),
            &arguments(format!("const {prefix} *chain"), "mstmm_real *value"),
        )
    });
    text.collect()
}

fn answer(model: &Model, of: &Function) -> String {
    let (prefix, upper) = (&model.prefix, upper(model));
    let Function { name, given, result, is_matrix, may_be_singular, docs } = *of;
    let given_docs = given.map_or(String::new(), |(name, docs)| {
        format!("\n * `{name}` is {docs}: {upper}_RATES numbers.")
    });
    let size = match is_matrix {
        true => format!("`{result}` has {upper}_RATES rows with {upper}_RATES numbers each."),
        false => format!("`{result}` has {upper}_RATES numbers."),
    };
    let mut arguments = vec![
        format!("const {prefix} *chain"),
        format!("const {prefix}_state *state"),
        format!("const {prefix}_inputs *inputs"),
    ];
    arguments.extend(given.map(|(name, _)| format!("const mstmm_real *{name}")));
    arguments.push(format!("mstmm_real *{result}"));
    function(
        &format!("{docs}{given_docs}\n * {size}"),
        &errors(model, may_be_singular, "the result is"),
        &format!("{prefix}_{name}"),
        &arguments,
    )
}

/// Returns the linearisation, the functions that cannot fail, and the checks of sizes.
fn closing(model: &Model) -> String {
    let (prefix, upper) = (&model.prefix, upper(model));
    let mut text = String::new();
    if linearizes(&model.tables) {
        let has_inputs = model.tables.inputs.length > 0;
        let (b, of_b) = match has_inputs {
            true => (
                Some("mstmm_real *b".to_owned()),
                format!("\n * `b` has 2 {upper}_RATES rows with {upper}_INPUTS numbers each."),
            ),
            false => (None, String::new()),
        };
        let mut arguments = vec![
            format!("const {prefix} *chain"),
            format!("const {prefix}_state *state"),
            format!("const {prefix}_inputs *inputs"),
            "mstmm_real *a".to_owned(),
        ];
        arguments.extend(b);
        text += &function(
            &format!(
                "Computes the linearised equations of motion dx/dt = a x + b u. x are small changes of the coordinates,\n \
                 * along the rates, and of the rates. `a` has 2 {upper}_RATES rows with 2 {upper}_RATES numbers each.{of_b}"
            ),
            &errors(model, true, "the results are"),
            &format!("{prefix}_linearize"),
            &arguments,
        );
    }
    text += &format!(
        "/* Returns sizeof({prefix}) of the library, to check that header and library match. */\n\
         uint32_t {prefix}_size(void);\n\n\
         /* Returns the name of a hinge in the description; \"\" for an unknown hinge. */\n\
         const char *{prefix}_hinge_name(int32_t hinge);\n\n\
         /* The library checks the same size. */\n\
         typedef char {prefix}_has_its_size[sizeof({prefix}) == {} * sizeof(mstmm_real) ? 1 : -1];\n\n",
        model.size(),
    );
    text
}
