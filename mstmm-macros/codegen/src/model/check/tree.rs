//! Trees: several routes.

use super::route::{RouteView, called, readable_routes};
use crate::diag::Diagnostics;
use crate::model::SolutionMethod;
use crate::model::lower::{Draft, RouteItem, RouteStart, example_place, places_of};
use crate::syntax::PathSyntax;

/// Reports routes after the first one that begin neither with an end nor at a place.
pub(super) fn further_routes_begin_at_places(draft: &Draft, diagnostics: &mut Diagnostics) {
    for route in readable_routes(draft) {
        if route.index == RouteView::FIRST || route.route.syntax.start.is_some() {
            continue;
        }
        let Some(first) = route.items().next() else { continue };
        // A body on two routes is reported in a repeated part, too.
        if first.is_end() {
            continue;
        }
        let message = begin_message(draft, route, first);
        if let Some(message) = message {
            diagnostics.error(route.route.syntax.at, message);
        }
    }
}

/// Returns the message for a wrong first item of a further route.
fn begin_message(draft: &Draft, route: RouteView, first: &RouteItem) -> Option<String> {
    let names = &draft.names;
    let named_body = |path: &str| {
        let item = draft.items.get(names.by_path(path)?)?;
        match item {
            RouteItem::Body { body_type: Some(index), name, .. } => {
                Some((name, &draft.types.all[*index]))
            }
            _ => None,
        }
    };
    Some(match first {
        RouteItem::Duplicate { name } => match named_body(&name.path) {
            Some((name, body_type)) => format!(
                "a later route begins at a place: `{name}.{} -> …`; `{name}` has {}",
                example_place(body_type),
                places_of(body_type)
            ),
            None if names.instance_by_path(&name.path).is_some() => {
                let instance = names.instance_by_path(&name.path)?;
                let path = PathSyntax::name(name.joined.clone());
                draft.resolved().part_message(&path, instance)
            }
            None => format!(
                "`{name}` is not a body: a later route begins at a place of a body, as in \
                 `body.output -> …`"
            ),
        },
        RouteItem::Body { body_type: Some(_), word, name, .. } => format!(
            "only the first route begins with a body: write `ground -> floating name -> {word} \
             {name}`"
        ),
        RouteItem::Hinge { .. } => {
            let (_, hinge) = called(first)?;
            let before = draft.written.routes[..route.index].last();
            let last = before.and_then(|before| draft.items[*before.items.last()?].name());
            let body = last.map_or_else(|| "body".to_owned(), |last| last.path.clone());
            format!(
                "{hinge} connects nothing: begin the route at a place, as in `{body}.output -> …`, \
                 or write `->` instead of the `;` before it"
            )
        }
        _ => return None,
    })
}

/// Reports `method = transfer` for a tree.
pub(super) fn transfer_is_for_chains(draft: &Draft, diagnostics: &mut Diagnostics) {
    let Some(method) = &draft.settings.method else { return };
    if method.value != SolutionMethod::Transfer || draft.written.routes.len() < 2 {
        return;
    }
    let places = draft.starts.iter().find_map(|start| match start {
        RouteStart::Place(Some(place)) => Some(place.item),
        RouteStart::Previous(Some(place)) => Some(place.previous.item),
        _ => None,
    });
    let branch = places.and_then(|item| draft.items[item].name());
    let reason = match branch {
        Some(body) => format!("branches at `{body}`"),
        None => "has several routes".into(),
    };
    let message = format!(
        "`transfer` is for chains: this one {reason}; remove `method`, or write `method = riccati`"
    );
    diagnostics.error_over(method.at, message);
}
