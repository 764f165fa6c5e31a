//! The tables of inputs and parameters.

use super::super::EmitContext;
use super::elements::components;
use super::row::{Row, default, indexed};
use crate::ids::RepeatId;
use crate::model::{DofGroup, Drive, Effort, Hinge, HingeId, InputKind, Representation};
use quote::{format_ident, quote};

/// A part of an input: its path, its components and their kind.
type InputPart = (String, &'static str, QuantityKind);

/// A row of the table of inputs.
pub struct InputRow {
    /// The path, with brackets for the index of a repetition.
    pub path: String,
    /// A character for each component; empty for a scalar.
    pub components: &'static str,
    /// The kind of the components.
    pub kind: QuantityKind,
    /// The repeated part that it belongs to, with the number of repetitions.
    pub repeat: Option<(RepeatId, usize)>,
}

/// The kind of an entry of coordinates, rates and inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum QuantityKind {
    Length,
    Angle,
    Orientation,
    Velocity,
    AngularVelocity,
    Acceleration,
    AngularAcceleration,
    Force,
    Torque,
}

impl QuantityKind {
    /// Returns its unit as text, and the function of the runtime that makes an input of this kind.
    pub fn unit_and_maker(self) -> (&'static str, &'static str) {
        match self {
            QuantityKind::Length => ("m", "length_"),
            QuantityKind::Angle => ("rad", "angle_"),
            QuantityKind::Orientation => ("1", "orientation_"),
            QuantityKind::Velocity => ("m/s", "velocity_"),
            QuantityKind::AngularVelocity => ("rad/s", "angular_velocity_"),
            QuantityKind::Acceleration => ("m/s^2", "acceleration_"),
            QuantityKind::AngularAcceleration => ("rad/s^2", "angular_acceleration_"),
            QuantityKind::Force => ("N", "force_"),
            QuantityKind::Torque => ("N*m", "torque_"),
        }
    }

    /// Returns the kind of the coordinates of a group of degrees of freedom, with their components.
    pub fn of_coordinates(group: &DofGroup) -> (&'static str, QuantityKind) {
        match (group.representation, group.rotational) {
            (Representation::Quaternion, _) => ("wxyz", QuantityKind::Orientation),
            (_, true) => (components(group.coordinates.len()), QuantityKind::Angle),
            (_, false) => (components(group.coordinates.len()), QuantityKind::Length),
        }
    }

    /// Returns the kind of the rates of a group of degrees of freedom, with their components.
    pub fn of_rates(group: &DofGroup) -> (&'static str, QuantityKind) {
        let kind =
            if group.rotational { QuantityKind::AngularVelocity } else { QuantityKind::Velocity };
        (components(group.rates.len()), kind)
    }
}

/// Returns the table of inputs.
pub fn inputs(cx: &EmitContext) -> Vec<Row> {
    let row = |InputRow { path, components, kind, repeat }: InputRow| {
        let make = format_ident!("{}", kind.unit_and_maker().1);
        Row { tokens: quote!(#make(#path, #components)), repeat }
    };
    input_rows(cx).into_iter().map(row).collect()
}

/// Returns the rows of the table of inputs.
pub fn input_rows(cx: &EmitContext) -> Vec<InputRow> {
    let mut rows = Vec::new();
    for input in cx.layout.inputs.iter() {
        let repeat = cx.chain.repeat_of_input(input.what);
        let parts = match input.what {
            InputKind::Gravity => {
                vec![(
                    "gravity".to_owned(),
                    components(input.range.len()),
                    QuantityKind::Acceleration,
                )]
            }
            InputKind::Efforts(hinge) => efforts(cx, hinge),
            InputKind::Motion(hinge) => motion(cx, hinge),
            InputKind::Force(load) => {
                let path = indexed(&cx.chain.loads[load].path, repeat.is_some());
                vec![(format!("{path}.force"), components(input.range.len()), QuantityKind::Force)]
            }
            InputKind::Torque(load) => {
                let path = indexed(&cx.chain.loads[load].path, repeat.is_some());
                vec![(
                    format!("{path}.torque"),
                    components(input.range.len()),
                    QuantityKind::Torque,
                )]
            }
            InputKind::SpringForce(spring) => {
                let path = indexed(&cx.chain.springs[spring].path, repeat.is_some());
                vec![(format!("{path}.force"), components(1), QuantityKind::Force)]
            }
        };
        rows.extend(parts.into_iter().map(|(path, components, kind)| InputRow {
            path,
            components,
            kind,
            repeat: cx.counted(repeat),
        }));
    }
    rows
}

/// Returns the efforts of a hinge that are inputs. Where all are forces or all are torques, they have the name of the
/// hinge.
fn efforts(cx: &EmitContext, id: HingeId) -> Vec<InputPart> {
    let hinge = &cx.chain.hinges[id];
    let path = indexed(&hinge.path, cx.chain.repeat_of_hinge(id).is_some());
    let Drive::Efforts(efforts) = &hinge.drive else {
        bug!("a prescribed hinge has efforts as inputs")
    };
    let is_input = |group: &&DofGroup| efforts[group.rates.start] == Effort::Input;
    let groups: Vec<&DofGroup> = hinge.kind.spec().groups.iter().filter(is_input).collect();
    let row = |group: &DofGroup| {
        let word = if group.rotational { "torque" } else { "force" };
        let path = if groups.len() == 1 { path.clone() } else { format!("{path}.{word}") };
        let kind = if group.rotational { QuantityKind::Torque } else { QuantityKind::Force };
        (path, components(group.rates.len()), kind)
    };
    groups.iter().copied().map(row).collect()
}

/// Returns the coordinates, rates and accelerations of a prescribed motion.
fn motion(cx: &EmitContext, id: HingeId) -> Vec<InputPart> {
    let hinge = &cx.chain.hinges[id];
    let path = indexed(&hinge.path, cx.chain.repeat_of_hinge(id).is_some());
    let groups = hinge.kind.spec().groups;
    let coordinates = groups.iter().map(|group| {
        let (components, kind) = QuantityKind::of_coordinates(group);
        (format!("{path}.state.{}", group.names[0]), components, kind)
    });
    let rates = groups.iter().map(|group| {
        let (components, kind) = QuantityKind::of_rates(group);
        (format!("{path}.state.{}", group.names[1]), components, kind)
    });
    let accelerations = groups.iter().map(|group| {
        let (word, kind) = match group.rotational {
            true => ("angular", QuantityKind::AngularAcceleration),
            false => ("linear", QuantityKind::Acceleration),
        };
        let path = match has_both(hinge) {
            true => format!("{path}.acceleration.{word}"),
            false => format!("{path}.acceleration"),
        };
        (path, components(group.rates.len()), kind)
    });
    coordinates.chain(rates).chain(accelerations).collect()
}

/// Returns whether a hinge has translations and rotations.
fn has_both(hinge: &Hinge) -> bool {
    hinge.kind.spec().groups.len() > 1
}

/// Returns the table of parameters.
pub fn parameters(cx: &EmitContext) -> Vec<Row> {
    let rows = cx.chain.parameters.enumerate().map(|(id, parameter)| {
        let path = indexed(&parameter.name.to_string(), parameter.repetitions.is_some());
        let unit = if parameter.unit.is_empty() { "1" } else { &parameter.unit };
        let default = default(cx, &parameter.default);
        let repeat = cx.chain.repeat_of_parameter(id);
        Row {
            tokens: quote!(parameter_(#path, #unit, #default)),
            repeat: repeat.zip(parameter.repetitions),
        }
    });
    rows.collect()
}
