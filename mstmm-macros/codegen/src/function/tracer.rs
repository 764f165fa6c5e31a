//! Traces sweeps over repeated parts as loops.
//!
//! The tracer finds the loop-carried values by running the equations. In the first run every number that is known at the
//! start of a loop is assumed to be the same in every repetition. If a repetition ends with another value, the number
//! becomes an unknown of the loop (a phi), and the equations run again, until a fixpoint is reached.
//!
//! Sweeps that carry the same values share one loop: a sweep that starts like an earlier one is assumed to be the same
//! loop and gets its unknowns, until it ends with other values.

use super::{Carry, Loop};
use crate::equations::{Channel, LoopHook};
use crate::expr::{Expr, Graph, Stage};
use crate::ids::{RepeatId, SymbolId};
use std::cell::RefCell;
use std::fmt;

/// Runs equations until their loop-carried values are consistent.
pub struct LoopTracer<'g> {
    graph: &'g Graph,
    /// The first symbol that is free for loop-carried values.
    base: usize,
    run: RefCell<Run<'g>>,
}

/// The state of one run of the equations.
#[derive(Default)]
struct Run<'g> {
    /// What earlier runs have found about the visits to repeated parts, in the order in which they start.
    learned: Vec<Learned>,
    /// The number of these findings that are still valid: later visits followed from a wrong assumption.
    valid: Option<usize>,
    visits: Vec<Visit<'g>>,
    /// The visits that have started and not ended.
    open: Vec<usize>,
    loops: Vec<Loop>,
    /// The number of symbols in use.
    used: usize,
    consistent: bool,
}

/// What earlier runs have found about a visit.
struct Learned {
    /// Which values change from repetition to repetition.
    changing: Vec<bool>,
    /// The number of earlier loops that start like it and end with other values.
    rejected: usize,
}

/// A sweep over a repeated part, with the values of one channel.
struct Visit<'g> {
    channel: Channel,
    inward: bool,
    /// The values before the first repetition, including known numbers.
    init: Vec<Expr<'g>>,
    /// The values at the start of a repetition.
    phi: Vec<Expr<'g>>,
    /// Whether it is a new loop or reuses that of an earlier visit.
    kind: VisitKind,
    /// The values at the end of a repetition and those after the last one, once the visit has ended.
    end: Option<(Vec<Expr<'g>>, Vec<Expr<'g>>)>,
}

#[derive(Clone, Copy)]
enum VisitKind {
    /// A new loop by its index, or a further channel of one, whose values are carried from `first` on.
    New { index: usize, first: usize },
    /// The loop of an earlier visit.
    ReuseOf { visit: usize },
}

impl<'g> LoopTracer<'g> {
    /// Returns a tracer whose loop-carried values have the symbols from `base` on.
    pub fn new(graph: &'g Graph, base: usize) -> Self {
        LoopTracer { graph, base, run: RefCell::default() }
    }

    /// Runs `equations` until the loop-carried values are consistent; returns their result and the loops.
    pub fn trace<R>(&self, equations: impl Fn(&Self) -> R) -> (R, Vec<Loop>) {
        loop {
            let Run { mut learned, valid, .. } = self.run.take();
            learned.truncate(valid.unwrap_or(learned.len()));
            *self.run.borrow_mut() = Run { learned, consistent: true, ..Run::default() };
            let result = equations(self);
            let mut run = self.run.borrow_mut();
            if !run.open.is_empty() {
                bug!("a sweep has entered a repeated part and not left it")
            }
            if run.consistent {
                return (result, std::mem::take(&mut run.loops));
            }
        }
    }

    /// Returns the formula of a loop-carried value.
    fn unknown(&self, symbol: SymbolId) -> Expr<'g> {
        self.graph.symbol(symbol, Stage::State)
    }

    /// Starts a channel of a loop: returns its carries and the values at the start of a repetition.
    fn begin(&self, number: usize, init: &[Expr<'g>]) -> (Vec<Carry>, Vec<Expr<'g>>) {
        let Run { learned, used, .. } = &mut *self.run.borrow_mut();
        let mut carries = Vec::new();
        let enter = |(&init, changes): (&Expr<'g>, &mut bool)| {
            // A value that was known in an earlier run may be a formula in this one.
            *changes |= init.known().is_none();
            if !*changes {
                return init;
            }
            let [phi, exit] = [0, 1].map(|next| SymbolId(self.base + *used + next));
            *used += 2;
            let init = self.graph.edge(init);
            carries.push(Carry { init, next: init, phi, exit });
            self.unknown(phi)
        };
        let phi = init.iter().zip(&mut learned[number].changing).map(enter).collect();
        (carries, phi)
    }

    /// Ends a channel of a loop: returns the values after the last repetition.
    fn end(
        &self,
        visit: usize,
        (index, first): (usize, usize),
        next: &[Expr<'g>],
    ) -> Vec<Expr<'g>> {
        let Run { learned, visits, loops, consistent, .. } = &mut *self.run.borrow_mut();
        let mut carries = loops[index].carries.iter_mut().skip(first);
        let inits = visits[visit].init.iter();
        let leave = |((&next, &init), changes): ((&Expr<'g>, &Expr<'g>), &mut bool)| {
            if !*changes {
                if next.known() != init.known() {
                    (*changes, *consistent) = (true, false);
                }
                return init;
            }
            let Some(carry) = carries.next() else {
                bug!("a loop ends with more values than it started with")
            };
            carry.next = self.graph.edge(next);
            self.unknown(carry.exit)
        };
        next.iter().zip(inits).zip(&mut learned[visit].changing).map(leave).collect()
    }
}

impl<'g> LoopHook<Expr<'g>> for LoopTracer<'g> {
    fn enter(&self, channel: Channel, inward: bool, init: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let (number, earlier) = self.run.borrow_mut().visit((channel, inward), init);
        let (kind, phi) = match earlier {
            Some((visit, phi)) => (VisitKind::ReuseOf { visit }, phi),
            None => {
                let (carries, phi) = self.begin(number, init);
                (self.run.borrow_mut().add_carries((channel.0, inward), carries), phi)
            }
        };
        let (init, start) = (init.to_vec(), phi.clone());
        let visit = Visit { channel, inward, init, phi: start, kind, end: None };
        self.run.borrow_mut().visits.push(visit);
        phi
    }

    fn leave(&self, channel: Channel, next: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let (number, kind) = self.run.borrow_mut().close(channel);
        let exit = match kind {
            VisitKind::New { index, first } => self.end(number, (index, first), next),
            VisitKind::ReuseOf { visit } => self.run.borrow_mut().end_like(number, visit, next),
        };
        self.run.borrow_mut().visits[number].end = Some((next.to_vec(), exit.clone()));
        exit
    }
}

impl<'g> Run<'g> {
    /// Starts a visit: returns its index, and the earlier visit whose loop it reuses, with the values at the start of a
    /// repetition of that loop.
    fn visit(
        &mut self,
        part: (Channel, bool),
        init: &[Expr<'g>],
    ) -> (usize, Option<(usize, Vec<Expr<'g>>)>) {
        let number = self.visits.len();
        if self.learned.len() == number {
            let changing = init.iter().map(|expr| expr.known().is_none()).collect();
            self.learned.push(Learned { changing, rejected: 0 });
        }
        self.open.push(number);
        let starts_alike = |visit: &Visit<'g>| {
            let is_new = matches!(visit.kind, VisitKind::New { .. }) && visit.end.is_some();
            is_new && (visit.channel, visit.inward) == part && same(&visit.init, init)
        };
        let earlier = self.visits.iter().enumerate().filter(|(_, visit)| starts_alike(visit));
        let mut chosen = earlier.map(|(earlier, visit)| (earlier, visit.phi.clone()));
        (number, chosen.nth(self.learned[number].rejected))
    }

    /// Adds the values of a channel to the loop that the sweep is in, or to a new one.
    fn add_carries(
        &mut self,
        (repeat, inward): (RepeatId, bool),
        carries: Vec<Carry>,
    ) -> VisitKind {
        let open = self.open.iter().filter_map(|&number| self.visits.get(number));
        let mut same = open.filter(|visit| (visit.channel.0, visit.inward) == (repeat, inward));
        let index = same.find_map(|visit| match visit.kind {
            VisitKind::New { index, .. } => Some(index),
            VisitKind::ReuseOf { .. } => None,
        });
        let index = index.unwrap_or_else(|| {
            self.loops.push(Loop { repeat, inward, carries: Vec::new() });
            self.loops.len() - 1
        });
        let first = self.loops[index].carries.len();
        self.loops[index].carries.extend(carries);
        VisitKind::New { index, first }
    }

    /// Ends the open visit of a channel.
    fn close(&mut self, channel: Channel) -> (usize, VisitKind) {
        let is_it = |&number: &usize| self.visits[number].channel == channel;
        let Some(place) = self.open.iter().rposition(is_it) else {
            bug!("a sweep leaves a repeated part that it has not entered")
        };
        let number = self.open.remove(place);
        (number, self.visits[number].kind)
    }

    /// Ends a visit that reuses the loop of an earlier one: returns the values after the last repetition.
    fn end_like(&mut self, number: usize, earlier: usize, next: &[Expr<'g>]) -> Vec<Expr<'g>> {
        match &self.visits[earlier].end {
            Some((other, exit)) if same(other, next) => return exit.clone(),
            // If an earlier assumption was wrong, the difference may follow from it.
            _ if !self.consistent => {}
            _ => {
                self.learned[number].rejected += 1;
                self.valid = Some(number + 1);
            }
        }
        self.consistent = false;
        next.to_vec()
    }
}

/// Returns whether two lists of values are the same.
fn same(a: &[Expr], b: &[Expr]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.is(b))
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
    use crate::ids::{ChannelId, RepeatId, SymbolId};
    use crate::math::Scalar;

    const PART: (RepeatId, ChannelId) = (RepeatId(0), ChannelId(0));

    #[test]
    fn sweeps_with_the_same_carries_share_a_loop() {
        let graph = Graph::default();
        let own = graph.symbol(SymbolId(0), Stage::State);
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
        let carries: Vec<_> = loops.iter().flat_map(|loop_| &loop_.carries).collect();
        let [of_sum, of_difference] = carries[..] else { panic!("{carries:?}") };
        let unknown = |symbol| graph.symbol(symbol, Stage::State);
        assert_eq!(of_sum.next, graph.edge(unknown(of_sum.phi) + own));
        assert_eq!(of_difference.next, graph.edge(own - unknown(of_difference.phi)));
        assert!(unknown(of_sum.exit).is(&sum) && unknown(of_difference.exit).is(&difference));
    }

    #[test]
    fn other_parts_directions_and_initial_values_are_other_loops() {
        let graph = Graph::default();
        let own = graph.symbol(SymbolId(0), Stage::State);
        let (_, loops) = LoopTracer::new(&graph, 1).trace(|tracer| {
            for (part, inward, init) in
                [(0, false, 0.0), (1, false, 0.0), (0, true, 0.0), (0, false, 1.0)]
            {
                let part = (RepeatId(part), ChannelId(0));
                let phi = tracer.enter(part, inward, &[Expr::number(init)])[0];
                tracer.leave(part, &[phi * own + own]);
            }
        });
        assert_eq!(loops.len(), 4);
    }
}
