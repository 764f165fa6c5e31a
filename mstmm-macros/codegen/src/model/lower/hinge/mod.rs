//! Kinds of hinges: a file each, and a line in [`KINDS`]. What is said of them behind the route is
//! read the same way for all.

mod axis;
mod ball;
mod cylindrical;
mod elastic;
mod field_names;
mod floating;
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
    /// What it lets free where nothing stands in parentheses; nothing if a chain of this dimension
    /// has no such hinge.
    plain: fn(Dimension) -> Option<HingeKind>,
    /// What stands in parentheses behind the word.
    takes: ArgumentRule,
}

/// What stands in parentheses behind a kind of hinge.
enum ArgumentRule {
    /// Nothing.
    Nothing,
    /// Something, or nothing.
    Something(ArgumentReader),
    /// Something; an example of how it is written.
    Needed(ArgumentReader, &'static str),
}

/// Reads what stands in parentheses behind a kind of hinge.
type ArgumentReader = fn(&ArgumentsSyntax, &mut Context) -> Option<HingeKind>;

/// All kinds.
pub(crate) const KINDS: &[Kind] = &[
    weld::KIND,
    pin::KIND,
    slider::KIND,
    screw::KIND,
    cylindrical::KIND,
    universal::KIND,
    ball::KIND,
    planar::KIND,
    floating::KIND,
    elastic::KIND,
];

impl Kind {
    /// Whether a chain of this dimension has such hinges; what they are like there.
    pub(crate) fn plain(&self, space: Dimension) -> Option<HingeKind> {
        (self.plain)(space)
    }

    /// What a hinge of this kind lets free.
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

/// Refuses parentheses behind a kind that needs none.
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
