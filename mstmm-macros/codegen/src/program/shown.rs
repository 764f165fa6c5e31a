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
        // Statements stand before those that read them.
        let sections: Vec<&Section> = self.sections().collect();
        for statement in sections.iter().rev().flat_map(|section| section.statements.iter().rev()) {
            match statement {
                Statement::Let(name, operation) if shown.names.contains(name.as_str()) => {
                    handed_on(operation).into_iter().flatten().for_each(|from| shown.add(from));
                }
                Statement::Let(..) => (),
                Statement::SinCos { sines, cosines, angles } => {
                    let named = sines.iter().zip(angles).chain(cosines.iter().zip(angles));
                    for (name, angle) in named {
                        if name.as_deref().is_some_and(|name| shown.names.contains(name)) {
                            shown.add(angle);
                        }
                    }
                }
            }
        }
        shown.symbols
    }
}

/// What leaves a result infinite or undefined.
#[derive(Default)]
struct Shown<'a> {
    names: HashSet<&'a str>,
    symbols: HashSet<u32>,
}

impl<'a> Shown<'a> {
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
