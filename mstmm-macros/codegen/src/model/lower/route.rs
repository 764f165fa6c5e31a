//! The route with its names resolved.

use proc_macro2::{Ident, Span};

use super::body::BodyType;
use super::context::{Context, Spanned};
use super::fields::listed;
use super::hinge::{KINDS, Kind};
use crate::diag::nearest;
use crate::model::{Frame, HingeKind, HingeSpec};
use crate::syntax::{self, ArgumentsSyntax, ChainSyntax};
use std::collections::HashSet;

/// An item of the route, as far as it is readable.
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
        name: Option<&'a Ident>,
    },
    /// A hinge of a known kind.
    Hinge {
        /// Its kind as written.
        word: &'a Ident,
        /// Its name; `None` is reported as an error.
        name: Option<&'a Ident>,
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
        name: Ident,
        /// Whether the name was written.
        named: bool,
        /// The index of its type; `None` is reported as an error.
        body_type: Option<usize>,
    },
    /// An item with an error that is reported already.
    Unknown {
        /// Its name.
        name: Option<&'a Ident>,
    },
    /// An item with the name of an earlier one, which is reported already.
    Duplicate {
        /// The name.
        name: &'a Ident,
    },
}

impl RouteItem<'_> {
    /// Its name on the route.
    pub fn name(&self) -> Option<&Ident> {
        match self {
            RouteItem::Ground { .. } | RouteItem::Duplicate { .. } => None,
            RouteItem::Moving { name, .. }
            | RouteItem::Hinge { name, .. }
            | RouteItem::Unknown { name, .. } => *name,
            RouteItem::Body { name, .. } => Some(name),
        }
    }
}

/// Resolves all items.
pub(super) fn items<'a>(
    def: &'a ChainSyntax,
    types: &[BodyType],
    context: &mut Context,
) -> Vec<RouteItem<'a>> {
    let Some(route) = &def.route else { return Vec::new() };
    let mut known = HashSet::new();
    let mut resolve = |(index, item): (usize, &'a syntax::RouteItemSyntax)| match item {
        syntax::RouteItemSyntax::Ground { at, position, turned } => RouteItem::Ground {
            at: *at,
            frame: context.frame(position.as_deref(), turned.as_deref()),
        },
        syntax::RouteItemSyntax::Moving { name: Some(name), .. }
            if index >= route.first_end() && known.contains(&name.to_string()) =>
        {
            RouteItem::Duplicate { name }
        }
        syntax::RouteItemSyntax::Moving { at, name } => {
            known.extend(name.as_ref().map(ToString::to_string));
            if name.is_none() {
                context.diagnostics.error(*at, "a moving end needs a name: write `moving name`");
            }
            RouteItem::Moving { at: *at, name: name.as_ref() }
        }
        syntax::RouteItemSyntax::Unread { name } => RouteItem::Unknown { name: name.as_ref() },
        syntax::RouteItemSyntax::Element { word, arguments, name, place, after_error } => {
            let first_end = route.first_end();
            let (arguments, name) = (arguments.as_ref(), name.as_ref());
            let at_end = index == 0 || index + 1 == first_end || index + 1 == route.items.len();
            let element = UnresolvedElement { word, arguments, name, at_end };
            let further = route.further.iter().any(|further| further.start == index);
            let again = element.again(&known, types, further);
            let item = match again {
                Some(name) if index < first_end && !after_error => passed_twice(name, context),
                Some(name) => RouteItem::Duplicate { name },
                // The further route, or the error before this item, is reported already.
                None if (further || *after_error) && !element.is_known(types) => {
                    RouteItem::Unknown { name: element.name }
                }
                None if *after_error && element.name.is_none() && element.is_kind() => {
                    RouteItem::Unknown { name: None }
                }
                None => element.resolve(def, types, context),
            };
            if let (Some(place), None) = (place, again) {
                refuse_place(*place, &item, context);
            }
            known.extend(item.name().map(ToString::to_string));
            item
        }
    };
    route.items.iter().enumerate().map(&mut resolve).collect()
}

/// Reports an item that is on the route twice.
fn passed_twice<'a>(name: &'a Ident, context: &mut Context) -> RouteItem<'a> {
    let message = format!(
        "`{name}` is on the route already, and a loop can close only at the ground or at a \
         moving end: end the route before this hinge, and hold the two bodies together by two \
         loads with `force = input`"
    );
    context.diagnostics.error(name.span(), message);
    RouteItem::Duplicate { name }
}

/// Reports a position that is written on the route.
fn refuse_place(place: Span, item: &RouteItem, context: &mut Context) {
    let message = match item {
        RouteItem::Body { word, .. } => format!(
            "the next hinge is always at the `output` of a body: write this point as the \
             `output` of `{word}`"
        ),
        RouteItem::Hinge { .. } => "a hinge is at the `output` of the body before it: write its \
                                    position there, or on the ground as in `ground at [x, y, z]`"
            .into(),
        _ => return,
    };
    context.diagnostics.error(place, message);
}

/// A hinge or a body as written.
struct UnresolvedElement<'a> {
    word: &'a Ident,
    arguments: Option<&'a ArgumentsSyntax>,
    name: Option<&'a Ident>,
    /// Whether it is the first or the last item.
    at_end: bool,
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
    ("helical", "screw"),
    ("bushing", "elastic"),
    ("spring", "elastic"),
];

/// Names of the ground in other programs.
const GROUNDS: &[&str] = &["world", "base", "earth", "inertial", "origin"];

impl<'a> UnresolvedElement<'a> {
    /// Returns the name if it is that of an earlier item: without a kind or a type, or with one if
    /// a further route begins.
    fn again(
        &self,
        known: &HashSet<String>,
        types: &[BodyType],
        further: bool,
    ) -> Option<&'a Ident> {
        let is_known = |name: &&Ident| known.contains(&name.to_string());
        match self.name {
            None => (!self.is_known(types)).then_some(self.word).filter(is_known),
            Some(name) => further.then_some(name).filter(is_known),
        }
    }

    /// Whether its word is a kind of hinge or a body type.
    fn is_known(&self, types: &[BodyType]) -> bool {
        self.is_kind() || types.iter().any(|known| self.word == known.name)
    }

    /// Whether its word is a kind of hinge.
    fn is_kind(&self) -> bool {
        KINDS.iter().any(|kind| self.word == kind.word)
    }

    fn resolve(
        self,
        def: &ChainSyntax,
        types: &[BodyType],
        context: &mut Context,
    ) -> RouteItem<'a> {
        let UnresolvedElement { word, name, .. } = self;
        if let Some(kind) = KINDS.iter().find(|kind| word == kind.word) {
            return self.hinge(kind, context);
        }
        let body_type = types.iter().position(|known| word == known.name);
        if body_type.is_some() {
            return self.body(body_type, context);
        }
        if let Some(what) = self.is_swapped(types) {
            let name = self.name.map_or_else(String::new, ToString::to_string);
            let message = format!("the {what} comes first, then the name: `{name} {word}`");
            context.diagnostics.error(word.span(), message);
            return RouteItem::Unknown { name: Some(word) };
        }
        if self.is_body(types) {
            self.unknown_type(def, types, context);
            return self.body(None, context);
        }
        let meant = self.meant();
        let message = match meant {
            Some(meant) => {
                let is_kind = KINDS.iter().any(|kind| kind.word == meant);
                let what = if is_kind { "kind of hinge" } else { "route item" };
                format!("unknown {what} `{word}`; did you mean `{meant}`?")
            }
            None => format!("unknown kind of hinge `{word}`; there are {}", kinds(context)),
        };
        context.diagnostics.error(word.span(), message);
        RouteItem::Unknown { name }
    }

    /// Returns what the name is, if keyword and name are swapped.
    fn is_swapped(&self, types: &[BodyType]) -> Option<&'static str> {
        let name = self.name?;
        let kind = KINDS.iter().any(|kind| name == kind.word).then_some("kind");
        kind.or_else(|| types.iter().any(|known| name == known.name).then_some("type"))
    }

    /// Returns whether an unknown word probably means a body type, not a kind of hinge.
    fn is_body(&self, types: &[BodyType]) -> bool {
        let word = self.word.to_string();
        let near_type = || {
            let types: Vec<String> = types.iter().map(|known| known.name.to_string()).collect();
            nearest(&word, types.iter().map(String::as_str)).is_some()
        };
        word.starts_with(char::is_uppercase)
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
            return RouteItem::Unknown { name };
        };
        if name.is_none() {
            let message = format!("a hinge needs a name: write `{word} name`");
            context.diagnostics.error(word.span(), message);
        }
        let hinge_kind = kind.read(word, arguments, context);
        RouteItem::Hinge { word, name, kind, spec: plain.spec(), arguments, hinge_kind }
    }

    fn body(self, body_type: Option<usize>, context: &mut Context) -> RouteItem<'a> {
        let UnresolvedElement { word, arguments, name, .. } = self;
        if let Some(arguments) = arguments {
            let message = "a body has no arguments: remove the parentheses";
            context.diagnostics.error_over(arguments.extent, message);
        }
        let made = || {
            let plain = syn::ext::IdentExt::unraw(word).to_string();
            Ident::new(&snake_case(&plain), word.span())
        };
        let named = name.is_some();
        RouteItem::Body { word, name: name.cloned().unwrap_or_else(made), named, body_type }
    }

    fn unknown_type(&self, def: &ChainSyntax, types: &[BodyType], context: &mut Context) {
        let word = self.word;
        // A block in the wrong place, or that was not readable, is reported already.
        if !def.complete || def.blocks.iter().any(|block| block.names.contains(word)) {
            return;
        }
        let hint = context.hint(word, types.iter().map(|known| known.name));
        let message = format!("unknown body type `{word}`{hint}");
        context.diagnostics.unknown(word, message, types.iter().map(|known| known.name));
    }
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

/// `UpperArm` is `upper_arm`, `L1` is `l1`, `IMUCase` is `imu_case`.
fn snake_case(name: &str) -> String {
    let letters: Vec<char> = name.chars().collect();
    let mut snake = String::new();
    for (at, &letter) in letters.iter().enumerate() {
        let before = at.checked_sub(1).map(|before| letters[before]);
        let after = letters.get(at + 1);
        let begins_word = letter.is_uppercase()
            && before.is_some_and(|before| {
                before != '_'
                    && (!before.is_uppercase() || after.is_some_and(|after| after.is_lowercase()))
            });
        if begins_word {
            snake.push('_');
        }
        snake.extend(letter.to_lowercase());
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::snake_case;

    #[test]
    fn type_names_become_names() {
        let names = ["UpperArm", "L1", "IMUCase", "rod", "My_Rod"].map(snake_case);
        assert_eq!(names, ["upper_arm", "l1", "imu_case", "rod", "my_rod"]);
    }
}
