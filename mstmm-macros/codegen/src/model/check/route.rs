//! The routes: bodies with hinges between them.

use proc_macro2::Span;

use crate::diag::Diagnostics;
use crate::model::Drive;
use crate::model::lower::{Draft, RouteItem, WrittenRepeat, WrittenRoute};

/// A route with its items.
#[derive(Clone, Copy)]
pub(super) struct RouteView<'d, 'a> {
    draft: &'d Draft<'a>,
    /// Its index.
    pub index: usize,
    /// As written.
    pub route: &'a WrittenRoute<'a>,
}

impl<'d, 'a> RouteView<'d, 'a> {
    /// The index of the first route.
    pub const FIRST: usize = 0;

    /// Returns its items.
    pub fn items(self) -> impl DoubleEndedIterator<Item = &'d RouteItem<'a>> {
        self.route.items.iter().map(|&item| &self.draft.items[item])
    }

    /// Returns the number of its items.
    pub fn len(self) -> usize {
        self.route.items.len()
    }

    /// Returns the repeated part that contains the item at this position.
    pub fn repeat_around(self, position: usize) -> Option<&'a WrittenRepeat<'a>> {
        let item = *self.route.items.get(position)?;
        self.draft.written.items[item].repeat.map(|repeat| &self.draft.written.repeats[repeat])
    }

    /// Returns whether a repeated part begins or ends between this position and the next one with a wrong item, which
    /// another rule reports.
    pub fn boundary_is_wrong(self, position: usize) -> bool {
        let item = |position: usize| &self.draft.items[self.route.items[position]];
        let of_this_route = |repeat: &&WrittenRepeat| repeat.route == self.index;
        let around = |position| self.repeat_around(position).filter(of_this_route);
        let begins = around(position + 1).is_some_and(|at| at.on_route.start == position + 1);
        let ends = around(position).is_some_and(|at| at.on_route.end == position + 1);
        (begins && !item(position + 1).is_hinge()) || (ends && !item(position).is_body())
    }
}

/// Returns the routes if all of them are readable and the first one has a body, and nothing otherwise.
pub(super) fn readable_routes<'d, 'a>(
    draft: &'d Draft<'a>,
) -> impl Iterator<Item = RouteView<'d, 'a>> {
    let has_body = complete_routes(draft).next().is_some_and(has_body);
    complete_routes(draft).filter(move |_| has_body)
}

fn complete_routes<'d, 'a>(draft: &'d Draft<'a>) -> impl Iterator<Item = RouteView<'d, 'a>> {
    let routes = draft.written.routes.iter().enumerate();
    let routes = routes.map(|(index, route)| RouteView { draft, index, route });
    routes.filter(|_| draft.written.routes_are_complete)
}

fn has_body(route: RouteView) -> bool {
    route.items().any(|item| {
        matches!(
            item,
            RouteItem::Body { .. } | RouteItem::Unknown { .. } | RouteItem::Duplicate { .. }
        )
    })
}

/// Returns the span and the description of an item for a message.
pub(super) fn called(item: &RouteItem) -> Option<(Span, String)> {
    match item {
        RouteItem::Ground { at, .. } => Some((*at, "`ground`".into())),
        RouteItem::Moving { at, name } => Some((
            *at,
            name.as_ref().map_or_else(|| "`moving`".into(), |name| format!("moving end `{name}`")),
        )),
        RouteItem::Hinge { word, name, .. } => Some(match name {
            Some(name) => (name.joined.span(), format!("hinge `{name}`")),
            None => (word.span(), format!("`{word}`")),
        }),
        RouteItem::Body { name, .. } => Some((name.joined.span(), format!("body `{name}`"))),
        RouteItem::Unknown { .. } | RouteItem::Duplicate { .. } => None,
    }
}

/// Returns the token of an item in a scope: its own, or that of the instance of a part that contains it.
pub(super) fn token_in(draft: &Draft, scope: usize, item: usize) -> Option<Span> {
    match instance_in(draft, scope, item) {
        None => called(&draft.items[item]).map(|(at, _)| at),
        Some(instance) => Some(draft.written.scopes[instance].name.as_ref()?.joined.span()),
    }
}

/// Returns the instance of a part in a scope that contains an item; `None` if the item is written in the scope.
pub(super) fn instance_in(draft: &Draft, scope: usize, item: usize) -> Option<usize> {
    let mut inner = None;
    let mut around = draft.written.items[item].scope;
    while around != scope && around > 0 {
        inner = Some(around);
        around = draft.written.scopes[around].parent;
    }
    inner
}

/// Reports a missing route, and routes without a body.
pub(super) fn there_is_a_route_with_a_body(draft: &Draft, diagnostics: &mut Diagnostics) {
    let name = &draft.def.name;
    if draft.def.content.routes.is_empty() && draft.written.complete {
        let message = format!(
            "chain `{name}` has no route: write one, as in `ground -> slider joint -> Car car;`"
        );
        diagnostics.error(name.span(), message);
    }
    // A further route that ends on the ground is reported for its end, unless its end is its beginning.
    let is_closed = |route: &RouteView| {
        let beginning = usize::from(route.route.syntax.start.is_none());
        let end = route.items().skip(beginning).last();
        route.index > RouteView::FIRST && end.is_some_and(RouteItem::is_end)
    };
    for route in complete_routes(draft).filter(|route| !has_body(*route) && !is_closed(route)) {
        if let Some((at, _)) = route.items().next().and_then(called) {
            diagnostics.error(at, "the route has no body: add at least one");
        }
    }
}

/// Reports `ground` and moving ends within a route.
pub(super) fn ground_is_at_the_ends(draft: &Draft, diagnostics: &mut Diagnostics) {
    for route in readable_routes(draft) {
        for (position, item) in route.items().enumerate() {
            let (at, word) = match item {
                RouteItem::Ground { at, .. } => (*at, "ground"),
                RouteItem::Moving { at, .. } => (*at, "moving"),
                _ => continue,
            };
            let is_start = position == 0 && route.route.syntax.start.is_none();
            // One in a repeated part is reported there.
            if is_start || route.repeat_around(position).is_some() {
                continue;
            }
            if position + 1 < route.len() {
                let message = format!(
                    "`{word}` can only be at an end of the route: end this route here, and begin \
                     another one with `{word}`"
                );
                diagnostics.error(at, message);
            } else if route.index != RouteView::FIRST {
                let message = "this closes a loop: only the first route may end on the ground or \
                               at a moving end";
                diagnostics.error(at, message);
            }
        }
    }
}

/// Reports hinges at an end of a route.
pub(super) fn hinges_connect_two_sides(draft: &Draft, diagnostics: &mut Diagnostics) {
    for route in readable_routes(draft) {
        let Some(last) = route.len().checked_sub(1) else { continue };
        let begins_with_item =
            route.index == RouteView::FIRST && route.route.syntax.start.is_none();
        let begin = begins_with_item.then_some((0, "begin"));
        for (position, verb) in begin.into_iter().chain([(last, "end")]) {
            let item = &draft.items[route.route.items[position]];
            let around = route.repeat_around(position).filter(|at| at.route == route.index);
            if !item.is_hinge() || around.is_some() {
                continue;
            }
            let Some((_, name)) = called(item) else { continue };
            let at = token_in(draft, route.route.scope, route.route.items[position]);
            let ends = if route.index == RouteView::FIRST { " or with `ground`" } else { "" };
            let message = format!("{name} connects nothing: {verb} the route with a body{ends}");
            diagnostics.error(at.unwrap_or(route.route.syntax.at), message);
        }
    }
}

/// Reports closed chains whose first route has no hinge that is free to move.
pub(super) fn closed_chains_can_move(draft: &Draft, diagnostics: &mut Diagnostics) {
    let Some(route) = readable_routes(draft).next() else { return };
    let [first, middle @ .., last] = &route.route.items[..] else { return };
    let last = &draft.items[*last];
    if !(draft.items[*first].is_end() && last.is_end()) {
        return;
    }
    let is_rigid = |&item: &usize| match &draft.items[item] {
        RouteItem::Body { .. } => true,
        RouteItem::Hinge { spec, .. } => {
            let motion = draft.properties[item].motion.as_ref();
            spec.groups.is_empty() || motion.is_some_and(|motion| motion.drive == Drive::Prescribed)
        }
        RouteItem::Ground { .. }
        | RouteItem::Moving { .. }
        | RouteItem::Unknown { .. }
        | RouteItem::Duplicate { .. } => false,
    };
    let has_body = middle.iter().any(|&item| draft.items[item].is_body());
    if let Some((at, _)) = called(last)
        && has_body
        && middle.iter().all(is_rigid)
    {
        let message = "the route is held at both ends and cannot move, since all its hinges are welds \
                       or prescribed: add a hinge that can move to it, or leave one end free";
        diagnostics.error(at, message);
    }
}
