//! The functions that depend on the description.

use super::super::Model;
use super::super::functions::{Argument, Function, Shape};
use super::exported;

/// Returns a function.
pub(super) fn function(model: &Model, of: &Function) -> String {
    let prefix = &model.prefix;
    let pointers = |argument: &&Argument| argument.shape != Shape::Frame;
    let given = of.given.iter().map(|it| match it.shape {
        Shape::Frame => format!("    {}: i32,\n", it.name),
        _ => format!("    {}: Option<&{}>,\n", it.name, rust(model, it)),
    });
    let results = of
        .results
        .iter()
        .map(|it| format!("    {}: Option<&mut MaybeUninit<{}>>,\n", it.name, rust(model, it)));
    let (arguments, convert, state) = match of.of_state {
        true => (
            "    state: Option<&State>,\n    inputs: Option<&Inputs>,\n",
            "let (state, inputs) = ((*state).into(), (*inputs).into());\n    ",
            vec!["state", "inputs"],
        ),
        false => ("", "", vec![]),
    };
    // Functions with the caller's storage do not check quaternions.
    let check = match of.of_state && model.has_quaternions() {
        true => {
            "let checked = chain.check_state(&state).and_then(|()| chain.check_inputs(&inputs));\n    \
             if checked.is_err() {\n        return Status::of(checked, &HINGES);\n    }\n    "
        }
        false => "",
    };
    // A result and what it is computed from have one name, so the place of the result has another.
    let place = |it: &Argument| format!("to_{}", it.name);
    let given_pointers = of.given.iter().filter(pointers);
    let taken: Vec<(String, String)> = std::iter::once(("model".to_owned(), "model".to_owned()))
        .chain(state.iter().map(|name| ((*name).to_owned(), (*name).to_owned())))
        .chain(given_pointers.map(|it| (it.name.to_owned(), it.name.to_owned())))
        .chain(of.results.iter().map(|it| (it.name.to_owned(), place(it))))
        .collect();
    let from: Vec<&str> = taken.iter().map(|(name, _)| &**name).collect();
    let to: Vec<String> = taken.iter().map(|(_, place)| format!("Some({place})")).collect();
    let writes: String = of
        .results
        .iter()
        .map(|it| format!("\n        {}.write({});", place(it), it.value))
        .collect();
    let found = match of.results.iter().any(|it| it.value.contains("found")) {
        true => "found",
        false => "_",
    };
    exported(of.docs.lines().next().unwrap_or_default())
        + &format!(
            "pub extern \"C\" fn {prefix}_{name}(\n    model: Option<&Model>,\n{arguments}{}{}) -> Status {{\n    \
                 let ({}) =\n        ({})\n    else {{\n        return Status::NULL_POINTER;\n    }};\n    \
                 let chain = &model.chain;\n    \
                 {convert}{check}{compute}\n    \
                 let written = computed.map(|{found}| {{{writes}\n    }});\n    \
                 Status::of(written, &HINGES)\n}}\n\n",
            given.collect::<String>(),
            results.collect::<String>(),
            to.join(", "),
            from.join(", "),
            name = of.name,
            compute = of.compute,
        )
}

/// Returns the type of an argument.
fn rust(model: &Model, argument: &Argument) -> String {
    let size = |size: super::super::functions::Size| size.of(&model.tables, model.dimension());
    match argument.shape {
        Shape::Frame => "i32".to_owned(),
        Shape::Vector(of) => format!("[Real; {}]", size(of)),
        Shape::Matrix(rows, columns) => format!("[[Real; {}]; {}]", size(columns), size(rows)),
        Shape::Struct(_, name) => name.to_owned(),
    }
}

/// Returns the search for a frame on a body.
pub(super) fn frames(model: &Model) -> String {
    let rows: Vec<String> = model
        .frames()
        .map(|(first, body)| {
            let (count, repetitions) = (body.frames.len(), body.repetitions.unwrap_or(1));
            format!("[{first}, {count}, {repetitions}]")
        })
        .collect();
    format!(
        "/// The bodies: the first frame, the number of frames of one repetition, and the number of repetitions.\n\
         const BODIES: [[usize; 3]; {}] = [{}];\n\n\
         /// Returns the body, the repetition and the number of a frame.\n\
         fn frame_at(index: i32) -> Option<[usize; 3]> {{\n    \
             let index = usize::try_from(index).ok()?;\n    \
             BODIES.iter().enumerate().find_map(|(body, &[first, count, repetitions])| {{\n        \
                 let at = index.checked_sub(first)?;\n        \
                 let (repetition, number) = (at.checked_div(count)?, at.checked_rem(count)?);\n        \
                 (repetition < repetitions).then_some([body, repetition, number])\n    }})\n}}\n\n",
        rows.len(),
        rows.join(", "),
    )
}
