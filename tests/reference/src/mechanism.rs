//! A chain prepared for computing: bodies about their centres of mass, and hinges with their two
//! sides.

use crate::chain::{About, Body, Chain, Element, End, Frame, Gravity, State};
use crate::drives::{Drives, FrameMotion, HingeMotion};
use crate::external_load::ExternalLoad;
use crate::hinge::{Group, Hinge, HingeKind, Source};
use crate::rotation::{self, Mat3, Vec3};
use std::ops::Range;

/// A chain as the solver sees it, at one instant.
pub(crate) struct Mechanism<'a> {
    pub(crate) chain: &'a Chain,
    pub(crate) gravity: Vec3,
    pub(crate) bodies: Vec<Rigid>,
    pub(crate) joints: Vec<Joint<'a>>,
    pub(crate) external_loads: Vec<ExternalLoad>,
    /// The frames that the start and the finish are attached to.
    pub(crate) start: Option<FrameState>,
    pub(crate) finish: Option<FrameState>,
}

/// A body; all vectors start at its centre of mass and have components in body axes.
pub(crate) struct Rigid {
    pub(crate) mass: f64,
    pub(crate) inertia: Mat3,
    pub(crate) input: Vec3,
    pub(crate) output: Vec3,
    pub(crate) output_turn: Mat3,
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
    first_coordinate: usize,
    pub(crate) first_rate: usize,
    /// The motor's efforts, one for every rate.
    pub(crate) motor: Vec<f64>,
}

/// A frame on a body, or the one an end of the chain is attached to.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Side {
    Start,
    Finish,
    Input(usize),
    Output(usize),
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
    /// Panics if hinges and bodies do not alternate as the ends of the chain require, or if the body
    /// of a load or a spring does not exist.
    pub(crate) fn new(chain: &'a Chain, drives: &'a Drives) -> Mechanism<'a> {
        let gravity = match chain.gravity {
            Gravity::Constant(acceleration) => acceleration,
            Gravity::Input => drives.gravity,
        };
        Mechanism {
            chain,
            gravity: Vec3::from(gravity),
            bodies: chain.bodies().map(Rigid::new).collect(),
            joints: joints_of(chain, drives),
            external_loads: ExternalLoad::all(chain, drives),
            start: attached(&chain.start, &drives.start),
            finish: attached(&chain.finish, &drives.finish),
        }
    }

    /// Returns the motion of a frame for given motions of the bodies.
    pub(crate) fn frame_motion(&self, side: &Side, motions: &[Motion]) -> FrameState {
        match *side {
            Side::Start => self.start.clone().expect("a start that is attached"),
            Side::Finish => self.finish.clone().expect("a finish that is attached"),
            Side::Input(body) => {
                FrameState::on(body, &motions[body], &self.bodies[body].input, &Mat3::identity())
            }
            Side::Output(body) => {
                let rigid = &self.bodies[body];
                FrameState::on(body, &motions[body], &rigid.output, &rigid.output_turn)
            }
        }
    }

    /// Returns every connection point in written order.
    pub(crate) fn connection_points(&self) -> Vec<Side> {
        let on_bodies =
            (0..self.bodies.len()).flat_map(|body| [Side::Input(body), Side::Output(body)]);
        let start = self.start.iter().map(|_| Side::Start);
        start.chain(on_bodies).chain(self.finish.iter().map(|_| Side::Finish)).collect()
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
    /// inertial origin) and of the springs to the ground.
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

/// Pairs every hinge with the frames that it joins.
fn joints_of<'a>(chain: &'a Chain, drives: &'a Drives) -> Vec<Joint<'a>> {
    let misplaced = |name: &str| -> ! {
        panic!("chain {}: {name} is not where hinges and bodies alternate", chain.name)
    };
    let (mut coordinate, mut rate) = (chain.base_coordinates(), chain.base_dof_count());
    let mut motions = drives.motions.iter();
    let mut joints: Vec<Joint> = Vec::new();
    let mut reached = (chain.start != End::Free).then_some(Side::Start);
    let mut waiting: Option<&Hinge> = None;
    let mut join = |hinge: &'a Hinge, inboard: Side, outboard: Side| {
        joints.push(Joint {
            hinge,
            inboard,
            outboard,
            prescribed: if hinge.prescribed { motions.next() } else { None },
            first_coordinate: coordinate,
            first_rate: rate,
            motor: motor_efforts(hinge, &drives.efforts[rate..]),
        });
        coordinate += hinge.coordinates();
        rate += hinge.dof_count();
    };
    let mut bodies = 0;
    for element in &chain.elements {
        match (element, waiting.take(), reached) {
            (Element::Hinge(hinge), None, Some(_)) => waiting = Some(hinge),
            (Element::Body(_), Some(hinge), Some(inboard)) => {
                join(hinge, inboard, Side::Input(bodies));
                reached = Some(Side::Output(bodies));
                bodies += 1;
            }
            (Element::Body(_), None, None) => {
                reached = Some(Side::Output(bodies));
                bodies += 1;
            }
            (Element::Hinge(hinge), ..) => misplaced(&hinge.name),
            (Element::Body(body), ..) => misplaced(&body.name),
        }
    }
    match (waiting, chain.finish != End::Free, reached) {
        (Some(hinge), true, Some(inboard)) if bodies > 0 => join(hinge, inboard, Side::Finish),
        (None, false, Some(_)) => {}
        _ => misplaced("the finish"),
    }
    joints
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

/// Returns the frame that an end is attached to, if any.
fn attached(end: &End, motion: &FrameMotion) -> Option<FrameState> {
    match end {
        End::Free => None,
        End::Held(Frame { position, rpy_degrees }) => {
            let rotation = rotation::from_rpy_degrees(rpy_degrees);
            Some(FrameState::at_rest(Vec3::from(*position), rotation))
        }
        End::Moving { .. } => Some(FrameState::moving(motion)),
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
        Rigid {
            mass: body.mass,
            inertia,
            input: -com,
            output: Vec3::from(body.output.position) - com,
            output_turn: rotation::from_rpy_degrees(&body.output.rpy_degrees),
        }
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
    fn moving(motion: &FrameMotion) -> FrameState {
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
