//! Operation counts of programs, in total and by heading.

use super::{Operation, Procedure, Program, Section, Statement};

/// The numbers of operations by kind.
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
    /// Returns the sum of multiplications, additions, reciprocals and square roots.
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
    /// Returns its operation count.
    fn cost(&self) -> Cost {
        let of_statement = |statement: &Statement| match statement {
            Statement::SinCos { angles, .. } => Cost { trig: angles.len(), ..Cost::default() },
            Statement::Pack { .. } | Statement::Lane { .. } => Cost::default(),
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
        self.statements.iter().map(of_statement).fold(Cost::default(), |sum, cost| sum + cost)
    }
}

/// The operation count of all sections with the same heading.
#[derive(Clone, Copy, Debug)]
pub struct SectionCost<'a> {
    /// The title: what is computed.
    pub title: &'a str,
    /// The source of the equations.
    pub source: &'a str,
    /// The operation count.
    pub cost: Cost,
}

/// Returns the operation counts by heading, in the order in which the headings first occur.
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
    /// Returns its operation count; operations of loops count once.
    pub fn cost(&self) -> Cost {
        self.sections().map(Section::cost).fold(Cost::default(), |sum, cost| sum + cost)
    }
}

impl Procedure {
    /// Returns its operation count; operations of loops count once.
    pub fn cost(&self) -> Cost {
        self.sections().map(Section::cost).fold(Cost::default(), |sum, cost| sum + cost)
    }
}
