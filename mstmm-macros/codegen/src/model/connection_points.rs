//! The connection points of a model: where pose, velocity, acceleration and internal forces are
//! reported.
//!
//! Every element has an input and an output. A hinge's output is the input of the body that it leads
//! to. A hinge's input is the place that it leaves, if no other hinge leaves that place: the output or
//! a named point of a body, or a frame on the ground. If several hinges leave one place, the place
//! reports the sum of what they transmit, and the input of each is a separate point with its share.
//! The same holds for hinges that leave a body's input, whose force and moment are those of the hinge
//! that leads to the body.
//!
//! Order: the elements in the order of the text, each with its input, if that is a new point, and its
//! output. The named points of a body that hinges leave follow its output.

use super::{Attachment, BodyId, Chain, Element, HingeId, RepeatBoundary, RepeatId};
use crate::ids::{ChannelId, IdVec, PointId};
use std::collections::HashMap;

/// A connection point.
#[derive(Clone, Debug)]
pub struct ConnectionPoint {
    /// Its frame.
    pub attachment: Attachment,
    /// The force and moment that it reports.
    pub transmitted: Transmitted,
    /// The repeated part that it belongs to.
    pub repeat: Option<RepeatId>,
}

/// The force and moment at a connection point.
#[derive(Clone, Debug)]
pub enum Transmitted {
    /// Those of the hinge that leads to the point.
    To(HingeId),
    /// The sum over these hinges, which leave the point; zero if there is none.
    From(Vec<HingeId>),
}

/// The points of an element.
#[derive(Clone, Copy, Debug)]
pub struct ElementPoints {
    /// Its input, in a repeated part that of the first repetition.
    pub input: PointId,
    /// Its input in the other repetitions, if that is a point of the previous repetition.
    pub previous: Option<PointId>,
    /// Its output.
    pub output: PointId,
}

/// All connection points of a chain; those of a repeated part are listed once.
#[derive(Clone, Debug, Default)]
pub struct ConnectionPoints {
    /// The points in order.
    pub points: IdVec<PointId, ConnectionPoint>,
    /// The points of every element.
    pub elements: Vec<ElementPoints>,
    /// The named points of bodies that hinges leave, by their index in [`super::Body::points`].
    pub joined: HashMap<(BodyId, usize), PointId>,
}

impl Chain {
    /// Returns the connection points.
    pub fn connection_points(&self) -> ConnectionPoints {
        let mut leaving: HashMap<PlaceKey, Vec<HingeId>> = HashMap::new();
        for (id, hinge) in self.hinges.enumerate() {
            if let Some(key) = place_key(&hinge.inboard) {
                leaving.entry(key).or_default().push(id);
            }
        }
        let finder = Finder {
            chain: self,
            leaving,
            inputs: HashMap::new(),
            outputs: HashMap::new(),
            later: Vec::new(),
            found: ConnectionPoints::default(),
        };
        finder.find()
    }
}

/// A place of a body: its input, its output or a named point.
type PlaceKey = (BodyId, Option<usize>, bool);

fn place_key(place: &Attachment) -> Option<PlaceKey> {
    match place {
        Attachment::Ground(_) => None,
        Attachment::Input(body) => Some((*body, None, true)),
        Attachment::Output(body) => Some((*body, None, false)),
        Attachment::Point(body, point) => Some((*body, Some(*point), false)),
    }
}

/// The search for the points, element by element.
struct Finder<'a> {
    chain: &'a Chain,
    /// The hinges that leave each place.
    leaving: HashMap<PlaceKey, Vec<HingeId>>,
    /// The input of each body that a hinge leads to.
    inputs: HashMap<BodyId, PointId>,
    /// The output of each body.
    outputs: HashMap<BodyId, PointId>,
    /// The elements whose input in later repetitions is the output of a body that follows.
    later: Vec<(usize, BodyId)>,
    found: ConnectionPoints,
}

impl Finder<'_> {
    fn find(mut self) -> ConnectionPoints {
        for (index, &element) in self.chain.elements.iter().enumerate() {
            let points = match element {
                Element::Hinge(hinge) => self.hinge(index, hinge),
                Element::Body(body) => self.body(body),
            };
            self.found.elements.push(points);
        }
        for (index, body) in self.later {
            self.found.elements[index].previous = Some(self.outputs[&body]);
        }
        self.found
    }

    fn add(
        &mut self,
        attachment: &Attachment,
        transmitted: Transmitted,
        repeat: Option<RepeatId>,
    ) -> PointId {
        self.found.points.push(ConnectionPoint {
            attachment: attachment.clone(),
            transmitted,
            repeat,
        })
    }

    fn body(&mut self, body: BodyId) -> ElementPoints {
        let repeat = self.chain.repeat_of_body(body);
        let input = match self.inputs.get(&body) {
            Some(&input) => input,
            None => self.add(&Attachment::Input(body), Transmitted::From(Vec::new()), repeat),
        };
        let output = self.place(&Attachment::Output(body), repeat);
        self.outputs.insert(body, output);
        for point in 0..self.chain.bodies[body].points.len() {
            let place = Attachment::Point(body, point);
            if !self.leaving(&place).is_empty() {
                let joined = self.place(&place, repeat);
                self.found.joined.insert((body, point), joined);
            }
        }
        ElementPoints { input, previous: None, output }
    }

    /// Adds a place of a body with all that leaves it.
    fn place(&mut self, place: &Attachment, repeat: Option<RepeatId>) -> PointId {
        let hinges = self.leaving(place).to_vec();
        self.add(place, Transmitted::From(hinges), repeat)
    }

    fn hinge(&mut self, index: usize, id: HingeId) -> ElementPoints {
        let hinge = &self.chain.hinges[id];
        let repeat = self.chain.repeat_of_hinge(id);
        let boundary = self.chain.repeat_boundary(&hinge.inboard);
        let shared = match boundary {
            None => self.shared(&hinge.inboard, id),
            Some(RepeatBoundary { channel: ChannelId(0), at_end: true, .. })
                if self.leaving(&hinge.inboard).len() == 1 =>
            {
                let weld = self.weld_at(&hinge.inboard);
                self.shared(&self.chain.hinges[weld].inboard, weld)
            }
            Some(RepeatBoundary { repeat, channel: ChannelId(0), at_end: false }) => {
                self.start_of_repeat(index, repeat, &hinge.inboard)
            }
            Some(_) => None,
        };
        let own = || Transmitted::From(vec![id]);
        let input = shared.unwrap_or_else(|| self.add(&hinge.inboard, own(), repeat));
        let output = self.add(&hinge.outboard, Transmitted::To(id), repeat);
        if let Attachment::Input(body) = hinge.outboard {
            self.inputs.insert(body, output);
        }
        ElementPoints { input, previous: None, output }
    }

    /// Returns the point of the place that the first hinge of a repeated part leaves in the first
    /// repetition, if the hinge is alone there and in the other repetitions.
    fn start_of_repeat(
        &mut self,
        index: usize,
        repeat: RepeatId,
        boundary: &Attachment,
    ) -> Option<PointId> {
        let last_body = self.chain.repeats[repeat].last_body;
        if self.leaving(&Attachment::Output(last_body)).len() > 1 {
            return None;
        }
        let weld = self.weld_at(boundary);
        let first = match &self.chain.hinges[weld].inboard {
            ground @ Attachment::Ground(_) => {
                Some(self.add(ground, Transmitted::From(vec![weld]), None))
            }
            place => match self.chain.repeat_boundary(place) {
                None => self.shared(place, weld),
                Some(RepeatBoundary { channel: ChannelId(0), at_end: true, .. })
                    if self.leaving(place).len() == 1 =>
                {
                    let before = self.weld_at(place);
                    self.shared(&self.chain.hinges[before].inboard, before)
                }
                Some(_) => None,
            },
        }?;
        self.later.push((index, last_body));
        Some(first)
    }

    /// Returns the point of a place that only one hinge leaves, with a new point on the ground or at a
    /// moving end.
    fn shared(&mut self, place: &Attachment, hinge: HingeId) -> Option<PointId> {
        let alone = self.leaving(place).len() == 1;
        match place {
            Attachment::Ground(_) | Attachment::Input(_) => None,
            Attachment::Output(body) if alone => Some(match self.outputs.get(body) {
                Some(&output) => output,
                // A moving end is no element.
                None => self.add(place, Transmitted::From(vec![hinge]), None),
            }),
            Attachment::Point(body, point) if alone => {
                self.found.joined.get(&(*body, *point)).copied()
            }
            Attachment::Output(_) | Attachment::Point(..) => None,
        }
    }

    fn leaving(&self, place: &Attachment) -> &[HingeId] {
        place_key(place).and_then(|key| self.leaving.get(&key)).map_or(&[], Vec::as_slice)
    }

    /// Returns the weld of the boundary at an attachment.
    fn weld_at(&self, boundary: &Attachment) -> HingeId {
        let Some(found) = self.chain.repeat_boundary(boundary) else {
            bug!("no repeated part begins or ends at an attachment")
        };
        self.chain.weld_of(found)
    }
}
