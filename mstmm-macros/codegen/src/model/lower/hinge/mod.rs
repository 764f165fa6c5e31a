//! Kinds of hinges: a file each, and a line in [`KINDS`].

mod ball;
mod floating;
mod pin;
mod weld;

pub(super) use floating::FIELDS as FLOATING_FIELDS;
pub(super) use floating::motion as floating_motion;

use proc_macro2::Ident;

use super::context::{Context, Given};
use super::fields::Fields;
use crate::model::{Effort, HingeKind, Value};
use crate::syntax::{Arguments, Field, Written};

/// A kind of hinge in the language.
pub(crate) struct Kind {
    /// The word on the route.
    pub word: &'static str,
    /// With its article, for messages.
    pub name: &'static str,
    /// What can be said of it behind the route.
    pub fields: &'static [&'static str],
    /// Reads what stands in parentheses behind the word.
    pub(super) read: fn(&Ident, Option<&Arguments>, &mut Context) -> Option<Given<HingeKind>>,
    /// Reads what is said of it behind the route.
    pub(super) motion: fn(&Fields, &mut Context) -> Option<Motion>,
}

/// How a hinge starts and what drives it.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    /// Start coordinates.
    pub start: Vec<Value>,
    /// Start rates.
    pub start_rate: Vec<Value>,
    /// The effort.
    pub effort: Effort,
}

/// The kinds that can be used.
pub(crate) const KINDS: &[Kind] = &[pin::KIND, ball::KIND, weld::KIND];

/// The kinds that are kept for later.
pub(crate) const LATER_KINDS: &[&str] =
    &["slider", "screw", "cylindrical", "universal", "planar", "floating", "elastic"];

/// `input`, or numbers read by `read`.
fn effort(
    field: Option<&Field>,
    context: &mut Context,
    read: impl FnOnce(&mut Context, &Written) -> Option<Vec<Value>>,
) -> Option<Effort> {
    context.optional(
        field,
        || Effort::Free,
        |context, written| match written.word() {
            Some(word) if word == "input" => Some(Effort::Input),
            _ => read(context, written).map(Effort::Constant),
        },
    )
}

/// Refuses parentheses behind a kind that needs none.
fn no_arguments(word: &Ident, arguments: Option<&Arguments>, context: &mut Context) -> Option<()> {
    match arguments {
        None => Some(()),
        Some(arguments) => {
            context.refuse(arguments.extent, format!("`{word}` takes nothing in parentheses"))
        }
    }
}
