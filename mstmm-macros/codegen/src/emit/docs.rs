//! The docs of a generated chain.

use super::{EmitContext, drawing, routes};
use crate::examine::Mobility;
use crate::model::{
    Answer, Attachment, Element, Parameter, Results, SolutionMethod, Value, listed,
};
use crate::program::{Cost, Procedure, SectionCost, by_heading};
use crate::syntax::PartInstance;

/// Returns the overview of a chain: route, picture, elements, degrees of freedom, method and operation counts.
pub fn chain(cx: &EmitContext) -> Vec<String> {
    let mut lines = vec![String::new(), " # The chain".into(), String::new()];
    lines.extend(match &routes::written(cx.chain)[..] {
        [route] => vec![format!(" `{route}`")],
        // Markdown would join lines to one paragraph.
        routes => routes.iter().map(|route| format!(" * `{route}`")).collect(),
    });
    lines.extend(cx.findings.start.iter().flat_map(drawing::picture));
    lines.push(String::new());
    lines.extend(instances(cx));
    lines.push(" | element | kind | degrees of freedom |".into());
    lines.push(" |---|---|---|".into());
    lines.extend(cx.chain.elements.iter().map(|&element| row(cx, element)));
    lines.push(String::new());
    lines.extend(mobility(cx));
    lines.push(String::new());
    let cost = cx.compiled.function(Answer::Accelerations).procedure.cost();
    let each = if cx.chain.repeats.is_empty() { "" } else { "; a repeated part counts once" };
    let whole = match cx.chain.results {
        Results::ALL => "all results at every connection point",
        _ => "the selected results",
    };
    lines.push(format!(
        " Accelerations by `{}`: {} operations ({cost}). With {whole}: {} operations{each}.",
        method_name(cx.compiled.method),
        cost.arithmetic(),
        cx.compiled.function(Answer::Solution).procedure.cost().arithmetic(),
    ));
    lines.extend(precision(cx));
    lines
}

/// Returns a list of the instances of parts with their doc comments.
fn instances(cx: &EmitContext) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for PartInstance { path, part, docs } in &cx.passthrough.instances {
        let texts = docs.iter().filter_map(doc_text);
        let text = texts.map(|line| line.trim().to_owned()).collect::<Vec<_>>().join(" ");
        let separator = if text.is_empty() { "" } else { ": " };
        lines.push(format!(" * `{path}`, part `{part}`{separator}{text}"));
    }
    if !lines.is_empty() {
        lines.push(String::new());
    }
    lines
}

/// Returns the lines of doc comments, without the space at their beginning.
pub fn written(attributes: &[syn::Attribute]) -> Vec<String> {
    let docs = attributes.iter().filter(|attribute| attribute.path().is_ident("doc"));
    let texts = docs.filter_map(doc_text);
    texts.map(|line| line.strip_prefix(' ').unwrap_or(&line).to_owned()).collect()
}

/// Returns the text of a doc comment.
fn doc_text(attribute: &syn::Attribute) -> Option<String> {
    let syn::Meta::NameValue(doc) = &attribute.meta else { return None };
    match &doc.value {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
        _ => None,
    }
}

/// The bound of the relative error of accelerations by `transfer`, in units of ε, divided by the sum of ten and the mass
/// ratio. It is more than twice the largest error of random chains (`tests/mass_ratio.rs`). Forces in N and
/// accelerations in m/s² are unknowns of the same equations, so masses above 1 kg also increase the error.
const TRANSFER_LOSS: f64 = 100.0;

/// Returns the precision of `transfer`, if it may lose digits because of the mass ratio.
fn precision(cx: &EmitContext) -> Vec<String> {
    let Some(ratio) = cx.findings.mass_ratio else { return Vec::new() };
    if cx.compiled.method == SolutionMethod::Riccati {
        return Vec::new();
    }
    let times = if ratio < 1e3 { format!("{ratio:.0}") } else { format!("{ratio:.1e}") };
    let error = |epsilon: f64| TRANSFER_LOSS * (10.0 + ratio) * epsilon;
    let text = format!(
        " **Precision of `transfer`.** The largest mass is {times} times the smallest mass or 1 kg, whichever is less, with \
         default parameters. `transfer` can lose digits by that factor: for bodies of similar size the relative \
         error of accelerations is up to {:.1e} in `f64` and {:.1e} in `f32`. The error of wrenches at the lightest bodies is up to a \
         hundred times larger. `riccati` does not lose digits.",
        error(f64::EPSILON),
        error(f32::EPSILON.into()),
    );
    vec![String::new(), text]
}

/// Lists the results of a solution.
pub fn results(cx: &EmitContext) -> String {
    let Results { poses, velocities, z, energies } = cx.chain.results;
    let chosen = |words: &[(bool, &'static str)]| -> Vec<&'static str> {
        words.iter().filter(|(given, _)| *given).map(|&(_, word)| word).collect()
    };
    let has_springs = z && !cx.chain.springs.is_empty();
    let once = chosen(&[
        (true, "accelerations"),
        (true, "efforts"),
        (energies, "energies"),
        (has_springs, "the state of every spring"),
    ]);
    let points = chosen(&[(poses, "pose"), (velocities, "velocity"), (z, "the state vector `z`")]);
    if points.is_empty() {
        return listed(&once);
    }
    format!("{} and, at every connection point, {}", once.join(", "), listed(&points))
}

/// Returns the degrees of freedom, and the constraints of a loop closure.
fn mobility(cx: &EmitContext) -> Vec<String> {
    let count = cx.rates().total;
    if cx.layout.loop_hinges.is_empty() {
        let noun = if count == 1 { "degree of freedom" } else { "degrees of freedom" };
        return vec![format!(" Mobility {count}: {count} {noun}.")];
    }
    let rates = if count == 1 { "rate" } else { "rates" };
    let Some(Mobility { dofs, constraints, redundant }) = cx.findings.mobility else {
        return vec![format!(" {count} {rates}; {} closes the loop.", closing_hinge(cx))];
    };
    let mut lines = vec![format!(
        " Mobility {dofs}: {count} {rates}, of which the loop constraints remove {}.",
        count - dofs
    )];
    if redundant > 0 {
        lines.push(String::new());
        lines.push(format!(
            " **Warning: the loop constraints are redundant.** {redundant} of the {constraints} directions that \
             {} constrains follow from the others. The motion is unique, but the reactions are not: \
             those of least norm are reported, and `closure()` of the workspace has the redundant directions.",
            closing_hinge(cx)
        ));
    }
    lines
}

/// Returns what the docs call the hinge that closes the loop.
fn closing_hinge(cx: &EmitContext) -> String {
    let closing = cx.layout.loop_hinges.first();
    let closing = *closing.unwrap_or_else(|| bug!("an open chain has no closing hinge"));
    match cx.chain.elements.last() {
        Some(&Element::Hinge(last)) if last == closing => "the last hinge".into(),
        _ => format!("hinge `{}`", cx.chain.hinges[closing].path),
    }
}

fn row(cx: &EmitContext, element: Element) -> String {
    match element {
        Element::Body(index) => {
            let body = &cx.chain.bodies[index];
            let floats = cx.chain.hinges.iter().find(|hinge| {
                hinge.outboard == Attachment::Input(index) && hinge.name == body.name
            });
            let dof_count =
                floats.map_or(String::new(), |hinge| hinge.kind.dof_count().to_string());
            let mass = body.mass.known().map_or(String::new(), |mass| format!(", {mass} kg"));
            format!(" | `{}` | body `{}`{mass} | {dof_count} |", body.path, body.type_name)
        }
        Element::Hinge(index) => {
            let hinge = &cx.chain.hinges[index];
            let kind = hinge.kind.spec().word;
            let motion = if hinge.is_prescribed() { ", prescribed motion" } else { "" };
            let axes: Vec<String> = hinge.kind.axes().iter().filter_map(axis).collect();
            let about = match &axes[..] {
                [] => String::new(),
                axes => format!("({})", axes.join(", ")),
            };
            let dof_count = if hinge.is_prescribed() { 0 } else { hinge.kind.dof_count() };
            format!(" | `{}` | {kind}{about}{motion} | {dof_count} |", hinge.path)
        }
    }
}

/// Returns an axis, if its components are known.
fn axis(axis: &[Value; 3]) -> Option<String> {
    let [x, y, z] = axis.each_ref().map(Value::known);
    let axis = [x?, y?, z?];
    let unit = (0..3).find(|&k| (0..3).all(|other| axis[other] == f64::from(u8::from(other == k))));
    Some(match unit {
        Some(k) => ["x", "y", "z"][k].to_owned(),
        // Brackets would make links.
        None => format!("{} {} {}", axis[0], axis[1], axis[2]),
    })
}

/// Returns the operation counts of a procedure by heading.
pub fn cost(procedure: &Procedure) -> Vec<String> {
    let total = procedure.cost();
    if total == Cost::default() {
        return Vec::new();
    }
    let mut lines = vec![
        String::new(),
        format!(" {} operations: {total}.", total.arithmetic()),
        String::new(),
        " | section | equations | mul | add | reciprocal | square root | sin/cos |".into(),
        " |---|---|---|---|---|---|---|".into(),
    ];
    lines.extend(by_heading(procedure.sections()).into_iter().map(
        |SectionCost { title, source, cost }| {
            let Cost { mul, add, recip, sqrt, trig } = cost;
            // Brackets would make links of the tags.
            let source = source.replace('[', "\\[").replace(']', "\\]");
            format!(" | {title} | {source} | {mul} | {add} | {recip} | {sqrt} | {trig} |")
        },
    ));
    lines
}

/// Returns the description of a parameter, with its unit.
pub fn parameter(parameter: &Parameter) -> String {
    let unit =
        if parameter.unit.is_empty() { String::new() } else { format!(" in {}", parameter.unit) };
    format!(" `{}`{unit}.", parameter.name)
}

/// Returns the name of a method.
fn method_name(method: SolutionMethod) -> &'static str {
    match method {
        SolutionMethod::Riccati => "riccati",
        SolutionMethod::Transfer => "transfer",
    }
}
