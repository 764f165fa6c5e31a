//! The unknowns of a chain's functions: their names, and the arrays that they are read from.

use crate::ids::{IdRange, IdVec, RepeatId, SymbolId};
use crate::program::{Argument, ArrayLayout};
use std::ops::Range;

/// An unknown.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Its name, which is unique.
    pub name: String,
    /// The array that it is read from.
    pub argument: Argument,
    /// Its entry of the array.
    pub entry: usize,
    /// The repeated part that it belongs to, if any.
    pub repeat: Option<RepeatId>,
}

/// The unknowns of a chain, by their symbols in the graph.
#[derive(Clone, Debug, Default)]
pub struct Unknowns {
    all: IdVec<SymbolId, Unknown>,
    repetitions: IdVec<RepeatId, usize>,
    arguments: Vec<(Argument, ArrayLayout, IdRange<SymbolId>)>,
    quaternions: Vec<IdRange<SymbolId>>,
}

impl Unknowns {
    /// Returns an empty table for a chain whose parts have these numbers of repetitions.
    pub fn new(repetitions: IdVec<RepeatId, usize>) -> Self {
        Unknowns { repetitions, ..Unknowns::default() }
    }

    /// Adds the entries of an array, with their names.
    pub fn add(&mut self, argument: Argument, layout: ArrayLayout, names: Vec<String>) {
        if layout.entries() != names.len() {
            bug!("an array has {} entries and {} names", layout.entries(), names.len())
        }
        let first = self.all.len();
        for (entry, name) in names.into_iter().enumerate() {
            let repeat = layout.segment_of(entry).repeat;
            self.all.push(Unknown { name, argument, entry, repeat });
        }
        self.arguments.push((argument, layout, (first..self.all.len()).into()));
    }

    /// Marks entries of an argument as components of a quaternion.
    pub fn mark_quaternion(&mut self, argument: Argument, entries: Range<usize>) {
        let first = self.of(argument).first().index();
        self.quaternions.push((first + entries.start..first + entries.end).into());
    }

    /// Returns the number of the quaternion that an unknown is a component of, if it is.
    pub fn quaternion(&self, symbol: SymbolId) -> Option<usize> {
        self.quaternions.iter().position(|symbols| symbols.contains(symbol))
    }

    /// Returns the number of unknowns.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// Returns an unknown; none if the symbol is a loop-carried value.
    pub fn get(&self, symbol: SymbolId) -> Option<&Unknown> {
        self.all.as_slice().get(symbol.index())
    }

    /// Iterates over the unknowns in the order of their symbols.
    pub fn iter(&self) -> impl Iterator<Item = &Unknown> {
        self.all.iter()
    }

    /// Returns whether an argument has unknowns.
    pub fn has(&self, argument: Argument) -> bool {
        self.arguments.iter().any(|(other, ..)| *other == argument)
    }

    /// Returns the symbols of an argument's entries.
    pub fn of(&self, argument: Argument) -> IdRange<SymbolId> {
        match self.arguments.iter().find(|(other, ..)| *other == argument) {
            Some((_, _, symbols)) => *symbols,
            None => bug!("no unknown is read from {argument:?}"),
        }
    }

    /// Returns the name of an unknown, which must not be a loop-carried value.
    pub fn name(&self, symbol: SymbolId) -> String {
        self.all[symbol].name.clone()
    }

    /// Returns the repeated parts.
    pub fn parts(&self) -> IdRange<RepeatId> {
        self.repetitions.ids()
    }

    /// Returns the number of repetitions of a part.
    pub fn repetitions(&self, part: RepeatId) -> usize {
        self.repetitions[part]
    }

    /// Returns the layout of an argument.
    pub fn layout(&self, argument: Argument) -> ArrayLayout {
        match self.arguments.iter().find(|(other, ..)| *other == argument) {
            Some((_, layout, _)) => layout.clone(),
            None => bug!("no unknown is read from {argument:?}"),
        }
    }

    /// Iterates over the arguments with their layouts.
    pub fn arguments(&self) -> impl Iterator<Item = (Argument, &ArrayLayout)> {
        self.arguments.iter().map(|(argument, layout, _)| (*argument, layout))
    }
}
