//! Springs, dampers, friction, limits and rotors of hinges.

use crate::diag::Diagnostics;
use crate::model::condition::{Bound, Condition, Requirement};
use crate::model::lower::{Draft, FieldNames, Fields, RouteItem, groups, listed};
use crate::model::rules::{LARGEST_ANGLE, PASSIVE, PassiveRule, WIDTH};
use crate::model::{DofGroup, Passive, Representation};
use crate::syntax::{FieldSyntax, SpanRange, ValueSyntax};

/// Fields that need another field, with usual values of this field for translations and for rotations.
const NEEDED: &[(FieldName, FieldName, Option<[&str; 2]>)] = &[
    (|names| names.friction, |names| names.friction_speed, Some(["1 mm/s", "0.01 rad/s"])),
    (|names| names.limits, |names| names.limit_stiffness, Some(["100 N/mm", "100 N*m/deg"])),
    (|names| names.friction_speed, |names| names.friction, None),
    (|names| names.limit_stiffness, |names| names.limits, None),
    (|names| names.limit_damping, |names| names.limits, None),
];

/// The message for a limit of an angle that is measured by the shorter way.
const NEVER_REACHED: &str = "this angle is never larger than 180 deg: a larger limit has no effect; a number without a unit is in rad";

type FieldName = fn(&FieldNames) -> &'static str;

/// The fields of a group of degrees of freedom.
struct PassiveGroup<'d> {
    fields: &'d Fields<'d>,
    names: &'static FieldNames,
    rotational: bool,
    representation: Representation,
    passive: &'d [Passive],
}

/// Returns all groups of all readable hinges.
fn all_groups<'d>(draft: &'d Draft) -> impl Iterator<Item = PassiveGroup<'d>> {
    let hinges = draft.items.iter().zip(&draft.properties).filter_map(|(item, properties)| {
        let RouteItem::Hinge { spec, .. } = item else { return None };
        Some((*spec, &properties.fields, properties.motion.as_ref()?))
    });
    hinges.flat_map(|(spec, fields, motion)| {
        groups(spec).map(move |(group, names)| {
            let passive = &motion.passive[group.rates.clone()];
            let DofGroup { rotational, representation, .. } = *group;
            PassiveGroup { fields, names, rotational, representation, passive }
        })
    })
}

/// Reported errors in fields that several hinges may share: each is reported once.
#[derive(Default)]
struct Once<'d> {
    reported: Vec<(&'d FieldSyntax, usize)>,
}

impl<'d> Once<'d> {
    /// Returns whether this is the first error in this entry of the field.
    fn is_new(&mut self, field: &'d FieldSyntax, entry: usize) -> bool {
        let same =
            |(other, at): &(&FieldSyntax, usize)| std::ptr::eq(*other, field) && *at == entry;
        let new = !self.reported.iter().any(same);
        if new {
            self.reported.push((field, entry));
        }
        new
    }
}

/// Reports friction without the speed that smooths it, limits without a stiffness, and the reverse.
pub(super) fn friction_and_limits_are_complete(draft: &Draft, diagnostics: &mut Diagnostics) {
    let mut once = Once::default();
    for PassiveGroup { fields, names, rotational, .. } in all_groups(draft) {
        for (present, needed, usual) in NEEDED {
            let needed = needed(names);
            if let Some(field) = fields.get(present(names))
                && fields.lacks(needed)
                && once.is_new(field, 0)
            {
                let usual = usual.map(|usual| usual[usize::from(rotational)]);
                let such_as = usual.map(|usual| format!(", such as `{needed} = {usual}`"));
                let such_as = such_as.unwrap_or_default();
                let message = format!("`{}` needs `{needed}` as well{such_as}", field.name);
                diagnostics.error(field.name.span(), message);
            }
        }
    }
}

/// Reports a position at rest on which no effort of its hinge depends.
pub(super) fn rest_positions_have_springs(draft: &Draft, diagnostics: &mut Diagnostics) {
    let mut once = Once::default();
    for (item, properties) in draft.items.iter().zip(&draft.properties) {
        let RouteItem::Hinge { name: Some(name), spec, .. } = item else { continue };
        let fields = &properties.fields;
        let Some(field) = fields.get("rest") else { continue };
        let needed: Vec<_> = groups(spec).flat_map(efforts_from_rest).collect();
        if needed.iter().all(|needed| fields.lacks(needed)) && once.is_new(field, 0) {
            let quoted: Vec<_> = needed.iter().map(|needed| format!("`{needed}`")).collect();
            let one_of = if quoted.len() > 1 { "one of " } else { "" };
            let message = format!(
                "`rest` of hinge `{}` needs {one_of}{} as well; for the initial coordinates write \
                 `start`",
                name.path,
                listed(&quoted)
            );
            diagnostics.error(field.name.span(), message);
        }
    }
}

/// Returns the fields of a group whose efforts depend on the position at rest: the springs, and the limits of a
/// quaternion, which are angles from rest.
fn efforts_from_rest(
    (group, names): (&'static DofGroup, &'static FieldNames),
) -> impl Iterator<Item = &'static str> {
    let from_rest = group.representation == Representation::Quaternion;
    std::iter::once(names.stiffness).chain(from_rest.then_some(names.limits))
}

/// Requires values that dissipate or store energy: none is negative.
pub(super) fn passive_values_are_not_negative(draft: &Draft) -> Vec<Requirement> {
    requirements(draft, Bound::NotBeNegative)
}

/// Requires positive speeds of friction and stiffness of limits.
pub(super) fn speeds_and_limits_are_positive(draft: &Draft) -> Vec<Requirement> {
    requirements(draft, Bound::BePositive)
}

fn requirements(draft: &Draft, must: Bound) -> Vec<Requirement> {
    let mut once = Once::default();
    let mut requirements = Vec::new();
    for PassiveGroup { fields, names, passive, .. } in all_groups(draft) {
        for PassiveRule { rule, field, number } in PASSIVE.iter().filter(|it| it.rule.must == must)
        {
            let Some(field) = fields.get(field(names)) else { continue };
            for (index, passive) in passive.iter().enumerate() {
                if let Some(value) = number(passive)
                    && let Some((entry, at)) = entry(field, index)
                    && once.is_new(field, entry)
                {
                    requirements.push(vec![rule.condition(value.clone(), at)]);
                }
            }
        }
    }
    requirements
}

/// Returns the index and the span of the number of a field for this strain.
fn entry(field: &FieldSyntax, strain: usize) -> Option<(usize, SpanRange)> {
    match field.value.as_ref()? {
        ValueSyntax::Vector(list) => Some((strain, list.entries.get(strain)?.extent)),
        other => Some((0, other.extent())),
    }
}

/// Requires that the lowest limit is below the highest one.
pub(super) fn limits_are_in_order(draft: &Draft) -> Vec<Requirement> {
    let mut once = Once::default();
    let mut requirements = Vec::new();
    for PassiveGroup { fields, names, representation, passive, .. } in all_groups(draft) {
        let limits = passive.first().and_then(|passive| passive.limits.as_ref());
        if let (Some(field), Some(limits)) = (fields.get(names.limits), limits)
            && let Some(syntax) = &field.value
            && once.is_new(field, 0)
        {
            let at = syntax.extent();
            requirements.push(match representation {
                Representation::Quaternion => {
                    let left = limits.to_half_turn();
                    let never = Condition::new(left, Bound::NotBeNegative, at, NEVER_REACHED);
                    vec![LARGEST_ANGLE.condition(limits.width(), at), never]
                }
                Representation::Numbers | Representation::Angles => {
                    vec![WIDTH.condition(limits.width(), at)]
                }
            });
        }
    }
    requirements
}
