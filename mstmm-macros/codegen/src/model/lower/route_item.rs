//! Items of routes with their words resolved.

use proc_macro2::{Ident, Span};

use super::context::Spanned;
use super::hinge::Kind;
use super::parts::ItemName;
use crate::model::{Frame, HingeKind, HingeSpec};
use crate::syntax::ArgumentsSyntax;

/// An item of a route, as far as it is readable.
pub(crate) enum RouteItem<'a> {
    /// A frame on the ground.
    Ground {
        /// The word.
        at: Span,
        /// The frame.
        frame: Option<Frame>,
    },
    /// A moving end: its motion is prescribed.
    Moving {
        /// The word.
        at: Span,
        /// Its name; `None` is reported as an error.
        name: Option<ItemName>,
    },
    /// A hinge of a known kind.
    Hinge {
        /// Its kind as written.
        word: &'a Ident,
        /// Its name; `None` is reported as an error.
        name: Option<ItemName>,
        /// Its kind.
        kind: &'static Kind,
        /// The coordinates and rates of its kind.
        spec: &'static HingeSpec,
        /// Its arguments.
        arguments: Option<&'a ArgumentsSyntax>,
        /// The kind of hinge in the model, if it was readable.
        hinge_kind: Option<Spanned<HingeKind>>,
    },
    /// A body.
    Body {
        /// Its type as written.
        word: &'a Ident,
        /// Its name, given or made.
        name: ItemName,
        /// Whether the name was written.
        named: bool,
        /// The index of its type; `None` is reported as an error.
        body_type: Option<usize>,
    },
    /// An item with an error that is reported already.
    Unknown {
        /// Its name.
        name: Option<ItemName>,
    },
    /// An item with the name of an earlier one, which is reported.
    Duplicate {
        /// The name.
        name: ItemName,
    },
}

impl RouteItem<'_> {
    /// Its name on the route.
    pub fn name(&self) -> Option<&ItemName> {
        match self {
            RouteItem::Ground { .. } | RouteItem::Duplicate { .. } => None,
            RouteItem::Moving { name, .. }
            | RouteItem::Hinge { name, .. }
            | RouteItem::Unknown { name, .. } => name.as_ref(),
            RouteItem::Body { name, .. } => Some(name),
        }
    }

    /// Whether it is `ground` or a moving end.
    pub fn is_end(&self) -> bool {
        matches!(self, RouteItem::Ground { .. } | RouteItem::Moving { .. })
    }

    /// Whether it is a hinge of a known kind.
    pub fn is_hinge(&self) -> bool {
        matches!(self, RouteItem::Hinge { .. })
    }

    /// Whether it is a body.
    pub fn is_body(&self) -> bool {
        matches!(self, RouteItem::Body { .. })
    }
}
