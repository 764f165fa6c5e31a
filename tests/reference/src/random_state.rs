//! Random states of chains, and random drives.

use crate::chain::{Chain, Dimension, End, Frame, Gravity, State};
use crate::closure::{end_of_chain, finish_of};
use crate::drives::{Drives, FrameMotion, HingeMotion};
use crate::hinge::{Hinge, HingeKind, Source};
use crate::mechanism::Mechanism;
use crate::random::{Random, round_to};
use crate::random_chain::flattened;
use crate::relative::gimbal_regularity;
use crate::rotation::{self, Mat3, Vec3};
use std::f64::consts::PI;
use std::iter;

/// The largest number of states that are tried.
const TRIES: usize = 3000;
/// The largest number of states that are tried to find out whether a chain has any.
const TRIAL: usize = 20;
/// The lower bound of [`Chain::closure_strength`]: weaker loop constraints magnify errors.
const STRENGTH: f64 = 0.1;
/// The highest rate of a closed chain; with a weak loop constraint, rates can be high.
const FASTEST: f64 = 10.0;
/// The largest of the small angles of an elastic hinge, in rad.
const SMALL_ANGLE: f64 = 0.6;
/// The smallest regularity of a gimbal: its rates are high where its axes are almost in one plane.
const LEAST_REGULARITY: f64 = 0.5;
/// The smallest distance of coordinates from limits, where efforts can jump, in m or rad.
const MARGIN: f64 = 1e-3;
/// The smallest distance of rotations with a spring from half a turn, where its torque jumps, in rad.
const FROM_HALF_A_TURN: f64 = 0.15;
/// The shortest spring to the ground in m: the direction of a shorter one is ill-determined.
const SHORTEST_SPRING: f64 = 0.05;

/// Returns a random state of the chain: any orientations and angles, rates in ±2, and a floating base
/// within two metres of the origin. Moving ends and prescribed hinges are as in [`Drives::none`].
///
/// # Panics
///
/// Panics when no state is found in which a closed chain closes.
pub fn random_state(random: &mut Random, chain: &Chain) -> State {
    let drives = Drives::none(chain);
    for _ in 0..TRIES {
        let guess = random_guess(random, chain);
        if let Some(state) = accepted(chain, &drives, guess) {
            return state;
        }
    }
    panic!("chain {}: no state has been found", chain.name)
}

/// Returns random drives of the chain and a consistent state: a closed chain closes with its
/// prescribed motions and moving ends.
///
/// # Panics
///
/// Panics when no such state is found.
pub fn random_motion(random: &mut Random, chain: &Chain) -> (State, Drives) {
    let found = (0..TRIES).find_map(|_| motion(random, chain));
    found.unwrap_or_else(|| panic!("chain {}: no motion has been found", chain.name))
}

/// Returns random efforts in ±5 (N, N·m) for motors with inputs and zero for all other rates.
pub fn random_efforts(random: &mut Random, chain: &Chain) -> Vec<f64> {
    let mut efforts = vec![0.0; chain.base_dof_count()];
    for hinge in chain.hinges().filter(|hinge| !hinge.prescribed) {
        for (group, rates) in hinge.groups() {
            let input = group.motor == Source::Input;
            efforts.extend(rates.map(|_| if input { random.between(-5.0, 5.0) } else { 0.0 }));
        }
    }
    efforts
}

/// Returns whether a chain has states, and, if closed, states with a well-conditioned constraint.
pub(crate) fn has_states(random: &mut Random, chain: &Chain) -> bool {
    (0..TRIAL).any(|_| motion(random, chain).is_some())
}

/// Returns a frame at which the finish of a closed chain can be held, in short decimals.
pub(crate) fn closing_frame(random: &mut Random, chain: &Chain) -> Frame {
    let drives = random_drives(random, chain);
    let guess = random_guess(random, chain);
    let end = end_of_chain(&Mechanism::new(chain, &drives), &guess);
    let r = end.rotation;
    let pitch = (-r[(2, 0)]).atan2(r[(2, 1)].hypot(r[(2, 2)]));
    let angles = [r[(2, 1)].atan2(r[(2, 2)]), pitch, r[(1, 0)].atan2(r[(0, 0)])];
    Frame {
        position: <[f64; 3]>::from(end.position).map(|x| round_to(x, 2)),
        rpy_degrees: angles.map(|angle| round_to(angle.to_degrees(), 1)),
    }
}

/// Returns random coordinates of a hinge.
pub(crate) fn random_coordinates(random: &mut Random, kind: &HingeKind) -> Vec<f64> {
    let mut q = Vec::new();
    let mut shifts = |random: &mut Random, size: f64| {
        q.extend(kind.linear().map(|_| random.between(-size, size)));
    };
    match kind {
        HingeKind::Elastic => {
            shifts(random, 0.5);
            q.extend([0.0; 2].map(|_: f64| random.between(-SMALL_ANGLE, SMALL_ANGLE)));
            q.push(random.between(-PI, PI));
        }
        HingeKind::Ball | HingeKind::Floating => {
            shifts(random, 1.0);
            q.extend(random_quaternion(random));
        }
        HingeKind::Gimbal { axes } => {
            let mut angles = || [0.0; 3].map(|_: f64| random.between(-PI, PI));
            let regular = |q: &[f64; 3]| gimbal_regularity(axes, q) > LEAST_REGULARITY;
            q.extend(iter::repeat_with(&mut angles).find(regular).expect("half of all angles"));
        }
        _ => {
            shifts(random, 1.0);
            q.extend(kind.turning().map(|_| random.between(-PI, PI)));
        }
    }
    q
}

/// Returns a uniformly distributed unit quaternion (w, x, y, z).
pub(crate) fn random_quaternion(random: &mut Random) -> [f64; 4] {
    loop {
        let candidate = [0.0; 4].map(|_: f64| random.between(-1.0, 1.0));
        let length = candidate.iter().map(|component| component * component).sum::<f64>().sqrt();
        // Rejection leaves a ball, without its centre, where the division loses digits.
        if (0.1..=1.0).contains(&length) {
            return candidate.map(|component| component / length);
        }
    }
}

/// Returns coordinates and rates without regard to a loop constraint.
fn random_guess(random: &mut Random, chain: &Chain) -> State {
    let mut q: Vec<f64> = Vec::new();
    if chain.floats() {
        let shifts = HingeKind::of_base(chain.dimension).linear();
        q.extend(shifts.map(|_| random.between(-2.0, 2.0)));
        match chain.dimension {
            Dimension::Space => q.extend(random_quaternion(random)),
            Dimension::Plane => q.push(random.between(-PI, PI)),
            Dimension::Line => {}
        }
    }
    for hinge in chain.hinges().filter(|hinge| !hinge.prescribed) {
        q.extend(random_coordinates(random, &hinge.kind));
    }
    let v = (0..chain.dof_count()).map(|_| random.between(-2.0, 2.0)).collect();
    State { q, v }
}

/// Returns drives without regard to a loop constraint.
fn random_drives(random: &mut Random, chain: &Chain) -> Drives {
    let dimension = chain.dimension;
    let mut drives = Drives { efforts: random_efforts(random, chain), ..Drives::none(chain) };
    let prescribed = chain.hinges().filter(|hinge| hinge.prescribed);
    for (hinge, motion) in prescribed.zip(&mut drives.motions) {
        let dof_count = hinge.kind.dof_count();
        *motion = HingeMotion {
            q: random_coordinates(random, &hinge.kind),
            v: (0..dof_count).map(|_| random.between(-1.5, 1.5)).collect(),
            a: (0..dof_count).map(|_| random.between(-3.0, 3.0)).collect(),
        };
    }
    let ends = [(&chain.start, &mut drives.start), (chain.attached_finish(), &mut drives.finish)];
    let later = chain.later_routes.iter().map(|route| &route.start).zip(&mut drives.route_starts);
    let ends = ends.into_iter().chain(later);
    for (_, motion) in ends.filter(|(end, _)| matches!(end, End::Moving { .. })) {
        *motion = random_frame_motion(random, dimension);
    }
    for (load, input) in chain.loads.iter().zip(&mut drives.loads) {
        if load.force == Source::Input {
            input.force = random_vector(random, 8.0, dimension);
        }
        if load.torque == Source::Input {
            input.torque = random_turning(random, 8.0, dimension);
        }
    }
    let mut beside = random.beside();
    for (spring, input) in chain.springs.iter().zip(&mut drives.springs) {
        if spring.force == Source::Input {
            *input = beside.between(-8.0, 8.0);
        }
    }
    if chain.gravity == Gravity::Input {
        drives.gravity = random_vector(random, 8.0, dimension);
    }
    drives
}

fn random_frame_motion(random: &mut Random, dimension: Dimension) -> FrameMotion {
    let half_angle = random.between(-0.5 * PI, 0.5 * PI);
    FrameMotion {
        position: random_vector(random, 1.0, dimension),
        orientation: match dimension {
            Dimension::Space => random_quaternion(random),
            Dimension::Plane => [half_angle.cos(), 0.0, 0.0, half_angle.sin()],
            Dimension::Line => [1.0, 0.0, 0.0, 0.0],
        },
        velocity: random_vector(random, 1.0, dimension),
        rate: random_turning(random, 1.0, dimension),
        acceleration: random_vector(random, 3.0, dimension),
        rate_derivative: random_turning(random, 3.0, dimension),
    }
}

fn random_vector(random: &mut Random, size: f64, dimension: Dimension) -> [f64; 3] {
    flattened([0.0; 3].map(|_: f64| random.between(-size, size)), dimension)
}

/// Returns a random vector about which something rotates.
fn random_turning(random: &mut Random, size: f64, dimension: Dimension) -> [f64; 3] {
    let [x, y, z] = [0.0; 3].map(|_: f64| random.between(-size, size));
    match dimension {
        Dimension::Space => [x, y, z],
        Dimension::Plane => [0.0, 0.0, z],
        Dimension::Line => [0.0; 3],
    }
}

/// Tries to find drives and a state that agrees with them.
fn motion(random: &mut Random, chain: &Chain) -> Option<(State, Drives)> {
    let mut drives = random_drives(random, chain);
    let guess = random_guess(random, chain);
    if chain.closed() {
        meet(chain, &guess, &mut drives);
    }
    accepted(chain, &drives, guess).map(|state| (state, drives))
}

/// Moves a moving end of a closed chain to where the chain closes with the given coordinates.
fn meet(chain: &Chain, guess: &State, drives: &mut Drives) {
    let moving = |end: &End| matches!(end, End::Moving { .. });
    if moving(chain.attached_finish()) {
        let end = end_of_chain(&Mechanism::new(chain, drives), guess);
        put(&mut drives.finish, end.position, end.rotation);
    } else if moving(&chain.start) {
        put(&mut drives.start, Vec3::zeros(), Mat3::identity());
        let mechanism = Mechanism::new(chain, drives);
        let end = end_of_chain(&mechanism, guess);
        let finish = finish_of(&mechanism);
        let rotation = finish.rotation * end.rotation.transpose();
        put(&mut drives.start, finish.position - rotation * end.position, rotation);
    }
}

fn put(frame: &mut FrameMotion, position: Vec3, rotation: Mat3) {
    frame.position = position.into();
    frame.orientation = rotation::to_quaternion(&rotation, &[1.0, 0.0, 0.0, 0.0]);
}

/// Returns the state near a guess that agrees with the drives, if it exists and is well-conditioned.
fn accepted(chain: &Chain, drives: &Drives, guess: State) -> Option<State> {
    let state = if chain.closed() { chain.close(&guess, drives)? } else { guess };
    if chain.closed() {
        let (strength, _) = chain.closure_strength(&state, drives);
        if strength < STRENGTH || state.v.iter().any(|rate| rate.abs() > FASTEST) {
            return None;
        }
    }
    let mechanism = Mechanism::new(chain, drives);
    let motions = mechanism.motions(&state);
    let springs = mechanism.external_loads.iter().filter_map(|load| load.stretched(&motions));
    let mut lengths = springs.map(|spring| spring.length);
    let hinges_fit = mechanism.joints.iter().all(|joint| fits(joint.hinge, joint.q(&state)));
    (hinges_fit && lengths.all(|length| length > SHORTEST_SPRING)).then_some(state)
}

/// Returns whether the coordinates of a hinge are far from jumps of its efforts.
fn fits(hinge: &Hinge, q: &[f64]) -> bool {
    let regular = match &hinge.kind {
        HingeKind::Elastic => q[3].abs().max(q[4].abs()) <= SMALL_ANGLE,
        HingeKind::Gimbal { axes } => gimbal_regularity(axes, q) > LEAST_REGULARITY,
        _ => true,
    };
    regular
        && hinge.groups().into_iter().enumerate().all(|(number, (group, strained))| {
            let range = group.limits.as_ref().map(|limits| limits.range);
            if number == 1 && hinge.kind.has_quaternion() {
                let rest = hinge.rest_coordinates();
                let turn = rotation::vector_between(&rest[strained.start..], &q[strained.start..]);
                let angle = turn.norm();
                let acts = range.is_some() || !group.stiffness.is_empty();
                let clear = !acts || angle < PI - FROM_HALF_A_TURN;
                clear && range.is_none_or(|[_, most]| (angle - most).abs() > MARGIN)
            } else {
                let near = |q: f64, limit: f64| (q - limit).abs() <= MARGIN;
                let clear =
                    |q: &f64| range.is_none_or(|range| range.iter().all(|limit| !near(*q, *limit)));
                q[strained].iter().all(clear)
            }
        })
}
