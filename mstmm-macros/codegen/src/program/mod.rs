//! A straight-line program: named values under headings, computed in order. It knows neither
//! where the formulas came from nor which language they will be printed in.

mod cost;
mod names;
mod shown;
pub mod text;

pub use cost::{Cost, Headed, by_heading};
pub use names::{Name, Names};

use crate::ids::RepeatId;

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// What its values are called.
    pub names: Names,
    /// Unknowns that it reads, in the order of their numbers.
    pub symbols: Vec<u32>,
    /// Values known since setup that it reads, in the order of their slots.
    pub slots: Vec<Slot>,
    /// The statements, in the order in which they run.
    pub blocks: Vec<Block>,
    /// What it computes, in the groups that were asked for. What a loop computes is
    /// [`Operand::Repeated`] here.
    pub outputs: Vec<Vec<Operand>>,
}

/// A part of a program.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Statements that run once, by sections.
    Once(Vec<Section>),
    /// Statements that run for every time of a repeated part.
    Loop(Loop),
}

/// A loop over the times of a repeated part.
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Which part.
    pub repeat: RepeatId,
    /// Whether it goes from the last time to the first.
    pub inwards: bool,
    /// What it carries: they change from time to time, and keep their last value.
    pub carries: Vec<Carried>,
    /// Unknowns of a time that it reads, in the order of their numbers.
    pub symbols: Vec<u32>,
    /// Values of a time known since setup that it reads.
    pub slots: Vec<Slot>,
    /// Values of the same time from earlier loops, by the number of the loop's block.
    pub loads: Vec<(usize, Vec<Name>)>,
    /// Values that later loops read at the same time.
    pub stores: Vec<Name>,
    /// The statements by sections.
    pub sections: Vec<Section>,
    /// What it computes: group, place in the group, and value.
    pub outputs: Vec<(usize, usize, Operand)>,
}

/// A number that a loop carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Carried {
    /// Under which name the last value is kept.
    pub name: Name,
    /// The value that a time begins with.
    pub entering: Name,
    /// What the first time begins with.
    pub first: Operand,
    /// What any time hands on.
    pub next: Operand,
}

/// A value known since setup.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Where it is kept.
    pub index: usize,
    /// Its name.
    pub name: Name,
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
    Let(Name, Operation),
    /// Sines and cosines of several angles at once.
    SinCos {
        /// Names of the sines, where they are used.
        sines: Vec<Option<Name>>,
        /// Names of the cosines, where they are used.
        cosines: Vec<Option<Name>>,
        /// The angles.
        angles: Vec<Operand>,
    },
}

impl Statement {
    /// The values that it computes.
    pub fn names(&self) -> impl Iterator<Item = Name> {
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
    /// An unknown, by its number.
    Symbol(u32),
    /// A value computed before, or a slot, by its name.
    Named(Name),
    /// The negative of a symbol or a named value.
    Minus(Box<Operand>),
    /// What a loop computes for every time of a repeated part.
    Repeated,
}

impl Operand {
    /// Its name, or that of the value that it is the negative of.
    pub fn name(&self) -> Option<Name> {
        match self {
            Operand::Named(name) => Some(*name),
            Operand::Minus(inner) => inner.name(),
            Operand::Number(_) | Operand::Symbol(_) | Operand::Repeated => None,
        }
    }
}

impl Program {
    /// All sections, those of loops once.
    pub fn sections(&self) -> impl Iterator<Item = &Section> {
        self.blocks.iter().flat_map(|block| match block {
            Block::Once(sections) => sections,
            Block::Loop(turn) => &turn.sections,
        })
    }

    /// Its loops.
    pub fn loops(&self) -> impl Iterator<Item = &Loop> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Once(_) => None,
            Block::Loop(turn) => Some(turn),
        })
    }
}
