//! Random chains that are physically possible, with many special cases among their data.
//!
//! Code that omits values which are zero or one by construction has to be tested with such values. So
//! offsets are often zero or along an axis, frames often not rotated or rotated by right angles, and
//! axes of hinges often those of frames, in either direction.

use crate::chain::{About, Body, Chain, Dimension, Element, End, Frame, Gravity};
use crate::hinge::{Axis, Hinge, HingeKind};
use crate::random::{Random, round_to};
use crate::random_forces::{add_forces, add_motors};
use crate::random_state::{closing_frame, has_states, random_quaternion};
use crate::recipe::{Ends, HingeChoice, Recipe};
use crate::rotation::{self, Mat3, Vec3};

/// The largest number of chains that are tried.
pub(crate) const TRIES: usize = 1000;

/// Returns a chain in space of `bodies` bodies, joined by hinges of the given kinds, with gravity
/// and motors only.
///
/// All numbers are short decimals. Bodies are called `b1`, `b2`, … and hinges `j1`, `j2`, ….
///
/// # Panics
///
/// Panics like [`random_mechanism`].
pub fn random_chain(
    random: &mut Random,
    name: &str,
    bodies: usize,
    ends: Ends,
    kinds: &[HingeChoice],
) -> Chain {
    random_mechanism(random, name, &Recipe::plain(bodies, ends, kinds))
}

/// Returns a chain made by a recipe. Loads are called `l1`, …, springs `s1`, …, named points `p1`, …,
/// and the moving frames at the ends `base` and `tip`.
///
/// A closed chain has states in which it closes and in which its constraint is well-conditioned.
///
/// # Panics
///
/// Panics if there are no bodies or no kinds to choose from, or if no chain with states is found, as
/// with too few degrees of freedom in a closed chain.
pub fn random_mechanism(random: &mut Random, name: &str, recipe: &Recipe) -> Chain {
    let mut recipe = recipe.clone();
    let layout = recipe.layout();
    recipe.kinds.retain(|kind| kind.exists_in(layout));
    assert!(recipe.bodies > 0 && !recipe.kinds.is_empty(), "a chain needs bodies and hinges");
    let chain = (0..TRIES).find_map(|_| {
        let chain = bare_chain(random, name, &recipe);
        finished(random, chain, &recipe)
    });
    chain.unwrap_or_else(|| panic!("chain {name}: no chain like this has been found"))
}

/// Adds everything that acts in a chain, and the finish of a closed chain; returns nothing if the
/// chain then has no states.
pub(crate) fn finished(random: &mut Random, mut chain: Chain, recipe: &Recipe) -> Option<Chain> {
    add_forces(random, &mut chain, recipe);
    if recipe.flat {
        chain = chain.in_space();
    }
    if !recipe.ends.closed() && chain.springs.is_empty() {
        return Some(chain);
    }
    if recipe.ends == Ends::HeldHeld {
        chain.finish = End::Held(closing_frame(random, &chain));
    }
    has_states(random, &chain).then_some(chain)
}

impl Recipe {
    /// Returns the dimension that contains the whole chain.
    pub(crate) fn layout(&self) -> Dimension {
        if self.flat { Dimension::Plane } else { self.dimension }
    }
}

impl Chain {
    /// Returns a plane or line chain as a chain in space: hinges with the same degrees of freedom keep
    /// it in its plane or on its line.
    ///
    /// # Panics
    ///
    /// Panics at an elastic hinge of a plane chain, since the elastic hinge in space has more degrees
    /// of freedom.
    pub fn in_space(&self) -> Chain {
        let mut chain = Chain { dimension: Dimension::Space, ..self.clone() };
        for element in chain.all_elements_mut() {
            let Element::Hinge(hinge) = element else { continue };
            match hinge.kind {
                HingeKind::PlaneFloating => hinge.kind = HingeKind::Planar { normal: Axis::Z },
                HingeKind::LineFloating | HingeKind::LineElastic => {
                    hinge.kind = HingeKind::Slider { axis: [1.0, 0.0, 0.0] };
                }
                HingeKind::PlaneElastic => panic!("hinge {}: elastic in the plane", hinge.name),
                _ => {}
            }
        }
        chain
    }
}

/// Returns a chain with motors and gravity. A held finish of a closed chain is still at the inertial
/// frame.
pub(crate) fn bare_chain(random: &mut Random, name: &str, recipe: &Recipe) -> Chain {
    let layout = recipe.layout();
    let mut elements = Vec::new();
    let mut hinges = 0;
    let mut hinge = |random: &mut Random| {
        hinges += 1;
        Element::Hinge(random_hinge(random, format!("j{hinges}"), recipe))
    };
    for body in 1..=recipe.bodies {
        if body > 1 || !recipe.ends.free_start() {
            elements.push(hinge(random));
        }
        elements.push(Element::Body(random_body(random, format!("b{body}"), layout)));
    }
    if !recipe.ends.free_finish() {
        elements.push(hinge(random));
    }
    let (start, finish) = random_ends(random, recipe);
    let gravity = Gravity::Constant(random_gravity(random, layout));
    let plain = Chain::new(name, [0.0; 3], elements);
    Chain { dimension: layout, gravity, start, finish, ..plain }
}

fn random_ends(random: &mut Random, recipe: &Recipe) -> (End, End) {
    let [base, tip] = ["base", "tip"].map(|name| End::Moving { name: name.to_owned() });
    let mut held = || End::Held(random_ground(random, recipe.layout()));
    match recipe.ends {
        Ends::HeldFree => (held(), End::Free),
        Ends::FreeFree => (End::Free, End::Free),
        Ends::FreeHeld => (End::Free, held()),
        Ends::HeldHeld => (held(), End::Held(Frame::IDENTITY)),
        Ends::MovingFree => (base, End::Free),
        Ends::FreeMoving => (End::Free, tip),
        Ends::HeldMoving => (held(), tip),
        Ends::MovingHeld => (base, held()),
        Ends::MovingMoving => (base, tip),
    }
}

pub(crate) fn random_hinge(random: &mut Random, name: String, recipe: &Recipe) -> Hinge {
    let layout = recipe.layout();
    let kind = match (random.choose(&recipe.kinds), layout) {
        (HingeChoice::Weld, _) => HingeKind::Weld,
        (HingeChoice::Pin, Dimension::Plane) => HingeKind::Pin { axis: [0.0, 0.0, 1.0] },
        (HingeChoice::Pin, _) => HingeKind::Pin { axis: random_axis(random) },
        (HingeChoice::Ball, _) => HingeKind::Ball,
        (HingeChoice::Slider, Dimension::Line) => HingeKind::Slider { axis: [1.0, 0.0, 0.0] },
        (HingeChoice::Slider, _) => HingeKind::Slider { axis: random_axis_in(random, layout) },
        (HingeChoice::Screw, _) => {
            let pitch = random.rounded(0.05, 0.6, 2);
            let axis = random_axis(random);
            HingeKind::Screw { axis, pitch: if random.chance(0.7) { pitch } else { -pitch } }
        }
        (HingeChoice::Cylindrical, _) => HingeKind::Cylindrical { axis: random_axis(random) },
        (HingeChoice::Universal, _) => random_universal(random),
        (HingeChoice::Gimbal, _) => random_gimbal(random),
        (HingeChoice::Planar, Dimension::Plane) => HingeKind::Planar { normal: Axis::Z },
        (HingeChoice::Planar, _) => {
            HingeKind::Planar { normal: *random.choose(&[Axis::X, Axis::Y, Axis::Z]) }
        }
        (HingeChoice::Floating, Dimension::Space) => HingeKind::Floating,
        (HingeChoice::Floating, Dimension::Plane) => HingeKind::PlaneFloating,
        (HingeChoice::Floating, Dimension::Line) => HingeKind::LineFloating,
        (HingeChoice::Elastic, Dimension::Space) => HingeKind::Elastic,
        (HingeChoice::Elastic, Dimension::Plane) => HingeKind::PlaneElastic,
        (HingeChoice::Elastic, Dimension::Line) => HingeKind::LineElastic,
    };
    let mut hinge = Hinge { name, ..Hinge::new("", kind) };
    add_motors(random, &mut hinge, recipe);
    hinge
}

/// Returns the direction of an axis: along an axis of the frame, in a plane of two axes, or oblique.
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

/// Returns the direction of an axis, in the plane if the chain is a plane chain.
fn random_axis_in(random: &mut Random, dimension: Dimension) -> [f64; 3] {
    loop {
        let [x, y, z] = random_axis(random);
        match dimension {
            Dimension::Plane if x == 0.0 && y == 0.0 => {}
            Dimension::Plane => return [x, y, 0.0],
            _ => return [x, y, z],
        }
    }
}

/// Returns a universal hinge whose axes are at least 30 degrees apart.
fn random_universal(random: &mut Random) -> HingeKind {
    loop {
        let (first, second) = (random_axis(random), random_axis(random));
        let [a, b] = [first, second].map(|axis| Vec3::from(axis).normalize());
        if a.cross(&b).norm() > 0.5 {
            return HingeKind::Universal { first, second };
        }
    }
}

/// Returns a gimbal with successive axes at least 30 degrees apart.
fn random_gimbal(random: &mut Random) -> HingeKind {
    loop {
        let axes = [0; 3].map(|_| random_axis(random));
        let [a, b, c] = axes.map(|axis| Vec3::from(axis).normalize());
        if a.cross(&b).norm().min(b.cross(&c).norm()) > 0.5 {
            return HingeKind::Gimbal { axes };
        }
    }
}

pub(crate) fn random_body(random: &mut Random, name: String, dimension: Dimension) -> Body {
    let mass = random.rounded(0.2, 5.0, 2);
    let com = random_offset(random, 0.6, dimension);
    let position = random_offset(random, 1.2, dimension);
    let output = Frame { position, rpy_degrees: random_turn(random, dimension) };
    let about = *random.choose(&[About::Input, About::Com]);
    let inertia = random_inertia(random, mass, com, about);
    Body { name, mass, com, output, inertia, about, points: Vec::new() }
}

/// Returns an offset in m: zero, along an axis, or oblique.
pub(crate) fn random_offset(random: &mut Random, size: f64, dimension: Dimension) -> [f64; 3] {
    let mut offset = [0.0; 3];
    if random.chance(0.15) {
        return offset;
    }
    if random.chance(0.5) {
        let length = random.rounded(0.1, size, 2);
        offset[random.below(3)] = if random.chance(0.7) { length } else { -length };
        return flattened(offset, dimension);
    }
    flattened(offset.map(|_: f64| random.rounded(-size, size, 2)), dimension)
}

/// Returns a vector without the components that the dimension does not have.
pub(crate) fn flattened([x, y, z]: [f64; 3], dimension: Dimension) -> [f64; 3] {
    match dimension {
        Dimension::Space => [x, y, z],
        Dimension::Plane => [x, y, 0.0],
        Dimension::Line => [x, 0.0, 0.0],
    }
}

/// Returns roll, pitch and yaw in degrees: zero, right angles, or any angles.
pub(crate) fn random_turn(random: &mut Random, dimension: Dimension) -> [f64; 3] {
    let mut turn = [0.0; 3];
    if random.chance(0.4) {
        return turn;
    }
    if random.chance(0.3) {
        turn[random.below(3)] = *random.choose(&[90.0, -90.0, 180.0]);
    } else if random.chance(0.3) {
        turn = turn.map(|_: f64| *random.choose(&[0.0, 90.0, -90.0, 180.0]));
    } else {
        turn = turn.map(|_: f64| random.rounded(-180.0, 180.0, 1));
    }
    match dimension {
        Dimension::Space => turn,
        Dimension::Plane => [0.0, 0.0, turn[2]],
        Dimension::Line => [0.0; 3],
    }
}

/// Returns the inertia of a solid box, along the body axes or oblique, about the given point.
///
/// The ratio of the sides is at most ten, so that rounding cannot make the tensor impossible.
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

pub(crate) fn random_ground(random: &mut Random, dimension: Dimension) -> Frame {
    if random.chance(0.5) {
        return Frame::IDENTITY;
    }
    let position = random_offset(random, 2.0, dimension);
    Frame { position, rpy_degrees: random_turn(random, dimension) }
}

fn random_gravity(random: &mut Random, dimension: Dimension) -> [f64; 3] {
    let gravity = if random.chance(0.3) {
        [0.0; 3].map(|_: f64| random.rounded(-6.0, 6.0, 2))
    } else {
        *random.choose(&[[0.0, -9.8, 0.0], [0.0, 0.0, -9.81], [9.81, 0.0, 0.0], [0.0, 0.0, 0.0]])
    };
    flattened(gravity, dimension)
}
