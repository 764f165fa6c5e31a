//! Which body and which hinge of the model each stop of the route is.

use std::ops::Range;

use super::properties;
use super::route::RouteItem;
use crate::ids::IdRange;
use crate::model::{BodyId, HingeId};

/// How many bodies, moving ends and hinges stand before each stop, and before the end of the route.
pub(super) struct Numbering {
    before: Vec<Counts>,
    /// Which stops are moving ends.
    moving: Vec<bool>,
    /// How many bodies are on the route.
    on_route: usize,
    /// How many hinges are implied.
    implied: usize,
}

#[derive(Clone, Copy, Default)]
struct Counts {
    bodies: usize,
    ends: usize,
    hinges: usize,
}

impl Numbering {
    /// Bodies in the order of the route, then those of the moving ends; implied hinges, then those
    /// of the route.
    pub fn of(stops: &[RouteItem]) -> Self {
        let mut counts = Counts::default();
        let mut before = vec![counts];
        for stop in stops {
            match stop {
                RouteItem::Body { .. } => counts.bodies += 1,
                RouteItem::Moving { .. } => counts.ends += 1,
                RouteItem::Hinge { .. } => counts.hinges += 1,
                RouteItem::Ground { .. } | RouteItem::Unknown { .. } | RouteItem::Again { .. } => {}
            }
            before.push(counts);
        }
        let moving = stops.iter().map(|stop| matches!(stop, RouteItem::Moving { .. })).collect();
        let implied = if properties::floats(stops) { 1 } else { counts.ends };
        Numbering { before, moving, on_route: counts.bodies, implied }
    }

    /// The body of a stop that is a body or a moving end.
    pub fn body(&self, stop: usize) -> BodyId {
        let Counts { bodies, ends, .. } = self.before[stop];
        BodyId(if self.moving[stop] { self.on_route + ends } else { bodies })
    }

    /// The bodies among these stops.
    pub fn bodies(&self, stops: Range<usize>) -> IdRange<BodyId> {
        (self.before[stops.start].bodies..self.before[stops.end].bodies).into()
    }

    /// The hinges among these stops.
    pub fn hinges(&self, stops: Range<usize>) -> IdRange<HingeId> {
        let hinge = |stop: usize| self.implied + self.before[stop].hinges;
        (hinge(stops.start)..hinge(stops.end)).into()
    }

    /// The elements among these stops, as the route counts them.
    pub fn elements(&self, stops: Range<usize>) -> Range<usize> {
        let element = |stop: usize| self.before[stop].bodies + self.before[stop].hinges;
        element(stops.start)..element(stops.end)
    }
}
