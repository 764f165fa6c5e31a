//! `universal(x, y) name`: turns about an axis of the inboard side, then about one of the outboard
//! side.

use super::axis::{axis, unit};
use super::{Kind, Takes};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::Arguments;

pub(super) const KIND: Kind =
    Kind { word: "universal", name: "a universal hinge", plain, takes: Takes::Something(read) };

fn plain(space: Dimension) -> Option<HingeKind> {
    (space == Dimension::Space).then(|| HingeKind::Universal { axes: [unit(0), unit(1)] })
}

fn read(arguments: &Arguments, context: &mut Context) -> Option<HingeKind> {
    let [first, second] = &arguments.values[..] else {
        let message = "a universal hinge has two axes, such as `universal(x, y)`";
        return context.refuse(arguments.extent, message);
    };
    let (first, second) = (axis(first, context), axis(second, context));
    Some(HingeKind::Universal { axes: [first?, second?] })
}
