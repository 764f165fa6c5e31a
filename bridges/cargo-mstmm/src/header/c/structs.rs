//! The structs of a header.

use super::super::Model;
use super::super::functions::{MOMENTUM, MOTION, VARIATION};
use super::upper;
use mstmm_codegen::emit::NamedArray;
use mstmm_codegen::model::{Dimension, Results};

/// Returns a field with a comment.
fn field(ty: &str, name: &str, comment: &str) -> String {
    format!("    {ty} {name}; /* {comment} */\n")
}

/// Returns the structs of a chain.
pub(super) fn of(model: &Model) -> String {
    let (prefix, upper, tables) = (&model.prefix, upper(model), &model.tables);
    let length = |array: &NamedArray, name: &str| match array.length {
        0 => ("1".to_owned(), "unused; "),
        _ => (format!("{upper}_{name}"), ""),
    };
    let (q, no_q) = length(&tables.coordinates, "COORDINATES");
    let (v, no_v) = length(&tables.rates, "RATES");
    let (u, no_u) = length(&tables.inputs, "INPUTS");
    let mut text = format!(
        "/* The chain with its parameters and its integrator. The contents are private; it may be copied by assignment. */\n\
         typedef struct {prefix} {{\n    mstmm_real numbers[{}];\n}} {prefix};\n\n\
         typedef struct {prefix}_state {{\n{}{}{}}} {prefix}_state;\n\n\
         typedef struct {prefix}_inputs {{\n{}}} {prefix}_inputs;\n\n",
        model.size(),
        field("mstmm_real", &format!("q[{q}]"), &format!("{no_q}coordinates")),
        field("mstmm_real", &format!("v[{v}]"), &format!("{no_v}rates")),
        field("mstmm_real", "t", "time, s"),
        field("mstmm_real", &format!("u[{u}]"), &format!("{no_u}all inputs")),
    );
    if model.has_points() {
        text += &format!(
            "/* A connection point and the frame that moves with it. */\n\
             typedef struct {prefix}_point {{\n{}}} {prefix}_point;\n\n",
            point(model)
        );
    }
    let mut results = field(
        "mstmm_real",
        &format!("accelerations[{v}]"),
        &format!("{no_v}time derivatives of the rates"),
    );
    if model.results().energies {
        results += &field("mstmm_real", "kinetic_energy", "J");
        results += &field(
            "mstmm_real",
            "potential_energy",
            "J, of gravity and springs; that of gravity is zero with all masses at the origin",
        );
    }
    if model.has_points() {
        results += &format!("    {prefix}_point points[{upper}_POINTS];\n");
    }
    text += &format!("typedef struct {prefix}_results {{\n{results}}} {prefix}_results;\n\n");
    if model.functions.use_shape(VARIATION) {
        let p = length(&tables.parameters, "PARAMETERS").0;
        text += &format!(
            "/* A small change of all that the accelerations depend on, or a gradient with respect to it. `coordinates` are\n \
             * displacements along the rates. */\n\
             typedef struct {prefix}_variation {{\n{}{}{}{}}} {prefix}_variation;\n\n",
            field("mstmm_real", &format!("coordinates[{v}]"), "along the rates"),
            field("mstmm_real", &format!("rates[{v}]"), "in the order of `v`"),
            field("mstmm_real", &format!("inputs[{u}]"), &format!("{no_u}in the order of `u`")),
            field("mstmm_real", &format!("parameters[{p}]"), "in the order of the description"),
        );
    }
    if model.functions.use_shape(MOTION) {
        text += &format!(
            "/* The motion of a frame on a body. Bias accelerations are those at zero accelerations of the rates. */\n\
             typedef struct {prefix}_motion {{\n{}}} {prefix}_motion;\n\n",
            motion(model)
        );
    }
    if model.functions.use_shape(MOMENTUM) {
        let fields = [
            field("mstmm_real", "mass", "of all bodies, kg"),
            field("mstmm_real", &vector(model, "center_of_mass"), "m"),
            field("mstmm_real", &vector(model, "linear"), "kg m/s"),
            angular(model, "angular", "about the centre of mass, kg m^2/s"),
        ];
        text += &format!(
            "typedef struct {prefix}_momentum_result {{\n{}}} {prefix}_momentum_result;\n\n",
            fields.concat()
        );
    }
    text
}

/// Returns the name of a field with the components of a vector.
fn vector(model: &Model, name: &str) -> String {
    match model.dimension() {
        Dimension::Space => format!("{name}[3]"),
        Dimension::Plane => format!("{name}[2]"),
        Dimension::Line => name.to_owned(),
    }
}

/// Returns a field with the components of a rotation, if there are any.
fn angular(model: &Model, name: &str, comment: &str) -> String {
    match model.dimension() {
        Dimension::Space => field("mstmm_real", &format!("{name}[3]"), comment),
        Dimension::Plane => field("mstmm_real", name, comment),
        Dimension::Line => String::new(),
    }
}

/// Returns the fields of a pose.
fn pose(model: &Model) -> String {
    let mut text = field("mstmm_real", &vector(model, "position"), "m");
    text += &match model.dimension() {
        Dimension::Space => field(
            "mstmm_real",
            "orientation[3][3]",
            "rows of the rotation matrix from components in the frame of the point to inertial components",
        ),
        Dimension::Plane => field(
            "mstmm_real",
            "cos_sin[2]",
            "cosine and sine of the angle of the frame of the point",
        ),
        Dimension::Line => String::new(),
    };
    text
}

fn motion(model: &Model) -> String {
    [
        pose(model),
        field("mstmm_real", &vector(model, "velocity"), "m/s"),
        angular(model, "angular_velocity", "rad/s"),
        field("mstmm_real", &vector(model, "bias_acceleration"), "m/s^2"),
        angular(model, "angular_bias_acceleration", "rad/s^2"),
    ]
    .concat()
}

fn point(model: &Model) -> String {
    let Results { poses, velocities, z, .. } = model.results();
    let vector = |name: &str| vector(model, name);
    let angular = |name: &str, comment: &str| angular(model, name, comment);
    let mut text = String::new();
    if poses {
        text += &pose(model);
    }
    if velocities {
        text += &field("mstmm_real", &vector("velocity"), "m/s");
        text += &angular("angular_velocity", "rad/s");
    }
    if z {
        text += &field(
            "mstmm_real",
            &vector("acceleration"),
            "m/s^2, relative to the inertial frame: zero at rest",
        );
        text += &angular("angular_acceleration", "rad/s^2");
        text += &angular(
            "moment",
            "N m, acts on the part inboard of the point; its opposite acts on the part outboard of it",
        );
        text += &field(
            "mstmm_real",
            &vector("force"),
            "N, acts on the part outboard of the point; its opposite acts on the part inboard of it",
        );
    }
    text
}
