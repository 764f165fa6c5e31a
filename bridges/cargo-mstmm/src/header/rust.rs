//! The functions of the header in Rust, without unsafe code: a pointer that may be null is an `Option` of a reference.

use super::Model;
use super::functions::{Function, is_closed, linearizes};
use mstmm_codegen::emit::{Entry, NamedArray};
use mstmm_codegen::model::{Dimension, Results};

/// Returns `src/mstmm_NAME.rs` without its first line.
pub fn chain(model: &Model) -> String {
    let chain = &model.chain;
    let integrator = model.method.parts().0;
    let import = match model.tables.plain_inputs {
        Some(_) => integrator.to_owned(),
        None => format!("{{Described, {integrator}}}"),
    };
    let mut text = format!(
        "//! The functions of `{prefix}` in the header.\n\
         #![expect(unsafe_code, reason = \"names that a linker sees\")]\n\
         #![allow(clippy::unnecessary_wraps, non_snake_case)]\n\n\
         use core::ffi::{{CStr, c_char}};\n\
         use core::mem::MaybeUninit;\n\n\
         use mstmm::{import};\n\n\
         use crate::{{Real, Status, {chain}, {chain}Inputs, {chain}State, {chain}Workspace}};\n\n",
        prefix = model.prefix,
        import = import,
    );
    text += &types(model);
    text += &conversions(model);
    text += &always(model);
    for (number, _) in model.tables.parameters.entries.iter().enumerate() {
        text += &parameter(model, number);
    }
    for function in &model.functions {
        text += &answer(model, function);
    }
    if linearizes(&model.tables) {
        text += &linearize(model);
    }
    if is_closed(&model.tables) {
        text += &assemble(model);
    }
    text
}

/// Returns the length of an array in C, which cannot be zero.
fn length(array: &NamedArray) -> usize {
    array.length.max(1)
}

fn types(model: &Model) -> String {
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
    text + &format!(
        "/// `{prefix}_results` of the header.\n\
         #[repr(C)]\n\
         #[derive(Clone, Copy, Debug, PartialEq)]\n\
         pub struct Results {{\n{results}}}\n\n"
    )
}

/// Returns the fields of a point: name, type, and its value from `point`.
fn fields(model: &Model) -> Vec<(&'static str, &'static str, &'static str)> {
    let Results { poses, velocities, z, .. } = model.results();
    let vector = match model.dimension() {
        Dimension::Space => "[Real; 3]",
        Dimension::Plane => "[Real; 2]",
        Dimension::Line => "Real",
    };
    let rotation = match model.dimension() {
        Dimension::Space => Some("[Real; 3]"),
        Dimension::Plane => Some("Real"),
        Dimension::Line => None,
    };
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

fn conversions(model: &Model) -> String {
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
    text + &format!(
        "impl From<{chain}Workspace<Real>> for Results {{\n    \
             fn from(at: {chain}Workspace<Real>) -> Self {{\n        \
                 Self {{\n            {},\n        }}\n    }}\n\
         }}\n\n",
        values.join(",\n            ")
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

/// Returns the attributes of a function.
fn exported(docs: &str) -> String {
    format!("/// {docs}\n// SAFETY: nothing else has this name.\n#[unsafe(no_mangle)]\n")
}

fn always(model: &Model) -> String {
    let Model { chain, prefix, tables, .. } = model;
    let integrator = model.method.parts().0;
    let no_inputs = match (&tables.plain_inputs, tables.inputs.length) {
        (Some(_), length) => format!("let u = [0.0; {}];", length.max(1)),
        (None, length) => format!(
            "let mut u = [0.0; {length}];\n    \
             // The length is right, so the copy is complete.\n    \
             let _ = {chain}::inputs_to_slice(&{chain}Inputs::default(), &mut u);"
        ),
    };
    [
        exported("Makes a chain with a step in s."),
        format!(
            "pub extern \"C\" fn {prefix}_init(model: Option<&mut MaybeUninit<Model>>, step: Real) -> Status {{\n    \
                 let Some(model) = model else {{ return Status::NULL_POINTER }};\n    \
                 if !step.is_finite() {{\n        return Status::NOT_FINITE;\n    }}\n    \
                 model.write(Model {{ chain: {chain}::new(), integrator: {integrator}::new(step) }});\n    \
                 Status::OK\n}}\n\n"
        ),
        exported("Sets the step in s."),
        format!(
            "pub extern \"C\" fn {prefix}_set_step(model: Option<&mut Model>, step: Real) -> Status {{\n    \
                 let Some(model) = model else {{ return Status::NULL_POINTER }};\n    \
                 if !step.is_finite() {{\n        return Status::NOT_FINITE;\n    }}\n    \
                 model.integrator.set_step_size(step);\n    \
                 Status::OK\n}}\n\n"
        ),
        exported("Writes inputs that are zero."),
        format!(
            "pub extern \"C\" fn {prefix}_no_inputs(inputs: Option<&mut MaybeUninit<Inputs>>) -> Status {{\n    \
                 let Some(inputs) = inputs else {{ return Status::NULL_POINTER }};\n    \
                 {no_inputs}\n    \
                 inputs.write(Inputs {{ u }});\n    \
                 Status::OK\n}}\n\n"
        ),
        exported("Writes the start."),
        format!(
            "pub extern \"C\" fn {prefix}_initial_state(\n    \
                 model: Option<&Model>,\n    state: Option<&mut MaybeUninit<State>>,\n) -> Status {{\n    \
                 let (Some(model), Some(state)) = (model, state) else {{ return Status::NULL_POINTER }};\n    \
                 state.write(model.chain.initial_state().into());\n    \
                 Status::OK\n}}\n\n"
        ),
        exported("Takes one step with constant inputs."),
        format!(
            "pub extern \"C\" fn {prefix}_step(\n    \
                 model: Option<&mut Model>,\n    state: Option<&mut State>,\n    inputs: Option<&Inputs>,\n) -> Status {{\n    \
                 let (Some(model), Some(state), Some(inputs)) = (model, state, inputs) else {{\n        \
                     return Status::NULL_POINTER;\n    }};\n    \
                 let mut moved = {chain}State::from(*state);\n    \
                 let stepped = model.integrator.step(&model.chain, &mut moved, |_, _| (*inputs).into());\n    \
                 Status::of(stepped.map(|()| *state = moved.into()), &HINGES)\n}}\n\n"
        ),
        exported("Computes all results."),
        format!(
            "pub extern \"C\" fn {prefix}_solve(\n    \
                 model: Option<&Model>,\n    state: Option<&State>,\n    inputs: Option<&Inputs>,\n    \
                 results: Option<&mut MaybeUninit<Results>>,\n) -> Status {{\n    \
                 let (Some(model), Some(state), Some(inputs), Some(results)) = (model, state, inputs, results) else {{\n        \
                     return Status::NULL_POINTER;\n    }};\n    \
                 let mut at = model.chain.workspace();\n    \
                 let solved = model.chain.solve_into(&(*state).into(), &(*inputs).into(), &mut at);\n    \
                 Status::of(solved.map(|()| _ = results.write(at.into())), &HINGES)\n}}\n\n"
        ),
        exported("Returns the size of a chain in bytes."),
        format!(
            "pub extern \"C\" fn {prefix}_size() -> u32 {{\n    size_of::<Model>() as u32\n}}\n\n"
        ),
        exported("Returns the name of a hinge."),
        format!(
            "pub extern \"C\" fn {prefix}_hinge_name(hinge: i32) -> *const c_char {{\n    \
                 crate::status::name(&HINGES, hinge).as_ptr()\n}}\n\n"
        ),
    ]
    .concat()
}

/// Returns the functions that set and read a parameter.
fn parameter(model: &Model, number: usize) -> String {
    let (prefix, name) = (&model.prefix, &model.parameters[number]);
    let Entry { path, repeated, .. } = &model.tables.parameters.entries[number];
    let rust = path.trim_end_matches("[]");
    let setter = rust.trim_start_matches("r#");
    let (argument, check, place, set) = match repeated {
        None => (
            "",
            String::new(),
            format!("model.chain.parameters().{rust}()"),
            format!("model.chain.set_{setter}(value)"),
        ),
        Some([count, _]) => (
            " index: i32,",
            format!(
                "let Some(index) = usize::try_from(index).ok().filter(|index| *index < {count}) else {{\n        \
                     return Status::INDEX;\n    }};\n    "
            ),
            format!("model.chain.parameters().{rust}().get(index).copied().unwrap_or_default()"),
            format!(
                "{{\n        let mut values = *model.chain.parameters().{rust}();\n        \
                     if let Some(place) = values.get_mut(index) {{\n            *place = value;\n        }}\n        \
                     let mut values = values.into_iter();\n        \
                     model.chain.set_{setter}(|_| values.next().unwrap_or_default())\n    }}"
            ),
        ),
    };
    exported(&format!("Sets the parameter `{rust}`."))
        + &format!(
            "pub extern \"C\" fn {prefix}_set_{name}(model: Option<&mut Model>,{argument} value: Real) -> Status {{\n    \
                 let Some(model) = model else {{ return Status::NULL_POINTER }};\n    \
                 {check}let set = {set};\n    \
                 Status::of(set, &HINGES)\n}}\n\n"
        )
        + &exported(&format!("Reads the parameter `{rust}`."))
        + &format!(
            "pub extern \"C\" fn {prefix}_get_{name}(\n    \
                 model: Option<&Model>,{argument} value: Option<&mut MaybeUninit<Real>>,\n) -> Status {{\n    \
                 let (Some(model), Some(value)) = (model, value) else {{ return Status::NULL_POINTER }};\n    \
                 {check}value.write({place});\n    \
                 Status::OK\n}}\n\n"
        )
}

/// Returns a function with a vector or a matrix as its result.
fn answer(model: &Model, function: &Function) -> String {
    let (prefix, rates) = (&model.prefix, model.tables.rates.length);
    let Function { name, given, result, is_matrix, docs, .. } = *function;
    let ty =
        if is_matrix { format!("[[Real; {rates}]; {rates}]") } else { format!("[Real; {rates}]") };
    let (argument, pattern, taken) = match given {
        None => (String::new(), String::new(), String::new()),
        Some((given, _)) => (
            format!("    {given}: Option<&[Real; {rates}]>,\n"),
            format!("Some({given}), "),
            format!("{given}, "),
        ),
    };
    // The arguments of Rust: accelerations precede inputs, other vectors follow them.
    let arguments = match given {
        Some(("accelerations", _)) => "&state, &(*accelerations).into(), &inputs",
        Some(_) => "&state, &inputs, &(*vector).into()",
        None => "&state, &inputs",
    };
    // Rows of C are columns of nalgebra.
    let value = if is_matrix { "computed.transpose().into()" } else { "computed.into()" };
    exported(docs)
        + &format!(
            "pub extern \"C\" fn {prefix}_{name}(\n    \
                 model: Option<&Model>,\n    state: Option<&State>,\n    inputs: Option<&Inputs>,\n{argument}    \
                 {result}: Option<&mut MaybeUninit<{ty}>>,\n) -> Status {{\n    \
                 let (Some(model), Some(state), Some(inputs), {pattern}Some({result})) =\n        \
                     (model, state, inputs, {taken}{result})\n    else {{\n        return Status::NULL_POINTER;\n    }};\n    \
                 let (state, inputs) = ((*state).into(), (*inputs).into());\n    \
                 let computed = model.chain.{name}({arguments});\n    \
                 Status::of(computed.map(|computed| _ = {result}.write({value})), &HINGES)\n}}\n\n"
        )
}

fn linearize(model: &Model) -> String {
    let (prefix, n, u) = (&model.prefix, 2 * model.tables.rates.length, model.tables.inputs.length);
    let (argument, pattern, taken, write) = match u {
        0 => (String::new(), "", "", ""),
        u => (
            format!("    b: Option<&mut MaybeUninit<[[Real; {u}]; {n}]>>,\n"),
            ", Some(b)",
            ", b",
            "\n        b.write(linear.b().transpose().into());",
        ),
    };
    exported("Computes the linearised equations of motion.")
        + &format!(
            "pub extern \"C\" fn {prefix}_linearize(\n    \
                 model: Option<&Model>,\n    state: Option<&State>,\n    inputs: Option<&Inputs>,\n    \
                 a: Option<&mut MaybeUninit<[[Real; {n}]; {n}]>>,\n{argument}) -> Status {{\n    \
                 let (Some(model), Some(state), Some(inputs), Some(a){pattern}) = (model, state, inputs, a{taken}) else {{\n        \
                     return Status::NULL_POINTER;\n    }};\n    \
                 let (state, inputs) = ((*state).into(), (*inputs).into());\n    \
                 let written = model.chain.linearize(&state, &inputs).map(|linear| {{\n        \
                     a.write(linear.a().transpose().into());{write}\n    }});\n    \
                 Status::of(written, &HINGES)\n}}\n\n"
        )
}

fn assemble(model: &Model) -> String {
    let (chain, prefix) = (&model.chain, &model.prefix);
    exported("Closes the loop.")
        + &format!(
            "pub extern \"C\" fn {prefix}_assemble(\n    \
                 model: Option<&Model>,\n    state: Option<&mut State>,\n    inputs: Option<&Inputs>,\n) -> Status {{\n    \
                 let (Some(model), Some(state), Some(inputs)) = (model, state, inputs) else {{\n        \
                     return Status::NULL_POINTER;\n    }};\n    \
                 let mut closed = {chain}State::from(*state);\n    \
                 let assembled = model.chain.assemble(&mut closed, &(*inputs).into());\n    \
                 Status::of(assembled.map(|()| *state = closed.into()), &HINGES)\n}}\n\n"
        )
}
