//! How many operations a program takes, in all and under each heading.

use super::{Operation, Procedure, Program, Section, Statement};

/// How many operations of each kind a program has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Multiplications.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
    /// Reciprocals.
    pub recip: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Pairs of sine and cosine, and arctangents.
    pub trig: usize,
}

impl Cost {
    /// Multiplications, additions, reciprocals and square roots together.
    pub fn arithmetic(&self) -> usize {
        self.mul + self.add + self.recip + self.sqrt
    }
}

impl std::ops::Add for Cost {
    type Output = Cost;
    fn add(self, other: Cost) -> Cost {
        Cost {
            mul: self.mul + other.mul,
            add: self.add + other.add,
            recip: self.recip + other.recip,
            sqrt: self.sqrt + other.sqrt,
            trig: self.trig + other.trig,
        }
    }
}

impl std::fmt::Display for Cost {
    fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
        let Cost { mul, add, recip, sqrt, trig } = self;
        write!(out, "{mul} mul, {add} add, {recip} reciprocal")?;
        if *sqrt > 0 {
            write!(out, ", {sqrt} square root")?;
        }
        if *trig > 0 {
            write!(out, ", {trig} sin/cos")?;
        }
        Ok(())
    }
}

impl Section {
    /// Its operations.
    fn cost(&self) -> Cost {
        let one = |statement: &Statement| match statement {
            Statement::SinCos { angles, .. } => Cost { trig: angles.len(), ..Cost::default() },
            Statement::Let(_, operation) => match operation {
                Operation::Sum(..) | Operation::Difference(..) => {
                    Cost { add: 1, ..Cost::default() }
                }
                Operation::Product(..) => Cost { mul: 1, ..Cost::default() },
                Operation::MulAdd(..) | Operation::MulSub(..) | Operation::MulNegAdd(..) => {
                    Cost { mul: 1, add: 1, ..Cost::default() }
                }
                Operation::Recip(_) | Operation::RecipAbove(..) => {
                    Cost { recip: 1, ..Cost::default() }
                }
                Operation::Atan2(..) => Cost { trig: 1, ..Cost::default() },
                Operation::Sqrt(_) => Cost { sqrt: 1, ..Cost::default() },
                Operation::CopySign(..) => Cost::default(),
            },
        };
        self.statements.iter().map(one).fold(Cost::default(), |sum, cost| sum + cost)
    }
}

/// All operations under a heading.
#[derive(Clone, Copy, Debug)]
pub struct SectionCost<'a> {
    /// What is computed.
    pub title: &'a str,
    /// Where the equations are from.
    pub source: &'a str,
    /// The operations.
    pub cost: Cost,
}

/// The operations of sections by their headings, in the order in which those come first.
pub fn by_heading<'a>(sections: impl IntoIterator<Item = &'a Section>) -> Vec<SectionCost<'a>> {
    let mut all: Vec<SectionCost> = Vec::new();
    for section in sections {
        let (title, source, cost) = (&section.title[..], &section.source[..], section.cost());
        match all.iter_mut().find(|other| other.title == title && other.source == source) {
            Some(other) => other.cost = other.cost + cost,
            None => all.push(SectionCost { title, source, cost }),
        }
    }
    all
}

impl Program {
    /// Its operations; those of loops once.
    pub fn cost(&self) -> Cost {
        self.sections().map(Section::cost).fold(Cost::default(), |sum, cost| sum + cost)
    }
}

impl Procedure {
    /// Its operations; those of loops once.
    pub fn cost(&self) -> Cost {
        self.sections().map(Section::cost).fold(Cost::default(), |sum, cost| sum + cost)
    }
}
