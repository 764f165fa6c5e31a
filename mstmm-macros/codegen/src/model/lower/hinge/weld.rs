//! `weld name`: lets nothing free.

use proc_macro2::Ident;

use super::{Kind, Motion};
use crate::model::lower::context::{Context, Given};
use crate::model::lower::fields::Fields;
use crate::model::{Effort, HingeKind};
use crate::syntax::{Arguments, Extent};

pub(super) const KIND: Kind = Kind { word: "weld", name: "a weld", fields: &[], read, motion };

fn read(
    word: &Ident,
    arguments: Option<&Arguments>,
    context: &mut Context,
) -> Option<Given<HingeKind>> {
    super::no_arguments(word, arguments, context)?;
    Some(Given { value: HingeKind::Weld, at: Extent::token(word.span()) })
}

fn motion(_: &Fields, _: &mut Context) -> Option<Motion> {
    Some(Motion { start: Vec::new(), start_rate: Vec::new(), effort: Effort::Free })
}
