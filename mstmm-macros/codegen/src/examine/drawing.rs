//! The geometry of a chain at its start, for a drawing.

use super::dry_run::{Configuration, DryRun, Number};
use crate::equations::{self, PointState, Trace};
use crate::ids::{IdVec, PointId};
use crate::math::Vec3;
use crate::model::{
    BodyId, BodyPoint, Chain, ConnectionPoints, Element, ElementPoints, Source, Spring, SpringEnd,
    Value,
};

/// The geometry of a chain for a drawing.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// The chain, its repeated parts written out or shortened.
    pub chain: Chain,
    /// Positions of all connection points in m.
    pub points: IdVec<PointId, [f64; 3]>,
    /// The connection points.
    pub of: ConnectionPoints,
    /// Positions of the elements' centres of mass in m; for hinges, of their inputs.
    pub centres: Vec<[f64; 3]>,
    /// The springs, in all repetitions.
    pub springs: Vec<DrawnSpring>,
    /// The named points of bodies that no hinge leaves.
    pub marks: Vec<DrawnMark>,
    /// The axis closest to the vertical; z without gravity.
    pub up: usize,
    /// Gravity in m/s², with parameters at their defaults; `None` if it is zero or an input.
    pub gravity: Option<[f64; 3]>,
}

/// A spring in a drawing.
#[derive(Clone, Debug)]
pub struct DrawnSpring {
    /// Its path.
    pub path: String,
    /// Its ends.
    pub ends: [DrawnEnd; 2],
}

/// An end of a spring, at a position in m: on the ground or on a body.
#[derive(Clone, Copy, Debug)]
pub enum DrawnEnd {
    /// On the ground.
    Ground([f64; 3]),
    /// On a body.
    Body {
        /// The input of the body.
        input: [f64; 3],
        /// The point on the body.
        at: [f64; 3],
    },
}

impl DrawnEnd {
    /// Returns the position of the end.
    pub fn at(&self) -> &[f64; 3] {
        match self {
            DrawnEnd::Ground(at) | DrawnEnd::Body { at, .. } => at,
        }
    }
}

/// A named point of a body in a drawing.
#[derive(Clone, Debug)]
pub struct DrawnMark {
    /// The path of the body, and the name of the point.
    pub path: [String; 2],
    /// The input of the body in m.
    pub input: [f64; 3],
    /// The point in m.
    pub at: [f64; 3],
}

impl DryRun {
    /// Returns the geometry at the start, closed if possible. `springs` are those of the unrolled chain.
    pub fn drawing(&self, poses: Vec<Configuration>, springs: &[Spring]) -> Drawing {
        let near = poses.into_iter().next();
        let pose = near.unwrap_or_else(|| self.pose(&self.values, 0));
        let (v, Configuration { q, inputs }) = (self.at_rest(), &pose);
        let context = self.context(&self.layout, &self.values, (q, &v, inputs));
        let (solved, swept) = self.swept(&self.values, &pose);
        let report = equations::report(&context, (&solved, &swept), &mut Trace::silent());
        let inputs = self.inputs_of_bodies(&report.connection_points.elements, &report.points);
        let places = Places { dry_run: self, inputs };
        Drawing {
            points: report.points.iter().map(|point| position(point.position)).collect(),
            centres: self
                .chain
                .elements
                .iter()
                .zip(&report.connection_points.elements)
                .map(|(element, ends)| match *element {
                    Element::Hinge(_) => position(report.points[ends.input].position),
                    Element::Body(body) => places.of(body, &self.chain.bodies[body].com)[1],
                })
                .collect(),
            springs: springs.iter().map(|spring| places.spring(spring)).collect(),
            marks: places.marks(&report.connection_points),
            of: report.connection_points,
            up: self.vertical(),
            gravity: self.gravity(),
            chain: self.chain.clone(),
        }
    }

    /// Returns the inputs of all bodies.
    fn inputs_of_bodies<'a>(
        &self,
        ends: &[ElementPoints],
        points: &'a IdVec<PointId, PointState<Number>>,
    ) -> Vec<(BodyId, &'a PointState<Number>)> {
        let elements = self.chain.elements.iter().zip(ends);
        let bodies = elements.filter_map(|(element, ends)| match *element {
            Element::Body(body) => Some((body, &points[ends.input])),
            Element::Hinge(_) => None,
        });
        bodies.collect()
    }

    fn gravity(&self) -> Option<[f64; 3]> {
        let Source::Constant(gravity) = &self.chain.gravity else { return None };
        let gravity = self.values.vector(gravity).0.map(Number::value);
        gravity.iter().any(|&part| part != 0.0).then_some(gravity)
    }

    fn vertical(&self) -> usize {
        let Some(gravity) = self.gravity() else { return 2 };
        let size = |axis: usize| gravity[axis].abs();
        [2, 1, 0].into_iter().max_by(|&a, &b| size(a).total_cmp(&size(b))).unwrap_or(2)
    }
}

fn position(place: Vec3<Number>) -> [f64; 3] {
    place.0.map(Number::value)
}

/// Finds the positions of points of bodies.
struct Places<'a> {
    dry_run: &'a DryRun,
    inputs: Vec<(BodyId, &'a PointState<Number>)>,
}

impl Places<'_> {
    /// Returns the input of a body, and a point of it.
    fn of(&self, body: BodyId, at: &[Value; 3]) -> [[f64; 3]; 2] {
        let found = self.inputs.iter().find(|(id, _)| *id == body);
        let Some((_, input)) = found else { bug!("a point is on a body without an input") };
        let at = self.dry_run.values.vector(at);
        [position(input.position), position(input.position + input.rotation * at)]
    }

    fn end(&self, BodyPoint { body, at }: &BodyPoint) -> DrawnEnd {
        let [input, at] = self.of(*body, at);
        DrawnEnd::Body { input, at }
    }

    fn spring(&self, spring: &Spring) -> DrawnSpring {
        let to = match &spring.to {
            SpringEnd::Ground(at) => DrawnEnd::Ground(position(self.dry_run.values.vector(at))),
            SpringEnd::Body(point) | SpringEnd::Previous { first: point, .. } => self.end(point),
        };
        DrawnSpring { path: spring.path.clone(), ends: [self.end(&spring.on), to] }
    }

    /// Returns the named points that no hinge leaves.
    fn marks(&self, connected: &ConnectionPoints) -> Vec<DrawnMark> {
        let mut marks = Vec::new();
        for &(body, _) in &self.inputs {
            let of = &self.dry_run.chain.bodies[body];
            for (number, point) in of.points.iter().enumerate() {
                if connected.joined.contains_key(&(body, number)) {
                    continue;
                }
                let [input, at] = self.of(body, &point.frame.position);
                let path = [of.path.clone(), point.name.to_string()];
                marks.push(DrawnMark { path, input, at });
            }
        }
        marks
    }
}
