//! Random motors, springs, dampers, friction, limits, rotors and loads of a chain.

use crate::chain::{Chain, Dimension, Element, Gravity};
use crate::hinge::{Group, Hinge, HingeKind, Limits, Source};
use crate::load::{Axes, BodyPoint, Load, Spring, SpringEnd};
use crate::random::{Random, round_to};
use crate::random_chain::{flattened, random_offset};
use crate::random_state::random_coordinates;
use crate::recipe::Recipe;

/// Adds motors to a hinge: inputs in all its groups, or constants in some.
pub(crate) fn add_motors(random: &mut Random, hinge: &mut Hinge, recipe: &Recipe) {
    let sizes = [hinge.kind.linear().len(), hinge.kind.turning().len()];
    if hinge.kind.dof_count() == 0 || !random.chance(recipe.motors) {
        return;
    }
    for (group, size) in [&mut hinge.linear, &mut hinge.turning].into_iter().zip(sizes) {
        if size > 0 {
            // No random number is drawn if there is no choice, so that plain chains do not change.
            let constant = recipe.constant_motors > 0.0 && random.chance(recipe.constant_motors);
            group.motor = if constant {
                Source::Constant((0..size).map(|_| random.rounded(-5.0, 5.0, 1)).collect())
            } else {
                Source::Input
            };
        }
    }
}

/// Adds everything else that acts in a chain, by a recipe.
pub(crate) fn add_forces(random: &mut Random, chain: &mut Chain, recipe: &Recipe) {
    let dimension = chain.dimension;
    let mut points = 0;
    let later = chain.later_routes.iter_mut().flat_map(|route| &mut route.elements);
    for element in chain.elements.iter_mut().chain(later) {
        match element {
            Element::Hinge(hinge) if hinge.kind.dof_count() > 0 => {
                add_passive(random, hinge, recipe);
                if recipe.prescribed > 0.0 && random.chance(recipe.prescribed) {
                    hinge.prescribed = true;
                    hinge.linear.motor = Source::None;
                    hinge.turning.motor = Source::None;
                }
            }
            Element::Hinge(_) => {}
            Element::Body(body) => {
                if recipe.loads > 0.0 && random.chance(recipe.loads) {
                    let name = format!("l{}", chain.loads.len() + 1);
                    let at = random_point(random, dimension, &mut points);
                    chain.loads.push(random_load(random, name, &body.name, at, dimension));
                }
                if recipe.springs > 0.0 && random.chance(recipe.springs) {
                    let name = format!("s{}", chain.springs.len() + 1);
                    let at = random_point(random, dimension, &mut points);
                    chain.springs.push(random_spring(random, name, &body.name, at, dimension));
                }
            }
        }
    }
    if recipe.gravity_inputs > 0.0 && random.chance(recipe.gravity_inputs) {
        chain.gravity = Gravity::Input;
    }
}

/// Adds springs, dampers and so on to a hinge.
fn add_passive(random: &mut Random, hinge: &mut Hinge, recipe: &Recipe) {
    let sizes = [hinge.kind.linear().len(), hinge.kind.turning().len()];
    let quaternion = hinge.kind.has_quaternion();
    let groups = [(&mut hinge.linear, false), (&mut hinge.turning, quaternion)];
    for ((group, quaternion), size) in groups.into_iter().zip(sizes) {
        if size > 0 && recipe.passive > 0.0 && random.chance(recipe.passive) {
            add_to_group(random, group, if quaternion { 1 } else { size });
            if random.chance(0.4) {
                group.limits = Some(random_limits(random, quaternion));
            }
        }
    }
    let springs = [&hinge.linear, &hinge.turning].iter().any(|group| !group.stiffness.is_empty());
    if springs && random.chance(0.6) {
        hinge.rest = random_rest(random, &hinge.kind);
    }
}

fn add_to_group(random: &mut Random, group: &mut Group, size: usize) {
    if random.chance(0.6) {
        group.stiffness = random_list(random, size, [1.0, 40.0]);
    }
    if random.chance(0.6) {
        group.damping = random_list(random, size, [0.1, 3.0]);
    }
    if random.chance(0.4) {
        group.armature = random_list(random, size, [0.05, 0.8]);
    }
    if random.chance(0.3) {
        group.friction = random_list(random, size, [0.1, 2.0]);
        group.friction_speed = random.rounded(0.1, 1.0, 1);
    }
}

/// Returns one random number for a whole group, or one for each member.
fn random_list(random: &mut Random, size: usize, [low, high]: [f64; 2]) -> Vec<f64> {
    let length = if random.chance(0.5) { 1 } else { size };
    (0..length).map(|_| random.rounded(low, high, 2)).collect()
}

fn random_limits(random: &mut Random, quaternion: bool) -> Limits {
    let range = if quaternion {
        [0.0, random.rounded(0.4, 2.5, 2)]
    } else {
        [random.rounded(-1.2, -0.1, 2), random.rounded(0.1, 1.2, 2)]
    };
    let damping = if random.chance(0.5) { random.rounded(0.1, 2.0, 2) } else { 0.0 };
    Limits { range, stiffness: random.rounded(5.0, 60.0, 1), damping }
}

/// Returns random coordinates of rest, short decimals.
fn random_rest(random: &mut Random, kind: &HingeKind) -> Vec<f64> {
    let coordinates = random_coordinates(random, kind);
    coordinates.iter().map(|q| round_to(0.5 * q, 2)).collect()
}

fn random_point(random: &mut Random, dimension: Dimension, points: &mut usize) -> BodyPoint {
    match random.below(5) {
        0 => BodyPoint::Com,
        1 => BodyPoint::Input,
        2 => BodyPoint::Output,
        3 => BodyPoint::At(random_offset(random, 1.0, dimension)),
        _ => {
            *points += 1;
            let position = random_offset(random, 1.0, dimension);
            BodyPoint::Named { name: format!("p{points}"), position }
        }
    }
}

fn random_load(
    random: &mut Random,
    name: String,
    body: &str,
    at: BodyPoint,
    dimension: Dimension,
) -> Load {
    let turning = |[_, _, z]: [f64; 3]| match dimension {
        Dimension::Plane => [0.0, 0.0, z],
        _ => [0.0; 3],
    };
    let mut source = |force: bool| {
        let value = [0.0; 3].map(|_: f64| random.rounded(-8.0, 8.0, 1));
        let value = match dimension {
            Dimension::Space => value,
            _ if force => flattened(value, dimension),
            _ => turning(value),
        };
        if random.chance(0.5) { Source::Input } else { Source::Constant(value) }
    };
    let (force, torque) = (source(true), source(false));
    let which = if dimension == Dimension::Line { 0 } else { random.below(3) };
    // Loads of line chains have no choice of axes.
    let axes = match dimension {
        Dimension::Line => Axes::Inertial,
        _ => *random.choose(&[Axes::Inertial, Axes::Body]),
    };
    Load {
        name,
        body: body.to_owned(),
        at,
        force: if which == 1 { Source::None } else { force },
        torque: if which == 0 { Source::None } else { torque },
        axes,
    }
}

/// Returns the force of the actuator of a spring.
pub(crate) fn random_actuator(random: &mut Random) -> Source<f64> {
    match random.below(4) {
        0 => Source::Input,
        1 => Source::Constant(random.rounded(-8.0, 8.0, 1)),
        _ => Source::None,
    }
}

fn random_spring(
    random: &mut Random,
    name: String,
    body: &str,
    at: BodyPoint,
    dimension: Dimension,
) -> Spring {
    Spring {
        name,
        body: body.to_owned(),
        at,
        to: SpringEnd::Ground(flattened(
            [0.0; 3].map(|_: f64| random.rounded(-2.0, 2.0, 1)),
            dimension,
        )),
        stiffness: random.rounded(1.0, 40.0, 1),
        damping: if random.chance(0.5) { random.rounded(0.1, 3.0, 2) } else { 0.0 },
        length: if random.chance(0.5) { random.rounded(0.1, 1.5, 2) } else { 0.0 },
        force: random_actuator(&mut random.beside()),
    }
}
