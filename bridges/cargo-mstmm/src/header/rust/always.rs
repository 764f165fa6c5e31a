//! The functions that all chains have, and those of parameters.

use super::super::Model;
use super::exported;
use mstmm_codegen::emit::Entry;

/// Returns the functions that all chains have.
pub(super) fn of(model: &Model) -> String {
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
pub(super) fn parameter(model: &Model, number: usize) -> String {
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

/// Returns the assembly of a closed chain.
pub(super) fn assemble(model: &Model) -> String {
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
