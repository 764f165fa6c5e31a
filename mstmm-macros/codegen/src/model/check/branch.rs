//! Messages for further routes: what they probably mean, and what to write instead.

use crate::model::lower::RouteItem;
use proc_macro2::Ident;

/// Returns the message for a further route.
pub(super) fn of_route(first: &[RouteItem], further: &[RouteItem]) -> String {
    let is_moving = |name: &Ident| {
        let is_it = |item: &RouteItem| matches!(item, RouteItem::Moving { name: Some(end), .. } if *end == name);
        first.iter().any(is_it)
    };
    // The same moving end may hold several chains.
    let mut again = further.iter().filter_map(|item| match item {
        RouteItem::Duplicate { name } if !is_moving(name) => Some(*name),
        _ => None,
    });
    let (again, other) = (again.next(), again.next());
    match (again, further) {
        (Some(name), _) if other.is_some() => format!(
            "a loop can close only at the ground or at a moving end, not at `{name}`: hold the \
             two bodies together by two loads with `force = input`"
        ),
        (Some(name), [RouteItem::Duplicate { .. }, ..]) if is_last(first, name) => {
            format!("a chain has one route: to continue it, write `->` instead of the `;` after \
                     `{name}`")
        }
        (Some(name), [RouteItem::Duplicate { .. }, ..]) if is_first(first, name) => format!(
            "a chain has no branches, but a route can pass through `{name}`: \
             begin it at the free end of one branch, as in `… -> {name} -> …`"
        ),
        (Some(name), _) => format!(
            "a chain has no branches, and `{name}` is on the route already: write the branch as a \
             separate chain, and couple the two by a `load` with `force = input` in each"
        ),
        (None, _) if is_continued(first, further) => {
            "a chain has one route: to continue the first one, write `->` instead of the `;` \
             before this"
                .into()
        }
        (None, [RouteItem::Ground { .. } | RouteItem::Moving { .. } | RouteItem::Duplicate { .. }, ..]) => {
            "a chain has one route: write this one as a second chain; a loop over the ground is one \
             route, `ground -> … -> ground at […]`"
                .into()
        }
        _ => "a chain has one route: write this one as a second chain".into(),
    }
}

fn is_called(item: Option<&RouteItem>, name: &Ident) -> bool {
    matches!(item, Some(body @ RouteItem::Body { .. }) if body.name() == Some(name))
}

/// Returns whether this body is the last item.
fn is_last(items: &[RouteItem], name: &Ident) -> bool {
    is_called(items.last(), name)
}

/// Returns whether this body is the first item.
fn is_first(items: &[RouteItem], name: &Ident) -> bool {
    is_called(items.first(), name)
}

/// Returns whether a route may continue the first one: a hinge follows a body, or a body follows a
/// hinge.
fn is_continued(first: &[RouteItem], further: &[RouteItem]) -> bool {
    let pair = (first.last(), further.first());
    let hinge_follows = matches!(
        pair,
        (Some(RouteItem::Body { .. }), Some(RouteItem::Hinge { .. } | RouteItem::Unknown { .. }))
    );
    hinge_follows || matches!(pair, (Some(RouteItem::Hinge { .. }), Some(RouteItem::Body { .. })))
}
