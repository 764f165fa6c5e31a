//! `screw(z, 5 mm/rev) name`: rotation about an axis with a proportional translation along it.

use super::axis::{axis, is_axis, unit};
use super::{ArgumentRule, Kind};
use crate::model::lower::context::Context;
use crate::model::lower::dimension::PITCH;
use crate::model::{Dimension, HingeKind, Value};
use crate::syntax::ArgumentsSyntax;

const EXAMPLE: &str = "screw(z, 5 mm/rev)";

pub(super) const KIND: Kind =
    Kind { word: "screw", name: "a screw", plain, takes: ArgumentRule::Needed(read, EXAMPLE) };

fn plain(space: Dimension) -> Option<HingeKind> {
    let screw = || HingeKind::Screw { axis: unit(2), pitch: Value::number(0.0) };
    (space == Dimension::Space).then(screw)
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    let (along, pitch) = match &arguments.values[..] {
        [only] if is_axis(only) => {
            let message = format!("`screw` needs a pitch as well: write `{EXAMPLE}`");
            return context.refuse(only.extent(), message);
        }
        [pitch] => (Some(unit(2)), pitch),
        [first, last] if is_axis(last) && !is_axis(first) => {
            return context.refuse(last.extent(), format!("the axis comes first: `{EXAMPLE}`"));
        }
        [along, pitch] => (axis(along, context), pitch),
        _ => {
            let message = format!("a screw has an axis and a pitch, such as `{EXAMPLE}`");
            return context.refuse(arguments.extent, message);
        }
    };
    let pitch = context.read_number(pitch, PITCH);
    Some(HingeKind::Screw { axis: along?, pitch: pitch? })
}
