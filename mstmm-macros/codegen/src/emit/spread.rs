//! Where numbers lie in arrays: those of a repeated part once for every time.

use super::Plan;
use crate::model::{Element, HingeId, RepeatId};

/// An array that holds numbers of all hinges, or of all connection points.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// How many numbers the array holds.
    pub total: usize,
    /// Its pieces, in their order.
    pub pieces: Vec<Piece>,
}

/// Numbers that follow on each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Where they begin among the numbers of the model, which has every repeated part once.
    pub first: usize,
    /// How many the model has.
    pub count: usize,
    /// Where they begin in the array.
    pub place: usize,
    /// The repeated part that they belong to.
    pub repeat: Option<RepeatId>,
    /// How often they stand there.
    pub times: usize,
}

impl Spread {
    fn of(plan: &Plan, items: impl Iterator<Item = (usize, Option<RepeatId>)>) -> Self {
        let mut pieces: Vec<Piece> = Vec::new();
        let (mut first, mut place) = (0, 0);
        for (count, repeat) in items.filter(|(count, _)| *count > 0) {
            let times = repeat.map_or(1, |repeat| plan.chain.repeats[repeat].count);
            match pieces.last_mut() {
                Some(last) if last.repeat == repeat => last.count += count,
                _ => pieces.push(Piece { first, count, place, repeat, times }),
            }
            first += count;
            place += count * times;
        }
        Spread { total: place, pieces }
    }

    /// The coordinates `q`.
    pub fn coordinates(plan: &Plan) -> Self {
        Spread::of_hinges(plan, |hinge| plan.layout.q[hinge].len())
    }

    /// The rates `v`.
    pub fn freedoms(plan: &Plan) -> Self {
        Spread::of_hinges(plan, |hinge| plan.layout.v[hinge].len())
    }

    /// Accelerations and efforts of all rates.
    pub fn rates(plan: &Plan) -> Self {
        Spread::of_hinges(plan, |hinge| plan.layout.rates[hinge].len())
    }

    fn of_hinges(plan: &Plan, count: impl Fn(HingeId) -> usize) -> Self {
        let hinges = plan.chain.hinges.ids().into_iter();
        Spread::of(plan, hinges.map(|hinge| (count(hinge), plan.chain.repeat_of_hinge(hinge))))
    }

    /// All connection points.
    pub fn points(plan: &Plan) -> Self {
        let outputs = plan.chain.route.iter().map(|element| match *element {
            Element::Hinge(hinge) => (1, plan.chain.repeat_of_hinge(hinge)),
            Element::Body(body) => (1, plan.chain.repeat_of_body(body)),
        });
        Spread::of(plan, std::iter::once((1, None)).chain(outputs))
    }

    /// The numbers of all connection points, in as many pieces as the points.
    pub fn numbers_of_points(plan: &Plan) -> Self {
        Spread::of(plan, plan.programs.places.pieces.iter().copied())
    }

    /// So many numbers for every time of one repeated part.
    pub fn each(count: usize, repeat: RepeatId, times: usize) -> Self {
        let piece = Piece { first: 0, count, place: 0, repeat: Some(repeat), times };
        Spread { total: count * times, pieces: vec![piece] }
    }

    /// Numbers each of which may belong to a repeated part.
    pub fn of_parts(plan: &Plan, parts: impl Iterator<Item = Option<RepeatId>>) -> Self {
        Spread::of(plan, parts.map(|part| (1, part)))
    }

    /// The piece that a number of the model belongs to.
    pub fn piece_of(&self, number: usize) -> &Piece {
        let has_it = |piece: &&Piece| (piece.first..piece.first + piece.count).contains(&number);
        let piece = self.pieces.iter().find(has_it);
        piece.unwrap_or_else(|| bug!("number {number} of an array is in none of its pieces"))
    }
}
