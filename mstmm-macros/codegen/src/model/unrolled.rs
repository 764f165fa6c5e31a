//! A chain with its repeated parts written out.

use super::{
    Attachment, BodyId, BodyPoint, Chain, Element, FromPrevious, HingeId, Repeat, RepeatId, Role,
    Spring, SpringEnd,
};
use crate::ids::{Id, IdRange, IdVec};
use std::collections::HashMap;

impl Chain {
    /// How many elements there are with all repeated parts written out up to `most` times.
    pub fn count_elements(&self, most: usize) -> usize {
        let repeated = self.repeats.iter();
        let more = repeated.map(|repeat| repeat.elements.len() * (repeat.count.min(most) - 1));
        self.elements.len() + more.sum::<usize>()
    }

    /// Returns the same chain with up to `most` repetitions of each part written out. It has no
    /// loads and no springs, and its names are not unique;
    /// [`unrolled_springs`](Self::unrolled_springs) has the springs.
    pub fn unrolled(&self, most: usize) -> Chain {
        let bodies = self.copies_of_bodies(most);
        let hinges = Copies::of(
            self,
            most,
            self.hinges.ids(),
            |repeat| repeat.hinges,
            |hinge| self.repeat_boundary(&self.hinges[hinge].outboard).is_some(),
        );
        let unrolled = Unrolled { chain: self, most, bodies: &bodies };
        let copy = |&(hinge, repetition): &(HingeId, usize)| {
            let original = &self.hinges[hinge];
            let mut copy = original.clone();
            copy.inboard = unrolled.attachment(hinge, &original.inboard, repetition);
            copy.outboard = unrolled.attachment(hinge, &original.outboard, repetition);
            copy
        };
        Chain {
            bodies: bodies.order.iter().map(|&(body, _)| self.bodies[body].clone()).collect(),
            hinges: hinges.order.iter().map(copy).collect(),
            elements: self.elements_of_all(most, &bodies, &hinges),
            repeats: IdVec::new(),
            loads: IdVec::new(),
            springs: IdVec::new(),
            ..self.clone()
        }
    }

    /// Returns the springs on the bodies of the unrolled chain, each spring of a repeated part once for each
    /// repetition.
    pub fn unrolled_springs(&self, most: usize) -> Vec<Spring> {
        let bodies = self.copies_of_bodies(most);
        let unrolled = Unrolled { chain: self, most, bodies: &bodies };
        let copies = self.springs.iter().flat_map(|spring| {
            let repeat = self.repeat_of_body(spring.on.body);
            let count = repeat.map_or(1, |repeat| self.repeats[repeat].count.min(most));
            (0..count).map(|repetition| unrolled.spring(spring, repetition)).collect::<Vec<_>>()
        });
        copies.collect()
    }

    fn copies_of_bodies(&self, most: usize) -> Copies<BodyId> {
        Copies::of(
            self,
            most,
            self.bodies.ids(),
            |repeat| repeat.bodies,
            |body| matches!(self.bodies[body].role, Role::RepeatBoundary(_)),
        )
    }

    fn elements_of_all(
        &self,
        most: usize,
        bodies: &Copies<BodyId>,
        hinges: &Copies<HingeId>,
    ) -> Vec<Element> {
        let copy = |element: Element, repetition: usize| match element {
            Element::Body(body) => Element::Body(bodies.copy(body, repetition)),
            Element::Hinge(hinge) => Element::Hinge(hinges.copy(hinge, repetition)),
        };
        let mut elements = Vec::new();
        let mut next = 0;
        for repeat in &self.repeats {
            let part = repeat.elements.clone();
            elements.extend(self.elements[next..part.start].iter().map(|&it| copy(it, 0)));
            for repetition in 0..repeat.count.min(most) {
                elements.extend(self.elements[part.clone()].iter().map(|&it| copy(it, repetition)));
            }
            next = part.end;
        }
        elements.extend(self.elements[next..].iter().map(|&it| copy(it, 0)));
        elements
    }

    /// Returns the attachment inboard of the boundaries at `attachment`, or `attachment` itself. Two
    /// boundaries follow each other between two repeated parts.
    pub fn before_boundary<'a>(&'a self, mut attachment: &'a Attachment) -> &'a Attachment {
        while let Some(boundary) = self.repeat_boundary(attachment) {
            attachment = &self.hinges[self.weld_of(boundary)].inboard;
        }
        attachment
    }
}

/// The copies of bodies or of hinges: each with its original and its repetition.
struct Copies<I> {
    order: Vec<(I, usize)>,
    indices: HashMap<(I, usize), usize>,
}

impl<I: Id + std::hash::Hash> Copies<I> {
    /// Copies everything but boundaries; a repeated part is copied repetition by repetition.
    fn of(
        chain: &Chain,
        most: usize,
        ids: IdRange<I>,
        range: impl Fn(&Repeat) -> IdRange<I>,
        is_boundary: impl Fn(I) -> bool,
    ) -> Self {
        let mut order: Vec<(I, usize)> = Vec::new();
        for id in ids.into_iter().filter(|&id| !is_boundary(id)) {
            match chain.repeats.iter().find(|repeat| range(repeat).contains(id)) {
                None => order.push((id, 0)),
                Some(repeat) if range(repeat).first() == id => {
                    for repetition in 0..repeat.count.min(most) {
                        order.extend(range(repeat).into_iter().map(|id| (id, repetition)));
                    }
                }
                Some(_) => {}
            }
        }
        let indices = order.iter().enumerate().map(|(index, &key)| (key, index)).collect();
        Copies { order, indices }
    }

    /// Returns the copy of an original.
    fn copy(&self, original: I, repetition: usize) -> I {
        let found = self.indices.get(&(original, repetition));
        I::new(*found.unwrap_or_else(|| bug!("a repetition has no copy of an element")))
    }
}

/// Finds the attachments of copied hinges and springs.
struct Unrolled<'a> {
    chain: &'a Chain,
    most: usize,
    bodies: &'a Copies<BodyId>,
}

impl Unrolled<'_> {
    /// Returns the attachment of one side of a hinge in a repetition.
    fn attachment(&self, hinge: HingeId, original: &Attachment, repetition: usize) -> Attachment {
        let chain = self.chain;
        let from = chain.repeat_of_hinge(hinge);
        let place = match (chain.repeat_boundary(original), from) {
            (Some(boundary), Some(repeat)) if repetition > 0 && boundary.repeat == repeat => {
                return self.on_copy(&self.previous(repeat, hinge), Some(repeat), repetition - 1);
            }
            _ => chain.before_boundary(original),
        };
        self.on_copy(place, from, repetition)
    }

    /// Returns the place of the previous repetition that a hinge of a repeated part leaves.
    fn previous(&self, repeat: RepeatId, hinge: HingeId) -> Attachment {
        let Repeat { last_body, from_previous, .. } = &self.chain.repeats[repeat];
        let other = from_previous.iter().find(|from: &&FromPrevious| from.hinge == hinge);
        other.map_or(Attachment::Output(*last_body), |from| from.previous.clone())
    }

    /// Returns a place on the copy of its body: in the same repetition if the hinge is in the same
    /// repeated part, else in the last one.
    fn on_copy(&self, place: &Attachment, from: Option<RepeatId>, repetition: usize) -> Attachment {
        let Some(body) = place.body() else { return place.clone() };
        place.on(self.body(body, from, repetition))
    }

    /// Returns the copy of a body: in the same repetition if it is in the repeated part `from`, else
    /// in the last one.
    fn body(&self, body: BodyId, from: Option<RepeatId>, repetition: usize) -> BodyId {
        let repetition = match self.chain.repeat_of_body(body) {
            None => 0,
            of_body if of_body == from => repetition,
            Some(repeat) => self.chain.repeats[repeat].count.min(self.most) - 1,
        };
        self.bodies.copy(body, repetition)
    }

    /// Returns the copy of a spring in a repetition.
    fn spring(&self, spring: &Spring, repetition: usize) -> Spring {
        let from = self.chain.repeat_of_body(spring.on.body);
        let point = |point: &BodyPoint, repetition| BodyPoint {
            body: self.body(point.body, from, repetition),
            at: point.at.clone(),
        };
        let to = match &spring.to {
            SpringEnd::Ground(at) => SpringEnd::Ground(at.clone()),
            SpringEnd::Body(to) => SpringEnd::Body(point(to, repetition)),
            SpringEnd::Previous { point: to, first } => SpringEnd::Body(match repetition {
                0 => point(first, 0),
                later => point(to, later - 1),
            }),
        };
        Spring { on: point(&spring.on, repetition), to, ..spring.clone() }
    }
}
