//! The arguments of an instance of a part.

use proc_macro2::Ident;
use std::collections::HashMap;
use std::rc::Rc;

use super::substitute::{FormulaSize, Substitution};
use crate::diag::Diagnostics;
use crate::model::lower::fields::listed;
use crate::syntax::{ArgumentsSyntax, ExprKind, ExprSyntax, PartSyntax, SpanRange, ValueSyntax};

/// Returns the arguments by the names of the parameters and reports wrong ones; `None` for a part without parameters.
pub(super) fn substitution(
    part: &PartSyntax,
    word: &Ident,
    name: &Ident,
    arguments: Option<&ArgumentsSyntax>,
    diagnostics: &mut Diagnostics,
) -> Option<Substitution> {
    let given = arguments.map_or(&[][..], |arguments| &arguments.values);
    if given.len() != part.parameters.len() {
        let at = arguments.map_or(SpanRange::from(word), |arguments| arguments.extent);
        diagnostics.error_over(at, wrong_count(part, given.len()));
    }
    if part.parameters.is_empty() {
        return None;
    }
    let right_count = given.len() == part.parameters.len();
    let argument = |(index, parameter): (usize, &Ident)| {
        let given = given.get(index).filter(|_| right_count);
        let expr = given.and_then(|value| number(value, diagnostics));
        let lost = || ExprSyntax { kind: ExprKind::Lost, extent: SpanRange::from(word) };
        (parameter.to_string(), Rc::new(expr.unwrap_or_else(lost)))
    };
    let numbers: HashMap<_, _> = part.parameters.iter().enumerate().map(argument).collect();
    let written: Vec<String> = given.iter().map(text).collect();
    let description = format!("{word}({}) {name}", written.join(", "));
    let instance = Some(diagnostics.add_instance(description));
    Some(Substitution { arguments: numbers, instance })
}

/// Returns the message for a wrong number of arguments.
fn wrong_count(part: &PartSyntax, found: usize) -> String {
    let name = &part.name;
    let parameters: Vec<String> = part.parameters.iter().map(ToString::to_string).collect();
    match parameters.len() {
        1 => format!("`{name}` takes 1 number, {}; found {found}", listed(&parameters)),
        count => format!("`{name}` takes {count} numbers, {}; found {found}", listed(&parameters)),
    }
}

/// Returns the number that an argument is.
fn number(value: &ValueSyntax, diagnostics: &mut Diagnostics) -> Option<ExprSyntax> {
    let ValueSyntax::Number(expr) = value else {
        let message = format!("an argument of a part is a number, found {}", value.described());
        diagnostics.error_over(value.extent(), message);
        return None;
    };
    let size = FormulaSize::of(expr);
    if size.is_lost {
        return None;
    }
    if size.is_too_large() {
        let message = "this argument is too long with the arguments in it written out: write a \
                       part of it as a `param` or a Rust `const`";
        diagnostics.error_over(expr.extent, message);
        return None;
    }
    Some(expr.clone())
}

/// Returns an argument as text for messages.
fn text(value: &ValueSyntax) -> String {
    match value {
        ValueSyntax::Number(expr) => number_text(expr).unwrap_or_else(|| "…".into()),
        _ => "…".into(),
    }
}

/// Returns a short number as text.
fn number_text(expr: &ExprSyntax) -> Option<String> {
    Some(match &expr.kind {
        ExprKind::Number(number) => number.to_string(),
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Path(path) => path.to_string().replace(' ', ""),
        ExprKind::Argument(_, inner) => number_text(inner)?,
        ExprKind::Parenthesized(inner) => format!("({})", number_text(inner)?),
        ExprKind::Negated(inner) => format!("-{}", number_text(inner)?),
        ExprKind::Quantity(inner, unit) => format!("{} {}", number_text(inner)?, unit.text()),
        _ => return None,
    })
}
