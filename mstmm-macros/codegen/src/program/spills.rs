//! Which values of a program are kept in memory meanwhile.

use super::Operand;

/// What moves between memory and registers, and when.
#[derive(Clone, Debug, PartialEq)]
pub struct Spills {
    /// What moves before each statement, and before the results are read.
    pub moves: Vec<Vec<Move>>,
    /// How many places are needed in memory.
    pub places: usize,
}

/// A value that moves.
#[derive(Clone, Debug, PartialEq)]
pub enum Move {
    /// An unknown, or a value known since setup, is read from where the caller keeps it.
    Read(Operand),
    /// A value is kept in the place of this number.
    Spill(Operand, usize),
    /// A value is needed again.
    Reload(Operand),
}
