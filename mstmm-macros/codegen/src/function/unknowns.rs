//! The unknowns of a chain's functions: their names, and where they are read.

use crate::ids::RepeatId;
use crate::program::{Argument, ArrayLayout};
use std::ops::Range;

/// An unknown.
#[derive(Clone, Debug)]
pub struct Unknown {
    /// Its name, which no other has.
    pub name: String,
    /// The array that it is read from.
    pub argument: Argument,
    /// Which entry of the array it is.
    pub entry: usize,
    /// The repeated part that it belongs to.
    pub repeat: Option<RepeatId>,
}

/// All unknowns, by the numbers of their symbols in the graph.
#[derive(Clone, Debug, Default)]
pub struct Unknowns {
    all: Vec<Unknown>,
    repetitions: Vec<usize>,
    arguments: Vec<(Argument, ArrayLayout, Range<usize>)>,
}

impl Unknowns {
    /// None yet, of a chain whose parts are repeated so often.
    pub fn new(repetitions: Vec<usize>) -> Self {
        Unknowns { repetitions, ..Unknowns::default() }
    }

    /// Adds an array with the names of its entries.
    pub fn add(&mut self, argument: Argument, layout: ArrayLayout, names: Vec<String>) {
        if layout.entries() != names.len() {
            bug!("an array has {} entries and {} names", layout.entries(), names.len())
        }
        let first = self.all.len();
        for (entry, name) in names.into_iter().enumerate() {
            let repeat = layout.segment_of(entry).repeat;
            self.all.push(Unknown { name, argument, entry, repeat });
        }
        self.arguments.push((argument, layout, first..self.all.len()));
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.all.len()
    }

    /// The one with a number; none for what a loop carries.
    pub fn get(&self, number: u32) -> Option<&Unknown> {
        self.all.get(number as usize)
    }

    /// All of them, by number.
    pub fn iter(&self) -> impl Iterator<Item = &Unknown> {
        self.all.iter()
    }

    /// Whether an array has unknowns.
    pub fn has(&self, argument: Argument) -> bool {
        self.arguments.iter().any(|(other, ..)| *other == argument)
    }

    /// The numbers of an array's entries.
    pub fn of(&self, argument: Argument) -> Range<usize> {
        match self.arguments.iter().find(|(other, ..)| *other == argument) {
            Some((_, _, range)) => range.clone(),
            None => bug!("no unknown is read from {argument:?}"),
        }
    }

    /// The name of an unknown that is none of those that loops carry.
    pub fn name(&self, number: u32) -> String {
        self.all[number as usize].name.clone()
    }

    /// How often a part is repeated.
    pub fn repetitions(&self, part: RepeatId) -> usize {
        self.repetitions[part.index()]
    }

    /// The layout of an array of unknowns.
    pub fn layout(&self, argument: Argument) -> ArrayLayout {
        match self.arguments.iter().find(|(other, ..)| *other == argument) {
            Some((_, layout, _)) => layout.clone(),
            None => bug!("no unknown is read from {argument:?}"),
        }
    }

    /// All arrays with their layouts.
    pub fn arguments(&self) -> impl Iterator<Item = (Argument, &ArrayLayout)> {
        self.arguments.iter().map(|(argument, layout, _)| (*argument, layout))
    }
}
