//! Accelerations, internal loads and energies at one instant.

use crate::assembly::Reported;
use crate::chain::{Chain, State};
use crate::drives::Drives;
use crate::equations::{Dynamics, Equations};
use crate::external_load::{ExternalLoad, Stretched};
use crate::mechanism::{FrameState, Joint, Mechanism, Motion, Rigid, Side};
use crate::relative::{Twist, twist};
use crate::rotation::{self, Vec3};

/// The largest error of the loop constraint, in m and rad, m/s and rad/s.
const GAP: f64 = 1e-6;

/// All results for a chain at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// The derivatives of the rates, in the order and the axes of [`State::v`], in m/s² and rad/s².
    pub accelerations: Vec<f64>,
    /// The efforts of every hinge in written order, one for every rate of its kind: the efforts of
    /// its motor, or of its drive if its motion is prescribed.
    pub efforts: Vec<Vec<f64>>,
    /// The connection points in written order: of every element its input, if that is a new point, and
    /// its output; after the output of a body its named points at which hinges begin.
    pub points: Vec<Point>,
    /// The points of every element in written order.
    pub elements: Vec<ElementPoints>,
    /// The named points of every body, also those at which no hinge begins.
    pub named_points: Vec<Vec<Point>>,
    /// The load of every hinge at its inboard side, in written order.
    pub hinge_loads: Vec<HingeLoad>,
    /// The springs in written order.
    pub springs: Vec<SpringState>,
    /// The kinetic energy in J, including rotors.
    pub kinetic_energy: f64,
    /// The potential energy in J: of constant gravity, −Σ m g·r, which is zero with every centre of
    /// mass at the inertial origin, and of springs and limits.
    pub potential_energy: f64,
    /// Whether the equations determine the internal loads. If they do not, as in a planar loop in
    /// space, the loads have least norm, and only the accelerations can be compared.
    pub reactions_unique: bool,
}

/// The state of one connection point. All vectors are in inertial axes.
///
/// The frame at a body's output, which is the input of the hinge after it, is the body's output
/// frame. The frame at a hinge's output is the frame of the body after it, or the frame that the
/// end of the chain is attached to.
///
/// The signs of the loads are those of the method. On the body whose input is this point act the
/// force and minus the moment; on the body whose output is this point act minus the force and the
/// moment. A hinge transmits both, so its two points have the same force, and moments that differ by
/// the moment of the force over the offset. The loads at a free end are zero.
///
/// At an output or a named point where several hinges begin, the loads are the sums over these
/// hinges, and the input of each hinge is a separate point with its share. The same holds for a hinge
/// that begins at the input of a body; the loads at this input are those of the hinge that ends there,
/// zero for a floating body.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The position in m.
    pub position: [f64; 3],
    /// The rotation matrix from components in the frame of the point to inertial components, row by
    /// row.
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

/// The indices of an element's points in [`Solution::points`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ElementPoints {
    /// Its input.
    pub input: usize,
    /// Its output.
    pub output: usize,
}

/// The share of one hinge in the loads of the point where it begins, with the signs of an output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HingeLoad {
    /// The internal moment about the point in N·m, inertial axes.
    pub moment: [f64; 3],
    /// The internal force in N, inertial axes.
    pub force: [f64; 3],
}

/// A spring at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringState {
    /// The length in m.
    pub length: f64,
    /// The derivative of the length in m/s.
    pub length_rate: f64,
    /// The force of spring and damper in N, positive if they pull.
    pub tension: f64,
    /// The force on the body of the spring in N, inertial axes.
    pub force: [f64; 3],
}

impl Chain {
    /// Solves the equations of motion in the given state, with efforts as the only inputs.
    ///
    /// `efforts` are those of [`Drives`].
    ///
    /// # Panics
    ///
    /// Panics like [`Chain::solve_driven`].
    pub fn solve(&self, state: &State, efforts: &[f64]) -> Solution {
        let drives = Drives { efforts: efforts.to_vec(), ..Drives::none(self) };
        self.solve_driven(state, &drives)
    }

    /// Solves the equations of motion in the given state.
    ///
    /// # Panics
    ///
    /// Panics if the elements do not alternate, if the state or the drives have the wrong length, or
    /// if a closed chain does not close in this state.
    pub fn solve_driven(&self, state: &State, drives: &Drives) -> Solution {
        self.check_lengths(state, drives);
        let mechanism = Mechanism::new(self, drives);
        let motions = mechanism.motions(state);
        let equations = Equations::new(&mechanism, &motions, state);
        let gaps = equations.contacts.iter().filter(|_| mechanism.has_loops()).map(|contact| {
            contact.pose_violation().amax().max(contact.velocity_violation().amax())
        });
        let gap = gaps.fold(0.0, f64::max);
        assert!(gap <= GAP, "chain {}: the state leaves a gap of {gap:e}", self.name);
        let dynamics = equations.dynamics();
        let point = |point: &Reported| point_at(&mechanism, &motions, &dynamics, point);
        let spring = |load: &ExternalLoad| load.stretched(&motions).map(SpringState::from);
        let passive = || equations.contacts.iter().map(|contact| &contact.passive);
        Solution {
            accelerations: chain_accelerations(&mechanism, &motions, &dynamics),
            points: mechanism.points.iter().map(point).collect(),
            elements: mechanism.elements.clone(),
            named_points: named_points(&mechanism, &motions, &dynamics),
            hinge_loads: hinge_loads(&mechanism, &motions, &dynamics),
            springs: mechanism.external_loads.iter().filter_map(spring).collect(),
            kinetic_energy: mechanism.kinetic_energy(&motions)
                + passive().map(|passive| passive.kinetic_energy).sum::<f64>(),
            potential_energy: mechanism.potential_energy(&motions)
                + passive().map(|passive| passive.potential_energy).sum::<f64>(),
            reactions_unique: equations.saddle.multipliers_are_unique(),
            efforts: dynamics.efforts,
        }
    }
}

/// Returns the derivatives of the chain's rates.
fn chain_accelerations(mechanism: &Mechanism, motions: &[Motion], dynamics: &Dynamics) -> Vec<f64> {
    let mut accelerations: Vec<f64> = Vec::new();
    if mechanism.chain.floats() {
        let input = mechanism.frame_motion(&Side::input(0), motions);
        let (acceleration, angular) = accelerations_at(&input, dynamics);
        // In body axes: the inertial derivative of a vector and its derivative in the body frame
        // differ by the cross product with the angular velocity, which is zero for the angular
        // velocity itself.
        let angular = input.rotation.transpose() * angular;
        let all = twist(acceleration, angular);
        let directions = mechanism.chain.dimension.directions();
        accelerations.extend(directions.iter().map(|direction| all[*direction]));
    }
    for (joint, own) in mechanism.joints.iter().zip(&dynamics.hinge_accelerations) {
        if joint.prescribed.is_none() {
            accelerations.extend(own);
        }
    }
    accelerations
}

/// Returns the acceleration and the angular acceleration of a frame.
fn accelerations_at(place: &FrameState, dynamics: &Dynamics) -> (Vec3, Vec3) {
    let known = (place.known_acceleration, place.known_angular);
    let Some(body) = place.body else { return known };
    let angular = dynamics.angular[body];
    (dynamics.linear[body] + angular.cross(&place.arm) + known.0, angular)
}

fn point_at(
    mechanism: &Mechanism,
    motions: &[Motion],
    dynamics: &Dynamics,
    Reported { side, share }: &Reported,
) -> Point {
    let place = mechanism.frame_motion(side, motions);
    let (acceleration, angular_acceleration) = accelerations_at(&place, dynamics);
    let (force, moment) = match *share {
        None => internal_loads(mechanism, motions, dynamics, side),
        Some(hinge) => {
            let (joint, wrench) = (&mechanism.joints[hinge], &dynamics.wrenches[hinge]);
            inboard_load(mechanism, motions, joint, wrench)
        }
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

/// Returns the force and the moment at a connection point, with the signs of [`Point`].
fn internal_loads(
    mechanism: &Mechanism,
    motions: &[Motion],
    dynamics: &Dynamics,
    side: &Side,
) -> (Vec3, Vec3) {
    let is_input = matches!(side, Side::On { place: 0, .. });
    let mut total = (Vec3::zeros(), Vec3::zeros());
    for (joint, wrench) in mechanism.joints.iter().zip(&dynamics.wrenches) {
        let (force, moment) = parts(wrench);
        if joint.outboard == *side {
            return (force, -moment);
        }
        if joint.inboard == *side && !is_input {
            let (force, moment) = inboard_load(mechanism, motions, joint, wrench);
            total = (total.0 + force, total.1 + moment);
        }
    }
    total
}

fn parts(wrench: &Twist) -> (Vec3, Vec3) {
    (wrench.fixed_rows::<3>(0).into(), wrench.fixed_rows::<3>(3).into())
}

/// Returns the force and the moment of a hinge at its inboard side, with the signs of [`Point`].
fn inboard_load(
    mechanism: &Mechanism,
    motions: &[Motion],
    joint: &Joint,
    wrench: &Twist,
) -> (Vec3, Vec3) {
    let (force, moment) = parts(wrench);
    let outboard = mechanism.frame_motion(&joint.outboard, motions).position;
    let arm = outboard - mechanism.frame_motion(&joint.inboard, motions).position;
    (force, -(moment + arm.cross(&force)))
}

fn named_points(mechanism: &Mechanism, motions: &[Motion], dynamics: &Dynamics) -> Vec<Vec<Point>> {
    let of_body = |(body, rigid): (usize, &Rigid)| {
        let places = 2..rigid.places.len();
        let side = |place| Reported { side: Side::On { body, place }, share: None };
        places.map(|place| point_at(mechanism, motions, dynamics, &side(place))).collect()
    };
    mechanism.bodies.iter().enumerate().map(of_body).collect()
}

fn hinge_loads(mechanism: &Mechanism, motions: &[Motion], dynamics: &Dynamics) -> Vec<HingeLoad> {
    let load = |(joint, wrench): (&Joint, &Twist)| {
        let (force, moment) = inboard_load(mechanism, motions, joint, wrench);
        HingeLoad { moment: moment.into(), force: force.into() }
    };
    mechanism.joints.iter().zip(&dynamics.wrenches).map(load).collect()
}

impl From<Stretched> for SpringState {
    fn from(Stretched { length, rate, tension, force, .. }: Stretched) -> SpringState {
        SpringState { length, length_rate: rate, tension, force: force.into() }
    }
}
