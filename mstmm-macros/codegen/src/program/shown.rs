//! Which unknowns need not be looked at, because results show what is wrong with them.

use super::{Operand, Operation, Program, Statement};
use std::collections::{HashMap, HashSet};

impl Program {
    /// Unknowns that leave a result of group `group` infinite or undefined whenever they are so
    /// themselves. Those of a repeated part do so in results of the same time.
    ///
    /// Sums, products, roots, sines and cosines hand on what is not finite (IEEE 754: 0 · ∞ and ∞ − ∞ are
    /// undefined, and so is what is computed from that). Not so reciprocals, for 1/∞ is zero, angles of
    /// points, and signs. What loops carry is not followed: it may end with the last time.
    pub fn shown(&self, group: usize) -> HashSet<u32> {
        let mut sources: HashMap<&str, Vec<&Operand>> = HashMap::new();
        for statement in self.sections().flat_map(|section| &section.statements) {
            match statement {
                Statement::Let(name, operation) => _ = sources.insert(name, handed_on(operation)),
                Statement::SinCos { sines, cosines, angles } => {
                    for names in [sines, cosines] {
                        let named = names.iter().zip(angles);
                        let named =
                            named.filter_map(|(name, angle)| Some((name.as_deref()?, angle)));
                        sources.extend(named.map(|(name, angle)| (name, vec![angle])));
                    }
                }
            }
        }
        let of_loops = self.loops().flat_map(|turn| &turn.outputs);
        let of_loops = of_loops.filter(|output| output.0 == group).map(|(_, _, result)| result);
        let mut waiting: Vec<&Operand> = self.outputs[group].iter().chain(of_loops).collect();
        let mut shown = HashSet::new();
        while let Some(operand) = waiting.pop() {
            match operand {
                Operand::Symbol(number) => _ = shown.insert(*number),
                // Followed once: the second time there is nothing left.
                Operand::Named(name) => {
                    waiting.extend(sources.remove(name.as_str()).unwrap_or_default())
                }
                Operand::Minus(operand) => waiting.push(operand),
                Operand::Number(_) | Operand::Repeated => (),
            }
        }
        shown
    }
}

/// What an operation does not hide.
fn handed_on(operation: &Operation) -> Vec<&Operand> {
    match operation {
        Operation::Sum(a, b) | Operation::Difference(a, b) | Operation::Product(a, b) => vec![a, b],
        Operation::MulAdd(a, b, c) | Operation::MulSub(a, b, c) | Operation::MulNegAdd(a, b, c) => {
            vec![a, b, c]
        }
        Operation::Sqrt(a) | Operation::CopySign(a, _) => vec![a],
        Operation::Recip(_) | Operation::RecipAbove(..) | Operation::Atan2(..) => vec![],
    }
}
