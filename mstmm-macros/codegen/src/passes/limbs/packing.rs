//! Writes the statements of a packed procedure.

use super::classes::{Canonical, ClassId, Classes, Form};
use crate::program::{
    Operand, Operation, PACK, Procedure, Section, Statement, Step, ValueId, ValueNames,
};
use std::collections::HashMap;

/// Which lanes of a pack hold the negative of their value.
type Signs = [bool; PACK];

/// An operand of an operation on packs.
struct Column {
    /// A pack, or a scalar that all lanes read.
    operand: Operand,
    negative: Signs,
}

/// A packed procedure under construction.
pub(super) struct Packing<'a> {
    procedure: &'a Procedure,
    classes: &'a Classes,
    /// The statement that computes each value.
    makers: Vec<Option<&'a Statement>>,
    /// The values that other steps than statements read.
    is_result: Vec<bool>,
    /// Whether a scalar is known.
    is_done: Vec<bool>,
    /// The pack of each class that has been computed, and its signs.
    packs: Vec<Option<(ValueId, Signs)>>,
    /// Whether the pack of a class has been begun.
    is_open: Vec<bool>,
    /// Whether a pack needs itself. Levels exclude it, except through the sines and cosines of one statement.
    is_circular: bool,
    /// The packs of scalars: values and numbers.
    gathered: HashMap<Vec<Gathered>, ValueId>,
    /// The products of packs with ±1.
    flipped: HashMap<(ValueId, Signs), ValueId>,
    names: ValueNames,
    statements: Vec<Statement>,
}

/// An entry of a pack of scalars.
#[derive(PartialEq, Eq, Hash)]
enum Gathered {
    Number(u64),
    Value(ValueId),
}

impl<'a> Packing<'a> {
    /// Returns the empty packing of a procedure.
    pub fn new(procedure: &'a Procedure, classes: &'a Classes) -> Self {
        let count = procedure.values.count();
        let mut packing = Packing {
            procedure,
            classes,
            makers: vec![None; count],
            is_result: vec![false; count],
            is_done: vec![true; count],
            packs: vec![None; classes.count()],
            is_open: vec![false; classes.count()],
            is_circular: false,
            gathered: HashMap::new(),
            flipped: HashMap::new(),
            names: procedure.values.clone(),
            statements: Vec::new(),
        };
        for statement in procedure.sections().flat_map(|section| &section.statements) {
            for value in statement.defined() {
                packing.makers[value.index()] = Some(statement);
                packing.is_done[value.index()] = false;
            }
        }
        for value in procedure.body.iter().flat_map(read) {
            packing.is_result[value.index()] = true;
        }
        packing
    }

    /// Returns the packed procedure; none if a pack needs itself. A pack is computed where the first of its values was.
    pub fn run(mut self) -> Option<Procedure> {
        let mut body = Vec::new();
        for step in &self.procedure.body {
            match step {
                Step::Compute(section) => {
                    let values = section.statements.iter().flat_map(Statement::defined);
                    values.for_each(|value| self.require(value));
                    let statements = std::mem::take(&mut self.statements);
                    if !statements.is_empty() {
                        let section = Section { statements, ..section.without_statements() };
                        body.push(Step::Compute(section));
                    }
                }
                _ => body.push(step.clone()),
            }
        }
        let is_complete = !self.is_circular;
        is_complete.then(|| Procedure { values: self.names, body, ..self.procedure.clone() })
    }

    /// Computes a value, in a pack if all limbs have it.
    fn require(&mut self, value: ValueId) {
        match self.class(value) {
            Some(class) => self.pack(class),
            None => self.scalar(value),
        }
    }

    /// Returns the class of a value that is computed in a pack.
    fn class(&self, value: ValueId) -> Option<ClassId> {
        let is_formula = matches!(self.makers[value.index()], Some(Statement::Let(..)));
        self.classes.class(value).filter(|_| is_formula)
    }

    /// Makes a value known as a scalar.
    fn scalar(&mut self, value: ValueId) {
        if self.is_done[value.index()] {
            return;
        }
        if let Some(class) = self.class(value) {
            self.pack(class);
            self.read_lane(value, class);
            return;
        }
        let Some(statement) = self.makers[value.index()] else {
            bug!("a value is neither read nor computed")
        };
        statement.operands().filter_map(Operand::value).for_each(|operand| self.scalar(operand));
        statement.defined().for_each(|value| self.is_done[value.index()] = true);
        self.statements.push(statement.clone());
    }

    fn read_lane(&mut self, value: ValueId, class: ClassId) {
        let Some((pack, signs)) = self.packs[class.index()] else { bug!("a pack is missing") };
        if !std::mem::replace(&mut self.is_done[value.index()], true) {
            let lane = self.classes.lane(value);
            self.statements.push(Statement::Lane { value, pack, lane, negative: signs[lane] });
        }
    }

    /// Computes the pack of a class.
    fn pack(&mut self, class: ClassId) {
        if self.packs[class.index()].is_some() {
            return;
        }
        let members: Vec<(usize, ValueId)> = self.classes.members(class).collect();
        if std::mem::replace(&mut self.is_open[class.index()], true) {
            // The procedure is given up: any value ends the circle.
            self.is_circular = true;
            self.packs[class.index()] = Some((members[0].1, [false; PACK]));
            return;
        }
        let operations: Vec<(usize, Canonical)> =
            members.iter().map(|&(lane, value)| (lane, self.operation(value))).collect();
        let count = operations[0].1.operands.len();
        let columns: Vec<Column> = (0..count)
            .map(|number| {
                let operands = operations.iter().map(|(lane, of)| (*lane, of.operands[number]));
                self.column(&operands.collect::<Vec<_>>())
            })
            .collect();
        let negative = [0, 1].map(|term| {
            filled(operations.iter().map(|(lane, operation)| (*lane, operation.negative[term])))
        });
        let (operation, signs) = self.combine(operations[0].1.form, columns, negative);
        let pack = self.names.fresh(format!("{}_limbs", self.names.text(members[0].1)));
        self.statements.push(Statement::Let(pack, operation));
        self.packs[class.index()] = Some((pack, signs));
        for (_, value) in members {
            if self.is_result[value.index()] {
                self.read_lane(value, class);
            }
        }
    }

    fn operation(&self, value: ValueId) -> Canonical<'a> {
        let Some(Statement::Let(_, operation)) = self.makers[value.index()] else {
            bug!("a value of a pack is no formula")
        };
        let classes = self.classes;
        classes.canonical(operation).unwrap_or_else(|| bug!("packs lack an operation"))
    }

    /// Returns an operation on packs and the signs of its result. `negative` has the signs of its terms.
    fn combine(
        &mut self,
        form: Form,
        columns: Vec<Column>,
        negative: [Signs; 2],
    ) -> (Operation, Signs) {
        let mut columns = columns.into_iter();
        let mut next = || columns.next().unwrap_or_else(|| bug!("an operation lacks an operand"));
        let a = next();
        match form {
            // Both are odd functions.
            Form::Recip => (Operation::Recip(a.operand), a.negative),
            Form::Sqrt => {
                let root = self.flip(a.operand, a.negative);
                (Operation::Sqrt(root), [false; PACK])
            }
            Form::Product => {
                let b = next();
                (Operation::Product(a.operand, b.operand), xor(a.negative, b.negative))
            }
            Form::Sum => {
                let b = next();
                // The first term keeps its sign.
                let signs = xor(negative[0], a.negative);
                let other = xor(signs, xor(negative[1], b.negative));
                let operation = match uniform(other) {
                    Some(false) => Operation::Sum(a.operand, b.operand),
                    Some(true) => Operation::Difference(a.operand, b.operand),
                    None => Operation::Sum(a.operand, self.flip(b.operand, other)),
                };
                (operation, signs)
            }
            Form::ProductSum => {
                let (b, c) = (next(), next());
                // The addend keeps its sign.
                let signs = xor(negative[1], c.negative);
                let product = xor(signs, xor(negative[0], xor(a.negative, b.negative)));
                let operation = match uniform(product) {
                    Some(false) => Operation::MulAdd(a.operand, b.operand, c.operand),
                    Some(true) => Operation::MulNegAdd(a.operand, b.operand, c.operand),
                    None => {
                        let factor = self.flip(b.operand, product);
                        Operation::MulAdd(a.operand, factor, c.operand)
                    }
                };
                (operation, signs)
            }
        }
    }

    /// Returns corresponding operands, each with its lane, as a pack, or as the scalar that they all are.
    fn column(&mut self, operands: &[(usize, &Operand)]) -> Column {
        let plain: Vec<(usize, Operand, bool)> = operands
            .iter()
            .map(|&(lane, operand)| {
                let (plain, negative) = without_sign(*operand);
                (lane, plain, negative)
            })
            .collect();
        let negative = filled(plain.iter().map(|&(lane, _, negative)| (lane, negative)));
        let (_, first, _) = plain[0];
        let class = first.value().and_then(|value| self.class(value));
        if class.is_none() && plain.iter().all(|(_, other, _)| *other == first) {
            first.value().into_iter().for_each(|value| self.scalar(value));
            return Column { operand: first, negative };
        }
        if let Operand::Value(value) = first
            && let Some(class) = self.class(value)
        {
            self.pack(class);
            let Some((pack, signs)) = self.packs[class.index()] else { bug!("a pack is missing") };
            return Column { operand: Operand::Value(pack), negative: xor(negative, signs) };
        }
        let values = filled(plain.iter().map(|&(lane, operand, _)| (lane, operand)));
        Column { operand: Operand::Value(self.gather(values.to_vec())), negative }
    }

    /// Returns a pack of scalars.
    fn gather(&mut self, values: Vec<Operand>) -> ValueId {
        let key = |operand: &Operand| match operand {
            Operand::Number(number) => Gathered::Number(number.to_bits()),
            Operand::Value(value) => Gathered::Value(*value),
            Operand::Minus(_) => bug!("signs are kept apart from the values of a pack"),
        };
        let keys: Vec<Gathered> = values.iter().map(key).collect();
        if let Some(&known) = self.gathered.get(&keys) {
            return known;
        }
        values.iter().filter_map(Operand::value).for_each(|value| self.scalar(value));
        let wanted = match values[0].value() {
            Some(value) => format!("{}_limbs", self.names.text(value)),
            None => "numbers_limbs".to_owned(),
        };
        let pack = self.names.fresh(wanted);
        self.statements.push(Statement::Pack { pack, values });
        self.gathered.insert(keys, pack);
        pack
    }

    /// Returns an operand with other signs in some lanes.
    fn flip(&mut self, operand: Operand, signs: Signs) -> Operand {
        if uniform(signs) == Some(false) {
            return operand;
        }
        let sign = |number: f64, is_negative: bool| if is_negative { -number } else { number };
        let value = match operand {
            Operand::Number(number) => {
                let numbers = signs.map(|negative| Operand::Number(sign(number, negative)));
                return Operand::Value(self.gather(numbers.to_vec()));
            }
            Operand::Value(value) => value,
            Operand::Minus(_) => bug!("signs are kept apart from the values of a pack"),
        };
        if let Some(&known) = self.flipped.get(&(value, signs)) {
            return Operand::Value(known);
        }
        let ones = signs.map(|negative| Operand::Number(sign(1.0, negative)));
        let ones = self.gather(ones.to_vec());
        let flipped = self.names.fresh(format!("{}_signed", self.names.text(value)));
        let product = Operation::Product(Operand::Value(value), Operand::Value(ones));
        self.statements.push(Statement::Let(flipped, product));
        self.flipped.insert((value, signs), flipped);
        Operand::Value(flipped)
    }
}

/// Returns the values that a step other than statements reads.
fn read(step: &Step) -> Vec<ValueId> {
    let operands: Vec<&Operand> = match step {
        Step::Store { values, .. } => values.iter().flatten().collect(),
        Step::TestBounds(bounds) => bounds.iter().flat_map(|bound| &bound.values).collect(),
        Step::CheckResults(check) => check.operands().collect(),
        Step::CheckPivot { value, scale, .. } => vec![value, scale],
        Step::CheckArguments(_) | Step::Load { .. } | Step::Compute(_) | Step::Loop(_) => vec![],
    };
    operands.into_iter().filter_map(Operand::value).collect()
}

/// Splits an operand into a number without a sign or a value, and whether it is its negative.
fn without_sign(operand: Operand) -> (Operand, bool) {
    match operand {
        Operand::Minus(value) => (Operand::Value(value), true),
        Operand::Number(_) | Operand::Value(_) => (operand, false),
    }
}

/// Returns one item for each lane; a lane without an item repeats the first.
fn filled<I: Copy>(items: impl Iterator<Item = (usize, I)> + Clone) -> [I; PACK] {
    let first = || items.clone().next().unwrap_or_else(|| bug!("a pack is empty")).1;
    std::array::from_fn(|lane| {
        items.clone().find(|&(of, _)| of == lane).map_or_else(first, |(_, item)| item)
    })
}

fn xor(a: Signs, b: Signs) -> Signs {
    std::array::from_fn(|lane| a[lane] != b[lane])
}

/// Returns the sign that all lanes have, if it is the same.
fn uniform(signs: Signs) -> Option<bool> {
    signs.iter().all(|&it| it == signs[0]).then_some(signs[0])
}
