//! The routes of a chain as text.

use crate::model::{Attachment, Chain, Element, Role};

/// Returns the routes, without arguments and with all parts written out.
pub fn written(chain: &Chain) -> Vec<String> {
    let mut routes: Vec<String> = vec![String::new()];
    // The place at which the route continues.
    let mut end: Option<Attachment> = None;
    for (index, &element) in chain.elements.iter().enumerate() {
        let repeat = chain.repeats.iter().find(|repeat| repeat.elements.start == index);
        let mut step = String::new();
        match element {
            Element::Body(body) => {
                step += &chain.bodies[body].path;
                end = Some(Attachment::Output(body));
            }
            Element::Hinge(id) => {
                let hinge = &chain.hinges[id];
                let place = chain.before_boundary(&hinge.inboard);
                if end.as_ref() != Some(place) || matches!(place, Attachment::Ground(_)) {
                    begin(&mut routes, chain, (index, id), place);
                }
                step = format!("{} {}", hinge.kind.spec().word, hinge.path);
                if let Some(place) = fixed(chain, &hinge.outboard) {
                    step += &format!(" -> {place}");
                }
            }
        }
        let Some(route) = routes.last_mut() else { bug!("a chain has no route") };
        if !route.is_empty() && !route.ends_with("{ ") {
            *route += " -> ";
        }
        if let Some(repeat) = repeat {
            *route += &format!("repeat {} {{ ", repeat.count);
        }
        *route += &step;
        if let Some(repeat) = chain.repeats.iter().find(|repeat| repeat.elements.end == index + 1) {
            *route += " }";
            end = Some(Attachment::Output(repeat.last_body));
        }
    }
    routes
}

/// Begins a route at a place: a new one, or a further one of a repeated part.
fn begin(
    routes: &mut Vec<String>,
    chain: &Chain,
    (index, hinge): (usize, crate::model::HingeId),
    place: &Attachment,
) {
    let from = chain.repeat_of_hinge(hinge).map(|repeat| &chain.repeats[repeat]);
    let last = from.and_then(|repeat| repeat.from_previous.iter().find(|it| it.hinge == hinge));
    let start = match last {
        Some(last) => format!("last.{}", name(chain, &last.previous)),
        None => name(chain, place),
    };
    let is_first = from.is_some_and(|repeat| repeat.elements.start == index);
    let Some(route) = routes.last_mut() else { bug!("a chain has no route") };
    if from.is_some() && !is_first {
        *route += "; ";
        *route += &start;
    } else if route.is_empty() {
        *route = start;
    } else {
        routes.push(start);
    }
}

/// Returns the name of a place.
fn name(chain: &Chain, place: &Attachment) -> String {
    let body = |body| &chain.bodies[body];
    fixed(chain, place).unwrap_or_else(|| match place {
        Attachment::Ground(_) => bug!("the ground has a name"),
        Attachment::Input(at) => format!("{}.input", body(*at).path),
        Attachment::Output(at) => format!("{}.output", body(*at).path),
        Attachment::Point(at, point) => {
            format!("{}.{}", body(*at).path, body(*at).points[*point].name)
        }
    })
}

/// Returns `ground` or the name of a moving end.
fn fixed(chain: &Chain, place: &Attachment) -> Option<String> {
    let Some(body) = place.body() else { return Some("ground".into()) };
    let body = &chain.bodies[body];
    (body.role == Role::MovingEnd).then(|| format!("moving {}", body.path))
}
