//! Repeated parts as loops: what sweeps carry over the seams, as unknowns.
//!
//! Sweeps over a repeated part are loops. What a loop carries is found by running the equations:
//! at first everything that is known where a loop begins is taken to be the same every time. Where
//! that turns out wrong the number becomes an unknown, and the equations are run again.
//!
//! Sweeps that carry the same are one loop: one that begins like an earlier one is taken to be that one,
//! with its unknowns, until it turns out to hand on something else.

use crate::equations::Weave;
use crate::expr::{Expr, Graph, Stage};
use crate::ids::RepeatId;
use std::cell::RefCell;
use std::fmt;

/// A loop over a repeated part.
#[derive(Clone, Debug)]
pub struct Turn<'g> {
    /// Which part.
    pub repeat: RepeatId,
    /// Whether it goes from the last time to the first.
    pub inwards: bool,
    /// What it carries.
    pub carries: Vec<Carry<'g>>,
}

/// A number that a loop carries.
#[derive(Clone, Copy, Debug)]
pub struct Carry<'g> {
    /// What the first time begins with.
    pub first: Expr<'g>,
    /// What any time hands on.
    pub next: Expr<'g>,
    /// Number of the unknown that any time begins with.
    pub entering: u32,
    /// Number of the unknown that the last time leaves.
    pub leaving: u32,
}

/// Runs equations until what is carried is consistent.
pub struct Loom<'g> {
    graph: &'g Graph,
    /// The number of the first unknown of its own.
    base: u32,
    state: RefCell<State<'g>>,
}

#[derive(Default)]
struct State<'g> {
    /// What earlier runs have shown of the sweeps that cross repeated parts, in the order in which they
    /// enter them.
    shown: Vec<Shown>,
    /// So much of that stands, the rest having gone on from what is wrong.
    standing: Option<usize>,
    crossings: Vec<Crossing<'g>>,
    /// The crossings begun and not ended.
    open: Vec<usize>,
    turns: Vec<Turn<'g>>,
    used: u32,
    consistent: bool,
}

/// What is known of a crossing before it is made.
struct Shown {
    /// Which numbers change from time to time.
    changing: Vec<bool>,
    /// So many earlier ones begin like it and go on otherwise.
    others: usize,
}

/// A sweep over a repeated part.
struct Crossing<'g> {
    repeat: RepeatId,
    inwards: bool,
    /// All that is carried into the part, known numbers as well.
    first: Vec<Expr<'g>>,
    /// What any time begins with.
    entering: Vec<Expr<'g>>,
    /// Its loop, or the earlier crossing that it is taken to be.
    way: Way,
    /// What any time ends with and what the last one leaves, once that is known.
    end: Option<(Vec<Expr<'g>>, Vec<Expr<'g>>)>,
}

#[derive(Clone, Copy)]
enum Way {
    Own { turn: usize },
    Same { crossing: usize },
}

impl<'g> Loom<'g> {
    /// A loom whose unknowns are numbered from `base` on.
    pub fn new(graph: &'g Graph, base: u32) -> Self {
        Loom { graph, base, state: RefCell::default() }
    }

    /// Runs `equations` until what is carried is consistent; the loops and the result.
    pub fn run<R>(&self, equations: impl Fn(&Self) -> R) -> (R, Vec<Turn<'g>>) {
        loop {
            let State { mut shown, standing, .. } = self.state.take();
            shown.truncate(standing.unwrap_or(shown.len()));
            *self.state.borrow_mut() = State { shown, consistent: true, ..State::default() };
            let result = equations(self);
            let mut state = self.state.borrow_mut();
            if state.consistent {
                return (result, std::mem::take(&mut state.turns));
            }
        }
    }

    /// An unknown of its own.
    fn unknown(&self, number: u32) -> Expr<'g> {
        self.graph.symbol(number, Stage::State)
    }

    /// Begins a loop: itself, and what any time begins with.
    fn begin(&self, number: usize, first: &[Expr<'g>]) -> (Vec<Carry<'g>>, Vec<Expr<'g>>) {
        let State { shown, used, .. } = &mut *self.state.borrow_mut();
        let mut carries = Vec::new();
        let enter = |(&first, changes): (&Expr<'g>, &mut bool)| {
            // What is known now may not have been in an earlier run.
            *changes |= first.known().is_none();
            if !*changes {
                return first;
            }
            let entering = self.base + *used;
            *used += 2;
            carries.push(Carry { first, next: first, entering, leaving: entering + 1 });
            self.unknown(entering)
        };
        let entering = first.iter().zip(&mut shown[number].changing).map(enter).collect();
        (carries, entering)
    }

    /// Ends a loop: what the last time leaves.
    fn end(&self, number: usize, turn: usize, any: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let State { shown, crossings, turns, consistent, .. } = &mut *self.state.borrow_mut();
        let mut carries = turns[turn].carries.iter_mut();
        let firsts = crossings[number].first.iter();
        let leave = |((&next, &first), changes): ((&Expr<'g>, &Expr<'g>), &mut bool)| {
            if !*changes {
                if next.known() != first.known() {
                    (*changes, *consistent) = (true, false);
                }
                return first;
            }
            carries.next().map_or(next, |carry| {
                carry.next = next;
                self.unknown(carry.leaving)
            })
        };
        any.iter().zip(firsts).zip(&mut shown[number].changing).map(leave).collect()
    }
}

impl<'g> Weave<Expr<'g>> for Loom<'g> {
    fn enter(&self, repeat: RepeatId, inwards: bool, first: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let (number, earlier) = self.state.borrow_mut().cross((repeat, inwards), first);
        let (way, entering) = match earlier {
            Some((crossing, entering)) => (Way::Same { crossing }, entering),
            None => {
                let (carries, entering) = self.begin(number, first);
                let turns = &mut self.state.borrow_mut().turns;
                turns.push(Turn { repeat, inwards, carries });
                (Way::Own { turn: turns.len() - 1 }, entering)
            }
        };
        let (first, begun) = (first.to_vec(), entering.clone());
        let crossing = Crossing { repeat, inwards, first, entering: begun, way, end: None };
        self.state.borrow_mut().crossings.push(crossing);
        entering
    }

    fn leave(&self, _: RepeatId, any: &[Expr<'g>]) -> Vec<Expr<'g>> {
        // Every sweep that leaves has entered.
        let Some(number) = self.state.borrow_mut().open.pop() else { return any.to_vec() };
        let way = self.state.borrow().crossings[number].way;
        let leaving = match way {
            Way::Own { turn } => self.end(number, turn, any),
            Way::Same { crossing } => self.state.borrow_mut().end_like(number, crossing, any),
        };
        self.state.borrow_mut().crossings[number].end = Some((any.to_vec(), leaving.clone()));
        leaving
    }
}

impl<'g> State<'g> {
    /// Begins a crossing: its number, and the earlier one that it is taken to be with what that one's
    /// times begin with.
    fn cross(
        &mut self,
        part: (RepeatId, bool),
        first: &[Expr<'g>],
    ) -> (usize, Option<(usize, Vec<Expr<'g>>)>) {
        let number = self.crossings.len();
        if self.shown.len() == number {
            let changing = first.iter().map(|expr| expr.known().is_none()).collect();
            self.shown.push(Shown { changing, others: 0 });
        }
        self.open.push(number);
        let begins_so = |crossing: &Crossing<'g>| {
            let is_own = matches!(crossing.way, Way::Own { .. }) && crossing.end.is_some();
            is_own && (crossing.repeat, crossing.inwards) == part && same(&crossing.first, first)
        };
        let earlier = self.crossings.iter().enumerate().filter(|(_, crossing)| begins_so(crossing));
        let mut chosen = earlier.map(|(earlier, crossing)| (earlier, crossing.entering.clone()));
        (number, chosen.nth(self.shown[number].others))
    }

    /// Ends a crossing that was taken to be an earlier one: what the last time leaves.
    fn end_like(&mut self, number: usize, earlier: usize, any: &[Expr<'g>]) -> Vec<Expr<'g>> {
        match &self.crossings[earlier].end {
            Some((next, leaving)) if same(next, any) => return leaving.clone(),
            // Where something before was wrong this need not be.
            _ if !self.consistent => {}
            _ => {
                self.shown[number].others += 1;
                self.standing = Some(number + 1);
            }
        }
        self.consistent = false;
        any.to_vec()
    }
}

/// Whether two sweeps carry the same.
fn same(one: &[Expr], other: &[Expr]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.is(other))
}

impl fmt::Debug for Loom<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("Loom").field("base", &self.base).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::Loom;
    use crate::equations::Weave;
    use crate::expr::{Expr, Graph, Stage};
    use crate::ids::RepeatId;
    use crate::math::Scalar;

    #[test]
    fn sweeps_that_carry_the_same_are_one_loop_and_others_are_not() {
        let graph = Graph::default();
        let own = graph.symbol(0, Stage::State);
        let (left, turns) = Loom::new(&graph, 1).run(|loom| {
            let enter = || loom.enter(RepeatId(0), false, &[Expr::number(0.0)])[0];
            let leave = |any| loom.leave(RepeatId(0), &[any])[0];
            let sum = || leave(enter() + own);
            let difference = || leave(own - enter());
            let kept = || leave(enter());
            [sum(), kept(), difference(), sum(), difference(), kept()]
        });
        let [sum, kept, difference, sum_again, difference_again, kept_again] = left;
        assert!(sum.is(&sum_again) && difference.is(&difference_again) && !sum.is(&difference));
        assert_eq!([kept, kept_again].map(Expr::known), [Some(0.0); 2]);
        let carries: Vec<_> = turns.iter().flat_map(|turn| &turn.carries).collect();
        let [of_sum, of_difference] = carries[..] else { panic!("{carries:?}") };
        let unknown = |number| graph.symbol(number, Stage::State);
        assert!(of_sum.next.is(&(unknown(of_sum.entering) + own)));
        assert!(of_difference.next.is(&(own - unknown(of_difference.entering))));
        assert!(unknown(of_sum.leaving).is(&sum) && unknown(of_difference.leaving).is(&difference));
    }

    #[test]
    fn other_parts_other_ways_and_other_beginnings_are_other_loops() {
        let graph = Graph::default();
        let own = graph.symbol(0, Stage::State);
        let (_, turns) = Loom::new(&graph, 1).run(|loom| {
            for (part, inwards, first) in
                [(0, false, 0.0), (1, false, 0.0), (0, true, 0.0), (0, false, 1.0)]
            {
                let entering = loom.enter(RepeatId(part), inwards, &[Expr::number(first)])[0];
                loom.leave(RepeatId(part), &[entering * own + own]);
            }
        });
        assert_eq!(turns.len(), 4);
    }
}
