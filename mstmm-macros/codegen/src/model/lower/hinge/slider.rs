//! `slider(x) name`: translation along an axis.

use super::axis::{axis, only, unit};
use super::{ArgumentRule, Kind, nothing};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind = Kind {
    word: "slider",
    name: "a slider",
    plain: |space| Some(plain(space)),
    takes: ArgumentRule::Something(read),
};

/// Along z in space, as a pin rotates about z; otherwise along x.
fn plain(space: Dimension) -> HingeKind {
    HingeKind::Slider { axis: unit(if space == Dimension::Space { 2 } else { 0 }) }
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    if context.space == Dimension::Line {
        return nothing("slider", arguments, context);
    }
    let syntax = only("slider", arguments, context, "a slider has one axis, such as `slider(x)`")?;
    axis(syntax, context).map(|axis| HingeKind::Slider { axis })
}
