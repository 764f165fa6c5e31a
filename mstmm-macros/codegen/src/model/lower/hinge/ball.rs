//! `ball name`: turns any way.

use proc_macro2::Ident;

use super::{Kind, Motion};
use crate::model::lower::context::{Context, Given};
use crate::model::lower::dimension::{RATE, TORQUE};
use crate::model::lower::fields::Fields;
use crate::model::lower::vector::zeros;
use crate::model::{HingeKind, Value};
use crate::syntax::{Arguments, Extent};

pub(super) const KIND: Kind =
    Kind { word: "ball", name: "a ball", fields: &["start", "start_rate", "torque"], read, motion };

fn read(
    word: &Ident,
    arguments: Option<&Arguments>,
    context: &mut Context,
) -> Option<Given<HingeKind>> {
    super::no_arguments(word, arguments, context)?;
    Some(Given { value: HingeKind::Ball, at: Extent::token(word.span()) })
}

fn motion(fields: &Fields, context: &mut Context) -> Option<Motion> {
    let unturned = || [1.0, 0.0, 0.0, 0.0].map(Value::number).to_vec();
    let start = context.optional(fields.get("start"), unturned, |context, written| {
        context.written_orientation(written).map(|turned| turned.quaternion().to_vec())
    });
    let rest = || zeros().to_vec();
    let start_rate = context.optional(fields.get("start_rate"), rest, |context, written| {
        context.written_vector(written, RATE).map(Vec::from)
    });
    let effort = super::effort(fields.get("torque"), context, |context, written| {
        context.written_vector(written, TORQUE).map(Vec::from)
    });
    Some(Motion { start: start?, start_rate: start_rate?, effort: effort? })
}
