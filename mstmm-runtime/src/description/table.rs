//! Tables whose rows are repeated in runs.

use core::ops::Range;

/// Rows, each with some entries in an array. A run of rows may be repeated: in the array all rows of its first
/// repetition precede those of the second one.
#[derive(Debug)]
pub struct Table<R: 'static> {
    rows: &'static [R],
    /// Numbers of rows and of their repetitions; empty if all rows occur once.
    runs: &'static [[usize; 2]],
}

impl<R> Clone for Table<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Table<R> {}

/// An entry of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry<R: 'static> {
    /// Its row.
    pub row: &'static R,
    /// The index of its row.
    pub number: usize,
    /// The repetition; zero if the row occurs once.
    pub repetition: usize,
    /// Its index among the entries of its row.
    pub entry: usize,
}

/// A run of rows with its place in an array.
struct Run<R: 'static> {
    rows: &'static [R],
    /// The index of its first row.
    number: usize,
    repetitions: usize,
    /// The index of its first entry.
    first: usize,
    /// The number of its entries in one repetition.
    stride: usize,
}

impl<R> Table<R> {
    /// The table without rows.
    pub const EMPTY: Self = Table { rows: &[], runs: &[] };

    /// Makes a table whose rows occur once.
    pub const fn new(rows: &'static [R]) -> Self {
        Table { rows, runs: &[] }
    }

    /// Repeats runs of rows.
    pub const fn repeated(self, runs: &'static [[usize; 2]]) -> Self {
        Table { rows: self.rows, runs }
    }

    /// Returns the number of all entries.
    pub fn len(self, count: fn(&R) -> usize) -> usize {
        self.runs(count).last().map_or(0, |run| run.first + run.stride * run.repetitions)
    }

    /// Returns the entry at an index of the array.
    pub fn entry(self, index: usize, count: fn(&R) -> usize) -> Option<Entry<R>> {
        let run = self.runs(count).find(|run| index < run.first + run.stride * run.repetitions)?;
        let (repetition, mut entry) =
            ((index - run.first) / run.stride, (index - run.first) % run.stride);
        for (number, row) in run.rows.iter().enumerate() {
            if entry < count(row) {
                return Some(Entry { row, number: run.number + number, repetition, entry });
            }
            entry -= count(row);
        }
        None
    }

    /// Returns the range of the entries of an item: of a row in one of its repetitions. Items are counted as rows are
    /// repeated.
    pub fn range(self, item: usize, count: fn(&R) -> usize) -> Option<Range<usize>> {
        let Entry { row, number, repetition, .. } = self.entry(item, |_| 1)?;
        let first = self.first_of(number, repetition, count)?;
        Some(first..first + count(row))
    }

    /// Returns the index of the first entry of a row in a repetition.
    pub fn first_of(
        self,
        number: usize,
        repetition: usize,
        count: fn(&R) -> usize,
    ) -> Option<usize> {
        let run = self.runs(count).find(|run| number < run.number + run.rows.len())?;
        let before = run.rows.get(..number - run.number)?;
        let within = before.iter().map(count).sum::<usize>();
        (repetition < run.repetitions).then_some(run.first + repetition * run.stride + within)
    }

    /// Returns the rows with their indices.
    pub fn rows(self) -> impl Iterator<Item = (usize, &'static R)> {
        self.rows.iter().enumerate()
    }

    fn runs(self, count: fn(&R) -> usize) -> impl Iterator<Item = Run<R>> {
        let all = [self.rows.len(), 1];
        let once = self.runs.is_empty().then_some(all);
        let (mut number, mut first) = (0, 0);
        self.runs.iter().copied().chain(once).filter_map(move |[length, repetitions]| {
            let rows = self.rows.get(number..number + length)?;
            let stride = rows.iter().map(count).sum();
            let run = Run { rows, number, repetitions, first, stride };
            number += length;
            first += stride * repetitions;
            Some(run)
        })
    }
}
