//! From formulas to programs: simplified, ordered, repeated parts as loops.

use super::{Reader, Scene};
use crate::equations::{Section, Trace};
use crate::expr::{Edge, Expr, Stage};
use crate::passes::{
    Carry, Heading, Setup, Turn, Unknowns, factor, issue, join, needed_carries, order, schedule,
};
use crate::program::Program;
use crate::weave::{self, Loom};

impl<'g> Scene<'_, 'g> {
    /// Simplifies and orders what leads to `outputs`.
    pub(super) fn program(
        &self,
        stage: Stage,
        trace: &Trace<Expr<'g>>,
        outputs: &[Vec<Expr<'g>>],
        turns: &[weave::Turn<'g>],
        setup: &mut Setup,
    ) -> Program {
        let edges: Vec<Vec<Edge>> = outputs
            .iter()
            .map(|group| group.iter().map(|&expr| self.graph.edge(expr)).collect())
            .collect();
        let results: Vec<Edge> = edges.iter().flatten().copied().collect();
        let turns: Vec<Turn> = turns.iter().map(|turn| self.turn(turn)).collect();
        let (turns, roots) = needed_carries(self.graph, &turns, &results);
        let turns = match self.reader {
            Reader::Person => turns,
            Reader::Processor => join(self.graph, &turns),
        };
        let (names, parts) = (self.symbols.names(), self.symbols.parts());
        let factored = factor(self.graph, &roots, &turns, parts);
        let turns = factored.turns(&turns);
        let ordered = (self.reader == Reader::Processor)
            .then(|| order(self.graph, &factored.edges(&roots), &turns, parts));
        let turns = ordered.as_ref().map_or_else(|| turns.clone(), |ordered| ordered.turns(&turns));
        let go = |edge: Edge| match &ordered {
            Some(ordered) => ordered.edge(factored.edge(edge)?),
            None => factored.edge(edge),
        };
        let outputs: Vec<Vec<Edge>> =
            edges.iter().map(|group| group.iter().filter_map(|&edge| go(edge)).collect()).collect();
        let headings: Vec<Heading> = trace.sections.iter().map(|one| heading(one, go)).collect();
        let unknowns = Unknowns { names, parts, turns: &turns };
        schedule(self.graph, &unknowns, stage, &headings, &outputs, setup)
    }

    /// A program in the order in which its statements should run.
    pub(super) fn issued(&self, program: Program) -> Program {
        match self.reader {
            Reader::Person => program,
            Reader::Processor => issue(program),
        }
    }

    /// A loop, with what it carries as edges.
    fn turn(&self, turn: &weave::Turn<'g>) -> Turn {
        let carry = |carry: &weave::Carry<'g>| Carry {
            first: self.graph.edge(carry.first),
            next: self.graph.edge(carry.next),
            entering: carry.entering,
            leaving: carry.leaving,
        };
        let carries = turn.carries.iter().map(carry).collect();
        Turn { repeat: turn.repeat, inwards: turn.inwards, carries }
    }

    /// Runs equations with repeated parts as loops.
    pub(super) fn woven<R>(
        &self,
        equations: impl Fn(&Loom<'g>, &mut Trace<Expr<'g>>) -> R,
    ) -> (R, Trace<Expr<'g>>, Vec<weave::Turn<'g>>) {
        let loom = Loom::new(self.graph, self.symbols.names().len() as u32);
        let run = |loom: &Loom<'g>| {
            let mut trace = Trace::new();
            let result = equations(loom, &mut trace);
            (result, trace)
        };
        let ((result, trace), turns) = loom.run(run);
        (result, trace, turns)
    }
}

/// A heading of a trace, over what has become of its values.
fn heading<'g>(section: &Section<Expr<'g>>, go: impl Fn(Edge) -> Option<Edge>) -> Heading {
    let formula = |(name, expr): &(String, Expr<'g>)| match expr {
        Expr::Formula(_, edge) => go(*edge).map(|edge| (name.clone(), edge)),
        Expr::Number(_) => None,
    };
    Heading {
        prefix: section.prefix.clone(),
        title: section.title.clone(),
        source: section.source.to_owned(),
        values: section.values.iter().filter_map(formula).collect(),
    }
}
