//! A straight-line program: named values in headed sections, computed in order. It knows neither
//! where the formulas came from nor which language they will be printed in.

/// A program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    /// Unknowns that it reads, in the order of their numbers.
    pub symbols: Vec<u32>,
    /// Values known since setup that it reads, in the order of their slots.
    pub slots: Vec<Slot>,
    /// The statements by sections.
    pub sections: Vec<Section>,
    /// What it computes, in the groups that were asked for.
    pub outputs: Vec<Vec<Operand>>,
}

/// A value known since setup.
#[derive(Clone, Debug, PartialEq)]
pub struct Slot {
    /// Where it is kept.
    pub index: usize,
    /// Its name.
    pub name: String,
}

/// Statements under one heading.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// What is computed.
    pub title: String,
    /// Where the equations are from.
    pub source: String,
    /// The statements.
    pub statements: Vec<Statement>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// One new value.
    Let(String, Operation),
    /// Sines and cosines of several angles at once.
    SinCos {
        /// Names of the sines, where they are used.
        sines: Vec<Option<String>>,
        /// Names of the cosines, where they are used.
        cosines: Vec<Option<String>>,
        /// The angles.
        angles: Vec<Operand>,
    },
}

impl Statement {
    /// The names that it gives values to.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let (one, many) = match self {
            Statement::Let(name, _) => (Some(name.as_str()), None),
            Statement::SinCos { sines, cosines, .. } => (None, Some(sines.iter().chain(cosines))),
        };
        one.into_iter().chain(many.into_iter().flatten().filter_map(Option::as_deref))
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
    /// `1 / a`
    Recip(Operand),
    /// `√a`
    Sqrt(Operand),
    /// `|a|` with the sign of `b`
    CopySign(Operand, Operand),
}

/// What an operation works on.
#[derive(Clone, Debug, PartialEq)]
pub enum Operand {
    /// A known number.
    Number(f64),
    /// An unknown, by its number.
    Symbol(u32),
    /// A value computed before, or a slot, by its name.
    Named(String),
    /// The negative of a symbol or a named value.
    Minus(Box<Operand>),
}

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
    /// Pairs of sine and cosine.
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
    pub fn cost(&self) -> Cost {
        let one = |statement: &Statement| match statement {
            Statement::SinCos { angles, .. } => Cost { trig: angles.len(), ..Cost::default() },
            Statement::Let(_, operation) => match operation {
                Operation::Sum(..) | Operation::Difference(..) => {
                    Cost { add: 1, ..Cost::default() }
                }
                Operation::Product(..) => Cost { mul: 1, ..Cost::default() },
                Operation::Recip(_) => Cost { recip: 1, ..Cost::default() },
                Operation::Sqrt(_) => Cost { sqrt: 1, ..Cost::default() },
                Operation::CopySign(..) => Cost::default(),
            },
        };
        self.statements.iter().map(one).fold(Cost::default(), |sum, cost| sum + cost)
    }
}

impl Program {
    /// Its operations.
    pub fn cost(&self) -> Cost {
        self.sections.iter().map(Section::cost).fold(Cost::default(), |sum, cost| sum + cost)
    }
}
