//! The declarations of functions that all chains have.

use super::super::Model;
use super::super::functions::is_closed;
use super::comment;

/// Returns a declaration with its documentation and its errors.
pub(super) fn function(docs: &str, errors: &str, name: &str, arguments: &[String]) -> String {
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
pub(super) fn errors(model: &Model, may_be_singular: bool, what: &str) -> String {
    let mut codes = vec!["MSTMM_NOT_FINITE"];
    codes.extend(may_be_singular.then_some("MSTMM_SINGULAR"));
    codes.extend(model.has_quaternions().then_some("MSTMM_QUATERNION"));
    format!("{}; {what} then unchanged.", codes.join(", "))
}

/// Returns the functions that all chains have.
pub(super) fn always(model: &Model) -> String {
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

/// Returns the functions that set and read parameters.
pub(super) fn parameters(model: &Model) -> String {
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

/// Returns the functions that cannot fail, and the checks of sizes.
pub(super) fn closing(model: &Model) -> String {
    let prefix = &model.prefix;
    format!(
        "/* Returns sizeof({prefix}) of the library, to check that header and library match. */\n\
         uint32_t {prefix}_size(void);\n\n\
         /* Returns the name of a hinge in the description; \"\" for an unknown hinge. */\n\
         const char *{prefix}_hinge_name(int32_t hinge);\n\n\
         /* The library checks the same size. */\n\
         typedef char {prefix}_has_its_size[sizeof({prefix}) == {} * sizeof(mstmm_real) ? 1 : -1];\n\n",
        model.size(),
    )
}
