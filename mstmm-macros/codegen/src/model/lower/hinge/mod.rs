//! Kinds of hinges: one file for each, and a line in [`KINDS`]. The fields of their blocks are read
//! in the same way for all kinds.

mod axis;
mod ball;
mod cylindrical;
mod elastic;
mod field_names;
mod floating;
mod gimbal;
mod passive;
mod pin;
mod planar;
mod properties;
mod screw;
mod slider;
mod universal;
mod weld;

pub(crate) use field_names::{FieldNames, fields, groups, start_fields};
pub(crate) use floating::of_everything;
pub(crate) use properties::{HingeProperties, motion};

use proc_macro2::Ident;

use super::context::{Context, Spanned};
use crate::model::{Dimension, HingeKind};
use crate::syntax::{ArgumentsSyntax, SpanRange};

/// A kind of hinge in the language.
pub(crate) struct Kind {
    /// The word on the route.
    pub word: &'static str,
    /// With its article, for messages.
    pub name: &'static str,
    /// The hinge without arguments; `None` if a chain of this dimension has no such hinge.
    plain: fn(Dimension) -> Option<HingeKind>,
    /// The arguments after the word.
    takes: ArgumentRule,
}

/// The arguments that a kind of hinge has.
enum ArgumentRule {
    /// None.
    Nothing,
    /// Optional.
    Something(ArgumentReader),
    /// Required; with an example.
    Needed(ArgumentReader, &'static str),
}

/// Reads the arguments of a hinge.
type ArgumentReader = fn(&ArgumentsSyntax, &mut Context) -> Option<HingeKind>;

/// All kinds.
pub(crate) const KINDS: &[Kind] = &[
    weld::KIND,
    pin::KIND,
    slider::KIND,
    screw::KIND,
    cylindrical::KIND,
    universal::KIND,
    gimbal::KIND,
    ball::KIND,
    planar::KIND,
    floating::KIND,
    elastic::KIND,
];

impl Kind {
    /// Returns the hinge without arguments, or `None` if a chain of this dimension has no such
    /// hinge.
    pub(crate) fn plain(&self, space: Dimension) -> Option<HingeKind> {
        (self.plain)(space)
    }

    /// Reads a hinge of this kind.
    pub(super) fn read(
        &self,
        word: &Ident,
        arguments: Option<&ArgumentsSyntax>,
        context: &mut Context,
    ) -> Option<Spanned<HingeKind>> {
        let at = SpanRange::token(word.span());
        let value = match (&self.takes, arguments) {
            (ArgumentRule::Needed(_, example), None) => {
                let message = format!("`{word}` needs arguments: write it as in `{example}`");
                return context.refuse(word, message);
            }
            (_, None) => self.plain(context.space),
            (ArgumentRule::Something(read) | ArgumentRule::Needed(read, _), Some(arguments)) => {
                read(arguments, context)
            }
            (ArgumentRule::Nothing, Some(arguments)) => nothing(word, arguments, context),
        };
        Some(Spanned { value: value?, at })
    }
}

/// Reports arguments of a kind that has none.
fn nothing<T>(
    word: impl std::fmt::Display,
    arguments: &ArgumentsSyntax,
    context: &mut Context,
) -> Option<T> {
    let chain = context.of_chain();
    context.refuse(
        arguments.extent,
        format!(
            "`{word}`{chain} has no arguments: remove the \
                                              parentheses"
        ),
    )
}
