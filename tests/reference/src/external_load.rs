//! External loads and springs to the ground, with the bodies they act on.

use crate::chain::{Body, Chain};
use crate::drives::{Drives, LoadInput};
use crate::hinge::Source;
use crate::load::{Axes, BodyPoint, Load, Spring};
use crate::mechanism::Motion;
use crate::rotation::Vec3;

/// An external load on a body.
pub(crate) struct ExternalLoad {
    /// The body it acts on.
    pub(crate) body: usize,
    /// The vector from the centre of mass to the point of action, body axes.
    point: Vec3,
    kind: Kind,
}

enum Kind {
    Load { force: Vec3, torque: Vec3, axes: Axes },
    Spring { to: Vec3, stiffness: f64, damping: f64, length: f64 },
}

impl ExternalLoad {
    /// Returns all external loads on a chain.
    ///
    /// # Panics
    ///
    /// Panics if the body of a load does not exist.
    pub(crate) fn all(chain: &Chain, drives: &Drives) -> Vec<ExternalLoad> {
        let loads = chain.loads.iter().zip(&drives.loads);
        let loads = loads.map(|(load, input)| ExternalLoad::load(chain, load, input));
        let springs = chain.springs.iter().map(|spring| ExternalLoad::spring(chain, spring));
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
        ExternalLoad::new(chain, &load.body, &load.at, kind)
    }

    fn spring(chain: &Chain, spring: &Spring) -> ExternalLoad {
        let Spring { to, stiffness, damping, length, .. } = *spring;
        let kind = Kind::Spring { to: Vec3::from(to), stiffness, damping, length };
        ExternalLoad::new(chain, &spring.body, &spring.at, kind)
    }

    fn new(chain: &Chain, name: &str, at: &BodyPoint, kind: Kind) -> ExternalLoad {
        let found = chain.bodies().enumerate().find(|(_, body)| body.name == name);
        let (body, description) =
            found.unwrap_or_else(|| panic!("chain {}: there is no body {name}", chain.name));
        let point = Vec3::from(at.position(description)) - Vec3::from(description.com);
        ExternalLoad { body, point, kind }
    }

    /// Returns the force, and the moment about the centre of mass of the body, in inertial axes.
    pub(crate) fn wrench(&self, motions: &[Motion]) -> [Vec3; 2] {
        let motion = &motions[self.body];
        let arm = motion.rotation * self.point;
        let (force, couple) = match &self.kind {
            Kind::Load { force, torque, axes: Axes::Inertial } => (*force, *torque),
            Kind::Load { force, torque, axes: Axes::Body } => {
                (motion.rotation * force, motion.rotation * torque)
            }
            Kind::Spring { to, stiffness, damping, length } => {
                let from_ground = motion.position + arm - to;
                let velocity = motion.velocity + motion.spin.cross(&arm);
                let force = spring_force(&from_ground, &velocity, [*stiffness, *damping, *length]);
                (force, Vec3::zeros())
            }
        };
        [force, couple + arm.cross(&force)]
    }

    /// Returns the length of a spring in m.
    pub(crate) fn length(&self, motions: &[Motion]) -> Option<f64> {
        let motion = &motions[self.body];
        match &self.kind {
            Kind::Load { .. } => None,
            Kind::Spring { to, .. } => {
                Some((motion.position + motion.rotation * self.point - to).norm())
            }
        }
    }

    /// Returns the potential energy in J.
    pub(crate) fn energy(&self, motions: &[Motion]) -> f64 {
        match (&self.kind, self.length(motions)) {
            (Kind::Spring { stiffness, length, .. }, Some(now)) => {
                0.5 * stiffness * (now - length).powi(2)
            }
            _ => 0.0,
        }
    }
}

/// Returns the force at the free end of a spring that is held at the origin.
fn spring_force(end: &Vec3, velocity: &Vec3, [stiffness, damping, length]: [f64; 3]) -> Vec3 {
    let now = end.norm();
    if now == 0.0 {
        return Vec3::zeros();
    }
    let direction = end / now;
    -direction * (stiffness * (now - length) + damping * direction.dot(velocity))
}

impl BodyPoint {
    /// Returns the position in m, in the body frame.
    pub fn position(&self, body: &Body) -> [f64; 3] {
        match self {
            BodyPoint::Com => body.com,
            BodyPoint::Input => [0.0; 3],
            BodyPoint::Output => body.output.position,
            BodyPoint::At(position) | BodyPoint::Named { position, .. } => *position,
        }
    }
}
