//! Which unknowns and results need not be looked at, because other results show what is wrong with them.

use super::{Operand, Operation, Program, Section, Statement, ValueId};
use crate::ids::SymbolId;
use std::collections::HashSet;
use std::ops::Range;

/// What need not be looked at, and what has to be, to find whether anything is infinite or undefined.
#[derive(Debug, Default)]
pub struct Finiteness<'a> {
    /// Unknowns that leave a result infinite or undefined whenever they are so themselves. Those of a repeated
    /// part do so in results of the same repetition.
    pub unknowns: HashSet<SymbolId>,
    /// Results that are not all finite if any of them is not: what is computed from a result shows it. They come
    /// in the order in which they are known; results of repeated parts are left out.
    pub witnesses: Vec<&'a Operand>,
    /// Which values hand on to a result, by number.
    values: Vec<Status<'a>>,
}

/// What is known of a value.
#[derive(Clone, Copy, Debug)]
enum Status<'a> {
    /// Nothing so far.
    Other,
    /// It is this result, and no other shows it so far.
    Result(&'a Operand),
    /// A result shows it.
    Covered,
}

impl Program {
    /// What the results of these numbers show.
    ///
    /// Sums, products, roots, sines and cosines hand on what is not finite (IEEE 754: 0 · ∞ and ∞ − ∞ are
    /// undefined, and so is what is computed from that). Not so reciprocals, for 1/∞ is zero, angles of
    /// points, and signs. What loops carry is not followed: it may end with the last repetition.
    pub fn finiteness(&self, numbers: Range<usize>) -> Finiteness<'_> {
        let results: Vec<&Operand> = self.results[numbers.clone()].iter().flatten().collect();
        let values = vec![Status::Other; self.names.count()];
        let mut shown = Finiteness { values, ..Finiteness::default() };
        for result in &results {
            if let Some(value) = result.value() {
                shown.values[value.index()] = Status::Result(result);
            }
        }
        let of_loops = self.loops().flat_map(|one| &one.results);
        let of_loops = of_loops.filter(|(number, _)| numbers.contains(number));
        of_loops.for_each(|(_, result)| shown.add(result));
        self.backwards().for_each(|statement| shown.follow(statement));
        // What no statement computes: unknowns, and what is known since setup.
        let others: Vec<&Operand> = results.into_iter().filter(|it| shown.lacks(it)).collect();
        others.iter().for_each(|result| shown.add(result));
        shown.witnesses.extend(others);
        shown.witnesses.reverse();
        let once = self.unknowns.iter();
        let all = once.chain(self.loops().flat_map(|one| &one.unknowns));
        let is_shown = |value: ValueId| matches!(shown.values[value.index()], Status::Covered);
        let unknowns = all.filter(|(_, value)| is_shown(*value)).map(|&(number, _)| number);
        shown.unknowns = unknowns.collect();
        shown
    }

    /// All statements from the last: before those that they read.
    fn backwards(&self) -> impl Iterator<Item = &Statement> {
        let sections: Vec<&Section> = self.sections().collect();
        sections.into_iter().rev().flat_map(|section| section.statements.iter().rev())
    }
}

impl<'a> Finiteness<'a> {
    /// What a statement makes of it: what it hands on.
    fn follow(&mut self, statement: &'a Statement) {
        match statement {
            Statement::Let(value, operation) => {
                if self.meets(*value) {
                    handed_on(operation).into_iter().flatten().for_each(|from| self.add(from));
                }
            }
            Statement::SinCos { sines, cosines, angles } => {
                let named = sines.iter().zip(angles).chain(cosines.iter().zip(angles));
                for (value, angle) in named {
                    if value.is_some_and(|value| self.meets(value)) {
                        self.add(angle);
                    }
                }
            }
        }
    }

    /// Whether the value that is computed here is among it. If it is a result that nothing shows, it is a
    /// witness.
    fn meets(&mut self, value: ValueId) -> bool {
        let status = &mut self.values[value.index()];
        if let Status::Result(result) = *status {
            self.witnesses.push(result);
            *status = Status::Covered;
        }
        matches!(status, Status::Covered)
    }

    fn add(&mut self, operand: &Operand) {
        if let Some(value) = operand.value() {
            self.values[value.index()] = Status::Covered;
        }
    }

    /// Whether an operand that may be infinite is not among it.
    fn lacks(&self, operand: &Operand) -> bool {
        let status = operand.value().map(|value| self.values[value.index()]);
        matches!(status, Some(Status::Result(_)))
    }
}

/// What an operation does not hide.
fn handed_on(operation: &Operation) -> [Option<&Operand>; 3] {
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
    fn what_others_show_is_not_telling() {
        let mut names = ValueNames::default();
        let [a, b, c, d, x, y, z] =
            ["a", "b", "c", "d", "x", "y", "z"].map(|name| names.add(name.into()));
        let statement = Statement::Let;
        let [read_a, read_b, read_c, read_x, read_y, read_z] =
            [a, b, c, x, y, z].map(Operand::Value);
        let minus_y = Operand::Minus(Box::new(read_y.clone()));
        let statements = vec![
            statement(a, Operation::Sum(read_x.clone(), read_y)),
            statement(b, Operation::Recip(read_a.clone())),
            statement(c, Operation::Product(read_a.clone(), minus_y)),
            statement(d, Operation::Difference(read_c.clone(), read_a.clone())),
        ];
        let section = Section { statements, ..Section::default() };
        let minus_d = Operand::Minus(Box::new(Operand::Value(d)));
        let known = Operand::Number(1.0);
        let all =
            vec![minus_d.clone(), read_c, read_b.clone(), read_a, read_z.clone(), read_x, known];
        let program = Program {
            names,
            unknowns: [x, y, z].into_iter().enumerate().map(|(k, it)| (SymbolId(k), it)).collect(),
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])].into(),
            results: all.into_iter().map(Some).collect(),
            pivots: Vec::new(),
        };
        // `d` shows `c`, `a`, and the first two unknowns; `b` may be zero where `a` is infinite.
        let shown = program.finiteness(0..7);
        assert_eq!(shown.witnesses, [&read_z, &read_b, &minus_d]);
        assert_eq!(shown.unknowns, HashSet::from([0, 1, 2].map(SymbolId)));
    }
}
