//! Trees with a repeated part: their text, and the same trees written out.

use crate::chain::{Chain, Element, End};
use crate::load::{BodyPoint, Load, Spring, SpringEnd};
use crate::route::{Place, Route};
use std::ops::Range;

/// What precedes the name of a body of the previous repetition.
pub(crate) const LAST: &str = "last.";

/// A tree with a repeated part on its first route, with the elements of the part written once.
#[derive(Clone, Debug)]
pub(crate) struct Repeated {
    /// The tree. Its first later routes are the branches of the part. Names of bodies that begin with
    /// [`LAST`] mean those of the previous repetition.
    pub(crate) tree: Chain,
    /// The elements of the first route that are repeated.
    pub(crate) main: Range<usize>,
    /// The number of branches of the part.
    pub(crate) branches: usize,
    /// The number of repetitions.
    pub(crate) count: usize,
    /// The places of the previous repetition that are used, each with its first value.
    pub(crate) seeds: Vec<(Place, Place)>,
}

impl Repeated {
    /// Returns the elements of the part.
    fn elements(&self) -> impl Iterator<Item = &Element> {
        let branches = self.tree.later_routes[..self.branches].iter();
        let branches = branches.flat_map(|route| &route.elements);
        self.tree.elements[self.main.clone()].iter().chain(branches)
    }

    /// Returns whether a body belongs to the part.
    pub(crate) fn has_body(&self, name: &str) -> bool {
        self.elements().any(|it| matches!(it, Element::Body(body) if body.name == name))
    }

    /// Returns the name of the body at the end of the main route of the part.
    fn last_body(&self) -> &str {
        match &self.tree.elements[self.main.end - 1] {
            Element::Body(body) => &body.name,
            Element::Hinge(hinge) => panic!("{}: a part ends with a body", hinge.name),
        }
    }

    /// Returns the text in the description language.
    pub(crate) fn text(&self) -> String {
        let tree = &self.tree;
        let steps = tree.steps(&tree.elements);
        let (before, after) = (&steps[..self.main.start], &steps[self.main.end..]);
        let seeds = self.seeds.iter().map(|(previous, first)| {
            format!("{}.{} = {}.{}", previous.body, previous.point, first.body, first.point)
        });
        let seeds = match self.seeds.len() {
            0 => String::new(),
            _ => format!(" from {}", seeds.collect::<Vec<_>>().join(", ")),
        };
        let route = |route: &Route| {
            let start = tree.end(&route.start).into_iter();
            start.chain(tree.steps(&route.elements)).collect::<Vec<_>>().join(" -> ")
        };
        let (branches, outside) = tree.later_routes.split_at(self.branches);
        let main = [steps[self.main.clone()].join(" -> ")];
        let routes: Vec<String> = main.into_iter().chain(branches.iter().map(route)).collect();
        let part = format!("repeat {}{seeds} {{ {} }}", self.count, routes.join("; "));
        let steps = tree.end(&tree.start).into_iter().chain(before.iter().cloned()).chain([part]);
        let steps = steps.chain(after.iter().cloned()).chain(tree.end(&tree.finish));
        let first = steps.collect::<Vec<_>>().join(" -> ");
        tree.text_with_routes(None, std::iter::once(first).chain(outside.iter().map(route)))
    }

    /// Returns the tree written out: elements, loads and springs of the part have the number of the
    /// repetition after their names.
    pub(crate) fn written_out(&self) -> Chain {
        let tree = &self.tree;
        let main = |repetition: usize| numbered(&tree.elements[self.main.clone()], repetition);
        let next = |repetition: usize| {
            let body = format!("{}_{repetition}", self.last_body());
            End::Place(Place { body, point: "output".to_owned() })
        };
        let elements = [tree.elements[..self.main.start].to_vec(), main(0)].concat();
        let (branches, outside) = tree.later_routes.split_at(self.branches);
        let mut later_routes = Vec::new();
        for repetition in 0..self.count {
            if repetition > 0 {
                let start = next(repetition - 1);
                let elements = main(repetition);
                later_routes.push(Route { start, elements, finish: End::Free });
            }
            later_routes.extend(branches.iter().map(|route| Route {
                start: self.start(&route.start, Some(repetition)),
                elements: numbered(&route.elements, repetition),
                finish: End::Free,
            }));
        }
        let after = tree.elements[self.main.end..].to_vec();
        if !after.is_empty() {
            let (start, finish) = (next(self.count - 1), tree.finish.clone());
            later_routes.push(Route { start, elements: after, finish });
        }
        later_routes.extend(
            outside
                .iter()
                .map(|route| Route { start: self.start(&route.start, None), ..route.clone() }),
        );
        let finish = End::Free;
        let (loads, springs) = (self.loads(), self.springs());
        Chain { elements, finish, later_routes, loads, springs, ..tree.clone() }
    }

    /// Returns the start of a route in a repetition of the part, or outside of the part.
    fn start(&self, start: &End, repetition: Option<usize>) -> End {
        match start {
            End::Place(place) => End::Place(self.place(place, repetition)),
            other => other.clone(),
        }
    }

    /// Returns a place that is named in a repetition of the part, or outside of the part.
    fn place(&self, place: &Place, repetition: Option<usize>) -> Place {
        let of = |body: &str, number: usize| Place {
            body: format!("{body}_{number}"),
            point: place.point.clone(),
        };
        match (place.body.strip_prefix(LAST), repetition) {
            (Some(body), Some(repetition)) if repetition > 0 => of(body, repetition - 1),
            (Some(body), _) => {
                let is_it = |seed: &Place| seed.body == body && seed.point == place.point;
                let seed = self.seeds.iter().find(|(previous, _)| is_it(previous));
                seed.expect("a first value").1.clone()
            }
            (None, repetition) if self.has_body(&place.body) => {
                of(&place.body, repetition.unwrap_or(self.count - 1))
            }
            (None, _) => place.clone(),
        }
    }

    /// Returns the repetitions in which something on a body exists, each with what follows its name.
    fn repetitions(&self, body: &str) -> Vec<(Option<usize>, String)> {
        match self.has_body(body) {
            true => (0..self.count).map(|k| (Some(k), format!("_{k}"))).collect(),
            false => vec![(None, String::new())],
        }
    }

    fn loads(&self) -> Vec<Load> {
        let loads = self.tree.loads.iter().flat_map(|load| {
            self.repetitions(&load.body).into_iter().map(move |(_, suffix)| {
                let [name, body] = [&load.name, &load.body].map(|name| format!("{name}{suffix}"));
                Load { name, body, ..load.clone() }
            })
        });
        loads.collect()
    }

    fn springs(&self) -> Vec<Spring> {
        let springs = self.tree.springs.iter().flat_map(|spring| {
            self.repetitions(&spring.body).into_iter().map(move |(repetition, suffix)| {
                let names = [&spring.name, &spring.body].map(|name| format!("{name}{suffix}"));
                let [name, body] = names;
                let to = self.spring_end(&spring.to, repetition);
                Spring { name, body, to, ..spring.clone() }
            })
        });
        springs.collect()
    }

    fn spring_end(&self, to: &SpringEnd, repetition: Option<usize>) -> SpringEnd {
        let SpringEnd::Body { body, at } = to else { return to.clone() };
        let point = match at {
            BodyPoint::Input => "input",
            BodyPoint::Output => "output",
            BodyPoint::Named { name, .. } => name,
            BodyPoint::Com | BodyPoint::At(_) => "",
        };
        let place = Place { body: body.clone(), point: point.to_owned() };
        let Place { body, point } = self.place(&place, repetition);
        let at = match point.as_str() {
            "input" => BodyPoint::Input,
            "output" => BodyPoint::Output,
            "" => at.clone(),
            name => self.named_point(&body, name).unwrap_or_else(|| at.clone()),
        };
        SpringEnd::Body { body, at }
    }

    /// Returns a named point of a body outside of the part, if it has it.
    fn named_point(&self, body: &str, name: &str) -> Option<BodyPoint> {
        let body = self.tree.bodies().find(|it| it.name == body)?;
        let position = body.place(name)?.position;
        Some(BodyPoint::Named { name: name.to_owned(), position })
    }
}

/// Returns elements with the number of a repetition after their names.
fn numbered(elements: &[Element], repetition: usize) -> Vec<Element> {
    let mut elements = elements.to_vec();
    for element in &mut elements {
        let name = match element {
            Element::Body(body) => &mut body.name,
            Element::Hinge(hinge) => &mut hinge.name,
        };
        *name = format!("{name}_{repetition}");
    }
    elements
}
