//! Hinges: their axes and what moves them.

use crate::diag::Diagnostics;
use crate::model::lower::{Draft, Given, Stop, groups};
use crate::model::{Drive, Form, HingeKind, Value};
use crate::syntax::{Arguments, Extent, Field, Turn, Written};
use std::f64::consts::FRAC_PI_2;

/// Two axes whose directions differ by less than this, in rad, are one.
const PARALLEL: f64 = 1e-6;

type Vector = [f64; 3];

/// The hinges that could be read, with what stands in parentheses behind their kinds.
fn hinges<'d>(
    draft: &'d Draft,
) -> impl Iterator<Item = (&'d Given<HingeKind>, Option<&'d Arguments>)> {
    draft.stops.iter().filter_map(|stop| match stop {
        Stop::Hinge { frees: Some(frees), arguments, .. } => Some((frees, *arguments)),
        _ => None,
    })
}

/// The axes of a hinge.
fn axes(kind: &HingeKind) -> &[[Value; 3]] {
    match kind {
        HingeKind::Pin { axis }
        | HingeKind::Slider { axis }
        | HingeKind::Screw { axis, .. }
        | HingeKind::Cylindrical { axis } => std::slice::from_ref(axis),
        HingeKind::Universal { axes } => axes,
        HingeKind::Weld
        | HingeKind::Ball
        | HingeKind::Planar { .. }
        | HingeKind::Floating
        | HingeKind::Elastic
        | HingeKind::PlaneElastic => &[],
    }
}

/// Where what stands at this place in the parentheses is.
fn argument(hinge: &Given<HingeKind>, arguments: Option<&Arguments>, index: usize) -> Extent {
    let written = arguments.and_then(|arguments| arguments.values.get(index));
    written.map_or(hinge.at, |written| written.extent())
}

/// An axis of zeros points nowhere; parameters count with their defaults.
pub(super) fn axes_have_a_direction(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for (hinge, arguments) in hinges(draft) {
        for (index, axis) in axes(&hinge.value).iter().enumerate() {
            if axis.iter().all(|component| component.at(&defaults) == Some(0.0)) {
                let at = argument(hinge, arguments, index);
                diagnostics.error_over(at, "an axis of zeros has no direction");
            }
        }
    }
}

/// Turns about two parallel axes are one turn; parameters count with their defaults.
pub(super) fn universal_axes_are_not_parallel(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for (hinge, arguments) in hinges(draft) {
        let HingeKind::Universal { axes } = &hinge.value else { continue };
        let [a, b] = axes.each_ref().map(|axis| direction(axis, &defaults));
        if let (Some(a), Some(b)) = (a, b)
            && sine(a, b) < PARALLEL
        {
            let message = "the two axes of a universal hinge must not be parallel";
            diagnostics.error_over(argument(hinge, arguments, 1), message);
        }
    }
}

/// An axis with its largest component 1, if it is known and has a direction.
fn direction(axis: &[Value; 3], defaults: &[Option<f64>]) -> Option<Vector> {
    let [x, y, z] = axis.each_ref().map(|component| component.at(defaults));
    let axis = [x?, y?, z?];
    let largest = axis.iter().fold(0.0_f64, |largest, component| largest.max(component.abs()));
    (largest > 0.0 && largest.is_finite()).then(|| axis.map(|component| component / largest))
}

/// The sine of the angle between two directions.
fn sine([a, b, c]: Vector, [x, y, z]: Vector) -> f64 {
    let length = |[x, y, z]: Vector| (x * x + y * y + z * z).sqrt();
    length([b * z - c * y, c * x - a * z, a * y - b * x]) / (length([a, b, c]) * length([x, y, z]))
}

/// The pitch of a screw is a finite number; parameters count with their defaults.
pub(super) fn pitches_are_finite(draft: &Draft, diagnostics: &mut Diagnostics) {
    let defaults = draft.defaults();
    for (hinge, arguments) in hinges(draft) {
        let HingeKind::Screw { pitch, .. } = &hinge.value else { continue };
        if pitch.at(&defaults).is_some_and(|pitch| !pitch.is_finite()) {
            let last = arguments.map_or(0, |arguments| arguments.values.len().saturating_sub(1));
            let at = argument(hinge, arguments, last);
            diagnostics.error_over(at, "with its parameters' defaults this pitch is not finite");
        }
    }
}

/// The angles of an elastic hinge say nothing where its pitch is a right angle; parameters count with
/// their defaults.
pub(super) fn elastic_pitches_are_less_than_a_right_angle(
    draft: &Draft,
    diagnostics: &mut Diagnostics,
) {
    let defaults = draft.defaults();
    let mut reported: Vec<&Field> = Vec::new();
    for (stop, properties) in draft.stops.iter().zip(&draft.properties) {
        let (Stop::Hinge { shape, .. }, Some(motion)) = (stop, &properties.motion) else {
            continue;
        };
        let Some(group) = shape.groups.iter().find(|group| group.form == Form::Angles) else {
            continue;
        };
        let pitch = group.coordinates.start + 1;
        for (name, coordinates) in [("start", &motion.start), ("rest", &motion.rest)] {
            let angle = coordinates.get(pitch).and_then(|angle| angle.at(&defaults));
            let is_wrong = angle.is_some_and(|angle| angle.abs() >= FRAC_PI_2);
            let Some(field) = properties.fields.get(name).filter(|_| is_wrong) else { continue };
            if reported.iter().any(|other| std::ptr::eq(*other, field)) {
                continue;
            }
            reported.push(field);
            let message = "the pitch of an elastic hinge lies between -90 deg and 90 deg";
            diagnostics.error_over(pitch_of(field), message);
        }
    }
}

/// Where the second of three angles stands behind `turned`.
fn pitch_of(field: &Field) -> Extent {
    match &field.value {
        Some(Written::Turned(_, Turn::Form(form))) => {
            form.list.entries.get(1).map_or(form.extent(), |entry| entry.extent)
        }
        Some(other) => other.extent(),
        None => Extent::token(field.name.span()),
    }
}

/// A hinge whose motion is given has no motor beside it, and is no part of the state that has a
/// start.
pub(super) fn motions_are_given_alone(draft: &Draft, diagnostics: &mut Diagnostics) {
    let mut reported: Vec<&Field> = Vec::new();
    for (stop, properties) in draft.stops.iter().zip(&draft.properties) {
        let (Stop::Hinge { shape, .. }, Some(motion)) = (stop, &properties.motion) else {
            continue;
        };
        if motion.drive != Drive::Motion {
            continue;
        }
        let names = groups(shape).flat_map(|(_, words)| [words.effort, words.start_rate]);
        let fields = names.chain(["start"]).filter_map(|name| properties.fields.get(name));
        for field in fields {
            if reported.iter().any(|other| std::ptr::eq(*other, field)) {
                continue;
            }
            reported.push(field);
            let name = &field.name;
            let message = format!("`{name}` says nothing here: the motion is given at each step");
            diagnostics.error(name.span(), message);
        }
    }
}
