//! Results that are the opposite of a value are computed with their own sign, where that takes no operation.

use crate::program::{Block, Operand, Operation, Program, Section, Statement};
use std::collections::HashMap;

/// The same program, in which few results of a group are the opposite of what a statement computes.
///
/// `a − b` becomes `b − a`, `a b − c` becomes `c − a b`, and where one operand of a sum or a product is wanted
/// nowhere else and can be turned round so, they are, too. All are rounded alike with either sign.
pub fn opposite(mut program: Program, group: usize) -> Program {
    let [Block::Once(sections)] = &mut program.blocks[..] else { return program };
    if !program.outputs[group].iter().any(|result| matches!(result, Operand::Minus(_))) {
        return program;
    }
    let mut values = Values::of(sections, &program.outputs);
    let mut results = program.outputs[group].clone();
    for result in &mut results {
        if let Operand::Minus(inner) = result
            && let Some(turned) = values.turned(inner)
        {
            *result = turned;
        }
    }
    let turned = values.turned;
    write(sections, turned);
    program.outputs[group] = results;
    program
}

/// The values that statements compute one by one.
struct Values<'a> {
    operations: HashMap<&'a str, &'a Operation>,
    /// How often each is wanted.
    uses: HashMap<&'a str, usize>,
    /// Those that have been turned round, by their names before.
    turned: Turned,
}

type Turned = HashMap<String, (String, Operation)>;

impl<'a> Values<'a> {
    fn of(sections: &'a [Section], outputs: &'a [Vec<Operand>]) -> Self {
        let statements = || sections.iter().flat_map(|section| &section.statements);
        let operations = statements().filter_map(|statement| match statement {
            Statement::Let(name, operation) => Some((name.as_str(), operation)),
            Statement::SinCos { .. } => None,
        });
        let mut uses = HashMap::new();
        let read = statements().flat_map(Statement::operands).chain(outputs.iter().flatten());
        for name in read.filter_map(Operand::name) {
            *uses.entry(name).or_insert(0) += 1;
        }
        Values { operations: operations.collect(), uses, turned: HashMap::new() }
    }

    /// The opposite of an operand, if it takes no operation.
    fn turned(&mut self, operand: &Operand) -> Option<Operand> {
        let name = match operand {
            Operand::Number(value) => return Some(Operand::Number(-value)),
            Operand::Minus(inner) => return Some((**inner).clone()),
            Operand::Named(name) => name,
            Operand::Symbol(_) | Operand::Repeated => return None,
        };
        if self.uses.get(name.as_str()) != Some(&1) {
            return None;
        }
        let turned = match (*self.operations.get(name.as_str())?).clone() {
            Operation::Difference(a, b) => Operation::Difference(b, a),
            Operation::MulSub(a, b, c) => Operation::MulNegAdd(a, b, c),
            Operation::MulNegAdd(a, b, c) => Operation::MulSub(a, b, c),
            Operation::MulAdd(a, b, c) => Operation::MulNegAdd(a, b, self.turned(&c)?),
            Operation::Sum(a, b) => match self.turned(&a) {
                Some(a) => Operation::Difference(a, b),
                None => Operation::Difference(self.turned(&b)?, a),
            },
            Operation::Product(a, b) => match self.turned(&a) {
                Some(a) => Operation::Product(a, b),
                None => Operation::Product(a, self.turned(&b)?),
            },
            _ => return None,
        };
        let opposite = self.opposite_name(name);
        self.turned.insert(name.clone(), (opposite.clone(), turned));
        Some(Operand::Named(opposite))
    }

    /// A name that nothing has yet.
    fn opposite_name(&self, name: &str) -> String {
        let plain =
            name.strip_prefix("minus_").map_or_else(|| format!("minus_{name}"), str::to_owned);
        let is_number = name.strip_prefix('t').is_some_and(|rest| rest.parse::<usize>().is_ok());
        if is_number || self.operations.contains_key(plain.as_str()) {
            name.to_owned()
        } else {
            plain
        }
    }
}

/// Puts what has been turned round where it was.
fn write(sections: &mut [Section], mut turned: Turned) {
    for statement in sections.iter_mut().flat_map(|section| &mut section.statements) {
        if let Statement::Let(name, operation) = statement
            && let Some(turned) = turned.remove(name)
        {
            (*name, *operation) = turned;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(name: &str) -> Operand {
        Operand::Named(name.into())
    }

    fn minus(name: &str) -> Operand {
        Operand::Minus(Box::new(named(name)))
    }

    fn program(statements: Vec<Statement>, results: Vec<Operand>) -> Program {
        let section = Section { title: String::new(), source: String::new(), statements };
        Program {
            symbols: vec![0, 1],
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])],
            outputs: vec![results],
        }
    }

    fn statement(name: &str, operation: Operation) -> Statement {
        Statement::Let(name.into(), operation)
    }

    #[test]
    fn differences_and_what_is_made_of_them_are_turned_round() {
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let given = program(
            vec![
                statement("t1", Operation::Difference(x.clone(), y.clone())),
                statement("t2", Operation::MulAdd(x.clone(), x.clone(), named("t1"))),
                statement("minus_a", Operation::Sum(y.clone(), named("t2"))),
            ],
            vec![minus("minus_a")],
        );
        let expected = program(
            vec![
                statement("t1", Operation::Difference(y.clone(), x.clone())),
                statement("t2", Operation::MulNegAdd(x.clone(), x, named("t1"))),
                statement("a", Operation::Difference(named("t2"), y)),
            ],
            vec![named("a")],
        );
        assert_eq!(opposite(given, 0), expected);
    }

    #[test]
    fn what_is_wanted_elsewhere_stays() {
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let given = program(
            vec![
                statement("a", Operation::Difference(x.clone(), y)),
                statement("b", Operation::Sum(x, named("a"))),
            ],
            vec![minus("a"), minus("b")],
        );
        assert_eq!(opposite(given.clone(), 0), given);
    }
}
