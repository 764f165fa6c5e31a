//! The tables of inputs and parameters.

use super::super::EmitContext;
use super::elements::components;
use super::row::{Row, default, indexed};
use crate::model::{DofGroup, Drive, Effort, Hinge, HingeId, InputKind, Representation};
use proc_macro2::TokenStream;
use quote::quote;

/// A part of an input: its path, its components and the function that makes it.
type InputRow = (String, &'static str, TokenStream);

/// Returns the table of inputs.
pub fn inputs(cx: &EmitContext) -> Vec<Row> {
    let mut rows = Vec::new();
    for input in cx.layout.inputs.iter() {
        let repeat = cx.chain.repeat_of_input(input.what);
        let parts = match input.what {
            InputKind::Gravity => {
                vec![("gravity".to_owned(), components(input.range.len()), quote!(acceleration_))]
            }
            InputKind::Efforts(hinge) => efforts(cx, hinge),
            InputKind::Motion(hinge) => motion(cx, hinge),
            InputKind::Force(load) => {
                let path = indexed(&cx.chain.loads[load].path, repeat.is_some());
                vec![(format!("{path}.force"), components(input.range.len()), quote!(force_))]
            }
            InputKind::Torque(load) => {
                let path = indexed(&cx.chain.loads[load].path, repeat.is_some());
                vec![(format!("{path}.torque"), components(input.range.len()), quote!(torque_))]
            }
        };
        rows.extend(parts.into_iter().map(|(path, components, make)| Row {
            tokens: quote!(#make(#path, #components)),
            repeat: cx.counted(repeat),
        }));
    }
    rows
}

/// Returns the efforts of a hinge that are inputs. Where all are forces or all are torques, they have the name of the
/// hinge.
fn efforts(cx: &EmitContext, id: HingeId) -> Vec<InputRow> {
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
        let make = if group.rotational { quote!(torque_) } else { quote!(force_) };
        (path, components(group.rates.len()), make)
    };
    groups.iter().copied().map(row).collect()
}

/// Returns the coordinates, rates and accelerations of a prescribed motion.
fn motion(cx: &EmitContext, id: HingeId) -> Vec<InputRow> {
    let hinge = &cx.chain.hinges[id];
    let path = indexed(&hinge.path, cx.chain.repeat_of_hinge(id).is_some());
    let groups = hinge.kind.spec().groups;
    let coordinates = groups.iter().map(|group| {
        let (components, make) = match (group.representation, group.rotational) {
            (Representation::Quaternion, _) => ("wxyz", quote!(orientation_)),
            (_, true) => (components(group.coordinates.len()), quote!(angle_)),
            (_, false) => (components(group.coordinates.len()), quote!(length_)),
        };
        (format!("{path}.state.{}", group.names[0]), components, make)
    });
    let rates = groups.iter().map(|group| {
        let make = if group.rotational { quote!(angular_velocity_) } else { quote!(velocity_) };
        (format!("{path}.state.{}", group.names[1]), components(group.rates.len()), make)
    });
    let accelerations = groups.iter().map(|group| {
        let (word, make) = match group.rotational {
            true => ("angular", quote!(angular_acceleration_)),
            false => ("linear", quote!(acceleration_)),
        };
        let path = match has_both(hinge) {
            true => format!("{path}.acceleration.{word}"),
            false => format!("{path}.acceleration"),
        };
        (path, components(group.rates.len()), make)
    });
    coordinates.chain(rates).chain(accelerations).collect()
}

/// Returns whether a hinge has translations and rotations.
fn has_both(hinge: &Hinge) -> bool {
    hinge.kind.spec().groups.len() > 1
}

/// Returns the table of parameters.
pub fn parameters(cx: &EmitContext) -> Vec<Row> {
    let rows = cx.chain.parameters.iter().enumerate().map(|(index, parameter)| {
        let path = indexed(&parameter.name.to_string(), parameter.repetitions.is_some());
        let unit = if parameter.unit.is_empty() { "1" } else { &parameter.unit };
        let default = default(cx, &parameter.default);
        let repeat = cx.chain.repeat_of_parameter(index);
        Row {
            tokens: quote!(parameter_(#path, #unit, #default)),
            repeat: repeat.zip(parameter.repetitions),
        }
    });
    rows.collect()
}
