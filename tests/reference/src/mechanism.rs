//! A chain prepared for computing: bodies about their centres of mass, and hinges with their two
//! sides.

use crate::assembly::{Assembly, Reported};
use crate::chain::{About, Body, Chain, Frame, Gravity, State};
use crate::drives::{Drives, FrameMotion, HingeMotion};
use crate::external_load::ExternalLoad;
use crate::hinge::{Hinge, HingeKind};
use crate::rotation::{self, Mat3, Vec3};
use crate::solve::ElementPoints;

/// A chain as the solver sees it, at one instant.
pub(crate) struct Mechanism<'a> {
    pub(crate) chain: &'a Chain,
    pub(crate) gravity: Vec3,
    pub(crate) bodies: Vec<Rigid>,
    pub(crate) joints: Vec<Joint<'a>>,
    pub(crate) external_loads: Vec<ExternalLoad>,
    /// The frames that starts and finishes of routes are attached to.
    pub(crate) frames: Vec<FrameState>,
    /// The connection points in written order.
    pub(crate) points: Vec<Reported>,
    /// The points of every element in written order.
    pub(crate) elements: Vec<ElementPoints>,
}

/// A body; all vectors start at its centre of mass and have components in body axes.
pub(crate) struct Rigid {
    pub(crate) mass: f64,
    pub(crate) inertia: Mat3,
    /// The position and the rotation of the input, the output and every named point.
    pub(crate) places: Vec<(Vec3, Mat3)>,
}

/// The motion of a body's centre of mass and of its frame, in inertial axes.
#[derive(Clone)]
pub(crate) struct Motion {
    pub(crate) position: Vec3,
    pub(crate) rotation: Mat3,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
}

/// A hinge, and the indices of its coordinates and rates.
pub(crate) struct Joint<'a> {
    pub(crate) hinge: &'a Hinge,
    pub(crate) inboard: Side,
    pub(crate) outboard: Side,
    /// The prescribed motion; without one the hinge has entries in the state.
    pub(crate) prescribed: Option<&'a HingeMotion>,
    pub(crate) first_coordinate: usize,
    pub(crate) first_rate: usize,
    /// The motor's efforts, one for every rate.
    pub(crate) motor: Vec<f64>,
}

/// A frame on a body, or one that an end of a route is attached to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Side {
    /// One of [`Mechanism::frames`].
    Frame(usize),
    /// One of [`Rigid::places`] of a body.
    On { body: usize, place: usize },
}

impl Side {
    pub(crate) fn input(body: usize) -> Side {
        Side::On { body, place: 0 }
    }

    pub(crate) fn output(body: usize) -> Side {
        Side::On { body, place: 1 }
    }

    /// The named point with the given number.
    pub(crate) fn named(body: usize, number: usize) -> Side {
        Side::On { body, place: 2 + number }
    }

    /// The body that the frame is fixed to, if any.
    pub(crate) fn body(self) -> Option<usize> {
        match self {
            Side::Frame(_) => None,
            Side::On { body, .. } => Some(body),
        }
    }
}

/// The motion of a [`Side`] in inertial axes.
#[derive(Clone)]
pub(crate) struct FrameState {
    /// The body that the frame is fixed to, if any.
    pub(crate) body: Option<usize>,
    /// The vector from the body's centre of mass to the frame's origin.
    pub(crate) arm: Vec3,
    pub(crate) position: Vec3,
    pub(crate) rotation: Mat3,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Vec3,
    /// The acceleration without the contributions of the body's acceleration and angular
    /// acceleration.
    pub(crate) known_acceleration: Vec3,
    /// The angular acceleration without that of the body.
    pub(crate) known_angular: Vec3,
}

impl<'a> Mechanism<'a> {
    /// Prepares a chain.
    ///
    /// # Panics
    ///
    /// Panics like [`Assembly::new`], and if the body of a load or a spring does not exist.
    pub(crate) fn new(chain: &'a Chain, drives: &'a Drives) -> Mechanism<'a> {
        let gravity = match chain.gravity {
            Gravity::Constant(acceleration) => acceleration,
            Gravity::Input => drives.gravity,
        };
        let Assembly { joints, frames, points, elements } = Assembly::new(chain, drives);
        Mechanism {
            chain,
            gravity: Vec3::from(gravity),
            bodies: chain.bodies().map(Rigid::new).collect(),
            joints,
            external_loads: ExternalLoad::all(chain, drives),
            frames,
            points,
            elements,
        }
    }

    /// Returns the motion of a frame for given motions of the bodies.
    pub(crate) fn frame_motion(&self, side: &Side, motions: &[Motion]) -> FrameState {
        match *side {
            Side::Frame(number) => self.frames[number].clone(),
            Side::On { body, place } => {
                let (position, turn) = &self.bodies[body].places[place];
                FrameState::on(body, &motions[body], position, turn)
            }
        }
    }

    /// Returns the hinge of a closed chain that joins its last body to the finish.
    pub(crate) fn closing(&self) -> Option<&Joint<'a>> {
        let closes = |joint: &&Joint| joint.outboard.body().is_none();
        self.joints.iter().find(closes).filter(|_| self.chain.closed())
    }

    /// Returns whether there are more hinges than a tree needs.
    pub(crate) fn has_loops(&self) -> bool {
        self.joints.len() + usize::from(self.chain.floats()) > self.bodies.len()
    }

    /// Returns the kinetic energy of the bodies in J.
    pub(crate) fn kinetic_energy(&self, motions: &[Motion]) -> f64 {
        let of_body = |(rigid, motion): (&Rigid, &Motion)| {
            let spin = motion.rotation.transpose() * motion.spin;
            0.5 * rigid.mass * motion.velocity.norm_squared()
                + 0.5 * spin.dot(&(rigid.inertia * spin))
        };
        self.bodies.iter().zip(motions).map(of_body).sum()
    }

    /// Returns the potential energy in J of constant gravity (zero with every centre of mass at the
    /// inertial origin) and of the springs between bodies and to the ground.
    pub(crate) fn potential_energy(&self, motions: &[Motion]) -> f64 {
        let gravity = match self.chain.gravity {
            Gravity::Constant(_) => self.gravity,
            Gravity::Input => Vec3::zeros(),
        };
        let of_body =
            |(rigid, motion): (&Rigid, &Motion)| -rigid.mass * gravity.dot(&motion.position);
        let of_bodies: f64 = self.bodies.iter().zip(motions).map(of_body).sum();
        of_bodies + self.external_loads.iter().map(|load| load.energy(motions)).sum::<f64>()
    }
}

impl Joint<'_> {
    pub(crate) fn kind(&self) -> &HingeKind {
        &self.hinge.kind
    }

    /// Returns the coordinates of the hinge.
    pub(crate) fn q<'b>(&'b self, state: &'b State) -> &'b [f64] {
        match self.prescribed {
            Some(motion) => &motion.q,
            None => &state.q[self.first_coordinate..][..self.kind().coordinates()],
        }
    }

    /// Returns the rates of the hinge.
    pub(crate) fn v<'b>(&'b self, state: &'b State) -> &'b [f64] {
        match self.prescribed {
            Some(motion) => &motion.v,
            None => &state.v[self.first_rate..][..self.kind().dof_count()],
        }
    }
}

impl Rigid {
    fn new(body: &Body) -> Rigid {
        let [xx, yy, zz, xy, xz, yz] = body.inertia;
        let com = Vec3::from(body.com);
        let given = Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        let offset = rotation::cross_matrix(&com);
        let inertia = match body.about {
            About::Com => given,
            // Steiner: the inertia about the input point is larger by −m [c×]².
            About::Input => given + body.mass * offset * offset,
        };
        let place = |frame: &Frame| {
            let turn = rotation::from_rpy_degrees(&frame.rpy_degrees);
            (Vec3::from(frame.position) - com, turn)
        };
        let points = body.points.iter().map(|point| &point.frame);
        let places = [&Frame::IDENTITY, &body.output].into_iter().chain(points).map(place);
        Rigid { mass: body.mass, inertia, places: places.collect() }
    }
}

impl FrameState {
    pub(crate) fn at_rest(position: Vec3, rotation: Mat3) -> FrameState {
        let rest = Vec3::zeros();
        FrameState {
            body: None,
            arm: rest,
            position,
            rotation,
            velocity: rest,
            spin: rest,
            known_acceleration: rest,
            known_angular: rest,
        }
    }

    /// Returns a frame with a prescribed motion.
    pub(crate) fn moving(motion: &FrameMotion) -> FrameState {
        let rotation = rotation::from_quaternion(&motion.orientation);
        FrameState {
            velocity: Vec3::from(motion.velocity),
            spin: rotation * Vec3::from(motion.rate),
            known_acceleration: Vec3::from(motion.acceleration),
            // The derivatives in the moving and in the inertial frame are equal: they differ by the
            // cross product of the angular velocity with itself.
            known_angular: rotation * Vec3::from(motion.rate_derivative),
            ..FrameState::at_rest(Vec3::from(motion.position), rotation)
        }
    }

    fn on(body: usize, motion: &Motion, arm: &Vec3, turn: &Mat3) -> FrameState {
        let arm = motion.rotation * arm;
        FrameState {
            body: Some(body),
            arm,
            position: motion.position + arm,
            rotation: motion.rotation * turn,
            velocity: motion.velocity + motion.spin.cross(&arm),
            spin: motion.spin,
            known_acceleration: motion.spin.cross(&motion.spin.cross(&arm)),
            known_angular: Vec3::zeros(),
        }
    }
}
