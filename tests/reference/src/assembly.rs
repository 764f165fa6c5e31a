//! The graph of a chain: which frames each hinge joins, and the connection points.

use crate::chain::{Chain, Element, End};
use crate::drives::{Drives, FrameMotion};
use crate::hinge::{Group, Hinge, Source};
use crate::mechanism::{FrameState, Joint, Side};
use crate::rotation;
use crate::rotation::Vec3;
use crate::route::Place;
use std::ops::Range;

/// The hinges, frames and connection points of a chain.
pub(crate) struct Assembly<'a> {
    /// The hinges in written order.
    pub(crate) joints: Vec<Joint<'a>>,
    /// The frames that starts and finishes of routes are attached to.
    pub(crate) frames: Vec<FrameState>,
    /// The connection points in written order.
    pub(crate) points: Vec<Side>,
}

/// An assembly of which some routes are done.
struct Builder<'a> {
    chain: &'a Chain,
    drives: &'a Drives,
    motions: std::slice::Iter<'a, crate::drives::HingeMotion>,
    coordinate: usize,
    rate: usize,
    bodies: usize,
    assembly: Assembly<'a>,
}

impl<'a> Assembly<'a> {
    /// Pairs every hinge with the frames that it joins.
    ///
    /// # Panics
    ///
    /// Panics if hinges and bodies do not alternate as the ends of the routes require, or if a place
    /// is not on a body of an earlier route.
    pub(crate) fn new(chain: &'a Chain, drives: &'a Drives) -> Assembly<'a> {
        let assembly = Assembly { joints: Vec::new(), frames: Vec::new(), points: Vec::new() };
        let mut builder = Builder {
            chain,
            drives,
            motions: drives.motions.iter(),
            coordinate: chain.base_coordinates(),
            rate: chain.base_dof_count(),
            bodies: 0,
            assembly,
        };
        let starts = std::iter::once(&drives.start).chain(&drives.route_starts);
        for (route, motion) in chain.routes().zip(starts) {
            builder.add_route(route, motion);
        }
        builder.assembly
    }
}

impl<'a> Builder<'a> {
    fn add_route(
        &mut self,
        (start, elements, finish): (&'a End, &'a [Element], &'a End),
        motion: &FrameMotion,
    ) {
        let mut reached = self.attached(start, motion);
        let mut waiting: Option<&Hinge> = None;
        match reached {
            Some(side) => self.add_point(side),
            None => self.add_point(Side::input(self.bodies)),
        }
        for element in elements {
            match (element, waiting.take(), reached) {
                (Element::Hinge(hinge), None, Some(_)) => waiting = Some(hinge),
                (Element::Body(_), Some(hinge), Some(inboard)) => {
                    self.join(hinge, inboard, Side::input(self.bodies));
                    reached = Some(self.next_body());
                }
                (Element::Body(_), None, None) => reached = Some(self.next_body()),
                (Element::Hinge(hinge), ..) => self.misplaced(&hinge.name),
                (Element::Body(body), ..) => self.misplaced(&body.name),
            }
        }
        match (waiting, self.attached(finish, &self.drives.finish), reached) {
            (Some(hinge), Some(outboard), Some(inboard)) if self.bodies > 0 => {
                self.join(hinge, inboard, outboard);
            }
            (None, None, Some(_)) => {}
            _ => self.misplaced("the finish"),
        }
    }

    fn misplaced(&self, name: &str) -> ! {
        panic!("chain {}: {name} is not where hinges and bodies alternate", self.chain.name)
    }

    /// Returns the frame that an end is attached to, if any.
    fn attached(&mut self, end: &End, motion: &FrameMotion) -> Option<Side> {
        let frame = match end {
            End::Free => return None,
            End::Place(place) => return Some(self.place(place)),
            End::Held(frame) => {
                let rotation = rotation::from_rpy_degrees(&frame.rpy_degrees);
                FrameState::at_rest(Vec3::from(frame.position), rotation)
            }
            End::Moving { .. } => FrameState::moving(motion),
        };
        self.assembly.frames.push(frame);
        Some(Side::Frame(self.assembly.frames.len() - 1))
    }

    fn place(&self, Place { body, point }: &Place) -> Side {
        let chain = self.chain;
        let found = chain.bodies().take(self.bodies).enumerate().find(|(_, it)| it.name == *body);
        let (body, description) = found
            .unwrap_or_else(|| panic!("chain {}: no earlier route reaches {body}", chain.name));
        let named = || description.points.iter().position(|it| it.name == *point);
        match point.as_str() {
            "input" => Side::input(body),
            "output" => Side::output(body),
            _ => match named() {
                Some(point) => Side::named(body, point),
                None => panic!("chain {}: {} has no {point}", chain.name, description.name),
            },
        }
    }

    /// Adds a body and returns its output.
    fn next_body(&mut self) -> Side {
        let output = Side::output(self.bodies);
        self.add_point(output);
        self.bodies += 1;
        output
    }

    /// Adds a connection point, unless the chain has it already.
    fn add_point(&mut self, side: Side) {
        let points = &mut self.assembly.points;
        if !matches!(side, Side::On { .. }) || !points.contains(&side) {
            points.push(side);
        }
    }

    fn join(&mut self, hinge: &'a Hinge, inboard: Side, outboard: Side) {
        self.assembly.joints.push(Joint {
            hinge,
            inboard,
            outboard,
            prescribed: if hinge.prescribed { self.motions.next() } else { None },
            first_coordinate: self.coordinate,
            first_rate: self.rate,
            motor: motor_efforts(hinge, &self.drives.efforts[self.rate..]),
        });
        self.coordinate += hinge.coordinates();
        self.rate += hinge.dof_count();
        self.add_point(outboard);
    }
}

/// Returns the efforts of a hinge's motors from the efforts of its rates and of all later rates.
fn motor_efforts(hinge: &Hinge, given: &[f64]) -> Vec<f64> {
    let of_group = |(group, rates): (&Group, Range<usize>)| match &group.motor {
        Source::Constant(efforts) => efforts.clone(),
        _ if hinge.prescribed => vec![0.0; rates.len()],
        _ => given[rates].to_vec(),
    };
    hinge.groups().map(of_group).concat()
}
