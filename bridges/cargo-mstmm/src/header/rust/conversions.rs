//! Conversions between the structs of the header and the types of the chain.

use super::super::Model;
use super::super::functions::{MOMENTUM, MOTION, VARIATION};
use super::types::{fields, motion_fields};
use mstmm_codegen::emit::NamedArray;
use mstmm_codegen::model::Dimension;

/// Returns the conversions.
pub(super) fn of(model: &Model) -> String {
    let Model { chain, tables, .. } = model;
    // Arrays of C have at least one entry.
    let into = |array: &NamedArray, name: &str| match array.length {
        0 => format!("{name}: [].into()"),
        _ => format!("{name}: state.{name}.into()"),
    };
    let from = |array: &NamedArray, name: &str| match array.length {
        0 => format!("{name}: [0.0]"),
        _ => format!("{name}: state.{name}.into()"),
    };
    let (q, v) = (&tables.coordinates, &tables.rates);
    let mut text = format!(
        "impl From<State> for {chain}State<Real> {{\n    \
             fn from(state: State) -> Self {{\n        Self {{ {}, {}, t: state.t }}\n    }}\n\
         }}\n\n\
         impl From<{chain}State<Real>> for State {{\n    \
             fn from(state: {chain}State<Real>) -> Self {{\n        Self {{ {}, {}, t: state.t }}\n    }}\n\
         }}\n\n",
        into(q, "q"),
        into(v, "v"),
        from(q, "q"),
        from(v, "v"),
    );
    text += &inputs(model);
    let accelerations = match v.length {
        0 => "accelerations: [0.0]",
        _ => "accelerations: (*at.accelerations()).into()",
    };
    let mut values = vec![accelerations];
    if model.results().energies {
        values.extend([
            "kinetic_energy: at.kinetic_energy()",
            "potential_energy: at.potential_energy()",
        ]);
    }
    let points;
    if model.has_points() {
        let fields = fields(model).into_iter().map(|(name, ty, method)| match (name, ty) {
            ("orientation", _) => {
                "orientation: point.orientation().matrix().transpose().into()".to_owned()
            }
            ("cos_sin", _) => "cos_sin: point.cos_sin().into()".to_owned(),
            (_, "Real") => format!("{name}: point.{method}()"),
            _ => format!("{name}: point.{method}().into()"),
        });
        points = format!(
            "points: at.points().map(|point| Point {{\n                {},\n            }})",
            fields.collect::<Vec<_>>().join(",\n                ")
        );
        values.push(&points);
    }
    text += &format!(
        "impl From<{chain}Workspace<Real>> for Results {{\n    \
             fn from(at: {chain}Workspace<Real>) -> Self {{\n        \
                 Self {{\n            {},\n        }}\n    }}\n\
         }}\n\n",
        values.join(",\n            ")
    );
    text + &answers(model)
}

/// Returns the conversions of the structs of functions that depend on the description.
fn answers(model: &Model) -> String {
    let mut text = String::new();
    if model.functions.use_shape(VARIATION) {
        text += &variation(model);
    }
    if model.functions.use_shape(MOTION) {
        text += &motion(model);
    }
    if model.functions.use_shape(MOMENTUM) {
        text += &momentum(model);
    }
    text
}

fn variation(model: &Model) -> String {
    let Model { chain, tables, .. } = model;
    let arrays = [
        ("coordinates", &tables.rates),
        ("rates", &tables.rates),
        ("inputs", &tables.inputs),
        ("parameters", &tables.parameters),
    ];
    let fields = |empty: &str| {
        let field = |(name, array): (&str, &NamedArray)| match array.length {
            0 => format!("{name}: {empty}"),
            _ => format!("{name}: it.{name}.into()"),
        };
        arrays.map(|(name, array)| field((name, array))).join(", ")
    };
    format!(
        "impl From<Variation> for {chain}Variation<Real> {{\n    \
             fn from(it: Variation) -> Self {{\n        Self {{ {} }}\n    }}\n}}\n\n\
         impl From<{chain}Variation<Real>> for Variation {{\n    \
             fn from(it: {chain}Variation<Real>) -> Self {{\n        Self {{ {} }}\n    }}\n}}\n\n",
        fields("[].into()"),
        fields("[0.0]"),
    )
}

/// Returns the conversion of a motion, which has three components in all dimensions.
fn motion(model: &Model) -> String {
    let field = |(name, ty): (&str, &str)| match (name, ty) {
        ("cos_sin", _) => "cos_sin: [cosine, sine]".to_owned(),
        ("orientation", _) => "orientation: it.orientation".to_owned(),
        (_, "[Real; 3]") => format!("{name}: it.{name}"),
        (_, "[Real; 2]") => {
            format!(
                "{name}: {{\n                let [x, y, _] = it.{name};\n                [x, y]\n            }}"
            )
        }
        // A rotation of a plane is about z; a line is along x.
        _ if name.starts_with("angular") => {
            format!(
                "{name}: {{\n                let [_, _, z] = it.{name};\n                z\n            }}"
            )
        }
        _ => format!(
            "{name}: {{\n                let [x, _, _] = it.{name};\n                x\n            }}"
        ),
    };
    let before = match model.dimension() {
        Dimension::Plane => "let [[cosine, ..], [sine, ..], _] = it.orientation;\n        ",
        _ => "",
    };
    let fields: Vec<String> = motion_fields(model).into_iter().map(field).collect();
    format!(
        "impl From<FrameMotion<Real>> for Motion {{\n    \
             fn from(it: FrameMotion<Real>) -> Self {{\n        {before}Self {{\n            {},\n        }}\n    }}\n}}\n\n",
        fields.join(",\n            ")
    )
}

fn momentum(model: &Model) -> String {
    let (name, fields) = match model.dimension() {
        Dimension::Space => (
            "Momentum",
            "center_of_mass: it.center_of_mass.into(), linear: it.linear.into(), angular: it.angular.into()",
        ),
        Dimension::Plane => (
            "PlaneMomentum",
            "center_of_mass: it.center_of_mass.into(), linear: it.linear.into(), angular: it.angular",
        ),
        Dimension::Line => ("LineMomentum", "center_of_mass: it.center_of_mass, linear: it.linear"),
    };
    format!(
        "impl From<mstmm::{name}<Real>> for Momentum {{\n    \
             fn from(it: mstmm::{name}<Real>) -> Self {{\n        Self {{ mass: it.mass, {fields} }}\n    }}\n}}\n\n"
    )
}

/// Returns the conversion of inputs: field by field if all are scalars or vectors, otherwise in the order of the
/// description.
fn inputs(model: &Model) -> String {
    let Model { chain, tables, .. } = model;
    let (argument, body) = match &tables.plain_inputs {
        Some(fields) if fields.is_empty() => ("_".to_owned(), "Self::default()".to_owned()),
        Some(fields) => {
            let numbers: Vec<String> =
                (0..tables.inputs.length).map(|at| format!("u{at}")).collect();
            let mut rest = &numbers[..];
            let mut values = Vec::new();
            for (name, count) in fields {
                let (own, others) = rest.split_at(*count);
                rest = others;
                values.push(match own {
                    [single] => format!("{name}: {single}"),
                    own => format!("{name}: [{}].into()", own.join(", ")),
                });
            }
            let pattern = format!("Inputs {{ u: [{}] }}", numbers.join(", "));
            (pattern, format!("Self {{ {} }}", values.join(", ")))
        }
        None => (
            "inputs".to_owned(),
            format!(
                "// The length is right, so the default does not occur.\n        \
                 {chain}::inputs_from_slice(&inputs.u).unwrap_or_default()"
            ),
        ),
    };
    format!(
        "impl From<Inputs> for {chain}Inputs<Real> {{\n    \
             fn from({argument}: Inputs) -> Self {{\n        {body}\n    }}\n\
         }}\n\n"
    )
}
