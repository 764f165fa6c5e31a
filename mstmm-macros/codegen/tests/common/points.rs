//! Reads connection points from the stored values of a solution, as the runtime does.

use super::interpreter::{Arrays, Judge};
use mstmm_codegen::compile::{
    Compiled, StoredFramedVector, StoredPoint, StoredVector, layouts, outputs,
};
use mstmm_codegen::ids::{PointId, RepeatId};
use mstmm_codegen::model::{Chain, Element, ElementPoints};
use mstmm_codegen::program::ArrayLayout;

/// Returns all points in inertial axes, in the order of the chain written out.
pub fn points<S: Judge>(chain: &Chain, compiled: &Compiled, full: &Arrays<S>) -> Vec<S> {
    let parts = compiled.point_storage.of.points.iter().map(|point| point.repeat);
    let points: Vec<(Option<RepeatId>, &StoredPoint)> =
        parts.zip(&compiled.point_storage.points).collect();
    let reader = Reader {
        chain,
        layout: layouts::numbers_of_points(chain, &compiled.point_storage),
        numbers: full.result(outputs::POINT_NUMBERS),
        base_acceleration: full.result(outputs::BASE_ACCELERATION),
    };
    let mut all = Vec::new();
    for segment in points.chunk_by(|one, next| one.0 == next.0) {
        let count = segment[0].0.map_or(1, |part| chain.repeats[part].count);
        for repetition in 0..count {
            for (_, point) in segment {
                all.extend(reader.point(point, repetition));
            }
        }
    }
    all
}

/// The points of an element in inertial axes.
pub struct OfElement<S> {
    pub input: Vec<S>,
    pub output: Vec<S>,
    /// The named points of a body at which hinges begin, by their index in the body.
    pub named: Vec<(usize, Vec<S>)>,
}

/// Returns the points of all elements, in the order of the chain written out.
pub fn element_points<S: Judge>(
    chain: &Chain,
    compiled: &Compiled,
    full: &Arrays<S>,
) -> Vec<OfElement<S>> {
    let storage = &compiled.point_storage;
    let reader = Reader {
        chain,
        layout: layouts::numbers_of_points(chain, storage),
        numbers: full.result(outputs::POINT_NUMBERS),
        base_acceleration: full.result(outputs::BASE_ACCELERATION),
    };
    let point = |id: PointId, own: Option<RepeatId>, repetition: usize| {
        let repetition = match storage.of.points[id].repeat {
            None => 0,
            Some(part) if Some(part) == own => repetition,
            // Elsewhere, a point of a repeated part is that of the last repetition.
            Some(part) => chain.repeats[part].count - 1,
        };
        reader.point(&storage.points[id], repetition)
    };
    let numbered: Vec<usize> = (0..chain.elements.len()).collect();
    let part = |index: usize| match chain.elements[index] {
        Element::Hinge(hinge) => chain.repeat_of_hinge(hinge),
        Element::Body(body) => chain.repeat_of_body(body),
    };
    let mut all = Vec::new();
    for segment in numbered.chunk_by(|one, next| part(*one) == part(*next)) {
        let own = part(segment[0]);
        let count = own.map_or(1, |part| chain.repeats[part].count);
        for repetition in 0..count {
            for &index in segment {
                let ElementPoints { input, previous, output } = storage.of.elements[index];
                let input = match previous {
                    Some(previous) if repetition > 0 => point(previous, own, repetition - 1),
                    _ => point(input, own, repetition),
                };
                let output = point(output, own, repetition);
                let mut named = Vec::new();
                if let Element::Body(body) = chain.elements[index] {
                    for number in 0..chain.bodies[body].points.len() {
                        if let Some(&id) = storage.of.joined.get(&(body, number)) {
                            named.push((number, point(id, own, repetition)));
                        }
                    }
                }
                all.push(OfElement { input, output, named });
            }
        }
    }
    all
}

/// Returns the results of all springs, with the repetitions of each spring one after the other.
pub fn springs<S: Judge>(chain: &Chain, full: &Arrays<S>) -> Vec<S> {
    let layout = layouts::springs(chain);
    let values = full.result(outputs::SPRINGS);
    let count = 3 + chain.dimension.translations().len();
    let mut all = Vec::new();
    for spring in 0..chain.springs.len() {
        let segment = layout.segment_of(spring * count);
        let first = segment.offset + spring * count - segment.first;
        for repetition in 0..segment.repetitions {
            all.extend_from_slice(&values[first + repetition * segment.count..][..count]);
        }
    }
    all
}

struct Reader<'a, S> {
    chain: &'a Chain,
    layout: ArrayLayout,
    numbers: Vec<S>,
    base_acceleration: Vec<S>,
}

impl<S: Judge> Reader<'_, S> {
    fn point(&self, point: &StoredPoint, repetition: usize) -> Vec<S> {
        let dimension = self.chain.dimension;
        let (translations, rotations) = (dimension.translations(), dimension.rotations());
        let entries = |stored: &StoredVector, count: usize| -> Vec<S> {
            let Some(first) = stored.first.checked_sub(1) else { return vec![S::zero(); count] };
            assert_eq!(stored.count, count);
            (0..count).map(|k| self.number(point.start + first + k, repetition)).collect()
        };
        let inertial =
            |StoredFramedVector { axes, vector }: &StoredFramedVector, along: &[usize]| -> Vec<S> {
                let vector = entries(vector, along.len());
                match axes.as_deref() {
                    None => vector,
                    Some([cos_sin]) => {
                        let [c, s] = entries(cos_sin, 2)[..] else { panic!("cosine and sine") };
                        vec![c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]]
                    }
                    Some(columns) => {
                        let columns: Vec<Vec<S>> = columns.iter().map(|x| entries(x, 3)).collect();
                        let sum = |k: usize| (0..3).map(move |j| (j, k));
                        let product = |(j, k): (usize, usize)| columns[j][k] * vector[j];
                        (0..3).map(|k| sum(k).map(product).fold(S::zero(), |a, b| a + b)).collect()
                    }
                }
            };
        let mut all = entries(&point.position, translations.len());
        match &point.orientation {
            Some(columns) => {
                all.extend(columns.iter().flat_map(|x| entries(x, translations.len())))
            }
            None => {
                let unit = |column: usize| {
                    (0..translations.len()).map(move |row| if row == column { 1.0 } else { 0.0 })
                };
                all.extend((0..dimension.columns()).flat_map(unit).map(S::number));
            }
        }
        // Velocity, angular velocity, proper acceleration, angular acceleration, moment and force.
        let kinds = [translations, rotations, translations, rotations, rotations, translations];
        let there = kinds.into_iter().enumerate().filter(|(_, along)| !along.is_empty());
        for ((kind, along), framed) in there.zip(&point.vectors) {
            let seen = inertial(framed, along);
            match kind {
                2 => all.extend(seen.iter().zip(&self.base_acceleration).map(|(&a, &g)| a - g)),
                _ => all.extend(seen),
            }
        }
        all
    }

    /// Returns an entry in a repetition of its part.
    fn number(&self, entry: usize, repetition: usize) -> S {
        let segment = self.layout.segment_of(entry);
        self.numbers[segment.offset + repetition * segment.count + entry - segment.first]
    }
}
