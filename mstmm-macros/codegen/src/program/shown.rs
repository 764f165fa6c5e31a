//! Which unknowns need not be looked at, because results show what is wrong with them.

use super::{Operand, Operation, Program, Section, Statement};
use std::collections::HashSet;

impl Program {
    /// Unknowns that leave a result of group `group` infinite or undefined whenever they are so
    /// themselves. Those of a repeated part do so in results of the same time.
    ///
    /// Sums, products, roots, sines and cosines hand on what is not finite (IEEE 754: 0 · ∞ and ∞ − ∞ are
    /// undefined, and so is what is computed from that). Not so reciprocals, for 1/∞ is zero, angles of
    /// points, and signs. What loops carry is not followed: it may end with the last time.
    pub fn shown(&self, group: usize) -> HashSet<u32> {
        let mut shown = Shown::default();
        let of_loops = self.loops().flat_map(|turn| &turn.outputs);
        let of_loops = of_loops.filter(|output| output.0 == group).map(|(_, _, result)| result);
        self.outputs[group].iter().chain(of_loops).for_each(|result| shown.add(result));
        self.backwards().for_each(|statement| shown.follow(statement));
        shown.symbols
    }

    /// Results of group `group` that are not all finite if any of the group is not: what is computed from
    /// a result shows it. They come in the order in which they are known; results of repeated parts are left
    /// out.
    pub fn telling(&self, group: usize) -> Vec<&Operand> {
        let results: Vec<&Operand> =
            self.outputs[group].iter().filter(|result| result.name().is_some()).collect();
        let (mut shown, mut telling) = (Shown::default(), Vec::new());
        for statement in self.backwards() {
            for name in statement.names() {
                let result = results.iter().find(|result| result.name() == Some(name));
                if let Some(result) = result.filter(|_| !shown.names.contains(name)) {
                    telling.push(*result);
                    shown.add(result);
                }
            }
            shown.follow(statement);
        }
        // What no statement computes: unknowns, and what is known since setup.
        let others = self.outputs[group].iter().filter(|&result| shown.lacks(result));
        telling.extend(others);
        telling.reverse();
        telling
    }

    /// All statements from the last: before those that they read.
    fn backwards(&self) -> impl Iterator<Item = &Statement> {
        let sections: Vec<&Section> = self.sections().collect();
        sections.into_iter().rev().flat_map(|section| section.statements.iter().rev())
    }
}

/// What leaves a result infinite or undefined.
#[derive(Default)]
struct Shown<'a> {
    names: HashSet<&'a str>,
    symbols: HashSet<u32>,
}

impl<'a> Shown<'a> {
    /// What a statement makes of it: what it hands on.
    fn follow(&mut self, statement: &'a Statement) {
        match statement {
            Statement::Let(name, operation) if self.names.contains(name.as_str()) => {
                handed_on(operation).into_iter().flatten().for_each(|from| self.add(from));
            }
            Statement::Let(..) => (),
            Statement::SinCos { sines, cosines, angles } => {
                let named = sines.iter().zip(angles).chain(cosines.iter().zip(angles));
                for (name, angle) in named {
                    if name.as_deref().is_some_and(|name| self.names.contains(name)) {
                        self.add(angle);
                    }
                }
            }
        }
    }

    /// Whether an operand that may be infinite is not among it.
    fn lacks(&self, operand: &Operand) -> bool {
        match operand {
            Operand::Symbol(number) => !self.symbols.contains(number),
            Operand::Named(name) => !self.names.contains(name.as_str()),
            Operand::Minus(operand) => self.lacks(operand),
            Operand::Number(_) | Operand::Repeated => false,
        }
    }

    fn add(&mut self, operand: &'a Operand) {
        match operand {
            Operand::Symbol(number) => _ = self.symbols.insert(*number),
            Operand::Named(name) => _ = self.names.insert(name),
            Operand::Minus(operand) => self.add(operand),
            Operand::Number(_) | Operand::Repeated => (),
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
    use crate::program::Block;

    fn named(name: &str) -> Operand {
        Operand::Named(name.into())
    }

    #[test]
    fn what_others_show_is_not_telling() {
        let statement = |name: &str, operation| Statement::Let(name.into(), operation);
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let statements = vec![
            statement("a", Operation::Sum(x.clone(), y.clone())),
            statement("b", Operation::Recip(named("a"))),
            statement("c", Operation::Product(named("a"), Operand::Minus(Box::new(y)))),
            statement("d", Operation::Difference(named("c"), named("a"))),
        ];
        let section = Section { title: String::new(), source: String::new(), statements };
        let [a, b, c] = ["a", "b", "c"].map(named);
        let d = Operand::Minus(Box::new(named("d")));
        let all = vec![d.clone(), c, b.clone(), a, Operand::Symbol(2), x, Operand::Number(1.0)];
        let program = Program {
            symbols: vec![0, 1, 2],
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])],
            outputs: vec![all],
        };
        // `d` shows `c`, `a`, and the first two unknowns; `b` may be zero where `a` is infinite.
        assert_eq!(program.telling(0), [&Operand::Symbol(2), &b, &d]);
        assert_eq!(program.shown(0), HashSet::from([0, 1, 2]));
    }
}
