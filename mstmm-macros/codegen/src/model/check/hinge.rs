//! Hinges: their axes and what moves them.

use crate::diag::Diagnostics;
use crate::model::condition::{Bound, Condition, Requirement};
use crate::model::length::{self, scaled};
use crate::model::lower::{Draft, RouteItem, Spanned, groups};
use crate::model::rules::right_angle_margins;
use crate::model::{DofGroup, Drive, HingeKind, Value};
use crate::syntax::{ArgumentsSyntax, FieldSyntax, OrientationSyntax, SpanRange, ValueSyntax};

/// Returns the readable hinges, with their arguments.
fn hinges<'d>(
    draft: &'d Draft,
) -> impl Iterator<Item = (&'d Spanned<HingeKind>, Option<&'d ArgumentsSyntax>)> {
    draft.items.iter().filter_map(|item| match item {
        RouteItem::Hinge { hinge_kind: Some(hinge_kind), arguments, .. } => {
            Some((hinge_kind, *arguments))
        }
        _ => None,
    })
}

/// Returns the span of an argument.
fn argument(
    hinge: &Spanned<HingeKind>,
    arguments: Option<&ArgumentsSyntax>,
    index: usize,
) -> SpanRange {
    let syntax = arguments.and_then(|arguments| arguments.values.get(index));
    syntax.map_or(hinge.at, |syntax| syntax.extent())
}

/// Requires axes that are not zero, and whose squares neither overflow nor vanish.
pub(super) fn axes_have_a_direction(draft: &Draft) -> Vec<Requirement> {
    let direction = |(hinge, arguments): (&Spanned<HingeKind>, Option<&ArgumentsSyntax>)| {
        let direction = |(index, axis): (usize, &[Value; 3])| {
            let at = argument(hinge, arguments, index);
            length::requirement(&scaled(axis), at, "an axis", "an axis of zeros has no direction")
        };
        hinge.value.axes().iter().enumerate().map(direction).collect::<Vec<_>>()
    };
    hinges(draft).flat_map(direction).collect()
}

/// Requires that successive axes of a universal hinge and of a gimbal are not parallel.
pub(super) fn successive_axes_are_not_parallel(draft: &Draft) -> Vec<Requirement> {
    let not_parallel = |(hinge, arguments): (&Spanned<HingeKind>, Option<&ArgumentsSyntax>)| {
        let message = "successive axes of a hinge must not be parallel";
        let pair = |(index, [a, b]): (usize, [&[Value; 3]; 2])| {
            let at = argument(hinge, arguments, index + 1);
            let sine = length::sine_margin([&scaled(a), &scaled(b)]);
            vec![
                Condition::silent(square(a), Bound::BePositive, at),
                Condition::silent(square(b), Bound::BePositive, at),
                Condition::new(sine, Bound::BePositive, at, message),
            ]
        };
        hinge.value.successive_axes().enumerate().map(pair).collect::<Vec<_>>()
    };
    hinges(draft).flat_map(not_parallel).collect()
}

/// Returns the squared length of an axis, which is scaled if it is known.
fn square(axis: &[Value; 3]) -> Value {
    length::squared(&scaled(axis))
}

/// Requires pitch angles of elastic hinges below a right angle, where the angles are singular.
pub(super) fn elastic_pitches_are_less_than_a_right_angle(draft: &Draft) -> Vec<Requirement> {
    let mut seen: Vec<&FieldSyntax> = Vec::new();
    let mut requirements = Vec::new();
    for (item, properties) in draft.items.iter().zip(&draft.properties) {
        let (RouteItem::Hinge { spec, .. }, Some(motion)) = (item, &properties.motion) else {
            continue;
        };
        let Some(pitch) = spec.groups.iter().find_map(DofGroup::pitch) else { continue };
        for (name, coordinates) in [("start", &motion.start), ("rest", &motion.rest)] {
            let Some(field) = properties.fields.get(name) else { continue };
            let Some(angle) = coordinates.get(pitch) else { continue };
            if seen.iter().any(|other| std::ptr::eq(*other, field)) {
                continue;
            }
            seen.push(field);
            let message = "the pitch angle of an elastic hinge must be between -90 deg and 90 deg";
            let margins = right_angle_margins(angle);
            let condition =
                |margin| Condition::new(margin, Bound::BePositive, pitch_of(field), message);
            requirements.push(margins.map(condition).to_vec());
        }
    }
    requirements
}

/// Returns the span of the second angle after `turned`.
fn pitch_of(field: &FieldSyntax) -> SpanRange {
    match &field.value {
        Some(ValueSyntax::Turned(_, OrientationSyntax::Form(form))) => {
            form.list.entries.get(1).map_or(form.extent(), |entry| entry.extent)
        }
        Some(other) => other.extent(),
        None => SpanRange::token(field.name.span()),
    }
}

/// Reports motors and start values of prescribed hinges, which have no part in the state.
pub(super) fn prescribed_motions_exclude_other_drives(
    draft: &Draft,
    diagnostics: &mut Diagnostics,
) {
    let mut reported: Vec<&FieldSyntax> = Vec::new();
    for (item, properties) in draft.items.iter().zip(&draft.properties) {
        let (RouteItem::Hinge { spec, .. }, Some(motion)) = (item, &properties.motion) else {
            continue;
        };
        if motion.drive != Drive::Prescribed {
            continue;
        }
        let names = groups(spec).flat_map(|(_, words)| [words.effort, words.start_rate]);
        let fields = names.chain(["start"]).filter_map(|name| properties.fields.get(name));
        for field in fields {
            if reported.iter().any(|other| std::ptr::eq(*other, field)) {
                continue;
            }
            reported.push(field);
            let name = &field.name;
            let message = format!(
                "`{name}` has no effect: `motion = input` prescribes the \
                                   motion of this hinge"
            );
            diagnostics.error(name.span(), message);
        }
    }
}
