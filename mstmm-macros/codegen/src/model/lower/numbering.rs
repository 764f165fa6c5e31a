//! The ids of the bodies and hinges of all routes.

use std::ops::Range;

use super::parts::WrittenOut;
use super::properties;
use super::route_item::RouteItem;
use crate::ids::IdRange;
use crate::model::{BodyId, HingeId};

/// The numbers of bodies, moving ends and hinges before each item, and before the end of all routes.
pub(super) struct Numbering {
    before: Vec<Counts>,
    /// Whether each item is a moving end.
    moving: Vec<bool>,
    /// How many bodies are on routes.
    on_routes: usize,
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
    /// Bodies in the order of the routes, then those of the moving ends; implied hinges, then those
    /// of the routes.
    pub fn of(written: &WrittenOut, items: &[RouteItem]) -> Self {
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
        let floats = properties::floats(written, items);
        let implied = counts.ends + usize::from(floats);
        Numbering { before, moving, on_routes: counts.bodies, implied }
    }

    /// The body of an item that is a body or a moving end.
    pub fn body(&self, item: usize) -> BodyId {
        let Counts { bodies, ends, .. } = self.before[item];
        BodyId(if self.moving[item] { self.on_routes + ends } else { bodies })
    }

    /// The hinge of an item that is a hinge.
    pub fn hinge(&self, item: usize) -> HingeId {
        HingeId(self.implied + self.before[item].hinges)
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

    /// The elements among these items, as the routes count them.
    pub fn elements(&self, items: Range<usize>) -> Range<usize> {
        let element = |item: usize| self.before[item].bodies + self.before[item].hinges;
        element(items.start)..element(items.end)
    }
}
