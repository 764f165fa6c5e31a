//! The poses of all bodies of a chain.

use super::hinge::{Motion, pose};
use super::space::{Pose, constant, constant_matrix, cross_matrix, plus, product, scaled, sum};
use super::{Now, Real, reals};
use crate::chain::Frame;
use crate::hinge::HingeKind;
use crate::mechanism::{FrameState, Mechanism, Side};
use crate::rotation::{self, Mat3, Vec3};

/// The motion of the chain for which poses are wanted.
#[derive(Clone, Copy)]
pub(super) struct Moves<'a> {
    /// The free rates and their derivatives.
    pub(super) rates: &'a [Real],
    pub(super) accelerations: &'a [Real],
    /// Whether frames and prescribed hinges move; they rest for virtual motions.
    pub(super) prescribed: bool,
}

/// Returns the joint that closes a loop: the last hinge of the closed route that is not a weld.
pub(super) fn closing_joint(mechanism: &Mechanism) -> Option<usize> {
    if !mechanism.chain.closed() {
        return None;
    }
    let joints = &mechanism.joints;
    let mut number = joints.iter().position(|joint| joint.outboard.body().is_none())?;
    while *joints[number].kind() == HingeKind::Weld {
        let body = joints[number].inboard.body();
        number = joints.iter().position(|joint| joint.outboard.body() == body)?;
    }
    Some(number)
}

/// Returns the motion of a joint.
pub(super) fn joint_motion(
    mechanism: &Mechanism,
    number: usize,
    now: &Now,
    moves: Moves,
) -> Motion {
    let joint = &mechanism.joints[number];
    let (coordinates, rates) = (joint.kind().coordinates(), joint.kind().dof_count());
    match &now.prescribed[number] {
        Some(motion) if moves.prescribed => motion.clone(),
        Some(motion) => {
            let rest = reals(&vec![0.0; rates]);
            Motion { q: motion.q.clone(), v: rest.clone(), a: rest }
        }
        None => Motion {
            q: now.q[joint.first_coordinate..][..coordinates].to_vec(),
            v: moves.rates[joint.first_rate..][..rates].to_vec(),
            a: moves.accelerations[joint.first_rate..][..rates].to_vec(),
        },
    }
}

/// Returns the motion of the floating base.
pub(super) fn base_motion(kind: &HingeKind, now: &Now, moves: Moves) -> Motion {
    let rates = kind.dof_count();
    Motion {
        q: now.q[..kind.coordinates()].to_vec(),
        v: moves.rates[..rates].to_vec(),
        a: moves.accelerations[..rates].to_vec(),
    }
}

/// Returns the poses of all bodies' frames, whose origins are the inputs.
pub(super) fn poses(
    mechanism: &Mechanism,
    closing: Option<usize>,
    now: &Now,
    moves: Moves,
) -> Vec<Pose> {
    let mut poses: Vec<Option<Pose>> = vec![None; mechanism.bodies.len()];
    if mechanism.chain.floats() {
        let kind = HingeKind::of_base(mechanism.chain.dimension);
        poses[0] = Some(pose(&kind, &base_motion(&kind, now, moves)));
    }
    let places = places(mechanism);
    let tree: Vec<usize> = (0..mechanism.joints.len()).filter(|it| Some(*it) != closing).collect();
    while poses.iter().any(Option::is_none) {
        let before = poses.clone();
        for &number in &tree {
            let joint = &mechanism.joints[number];
            let known = |side: Side, poses: &[Option<Pose>]| match side {
                Side::Frame(frame) => {
                    Some(frame_pose(&mechanism.frames[frame], now.time, moves.prescribed))
                }
                Side::On { body, place } => poses[body].map(|it| it.then(&places[body][place])),
            };
            let is_known = |side: Side| side.body().is_none_or(|body| poses[body].is_some());
            let across = |it: Motion| pose(joint.kind(), &it);
            let motion = || joint_motion(mechanism, number, now, moves);
            let (reached, side) = match [joint.inboard, joint.outboard] {
                [from, to] if is_known(from) && !is_known(to) => {
                    (known(from, &poses).map(|it| it.then(&across(motion()))), to)
                }
                [to, from] if is_known(from) && !is_known(to) => {
                    (known(from, &poses).map(|it| it.then(&across(motion()).inverse())), to)
                }
                _ => continue,
            };
            if let Side::On { body, place } = side {
                poses[body] = reached.map(|it| it.then(&places[body][place].inverse()));
            }
        }
        let count = |poses: &[Option<Pose>]| poses.iter().flatten().count();
        assert!(count(&before) < count(&poses), "a body is not joined");
    }
    poses.into_iter().flatten().collect()
}

/// Returns input, output and named points of all bodies, in their frames.
fn places(mechanism: &Mechanism) -> Vec<Vec<Pose>> {
    let place = |frame: &Frame| Pose {
        position: constant(frame.position.map(Real::new)),
        rotation: constant_matrix(matrix(&rotation::from_rpy_degrees(&frame.rpy_degrees))),
    };
    let of_body = |body: &crate::chain::Body| {
        let named = body.points.iter().map(|point| &point.frame);
        [&Frame::IDENTITY, &body.output].into_iter().chain(named).map(place).collect()
    };
    mechanism.chain.bodies().map(of_body).collect()
}

/// Returns the pose of a frame that an end of a route is attached to.
fn frame_pose(frame: &FrameState, time: Real, moves: bool) -> Pose {
    let vector = |it: &Vec3| <[f64; 3]>::from(*it).map(Real::new);
    let turning = cross_matrix(vector(&frame.spin));
    let rotation = matrix(&frame.rotation);
    let rate = product(turning, rotation);
    if !moves {
        let position = plus(vector(&frame.position), scaled(vector(&frame.velocity), time));
        let after = |row: usize| plus(rotation[row], scaled(rate[row], time));
        let rotation = constant_matrix(std::array::from_fn(after));
        return Pose { position: constant(position), rotation };
    }
    let change = cross_matrix(vector(&frame.known_angular));
    let second = product(sum(product(turning, turning), change), rotation);
    let [velocity, acceleration] = [&frame.velocity, &frame.known_acceleration].map(vector);
    Pose {
        position: super::space::moving(vector(&frame.position), velocity, acceleration),
        rotation: std::array::from_fn(|row| {
            super::space::moving(rotation[row], rate[row], second[row])
        }),
    }
}

fn matrix(rotation: &Mat3) -> super::space::Matrix {
    rotation::rows(rotation).map(|row| row.map(Real::new))
}
