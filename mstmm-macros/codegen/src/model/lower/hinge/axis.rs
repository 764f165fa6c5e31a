//! Axes in the arguments of hinges.

use crate::model::lower::context::Context;
use crate::model::lower::dimension::NUMBER;
use crate::model::lower::vector::zeros;
use crate::model::{Dimension, Value, length};
use crate::syntax::{ExprKind, ExprSyntax, ValueSyntax};

const NAMES: [&str; 3] = ["x", "y", "z"];

/// The axis of this index.
pub(super) fn unit(index: usize) -> [Value; 3] {
    let mut axis = zeros();
    if let Some(entry) = axis.get_mut(index) {
        *entry = Value::number(1.0);
    }
    axis
}

/// A word for an axis, with its sign.
fn word(syntax: &ValueSyntax) -> Option<(f64, usize)> {
    let ValueSyntax::Number(expr) = syntax else { return None };
    let (sign, expr) = match &expr.kind {
        ExprKind::Negated(inner) => (-1.0, &**inner),
        _ => (1.0, expr),
    };
    let ExprSyntax { kind: ExprKind::Name(word), .. } = expr else { return None };
    Some((sign, NAMES.iter().position(|name| word == name)?))
}

/// Whether this is an axis, right or wrong.
pub(super) fn is_axis(syntax: &ValueSyntax) -> bool {
    matches!(syntax, ValueSyntax::Vector(_)) || word(syntax).is_some()
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
