//! A hinge written in the description language of the project.

use crate::chain::Dimension;
use crate::hinge::{Axis, Group, Hinge, HingeKind};
use crate::text::{section, source};

/// Returns the keyword and the arguments for a kind of hinge.
pub(crate) fn word(kind: &HingeKind, dimension: Dimension) -> String {
    let flat = dimension == Dimension::Plane;
    match kind {
        HingeKind::Weld => "weld".to_owned(),
        HingeKind::Pin { .. } if flat => "pin".to_owned(),
        HingeKind::Pin { axis } => format!("pin({})", written_axis(axis, flat)),
        HingeKind::Slider { .. } if dimension == Dimension::Line => "slider".to_owned(),
        HingeKind::Slider { axis } => format!("slider({})", written_axis(axis, flat)),
        HingeKind::Screw { axis, pitch } => {
            format!("screw({}, {pitch:?} m/rad)", written_axis(axis, flat))
        }
        HingeKind::Cylindrical { axis } => format!("cylindrical({})", written_axis(axis, flat)),
        HingeKind::Universal { first, second } => {
            format!("universal({}, {})", written_axis(first, flat), written_axis(second, flat))
        }
        HingeKind::Gimbal { axes } => {
            let [first, second, third] = axes.each_ref().map(|axis| written_axis(axis, flat));
            format!("gimbal({first}, {second}, {third})")
        }
        HingeKind::Ball => "ball".to_owned(),
        HingeKind::Planar { .. } if flat => "planar".to_owned(),
        HingeKind::Planar { normal } => {
            let normal = match normal {
                Axis::X => "x",
                Axis::Y => "y",
                Axis::Z => "z",
            };
            format!("planar({normal})")
        }
        HingeKind::Floating | HingeKind::PlaneFloating | HingeKind::LineFloating => {
            "floating".to_owned()
        }
        HingeKind::Elastic | HingeKind::PlaneElastic | HingeKind::LineElastic => {
            "elastic".to_owned()
        }
    }
}

/// Returns the block of a hinge, if it has properties.
pub(crate) fn section_of(hinge: &Hinge) -> Option<String> {
    let mut fields: Vec<String> = Vec::new();
    if !hinge.rest.is_empty() {
        fields.push(format!("rest = {}", rest(hinge)));
    }
    let both = !hinge.kind.linear().is_empty() && !hinge.kind.turning().is_empty();
    let prefix = if both { "turning_" } else { "" };
    fields.extend(group(&hinge.linear, "", &LINEAR, false));
    fields.extend(group(&hinge.turning, prefix, &TURNING, hinge.kind.has_quaternion()));
    if hinge.prescribed {
        fields.push("motion = input".to_owned());
    }
    (!fields.is_empty()).then(|| section("hinge", &hinge.name, &fields))
}

/// The keywords and units of a group of coordinates.
struct Units {
    coordinate: &'static str,
    rate: &'static str,
    stiffness: &'static str,
    damping: &'static str,
    armature: &'static str,
    effort: &'static str,
    effort_word: &'static str,
}

const LINEAR: Units = Units {
    coordinate: "m",
    rate: "m/s",
    stiffness: "N/m",
    damping: "N*s/m",
    armature: "kg",
    effort: "N",
    effort_word: "force",
};

const TURNING: Units = Units {
    coordinate: "rad",
    rate: "rad/s",
    stiffness: "N*m/rad",
    damping: "N*m*s/rad",
    armature: "kg*m^2",
    effort: "N*m",
    effort_word: "torque",
};

/// Returns the fields of one group of rates.
fn group(group: &Group, prefix: &str, units: &Units, by_angle: bool) -> Vec<String> {
    let mut fields: Vec<String> = Vec::new();
    let lists = [
        ("stiffness", &group.stiffness, units.stiffness),
        ("damping", &group.damping, units.damping),
        ("armature", &group.armature, units.armature),
        ("friction", &group.friction, units.effort),
    ];
    for (field, list, unit) in lists.iter().filter(|(_, list, _)| !list.is_empty()) {
        fields.push(format!("{prefix}{field} = {} {unit}", numbers(list)));
    }
    if !group.friction.is_empty() {
        let speed = group.friction_speed;
        fields.push(format!("{prefix}friction_speed = {speed:?} {}", units.rate));
    }
    if let Some(limits) = &group.limits {
        // Rotations with a quaternion are limited by one angle.
        let range = if by_angle { &limits.range[1..] } else { &limits.range };
        fields.push(format!("{prefix}limits = {} {}", numbers(range), units.coordinate));
        let Units { stiffness, damping, .. } = units;
        fields.push(format!("{prefix}limit_stiffness = {:?} {stiffness}", limits.stiffness));
        if limits.damping != 0.0 {
            fields.push(format!("{prefix}limit_damping = {:?} {damping}", limits.damping));
        }
    }
    let constant = |efforts: &Vec<f64>| format!("{} {}", numbers(efforts), units.effort);
    fields.extend(source(units.effort_word, &group.motor, constant));
    fields
}

/// Returns the coordinates of a hinge at rest.
fn rest(hinge: &Hinge) -> String {
    let q = &hinge.rest;
    let (shifts, turns) = q.split_at(hinge.kind.linear().end);
    let turned = match (&hinge.kind, turns) {
        (_, []) => String::new(),
        (_, [w, x, y, z]) => format!("quaternion({w:?}, {x:?}, {y:?}, {z:?})"),
        (HingeKind::Elastic, [x, y, z]) => format!("rpy({x:?}, {y:?}, {z:?}) rad"),
        _ => format!("{} rad", numbers(turns)),
    };
    match (shifts, turns) {
        ([], _) => turned,
        (_, []) => format!("{} m", numbers(shifts)),
        _ => format!("{} m turned {turned}", numbers(shifts)),
    }
}

/// Returns a number, or a list in brackets.
fn numbers(list: &[f64]) -> String {
    match list {
        [one] => format!("{one:?}"),
        several => format!("{several:?}"),
    }
}

fn written_axis(axis: &[f64; 3], flat: bool) -> String {
    match axis {
        [1.0, 0.0, 0.0] => "x".to_owned(),
        [0.0, 1.0, 0.0] => "y".to_owned(),
        [0.0, 0.0, 1.0] => "z".to_owned(),
        [x, y, _] if flat => format!("[{x:?}, {y:?}]"),
        _ => format!("{axis:?}"),
    }
}
