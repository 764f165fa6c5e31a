//! Results that are the opposite of a value are computed with their own sign, where that takes no operation.

use crate::program::{Block, Name, Operand, Operation, Program, Section, Statement};

/// The same program, in which few results of a group are the opposite of what a statement computes.
///
/// `a − b` becomes `b − a`, `a b − c` becomes `c − a b`, and where one operand of a sum or a product is wanted
/// nowhere else and can be turned round so, they are, too. All are rounded alike with either sign. Unknowns
/// are called `symbols`.
pub fn opposite(mut program: Program, group: usize, symbols: &[String]) -> Program {
    let [Block::Once(sections)] = &mut program.blocks[..] else { return program };
    if !program.outputs[group].iter().any(|result| matches!(result, Operand::Minus(_))) {
        return program;
    }
    let mut values = Values::of(sections, &program.outputs, program.names.count());
    for result in &mut program.outputs[group] {
        if let Operand::Minus(inner) = result
            && let Some(turned) = values.turned(inner)
        {
            *result = turned;
        }
    }
    for name in values.turned {
        let opposite = opposite_name(program.names.text(name));
        if !program.names.all().contains(&opposite) && !symbols.contains(&opposite) {
            program.names.rename(name, opposite);
        }
    }
    program
}

/// The values that statements compute one by one.
struct Values<'a> {
    /// By the numbers of the values.
    operations: Vec<Option<&'a mut Operation>>,
    /// How often each is wanted.
    uses: Vec<usize>,
    /// Those that have been turned round.
    turned: Vec<Name>,
}

impl<'a> Values<'a> {
    fn of(sections: &'a mut [Section], outputs: &[Vec<Operand>], names: usize) -> Self {
        let mut uses = vec![0; names];
        let statements = sections.iter().flat_map(|section| &section.statements);
        let read = statements.flat_map(Statement::operands).chain(outputs.iter().flatten());
        read.filter_map(Operand::name).for_each(|name| uses[name.index()] += 1);
        let mut operations: Vec<_> = (0..names).map(|_| None).collect();
        for statement in sections.iter_mut().flat_map(|section| &mut section.statements) {
            if let Statement::Let(name, operation) = statement {
                operations[name.index()] = Some(operation);
            }
        }
        Values { operations, uses, turned: Vec::new() }
    }

    /// The opposite of an operand, if it takes no operation.
    fn turned(&mut self, operand: &Operand) -> Option<Operand> {
        let name = match operand {
            Operand::Number(value) => return Some(Operand::Number(-value)),
            Operand::Minus(inner) => return Some((**inner).clone()),
            Operand::Named(name) => *name,
            Operand::Symbol(_) | Operand::Repeated => return None,
        };
        if self.uses[name.index()] != 1 {
            return None;
        }
        let turned = match self.operations[name.index()].as_deref()?.clone() {
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
        if let Some(operation) = &mut self.operations[name.index()] {
            **operation = turned;
        }
        self.turned.push(name);
        Some(Operand::Named(name))
    }
}

/// What the opposite of a value may be called; one that has but a number keeps it.
fn opposite_name(name: &str) -> String {
    if name.strip_prefix('t').is_some_and(|rest| rest.parse::<usize>().is_ok()) {
        return name.to_owned();
    }
    name.strip_prefix("minus_").map_or_else(|| format!("minus_{name}"), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Names;

    const SYMBOLS: [&str; 2] = ["x", "y"];

    /// A program of statements that compute values of these names, in this order; names may be more.
    fn program(names: &[&str], operations: Vec<Operation>, results: Vec<Operand>) -> Program {
        let mut all = Names::default();
        let names: Vec<Name> = names.iter().map(|name| all.add((*name).to_owned())).collect();
        let statements = names.into_iter().zip(operations);
        let statements = statements.map(|(name, it)| Statement::Let(name, it)).collect();
        let section = Section { title: String::new(), source: String::new(), statements };
        Program {
            names: all,
            symbols: vec![0, 1],
            slots: Vec::new(),
            blocks: vec![Block::Once(vec![section])],
            outputs: vec![results],
        }
    }

    /// The first three values of a program.
    fn values() -> [Operand; 3] {
        let mut names = Names::default();
        ["", "", ""].map(|name| Operand::Named(names.add(name.to_owned())))
    }

    fn minus(operand: &Operand) -> Operand {
        Operand::Minus(Box::new(operand.clone()))
    }

    fn turned(program: Program) -> Program {
        opposite(program, 0, &SYMBOLS.map(str::to_owned))
    }

    #[test]
    fn differences_and_what_is_made_of_them_are_turned_round() {
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let [t1, t2, a] = values();
        let given = program(
            &["t1", "t2", "minus_a"],
            vec![
                Operation::Difference(x.clone(), y.clone()),
                Operation::MulAdd(x.clone(), x.clone(), t1.clone()),
                Operation::Sum(y.clone(), t2.clone()),
            ],
            vec![minus(&a)],
        );
        let expected = program(
            &["t1", "t2", "a"],
            vec![
                Operation::Difference(y.clone(), x.clone()),
                Operation::MulNegAdd(x.clone(), x, t1),
                Operation::Difference(t2, y),
            ],
            vec![a],
        );
        assert_eq!(turned(given), expected);
    }

    #[test]
    fn what_is_wanted_elsewhere_stays() {
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let [a, b, _] = values();
        let given = program(
            &["a", "b"],
            vec![Operation::Difference(x.clone(), y), Operation::Sum(x, a.clone())],
            vec![minus(&a), minus(&b)],
        );
        assert_eq!(turned(given.clone()), given);
    }

    #[test]
    fn names_that_are_there_already_are_not_given_again() {
        let (x, y) = (Operand::Symbol(0), Operand::Symbol(1));
        let [first, ..] = values();
        let difference = vec![Operation::Difference(x, y)];
        for (name, others) in [("minus_x", vec![]), ("minus_a", vec!["a"])] {
            let names: Vec<&str> = [name].into_iter().chain(others).collect();
            let turned = turned(program(&names, difference.clone(), vec![minus(&first)]));
            assert_eq!(turned.outputs, [vec![first.clone()]]);
            assert_eq!(turned.names.all()[0], name);
        }
    }
}
