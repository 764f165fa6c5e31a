//! Where the numbers of connection points are stored: every vector once, however many points share it.

use crate::equations::{FramedVector, PointState, SymbolValues};
use crate::expr::{Edge, Expr, Graph};
use crate::model::{Body, Chain, Dimension, Element, RepeatId, Results};
use std::collections::HashMap;

/// A vector among the numbers of all points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StoredVector {
    /// Where its first number is in its segment, counted from one; zero for a vector of zeros.
    pub first: usize,
    /// How many numbers it has.
    pub count: usize,
}

/// A vector and the axes that it is seen in: places of what turns into inertial ones, columns of a
/// matrix in space, cosine and sine in the plane; none if the vector is inertial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StoredFramedVector {
    /// The axes.
    pub axes: Option<Vec<StoredVector>>,
    /// The vector.
    pub vector: StoredVector,
}

/// Where the numbers of a connection point are.
#[derive(Clone, Debug)]
pub struct StoredPoint {
    /// How many numbers of all points lie before their segment.
    pub start: usize,
    /// Its position.
    pub position: StoredVector,
    /// Its orientation, as axes are; none in inertial axes.
    pub orientation: Option<Vec<StoredVector>>,
    /// Velocity, `Ω`, `r̈` as felt, `Ω̇`, `m` and `q`; along a line those that there are.
    pub vectors: Vec<StoredFramedVector>,
    /// At the input of a body its centre of mass and its named points, body frame; none where no
    /// parameter changes them, so that the workspace need not keep them.
    pub changing: Vec<Option<StoredVector>>,
}

/// Where the numbers of all connection points are: segments of those that stand once or belong to one
/// repeated part.
#[derive(Clone, Debug, Default)]
pub struct PointStorage {
    /// How many numbers each segment has, and its repeated part.
    pub segments: Vec<(usize, Option<RepeatId>)>,
    /// The points of the model.
    pub points: Vec<StoredPoint>,
}

/// The places of points, each with its repeated part, and the numbers that are to lie there.
pub(super) fn allocate<'g>(
    chain: &Chain,
    graph: &'g Graph,
    points: &[PointState<Expr<'g>>],
    numbers: &SymbolValues<Expr<'g>>,
) -> (PointStorage, Vec<Expr<'g>>) {
    let mut all = PointAllocator { graph, known: HashMap::new(), start: 0, numbers: Vec::new() };
    let mut storage = PointStorage::default();
    let part = |element: &Element| match *element {
        Element::Hinge(hinge) => chain.repeat_of_hinge(hinge),
        Element::Body(body) => chain.repeat_of_body(body),
    };
    let parts = std::iter::once(None).chain(chain.route.iter().map(part));
    for (index, (point, part)) in points.iter().zip(parts).enumerate() {
        match storage.segments.last() {
            Some((_, last)) if *last == part => {}
            _ => {
                all.begin_segment();
                storage.segments.push((0, part));
            }
        }
        let mut own = all.point(point, chain.dimension, chain.results);
        if let Some(Element::Body(body)) = chain.route.get(index) {
            own.changing = all.changing(&chain.bodies[*body], chain, numbers);
        }
        storage.points.push(own);
        if let Some((count, _)) = storage.segments.last_mut() {
            *count = all.count();
        }
    }
    (storage, all.numbers)
}

/// Numbers that find their places.
struct PointAllocator<'g> {
    graph: &'g Graph,
    /// Where vectors of the segment begin, by their numbers.
    known: HashMap<Vec<Edge>, usize>,
    /// How many numbers lie before the segment.
    start: usize,
    /// All numbers.
    numbers: Vec<Expr<'g>>,
}

impl<'g> PointAllocator<'g> {
    fn begin_segment(&mut self) {
        self.known.clear();
        self.start = self.numbers.len();
    }

    /// How many numbers the segment has.
    fn count(&self) -> usize {
        self.numbers.len() - self.start
    }

    /// The places of what is asked for; of all else those of zeros.
    fn point(
        &mut self,
        point: &PointState<Expr<'g>>,
        dimension: Dimension,
        results: Results,
    ) -> StoredPoint {
        let (shifts, turns) = (dimension.shifts(), dimension.turns());
        let seen = [
            (results.velocities, &point.velocity, shifts),
            (results.velocities, &point.omega, turns),
            (results.z, &point.felt, shifts),
            (results.z, &point.turning, turns),
            (results.z, &point.moment, turns),
            (results.z, &point.force, shifts),
        ];
        let (position, orientation) = if results.poses {
            let columns = point.rotation.transposed().0;
            (self.vector(point.position.0, shifts), self.axes(columns, dimension))
        } else {
            (StoredVector::default(), None)
        };
        let seen = seen.into_iter().filter(|(.., along)| !along.is_empty());
        let framed = |(wanted, seen, along)| match wanted {
            true => self.framed(seen, along, dimension),
            false => StoredFramedVector { axes: None, vector: StoredVector::default() },
        };
        let vectors = seen.map(framed).collect();
        let changing = Vec::new();
        StoredPoint { start: self.start, position, orientation, vectors, changing }
    }

    /// The places of those of a body's points that parameters change, if they can be read.
    fn changing(
        &mut self,
        body: &Body,
        chain: &Chain,
        numbers: &SymbolValues<Expr<'g>>,
    ) -> Vec<Option<StoredVector>> {
        let shifts = chain.dimension.shifts();
        let all = body.own_points().map(|position| {
            let changes = shifts.iter().any(|&axis| position[axis].changes());
            let kept = changes && chain.results.poses;
            kept.then(|| self.vector(numbers.vector(position).0, shifts))
        });
        all.collect()
    }

    fn framed(
        &mut self,
        seen: &FramedVector<Expr<'g>>,
        along: &[usize],
        dimension: Dimension,
    ) -> StoredFramedVector {
        let vector = self.vector(seen.vector.0, along);
        // Zeros, and a turn in the plane, are the same numbers in all axes.
        let turned = vector != StoredVector::default() && along.len() > 1;
        let axes = turned.then(|| self.axes(seen.axes.transposed().0, dimension)).flatten();
        StoredFramedVector { axes, vector }
    }

    /// The places of axes, unless they are inertial.
    fn axes(
        &mut self,
        columns: [[Expr<'g>; 3]; 3],
        dimension: Dimension,
    ) -> Option<Vec<StoredVector>> {
        let is_unit = |(k, column): (usize, &[Expr<'g>; 3])| {
            let one = |i: usize| if i == k { 1.0 } else { 0.0 };
            column.iter().enumerate().all(|(i, x)| x.known() == Some(one(i)))
        };
        let inertial = columns.iter().enumerate().all(is_unit);
        let (count, shifts) = (dimension.columns(), dimension.shifts());
        (!inertial && count > 0)
            .then(|| columns[..count].iter().map(|&column| self.vector(column, shifts)).collect())
    }

    /// The place of a vector's entries along the axes that matter.
    fn vector(&mut self, vector: [Expr<'g>; 3], along: &[usize]) -> StoredVector {
        let edges: Vec<Edge> = along.iter().map(|&k| self.graph.edge(vector[k])).collect();
        if edges.iter().all(|&edge| self.graph.expr(edge).known() == Some(0.0)) {
            return StoredVector::default();
        }
        let count = edges.len();
        if let Some(&first) = self.known.get(&edges) {
            return StoredVector { first, count };
        }
        let first = self.count() + 1;
        self.numbers.extend(edges.iter().map(|&edge| self.graph.expr(edge)));
        self.known.insert(edges, first);
        StoredVector { first, count }
    }
}
