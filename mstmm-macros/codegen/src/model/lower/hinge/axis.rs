//! Axes in the arguments of hinges.

use crate::model::lower::context::Context;
use crate::model::lower::dimension::NUMBER;
use crate::model::lower::vector::zeros;
use crate::model::{Dimension, Value, length};
use crate::syntax::{ArgumentsSyntax, ExprKind, ValueSyntax};

const NAMES: [&str; 3] = ["x", "y", "z"];

/// The axis of this index.
pub(super) fn unit(index: usize) -> [Value; 3] {
    let mut axis = zeros();
    if let Some(entry) = axis.get_mut(index) {
        *entry = Value::number(1.0);
    }
    axis
}

/// A word for an axis, with its sign. In a part it means the axis also where a parameter has this name, as in a chain.
fn word(syntax: &ValueSyntax) -> Option<(f64, usize)> {
    let ValueSyntax::Number(expr) = syntax else { return None };
    let (sign, expr) = match &expr.kind {
        ExprKind::Negated(inner) => (-1.0, &**inner),
        _ => (1.0, expr),
    };
    let (ExprKind::Name(word) | ExprKind::Argument(word, _)) = &expr.kind else { return None };
    Some((sign, NAMES.iter().position(|name| word == name)?))
}

/// Whether this is an axis, right or wrong.
pub(super) fn is_axis(syntax: &ValueSyntax) -> bool {
    matches!(syntax, ValueSyntax::Vector(_)) || word(syntax).is_some()
}

/// Returns the only argument of a hinge, its axis. A vector without brackets is reported with them, other arguments with
/// the message.
pub(super) fn only<'a>(
    word: &str,
    arguments: &'a ArgumentsSyntax,
    context: &mut Context,
    message: &str,
) -> Option<&'a ValueSyntax> {
    let values = &arguments.values[..];
    if let [syntax] = values {
        return Some(syntax);
    }
    let numbers: Option<Vec<String>> = values.iter().map(literal).collect();
    let is_vector = values.len() == context.space.translations().len();
    match numbers.filter(|_| is_vector) {
        Some(numbers) => {
            let message = format!("write an axis in brackets: `{word}([{}])`", numbers.join(", "));
            context.refuse(arguments.extent, message)
        }
        None => context.refuse(arguments.extent, message),
    }
}

/// Returns the text of a number without a unit.
fn literal(syntax: &ValueSyntax) -> Option<String> {
    let ValueSyntax::Number(expr) = syntax else { return None };
    match &expr.kind {
        ExprKind::Number(value) => Some(value.to_string()),
        ExprKind::Negated(inner) => match inner.kind {
            ExprKind::Number(value) => Some(format!("-{value}")),
            _ => None,
        },
        _ => None,
    }
}

/// An axis: a word or a vector. In a plane chain it lies in the plane.
pub(super) fn axis(syntax: &ValueSyntax, context: &mut Context) -> Option<[Value; 3]> {
    if let ValueSyntax::Vector(_) = syntax {
        return context.read_vector(syntax, NUMBER).map(length::within_bounds);
    }
    let axis = word(syntax).filter(|(_, index)| context.space.translations().contains(index));
    let Some((sign, index)) = axis else {
        let expected = match context.space {
            Dimension::Space => "`x`, `y`, `z`, `-x`, `-y`, `-z` or `[a, b, c]`",
            Dimension::Plane => "`x`, `y`, `-x`, `-y` or `[a, b]`",
            Dimension::Line => "`x` or `-x`",
        };
        return context.refuse(syntax.extent(), format!("expected an axis: {expected}"));
    };
    // `0 − x` instead of `−x`: the sign of a zero has no meaning here.
    Some(if sign < 0.0 { unit(index).map(Value::negated) } else { unit(index) })
}

/// Which axis a normal is: a word without a sign.
pub(super) fn normal(syntax: &ValueSyntax, context: &mut Context) -> Option<usize> {
    match word(syntax) {
        Some((sign, index)) if sign > 0.0 => Some(index),
        _ => context.refuse(syntax.extent(), "expected a normal: `x`, `y` or `z`"),
    }
}
