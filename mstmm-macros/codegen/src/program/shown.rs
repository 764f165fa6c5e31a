//! Which unknowns and results need not be looked at, because other results show what is wrong with them.

use super::{Name, Operand, Operation, Program, Section, Statement};
use std::collections::HashSet;

/// What need not be looked at, and what has to be, to find whether anything is infinite or undefined.
#[derive(Debug, Default)]
pub struct Shown<'a> {
    /// Unknowns that leave a result infinite or undefined whenever they are so themselves. Those of a repeated
    /// part do so in results of the same time.
    pub unknowns: HashSet<u32>,
    /// Results that are not all finite if any of them is not: what is computed from a result shows it. They come
    /// in the order in which they are known; results of repeated parts are left out.
    pub telling: Vec<&'a Operand>,
    /// Which values hand on to a result, by number.
    values: Vec<Value<'a>>,
}

/// What is known of a value.
#[derive(Clone, Copy, Debug)]
enum Value<'a> {
    /// Nothing so far.
    Other,
    /// It is this result, and no other shows it so far.
    Result(&'a Operand),
    /// A result shows it.
    Shown,
}

impl Program {
    /// What results of group `group` show.
    ///
    /// Sums, products, roots, sines and cosines hand on what is not finite (IEEE 754: 0 · ∞ and ∞ − ∞ are
    /// undefined, and so is what is computed from that). Not so reciprocals, for 1/∞ is zero, angles of
    /// points, and signs. What loops carry is not followed: it may end with the last time.
    pub fn shown(&self, group: usize) -> Shown<'_> {
        let results = &self.outputs[group];
        let values = vec![Value::Other; self.names.count()];
        let mut shown = Shown { values, ..Shown::default() };
        for result in results {
            if let Some(name) = result.name() {
                shown.values[name.index()] = Value::Result(result);
            }
        }
        let of_loops = self.loops().flat_map(|turn| &turn.outputs);
        let of_loops = of_loops.filter(|output| output.0 == group).map(|(_, _, result)| result);
        of_loops.for_each(|result| shown.add(result));
        self.backwards().for_each(|statement| shown.follow(statement));
        // What no statement computes: unknowns, and what is known since setup.
        let others = results.iter().filter(|result| shown.lacks(result)).collect::<Vec<_>>();
        others.iter().for_each(|result| shown.add(result));
        shown.telling.extend(others);
        shown.telling.reverse();
        shown
    }

    /// All statements from the last: before those that they read.
    fn backwards(&self) -> impl Iterator<Item = &Statement> {
        let sections: Vec<&Section> = self.sections().collect();
        sections.into_iter().rev().flat_map(|section| section.statements.iter().rev())
    }
}

impl<'a> Shown<'a> {
    /// What a statement makes of it: what it hands on.
    fn follow(&mut self, statement: &'a Statement) {
        match statement {
            Statement::Let(name, operation) => {
                if self.meets(*name) {
                    handed_on(operation).into_iter().flatten().for_each(|from| self.add(from));
                }
            }
            Statement::SinCos { sines, cosines, angles } => {
                let named = sines.iter().zip(angles).chain(cosines.iter().zip(angles));
                for (name, angle) in named {
                    if name.is_some_and(|name| self.meets(name)) {
                        self.add(angle);
                    }
                }
            }
        }
    }

    /// Whether the value that is computed here is among it. If it is a result that nothing shows, it is telling.
    fn meets(&mut self, name: Name) -> bool {
        let value = &mut self.values[name.index()];
        if let Value::Result(result) = *value {
            self.telling.push(result);
            *value = Value::Shown;
        }
        matches!(value, Value::Shown)
    }

    fn add(&mut self, operand: &'a Operand) {
        match operand {
            Operand::Symbol(number) => _ = self.unknowns.insert(*number),
            Operand::Named(name) => self.values[name.index()] = Value::Shown,
            Operand::Minus(operand) => self.add(operand),
            Operand::Number(_) | Operand::Repeated => (),
        }
    }

    /// Whether an operand that may be infinite is not among it.
    fn lacks(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Symbol(number) => !self.unknowns.contains(number),
            Operand::Named(name) => matches!(self.values[name.index()], Value::Result(_)),
            Operand::Minus(operand) => self.lacks(operand),
            Operand::Number(_) | Operand::Repeated => false,
        }
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
    use crate::program::{Block, Names};

    #[test]
    fn what_others_show_is_not_telling() {
        let mut names = Names::default();
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|name| names.add(name.into()));
        let statement = Statement::Let;
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let [read_a, read_b, read_c] = [a, b, c].map(Operand::Named);
        let minus_y = Operand::Minus(Box::new(y.clone()));
        let statements = vec![
            statement(a, Operation::Sum(x.clone(), y)),
            statement(b, Operation::Recip(read_a.clone())),
            statement(c, Operation::Product(read_a.clone(), minus_y)),
            statement(d, Operation::Difference(read_c.clone(), read_a.clone())),
        ];
        let section = Section { statements, ..Section::default() };
        let minus_d = Operand::Minus(Box::new(Operand::Named(d)));
        let known = Operand::Number(1.0);
        let all =
            vec![minus_d.clone(), read_c, read_b.clone(), read_a, Operand::Symbol(2), x, known];
        let program = Program {
            names,
            symbols: vec![0, 1, 2],
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])],
            outputs: vec![all],
        };
        // `d` shows `c`, `a`, and the first two unknowns; `b` may be zero where `a` is infinite.
        let shown = program.shown(0);
        assert_eq!(shown.telling, [&Operand::Symbol(2), &read_b, &minus_d]);
        assert_eq!(shown.unknowns, HashSet::from([0, 1, 2]));
    }
}
