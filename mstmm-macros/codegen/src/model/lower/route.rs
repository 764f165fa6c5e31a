//! The items of the routes with their words resolved.

use proc_macro2::{Ident, Span};
use std::collections::HashSet;

use super::body::BodyTypes;
use super::context::Context;
use super::element::UnresolvedElement;
use super::parts::{ItemName, WrittenOut};
use super::route_item::RouteItem;
use crate::syntax::RouteItemSyntax;

/// Resolves all items.
pub(super) fn items<'a>(
    written: &'a WrittenOut,
    types: &BodyTypes<'a>,
    context: &mut Context,
) -> Vec<RouteItem<'a>> {
    let instances =
        written.scopes.iter().filter_map(|scope| Some(scope.name.as_ref()?.path.clone()));
    let mut resolver =
        Resolver { written, types, known: HashSet::new(), instances: instances.collect() };
    (0..written.items.len()).map(|index| resolver.item(index, context)).collect()
}

/// Resolves items one after the other.
struct Resolver<'a, 't> {
    written: &'a WrittenOut<'a>,
    types: &'t BodyTypes<'a>,
    /// The paths of the items so far.
    known: HashSet<String>,
    /// The paths of the instances of parts.
    instances: HashSet<String>,
}

impl<'a> Resolver<'a, '_> {
    fn item(&mut self, index: usize, context: &mut Context) -> RouteItem<'a> {
        let item = &self.written.items[index];
        let scope = &self.written.scopes[item.scope];
        let item_name = |name: &Option<Ident>| name.as_ref().map(|name| scope.item_name(name));
        let resolved = match &*item.syntax {
            RouteItemSyntax::Ground { at, position, turned, name } => {
                if let Some(name) = name {
                    self.refuse_name(name, context);
                }
                let frame = context.frame(position.as_deref(), turned.as_deref());
                RouteItem::Ground { at: *at, frame }
            }
            RouteItemSyntax::Moving { at, name } => {
                if name.is_none() {
                    let message = "a moving end needs a name: write `moving name`";
                    context.diagnostics.error(*at, message);
                }
                RouteItem::Moving { at: *at, name: item_name(name) }
            }
            RouteItemSyntax::Unread { name } => RouteItem::Unknown { name: item_name(name) },
            RouteItemSyntax::Element { .. } => self.element(index, context),
        };
        self.known.extend(resolved.name().map(|name| name.path.clone()));
        resolved
    }

    /// Reports a name of the ground, unless a type or a part is called `ground`, which is reported.
    fn refuse_name(&self, name: &Ident, context: &mut Context) {
        let types = self.types.all.iter().map(|body| body.name);
        let words = types.chain(self.written.parts.iter().copied());
        let message = format!("the ground has no name: remove `{name}`");
        context.diagnostics.unknown(name, message, words.filter(|word| *word == "ground"));
    }

    fn element(&self, index: usize, context: &mut Context) -> RouteItem<'a> {
        let item = &self.written.items[index];
        let RouteItemSyntax::Element { word, arguments, name, place, after_error } = &*item.syntax
        else {
            return RouteItem::Unknown { name: None };
        };
        let route = &self.written.routes[item.route];
        let (begins, ends) =
            (route.items.first() == Some(&index), route.items.last() == Some(&index));
        let element = UnresolvedElement {
            word,
            arguments: arguments.as_ref(),
            name: name.as_ref(),
            at_end: begins || ends,
            scope: item.scope,
            written: self.written,
        };
        let begins_further = begins && item.route > 0 && route.syntax.start.is_none();
        let again = self.again(&element, begins_further);
        let resolved = match again {
            Some(name) if !begins_further && !after_error => passed_twice(name, context),
            Some(name) => RouteItem::Duplicate { name },
            // The error before this item is reported already.
            None if *after_error && !element.is_known(self.types) => element.unknown(),
            None if *after_error && element.name.is_none() && element.is_kind() => {
                RouteItem::Unknown { name: None }
            }
            None => element.resolve(self.types, context),
        };
        if let (Some(place), false) = (place, matches!(resolved, RouteItem::Duplicate { .. })) {
            refuse_place(*place, &resolved, context);
        }
        resolved
    }

    /// Returns the name if it is that of an earlier item or of an instance of a part: without a kind or a type, or with
    /// one if a further route begins.
    fn again(&self, element: &UnresolvedElement, begins_further: bool) -> Option<ItemName> {
        let scope = &self.written.scopes[element.scope];
        let is_known = |name: &ItemName| {
            self.known.contains(&name.path) || self.instances.contains(&name.path)
        };
        let name = match element.name {
            None if element.is_known(self.types) => None,
            None => Some(element.word),
            Some(name) => (begins_further && !element.is_kind()).then_some(name),
        };
        name.map(|name| scope.item_name(name)).filter(is_known)
    }
}

/// Reports an item that is on a route twice.
fn passed_twice<'a>(name: ItemName, context: &mut Context) -> RouteItem<'a> {
    let message = format!(
        "`{name}` is on a route already, and a loop can close only at the ground or at a moving \
         end: end the route before this hinge, and hold the two bodies together by a `spring` that \
         is stiff and damped, or by constraints as in `mstmm::tutorial::several_loops`; for a branch end \
         the route, and begin another one at a place of `{name}`"
    );
    context.diagnostics.error(name.joined.span(), message);
    RouteItem::Duplicate { name }
}

/// Reports a position that is written on the route.
fn refuse_place(place: Span, item: &RouteItem, context: &mut Context) {
    let message = match item {
        RouteItem::Body { name, .. } => format!(
            "on a route the next hinge is at the `output` of a body: for another place end the \
             route here, and begin the next one at `{name}.place -> …`"
        ),
        RouteItem::Hinge { .. } => "a hinge is at the `output` of the body before it: write its \
                                    position there, or on the ground as in `ground at [x, y, z]`"
            .into(),
        _ => return,
    };
    context.diagnostics.error(place, message);
}
