//! Random chains that are physically possible, with many special cases among their data.
//!
//! Code that leaves out what is zero or one by construction has to be tested where there is
//! something to leave out. So offsets are often zero or along an axis, frames often untouched or
//! turned by quarter turns, and pins often along an axis, one way or the other.

use crate::chain::{About, Body, Chain, Element, End, Frame, Hinge, HingeKind, State};
use crate::random::{Random, round_to};
use crate::rotation::{self, Mat3, Vec3};
use std::f64::consts::PI;

/// Which ends of a random chain are held.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ends {
    /// The start is held and the finish free.
    HeldFree,
    /// Both ends are free: the chain floats.
    FreeFree,
    /// The start is free and the finish held.
    FreeHeld,
}

/// The kinds of hinges a random chain may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joining {
    /// Bodies welded together.
    Weld,
    /// Pins about axes of all directions.
    Pin,
    /// Balls.
    Ball,
}

/// Makes a chain of `bodies` bodies, joined by hinges of the given kinds.
///
/// All numbers are short decimals. Bodies are called `b1`, `b2`, … and hinges `j1`, `j2`, ….
///
/// # Panics
///
/// Panics when there are no bodies or no kinds to choose from.
pub fn random_chain(
    random: &mut Random,
    name: &str,
    bodies: usize,
    ends: Ends,
    kinds: &[Joining],
) -> Chain {
    assert!(bodies > 0 && !kinds.is_empty(), "a chain needs bodies and kinds of hinges");
    let mut elements = Vec::new();
    let mut hinges = 0;
    let mut hinge = |random: &mut Random| {
        hinges += 1;
        Element::Hinge(random_hinge(random, format!("j{hinges}"), kinds))
    };
    for body in 1..=bodies {
        if body > 1 || ends == Ends::HeldFree {
            elements.push(hinge(random));
        }
        elements.push(Element::Body(random_body(random, format!("b{body}"))));
    }
    if ends == Ends::FreeHeld {
        elements.push(hinge(random));
    }
    let (start, finish) = match ends {
        Ends::HeldFree => (End::Held(random_ground(random)), End::Free),
        Ends::FreeFree => (End::Free, End::Free),
        Ends::FreeHeld => (End::Free, End::Held(random_ground(random))),
    };
    Chain { name: name.to_owned(), gravity: random_gravity(random), start, finish, elements }
}

/// Makes a state of the chain: any orientations and angles, rates up to two either way, and a
/// floating base within two metres of the origin.
pub fn random_state(random: &mut Random, chain: &Chain) -> State {
    let mut q: Vec<f64> = Vec::new();
    if chain.floats() {
        q.extend((0..3).map(|_| random.between(-2.0, 2.0)));
        q.extend(random_quaternion(random));
    }
    for hinge in chain.hinges() {
        match hinge.kind {
            HingeKind::Weld => {}
            HingeKind::Pin { .. } => q.push(random.between(-PI, PI)),
            HingeKind::Ball => q.extend(random_quaternion(random)),
        }
    }
    let v = (0..chain.freedoms()).map(|_| random.between(-2.0, 2.0)).collect();
    State { q, v }
}

/// Makes efforts up to five newton metres either way at the motors and zero elsewhere.
pub fn random_efforts(random: &mut Random, chain: &Chain) -> Vec<f64> {
    let mut efforts = vec![0.0; if chain.floats() { 6 } else { 0 }];
    for hinge in chain.hinges() {
        let of_hinge = |_| if hinge.motor { random.between(-5.0, 5.0) } else { 0.0 };
        efforts.extend((0..hinge.kind.freedoms()).map(of_hinge));
    }
    efforts
}

fn random_hinge(random: &mut Random, name: String, kinds: &[Joining]) -> Hinge {
    let kind = match random.choose(kinds) {
        Joining::Weld => HingeKind::Weld,
        Joining::Pin => HingeKind::Pin { axis: random_axis(random) },
        Joining::Ball => HingeKind::Ball,
    };
    let motor = kind.freedoms() > 0 && random.chance(0.5);
    Hinge { name, kind, motor }
}

/// Makes the direction of a pin: along an axis, in a plane of two axes, or askew.
fn random_axis(random: &mut Random) -> [f64; 3] {
    let mut axis = [0.0; 3];
    if random.chance(0.6) {
        axis[random.below(3)] = *random.choose(&[1.0, -1.0]);
        return axis;
    }
    let zero = if random.chance(0.3) { Some(random.below(3)) } else { None };
    for (k, component) in axis.iter_mut().enumerate() {
        let size = random.rounded(0.1, 1.5, 2);
        let signed = if random.chance(0.5) { size } else { -size };
        *component = if Some(k) == zero { 0.0 } else { signed };
    }
    axis
}

fn random_body(random: &mut Random, name: String) -> Body {
    let mass = random.rounded(0.2, 5.0, 2);
    let com = random_offset(random, 0.6);
    let output = Frame { position: random_offset(random, 1.2), rpy_degrees: random_turn(random) };
    let about = *random.choose(&[About::Input, About::Com]);
    let inertia = random_inertia(random, mass, com, about);
    Body { name, mass, com, output, inertia, about }
}

/// Makes an offset in m: none, along an axis, or askew.
fn random_offset(random: &mut Random, size: f64) -> [f64; 3] {
    let mut offset = [0.0; 3];
    if random.chance(0.15) {
        return offset;
    }
    if random.chance(0.5) {
        let length = random.rounded(0.1, size, 2);
        offset[random.below(3)] = if random.chance(0.7) { length } else { -length };
        return offset;
    }
    offset.map(|_: f64| random.rounded(-size, size, 2))
}

/// Makes roll, pitch and yaw in degrees: none, quarter turns, or any.
fn random_turn(random: &mut Random) -> [f64; 3] {
    let mut turn = [0.0; 3];
    if random.chance(0.4) {
        return turn;
    }
    if random.chance(0.3) {
        turn[random.below(3)] = *random.choose(&[90.0, -90.0, 180.0]);
        return turn;
    }
    if random.chance(0.3) {
        return turn.map(|_: f64| *random.choose(&[0.0, 90.0, -90.0, 180.0]));
    }
    turn.map(|_: f64| random.rounded(-180.0, 180.0, 1))
}

/// Makes the inertia of a solid box, along the body axes or askew, about the point asked for.
///
/// The sides keep within a factor of ten, so that rounding cannot make the tensor impossible.
fn random_inertia(random: &mut Random, mass: f64, com: [f64; 3], about: About) -> [f64; 6] {
    let squares = Vec3::from_fn(|_, _| random.between(0.1, 1.0).powi(2));
    let moments = Vec3::repeat(squares.sum()) - squares;
    let along_axes = Mat3::from_diagonal(&(moments * (mass / 12.0)));
    let about_com = if random.chance(0.4) {
        along_axes
    } else {
        let turn = rotation::from_quaternion(&random_quaternion(random));
        turn * along_axes * turn.transpose()
    };
    let offset = rotation::cross_matrix(&Vec3::from(com));
    let tensor = match about {
        About::Com => about_com,
        About::Input => about_com - mass * offset * offset,
    };
    let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
    entries.map(|entry| round_to(tensor[entry], 6))
}

fn random_ground(random: &mut Random) -> Frame {
    if random.chance(0.5) {
        return Frame::IDENTITY;
    }
    Frame { position: random_offset(random, 2.0), rpy_degrees: random_turn(random) }
}

fn random_gravity(random: &mut Random) -> [f64; 3] {
    if random.chance(0.3) {
        return [0.0; 3].map(|_: f64| random.rounded(-6.0, 6.0, 2));
    }
    *random.choose(&[[0.0, -9.8, 0.0], [0.0, 0.0, -9.81], [9.81, 0.0, 0.0], [0.0, 0.0, 0.0]])
}

/// Makes a unit quaternion (w, x, y, z), all orientations being equally likely.
fn random_quaternion(random: &mut Random) -> [f64; 4] {
    loop {
        let candidate = [0.0; 4].map(|_: f64| random.between(-1.0, 1.0));
        let length = candidate.iter().map(|component| component * component).sum::<f64>().sqrt();
        // What is left of the cube is a ball, without the middle where dividing loses digits.
        if (0.1..=1.0).contains(&length) {
            return candidate.map(|component| component / length);
        }
    }
}
