//! The connection points of a chain by place, found a second time for the tests.

use mstmm_reference::{Chain, Element, End, Place, Point, Solution};

/// A connection point.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Spot {
    /// The frame that a route begins at, by the number of the route.
    Start(usize),
    /// The frame that a route ends at.
    Finish,
    /// A place of a body: the number of the body, and `input`, `output` or the name of a point.
    On(usize, String),
}

/// The connection points of a chain.
pub(crate) struct Graph {
    pub(crate) spots: Vec<Spot>,
    /// The inboard and the outboard point of every hinge.
    pub(crate) hinges: Vec<[usize; 2]>,
}

impl Graph {
    pub(crate) fn new(chain: &Chain) -> Graph {
        let mut graph = Graph { spots: Vec::new(), hinges: Vec::new() };
        let later = chain.later_routes.iter();
        let later = later.map(|route| (&route.start, &route.elements[..], &route.finish));
        let first = (&chain.start, &chain.elements[..], &chain.finish);
        let mut bodies = 0;
        for (number, (start, elements, finish)) in std::iter::once(first).chain(later).enumerate() {
            let mut here = graph.find(match start {
                End::Free => Spot::On(bodies, "input".to_owned()),
                End::Held(_) | End::Moving { .. } => Spot::Start(number),
                End::Place(Place { body, point }) => {
                    let body = chain.bodies().position(|it| it.name == *body).expect("the body");
                    Spot::On(body, point.clone())
                }
            });
            for (k, element) in elements.iter().enumerate() {
                let ends = *finish != End::Free && k + 1 == elements.len();
                let spot = match element {
                    Element::Hinge(_) if ends => Spot::Finish,
                    Element::Hinge(_) => Spot::On(bodies, "input".to_owned()),
                    Element::Body(_) => Spot::On(bodies, "output".to_owned()),
                };
                let next = graph.find(spot);
                match element {
                    Element::Hinge(_) => graph.hinges.push([here, next]),
                    Element::Body(_) => bodies += 1,
                }
                here = next;
            }
        }
        graph
    }

    /// Returns the number of a point, which is added if it is new.
    fn find(&mut self, spot: Spot) -> usize {
        self.spots.iter().position(|it| *it == spot).unwrap_or_else(|| {
            self.spots.push(spot);
            self.spots.len() - 1
        })
    }

    /// Returns the input of a body.
    pub(crate) fn input<'a>(&self, solution: &'a Solution, body: usize) -> &'a Point {
        let input = Spot::On(body, "input".to_owned());
        let found = self.spots.iter().position(|spot| *spot == input);
        &solution.points[found.expect("the input of a body")]
    }

    /// Returns the number of the body that a point is on.
    pub(crate) fn body(&self, point: usize) -> Option<usize> {
        match &self.spots[point] {
            Spot::On(body, _) => Some(*body),
            Spot::Start(_) | Spot::Finish => None,
        }
    }
}
