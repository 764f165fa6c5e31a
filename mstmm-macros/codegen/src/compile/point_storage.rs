//! Assigns the vectors of connection points to entries of the workspace. Points that share a vector share its entries.

use crate::equations::{FramedVector, PointState, Report, SymbolValues};
use crate::expr::{Edge, Expr, Graph};
use crate::ids::{BodyId, IdVec, PointId, RepeatId};
use crate::model::{Body, Chain, ConnectionPoints, Dimension, Element, Results, Value};
use std::collections::HashMap;

/// A vector in the stored values of all points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StoredVector {
    /// One plus the index of its first entry in its segment; zero for a zero vector.
    pub first: usize,
    /// The number of its entries.
    pub count: usize,
}

/// A vector and the frame in which it is stored.
///
/// The frame is given by the rotation from it to the inertial frame: the columns of the matrix in space, cosine and sine
/// in the plane. It is none for a vector in inertial axes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StoredFramedVector {
    /// The rotation to the inertial frame.
    pub axes: Option<Vec<StoredVector>>,
    /// The vector.
    pub vector: StoredVector,
}

/// The stored values of a connection point.
#[derive(Clone, Debug)]
pub struct StoredPoint {
    /// The index among all stored values at which its segment starts.
    pub start: usize,
    /// The position.
    pub position: StoredVector,
    /// The rotation of its axes to the inertial frame; none for inertial axes.
    pub orientation: Option<Vec<StoredVector>>,
    /// Velocity, angular velocity, proper acceleration, angular acceleration, moment and force; on a line only those that
    /// exist.
    pub vectors: Vec<StoredFramedVector>,
    /// At the input of a body: its centre of mass and its named points.
    pub own: Vec<StoredFrame>,
}

/// What parameters change of a frame in a body, in the body frame. The workspace does not store the rest.
#[derive(Clone, Debug, Default)]
pub struct StoredFrame {
    /// The position.
    pub position: Option<StoredVector>,
    /// The columns of the rotation; in the plane the first.
    pub axes: Option<Vec<StoredVector>>,
}

/// The storage of all connection points, in segments of points that belong to the same repeated part, or to none.
#[derive(Clone, Debug, Default)]
pub struct PointStorage {
    /// The number of entries of each segment, and its repeated part.
    pub segments: Vec<(usize, Option<RepeatId>)>,
    /// The points.
    pub points: IdVec<PointId, StoredPoint>,
    /// The connection points that they belong to.
    pub of: ConnectionPoints,
}

/// Assigns storage to all points of a chain, the same for several functions that compute them. Returns the storage, and the
/// values to be stored of each function. `reports` has one report for each function.
pub(super) fn allocate<'g>(
    chain: &Chain,
    graph: &'g Graph,
    reports: &[Report<Expr<'g>>],
    numbers: &SymbolValues<Expr<'g>>,
) -> (PointStorage, Vec<Vec<Expr<'g>>>) {
    let stored = vec![Vec::new(); reports.len()];
    let mut allocator = PointAllocator { graph, known: HashMap::new(), start: 0, numbers: stored };
    let mut storage =
        PointStorage { of: reports[0].connection_points.clone(), ..PointStorage::default() };
    let ends = chain.elements.iter().zip(&storage.of.elements);
    let inputs: HashMap<PointId, BodyId> = ends
        .filter_map(|(&element, ends)| match element {
            Element::Body(body) => Some((ends.input, body)),
            Element::Hinge(_) => None,
        })
        .collect();
    for (index, at) in storage.of.points.enumerate() {
        match storage.segments.last() {
            Some((_, last)) if *last == at.repeat => {}
            _ => {
                allocator.begin_segment();
                storage.segments.push((0, at.repeat));
            }
        }
        let points: Vec<&PointState<Expr>> =
            reports.iter().map(|report| &report.points[index]).collect();
        let mut stored = allocator.point(&points, chain.dimension, chain.results);
        if let Some(&body) = inputs.get(&index) {
            stored.own = allocator.own_frames(&chain.bodies[body], chain, numbers);
        }
        storage.points.push(stored);
        if let Some((count, _)) = storage.segments.last_mut() {
            *count = allocator.count();
        }
    }
    (storage, allocator.numbers)
}

/// The storage under construction. A vector has one value for each function; it is stored unless it vanishes in all of them.
struct PointAllocator<'g> {
    graph: &'g Graph,
    /// The first entries of the segment's vectors, by their values.
    known: HashMap<Vec<Edge>, usize>,
    /// The number of entries before the segment.
    start: usize,
    /// The stored values of each function.
    numbers: Vec<Vec<Expr<'g>>>,
}

impl<'g> PointAllocator<'g> {
    fn begin_segment(&mut self) {
        self.known.clear();
        self.start = self.numbers[0].len();
    }

    /// Returns the number of entries of the segment.
    fn count(&self) -> usize {
        self.numbers[0].len() - self.start
    }

    /// Stores the requested vectors of a point; all others are zero vectors.
    fn point(
        &mut self,
        points: &[&PointState<Expr<'g>>],
        dimension: Dimension,
        results: Results,
    ) -> StoredPoint {
        let (translations, rotations) = (dimension.translations(), dimension.rotations());
        let all = |read: fn(&PointState<Expr<'g>>) -> FramedVector<Expr<'g>>| {
            points.iter().map(|point| read(point)).collect::<Vec<_>>()
        };
        let seen = [
            (results.velocities, all(|point| point.velocity), translations),
            (results.velocities, all(|point| point.omega), rotations),
            (results.z, all(|point| point.proper_acceleration), translations),
            (results.z, all(|point| point.angular_acceleration), rotations),
            (results.z, all(|point| point.moment), rotations),
            (results.z, all(|point| point.force), translations),
        ];
        let (position, orientation) = if results.poses {
            let positions = points.iter().map(|point| point.position.0);
            let columns = points.iter().map(|point| point.rotation.transposed().0);
            (
                self.vector(&positions.collect::<Vec<_>>(), translations),
                self.axes(&columns.collect::<Vec<_>>(), dimension),
            )
        } else {
            (StoredVector::default(), None)
        };
        let seen = seen.into_iter().filter(|(.., along)| !along.is_empty());
        let framed =
            |(wanted, seen, along): (bool, Vec<FramedVector<Expr<'g>>>, &[usize])| match wanted {
                true => self.framed(&seen, along, dimension),
                false => StoredFramedVector { axes: None, vector: StoredVector::default() },
            };
        let vectors = seen.map(framed).collect();
        StoredPoint { start: self.start, position, orientation, vectors, own: Vec::new() }
    }

    /// Stores what parameters change of the frames of a body, if the results include poses.
    fn own_frames(
        &mut self,
        body: &Body,
        chain: &Chain,
        numbers: &SymbolValues<Expr<'g>>,
    ) -> Vec<StoredFrame> {
        let dimension = chain.dimension;
        let translations = dimension.translations();
        let all = body.own_frames().map(|(place, rotation)| {
            if !chain.results.poses {
                return StoredFrame::default();
            }
            let moves = translations.iter().any(|&axis| place[axis].changes());
            let place = numbers.vector(place).0;
            let position =
                moves.then(|| self.vector(&vec![place; self.numbers.len()], translations));
            let turns = rotation.filter(|rotation| rotation.iter().flatten().any(Value::changes));
            let axes = turns.and_then(|rotation| {
                let column = |k: usize| [0, 1, 2].map(|i| numbers.scalar(&rotation[i][k]));
                let columns = [0, 1, 2].map(column);
                self.axes(&vec![columns; self.numbers.len()], dimension)
            });
            StoredFrame { position, axes }
        });
        all.collect()
    }

    fn framed(
        &mut self,
        seen: &[FramedVector<Expr<'g>>],
        along: &[usize],
        dimension: Dimension,
    ) -> StoredFramedVector {
        let vectors: Vec<[Expr; 3]> = seen.iter().map(|seen| seen.vector.0).collect();
        let vector = self.vector(&vectors, along);
        // A zero vector, and a rotation in the plane, have the same components in all axes.
        let has_frame = vector != StoredVector::default() && along.len() > 1;
        let columns = || seen.iter().map(|seen| seen.axes.transposed().0).collect::<Vec<_>>();
        let axes = has_frame.then(|| self.axes(&columns(), dimension)).flatten();
        StoredFramedVector { axes, vector }
    }

    /// Stores the columns of a rotation, unless it is the identity.
    fn axes(
        &mut self,
        columns: &[[[Expr<'g>; 3]; 3]],
        dimension: Dimension,
    ) -> Option<Vec<StoredVector>> {
        let is_unit = |(k, column): (usize, &[Expr<'g>; 3])| {
            let one = |i: usize| if i == k { 1.0 } else { 0.0 };
            column.iter().enumerate().all(|(i, x)| x.known() == Some(one(i)))
        };
        let inertial = columns.iter().all(|columns| columns.iter().enumerate().all(is_unit));
        let (count, translations) = (dimension.columns(), dimension.translations());
        let column = |k: usize| columns.iter().map(|columns| columns[k]).collect::<Vec<_>>();
        (!inertial && count > 0)
            .then(|| (0..count).map(|k| self.vector(&column(k), translations)).collect())
    }

    /// Stores the components of a vector along some axes.
    fn vector(&mut self, vectors: &[[Expr<'g>; 3]], along: &[usize]) -> StoredVector {
        let edge = |vector: &[Expr<'g>; 3], k: usize| self.graph.edge(vector[k]);
        let edges: Vec<Edge> =
            vectors.iter().flat_map(|vector| along.iter().map(move |&k| edge(vector, k))).collect();
        if edges.iter().all(|&edge| self.graph.expr(edge).known() == Some(0.0)) {
            return StoredVector::default();
        }
        let count = along.len();
        if let Some(&first) = self.known.get(&edges) {
            return StoredVector { first, count };
        }
        let first = self.count() + 1;
        for (numbers, of_function) in self.numbers.iter_mut().zip(edges.chunks(count)) {
            numbers.extend(of_function.iter().map(|&edge| self.graph.expr(edge)));
        }
        self.known.insert(edges, first);
        StoredVector { first, count }
    }
}
