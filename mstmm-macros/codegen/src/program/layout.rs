//! Where the numbers of an array lie: those of a repeated part once for every repetition.

use crate::ids::RepeatId;

/// How an array is laid out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ArrayLayout {
    /// How many numbers the array holds.
    pub total: usize,
    /// Its segments, in their order.
    pub segments: Vec<Segment>,
}

/// Neighbouring numbers that belong to the same repeated part, or to none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// The number of its first entry; entries count a repeated part once.
    pub first: usize,
    /// How many entries it has.
    pub count: usize,
    /// Where its numbers begin in the array.
    pub offset: usize,
    /// The repeated part that it belongs to.
    pub repeat: Option<RepeatId>,
    /// How often its entries follow on each other in the array.
    pub repetitions: usize,
}

impl ArrayLayout {
    /// The layout of items, each with so many numbers, and with its repeated part and how often that is
    /// repeated.
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

    /// So many numbers that stand once.
    pub fn once(count: usize) -> Self {
        ArrayLayout::of([(count, None)])
    }

    /// So many numbers for every repetition of one part.
    pub fn each(count: usize, repeat: RepeatId, repetitions: usize) -> Self {
        ArrayLayout::of([(count, Some((repeat, repetitions)))])
    }

    /// How many entries there are.
    pub fn entries(&self) -> usize {
        self.segments.iter().map(|segment| segment.count).sum()
    }

    /// The segment that an entry belongs to.
    pub fn segment_of(&self, entry: usize) -> &Segment {
        let segment = self.segments.iter().find(|segment| segment.entries().contains(&entry));
        segment.unwrap_or_else(|| bug!("entry {entry} of an array is in none of its segments"))
    }
}

impl Segment {
    /// The numbers of its entries.
    pub fn entries(&self) -> std::ops::Range<usize> {
        self.first..self.first + self.count
    }
}
