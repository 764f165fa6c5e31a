//! Finds a small set of results whose finiteness implies that all results and most unknowns are finite.
//!
//! A result *covers* a value if the result is not finite whenever the value is not finite.

use super::{Operand, Operation, Program, Section, Statement, ValueId};
use crate::ids::SymbolId;
use std::collections::HashSet;
use std::ops::Range;

/// Which values must be tested to find whether anything is infinite or undefined.
#[derive(Debug, Default)]
pub struct Finiteness<'a> {
    /// The unknowns that a result covers. An unknown of a repeated part is covered by results of the same repetition.
    pub covered: HashSet<SymbolId>,
    /// The results that no other result covers, in the order in which they are computed. Results of repeated parts are
    /// not among them.
    pub witnesses: Vec<&'a Operand>,
    /// The status of each value.
    values: Vec<Status<'a>>,
}

/// Whether the results cover a value.
#[derive(Clone, Copy, Debug)]
enum Status<'a> {
    /// No result covers it.
    Uncovered,
    /// It is this result, which no other result covers.
    Result(&'a Operand),
    /// A result covers it.
    Covered,
}

impl Program {
    /// Finds which values the results in ranges of indices cover.
    ///
    /// Sums, products, roots, sines and cosines propagate values that are not finite (IEEE 754: 0 · ∞ and ∞ − ∞ are
    /// undefined, and so are all results of undefined operands). Reciprocals do not, since 1/∞ is zero, nor do
    /// arctangents and the sign of `copysign`. Loop-carried values are not followed, since the chain of repetitions may
    /// end with the last one.
    pub fn finiteness(&self, ranges: &[Range<usize>]) -> Finiteness<'_> {
        let results = ranges.iter().flat_map(|range| self.results[range.clone()].iter().flatten());
        let results: Vec<&Operand> = results.collect();
        let values = vec![Status::Uncovered; self.names.count()];
        let mut finiteness = Finiteness { values, ..Finiteness::default() };
        for result in &results {
            if let Some(value) = result.value() {
                finiteness.values[value.index()] = Status::Result(result);
            }
        }
        let of_loops = self.loops().flat_map(|block| &block.results);
        let is_tested = |index: &usize| ranges.iter().any(|range| range.contains(index));
        let of_loops = of_loops.filter(|(index, _)| is_tested(index));
        of_loops.for_each(|(_, result)| finiteness.cover(result));
        self.backwards().for_each(|statement| finiteness.follow(statement));
        // Results that no statement computes: unknowns and slots.
        let uncovered = |result: &&Operand| finiteness.is_uncovered_result(result);
        let others: Vec<&Operand> = results.into_iter().filter(uncovered).collect();
        others.iter().for_each(|result| finiteness.cover(result));
        finiteness.witnesses.extend(others);
        finiteness.witnesses.reverse();
        let unknowns = self.unknowns.iter();
        let unknowns = unknowns.chain(self.loops().flat_map(|block| &block.unknowns));
        let covered = unknowns.filter(|(_, value)| finiteness.is_covered(*value));
        finiteness.covered = covered.map(|&(symbol, _)| symbol).collect();
        finiteness
    }

    /// Iterates over all statements from the last to the first, so that users come before their operands.
    fn backwards(&self) -> impl Iterator<Item = &Statement> {
        let sections: Vec<&Section> = self.sections().collect();
        sections.into_iter().rev().flat_map(|section| section.statements.iter().rev())
    }
}

impl<'a> Finiteness<'a> {
    /// Covers the operands of a statement whose value is covered or a result.
    fn follow(&mut self, statement: &'a Statement) {
        match statement {
            Statement::Let(value, operation) => {
                if self.reaches(*value) {
                    propagating(operation).into_iter().flatten().for_each(|it| self.cover(it));
                }
            }
            Statement::SinCos { sines, cosines, angles } => {
                let pairs = sines.iter().zip(angles).chain(cosines.iter().zip(angles));
                for (value, angle) in pairs {
                    if value.is_some_and(|value| self.reaches(value)) {
                        self.cover(angle);
                    }
                }
            }
            Statement::Pack { .. } | Statement::Lane { .. } => bug!("a program has no packs"),
        }
    }

    /// Returns whether a value is covered. A result that no other result covers becomes a witness and covers itself.
    fn reaches(&mut self, value: ValueId) -> bool {
        let status = &mut self.values[value.index()];
        if let Status::Result(result) = *status {
            self.witnesses.push(result);
            *status = Status::Covered;
        }
        self.is_covered(value)
    }

    fn cover(&mut self, operand: &Operand) {
        if let Some(value) = operand.value() {
            self.values[value.index()] = Status::Covered;
        }
    }

    fn is_covered(&self, value: ValueId) -> bool {
        matches!(self.values[value.index()], Status::Covered)
    }

    fn is_uncovered_result(&self, operand: &Operand) -> bool {
        let status = operand.value().map(|value| self.values[value.index()]);
        matches!(status, Some(Status::Result(_)))
    }
}

/// Returns the operands whose infinite or undefined values an operation propagates.
fn propagating(operation: &Operation) -> [Option<&Operand>; 3] {
    match operation {
        Operation::CopySign(a, _) => [Some(a), None, None],
        Operation::Recip(_) | Operation::RecipAbove(..) | Operation::Atan2(..) => [None; 3],
        Operation::Sum(..)
        | Operation::Difference(..)
        | Operation::Product(..)
        | Operation::MulAdd(..)
        | Operation::MulSub(..)
        | Operation::MulNegAdd(..)
        | Operation::Sqrt(_) => operation.operands(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::{Block, ValueNames};

    #[test]
    fn results_that_others_cover_are_no_witnesses() {
        let mut names = ValueNames::default();
        let [a, b, c, d, x, y, z] =
            ["a", "b", "c", "d", "x", "y", "z"].map(|name| names.add(name.into()));
        let statement = Statement::Let;
        let [read_a, read_b, read_c, read_x, read_y, read_z] =
            [a, b, c, x, y, z].map(Operand::Value);
        let minus_y = Operand::Minus(y);
        let statements = vec![
            statement(a, Operation::Sum(read_x, read_y)),
            statement(b, Operation::Recip(read_a)),
            statement(c, Operation::Product(read_a, minus_y)),
            statement(d, Operation::Difference(read_c, read_a)),
        ];
        let section = Section { statements, ..Section::default() };
        let minus_d = Operand::Minus(d);
        let known = Operand::Number(1.0);
        let all = vec![minus_d, read_c, read_b, read_a, read_z, read_x, known];
        let program = Program {
            names,
            unknowns: [x, y, z].into_iter().enumerate().map(|(k, it)| (SymbolId(k), it)).collect(),
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])].into(),
            results: all.into_iter().map(Some).collect(),
            pivots: Vec::new(),
        };
        // `d` covers `c`, `a`, and the first two unknowns; `b` may be zero if `a` is infinite.
        let finiteness = program.finiteness(&[0..4, 4..7]);
        assert_eq!(finiteness.witnesses, [&read_z, &read_b, &minus_d]);
        assert_eq!(finiteness.covered, HashSet::from([0, 1, 2].map(SymbolId)));
    }
}
