//! Sweeps over repeated parts, traced as loops.
//!
//! What a loop carries is found by running the equations: at first everything that is known where a loop
//! begins is taken to be the same in every repetition. Where that turns out wrong the number becomes an
//! unknown of the loop (a phi), and the equations are run again, until a fixpoint is reached.
//!
//! Sweeps that carry the same are one loop: one that begins like an earlier one is taken to be that one,
//! with its unknowns, until it turns out to hand on something else.

use super::{Carry, Loop};
use crate::equations::LoopHook;
use crate::expr::{Expr, Graph, Stage};
use crate::ids::RepeatId;
use std::cell::RefCell;
use std::fmt;

/// Runs equations until what their loops carry is consistent.
pub struct LoopTracer<'g> {
    graph: &'g Graph,
    /// The number of the first unknown of its own.
    base: u32,
    state: RefCell<State<'g>>,
}

#[derive(Default)]
struct State<'g> {
    /// What earlier runs have shown of the visits to repeated parts, in the order in which they begin.
    learned: Vec<Learned>,
    /// So much of that stands, the rest having gone on from what is wrong.
    standing: Option<usize>,
    visits: Vec<Visit<'g>>,
    /// The visits begun and not ended.
    open: Vec<usize>,
    loops: Vec<Loop>,
    used: u32,
    consistent: bool,
}

/// What is known of a visit before it is made.
struct Learned {
    /// Which numbers change from repetition to repetition.
    changing: Vec<bool>,
    /// So many earlier loops begin like it and hand on something else.
    rejected: usize,
}

/// A sweep over a repeated part.
struct Visit<'g> {
    repeat: RepeatId,
    inward: bool,
    /// All that is carried into the part, known numbers as well.
    init: Vec<Expr<'g>>,
    /// What any repetition begins with.
    phi: Vec<Expr<'g>>,
    /// Its loop, or the earlier visit that it is taken to be.
    way: Way,
    /// What any repetition ends with and what the last one leaves, once that is known.
    end: Option<(Vec<Expr<'g>>, Vec<Expr<'g>>)>,
}

#[derive(Clone, Copy)]
enum Way {
    New { number: usize },
    ReuseOf { visit: usize },
}

impl<'g> LoopTracer<'g> {
    /// A tracer whose unknowns are numbered from `base` on.
    pub fn new(graph: &'g Graph, base: usize) -> Self {
        LoopTracer { graph, base: base as u32, state: RefCell::default() }
    }

    /// Runs `equations` until what is carried is consistent; their result and the loops.
    pub fn trace<R>(&self, equations: impl Fn(&Self) -> R) -> (R, Vec<Loop>) {
        loop {
            let State { mut learned, standing, .. } = self.state.take();
            learned.truncate(standing.unwrap_or(learned.len()));
            *self.state.borrow_mut() = State { learned, consistent: true, ..State::default() };
            let result = equations(self);
            let mut state = self.state.borrow_mut();
            if !state.open.is_empty() {
                bug!("a sweep has not left a repeated part")
            }
            if state.consistent {
                return (result, std::mem::take(&mut state.loops));
            }
        }
    }

    /// An unknown of its own.
    fn unknown(&self, number: u32) -> Expr<'g> {
        self.graph.symbol(number, Stage::State)
    }

    /// Begins a loop: what it carries, and what any repetition begins with.
    fn begin(&self, number: usize, init: &[Expr<'g>]) -> (Vec<Carry>, Vec<Expr<'g>>) {
        let State { learned, used, .. } = &mut *self.state.borrow_mut();
        let mut carries = Vec::new();
        let enter = |(&init, changes): (&Expr<'g>, &mut bool)| {
            // What is known now may not have been in an earlier run.
            *changes |= init.known().is_none();
            if !*changes {
                return init;
            }
            let phi = self.base + *used;
            *used += 2;
            let init = self.graph.edge(init);
            carries.push(Carry { init, next: init, phi, exit: phi + 1 });
            self.unknown(phi)
        };
        let phi = init.iter().zip(&mut learned[number].changing).map(enter).collect();
        (carries, phi)
    }

    /// Ends a loop: what the last repetition leaves.
    fn end(&self, visit: usize, number: usize, next: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let State { learned, visits, loops, consistent, .. } = &mut *self.state.borrow_mut();
        let mut carries = loops[number].carries.iter_mut();
        let inits = visits[visit].init.iter();
        let leave = |((&next, &init), changes): ((&Expr<'g>, &Expr<'g>), &mut bool)| {
            if !*changes {
                if next.known() != init.known() {
                    (*changes, *consistent) = (true, false);
                }
                return init;
            }
            let Some(carry) = carries.next() else {
                bug!("a loop ends with more numbers than it began with")
            };
            carry.next = self.graph.edge(next);
            self.unknown(carry.exit)
        };
        next.iter().zip(inits).zip(&mut learned[visit].changing).map(leave).collect()
    }
}

impl<'g> LoopHook<Expr<'g>> for LoopTracer<'g> {
    fn enter(&self, repeat: RepeatId, inward: bool, init: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let (number, earlier) = self.state.borrow_mut().visit((repeat, inward), init);
        let (way, phi) = match earlier {
            Some((visit, phi)) => (Way::ReuseOf { visit }, phi),
            None => {
                let (carries, phi) = self.begin(number, init);
                let loops = &mut self.state.borrow_mut().loops;
                loops.push(Loop { repeat, inward, carries });
                (Way::New { number: loops.len() - 1 }, phi)
            }
        };
        let (init, begun) = (init.to_vec(), phi.clone());
        let visit = Visit { repeat, inward, init, phi: begun, way, end: None };
        self.state.borrow_mut().visits.push(visit);
        phi
    }

    fn leave(&self, repeat: RepeatId, next: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let Some(number) = self.state.borrow_mut().open.pop() else {
            bug!("a sweep leaves a repeated part that it has not entered")
        };
        let (own, way) = {
            let visit = &self.state.borrow().visits[number];
            (visit.repeat, visit.way)
        };
        if own != repeat {
            bug!("a sweep leaves another repeated part than it entered")
        }
        let exit = match way {
            Way::New { number: of } => self.end(number, of, next),
            Way::ReuseOf { visit } => self.state.borrow_mut().end_like(number, visit, next),
        };
        self.state.borrow_mut().visits[number].end = Some((next.to_vec(), exit.clone()));
        exit
    }
}

impl<'g> State<'g> {
    /// Begins a visit: its number, and the earlier one that it is taken to be with what a repetition of
    /// that one begins with.
    fn visit(
        &mut self,
        part: (RepeatId, bool),
        init: &[Expr<'g>],
    ) -> (usize, Option<(usize, Vec<Expr<'g>>)>) {
        let number = self.visits.len();
        if self.learned.len() == number {
            let changing = init.iter().map(|expr| expr.known().is_none()).collect();
            self.learned.push(Learned { changing, rejected: 0 });
        }
        self.open.push(number);
        let begins_so = |visit: &Visit<'g>| {
            let is_new = matches!(visit.way, Way::New { .. }) && visit.end.is_some();
            is_new && (visit.repeat, visit.inward) == part && same(&visit.init, init)
        };
        let earlier = self.visits.iter().enumerate().filter(|(_, visit)| begins_so(visit));
        let mut chosen = earlier.map(|(earlier, visit)| (earlier, visit.phi.clone()));
        (number, chosen.nth(self.learned[number].rejected))
    }

    /// Ends a visit that was taken to be an earlier one: what the last repetition leaves.
    fn end_like(&mut self, number: usize, earlier: usize, next: &[Expr<'g>]) -> Vec<Expr<'g>> {
        match &self.visits[earlier].end {
            Some((other, exit)) if same(other, next) => return exit.clone(),
            // Where something before was wrong this need not be.
            _ if !self.consistent => {}
            _ => {
                self.learned[number].rejected += 1;
                self.standing = Some(number + 1);
            }
        }
        self.consistent = false;
        next.to_vec()
    }
}

/// Whether two sweeps carry the same.
fn same(one: &[Expr], other: &[Expr]) -> bool {
    one.len() == other.len() && one.iter().zip(other).all(|(one, other)| one.is(other))
}

impl fmt::Debug for LoopTracer<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("LoopTracer").field("base", &self.base).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::LoopTracer;
    use crate::equations::LoopHook;
    use crate::expr::{Expr, Graph, Stage};
    use crate::ids::RepeatId;
    use crate::math::Scalar;

    const PART: RepeatId = RepeatId(0);

    #[test]
    fn sweeps_that_carry_the_same_are_one_loop_and_others_are_not() {
        let graph = Graph::default();
        let own = graph.symbol(0, Stage::State);
        let (left, loops) = LoopTracer::new(&graph, 1).trace(|tracer| {
            let enter = || tracer.enter(PART, false, &[Expr::number(0.0)])[0];
            let leave = |next| tracer.leave(PART, &[next])[0];
            let sum = || leave(enter() + own);
            let difference = || leave(own - enter());
            let kept = || leave(enter());
            [sum(), kept(), difference(), sum(), difference(), kept()]
        });
        let [sum, kept, difference, sum_again, difference_again, kept_again] = left;
        assert!(sum.is(&sum_again) && difference.is(&difference_again) && !sum.is(&difference));
        assert_eq!([kept, kept_again].map(Expr::known), [Some(0.0); 2]);
        let carries: Vec<_> = loops.iter().flat_map(|one| &one.carries).collect();
        let [of_sum, of_difference] = carries[..] else { panic!("{carries:?}") };
        let unknown = |number| graph.symbol(number, Stage::State);
        assert_eq!(of_sum.next, graph.edge(unknown(of_sum.phi) + own));
        assert_eq!(of_difference.next, graph.edge(own - unknown(of_difference.phi)));
        assert!(unknown(of_sum.exit).is(&sum) && unknown(of_difference.exit).is(&difference));
    }

    #[test]
    fn other_parts_other_ways_and_other_beginnings_are_other_loops() {
        let graph = Graph::default();
        let own = graph.symbol(0, Stage::State);
        let (_, loops) = LoopTracer::new(&graph, 1).trace(|tracer| {
            for (part, inward, init) in
                [(0, false, 0.0), (1, false, 0.0), (0, true, 0.0), (0, false, 1.0)]
            {
                let phi = tracer.enter(RepeatId(part), inward, &[Expr::number(init)])[0];
                tracer.leave(RepeatId(part), &[phi * own + own]);
            }
        });
        assert_eq!(loops.len(), 4);
    }
}
