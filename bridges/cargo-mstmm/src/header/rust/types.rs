//! The structs of the header in Rust.

use super::super::Model;
use super::super::functions::{MOMENTUM, MOTION, VARIATION};
use mstmm_codegen::emit::NamedArray;
use mstmm_codegen::model::{Dimension, Results};

/// Returns the length of an array in C, which cannot be zero.
pub(super) fn length(array: &NamedArray) -> usize {
    array.length.max(1)
}

/// Returns the types.
pub(super) fn of(model: &Model) -> String {
    let Model { chain, tables, prefix, .. } = model;
    let (q, v, u) = (length(&tables.coordinates), length(&tables.rates), length(&tables.inputs));
    let integrator = model.method.parts().0;
    let hinges: String =
        tables.hinges.iter().map(|hinge| format!("c\"{}\", ", hinge.path)).collect();
    let hinges = hinges.trim_end_matches(", ");
    let count = tables.hinges.len();
    let size = model.size();
    let mut text = format!(
        "/// The chain and its integrator: `{prefix}` of the header, there an array of numbers.\n\
         ///\n\
         /// It consists of numbers only, so every bit pattern in its memory is a valid value.\n\
         #[repr(C)]\n\
         pub struct Model {{\n    \
             chain: {chain}<Real>,\n    \
             integrator: {integrator}<{chain}<Real>>,\n\
         }}\n\n\
         /// `{prefix}_state` of the header.\n\
         #[repr(C)]\n\
         #[derive(Clone, Copy, Debug, PartialEq)]\n\
         pub struct State {{\n    \
             /// Coordinates.\n    pub q: [Real; {q}],\n    \
             /// Rates.\n    pub v: [Real; {v}],\n    \
             /// Time in s.\n    pub t: Real,\n\
         }}\n\n\
         /// `{prefix}_inputs` of the header.\n\
         #[repr(C)]\n\
         #[derive(Clone, Copy, Debug, PartialEq)]\n\
         pub struct Inputs {{\n    /// The scalars of all inputs.\n    pub u: [Real; {u}],\n}}\n\n\
         /// The names of the hinges.\n\
         const HINGES: [&CStr; {count}] = [{hinges}];\n\n\
         // The size in the header, as the length of an array, so that the compiler reports the right size.\n\
         const _: [(); {size} * size_of::<Real>()] = [(); size_of::<Model>()];\n\
         const _: [(); align_of::<Real>()] = [(); align_of::<Model>()];\n\n",
    );
    if model.has_points() {
        text += &format!(
            "/// `{prefix}_point` of the header.\n\
             #[repr(C)]\n\
             #[derive(Clone, Copy, Debug, PartialEq)]\n\
             pub struct Point {{\n{}}}\n\n",
            fields(model)
                .iter()
                .map(|(name, ty, ..)| format!("    /// `{name}`\n    pub {name}: {ty},\n"))
                .collect::<String>(),
        );
    }
    let mut results =
        format!("    /// Derivatives of the rates.\n    pub accelerations: [Real; {v}],\n");
    if model.results().energies {
        results += "    /// In J.\n    pub kinetic_energy: Real,\n    /// In J.\n    pub potential_energy: Real,\n";
    }
    if model.has_points() {
        results += &format!(
            "    /// All connection points.\n    pub points: [Point; {}],\n",
            tables.points.length
        );
    }
    text += &structure(prefix, "results", "Results", &results);
    text + &answers(model)
}

/// Returns a struct of the header with these fields.
fn structure(prefix: &str, in_c: &str, name: &str, fields: &str) -> String {
    format!(
        "/// `{prefix}_{in_c}` of the header.\n\
         #[repr(C)]\n\
         #[derive(Clone, Copy, Debug, PartialEq)]\n\
         pub struct {name} {{\n{fields}}}\n\n"
    )
}

/// Returns the structs of functions that depend on the description.
fn answers(model: &Model) -> String {
    let Model { prefix, tables, .. } = model;
    let fields = |fields: &[(&str, String)]| -> String {
        let field =
            |(name, ty): &(&str, String)| format!("    /// `{name}`\n    pub {name}: {ty},\n");
        fields.iter().map(field).collect()
    };
    let mut text = String::new();
    if model.functions.use_shape(VARIATION) {
        let array = |array: &NamedArray| format!("[Real; {}]", length(array));
        let own = fields(&[
            ("coordinates", array(&tables.rates)),
            ("rates", array(&tables.rates)),
            ("inputs", array(&tables.inputs)),
            ("parameters", array(&tables.parameters)),
        ]);
        text += &structure(prefix, "variation", "Variation", &own);
    }
    let typed = |own: Vec<(&'static str, &str)>| -> Vec<(&'static str, String)> {
        own.into_iter().map(|(name, ty)| (name, ty.to_owned())).collect()
    };
    if model.functions.use_shape(MOTION) {
        text += &structure(prefix, "motion", "Motion", &fields(&typed(motion_fields(model))));
    }
    if model.functions.use_shape(MOMENTUM) {
        let (vector, rotation) = components(model);
        let mut own = vec![("mass", "Real"), ("center_of_mass", vector), ("linear", vector)];
        own.extend(rotation.map(|ty| ("angular", ty)));
        text += &structure(prefix, "momentum_result", "Momentum", &fields(&typed(own)));
    }
    text
}

/// Returns the types of vectors and of rotations.
fn components(model: &Model) -> (&'static str, Option<&'static str>) {
    match model.dimension() {
        Dimension::Space => ("[Real; 3]", Some("[Real; 3]")),
        Dimension::Plane => ("[Real; 2]", Some("Real")),
        Dimension::Line => ("Real", None),
    }
}

/// Returns the fields of the motion of a frame: name and type.
pub(super) fn motion_fields(model: &Model) -> Vec<(&'static str, &'static str)> {
    let (vector, rotation) = components(model);
    let mut fields = vec![("position", vector)];
    match model.dimension() {
        Dimension::Space => fields.push(("orientation", "[[Real; 3]; 3]")),
        Dimension::Plane => fields.push(("cos_sin", "[Real; 2]")),
        Dimension::Line => {}
    }
    fields.push(("velocity", vector));
    fields.extend(rotation.map(|ty| ("angular_velocity", ty)));
    fields.push(("bias_acceleration", vector));
    fields.extend(rotation.map(|ty| ("angular_bias_acceleration", ty)));
    fields
}

/// Returns the fields of a point: name, type, and its value from `point`.
pub(super) fn fields(model: &Model) -> Vec<(&'static str, &'static str, &'static str)> {
    let Results { poses, velocities, z, .. } = model.results();
    let (vector, rotation) = components(model);
    let mut fields = Vec::new();
    if poses {
        fields.push(("position", vector, "position"));
        match model.dimension() {
            Dimension::Space => fields.push(("orientation", "[[Real; 3]; 3]", "orientation")),
            Dimension::Plane => fields.push(("cos_sin", "[Real; 2]", "cos_sin")),
            Dimension::Line => {}
        }
    }
    if velocities {
        fields.push(("velocity", vector, "velocity"));
        fields.extend(rotation.map(|ty| ("angular_velocity", ty, "angular_velocity")));
    }
    if z {
        fields.push(("acceleration", vector, "acceleration"));
        fields.extend(rotation.map(|ty| ("angular_acceleration", ty, "angular_acceleration")));
        fields.extend(rotation.map(|ty| ("moment", ty, "moment")));
        fields.push(("force", vector, "force"));
    }
    fields
}
