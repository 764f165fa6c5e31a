//! External loads and springs, with the points they act at.

use crate::chain::{Body, Chain};
use crate::drives::{Drives, LoadInput};
use crate::hinge::Source;
use crate::load::{Axes, BodyPoint, Load, Spring, SpringEnd};
use crate::mechanism::Motion;
use crate::rotation::Vec3;

/// An external load on a body, or a spring.
pub(crate) struct ExternalLoad {
    at: Anchor,
    kind: Kind,
}

enum Kind {
    Load { force: Vec3, torque: Vec3, axes: Axes },
    Spring(SpringLaw),
}

/// A point that a load or a spring acts at.
enum Anchor {
    /// A point of the ground, inertial.
    Ground(Vec3),
    /// A point of a body: its index, and the vector from the centre of mass in body axes.
    Body(usize, Vec3),
}

/// A spring with a damper and an actuator.
struct SpringLaw {
    to: Anchor,
    stiffness: f64,
    damping: f64,
    length: f64,
    /// The force of the actuator, which pushes the ends apart.
    push: f64,
}

/// A spring at one instant.
pub(crate) struct Stretched {
    pub(crate) length: f64,
    pub(crate) rate: f64,
    pub(crate) tension: f64,
    /// The force on the body of the spring, in inertial axes.
    pub(crate) force: Vec3,
    energy: f64,
}

impl ExternalLoad {
    /// Returns all loads on a chain, then all its springs.
    ///
    /// # Panics
    ///
    /// Panics if the body of a load or a spring does not exist.
    pub(crate) fn all(chain: &Chain, drives: &Drives) -> Vec<ExternalLoad> {
        let loads = chain.loads.iter().zip(&drives.loads);
        let loads = loads.map(|(load, input)| ExternalLoad::load(chain, load, input));
        let springs = chain.springs.iter().zip(&drives.springs);
        let springs = springs.map(|(spring, &input)| ExternalLoad::spring(chain, spring, input));
        loads.chain(springs).collect()
    }

    fn load(chain: &Chain, load: &Load, input: &LoadInput) -> ExternalLoad {
        let vector = |source: &Source<[f64; 3]>, input: [f64; 3]| match source {
            Source::None => Vec3::zeros(),
            Source::Constant(constant) => Vec3::from(*constant),
            Source::Input => Vec3::from(input),
        };
        let force = vector(&load.force, input.force);
        let torque = vector(&load.torque, input.torque);
        let kind = Kind::Load { force, torque, axes: load.axes };
        ExternalLoad { at: Anchor::on_body(chain, &load.body, &load.at), kind }
    }

    fn spring(chain: &Chain, spring: &Spring, input: f64) -> ExternalLoad {
        let to = match &spring.to {
            SpringEnd::Ground(position) => Anchor::Ground(Vec3::from(*position)),
            SpringEnd::Body { body, at } => Anchor::on_body(chain, body, at),
        };
        let Spring { stiffness, damping, length, .. } = *spring;
        let push = spring.actuator(input);
        let kind = Kind::Spring(SpringLaw { to, stiffness, damping, length, push });
        ExternalLoad { at: Anchor::on_body(chain, &spring.body, &spring.at), kind }
    }

    /// Returns the bodies it acts on, each with the force and the moment about the centre of mass of
    /// the body, in inertial axes.
    pub(crate) fn wrenches(&self, motions: &[Motion]) -> Vec<(usize, Vec3, Vec3)> {
        let own = |force: Vec3, couple: Vec3| self.at.wrench(motions, force, couple);
        let Kind::Load { force, torque, axes } = &self.kind else {
            let Kind::Spring(law) = &self.kind else { return Vec::new() };
            let force = law.stretched(&self.at, motions).force;
            let opposite = law.to.wrench(motions, -force, Vec3::zeros());
            return own(force, Vec3::zeros()).into_iter().chain(opposite).collect();
        };
        let acting = match (axes, &self.at) {
            (Axes::Body, Anchor::Body(body, _)) => {
                let rotation = motions[*body].rotation;
                own(rotation * force, rotation * torque)
            }
            _ => own(*force, *torque),
        };
        acting.into_iter().collect()
    }

    /// Returns the state of a spring, or nothing for a load.
    pub(crate) fn stretched(&self, motions: &[Motion]) -> Option<Stretched> {
        match &self.kind {
            Kind::Load { .. } => None,
            Kind::Spring(law) => Some(law.stretched(&self.at, motions)),
        }
    }

    /// Returns the potential energy in J.
    pub(crate) fn energy(&self, motions: &[Motion]) -> f64 {
        self.stretched(motions).map_or(0.0, |spring| spring.energy)
    }
}

impl Anchor {
    fn on_body(chain: &Chain, name: &str, at: &BodyPoint) -> Anchor {
        let found = chain.bodies().enumerate().find(|(_, body)| body.name == name);
        let (body, description) =
            found.unwrap_or_else(|| panic!("chain {}: there is no body {name}", chain.name));
        let point = Vec3::from(at.position(description)) - Vec3::from(description.com);
        Anchor::Body(body, point)
    }

    /// Returns the position and the velocity of the point.
    fn motion(&self, motions: &[Motion]) -> (Vec3, Vec3) {
        match self {
            Anchor::Ground(position) => (*position, Vec3::zeros()),
            Anchor::Body(body, point) => {
                let motion = &motions[*body];
                let arm = motion.rotation * point;
                (motion.position + arm, motion.velocity + motion.spin.cross(&arm))
            }
        }
    }

    /// Returns the body, the force, and the moment about its centre of mass; nothing for the ground.
    fn wrench(&self, motions: &[Motion], force: Vec3, couple: Vec3) -> Option<(usize, Vec3, Vec3)> {
        let Anchor::Body(body, point) = self else { return None };
        let arm = motions[*body].rotation * point;
        Some((*body, force, couple + arm.cross(&force)))
    }
}

impl SpringLaw {
    /// Returns the spring between the point `at` and its other end. A spring of length zero has no
    /// direction: it has neither a force nor a rate.
    fn stretched(&self, at: &Anchor, motions: &[Motion]) -> Stretched {
        let (from, to) = (at.motion(motions), self.to.motion(motions));
        let (between, velocity) = (from.0 - to.0, from.1 - to.1);
        let length = between.norm();
        let direction = if length == 0.0 { Vec3::zeros() } else { between / length };
        let rate = direction.dot(&velocity);
        let tension = self.stiffness * (length - self.length) + self.damping * rate - self.push;
        let energy = 0.5 * self.stiffness * (length - self.length).powi(2);
        Stretched { length, rate, tension, force: -direction * tension, energy }
    }
}

impl Spring {
    /// Returns the force of the actuator for the value of its input.
    pub fn actuator(&self, input: f64) -> f64 {
        match self.force {
            Source::None => 0.0,
            Source::Constant(force) => force,
            Source::Input => input,
        }
    }
}

impl BodyPoint {
    /// Returns the position in m, in the body frame.
    pub fn position(&self, body: &Body) -> [f64; 3] {
        match self {
            BodyPoint::Com => body.com,
            BodyPoint::Input => [0.0; 3],
            BodyPoint::Output => body.output.position,
            BodyPoint::At(position) => *position,
            BodyPoint::Named { name, position } => {
                body.place(name).map_or(*position, |frame| frame.position)
            }
        }
    }
}
