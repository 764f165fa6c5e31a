//! Where results lie that many connection points share: every vector once, whichever its sign.

use crate::equations::{Point, Seen};
use crate::expr::{Edge, Expr, Graph};
use crate::model::{Chain, Dimension, Element};
use std::collections::HashMap;

/// A vector among the numbers of all points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Place {
    /// Where its first number is in its piece, counted from one; zero for a vector of zeros.
    pub first: usize,
    /// Whether the opposite vector lies there.
    pub opposite: bool,
}

/// A vector and the axes that it is seen in: places of what turns into inertial ones, columns of a
/// matrix in space, cosine and sine in the plane; none if the vector is inertial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Sight {
    /// The axes.
    pub axes: Option<Vec<Place>>,
    /// The vector.
    pub vector: Place,
}

/// Where the numbers of a connection point are.
#[derive(Clone, Debug)]
pub struct PointPlaces {
    /// Its position.
    pub position: Place,
    /// Its orientation, as axes are; none in inertial axes.
    pub orientation: Option<Vec<Place>>,
    /// Velocity, `Ω`, `r̈` as felt, `Ω̇`, `m` and `q`; along a line those that there are.
    pub vectors: Vec<Sight>,
}

/// Where the numbers of all connection points are: pieces of those that stand once or belong to one
/// repeated part.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// How many numbers each piece has, and its repeated part.
    pub pieces: Vec<(usize, Option<usize>)>,
    /// The points of the model.
    pub points: Vec<PointPlaces>,
}

/// The places of points, each with its repeated part, and the numbers that are to lie there.
pub(super) fn places<'g>(
    chain: &Chain,
    graph: &'g Graph,
    points: &[Point<Expr<'g>>],
) -> (Places, Vec<Expr<'g>>) {
    let mut all = Filling { graph, known: HashMap::new(), count: 0, numbers: Vec::new() };
    let mut places = Places::default();
    let part = |element: &Element| match *element {
        Element::Hinge(hinge) => chain.repeat_of_hinge(hinge),
        Element::Body(body) => chain.repeat_of_body(body),
    };
    let parts = std::iter::once(None).chain(chain.route.iter().map(part));
    for (point, part) in points.iter().zip(parts) {
        match places.pieces.last() {
            Some((_, last)) if *last == part => {}
            _ => {
                all.begin_piece();
                places.pieces.push((0, part));
            }
        }
        places.points.push(all.point(point, chain.dimension));
        if let Some((count, _)) = places.pieces.last_mut() {
            *count = all.count;
        }
    }
    (places, all.numbers)
}

/// Numbers that find their places.
struct Filling<'g> {
    graph: &'g Graph,
    /// Vectors of the piece, in the sign that most of their numbers are positive in.
    known: HashMap<Vec<Edge>, Place>,
    /// How many numbers the piece has.
    count: usize,
    /// All numbers.
    numbers: Vec<Expr<'g>>,
}

impl<'g> Filling<'g> {
    fn begin_piece(&mut self) {
        self.known.clear();
        self.count = 0;
    }

    fn point(&mut self, point: &Point<Expr<'g>>, dimension: Dimension) -> PointPlaces {
        let (shifts, turns) = (dimension.shifts(), dimension.turns());
        let seen = [
            (&point.velocity, shifts),
            (&point.omega, turns),
            (&point.felt, shifts),
            (&point.turning, turns),
            (&point.moment, turns),
            (&point.force, shifts),
        ];
        PointPlaces {
            position: self.vector(point.position.0, shifts),
            orientation: self.axes(point.rotation.transposed().0, dimension),
            vectors: seen
                .into_iter()
                .filter(|(_, along)| !along.is_empty())
                .map(|(seen, along)| self.sight(seen, along, dimension))
                .collect(),
        }
    }

    fn sight(&mut self, seen: &Seen<Expr<'g>>, along: &[usize], dimension: Dimension) -> Sight {
        let vector = self.vector(seen.vector.0, along);
        // Zeros, and a turn in the plane, are the same numbers in all axes.
        let turned = vector != Place::default() && along.len() > 1;
        let axes = turned.then(|| self.axes(seen.axes.transposed().0, dimension)).flatten();
        Sight { axes, vector }
    }

    /// The places of axes, unless they are inertial.
    fn axes(&mut self, columns: [[Expr<'g>; 3]; 3], dimension: Dimension) -> Option<Vec<Place>> {
        let is_unit = |(k, column): (usize, &[Expr<'g>; 3])| {
            let one = |i: usize| if i == k { 1.0 } else { 0.0 };
            column.iter().enumerate().all(|(i, x)| x.known() == Some(one(i)))
        };
        let inertial = columns.iter().enumerate().all(is_unit);
        let count = match dimension {
            Dimension::Space => 3,
            Dimension::Plane => 1,
            Dimension::Line => 0,
        };
        let shifts = dimension.shifts();
        (!inertial && count > 0)
            .then(|| columns[..count].iter().map(|&column| self.vector(column, shifts)).collect())
    }

    /// The place of a vector's entries along the axes that matter.
    fn vector(&mut self, vector: [Expr<'g>; 3], along: &[usize]) -> Place {
        let edges: Vec<Edge> = along.iter().map(|&k| self.graph.edge(vector[k])).collect();
        let is_zero = |edge: &Edge| self.graph.expr(*edge).known() == Some(0.0);
        let signs: Vec<bool> =
            edges.iter().filter(|edge| !is_zero(edge)).map(|edge| edge.is_negative()).collect();
        let Some(&first) = signs.first() else { return Place::default() };
        let negative = signs.iter().filter(|&&negative| negative).count();
        let opposite = 2 * negative > signs.len() || (2 * negative == signs.len() && first);
        let turned = |edge: Edge| if opposite && !is_zero(&edge) { edge.negated() } else { edge };
        let edges: Vec<Edge> = edges.into_iter().map(turned).collect();
        if let Some(place) = self.known.get(&edges) {
            return Place { opposite, ..*place };
        }
        let place = Place { first: self.count + 1, opposite: false };
        self.count += edges.len();
        self.numbers.extend(edges.iter().map(|&edge| self.graph.expr(edge)));
        self.known.insert(edges, place);
        Place { opposite, ..place }
    }
}
