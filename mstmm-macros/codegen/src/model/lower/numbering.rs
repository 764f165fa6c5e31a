//! The ids of the bodies and hinges of the route.

use std::ops::Range;

use super::properties;
use super::route::RouteItem;
use crate::ids::IdRange;
use crate::model::{BodyId, HingeId};

/// The numbers of bodies, moving ends and hinges before each item, and before the end of the route.
pub(super) struct Numbering {
    before: Vec<Counts>,
    /// Whether each item is a moving end.
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
    pub fn of(items: &[RouteItem]) -> Self {
        let mut counts = Counts::default();
        let mut before = vec![counts];
        for item in items {
            match item {
                RouteItem::Body { .. } => counts.bodies += 1,
                RouteItem::Moving { .. } => counts.ends += 1,
                RouteItem::Hinge { .. } => counts.hinges += 1,
                RouteItem::Ground { .. }
                | RouteItem::Unknown { .. }
                | RouteItem::Duplicate { .. } => {}
            }
            before.push(counts);
        }
        let moving = items.iter().map(|item| matches!(item, RouteItem::Moving { .. })).collect();
        let implied = if properties::floats(items) { 1 } else { counts.ends };
        Numbering { before, moving, on_route: counts.bodies, implied }
    }

    /// The body of a stop that is a body or a moving end.
    pub fn body(&self, item: usize) -> BodyId {
        let Counts { bodies, ends, .. } = self.before[item];
        BodyId(if self.moving[item] { self.on_route + ends } else { bodies })
    }

    /// The bodies among these items.
    pub fn bodies(&self, items: Range<usize>) -> IdRange<BodyId> {
        (self.before[items.start].bodies..self.before[items.end].bodies).into()
    }

    /// The hinges among these items.
    pub fn hinges(&self, items: Range<usize>) -> IdRange<HingeId> {
        let hinge = |item: usize| self.implied + self.before[item].hinges;
        (hinge(items.start)..hinge(items.end)).into()
    }

    /// The elements among these items, as the route counts them.
    pub fn elements(&self, items: Range<usize>) -> Range<usize> {
        let element = |item: usize| self.before[item].bodies + self.before[item].hinges;
        element(items.start)..element(items.end)
    }
}
