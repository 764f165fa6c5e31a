//! The rates that move each body: those of the hinges between the ground and the body.
//!
//! In the order of `v`, the rates of a path are a few runs of consecutive indices; a chain without branches has one run.
//! Repeated parts have their runs once, and the path of a body goes from one repetition to the previous one.

use super::layouts;
use crate::ids::{BodyId, ChannelId, IdVec, LinkId, RepeatId};
use crate::model::{Chain, Layout, Link, MovesWith, RepeatBoundary};
use crate::program::ArrayLayout;

/// Consecutive rates on the path of a link, and how the path goes on toward the ground.
#[derive(Clone, Copy, Debug, Default)]
struct HingeRun {
    /// The index of its first rate, in the first repetition of a repeated part.
    first: usize,
    /// The number of its rates.
    count: usize,
    /// The number of rates from one repetition to the next.
    stride: usize,
    /// The repeated part of the rates.
    repeat: Option<RepeatId>,
    /// The next run.
    inboard: Option<usize>,
    /// The repetition in which the path goes on there, if it changes.
    enters: Option<usize>,
    /// The boundary at which all repetitions but the first go on in the previous one.
    previous: Option<(RepeatId, ChannelId)>,
}

/// The paths of all links to the ground.
#[derive(Clone, Debug)]
pub struct RatePaths {
    runs: Vec<HingeRun>,
    /// The run that the path of each link begins with.
    of_links: IdVec<LinkId, Option<usize>>,
    /// The runs inboard of the ends of repeated parts.
    ends: Vec<((RepeatId, ChannelId), Option<usize>)>,
}

impl RatePaths {
    /// Returns the paths of a chain, in its layout with a link for every body.
    pub fn of(chain: &Chain, layout: &Layout) -> Self {
        let rates = layouts::rates(chain, layout);
        let mut paths = RatePaths { runs: Vec::new(), of_links: IdVec::new(), ends: Vec::new() };
        for link in layout.links.iter() {
            let inboard = link.parent.and_then(|parent| paths.of_links[parent]);
            let run = match link.boundary {
                Some(boundary) => paths.boundary(chain, boundary, inboard),
                None => paths.link((layout, &rates), link, inboard),
            };
            paths.of_links.push(run);
        }
        paths
    }

    fn add(&mut self, run: HingeRun) -> Option<usize> {
        self.runs.push(run);
        Some(self.runs.len() - 1)
    }

    /// Returns the run of a boundary, which has no rates.
    fn boundary(
        &mut self,
        chain: &Chain,
        RepeatBoundary { repeat, channel, at_end }: RepeatBoundary,
        inboard: Option<usize>,
    ) -> Option<usize> {
        if at_end {
            self.ends.push(((repeat, channel), inboard));
            let enters = Some(chain.repeats[repeat].count - 1);
            return self.add(HingeRun { inboard, enters, ..HingeRun::default() });
        }
        self.add(HingeRun { inboard, previous: Some((repeat, channel)), ..HingeRun::default() })
    }

    /// Returns the run of a link: that of its parent, with the rates of the link's hinge if they follow or precede it.
    fn link(
        &mut self,
        (layout, rates): (&Layout, &ArrayLayout),
        link: &Link,
        inboard: Option<usize>,
    ) -> Option<usize> {
        let range = layout.v[link.hinge].clone();
        if range.is_empty() {
            return inboard;
        }
        let segment = rates.segment_of(range.start);
        let own = HingeRun {
            first: segment.offset + range.start - segment.first,
            count: range.len(),
            stride: if segment.repeat.is_some() { segment.count } else { 0 },
            repeat: segment.repeat,
            ..HingeRun::default()
        };
        let Some(parent) = inboard.map(|index| self.runs[index]) else { return self.add(own) };
        let HingeRun { inboard: next, enters, previous, .. } = parent;
        let further = HingeRun { inboard: next, enters, previous, ..own };
        let count = parent.count + own.count;
        let run = if parent.count == 0 {
            further
        } else if parent.repeat == own.repeat && parent.first + parent.count == own.first {
            HingeRun { first: parent.first, count, ..further }
        } else if parent.repeat == own.repeat && own.first + own.count == parent.first {
            HingeRun { count, ..further }
        } else {
            HingeRun { inboard, ..own }
        };
        self.add(run)
    }

    /// Returns the run that the path of a body begins with, counted from one; zero for a body on the ground.
    pub fn of_body(&self, layout: &Layout, body: BodyId) -> usize {
        match layout.parts[body] {
            MovesWith::Ground => 0,
            MovesWith::Link(link) => number(self.of_links[link]),
        }
    }

    /// Returns the runs: the index of the first rate, the number of rates and the number of rates from one repetition to
    /// the next; then links to other runs as the runtime reads them.
    pub fn rows(&self) -> Vec<([usize; 3], [usize; 3])> {
        let previous = |key| {
            let end = self.ends.iter().find(|(end, _)| *end == key);
            end.map_or_else(|| bug!("a repeated part has no end"), |(_, run)| number(*run))
        };
        let row = |run: &HingeRun| {
            let previous = run.previous.map_or(0, previous);
            let next = [number(run.inboard), number(run.enters), previous];
            ([run.first, run.count, run.stride], next)
        };
        self.runs.iter().map(row).collect()
    }
}

/// Returns an index counted from one, or zero for none.
fn number(index: Option<usize>) -> usize {
    index.map_or(0, |index| index + 1)
}
