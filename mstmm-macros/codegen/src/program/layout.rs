//! The layout of arrays, in which the entries of a repeated part follow one another repetition by repetition.

use crate::ids::RepeatId;

/// The layout of an array.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArrayLayout {
    /// The length of the array.
    pub total: usize,
    /// Its segments, in order.
    pub segments: Vec<Segment>,
}

/// Consecutive entries that belong to the same repeated part, or to none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The index of its first entry; entries of a repeated part count once.
    pub first: usize,
    /// The number of its entries.
    pub count: usize,
    /// The index in the array at which it starts.
    pub offset: usize,
    /// The repeated part that it belongs to, if any.
    pub repeat: Option<RepeatId>,
    /// The number of repetitions of its entries in the array.
    pub repetitions: usize,
}

/// The indices of an entry in the array, one for each repetition of its part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strided {
    /// The index in the first repetition.
    pub first: usize,
    /// The number of entries from one repetition to the next.
    pub stride: usize,
    /// The number of repetitions.
    pub count: usize,
}

impl ArrayLayout {
    /// Returns the indices of an entry, which is given by its index in the layout.
    pub fn strided(&self, entry: usize) -> Strided {
        let &Segment { first, count, offset, repetitions, .. } = self.segment_of(entry);
        Strided { first: offset + entry - first, stride: count, count: repetitions }
    }

    /// Returns the layout of items, each with its number of entries, its repeated part, and the number of repetitions of
    /// that part.
    pub fn of(items: impl IntoIterator<Item = (usize, Option<(RepeatId, usize)>)>) -> Self {
        let mut segments: Vec<Segment> = Vec::new();
        let (mut first, mut offset) = (0, 0);
        for (count, part) in items.into_iter().filter(|(count, _)| *count > 0) {
            let (repeat, repetitions) = (part.map(|(repeat, _)| repeat), part.map_or(1, |it| it.1));
            match segments.last_mut() {
                Some(last) if last.repeat == repeat => last.count += count,
                _ => segments.push(Segment { first, count, offset, repeat, repetitions }),
            }
            first += count;
            offset += count * repetitions;
        }
        ArrayLayout { total: offset, segments }
    }

    /// Returns the layout of entries outside of repeated parts.
    pub fn once(count: usize) -> Self {
        ArrayLayout::of([(count, None)])
    }

    /// Returns the layout of entries of one repeated part.
    pub fn each(count: usize, repeat: RepeatId, repetitions: usize) -> Self {
        ArrayLayout::of([(count, Some((repeat, repetitions)))])
    }

    /// Returns the number of entries; entries of repeated parts count once.
    pub fn entries(&self) -> usize {
        self.segments.iter().map(|segment| segment.count).sum()
    }

    /// Returns the segment that an entry belongs to.
    pub fn segment_of(&self, entry: usize) -> &Segment {
        let segment = self.segments.iter().find(|segment| segment.entries().contains(&entry));
        segment.unwrap_or_else(|| bug!("entry {entry} of an array is in none of its segments"))
    }
}

impl Segment {
    /// Returns the range of its entries.
    pub fn entries(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }
}
