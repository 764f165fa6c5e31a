//! Angles without a unit: they are in radians, and large ones are most likely meant in degrees.

use std::f64::consts::TAU;

use super::context::{Context, KnownParameter, Measure};
use super::dimension::{ANGLE, Quantity};
use super::number::Measured;
use crate::syntax::{ExprKind, ExprSyntax};

/// The name of the warning.
const RULE: &str = "ANGLE_WITHOUT_UNIT";

impl Context<'_> {
    /// Warns about an angle of more than one turn without a unit, unless it is written with `PI`.
    /// For a parameter the default is checked, and the warning is at the default.
    pub fn warn_of_degrees(&mut self, found: &Measured, expr: &ExprSyntax, expected: &Quantity) {
        if expected.dimension != ANGLE.dimension || found.measure != Measure::Plain {
            return;
        }
        let defaults: Vec<_> = self.parameters.iter().map(|parameter| parameter.default).collect();
        let Some(angle) = found.value.at(&defaults).filter(|angle| angle.is_finite()) else {
            return;
        };
        if angle.abs() <= TAU || uses_pi(expr, self.parameters.as_slice()) {
            return;
        }
        let edited = without_sign(default_of(expr, self.parameters.as_slice()));
        let message = match edited.kind {
            ExprKind::Number(number) => {
                let number = shown(number);
                format!(
                    "`{number}` is an angle of {number} rad, {}: \
                     write `{number} deg` for degrees, or `{number} rad` if radians are meant",
                    turns(angle)
                )
            }
            _ => format!(
                "this angle without a unit is {} rad, {}: \
                 write `(…) deg` for degrees, or `(…) rad` if radians are meant",
                shown((10.0 * angle).round() / 10.0),
                turns(angle)
            ),
        };
        self.diagnostics.warn(edited.extent.first, RULE, message);
    }
}

/// Describes how many turns an angle is.
fn turns(angle: f64) -> String {
    match (angle.abs() / TAU).floor() {
        1.0 => "more than one turn".into(),
        turns => format!("more than {} turns", shown(turns)),
    }
}

/// Formats a number for a message.
fn shown(number: f64) -> String {
    if number.abs() < 1e9 { number.to_string() } else { format!("{number:e}") }
}

/// The parameter of this name.
fn parameter<'p, 'a>(
    expr: &ExprSyntax,
    parameters: &'p [KnownParameter<'a>],
) -> Option<&'p KnownParameter<'a>> {
    let ExprKind::Name(name) = &expr.kind else { return None };
    parameters.iter().find(|parameter| parameter.name == name)
}

/// Returns the expression to edit: the default of a parameter, or the angle itself.
fn default_of<'e>(expr: &'e ExprSyntax, parameters: &[KnownParameter<'e>]) -> &'e ExprSyntax {
    let default =
        parameter(without_sign(expr), parameters).and_then(|parameter| parameter.default_expr);
    default.unwrap_or(expr)
}

/// Returns the number without its signs and without the parentheses of a name.
fn without_sign(mut expr: &ExprSyntax) -> &ExprSyntax {
    loop {
        expr = match &expr.kind {
            ExprKind::Parenthesized(inner) | ExprKind::Negated(inner) => inner,
            ExprKind::Argument(_, argument) => argument,
            _ => return expr,
        };
    }
}

/// Whether `PI` is part of an expression, or of the default of a parameter in it.
fn uses_pi(expr: &ExprSyntax, parameters: &[KnownParameter]) -> bool {
    let any = |expr: &ExprSyntax| uses_pi(expr, parameters);
    match &expr.kind {
        ExprKind::Number(_) | ExprKind::Path(_) | ExprKind::Lost => false,
        ExprKind::Argument(_, argument) => any(argument),
        ExprKind::Name(name) if name == "PI" => true,
        // No default uses another parameter.
        ExprKind::Name(_) => parameter(expr, parameters)
            .and_then(|parameter| parameter.default_expr)
            .is_some_and(any),
        ExprKind::Parenthesized(inner)
        | ExprKind::Negated(inner)
        | ExprKind::Power(inner, _)
        | ExprKind::Quantity(inner, _) => any(inner),
        ExprKind::Sum(terms) => terms.iter().any(|term| any(&term.expr)),
        ExprKind::Product(factors) => factors.iter().any(|factor| any(&factor.expr)),
        ExprKind::Call(_, arguments) => arguments.iter().any(any),
    }
}
