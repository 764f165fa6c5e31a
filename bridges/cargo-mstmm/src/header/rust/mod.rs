//! The functions of the header in Rust, without unsafe code: a pointer that may be null is an `Option` of a reference.

mod always;
mod answers;
mod conversions;
mod types;

use super::Model;
use super::functions::{Shape, VARIATION, is_closed};

/// Returns `src/mstmm_NAME.rs` without its first line.
pub fn chain(model: &Model) -> String {
    let mut text = format!(
        "//! The functions of `{prefix}` in the header.\n\
         #![expect(unsafe_code, reason = \"names that a linker sees\")]\n\
         #![allow(clippy::unnecessary_wraps, non_snake_case)]\n\n\
         use core::ffi::{{CStr, c_char}};\n\
         use core::mem::MaybeUninit;\n\n\
         {imports}\n\n",
        prefix = model.prefix,
        imports = imports(model),
    );
    text += &types::of(model);
    text += &conversions::of(model);
    text += &always::of(model);
    for (number, _) in model.tables.parameters.entries.iter().enumerate() {
        text += &always::parameter(model, number);
    }
    if model.functions.use_shape(Shape::Frame) {
        text += &answers::frames(model);
    }
    for function in &model.functions.all {
        text += &answers::function(model, function);
    }
    if is_closed(&model.tables) {
        text += &always::assemble(model);
    }
    text
}

/// Returns the names that the file uses.
fn imports(model: &Model) -> String {
    let functions = &model.functions;
    let mut of_mstmm = vec![model.method.parts().0];
    if model.tables.plain_inputs.is_none() {
        of_mstmm.push("Described");
    }
    if model.has_quaternions() && functions.all.iter().any(|function| function.of_state) {
        of_mstmm.push("Chain");
    }
    if functions.use_shape(Shape::Frame) {
        of_mstmm.push("FrameMotion");
        of_mstmm.push("description::Answers");
    }
    let text: String = functions.all.iter().map(|function| &*function.compute).collect();
    let values: String = functions
        .all
        .iter()
        .flat_map(|function| &function.results)
        .map(|result| &*result.value)
        .collect();
    for name in ["SMatrix", "SVector"] {
        if text.contains(name) || values.contains(name) {
            of_mstmm.push(if name == "SMatrix" {
                "nalgebra::SMatrix"
            } else {
                "nalgebra::SVector"
            });
        }
    }
    of_mstmm.sort_unstable();
    let of_mstmm = match of_mstmm.as_slice() {
        [single] => (*single).to_owned(),
        names => format!("{{{}}}", names.join(", ")),
    };
    let chain = &model.chain;
    let mut own = vec!["Real".to_owned(), "Status".to_owned(), chain.clone()];
    own.extend(["Inputs", "State", "Workspace"].map(|name| format!("{chain}{name}")));
    if functions.use_shape(VARIATION) {
        own.push(format!("{chain}Variation"));
    }
    format!("use mstmm::{of_mstmm};\n\nuse crate::{{{}}};", own.join(", "))
}

/// Returns the attributes of a function.
fn exported(docs: &str) -> String {
    format!("/// {docs}\n// SAFETY: nothing else has this name.\n#[unsafe(no_mangle)]\n")
}
