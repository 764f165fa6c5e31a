//! The graph of a chain: which frames each hinge joins, and the connection points.

use crate::chain::{Chain, Element, End};
use crate::drives::{Drives, FrameMotion, HingeMotion};
use crate::hinge::{Group, Hinge, Source};
use crate::mechanism::{FrameState, Joint, Side};
use crate::rotation::{self, Vec3};
use crate::route::Place;
use crate::solve::ElementPoints;
use std::ops::Range;

/// The hinges, frames and connection points of a chain.
pub(crate) struct Assembly<'a> {
    /// The hinges in written order.
    pub(crate) joints: Vec<Joint<'a>>,
    /// The frames that starts and finishes of routes are attached to.
    pub(crate) frames: Vec<FrameState>,
    /// The connection points in written order.
    pub(crate) points: Vec<Reported>,
    /// The points of every element in written order.
    pub(crate) elements: Vec<ElementPoints>,
}

/// A connection point.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Reported {
    pub(crate) side: Side,
    /// The hinge whose share the point reports, if it begins at the same place as others, or at an
    /// input; the point reports everything there otherwise.
    pub(crate) share: Option<usize>,
}

/// An element by its number.
#[derive(Clone, Copy)]
enum Numbered {
    Hinge(usize),
    Body(usize),
}

/// An assembly of which some routes are done.
struct Builder<'a> {
    chain: &'a Chain,
    drives: &'a Drives,
    motions: std::slice::Iter<'a, HingeMotion>,
    coordinate: usize,
    rate: usize,
    bodies: usize,
    elements: Vec<Numbered>,
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
        let (joints, frames, points, elements) = Default::default();
        let assembly = Assembly { joints, frames, points, elements };
        let mut builder = Builder {
            chain,
            drives,
            motions: drives.motions.iter(),
            coordinate: chain.base_coordinates(),
            rate: chain.base_dof_count(),
            bodies: 0,
            elements: Vec::new(),
            assembly,
        };
        let starts = std::iter::once(&drives.start).chain(&drives.route_starts);
        for (route, motion) in chain.routes().zip(starts) {
            builder.add_route(route, motion);
        }
        let Builder { elements, mut assembly, .. } = builder;
        for element in elements {
            let points = assembly.element_points(chain, element);
            assembly.elements.push(points);
        }
        assembly
    }

    /// Returns the connection points of an element, and adds those that are new.
    fn element_points(&mut self, chain: &Chain, element: Numbered) -> ElementPoints {
        let leaving = |side: Side| self.joints.iter().filter(|it| it.inboard == side).count();
        match element {
            Numbered::Hinge(number) => {
                let Joint { inboard, outboard, .. } = self.joints[number];
                let is_input = matches!(inboard, Side::On { place: 0, .. });
                let is_shared = is_input || leaving(inboard) > 1;
                let input = self.point(inboard, Some(number).filter(|_| is_shared));
                ElementPoints { input, output: self.point(outboard, None) }
            }
            Numbered::Body(body) => {
                let named = chain.bodies().nth(body).map_or(0, |body| body.points.len());
                let named = (0..named).map(|point| Side::named(body, point));
                let joined: Vec<Side> = named.filter(|side| leaving(*side) > 0).collect();
                let input = self.point(Side::input(body), None);
                let output = self.point(Side::output(body), None);
                for side in joined {
                    self.point(side, None);
                }
                ElementPoints { input, output }
            }
        }
    }

    /// Returns the number of a point, which is added if it is new.
    fn point(&mut self, side: Side, share: Option<usize>) -> usize {
        let point = Reported { side, share };
        self.points.iter().position(|it| *it == point).unwrap_or_else(|| {
            self.points.push(point);
            self.points.len() - 1
        })
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
        self.elements.push(Numbered::Body(self.bodies));
        self.bodies += 1;
        Side::output(self.bodies - 1)
    }

    fn join(&mut self, hinge: &'a Hinge, inboard: Side, outboard: Side) {
        self.elements.push(Numbered::Hinge(self.assembly.joints.len()));
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
