//! `planar(z) name`: translations in a plane and a rotation about its normal.

use super::axis::normal;
use super::{ArgumentRule, Kind, nothing};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind = Kind {
    word: "planar",
    name: "a planar hinge",
    plain: |space| (space != Dimension::Line).then_some(HingeKind::Planar { normal: 2 }),
    takes: ArgumentRule::Something(read),
};

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    if context.space == Dimension::Plane {
        return nothing("planar", arguments, context);
    }
    let [syntax] = &arguments.values[..] else {
        let message = "a planar hinge has one normal, such as `planar(z)`";
        return context.refuse(arguments.extent, message);
    };
    normal(syntax, context).map(|normal| HingeKind::Planar { normal })
}
