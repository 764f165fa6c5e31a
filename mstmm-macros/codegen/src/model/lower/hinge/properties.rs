//! Start, rest position and drive of a hinge: read by the groups of its degrees of freedom, in the
//! same way for all kinds.

use proc_macro2::Ident;

use super::field_names::{groups, measures};
use super::passive::passive;
use crate::model::lower::context::Context;
use crate::model::lower::fields::Fields;
use crate::model::lower::orientation::Orientation;
use crate::model::{DofGroup, Drive, Effort, HingeSpec, Passive, Representation, Value};
use crate::syntax::{FieldSyntax, OrientationSyntax, ValueSyntax};

/// The properties of a hinge: its start, its drive and its passive forces.
#[derive(Clone, Debug)]
pub(crate) struct HingeProperties {
    /// Start coordinates.
    pub start: Vec<Value>,
    /// The name of the field `start`, if it is written.
    pub start_field: Option<Ident>,
    /// Start rates.
    pub start_rate: Vec<Value>,
    /// The coordinates at rest.
    pub rest: Vec<Value>,
    /// What drives it.
    pub drive: Drive,
    /// The passive forces along its strains.
    pub passive: Vec<Passive>,
}

impl HingeProperties {
    /// Returns the properties of a hinge without a block.
    pub fn none(spec: &HingeSpec) -> Self {
        let numbers = |count| vec![Value::number(0.0); count];
        let dof_count = spec.rates.len();
        HingeProperties {
            start: zero_position(spec),
            start_field: None,
            start_rate: numbers(dof_count),
            rest: zero_position(spec),
            drive: Drive::Efforts(vec![Effort::Free; dof_count]),
            passive: vec![Passive::none(); dof_count],
        }
    }
}

fn zero_position(spec: &HingeSpec) -> Vec<Value> {
    spec.coordinates.iter().map(|coordinate| Value::number(coordinate.rest)).collect()
}

/// Reads the properties of a hinge.
pub(crate) fn motion(
    spec: &'static HingeSpec,
    fields: &Fields,
    context: &mut Context,
) -> HingeProperties {
    let [start, rest] = ["start", "rest"].map(|name| {
        context.readable(
            fields.get(name),
            || zero_position(spec),
            |context, syntax| position(spec, syntax, context),
        )
    });
    let rates =
        groups(spec).flat_map(|(group, names)| rates(group, fields.get(names.start_rate), context));
    let start_rate = rates.collect();
    let drive = drive(spec, fields, context);
    let passives = groups(spec).flat_map(|(group, names)| {
        let rotation = groups(spec).find(|(other, _)| other.rotational && !group.rotational);
        passive(group, names, rotation.map(|(_, names)| names), fields, context)
    });
    let passive = passives.collect();
    let start_field = fields.get("start").map(|field| field.name.clone());
    HingeProperties { start, start_field, rest, start_rate, drive, passive }
}

/// The coordinates of a position.
fn position(
    spec: &'static HingeSpec,
    syntax: &ValueSyntax,
    context: &mut Context,
) -> Option<Vec<Value>> {
    let translations = |syntax, group: &DofGroup, context: &mut Context| {
        context.components(syntax, group.rates.len(), measures(group).strain)
    };
    match spec.groups {
        [group] if group.representation == Representation::Quaternion => {
            Some(context.read_orientation(syntax)?.quaternion().to_vec())
        }
        [group] => translations(syntax, group, context),
        [first, second, ..] => match syntax {
            ValueSyntax::Turned(position, orientation) => {
                let (position, turned) =
                    (translations(position, first, context), turned(second, orientation, context));
                Some([position?, turned?].concat())
            }
            other => {
                let mut coordinates = zero_position(spec);
                coordinates.splice(first.coordinates.clone(), translations(other, first, context)?);
                Some(coordinates)
            }
        },
        [] => Some(Vec::new()),
    }
}

/// Reads the coordinates of rotations after `turned`.
fn turned(
    group: &DofGroup,
    orientation: &OrientationSyntax,
    context: &mut Context,
) -> Option<Vec<Value>> {
    match group.representation {
        Representation::Numbers => context.angle(orientation).map(|angle| vec![angle]),
        Representation::Quaternion => Some(context.turned(orientation)?.quaternion().to_vec()),
        Representation::Angles => match context.turned(orientation)? {
            Orientation::Rpy(angles) => Some(angles.to_vec()),
            Orientation::Quaternion(_) => {
                let message = "the rotation of an elastic hinge is given by angles: write \
                               `rpy(roll, pitch, yaw)`";
                context.refuse(orientation.extent(), message)
            }
        },
    }
}

/// The start rates of a group.
fn rates(group: &DofGroup, field: Option<&FieldSyntax>, context: &mut Context) -> Vec<Value> {
    let count = group.rates.len();
    context.readable(
        field,
        || vec![Value::number(0.0); count],
        |context, syntax| context.components(syntax, count, measures(group).rate),
    )
}

/// Reads the drive: a motor for each group, or a prescribed motion. A rule reports if both are
/// written.
fn drive(spec: &'static HingeSpec, fields: &Fields, context: &mut Context) -> Drive {
    let efforts: Vec<_> = groups(spec)
        .flat_map(|(group, names)| efforts(group, fields.get(names.effort), context))
        .collect();
    let prescribed = context.readable(
        fields.get("motion"),
        || false,
        |context, syntax| match context.asks_for_input(syntax)? {
            true => Some(true),
            false => {
                let found = syntax.described();
                let message = format!(
                    "expected `motion = input`, found \
                             {found}"
                );
                context.refuse(syntax.extent(), message)
            }
        },
    );
    if prescribed { Drive::Prescribed } else { Drive::Efforts(efforts) }
}

/// The efforts of a group's motor.
fn efforts(group: &DofGroup, field: Option<&FieldSyntax>, context: &mut Context) -> Vec<Effort> {
    let count = group.rates.len();
    context.readable(
        field,
        || vec![Effort::Free; count],
        |context, syntax| match context.asks_for_input(syntax)? {
            true => Some(vec![Effort::Input; count]),
            false => {
                let numbers = context.components(syntax, count, measures(group).effort)?;
                Some(numbers.into_iter().map(Effort::Constant).collect())
            }
        },
    )
}
