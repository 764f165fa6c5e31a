//! `gimbal(x, y, z) name`: rotations about three axes, each of which the rotations before it move.

use super::axis::{axis, unit};
use super::{ArgumentRule, Kind};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind =
    Kind { word: "gimbal", name: "a gimbal", plain, takes: ArgumentRule::Something(read) };

fn plain(space: Dimension) -> Option<HingeKind> {
    (space == Dimension::Space).then(|| HingeKind::Gimbal { axes: [unit(0), unit(1), unit(2)] })
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    let [first, second, third] = &arguments.values[..] else {
        let message = "a gimbal has three axes, such as `gimbal(x, y, z)`";
        return context.refuse(arguments.extent, message);
    };
    let [first, second, third] = [first, second, third].map(|syntax| axis(syntax, context));
    Some(HingeKind::Gimbal { axes: [first?, second?, third?] })
}
