//! Accelerations, internal loads and energies at one instant.

use crate::chain::{Chain, State};
use crate::mechanism::{Base, Freedom, Joint, Mechanism, Motion, Place, Side};
use crate::rotation::{self, Vec3};
use crate::saddle::{Contact, Dynamics, Saddle};

/// Everything about a chain at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The derivatives of the rates, in the order and the axes of [`State::v`], in m/s² and rad/s².
    pub accelerations: Vec<f64>,
    /// The connection points in written order: the input of the first element, then the output of
    /// every element.
    pub points: Vec<Point>,
    /// The kinetic energy in J.
    pub kinetic_energy: f64,
    /// The potential energy −Σ m g·r in J, zero with every centre of mass at the inertial origin.
    pub potential_energy: f64,
}

/// The state of one connection point. All vectors are in inertial axes.
///
/// The frame at a body's output, which is the input of the hinge after it, is the body's output
/// frame. The frame at a hinge's output is the frame of the body after it, or that of the ground.
///
/// The signs of the loads are those of the method: the point's force acts as it stands on the body
/// whose input is here and reversed on the body whose output is here; its moment acts reversed on
/// the body whose input is here and as it stands on the body whose output is here. A hinge passes
/// on both, so its two points carry the same; a free end carries none.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The position in m.
    pub position: [f64; 3],
    /// The matrix that turns components in the frame of the point into inertial ones, row by row.
    pub rotation: [[f64; 3]; 3],
    /// The velocity in m/s.
    pub velocity: [f64; 3],
    /// The angular velocity of the frame in rad/s.
    pub angular_velocity: [f64; 3],
    /// The true acceleration in m/s²; gravity is not subtracted.
    pub acceleration: [f64; 3],
    /// The angular acceleration of the frame in rad/s².
    pub angular_acceleration: [f64; 3],
    /// The internal moment about the point in N·m, motor torques included.
    pub moment: [f64; 3],
    /// The internal force in N.
    pub force: [f64; 3],
}

impl Chain {
    /// Solves the equations of motion in the given state.
    ///
    /// `efforts` holds one torque for every rate. Those of hinges are applied, whether or not the
    /// hinge is described as a motor; the six of a floating base are ignored.
    ///
    /// # Panics
    ///
    /// Panics when the elements do not alternate, when both ends are held, or when the state or the
    /// efforts have the wrong length.
    pub fn solve(&self, state: &State, efforts: &[f64]) -> Solution {
        self.check_lengths(state, efforts);
        let mechanism = Mechanism::new(self);
        let motions = mechanism.motions(state);
        let saddle = Saddle::new(&mechanism, &motions);
        let dynamics = saddle.dynamics(efforts);
        let point = |side: &Side| point_at(&mechanism, &motions, &dynamics, side);
        Solution {
            accelerations: chain_accelerations(&mechanism, &motions, &saddle, &dynamics),
            points: mechanism.connection_points().iter().map(point).collect(),
            kinetic_energy: mechanism.kinetic_energy(&motions),
            potential_energy: mechanism.potential_energy(&motions),
        }
    }

    pub(crate) fn check_lengths(&self, state: &State, efforts: &[f64]) {
        assert_eq!(state.q.len(), self.coordinates(), "chain {}: coordinates", self.name);
        assert_eq!(state.v.len(), self.freedoms(), "chain {}: rates", self.name);
        assert_eq!(efforts.len(), self.freedoms(), "chain {}: efforts", self.name);
    }
}

/// Returns the derivatives of the chain's rates.
fn chain_accelerations(
    mechanism: &Mechanism,
    motions: &[Motion],
    saddle: &Saddle,
    dynamics: &Dynamics,
) -> Vec<f64> {
    let mut accelerations: Vec<f64> = Vec::new();
    if let Base::Floating = mechanism.base {
        let input = mechanism.place(&Side::Input(0), motions);
        let (acceleration, angular) = accelerations_at(&input, dynamics);
        accelerations.extend(acceleration.iter());
        // In body axes: a vector's derivative and its derivative seen from the body differ by its
        // product with the angular velocity, which for the angular velocity itself is nothing.
        accelerations.extend((input.rotation.transpose() * angular).iter());
    }
    for (joint, contact) in mechanism.joints.iter().zip(saddle.contacts()) {
        accelerations.extend(hinge_accelerations(joint, contact, dynamics));
    }
    accelerations
}

/// Returns the derivatives of one hinge's rates.
fn hinge_accelerations(joint: &Joint, contact: &Contact, dynamics: &Dynamics) -> Vec<f64> {
    let Contact { inboard, outboard, .. } = contact;
    let relative = accelerations_at(outboard, dynamics).1 - accelerations_at(inboard, dynamics).1;
    match &joint.freedom {
        Freedom::None => Vec::new(),
        // The turning of the axis contributes only across the axis.
        Freedom::About(axis) => vec![(inboard.rotation * axis).dot(&relative)],
        Freedom::AnyTurn => {
            let spin = outboard.spin - inboard.spin;
            let seen_from_outboard = relative - outboard.spin.cross(&spin);
            (outboard.rotation.transpose() * seen_from_outboard).iter().copied().collect()
        }
    }
}

/// Returns the acceleration and the angular acceleration of a place.
fn accelerations_at(place: &Place, dynamics: &Dynamics) -> (Vec3, Vec3) {
    let Some(body) = place.body else { return (Vec3::zeros(), Vec3::zeros()) };
    let angular = dynamics.angular[body];
    let linear = dynamics.linear[body] + angular.cross(&place.arm) + place.centripetal();
    (linear, angular)
}

fn point_at(mechanism: &Mechanism, motions: &[Motion], dynamics: &Dynamics, side: &Side) -> Point {
    let place = mechanism.place(side, motions);
    let (acceleration, angular_acceleration) = accelerations_at(&place, dynamics);
    let touches = |joint: &Joint| joint.inboard == *side || joint.outboard == *side;
    let (force, moment) = match mechanism.joints.iter().position(touches) {
        Some(hinge) => (dynamics.hinge_forces[hinge], -dynamics.hinge_moments[hinge]),
        None => (Vec3::zeros(), Vec3::zeros()),
    };
    Point {
        position: place.position.into(),
        rotation: rotation::rows(&place.rotation),
        velocity: place.velocity.into(),
        angular_velocity: place.spin.into(),
        acceleration: acceleration.into(),
        angular_acceleration: angular_acceleration.into(),
        moment: moment.into(),
        force: force.into(),
    }
}
