//! `universal(x, y) name`: rotation about an axis of the inboard side, then about an axis of the
//! outboard side.

use super::axis::{axis, unit};
use super::{ArgumentRule, Kind};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind = Kind {
    word: "universal",
    name: "a universal hinge",
    plain,
    takes: ArgumentRule::Something(read),
};

fn plain(space: Dimension) -> Option<HingeKind> {
    (space == Dimension::Space).then(|| HingeKind::Universal { axes: [unit(0), unit(1)] })
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    let [first, second] = &arguments.values[..] else {
        let message = "a universal hinge has two axes, such as `universal(x, y)`";
        return context.refuse(arguments.extent, message);
    };
    let (first, second) = (axis(first, context), axis(second, context));
    Some(HingeKind::Universal { axes: [first?, second?] })
}
