//! Loads on bodies and springs between bodies.

use super::space::{Pose, Vector, constant, cross, dot, minus, norm, plus, scaled, times};
use super::{Now, Real};
use crate::chain::Chain;
use crate::load::{Axes, BodyPoint, Load, Spring, SpringEnd};

/// A force at a point of a body and a couple, in inertial axes.
pub(super) struct Acting {
    pub(super) body: usize,
    /// The vector from the origin of the body's frame to the point, in body axes.
    pub(super) at: Vector,
    pub(super) force: Vector,
    pub(super) couple: Vector,
}

/// Returns everything that acts on the bodies, whose poses are given, apart from gravity and hinges.
pub(super) fn acting(chain: &Chain, now: &Now, poses: &[Pose]) -> Vec<Acting> {
    let loads = chain.loads.iter().zip(&now.loads);
    let loads = loads.map(|(load, inputs)| of_load(chain, load, *inputs, poses));
    let springs = chain.springs.iter().zip(&now.actuators);
    let springs = springs.flat_map(|(spring, &push)| of_spring(chain, spring, push, poses));
    loads.chain(springs).collect()
}

fn of_load(chain: &Chain, load: &Load, [force, couple]: [Vector; 2], poses: &[Pose]) -> Acting {
    let (body, at) = point(chain, &load.body, &load.at);
    let rotation = poses[body].rotation.map(|row| row.map(|entry| entry.value));
    let [force, couple] = match load.axes {
        Axes::Inertial => [force, couple],
        Axes::Body => [force, couple].map(|vector| times(rotation, vector)),
    };
    Acting { body, at, force, couple }
}

fn of_spring(chain: &Chain, spring: &Spring, push: Real, poses: &[Pose]) -> Vec<Acting> {
    let none = [Real::new(0.0); 3];
    let from = point(chain, &spring.body, &spring.at);
    let to = match &spring.to {
        SpringEnd::Ground(position) => Err(position.map(Real::new)),
        SpringEnd::Body { body, at } => Ok(point(chain, body, at)),
    };
    let motion = |&(body, at): &(usize, Vector)| {
        let there = place(&poses[body], at);
        [there.map(|entry| entry.value), there.map(|entry| entry.rate)]
    };
    let far = to.as_ref().map_or_else(|position| [*position, none], motion);
    let near = motion(&from);
    let (between, velocity) = (minus(near[0], far[0]), minus(near[1], far[1]));
    let length = norm(between);
    if length.high == 0.0 {
        return Vec::new();
    }
    let direction = scaled(between, length.recip());
    let tension = Real::new(spring.stiffness) * (length - Real::new(spring.length))
        + Real::new(spring.damping) * dot(direction, velocity)
        - push;
    let force = scaled(direction, -tension);
    let on = |(body, at): (usize, Vector), force| Acting { body, at, force, couple: none };
    let opposite = to.ok().map(|to| on(to, force.map(|entry| -entry)));
    [on(from, force)].into_iter().chain(opposite).collect()
}

/// Returns the inertial position of a point of a body.
pub(super) fn place(pose: &Pose, at: Vector) -> Vector<super::jet::Jet> {
    plus(pose.position, times(pose.rotation, constant(at)))
}

/// Returns a body by its name, and a point in its frame.
fn point(chain: &Chain, name: &str, at: &BodyPoint) -> (usize, Vector) {
    let found = chain.bodies().enumerate().find(|(_, body)| body.name == name);
    let (body, description) =
        found.unwrap_or_else(|| panic!("chain {}: there is no body {name}", chain.name));
    (body, at.position(description).map(Real::new))
}

/// Returns the force and the moment about the origin of the body's frame, in inertial axes.
pub(super) fn wrench(acting: &Acting, pose: &Pose) -> [Vector; 2] {
    let rotation = pose.rotation.map(|row| row.map(|entry| entry.value));
    let arm = times(rotation, acting.at);
    [acting.force, plus(acting.couple, cross(arm, acting.force))]
}
