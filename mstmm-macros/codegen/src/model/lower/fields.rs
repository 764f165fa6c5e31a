//! Fields of a block, before their values are read.

use super::context::Context;
use super::dimension::{INERTIA, LENGTH, MASS, Quantity, STIFFNESS};
use super::unit;
use crate::diag::nearest;
use crate::syntax::{ExprKind, ExprSyntax, FieldSyntax, PathSyntax, ValueSyntax, missing_field};
use proc_macro2::Ident;

/// Fields by name, each known and given once.
#[derive(Clone, Debug, Default)]
pub(crate) struct Fields<'a> {
    /// The fields, each with the part in which it is written.
    fields: Vec<(&'a FieldSyntax, Option<&'a Ident>)>,
    refused: bool,
    /// The names of fields in blocks whose names are wrong: they may be meant for this one.
    lost: Vec<&'a Ident>,
}

/// What fields describe, for messages.
pub(super) struct FieldOwner<'o, 'a> {
    /// In words: a kind of hinge or a name.
    pub name: &'o str,
    /// Its path in a block for several items.
    pub path: Option<&'o PathSyntax>,
    /// The part in which the fields are written.
    pub part: Option<&'a Ident>,
    /// All fields of the block: an unknown one is not meant to be another one of them.
    pub given: &'o [FieldSyntax],
    /// The kinds of the other hinges in a block for several, each with its fields.
    pub others: &'o [(&'static str, Vec<&'static str>)],
}

impl<'o> FieldOwner<'o, '_> {
    /// Returns an owner whose block has these fields and names no other item.
    pub fn of_block(name: &'o str, given: &'o [FieldSyntax]) -> Self {
        FieldOwner { name, path: None, part: None, given, others: &[] }
    }
}

impl<'a> Fields<'a> {
    /// Adds a field, or reports it if it is not `allowed` or given twice.
    pub(super) fn add(
        &mut self,
        field: &'a FieldSyntax,
        allowed: &[&str],
        owner: &FieldOwner<'_, 'a>,
        context: &mut Context,
    ) -> Option<()> {
        let message = self.fault(field, allowed, owner);
        let Some(message) = message else {
            self.fields.push((field, owner.part));
            return Some(());
        };
        self.refuse();
        // A field without a value is reported already: it may be no field.
        field.value.as_ref()?;
        context.refuse(&field.name, message)
    }

    /// Returns the error in a field, if there is one.
    fn fault(&self, field: &FieldSyntax, allowed: &[&str], owner: &FieldOwner) -> Option<String> {
        let FieldOwner { name: owner, path, part, given, others } = owner;
        let name = field.name.to_string();
        if !allowed.contains(&name.as_str()) {
            if let (Some(message), true) = (missing_field(&name), allowed.contains(&"armature")) {
                return Some(message.to_owned());
            }
            if let Some((other, _)) = others.iter().find(|(_, known)| known.contains(&&*name)) {
                return Some(format!(
                    "{owner} has no field `{name}`, unlike {other}: write a block for each kind of hinge"
                ));
            }
            let hint = hint(field, allowed, given);
            return Some(format!("{owner} has no field `{name}`{hint}"));
        }
        let (_, earlier) = self.fields.iter().find(|(field, _)| field.name == name)?;
        Some(match (earlier, path) {
            (Some(earlier), Some(path)) if *part != Some(*earlier) => {
                format!("`{name}` of `{path}` is given in part `{earlier}` already")
            }
            _ => format!("`{name}` of {owner} is given twice"),
        })
    }

    /// Notes that a field was refused, so that no field is reported as missing.
    pub fn refuse(&mut self) {
        self.refused = true;
    }

    /// Whether the field of this name is missing.
    pub fn lacks(&self, name: &str) -> bool {
        !self.refused && self.get(name).is_none() && !self.lost.iter().any(|lost| *lost == name)
    }

    /// Notes fields of a block that may be meant for this one.
    pub(super) fn may_have(&mut self, lost: &[&'a Ident]) {
        self.lost.extend(lost);
    }

    /// The field of this name.
    pub fn get(&self, name: &str) -> Option<&'a FieldSyntax> {
        self.fields.iter().map(|(field, _)| *field).find(|field| field.name == name)
    }
}

/// Fields that other programs, or other kinds of hinges, have under another name.
const COUNTERPARTS: &[(&str, &str)] = &[
    ("force", "torque"),
    ("torque", "force"),
    ("start_velocity", "start_rate"),
    ("start_rate", "start_velocity"),
    ("velocity", "start_velocity"),
    ("velocity", "start_rate"),
    ("rate", "start_rate"),
    ("angle", "start"),
    ("initial", "start"),
    ("position", "start"),
    ("equilibrium", "rest"),
    ("spring", "stiffness"),
    ("damper", "damping"),
    ("centre", "com"),
    ("center", "com"),
    ("centre_of_mass", "com"),
    ("center_of_mass", "com"),
    ("cog", "com"),
    ("moment", "torque"),
    ("motor", "torque"),
    ("motor", "force"),
    ("effort", "torque"),
    ("effort", "force"),
    ("actuator", "torque"),
    ("actuator", "force"),
    ("prescribed", "motion"),
    ("driven", "motion"),
    ("weight", "mass"),
    ("moment_of_inertia", "inertia"),
    ("tensor", "inertia"),
    ("visual", "shape"),
    ("geometry", "shape"),
    ("geom", "shape"),
    ("mesh", "shape"),
    ("end", "output"),
    ("body", "on"),
    ("bodies", "on"),
    ("between", "on"),
    ("from", "on"),
    ("from", "to"),
    ("from", "at"),
    ("point", "at"),
    ("range", "limits"),
    ("lower", "limits"),
    ("upper", "limits"),
    ("inertia", "armature"),
    ("rotor_inertia", "armature"),
    ("rest", "length"),
    ("rest_length", "length"),
    ("free_length", "length"),
];

/// The known field that an unknown one means.
pub(crate) fn meant<'k>(name: &str, allowed: &[&'k str]) -> Option<&'k str> {
    let find = |meant: &str| allowed.iter().copied().find(|name| *name == meant);
    let counterparts = COUNTERPARTS.iter().filter(|(other, _)| *other == name);
    let counterpart = counterparts.into_iter().find_map(|(_, meant)| find(meant));
    counterpart
        .or_else(|| find(name.strip_prefix("turning_")?))
        .or_else(|| nearest(name, allowed.iter().copied()))
}

/// Returns the end of the message for an unknown field: the one that it means, or all known ones.
fn hint(field: &FieldSyntax, allowed: &[&str], given: &[FieldSyntax]) -> String {
    match intended(&field.name.to_string(), allowed, given) {
        Some(meant) if is_given(meant, given) => return format!("; `{meant}` is given already"),
        Some(meant) => return format!("; did you mean `{meant}`?"),
        None => {}
    }
    if allowed.is_empty() {
        return String::new();
    }
    let allowed: Vec<_> = allowed.iter().map(|known| listed_as(known, field)).collect();
    format!("; it has {}", listed(&allowed))
}

/// Returns the known field that an unknown one means: rather one that the block does not have.
fn intended<'k>(name: &str, allowed: &[&'k str], given: &[FieldSyntax]) -> Option<&'k str> {
    let first = meant(name, allowed)?;
    let lacks = |meant: &&str| allowed.contains(meant) && !is_given(meant, given);
    let counterparts = COUNTERPARTS.iter().filter(|(other, _)| *other == name);
    let lacking = counterparts.map(|&(_, meant)| meant).find(lacks);
    Some(if is_given(first, given) { lacking.unwrap_or(first) } else { first })
}

fn is_given(name: &str, given: &[FieldSyntax]) -> bool {
    given.iter().any(|field| field.name == name)
}

/// What messages list after the fields of a body type, which has any number of points.
pub(super) const POINT: &str = "point name";

/// Returns a known field as messages list it where another one is unknown: an unknown field whose value is a vector may be
/// a point.
fn listed_as(known: &str, unknown: &FieldSyntax) -> String {
    let is_frame = matches!(unknown.value, Some(ValueSyntax::Vector(_) | ValueSyntax::Turned(..)));
    match known == POINT && is_frame {
        true => format!("`point {}`", unknown.name),
        false => format!("`{known}`"),
    }
}

/// Returns those of `required` that are missing. A field with a similar name counts as given: it is
/// reported as unknown, and correcting it is enough. So does an unknown field whose value could be
/// that of the missing field. A field that was not readable may be any.
pub(super) fn missing<'r>(
    fields: &[FieldSyntax],
    required: &[&'r str],
    allowed: &[&str],
) -> Vec<&'r str> {
    let is_known = |field: &FieldSyntax| allowed.iter().any(|name| field.name == name);
    if fields.iter().any(|field| field.value.is_none() && !is_known(field)) {
        return Vec::new();
    }
    let unknown: Vec<(&FieldSyntax, Option<&str>)> = fields
        .iter()
        .filter(|field| !is_known(field))
        .map(|field| (field, intended(&field.name.to_string(), allowed, fields)))
        .collect();
    let is_meant = |name: &str| {
        fields.iter().any(|field| field.name == name)
            || unknown.iter().any(|(_, meant)| *meant == Some(name))
    };
    let mut missing: Vec<_> = required.iter().copied().filter(|name| !is_meant(name)).collect();
    for (field, _) in unknown.iter().filter(|(_, meant)| meant.is_none()) {
        let could_be = |name: &&str| field.value.as_ref().is_some_and(|value| fits(value, name));
        if let Some(index) = missing.iter().position(could_be) {
            missing.remove(index);
        }
    }
    missing
}

/// Returns whether a value could be that of a field, by its form.
fn fits(value: &ValueSyntax, field: &str) -> bool {
    let measures = |quantity: &Quantity| match value {
        ValueSyntax::Number(ExprSyntax { kind: ExprKind::Quantity(_, unit), .. }) => {
            unit::resolve(unit).is_ok_and(|(_, dimension)| dimension == quantity.dimension)
        }
        _ => false,
    };
    let is_plain =
        !matches!(value, ValueSyntax::Number(ExprSyntax { kind: ExprKind::Quantity(..), .. }));
    let is_number = matches!(value, ValueSyntax::Number(_)) && value.word().is_none();
    let is_place =
        matches!(value, ValueSyntax::Vector(_) | ValueSyntax::Turned(..)) || measures(LENGTH);
    match field {
        "mass" => is_number && (is_plain || measures(MASS)),
        "stiffness" => is_number && (is_plain || measures(STIFFNESS)),
        "to" => is_place || matches!(value, ValueSyntax::Path(_)),
        "com" | "output" => is_place,
        "inertia" => {
            matches!(value, ValueSyntax::Form(_) | ValueSyntax::About(..)) || measures(INERTIA)
        }
        "on" => {
            matches!(value, ValueSyntax::Path(_))
                || value.word().is_some_and(|word| word != "input")
        }
        "force" | "torque" => {
            matches!(value, ValueSyntax::Vector(_))
                || value.word().is_some_and(|word| word == "input")
        }
        _ => false,
    }
}

/// `a`, `a and b`, `a, b and c`
pub(crate) fn listed(words: &[impl AsRef<str>]) -> String {
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match &words[..] {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
