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
    /// The share of a hinge at a place, by the number of the hinge and of the body.
    Share(usize, usize),
}

/// The connection points of a chain.
pub(crate) struct Graph {
    pub(crate) spots: Vec<Spot>,
    /// The inboard and the outboard point of every hinge.
    pub(crate) hinges: Vec<[usize; 2]>,
    /// The place at which every hinge begins.
    pub(crate) starts: Vec<Spot>,
}

impl Graph {
    pub(crate) fn new(chain: &Chain) -> Graph {
        let starts = starts(chain);
        let alone = |spot: &Spot| starts.iter().filter(|it| *it == spot).count() == 1;
        let (spots, hinges) = (Vec::new(), Vec::new());
        let mut graph = Graph { spots, hinges, starts: starts.clone() };
        let (mut hinge, mut body) = (0, 0);
        for (elements, finish) in routes(chain) {
            for (k, element) in elements.iter().enumerate() {
                let ends = *finish != End::Free && k + 1 == elements.len();
                let place = |name: &str| Spot::On(body, name.to_owned());
                match element {
                    Element::Hinge(_) => {
                        let start = match &starts[hinge] {
                            Spot::On(at, name) if name == "input" || !alone(&starts[hinge]) => {
                                Spot::Share(hinge, *at)
                            }
                            start => start.clone(),
                        };
                        let outboard = if ends { Spot::Finish } else { place("input") };
                        let sides = [graph.find(start), graph.find(outboard)];
                        graph.hinges.push(sides);
                        hinge += 1;
                    }
                    Element::Body(described) => {
                        graph.find(place("input"));
                        graph.find(place("output"));
                        let points = described.points.iter().map(|point| place(&point.name));
                        for point in points.filter(|point| starts.contains(point)) {
                            graph.find(point);
                        }
                        body += 1;
                    }
                }
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
            Spot::On(body, _) | Spot::Share(_, body) => Some(*body),
            Spot::Start(_) | Spot::Finish => None,
        }
    }
}

/// Returns the elements and the finishes of all routes.
fn routes(chain: &Chain) -> impl Iterator<Item = (&[Element], &End)> {
    let later = chain.later_routes.iter().map(|route| (&route.elements[..], &route.finish));
    std::iter::once((&chain.elements[..], &chain.finish)).chain(later)
}

/// Returns the place at which every hinge begins.
fn starts(chain: &Chain) -> Vec<Spot> {
    let later = chain.later_routes.iter().map(|route| &route.start);
    let ends: Vec<&End> = std::iter::once(&chain.start).chain(later).collect();
    let (mut starts, mut bodies) = (Vec::new(), 0);
    for (number, (elements, _)) in routes(chain).enumerate() {
        let mut here = match ends[number] {
            End::Free | End::Held(_) | End::Moving { .. } => Spot::Start(number),
            End::Place(Place { body, point }) => {
                let body = chain.bodies().position(|it| it.name == *body).expect("the body");
                Spot::On(body, point.clone())
            }
        };
        for element in elements {
            match element {
                Element::Hinge(_) => starts.push(here.clone()),
                Element::Body(_) => {
                    here = Spot::On(bodies, "output".to_owned());
                    bodies += 1;
                }
            }
        }
    }
    starts
}
