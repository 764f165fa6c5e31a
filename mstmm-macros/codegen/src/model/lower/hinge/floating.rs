//! The hinge that a floating chain has by implication, before its first body.

use super::Motion;
use crate::model::lower::context::Context;
use crate::model::lower::dimension::{RATE, VELOCITY};
use crate::model::lower::fields::Fields;
use crate::model::lower::vector::zeros;
use crate::model::{Effort, Value};

/// What can be said of the first body of a floating chain.
pub(crate) const FIELDS: &[&str] = &["start", "start_velocity", "start_rate"];

/// Where the first body starts and how it moves then.
pub(crate) fn motion(fields: &Fields, context: &mut Context) -> Option<Motion> {
    let unturned = || [1.0, 0.0, 0.0, 0.0].map(Value::number);
    let start = context.optional(
        fields.get("start"),
        || (zeros(), unturned()),
        |context, written| {
            let (position, turned) = context.written_placement(written)?;
            Some((position, turned.map_or_else(unturned, |turned| turned.quaternion())))
        },
    );
    let velocity = context.optional(fields.get("start_velocity"), zeros, |context, written| {
        context.written_vector(written, VELOCITY)
    });
    let rate = context.optional(fields.get("start_rate"), zeros, |context, written| {
        context.written_vector(written, RATE)
    });
    let (position, turned) = start?;
    Some(Motion {
        start: position.into_iter().chain(turned).collect(),
        start_rate: velocity?.into_iter().chain(rate?).collect(),
        effort: Effort::Free,
    })
}
