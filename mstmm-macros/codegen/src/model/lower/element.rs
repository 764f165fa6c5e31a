//! Hinges and bodies of a route: their words resolved.

use proc_macro2::Ident;

use super::body::{BodyTypes, is_type};
use super::context::Context;
use super::fields::listed;
use super::hinge::{KINDS, Kind};
use super::parts::{WrittenOut, snake_case};
use super::route_item::RouteItem;
use crate::diag::nearest;
use crate::syntax::{ArgumentsSyntax, PathSyntax};

/// A hinge or a body as written.
pub(super) struct UnresolvedElement<'a> {
    /// Its kind or its type.
    pub word: &'a Ident,
    /// Its arguments.
    pub arguments: Option<&'a ArgumentsSyntax>,
    /// Its name.
    pub name: Option<&'a Ident>,
    /// Whether it is the first or the last item of its route.
    pub at_end: bool,
    /// The scope in which it is written.
    pub scope: usize,
    /// The whole chain.
    pub written: &'a WrittenOut<'a>,
}

/// Names of hinges and ends in other programs.
const SYNONYMS: &[(&str, &str)] = &[
    ("revolute", "pin"),
    ("rotary", "pin"),
    ("prismatic", "slider"),
    ("linear", "slider"),
    ("spherical", "ball"),
    ("socket", "ball"),
    ("fixed", "weld"),
    ("rigid", "weld"),
    ("free", "floating"),
    ("freejoint", "floating"),
    ("freeflyer", "floating"),
    ("free_flyer", "floating"),
    ("continuous", "pin"),
    ("hinge", "pin"),
    ("cardan", "universal"),
    ("hooke", "universal"),
    ("euler", "gimbal"),
    ("rpy", "gimbal"),
    ("helical", "screw"),
    ("bushing", "elastic"),
    ("spring", "elastic"),
];

/// Names of the ground in other programs.
const GROUNDS: &[&str] = &["world", "base", "earth", "inertial", "origin"];

impl<'a> UnresolvedElement<'a> {
    /// Returns an item of which only the name is known.
    pub fn unknown(&self) -> RouteItem<'a> {
        self.unknown_of(self.name)
    }

    fn unknown_of(&self, name: Option<&Ident>) -> RouteItem<'a> {
        let scope = &self.written.scopes[self.scope];
        RouteItem::Unknown { name: name.map(|name| scope.item_name(name)) }
    }

    /// Whether its word is a kind of hinge or a body type.
    pub fn is_known(&self, types: &BodyTypes) -> bool {
        self.is_kind() || types.find(self.scope, self.word).is_some()
    }

    /// Whether its word is a kind of hinge.
    pub fn is_kind(&self) -> bool {
        KINDS.iter().any(|kind| self.word == kind.word)
    }

    /// Returns the hinge or the body; an unknown word is reported.
    pub fn resolve(self, types: &BodyTypes, context: &mut Context) -> RouteItem<'a> {
        let word = self.word;
        if let Some(kind) = KINDS.iter().find(|kind| word == kind.word) {
            return self.hinge(kind, context);
        }
        let body_type = types.find(self.scope, word);
        if body_type.is_some() {
            return self.body(body_type, context);
        }
        if let Some(what) = self.is_swapped(types) {
            let name = self.name.map_or_else(String::new, ToString::to_string);
            let message = format!("the {what} comes first, then the name: `{name} {word}`");
            context.diagnostics.error(word.span(), message);
            return self.unknown_of(Some(word));
        }
        if self.is_body(types) {
            self.unknown_type(types, context);
            return self.body(None, context);
        }
        let meant = self.meant();
        if meant.is_none() && self.arguments.is_some() && begins_type(word) {
            self.unknown_part(context);
            return self.unknown();
        }
        let message = match meant {
            Some(meant) => {
                let is_kind = KINDS.iter().any(|kind| kind.word == meant);
                let what = if is_kind { "kind of hinge" } else { "route item" };
                format!("unknown {what} `{word}`; did you mean `{meant}`?")
            }
            None => format!("unknown kind of hinge `{word}`; there are {}", kinds(context)),
        };
        context.diagnostics.error(word.span(), message);
        self.unknown()
    }

    /// Returns what the name is, if keyword and name are swapped.
    fn is_swapped(&self, types: &BodyTypes) -> Option<&'static str> {
        let name = self.name?;
        let kind = KINDS.iter().any(|kind| name == kind.word).then_some("kind");
        kind.or_else(|| types.find(self.scope, name).map(|_| "type"))
    }

    /// Returns whether an unknown word probably means a body type, not a kind of hinge.
    fn is_body(&self, types: &BodyTypes) -> bool {
        let word = self.word.to_string();
        let near_type = || {
            let types: Vec<String> = types.all.iter().map(|known| known.name.to_string()).collect();
            nearest(&word, types.iter().map(String::as_str)).is_some()
        };
        begins_type(self.word)
            && self.arguments.is_none()
            && (self.meant().is_none() || near_type())
    }

    /// Returns the keyword that an unknown word probably means.
    fn meant(&self) -> Option<&'static str> {
        let word = self.word.to_string().to_lowercase();
        if self.at_end && self.name.is_none() && GROUNDS.contains(&&*word) {
            return Some("ground");
        }
        let synonym = SYNONYMS.iter().find(|(other, _)| *other == word).map(|&(_, kind)| kind);
        let kinds = KINDS.iter().map(|kind| kind.word);
        synonym.or_else(|| nearest(&word, kinds.chain(["ground", "moving", "repeat"])))
    }

    fn hinge(self, kind: &'static Kind, context: &mut Context) -> RouteItem<'a> {
        let UnresolvedElement { word, arguments, name, .. } = self;
        let Some(plain) = kind.plain(context.space) else {
            no_such_hinge(word, context);
            return self.unknown();
        };
        if name.is_none() {
            let message = format!("a hinge needs a name: write `{word} name`");
            context.diagnostics.error(word.span(), message);
        }
        let hinge_kind = kind.read(word, arguments, context);
        let name = name.map(|name| self.written.scopes[self.scope].item_name(name));
        RouteItem::Hinge { word, name, kind, spec: plain.spec(), arguments, hinge_kind }
    }

    fn body(self, body_type: Option<usize>, context: &mut Context) -> RouteItem<'a> {
        let UnresolvedElement { word, arguments, name, .. } = self;
        if let Some(arguments) = arguments {
            let message = "a body has no arguments: remove the parentheses";
            context.diagnostics.error_over(arguments.extent, message);
        }
        let named = name.is_some();
        let name = name.cloned().unwrap_or_else(|| snake_case(word));
        let name = self.written.scopes[self.scope].item_name(&name);
        RouteItem::Body { word, name, named, body_type }
    }

    fn unknown_type(&self, types: &BodyTypes, context: &mut Context) {
        let word = self.word;
        let blocks = self.written.blocks.iter().map(|block| (block, is_type(&block.syntax)));
        let named = |names: &[PathSyntax]| names.iter().any(|path| path.end() == word);
        // A block in the wrong place, or that was not readable, is reported already.
        let mut misplaced = blocks.clone().filter(|(_, is_type)| !is_type);
        if !self.written.complete || misplaced.any(|(block, _)| named(&block.syntax.names)) {
            return;
        }
        // Another part has the type.
        let mut types_of_parts = blocks.filter(|(_, is_type)| *is_type);
        let part = types_of_parts.find_map(|(block, _)| {
            let part = self.written.scopes[block.scope].part?;
            named(&block.syntax.names).then_some(&part.name)
        });
        if let Some(part) = part {
            let message = format!(
                "only part `{part}` knows the type `{word}`: to use it here, write the type \
                 outside of the part"
            );
            context.diagnostics.error(word.span(), message);
            return;
        }
        let parts = self.written.parts.iter().copied();
        let visible = || types.visible(self.scope).map(|known| known.name);
        let hint = context.hint(word, visible().chain(parts));
        let message = format!("unknown body type `{word}`{hint}");
        context.diagnostics.unknown(word, message, visible());
    }

    /// Reports arguments after an unknown word with a capital, which is not a body then.
    fn unknown_part(&self, context: &mut Context) {
        let word = self.word;
        if !self.written.complete {
            return;
        }
        let parts = || self.written.parts.iter().copied();
        let hint = context.hint(word, parts());
        context.diagnostics.unknown(word, format!("unknown part `{word}`{hint}"), parts());
    }
}

fn begins_type(word: &Ident) -> bool {
    word.to_string().starts_with(char::is_uppercase)
}

/// Reports a kind of hinge that leaves the plane or the line.
fn no_such_hinge(word: &Ident, context: &mut Context) {
    let chain = context.of_chain().trim_start_matches(" of ");
    let message = format!("{chain} has no `{word}`: its hinges are {}", kinds(context));
    context.diagnostics.error(word.span(), message);
}

/// Lists the kinds of hinges that the chain can have.
fn kinds(context: &Context) -> String {
    let kinds = KINDS.iter().filter(|kind| kind.plain(context.space).is_some());
    listed(&kinds.map(|kind| format!("`{}`", kind.word)).collect::<Vec<_>>())
}
