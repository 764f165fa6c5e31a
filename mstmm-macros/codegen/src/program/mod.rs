//! Programs: statements under headings, in the order in which they run. They depend neither on the equations nor on the
//! language that they are printed in.
//!
//! A [`Program`] is a function whose statements are in order. A [`Procedure`] is a program with its loads, tests and
//! stores.

mod cost;
mod finiteness;
mod layout;
mod magnitude;
mod names;
mod procedure;
pub mod text;

pub use cost::{Cost, SectionCost, by_heading};
pub use finiteness::Finiteness;
pub use layout::{ArrayLayout, Segment, Strided};
pub use magnitude::ValueBound;
pub use names::{ValueId, ValueNames};
pub use procedure::{
    Argument, Array, ArrayId, ArrayRole, ArraySlice, CarriedValue, CheckId, Failure, ForLoop,
    Given, OutputId, PivotTest, PivotValue, Procedure, Repetition, ResultCheck, Step, Witness,
};

use crate::ids::{IdVec, RepeatId, SymbolId, declare_id};
use std::rc::Rc;

declare_id! {
    /// A block of a program.
    BlockId,
}

/// The number of lanes of a pack, and the largest number of limbs side by side. A lane without a limb repeats another limb.
pub const PACK: usize = 4;

/// The statements of a function, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// The names of its values.
    pub names: ValueNames,
    /// The unknowns that it reads outside of loops, sorted by symbol, each with its value.
    pub unknowns: Vec<(SymbolId, ValueId)>,
    /// The slots that it reads outside of loops.
    pub slots: Vec<Slot>,
    /// The blocks, in the order in which they run.
    pub blocks: IdVec<BlockId, Block>,
    /// The entries of all outputs, in order; none for entries that a loop computes.
    pub results: Vec<Option<Operand>>,
    /// Its pivots, each with its scale; none for the pivots of a loop.
    pub pivots: Vec<Option<(Operand, Operand)>>,
}

/// A block of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Sections that run once.
    Once(Vec<Section>),
    /// Sections that run in every repetition of a part.
    Loop(LoopBlock),
}

impl Block {
    /// Returns its sections.
    pub fn sections(&self) -> &[Section] {
        match self {
            Block::Once(sections) => sections,
            Block::Loop(one) => &one.sections,
        }
    }
}

/// A loop over the repetitions of a part.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopBlock {
    /// The repeated part.
    pub repeat: RepeatId,
    /// Whether it runs from the last repetition to the first.
    pub inward: bool,
    /// The loop-carried values, which keep their last value after the loop.
    pub carries: Vec<CarriedValue>,
    /// The unknowns of a repetition that it reads, sorted by symbol, each with its value.
    pub unknowns: Vec<(SymbolId, ValueId)>,
    /// The slots of a repetition that it reads.
    pub slots: Vec<Slot>,
    /// The values of the same repetition that it reads from earlier loops, by the block of the earlier loop.
    pub loads: Vec<(BlockId, Vec<ValueId>)>,
    /// The values that later loops read in the same repetition.
    pub stores: Vec<ValueId>,
    /// The sections.
    pub sections: Vec<Section>,
    /// The results that it computes, each with its index among the results of the program.
    pub results: Vec<(usize, Operand)>,
    /// Its pivots: index, value and scale.
    pub pivots: Vec<(usize, Operand, Operand)>,
}

/// A value that is known since setup and kept by the chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Its index in the array of slots.
    pub index: usize,
    /// The value.
    pub value: ValueId,
}

/// Statements under one heading. Several sections may have the same heading.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// The prefix of the names of unnamed values.
    pub prefix: Rc<str>,
    /// The title: what is computed.
    pub title: Rc<str>,
    /// The source of the equations.
    pub source: Rc<str>,
    /// The statements.
    pub statements: Vec<Statement>,
}

impl Section {
    /// Returns a section with the same heading and without statements.
    pub fn without_statements(&self) -> Section {
        let Section { prefix, title, source, .. } = self;
        let [prefix, title, source] = [prefix, title, source].map(Rc::clone);
        Section { prefix, title, source, statements: Vec::new() }
    }

    /// Returns title and source.
    pub fn heading(&self) -> (&str, &str) {
        (&self.title, &self.source)
    }
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// Defines one value.
    Let(ValueId, Operation),
    /// Defines sines and cosines of several angles at once.
    SinCos {
        /// The sines, if they are used.
        sines: Vec<Option<ValueId>>,
        /// The cosines, if they are used.
        cosines: Vec<Option<ValueId>>,
        /// The angles.
        angles: Vec<Operand>,
    },
    /// Defines a pack of scalars, one in each lane. A `Let` with a pack among its operands applies its operation lane by
    /// lane and defines a pack; its scalar operands are the same in all lanes.
    Pack {
        /// The pack.
        pack: ValueId,
        /// The scalars.
        values: Vec<Operand>,
    },
    /// Defines a scalar: the value in a lane of a pack, or its negative.
    Lane {
        /// The scalar.
        value: ValueId,
        /// The pack.
        pack: ValueId,
        /// The lane.
        lane: usize,
        /// Whether it is the negative of the value in the lane.
        negative: bool,
    },
}

impl Statement {
    /// Iterates over the values that it defines.
    pub fn defined(&self) -> impl Iterator<Item = ValueId> {
        let (single, several) = match self {
            Statement::Let(name, _)
            | Statement::Pack { pack: name, .. }
            | Statement::Lane { value: name, .. } => (Some(*name), [&[][..]; 2]),
            Statement::SinCos { sines, cosines, .. } => (None, [&sines[..], cosines]),
        };
        DefinedValues { single, several }
    }

    /// Iterates over its operands, except the pack that a lane is read from.
    pub fn operands(&self) -> impl Iterator<Item = &Operand> {
        let (few, several) = match self {
            Statement::Let(_, operation) => (operation.operands(), &[][..]),
            Statement::SinCos { angles, .. } => ([None; 3], &angles[..]),
            Statement::Pack { values, .. } => ([None; 3], &values[..]),
            Statement::Lane { .. } => ([None; 3], &[][..]),
        };
        StatementOperands { few, several }
    }
}

// These iterators are written by hand because macros are built unoptimised, where they cost a fraction of chains of iterators.

/// An iterator over the values that a statement defines.
struct DefinedValues<'a> {
    single: Option<ValueId>,
    several: [&'a [Option<ValueId>]; 2],
}

impl Iterator for DefinedValues<'_> {
    type Item = ValueId;

    fn next(&mut self) -> Option<ValueId> {
        if self.single.is_some() {
            return self.single.take();
        }
        for values in &mut self.several {
            while let [first, rest @ ..] = *values {
                *values = rest;
                if first.is_some() {
                    return *first;
                }
            }
        }
        None
    }
}

/// An iterator over the operands of a statement.
struct StatementOperands<'a> {
    /// Up to three, the missing ones last.
    few: [Option<&'a Operand>; 3],
    several: &'a [Operand],
}

impl<'a> Iterator for StatementOperands<'a> {
    type Item = &'a Operand;

    fn next(&mut self) -> Option<&'a Operand> {
        if let [Some(first), second, third] = self.few {
            self.few = [second, third, None];
            return Some(first);
        }
        let (first, rest) = self.several.split_first()?;
        self.several = rest;
        Some(first)
    }
}

/// An arithmetic operation.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// `atan2(a, b)`
    Atan2(Operand, Operand),
    /// `1 / a` if `a` exceeds the rounding error of `b`, otherwise zero
    RecipAbove(Operand, Operand),
}

impl Operation {
    /// Returns its operands.
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

/// An operand of an operation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A known number.
    Number(f64),
    /// A value that was read or computed before.
    Value(ValueId),
    /// The negative of a value.
    Minus(ValueId),
}

impl Operand {
    /// Returns the value that it is or negates.
    pub fn value(&self) -> Option<ValueId> {
        match self {
            Operand::Value(value) | Operand::Minus(value) => Some(*value),
            Operand::Number(_) => None,
        }
    }

    /// Returns whether it is the negative of a value.
    pub fn is_negated(&self) -> bool {
        matches!(self, Operand::Minus(_))
    }

    /// Returns whether it is a known number.
    pub fn is_known(&self) -> bool {
        self.value().is_none()
    }
}

impl Program {
    /// Iterates over all sections; sections of loops count once.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        self.blocks.iter().flat_map(Block::sections)
    }

    /// Iterates over its loops.
    pub fn loops(&self) -> impl Iterator<Item = &LoopBlock> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Once(_) => None,
            Block::Loop(block) => Some(block),
        })
    }
}
