//! The route: a chain of bodies with hinges between them.

use proc_macro2::Span;

use crate::diag::Diagnostics;
use crate::model::lower::{Draft, Stop};

/// The stops, if all of the route could be read; what is lost cannot be judged.
fn whole_route<'d, 'a>(draft: &'d Draft<'a>) -> &'d [Stop<'a>] {
    match &draft.def.route {
        Some(route) if route.whole => &draft.stops,
        _ => &[],
    }
}

/// What a message about a stop points at, and how it calls the stop.
fn called(stop: &Stop) -> Option<(Span, String)> {
    match stop {
        Stop::Ground { at, .. } => Some((*at, "`ground`".into())),
        Stop::Hinge { word, name, .. } => Some(match name {
            Some(name) => (name.span(), format!("hinge `{name}`")),
            None => (word.span(), format!("`{word}`")),
        }),
        Stop::Body { name, .. } => Some((name.span(), format!("body `{name}`"))),
        Stop::Unknown { .. } => None,
    }
}

/// A chain has one route, and at least one body on it.
pub(super) fn there_is_a_route_with_a_body(draft: &Draft, diagnostics: &mut Diagnostics) {
    let name = &draft.def.name;
    if draft.def.route.is_none() && draft.def.whole {
        diagnostics.error(name.span(), format!("chain `{name}` has no route"));
    }
    let stops = whole_route(draft);
    let may_be_body = |stop: &Stop| matches!(stop, Stop::Body { .. } | Stop::Unknown { .. });
    if let (Some((at, _)), false) = (stops.first().and_then(called), stops.iter().any(may_be_body))
    {
        diagnostics.error(at, "there is no body on the route");
    }
}

/// The ground holds an end of the chain.
pub(super) fn ground_is_at_the_ends(draft: &Draft, diagnostics: &mut Diagnostics) {
    let [_, middle @ .., _] = whole_route(draft) else { return };
    for stop in middle {
        if let Stop::Ground { at, .. } = stop {
            diagnostics.error(*at, "`ground` can only stand at an end of the route");
        }
    }
}

/// Between two bodies, and between the ground and a body, there is one hinge.
pub(super) fn hinges_and_bodies_alternate(draft: &Draft, diagnostics: &mut Diagnostics) {
    let stops = whole_route(draft);
    for (index, pair) in stops.windows(2).enumerate() {
        let [first, second] = pair else { continue };
        let at_start = index == 0;
        let at_end = index + 2 == stops.len();
        let (Some((_, first_name)), Some((at, second_name))) = (called(first), called(second))
        else {
            continue;
        };
        let message = match (first, second) {
            (Stop::Hinge { .. }, Stop::Hinge { .. }) => {
                let [first, second] =
                    [&first_name, &second_name].map(|name| name.trim_start_matches("hinge "));
                format!("hinges {first} and {second} have no body between them")
            }
            (Stop::Body { .. }, Stop::Body { .. }) => {
                let [first, second] =
                    [&first_name, &second_name].map(|name| name.trim_start_matches("body "));
                format!("bodies {first} and {second} have no hinge between them")
            }
            (Stop::Ground { .. }, Stop::Body { .. }) if at_start => {
                format!("{first_name} and {second_name} have no hinge between them")
            }
            (Stop::Body { .. }, Stop::Ground { .. }) if at_end => {
                format!("{first_name} and {second_name} have no hinge between them")
            }
            _ => continue,
        };
        diagnostics.error(at, message);
    }
}

/// A free end is a body's: a hinge at the end would join it to nothing.
pub(super) fn hinges_join_something_on_both_sides(draft: &Draft, diagnostics: &mut Diagnostics) {
    let stops = whole_route(draft);
    let ends = [(stops.first(), "begin"), (stops.last(), "end")];
    for (stop, verb) in ends {
        let Some(stop @ Stop::Hinge { .. }) = stop else { continue };
        let Some((at, name)) = called(stop) else { continue };
        let message =
            format!("{name} joins nothing: {verb} the route with a body or with `ground`");
        diagnostics.error(at, message);
    }
}

/// A chain that is held at both ends is a loop.
pub(super) fn one_end_at_most_is_held(draft: &Draft, diagnostics: &mut Diagnostics) {
    if let [Stop::Ground { .. }, .., Stop::Ground { at, .. }] = whole_route(draft) {
        diagnostics.error(*at, "a chain held at both ends is not supported yet");
    }
}
