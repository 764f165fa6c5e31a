//! `pin(z) name`: turns about an axis.

use proc_macro2::Ident;

use super::{Kind, Motion};
use crate::model::lower::context::{Context, Given};
use crate::model::lower::dimension::{ANGLE, NUMBER, RATE, TORQUE};
use crate::model::lower::fields::Fields;
use crate::model::{HingeKind, Value};
use crate::syntax::{Arguments, Expr, ExprKind, Extent, Written};

pub(super) const KIND: Kind =
    Kind { word: "pin", name: "a pin", fields: &["start", "start_rate", "torque"], read, motion };

const AXES: &[(&str, [f64; 3])] =
    &[("x", [1.0, 0.0, 0.0]), ("y", [0.0, 1.0, 0.0]), ("z", [0.0, 0.0, 1.0])];

fn read(
    word: &Ident,
    arguments: Option<&Arguments>,
    context: &mut Context,
) -> Option<Given<HingeKind>> {
    let Some(arguments) = arguments else {
        // The paper's pin turns about ζ.
        let axis = [0.0, 0.0, 1.0].map(Value::number);
        return Some(Given { value: HingeKind::Pin { axis }, at: Extent::token(word.span()) });
    };
    let [axis] = &arguments.values[..] else {
        return context.refuse(arguments.extent, "a pin has one axis, such as `pin(z)`");
    };
    let at = axis.extent();
    axis_of(axis, context).map(|axis| Given { value: HingeKind::Pin { axis }, at })
}

fn axis_of(written: &Written, context: &mut Context) -> Option<[Value; 3]> {
    if let Written::Vector(list) = written {
        return context.vector(list, NUMBER);
    }
    let (sign, word) = match written {
        Written::Number(Expr { kind: ExprKind::Name(word), .. }) => (1.0, Some(word)),
        Written::Number(Expr { kind: ExprKind::Negated(inner), .. }) => match &inner.kind {
            ExprKind::Name(word) => (-1.0, Some(word)),
            _ => (1.0, None),
        },
        _ => (1.0, None),
    };
    let axis = word.and_then(|word| AXES.iter().find(|(name, _)| word == name));
    match axis {
        // `0 ·` instead of `−0`: the sign of a zero has no meaning here.
        Some((_, axis)) => Some(axis.map(|entry| Value::number(sign * entry + 0.0))),
        None => {
            let message = "expected an axis: `x`, `y`, `z`, `-x`, `-y`, `-z` or `[a, b, c]`";
            context.refuse(written.extent(), message)
        }
    }
}

fn motion(fields: &Fields, context: &mut Context) -> Option<Motion> {
    let zero = || vec![Value::number(0.0)];
    let start = context.optional(fields.get("start"), zero, |context, written| {
        context.written_number(written, ANGLE).map(|angle| vec![angle])
    });
    let start_rate = context.optional(fields.get("start_rate"), zero, |context, written| {
        context.written_number(written, RATE).map(|rate| vec![rate])
    });
    let effort = super::effort(fields.get("torque"), context, |context, written| {
        context.written_number(written, TORQUE).map(|torque| vec![torque])
    });
    Some(Motion { start: start?, start_rate: start_rate?, effort: effort? })
}
