//! `cylindrical(z) name`: translation along and rotation about the same axis.

use super::axis::{axis, only, unit};
use super::{ArgumentRule, Kind};
use crate::model::lower::context::Context;
use crate::model::{Dimension, HingeKind};
use crate::syntax::ArgumentsSyntax;

pub(super) const KIND: Kind = Kind {
    word: "cylindrical",
    name: "a cylindrical hinge",
    plain,
    takes: ArgumentRule::Something(read),
};

fn plain(space: Dimension) -> Option<HingeKind> {
    (space == Dimension::Space).then(|| HingeKind::Cylindrical { axis: unit(2) })
}

fn read(arguments: &ArgumentsSyntax, context: &mut Context) -> Option<HingeKind> {
    let message = "a cylindrical hinge has one axis, such as `cylindrical(z)`";
    let syntax = only("cylindrical", arguments, context, message)?;
    axis(syntax, context).map(|axis| HingeKind::Cylindrical { axis })
}
