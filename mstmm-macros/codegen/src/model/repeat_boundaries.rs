//! Boundaries of repeated parts: a massless body is welded in where a part begins and where it
//! ends. Everything that the part exchanges with its surroundings passes through them, so each
//! repetition is the same.

use super::{
    About, Attachment, Body, BodyId, Chain, Frame, Hinge, HingeId, HingeKind, Inertia,
    PresentPoints, RepeatBoundary, RepeatId, Role, Value,
};
use super::{Drive, Element, InputKind};
use proc_macro2::Span;
use quote::format_ident;

/// Returns the chain with a massless body at each boundary.
pub(super) fn with_repeat_boundaries(mut chain: Chain) -> Chain {
    for repeat in chain.repeats.ids() {
        let part = chain.repeats[repeat].clone();
        let first = part.hinges.first();
        let last = part.bodies.last();
        let before = chain.hinges[first].inboard.clone();
        let start = add_boundary(&mut chain, RepeatBoundary { repeat, at_end: false }, before);
        chain.hinges[first].inboard = Attachment::Input(start);
        let outboard_end = Attachment::Output(last);
        let next = chain.hinges.position(|hinge| hinge.inboard == outboard_end);
        let end = add_boundary(&mut chain, RepeatBoundary { repeat, at_end: true }, outboard_end);
        if let Some(next) = next {
            chain.hinges[next].inboard = Attachment::Input(end);
        }
    }
    chain
}

/// Welds a boundary to an attachment.
fn add_boundary(chain: &mut Chain, boundary: RepeatBoundary, at: Attachment) -> BodyId {
    let word = if boundary.at_end { "end" } else { "start" };
    let name =
        format_ident!("{word}_of_repeat{}", boundary.repeat.index(), span = Span::call_site());
    let zero = || Value::number(0.0);
    let body = chain.bodies.push(Body {
        name: name.clone(),
        path: name.to_string(),
        type_name: name.clone(),
        result_name: name.clone(),
        mass: zero(),
        com: [(); 3].map(|()| zero()),
        inertia: Inertia { tensor: [(); 6].map(|()| zero()), about: About::Com },
        output: Frame::identity(),
        points: Vec::new(),
        present: PresentPoints::ALL,
        role: Role::RepeatBoundary(boundary),
    });
    chain.hinges.push(Hinge {
        path: name.to_string(),
        name,
        kind: HingeKind::Weld,
        inboard: at,
        outboard: Attachment::Input(body),
        start: Vec::new(),
        start_rate: Vec::new(),
        rest: Vec::new(),
        drive: Drive::Efforts(Vec::new()),
        passive: Vec::new(),
    });
    body
}

impl Chain {
    /// Returns the boundary at an attachment.
    pub fn repeat_boundary(&self, attachment: &Attachment) -> Option<RepeatBoundary> {
        match self.bodies[attachment.body()?].role {
            Role::RepeatBoundary(boundary) => Some(boundary),
            Role::Physical | Role::MovingEnd => None,
        }
    }

    /// Returns the weld between a boundary and the body inboard of it.
    pub fn weld_of(&self, boundary: RepeatBoundary) -> HingeId {
        let is_it = |hinge: &Hinge| self.repeat_boundary(&hinge.outboard) == Some(boundary);
        self.hinges.position(is_it).unwrap_or_else(|| bug!("{boundary:?} is welded to nothing"))
    }

    /// Returns the repeated part of a hinge.
    pub fn repeat_of_hinge(&self, hinge: HingeId) -> Option<RepeatId> {
        self.repeats.position(|repeat| repeat.hinges.contains(hinge))
    }

    /// Returns whether a hinge belongs to a repeated part, or is the weld of its end.
    pub fn lies_in_repeat(&self, hinge: HingeId, repeat: RepeatId) -> bool {
        self.repeats[repeat].hinges.contains(hinge)
            || self.repeat_boundary(&self.hinges[hinge].outboard)
                == Some(RepeatBoundary { repeat, at_end: true })
    }

    /// Returns the repeated part of a body.
    pub fn repeat_of_body(&self, body: BodyId) -> Option<RepeatId> {
        self.repeats.position(|repeat| repeat.bodies.contains(body))
    }

    /// Returns the repeated part of an input.
    pub fn repeat_of_input(&self, what: InputKind) -> Option<RepeatId> {
        match what {
            InputKind::Gravity => None,
            InputKind::Efforts(hinge) | InputKind::Motion(hinge) => self.repeat_of_hinge(hinge),
            InputKind::Force(load) | InputKind::Torque(load) => {
                self.repeat_of_body(self.loads[load].body)
            }
        }
    }

    /// Returns the number of repetitions of an element.
    pub fn repetitions(&self, element: Element) -> usize {
        let repeat = match element {
            Element::Hinge(hinge) => self.repeat_of_hinge(hinge),
            Element::Body(body) => self.repeat_of_body(body),
        };
        repeat.map_or(1, |repeat| self.repeats[repeat].count)
    }
}
