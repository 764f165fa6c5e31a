//! `pin(z) name`: rotation about an axis.

use super::axis::{axis, only, unit};
use super::{ArgumentRule, Kind};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind =
    Kind { word: "pin", name: "a pin", plain, takes: ArgumentRule::Something(read) };

/// The paper's pin turns about ζ.
fn plain(space: Dimension) -> Option<HingeKind> {
    (space != Dimension::Line).then(|| HingeKind::Pin { axis: unit(2) })
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    if context.space == Dimension::Plane {
        let message = "a pin of a plane chain rotates about z: write `pin` without an axis";
        return context.refuse(arguments.extent, message);
    }
    let syntax = only("pin", arguments, context, "a pin has one axis, such as `pin(z)`")?;
    axis(syntax, context).map(|axis| HingeKind::Pin { axis })
}
