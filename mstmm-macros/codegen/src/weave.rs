//! Repeated parts as loops: what sweeps carry over the seams, as unknowns.
//!
//! Every sweep over a repeated part is a loop. What it carries is found by running the equations:
//! at first everything that is known where a loop begins is taken to be the same every time. Where
//! that turns out wrong the number becomes an unknown, and the equations are run again.

use crate::equations::Weave;
use crate::expr::{Expr, Graph, Stage};
use std::cell::RefCell;
use std::fmt;

/// A loop over a repeated part.
#[derive(Clone, Debug)]
pub struct Turn<'g> {
    /// Which part.
    pub repeat: usize,
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
    /// For every loop in the order of its beginning, which numbers change from time to time.
    changing: Vec<Vec<bool>>,
    turns: Vec<Turn<'g>>,
    /// All that was carried into each loop, known numbers as well.
    first: Vec<Vec<Expr<'g>>>,
    /// The loops begun and not ended.
    open: Vec<usize>,
    used: u32,
    consistent: bool,
}

impl<'g> Loom<'g> {
    /// A loom whose unknowns are numbered from `base` on.
    pub fn new(graph: &'g Graph, base: u32) -> Self {
        Loom { graph, base, state: RefCell::default() }
    }

    /// Runs `equations` until what is carried is consistent; the loops and the result.
    pub fn run<R>(&self, equations: impl Fn(&Self) -> R) -> (R, Vec<Turn<'g>>) {
        loop {
            let changing = std::mem::take(&mut self.state.borrow_mut().changing);
            *self.state.borrow_mut() = State { changing, consistent: true, ..State::default() };
            let result = equations(self);
            let mut state = self.state.borrow_mut();
            if state.consistent {
                return (result, std::mem::take(&mut state.turns));
            }
        }
    }
}

impl<'g> Weave<Expr<'g>> for Loom<'g> {
    fn enter(&self, repeat: usize, inwards: bool, first: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let state = &mut *self.state.borrow_mut();
        let number = state.turns.len();
        if state.changing.len() == number {
            state.changing.push(first.iter().map(|expr| expr.known().is_none()).collect());
        }
        let mut carries = Vec::new();
        let mut entering = Vec::new();
        for (&first, changes) in first.iter().zip(&mut state.changing[number]) {
            // What is known now may not have been in an earlier run.
            *changes |= first.known().is_none();
            if !*changes {
                entering.push(first);
                continue;
            }
            let own = self.base + state.used;
            state.used += 2;
            entering.push(self.graph.symbol(own, Stage::State));
            carries.push(Carry { first, next: first, entering: own, leaving: own + 1 });
        }
        state.turns.push(Turn { repeat, inwards, carries });
        state.first.push(first.to_vec());
        state.open.push(number);
        entering
    }

    fn leave(&self, _: usize, any: &[Expr<'g>]) -> Vec<Expr<'g>> {
        let state = &mut *self.state.borrow_mut();
        // Every sweep that leaves has entered.
        let Some(number) = state.open.pop() else { return any.to_vec() };
        let mut carries = state.turns[number].carries.iter_mut();
        let mut leaving = Vec::new();
        let firsts = state.first[number].iter();
        for ((&next, &first), changes) in any.iter().zip(firsts).zip(&mut state.changing[number]) {
            if !*changes {
                if next.known() != first.known() {
                    *changes = true;
                    state.consistent = false;
                }
                leaving.push(first);
                continue;
            }
            let Some(carry) = carries.next() else { return any.to_vec() };
            carry.next = next;
            leaving.push(self.graph.symbol(carry.leaving, Stage::State));
        }
        leaving
    }
}

impl fmt::Debug for Loom<'_> {
    fn fmt(&self, out: &mut fmt::Formatter) -> fmt::Result {
        out.debug_struct("Loom").field("base", &self.base).finish_non_exhaustive()
    }
}
