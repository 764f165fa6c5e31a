//! What the generated docs say of a chain.

use super::Plan;
use super::spread::Spread;
use crate::model::{Element, Method, Parameter, Place};
use crate::program::{Cost, Program};

/// The chain at a glance: its route, its elements, its freedoms, its method and costs.
pub fn chain(plan: &Plan) -> Vec<String> {
    let mut lines = vec![String::new(), " # The chain".into(), String::new()];
    lines.push(format!(" `{}`", route(plan)));
    lines.push(String::new());
    lines.push(" | element | kind | freedoms |".into());
    lines.push(" |---|---|---|".into());
    lines.extend(plan.chain.route.iter().map(|&element| row(plan, element)));
    lines.push(String::new());
    let cost = plan.programs.accelerations.cost();
    let freedoms = match (Spread::freedoms(plan).total, plan.programs.held) {
        (1, None) => "1 degree of freedom".to_owned(),
        (count, None) => format!("{count} degrees of freedom"),
        (count, Some(held)) => format!("{count} rates, closed over {held} directions"),
    };
    let each = if plan.chain.repeats.is_empty() {
        ""
    } else {
        "; those of repeated parts are counted once"
    };
    lines.push(format!(
        " {freedoms}; accelerations by `{}`, {} operations ({cost}); with everything at \
         every connection point {} operations{each}.",
        method_name(plan.programs.method),
        cost.arithmetic(),
        plan.programs.solution.cost().arithmetic(),
    ));
    lines
}

fn route(plan: &Plan) -> String {
    let chain = plan.chain;
    let ground = |place: &Place| matches!(place, Place::Ground(_)).then(|| "ground".to_owned());
    let hinge = |element: Option<&Element>| match element {
        Some(Element::Hinge(index)) => Some(&chain.hinges[*index]),
        _ => None,
    };
    let start = hinge(chain.route.first()).and_then(|hinge| ground(&hinge.inboard));
    let finish = hinge(chain.route.last()).and_then(|hinge| ground(&hinge.outboard));
    let elements = chain.route.iter().map(|element| match *element {
        Element::Body(index) => chain.bodies[index].name.to_string(),
        Element::Hinge(index) => {
            format!("{} {}", chain.hinges[index].kind.shape().word, chain.hinges[index].name)
        }
    });
    start.into_iter().chain(elements).chain(finish).collect::<Vec<_>>().join(" -> ")
}

fn row(plan: &Plan, element: Element) -> String {
    match element {
        Element::Body(index) => {
            let body = &plan.chain.bodies[index];
            let floats = plan.chain.hinges.iter().find(|hinge| hinge.name == body.name);
            let freedoms = floats.map_or(String::new(), |hinge| hinge.kind.freedoms().to_string());
            format!(" | `{}` | body `{}` | {freedoms} |", body.name, body.type_name)
        }
        Element::Hinge(index) => {
            let hinge = &plan.chain.hinges[index];
            format!(
                " | `{}` | {} | {} |",
                hinge.name,
                hinge.kind.shape().word,
                hinge.kind.freedoms()
            )
        }
    }
}

/// The operations of a program, section by section.
pub fn cost(program: &Program) -> Vec<String> {
    let total = program.cost();
    let mut lines = vec![
        format!(" {} operations: {total}.", total.arithmetic()),
        String::new(),
        " | section | equations | mul | add | reciprocal | square root | sin/cos |".into(),
        " |---|---|---|---|---|---|---|".into(),
    ];
    lines.extend(program.sections().map(|section| {
        let Cost { mul, add, recip, sqrt, trig } = section.cost();
        // Brackets would make links of the tags.
        let source = section.source.replace('[', "\\[").replace(']', "\\]");
        let title = &section.title;
        format!(" | {title} | {source} | {mul} | {add} | {recip} | {sqrt} | {trig} |")
    }));
    lines
}

/// A parameter with its unit.
pub fn parameter(parameter: &Parameter) -> String {
    let unit =
        if parameter.unit.is_empty() { String::new() } else { format!(" in {}", parameter.unit) };
    format!(" `{}`{unit}.", parameter.name)
}

/// The method's name.
fn method_name(method: Method) -> &'static str {
    match method {
        Method::Riccati => "riccati",
        Method::Transfer => "transfer",
    }
}
