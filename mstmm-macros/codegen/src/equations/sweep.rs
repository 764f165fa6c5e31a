//! Sweeps over the links of a chain: from the ground outward, from the free ends inward, and along
//! paths. Only the functions in this file loop over links, and only they handle the boundaries of
//! repeated parts. An algorithm therefore cannot forget a boundary.
//!
//! With plain numbers nothing happens at the boundaries: the chain is written out. The compiler
//! runs the equations of a repeated part once, for all repetitions. At the start of the part, a
//! sweep's values are replaced by unknowns for the values that any repetition passes to the next;
//! at the end, by unknowns for the values that the last repetition leaves. An outward sweep crosses
//! a boundary after the link at the boundary, an inward sweep before that link.

use crate::ids::IdVec;
use crate::math::Scalar;
use crate::model::{ChannelId, Layout, LinkId, RepeatBoundary, RepeatId};
use std::fmt::Debug;

/// One entry for each link.
pub type PerLink<T> = IdVec<LinkId, T>;

/// Replaces the values that sweeps carry across the boundaries of repeated parts.
pub trait LoopHook<S>: Debug {
    /// Returns the values that any repetition starts with, from the values that the first starts
    /// with.
    fn enter(&self, channel: Channel, inwards: bool, first: &[S]) -> Vec<S>;
    /// Returns the values after the last repetition, from the values after any repetition.
    fn leave(&self, channel: Channel, any: &[S]) -> Vec<S>;
}

/// A channel of a repeated part.
pub type Channel = (RepeatId, ChannelId);

/// A set of values that a sweep carries from link to link.
pub trait Flatten<S>: Clone {
    /// Returns the set with every value replaced that crosses boundaries, always in the same order.
    /// These are the values at the point of a link; values that belong to the hinge are not
    /// replaced.
    fn visit(self, replace: &mut dyn FnMut(S) -> S) -> Self;
}

/// The tree of a chain's links, rooted at the ground.
#[derive(Clone, Copy, Debug)]
pub struct LinkTree<'a, S> {
    layout: &'a Layout,
    hook: Option<&'a dyn LoopHook<S>>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum SweepDirection {
    Outward,
    Inward,
}

impl<'a, S: Scalar> LinkTree<'a, S> {
    /// Returns the tree of the links in `layout`, without loops over repetitions.
    pub fn new(layout: &'a Layout) -> Self {
        LinkTree { layout, hook: None }
    }

    /// Returns this tree with `hook` at the boundaries of repeated parts.
    pub fn with_loops(self, hook: &'a dyn LoopHook<S>) -> Self {
        LinkTree { hook: Some(hook), ..self }
    }

    /// Returns the hook at the boundaries of repeated parts, if there is one.
    pub fn hook(&self) -> Option<&'a dyn LoopHook<S>> {
        self.hook
    }

    /// Whether a repeated part begins or ends at a link.
    pub fn is_boundary(&self, link: LinkId) -> bool {
        self.layout.links[link].boundary.is_some()
    }

    /// Whether a link is in a repeated part whose equations run once for all repetitions.
    pub fn is_repeated(&self, link: LinkId) -> bool {
        self.hook.is_some() && self.layout.links[link].repeated
    }

    /// Returns the links from the ground to `last`.
    pub fn path_to(&self, last: LinkId) -> Vec<LinkId> {
        let parent = |&link: &LinkId| self.layout.links[link].parent;
        let mut path: Vec<LinkId> = std::iter::successors(Some(last), parent).collect();
        path.reverse();
        path
    }

    /// Returns the links whose parent is the ground.
    pub fn roots(&self) -> Vec<LinkId> {
        self.with_parent(None)
    }

    /// Returns the links whose parent is `link`.
    pub fn children_of(&self, link: LinkId) -> Vec<LinkId> {
        self.with_parent(Some(link))
    }

    fn with_parent(&self, parent: Option<LinkId>) -> Vec<LinkId> {
        let links = self.layout.links.enumerate();
        links.filter(|(_, link)| link.parent == parent).map(|(index, _)| index).collect()
    }

    /// Sweeps from the ground outward. `step` computes a link's values and a result from the values
    /// of its parent, which are `base` on the ground. Returns the values and the results, by links.
    pub fn outward<B: Flatten<S>, R>(
        &self,
        base: B,
        mut step: impl FnMut(LinkId, &B) -> (B, R),
    ) -> (PerLink<B>, PerLink<R>) {
        let mut carried = PerLink::new();
        let mut results = PerLink::new();
        for (link, layout) in self.layout.links.enumerate() {
            let parent = layout.parent.map_or(&base, |parent| &carried[parent]);
            let (own, result) = step(link, parent);
            carried.push(self.cross(link, SweepDirection::Outward, own));
            results.push(result);
        }
        (carried, results)
    }

    /// Sweeps from the free ends inward. `step` receives the values of a link (its entry in `own`
    /// plus what its children have added), adds to the values of the link's parent and returns a
    /// result. Returns the results, by links, and the values that have reached the ground, which
    /// start as `base`.
    pub fn inward<B: Flatten<S>, R>(
        &self,
        mut own: PerLink<B>,
        mut base: B,
        mut step: impl FnMut(LinkId, B, &mut B) -> R,
    ) -> (PerLink<R>, B) {
        if own.len() != self.layout.links.len() {
            bug!("a sweep over {} links starts with {}", self.layout.links.len(), own.len())
        }
        let mut results = Vec::new();
        for (link, layout) in self.layout.links.enumerate().rev() {
            let Some(gathered) = own.pop() else { bug!("a sweep starts without {link:?}") };
            let here = self.cross(link, SweepDirection::Inward, gathered);
            let parent = layout.parent.map_or(&mut base, |parent| &mut own[parent]);
            results.push(step(link, here, parent));
        }
        results.reverse();
        (results.into(), base)
    }

    /// Runs `step` over all links in order, with a running total.
    pub fn total<B: Flatten<S>>(&self, start: B, mut step: impl FnMut(LinkId, B) -> B) -> B {
        let all: Vec<LinkId> = self.layout.links.ids().into_iter().collect();
        self.along(&all, start, |link, total| (step(link, total), ())).0
    }

    /// Sweeps outward along a path; each link takes the values of the link before it. Returns the
    /// values of the last link, and the results with their links.
    pub fn along<B: Flatten<S>, R>(
        &self,
        path: &[LinkId],
        start: B,
        mut step: impl FnMut(LinkId, B) -> (B, R),
    ) -> (B, Vec<(LinkId, R)>) {
        let mut carried = start;
        let mut results = Vec::new();
        for &link in path {
            let (own, result) = step(link, carried);
            carried = self.cross_route(link, SweepDirection::Outward, own);
            results.push((link, result));
        }
        (carried, results)
    }

    /// Sweeps back along the same path. `step` receives the result that the outward sweep has left
    /// at the link.
    pub fn back_along<B: Flatten<S>, T, R>(
        &self,
        path: &[(LinkId, T)],
        start: B,
        mut step: impl FnMut(LinkId, &T, B) -> (B, R),
    ) -> (B, Vec<(LinkId, R)>) {
        let mut carried = start;
        let mut results = Vec::new();
        for (link, left) in path.iter().rev() {
            let (own, result) =
                step(*link, left, self.cross_route(*link, SweepDirection::Inward, carried));
            carried = own;
            results.push((*link, result));
        }
        results.reverse();
        (carried, results)
    }

    /// Carries a value inward along a path without boundaries, from its last link to the ground or to the link before the path.
    /// `step` carries it across the hinge of a link.
    pub fn carry_inward<B>(
        &self,
        path: &[LinkId],
        start: B,
        mut step: impl FnMut(LinkId, B) -> B,
    ) -> B {
        path.iter().rev().fold(start, |carried, &link| step(self.inside(link), carried))
    }

    /// Carries a value outward along a path without boundaries, to its last link. `step` carries it across the hinge of a link.
    pub fn carry_outward<B>(
        &self,
        path: &[LinkId],
        start: B,
        mut step: impl FnMut(LinkId, B) -> B,
    ) -> B {
        path.iter().fold(start, |carried, &link| step(self.inside(link), carried))
    }

    /// Returns a link, which is not at a boundary.
    fn inside(&self, link: LinkId) -> LinkId {
        if self.hook.is_some() && self.is_boundary(link) {
            bug!("a value is carried across a boundary of a repeated part")
        }
        link
    }

    /// Crosses a boundary with values that pass from link to link on a path, which enter and leave a
    /// repeated part once.
    fn cross_route<B: Flatten<S>>(&self, link: LinkId, direction: SweepDirection, carried: B) -> B {
        match self.layout.links[link].boundary {
            Some(RepeatBoundary { channel, .. }) if channel != ChannelId(0) => carried,
            _ => self.cross(link, direction, carried),
        }
    }

    /// Returns the values on the other side of a link, which differ at the boundary of a repeated
    /// part.
    fn cross<B: Flatten<S>>(&self, link: LinkId, direction: SweepDirection, carried: B) -> B {
        let (Some(RepeatBoundary { repeat, channel, at_end }), Some(hook)) =
            (self.layout.links[link].boundary, self.hook)
        else {
            return carried;
        };
        let inward = direction == SweepDirection::Inward;
        let hook = |values: &[S]| {
            if at_end == inward {
                hook.enter((repeat, channel), inward, values)
            } else {
                hook.leave((repeat, channel), values)
            }
        };
        replaced(carried, hook)
    }

    /// Runs `step` for the repetitions of a part, outward or inward, with values that no link carries.
    /// The first repetition in this direction starts with `first`, each other one with the values that
    /// `step` returns for the repetition before it. Returns the values of the last repetition, and the
    /// result.
    pub fn through<B: Flatten<S>, R>(
        &self,
        (repeat, inward): (RepeatId, bool),
        first: B,
        step: impl FnOnce(B) -> (B, R),
    ) -> (B, R) {
        let Some(hook) = self.hook else { return step(first) };
        let start = replaced(first, |values| hook.enter((repeat, APART), inward, values));
        let (next, result) = step(start);
        (replaced(next, |values| hook.leave((repeat, APART), values)), result)
    }
}

/// The channel of values that no link carries.
const APART: ChannelId = ChannelId(usize::MAX);

/// Returns a set with all its values replaced. Without values no loop is needed.
fn replaced<S: Scalar, B: Flatten<S>>(set: B, replace: impl FnOnce(&[S]) -> Vec<S>) -> B {
    let mut values = Vec::new();
    set.clone().visit(&mut |number| {
        values.push(number);
        number
    });
    if values.is_empty() {
        return set;
    }
    let replaced = replace(&values);
    if replaced.len() != values.len() {
        bug!("{} numbers reach a boundary, {} leave it", values.len(), replaced.len())
    }
    let mut replaced = replaced.into_iter();
    set.visit(&mut |_| {
        replaced.next().unwrap_or_else(|| bug!("fewer numbers leave a boundary than reach it"))
    })
}

#[cfg(test)]
mod tests;
