//! Boundaries of repeated parts: a massless body is welded in where a part begins and where it
//! ends. Everything that the part exchanges with its surroundings passes through them, so each
//! repetition is the same.

use super::{
    About, Attachment, Body, BodyId, Chain, ChannelId, Frame, FromPrevious, Hinge, HingeId,
    HingeKind, Inertia, PresentPoints, Repeat, RepeatBoundary, RepeatId, Role, Value,
};
use super::{Drive, Element, InputKind};
use proc_macro2::Span;
use quote::format_ident;

/// Returns the chain with a massless body at each boundary.
pub(super) fn with_repeat_boundaries(mut chain: Chain) -> Chain {
    for repeat in chain.repeats.ids() {
        Boundaries { chain: &mut chain, repeat, channels: 0 }.add();
    }
    chain
}

/// Adds the boundaries of one repeated part. Each channel has one at the start and one at the end.
struct Boundaries<'a> {
    chain: &'a mut Chain,
    repeat: RepeatId,
    channels: usize,
}

impl Boundaries<'_> {
    fn add(mut self) {
        let Repeat { hinges, last_body, from_previous, .. } =
            self.chain.repeats[self.repeat].clone();
        let route_end = Attachment::Output(last_body);
        let before = self.chain.hinges[hinges.first()].inboard.clone();
        self.channel(Some(hinges.first()), &before, &route_end);
        for FromPrevious { hinge, previous } in &from_previous {
            let first = self.chain.hinges[*hinge].inboard.clone();
            self.channel(Some(*hinge), &first, previous);
        }
        // Elements outside of the part may leave other places of the last repetition. No hinge of the part
        // reads the channels of these places.
        while let Some(place) = self.place_left_outside() {
            self.channel(None, &before, &place);
        }
    }

    /// Adds a channel from the place `first` in the first repetition, or `previous` in all others, to
    /// the hinge `follower`, and from `previous` in the last repetition to what leaves it outside.
    fn channel(&mut self, follower: Option<HingeId>, first: &Attachment, previous: &Attachment) {
        let channel = ChannelId(self.channels);
        self.channels += 1;
        let outside = self.outside(previous);
        let boundary = |at_end| RepeatBoundary { repeat: self.repeat, channel, at_end };
        let [start, end] = [boundary(false), boundary(true)];
        let start = add_boundary(self.chain, start, first.clone());
        if let Some(follower) = follower {
            self.chain.hinges[follower].inboard = Attachment::Input(start);
        }
        let end = add_boundary(self.chain, end, previous.clone());
        // The places of channels other than the route's are served by channels without a follower.
        if channel == ChannelId(0) || follower.is_none() {
            for hinge in outside {
                self.chain.hinges[hinge].inboard = Attachment::Input(end);
            }
        }
    }

    /// Returns the hinges outside of the part that leave a place of it.
    fn outside(&self, place: &Attachment) -> Vec<HingeId> {
        let hinges = self.chain.hinges.enumerate();
        let outside =
            hinges.filter(|(id, hinge)| hinge.inboard == *place && self.is_outside(*id, hinge));
        outside.map(|(id, _)| id).collect()
    }

    fn is_outside(&self, id: HingeId, hinge: &Hinge) -> bool {
        !self.chain.repeats[self.repeat].hinges.contains(id)
            && self.chain.repeat_boundary(&hinge.outboard).is_none()
    }

    /// Returns a place of the part that a hinge outside leaves.
    fn place_left_outside(&self) -> Option<Attachment> {
        let bodies = self.chain.repeats[self.repeat].bodies;
        let hinges = self.chain.hinges.enumerate();
        let mut left = hinges.filter(|(id, hinge)| {
            hinge.inboard.body().is_some_and(|body| bodies.contains(body))
                && self.is_outside(*id, hinge)
        });
        left.next().map(|(_, hinge)| hinge.inboard.clone())
    }
}

/// Welds a boundary to an attachment.
fn add_boundary(chain: &mut Chain, boundary: RepeatBoundary, at: Attachment) -> BodyId {
    let RepeatBoundary { repeat, channel, at_end } = boundary;
    let word = if at_end { "end" } else { "start" };
    let channel = match channel {
        ChannelId(0) => String::new(),
        ChannelId(other) => format!("_{other}"),
    };
    let index = repeat.index();
    let name = format_ident!("{word}_of_repeat{index}{channel}", span = Span::call_site());
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
        shapes: Vec::new(),
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
        start_field: None,
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

    /// Returns the welds at the start of a repeated part, one for each channel.
    pub fn starts_of(&self, repeat: RepeatId) -> impl Iterator<Item = HingeId> {
        let is_start = move |hinge: &Hinge| {
            let boundary = self.repeat_boundary(&hinge.outboard);
            boundary.is_some_and(|boundary| boundary.repeat == repeat && !boundary.at_end)
        };
        self.hinges.enumerate().filter(move |(_, hinge)| is_start(hinge)).map(|(id, _)| id)
    }

    /// Returns the repeated part of a hinge.
    pub fn repeat_of_hinge(&self, hinge: HingeId) -> Option<RepeatId> {
        self.repeats.position(|repeat| repeat.hinges.contains(hinge))
    }

    /// Returns whether a hinge belongs to a repeated part, or is the weld of a boundary of it.
    pub fn lies_in_repeat(&self, hinge: HingeId, repeat: RepeatId) -> bool {
        self.repeats[repeat].hinges.contains(hinge)
            || self
                .repeat_boundary(&self.hinges[hinge].outboard)
                .is_some_and(|boundary| boundary.repeat == repeat)
    }

    /// Returns the repeated part of a body.
    pub fn repeat_of_body(&self, body: BodyId) -> Option<RepeatId> {
        self.repeats.position(|repeat| repeat.bodies.contains(body))
    }

    /// Returns the body that an input acts on; `None` for gravity and inputs of hinges.
    pub fn body_of_input(&self, what: InputKind) -> Option<BodyId> {
        match what {
            InputKind::Force(load) | InputKind::Torque(load) => Some(self.loads[load].body),
            InputKind::SpringForce(spring) => Some(self.springs[spring].on.body),
            InputKind::Gravity | InputKind::Efforts(_) | InputKind::Motion(_) => None,
        }
    }

    /// Returns the repeated part of an input.
    pub fn repeat_of_input(&self, what: InputKind) -> Option<RepeatId> {
        match what {
            InputKind::Gravity => None,
            InputKind::Efforts(hinge) | InputKind::Motion(hinge) => self.repeat_of_hinge(hinge),
            InputKind::Force(_) | InputKind::Torque(_) | InputKind::SpringForce(_) => {
                self.body_of_input(what).and_then(|body| self.repeat_of_body(body))
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
