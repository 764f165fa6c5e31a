//! Which values belong to a limb, and which values of limbs of one shape correspond to each other.

use super::{Leaf, Limb, LimbQuantity, Limbs};
use crate::ids::{IdVec, declare_id};
use crate::program::{
    ArrayRole, ArraySlice, Given, Operand, Operation, Procedure, Statement, Step, ValueId,
};
use std::collections::HashMap;

declare_id! {
    /// A class: values of the limbs of a group that correspond to each other, at most one for each limb.
    ClassId,
}

/// The classes of a procedure's values.
pub(super) struct Classes {
    /// The limb of each value that belongs to one, and its class.
    of: Vec<Option<(Limb, ClassId)>>,
    /// The values of each class by limb; none for a limb without a corresponding value.
    members: IdVec<ClassId, Vec<Option<ValueId>>>,
    /// The level of each value: how often, on the way to it, values of limbs have been joined to a value of no limb.
    ///
    /// Only values of the same level correspond to each other. A pack therefore never needs itself: within a level there
    /// are only paths inside of limbs, and those are the same in all of them.
    levels: Vec<u32>,
}

/// How a value is computed. Values with equal keys in different limbs correspond to each other.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Key {
    Leaf(LimbQuantity, Option<Given>, usize, usize),
    /// The level, the form and the operands.
    Formula(u32, Form, Vec<Term>),
    Sine(u32, Term),
    Cosine(u32, Term),
}

/// The form of an operation, up to signs.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub(super) enum Form {
    /// `±a ± b`
    Sum,
    /// `a b`
    Product,
    /// `±a b ± c`
    ProductSum,
    /// `1 / a`
    Recip,
    /// `√a`
    Sqrt,
}

/// An operand, up to signs.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
enum Term {
    Number,
    /// A value that belongs to no limb, and that may differ between limbs, as numbers may.
    Shared,
    Limb(ClassId),
}

/// An operation, with the factors of a product and the terms of a sum in an order that does not depend on the limb.
pub(super) struct Canonical<'a> {
    pub form: Form,
    /// The operands.
    pub operands: Vec<&'a Operand>,
    /// The signs of the first and of the last term; of a product, of its only term.
    pub negative: [bool; 2],
}

impl Classes {
    /// Finds the classes of a procedure without loops.
    pub fn of(procedure: &Procedure, limbs: &Limbs) -> Self {
        let count = procedure.values.count();
        let classes =
            Classes { of: vec![None; count], members: IdVec::new(), levels: vec![0; count] };
        let mut builder = Builder { classes, ids: HashMap::new(), counts: HashMap::new(), limbs };
        for step in &procedure.body {
            match step {
                Step::Load { from, into } => builder.load(procedure, from, into),
                Step::Compute(section) => section.statements.iter().for_each(|it| builder.add(it)),
                _ => {}
            }
        }
        builder.classes
    }

    /// Returns the class of a value, if another limb has a corresponding value.
    pub fn class(&self, value: ValueId) -> Option<ClassId> {
        let (_, class) = self.of.get(value.index()).copied().flatten()?;
        (self.members(class).count() > 1).then_some(class)
    }

    /// Iterates over the values of a class, each with its lane.
    pub fn members(&self, class: ClassId) -> impl Iterator<Item = (usize, ValueId)> {
        let members = self.members[class].iter().enumerate();
        members.filter_map(|(lane, value)| value.map(|value| (lane, value)))
    }

    /// Returns the number of classes.
    pub fn count(&self) -> usize {
        self.members.len()
    }

    /// Returns the lane of a value in the pack of its class.
    pub fn lane(&self, value: ValueId) -> usize {
        self.of[value.index()].map_or(0, |(limb, _)| limb.number)
    }

    /// Returns an operation in an order of operands that is the same for corresponding operations; none if packs do not
    /// have the operation.
    pub fn canonical<'a>(&self, operation: &'a Operation) -> Option<Canonical<'a>> {
        let (form, negative) = match operation {
            Operation::Sum(..) => (Form::Sum, [false, false]),
            Operation::Difference(..) => (Form::Sum, [false, true]),
            Operation::Product(..) => (Form::Product, [false, false]),
            Operation::MulAdd(..) => (Form::ProductSum, [false, false]),
            Operation::MulSub(..) => (Form::ProductSum, [false, true]),
            Operation::MulNegAdd(..) => (Form::ProductSum, [true, false]),
            Operation::Recip(_) => (Form::Recip, [false, false]),
            Operation::Sqrt(_) => (Form::Sqrt, [false, false]),
            Operation::CopySign(..) | Operation::Atan2(..) | Operation::RecipAbove(..) => {
                return None;
            }
        };
        let operands = operation.operands().into_iter().flatten().collect();
        let mut canonical = Canonical { form, operands, negative };
        if let [a, b, ..] = canonical.operands[..]
            && self.term(b) < self.term(a)
        {
            canonical.operands.swap(0, 1);
            if form == Form::Sum {
                canonical.negative.swap(0, 1);
            }
        }
        Some(canonical)
    }

    fn term(&self, operand: &Operand) -> Term {
        match operand.value() {
            None => Term::Number,
            Some(value) => match self.of[value.index()] {
                Some((_, class)) => Term::Limb(class),
                None => Term::Shared,
            },
        }
    }
}

struct Builder<'a> {
    classes: Classes,
    ids: HashMap<(usize, Key, usize), ClassId>,
    /// How often a limb has had a key.
    counts: HashMap<(Limb, Key), usize>,
    limbs: &'a Limbs,
}

impl Builder<'_> {
    fn load(&mut self, procedure: &Procedure, from: &ArraySlice, into: &[Option<ValueId>]) {
        let array = &procedure.arrays[from.array];
        let ArrayRole::Argument(argument) = array.role else { return };
        let first = array.layout.segments[from.segment].first + from.first;
        for (offset, value) in into.iter().enumerate() {
            let Some(value) = *value else { continue };
            if let Some(leaf) = self.limbs.leaves.get(&(argument, first + offset)) {
                let &Leaf { limb, quantity, given, place, offset } = leaf;
                self.insert(value, limb, Key::Leaf(quantity, given, place, offset));
            }
        }
    }

    /// Adds the values of a statement.
    fn add(&mut self, statement: &Statement) {
        match statement {
            Statement::Let(value, operation) => {
                let operands = || operation.operands().into_iter().flatten();
                let canonical = self.classes.canonical(operation);
                let limb = self.limb(operands()).filter(|_| canonical.is_some());
                let level = self.level(limb, operands());
                self.classes.levels[value.index()] = level;
                let (Some(limb), Some(canonical)) = (limb, canonical) else { return };
                let terms = canonical.operands.iter().map(|it| self.classes.term(it)).collect();
                self.insert(*value, limb, Key::Formula(level, canonical.form, terms));
            }
            Statement::SinCos { sines, cosines, angles } => {
                for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
                    let limb = self.limb(std::iter::once(angle));
                    let level = self.level(limb, std::iter::once(angle));
                    let term = self.classes.term(angle);
                    let keys = [(sine, Key::Sine(level, term)), (cosine, Key::Cosine(level, term))];
                    for (value, key) in keys {
                        let Some(value) = *value else { continue };
                        self.classes.levels[value.index()] = level;
                        if let Some(limb) = limb {
                            self.insert(value, limb, key);
                        }
                    }
                }
            }
            Statement::Pack { .. } | Statement::Lane { .. } => {
                bug!("a procedure that has packs is packed")
            }
        }
    }

    /// Returns the limb that operands belong to: the only one among them.
    fn limb<'a>(&self, operands: impl Iterator<Item = &'a Operand>) -> Option<Limb> {
        let of =
            |operand: &Operand| self.classes.of[operand.value()?.index()].map(|(limb, _)| limb);
        let mut limbs = operands.filter_map(of);
        let first = limbs.next()?;
        limbs.all(|other| other == first).then_some(first)
    }

    /// Returns the level of a value of this limb, or of none, with these operands.
    fn level<'a>(&self, limb: Option<Limb>, operands: impl Iterator<Item = &'a Operand>) -> u32 {
        let level = |value: ValueId| {
            let leaves_limb = limb.is_none() && self.classes.of[value.index()].is_some();
            self.classes.levels[value.index()] + u32::from(leaves_limb)
        };
        operands.filter_map(Operand::value).map(level).max().unwrap_or(0)
    }

    /// Adds a value. The order of values with equal keys in a limb distinguishes them.
    fn insert(&mut self, value: ValueId, limb: Limb, key: Key) {
        let count = self.counts.entry((limb, key.clone())).or_insert(0);
        let number = std::mem::replace(count, *count + 1);
        let size = self.limbs.sizes[limb.group];
        let members = &mut self.classes.members;
        let new = || members.push(vec![None; size]);
        let class = *self.ids.entry((limb.group, key, number)).or_insert_with(new);
        self.classes.members[class][limb.number] = Some(value);
        self.classes.of[value.index()] = Some((limb, class));
    }
}
