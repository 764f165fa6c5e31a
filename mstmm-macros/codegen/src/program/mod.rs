//! Programs: named values under headings, computed in order. They know neither where the formulas came from
//! nor which language they will be printed in.
//!
//! A [`Program`] is the order of a function: what is computed when. A [`Procedure`] is a program with all that it
//! reads, tests and writes.

mod cost;
mod finiteness;
mod layout;
mod names;
mod procedure;
pub mod text;

pub use cost::{Cost, SectionCost, by_heading};
pub use finiteness::Finiteness;
pub use layout::{ArrayLayout, Segment};
pub use names::{ValueId, ValueNames};
pub use procedure::{
    Argument, Array, ArrayId, ArrayRole, ArraySlice, CarriedValue, CheckId, Failure, Finish,
    ForLoop, OutputId, PivotTest, PivotValue, Procedure, Repetition, Step, Witness,
};

use crate::ids::RepeatId;

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// What its values are called.
    pub names: ValueNames,
    /// Unknowns that it reads once, in the order of their numbers, and the values that they are.
    pub unknowns: Vec<(u32, ValueId)>,
    /// Values known since setup that it reads, in the order of their slots.
    pub slots: Vec<Slot>,
    /// The statements, in the order in which they run.
    pub blocks: Vec<Block>,
    /// What it returns, the numbers of all outputs in their order; none for what a loop returns.
    pub results: Vec<Option<Operand>>,
    /// Its pivots, and what they are measured by; none for those of a loop.
    pub pivots: Vec<Option<(Operand, Operand)>>,
}

/// A part of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Statements that run once, by sections.
    Once(Vec<Section>),
    /// Statements that run in every repetition of a part.
    Loop(LoopBlock),
}

/// A loop over the repetitions of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopBlock {
    /// Which part.
    pub repeat: RepeatId,
    /// Whether it goes from the last repetition to the first.
    pub inward: bool,
    /// What it carries: they change from repetition to repetition, and keep their last value.
    pub carries: Vec<CarriedValue>,
    /// Unknowns of a repetition that it reads, in the order of their numbers, and the values that they are.
    pub unknowns: Vec<(u32, ValueId)>,
    /// Values of a repetition known since setup that it reads.
    pub slots: Vec<Slot>,
    /// Values of the same repetition from earlier loops, by the number of the loop's block.
    pub loads: Vec<(usize, Vec<ValueId>)>,
    /// Values that later loops read in the same repetition.
    pub stores: Vec<ValueId>,
    /// The statements by sections.
    pub sections: Vec<Section>,
    /// What it returns: the number of the result, and the value.
    pub results: Vec<(usize, Operand)>,
    /// Its pivots by number, and what they are measured by.
    pub pivots: Vec<(usize, Operand, Operand)>,
}

/// A value known since setup.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Where it is kept.
    pub index: usize,
    /// Its name.
    pub name: ValueId,
}

/// Statements under one heading, which may have others elsewhere.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// What names of values begin with that have none of their own.
    pub prefix: String,
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// The statements.
    pub statements: Vec<Statement>,
}

impl Section {
    /// The heading only.
    pub fn without_statements(&self) -> Section {
        let Section { prefix, title, source, .. } = self;
        let [prefix, title, source] = [prefix, title, source].map(String::clone);
        Section { prefix, title, source, statements: Vec::new() }
    }

    /// Title and source.
    pub fn heading(&self) -> (&str, &str) {
        (&self.title, &self.source)
    }
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// One new value.
    Let(ValueId, Operation),
    /// Sines and cosines of several angles at once.
    SinCos {
        /// Names of the sines, where they are used.
        sines: Vec<Option<ValueId>>,
        /// Names of the cosines, where they are used.
        cosines: Vec<Option<ValueId>>,
        /// The angles.
        angles: Vec<Operand>,
    },
}

impl Statement {
    /// The values that it computes.
    pub fn names(&self) -> impl Iterator<Item = ValueId> {
        let (one, many) = match self {
            Statement::Let(name, _) => (Some(*name), None),
            Statement::SinCos { sines, cosines, .. } => (None, Some(sines.iter().chain(cosines))),
        };
        one.into_iter().chain(many.into_iter().flatten().filter_map(|name| *name))
    }

    /// What it reads.
    pub fn operands(&self) -> impl Iterator<Item = &Operand> {
        let (some, many) = match self {
            Statement::Let(_, operation) => (operation.operands(), &[][..]),
            Statement::SinCos { angles, .. } => ([None; 3], &angles[..]),
        };
        some.into_iter().flatten().chain(many)
    }
}

/// What a statement computes.
#[derive(Clone, Debug, PartialEq)]
pub enum Operation {
    /// `a + b`
    Sum(Operand, Operand),
    /// `a − b`
    Difference(Operand, Operand),
    /// `a b`
    Product(Operand, Operand),
    /// `a b + c`
    MulAdd(Operand, Operand, Operand),
    /// `a b − c`
    MulSub(Operand, Operand, Operand),
    /// `c − a b`
    MulNegAdd(Operand, Operand, Operand),
    /// `1 / a`
    Recip(Operand),
    /// `√a`
    Sqrt(Operand),
    /// `|a|` with the sign of `b`
    CopySign(Operand, Operand),
    /// The angle of the point at `a` upwards and `b` to the right
    Atan2(Operand, Operand),
    /// `1 / a` where `a` exceeds what rounding can leave of `b`, zero elsewhere
    RecipAbove(Operand, Operand),
}

impl Operation {
    /// What it works on.
    pub fn operands(&self) -> [Option<&Operand>; 3] {
        match self {
            Operation::Recip(a) | Operation::Sqrt(a) => [Some(a), None, None],
            Operation::Sum(a, b)
            | Operation::Difference(a, b)
            | Operation::Product(a, b)
            | Operation::CopySign(a, b)
            | Operation::Atan2(a, b)
            | Operation::RecipAbove(a, b) => [Some(a), Some(b), None],
            Operation::MulAdd(a, b, c)
            | Operation::MulSub(a, b, c)
            | Operation::MulNegAdd(a, b, c) => [Some(a), Some(b), Some(c)],
        }
    }
}

/// What an operation works on.
#[derive(Clone, Debug, PartialEq)]
pub enum Operand {
    /// A known number.
    Number(f64),
    /// A value read or computed before.
    Value(ValueId),
    /// The negative of a value.
    Minus(Box<Operand>),
}

impl Operand {
    /// The value that it is, or that it is the negative of.
    pub fn value(&self) -> Option<ValueId> {
        match self {
            Operand::Value(value) => Some(*value),
            Operand::Minus(inner) => inner.value(),
            Operand::Number(_) => None,
        }
    }

    /// Whether it is the same in every state.
    pub fn is_known(&self) -> bool {
        self.value().is_none()
    }
}

impl Program {
    /// All sections, those of loops once.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        self.blocks.iter().flat_map(|block| match block {
            Block::Once(sections) => sections,
            Block::Loop(block) => &block.sections,
        })
    }

    /// Its loops.
    pub fn loops(&self) -> impl Iterator<Item = &LoopBlock> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Once(_) => None,
            Block::Loop(block) => Some(block),
        })
    }
}
