//! Where routes begin, and what places of the previous repetition are in the first one.

use super::context::Context;
use super::place::{BodyPlace, PlacePoint, Resolved, body_extent};
use crate::syntax::{PathSyntax, SeedSyntax, SpanRange};
use std::cell::Cell;

/// Where a route begins.
#[derive(Clone, Copy, Debug)]
pub(crate) enum RouteStart {
    /// With its first item.
    Item,
    /// At a place of an earlier body; `None` is reported as an error.
    Place(Option<BodyPlace>),
    /// At a place of the previous repetition; `None` is reported as an error.
    Previous(Option<PreviousPlace>),
}

/// A place of the previous repetition.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PreviousPlace {
    /// The place.
    pub previous: BodyPlace,
    /// What it is in the first repetition.
    pub first: BodyPlace,
}

/// The seeds of a repeated part: places in it, and what they are before its first repetition.
#[derive(Clone, Default)]
pub(super) struct Seeds {
    seeds: Vec<PreviousPlace>,
    /// Which of them routes or springs use.
    used: Vec<Cell<bool>>,
    /// Whether some were not readable.
    is_incomplete: bool,
}

/// Returns the seeds of all repeated parts.
pub(super) fn seeds(resolved: Resolved, context: &mut Context) -> Vec<Seeds> {
    (0..resolved.written.repeats.len()).map(|repeat| seeds_of(repeat, resolved, context)).collect()
}

fn seeds_of(repeat: usize, resolved: Resolved, context: &mut Context) -> Seeds {
    let mut seeds = Seeds::default();
    for seed in &resolved.written.repeats[repeat].syntax.seeds {
        let Some(place) = seed_of(repeat, seed, resolved, context) else {
            seeds.is_incomplete = true;
            continue;
        };
        if seeds.seeds.iter().any(|other| other.previous == place.previous) {
            let message = format!("`{}` is given twice", seed.place);
            context.diagnostics.error_over(seed.place.extent(), message);
        }
        seeds.seeds.push(place);
        seeds.used.push(Cell::new(false));
    }
    seeds
}

fn seed_of(
    repeat: usize,
    seed: &SeedSyntax,
    resolved: Resolved,
    context: &mut Context,
) -> Option<PreviousPlace> {
    for path in [&seed.place, &seed.first] {
        if let Some(last) = path.last {
            let plain = PathSyntax { last: None, ..path.clone() };
            let message = format!("`from` names places without `last`: write `{plain}`");
            return context.refuse(SpanRange::token(last), message);
        }
    }
    let written = &resolved.written.repeats[repeat];
    let previous = resolved.place(&seed.place, written.scope, context);
    let first = resolved.place(&seed.first, written.scope, context);
    let (previous, first) = (previous?, first?);
    if resolved.repeat_of(previous.item) != Some(repeat) {
        let message = "`from` maps a place of the repeated part to a place before it, as in `from \
                       left.end = beam.left`";
        return context.refuse(body_extent(&seed.place), message);
    }
    if first.item >= written.items.start {
        let message = "the first value is a place of a body before the `repeat`";
        return context.refuse(body_extent(&seed.first), message);
    }
    Some(PreviousPlace { previous, first })
}

/// Returns where all routes begin.
pub(super) fn starts(
    resolved: Resolved,
    seeds: &[Seeds],
    context: &mut Context,
) -> Vec<RouteStart> {
    let routes = resolved.written.routes.iter().enumerate();
    routes
        .map(|(index, route)| match &route.syntax.start {
            None => RouteStart::Item,
            Some(path) if path.last.is_some() => {
                let place = previous(path, route.scope, route.repeat, (resolved, seeds), context);
                let place = place.filter(|place| {
                    is_joint(place.previous, path, context) && is_joint(place.first, path, context)
                });
                RouteStart::Previous(place)
            }
            Some(path) => RouteStart::Place(start(index, path, resolved, context)),
        })
        .collect()
}

/// Returns a place of the previous repetition of a repeated part.
pub(super) fn previous(
    path: &PathSyntax,
    scope: usize,
    repeat: Option<usize>,
    (resolved, seeds): (Resolved, &[Seeds]),
    context: &mut Context,
) -> Option<PreviousPlace> {
    let Some(repeat) = repeat else {
        let message = "`last` is the previous repetition: use it inside `repeat` or in a spring \
                       on a repeated body";
        context.diagnostics.error(path.last?, message);
        return None;
    };
    let place = resolved.place(path, scope, context)?;
    if resolved.repeat_of(place.item) != Some(repeat) {
        let message = "`last` is the previous repetition: name a body of the same `repeat`";
        return context.refuse(body_extent(path), message);
    }
    let Seeds { seeds: known, used, .. } = &seeds[repeat];
    if let Some((found, used)) = known.iter().zip(used).find(|(seed, _)| seed.previous == place) {
        used.set(true);
        return Some(*found);
    }
    if !seeds[repeat].is_incomplete {
        let written = resolved.written;
        // A part in the `repeat` may name its own bodies, `from` names them from outside of the part.
        let plain = written.scopes[scope].path(&path.names);
        let outer = written.scopes[written.repeats[repeat].scope].prefix();
        let plain = plain.strip_prefix(outer).unwrap_or(&plain);
        let count = resolved.written.repeats[repeat].syntax.count;
        let count = count.map_or_else(|| "…".to_owned(), |count| count.to_string());
        let message = format!(
            "`{path}` has no first value: write `repeat {count} from {plain} = body.place {{ … }}`"
        );
        context.diagnostics.error_over(path.extent(), message);
    }
    None
}

/// The rule that a first value is used.
const UNUSED: &str = "UNUSED_FIRST_VALUE";

/// Warns of seeds that neither a route nor a spring uses, if everything else is readable.
pub(super) fn warn_of_unused(resolved: Resolved, seeds: &[Seeds], context: &mut Context) {
    if !context.diagnostics.is_empty() || !context.complete {
        return;
    }
    for (repeat, seeds) in resolved.written.repeats.iter().zip(seeds) {
        for (seed, used) in repeat.syntax.seeds.iter().zip(&seeds.used) {
            if !used.get() {
                let message = format!(
                    "`{0}` is not used: no route and no spring of this `repeat` has `last.{0}`",
                    seed.place
                );
                context.diagnostics.warn(seed.place.extent().first, UNUSED, message);
            }
        }
    }
}

/// Returns the place at which a route begins.
fn start(
    index: usize,
    path: &PathSyntax,
    resolved: Resolved,
    context: &mut Context,
) -> Option<BodyPlace> {
    let route = &resolved.written.routes[index];
    let place = resolved.place(path, route.scope, context)?;
    let name = resolved.items[place.item].name()?;
    if !is_joint(place, path, context) {
        return None;
    }
    if route.items.first().is_some_and(|&first| place.item >= first) {
        let message =
            format!("no route before this one reaches `{name}`: write the route to it first");
        return context.refuse(body_extent(path), message);
    }
    if route.repeat.is_some() && resolved.repeat_of(place.item) != route.repeat {
        let message = format!(
            "`{name}` is not in this `repeat`: a route in a `repeat` begins at a body of the same \
             repetition, or of the previous one as in `last.link.output`"
        );
        return context.refuse(body_extent(path), message);
    }
    Some(place)
}

/// Returns whether hinges can leave a place; they cannot leave the centre of mass.
fn is_joint(place: BodyPlace, path: &PathSyntax, context: &mut Context) -> bool {
    if place.point == PlacePoint::Com {
        let message = "nothing is joined at the centre of mass: write a `point` there";
        context.diagnostics.error(path.end().span(), message);
    }
    place.point != PlacePoint::Com
}
