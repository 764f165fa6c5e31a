//! The extension module.

mod arrays;
mod core;
mod describe;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyModule};

use self::core::{Core, Maker};
use crate::blocks::Blocks;

/// Fills the Python module with the classes of all chains.
///
/// # Errors
/// Those of Python.
#[doc(hidden)]
pub fn fill(module: &Bound<'_, PyModule>, chains: &[fn() -> Box<dyn Blocks>]) -> PyResult<()> {
    let py = module.py();
    let name = module.name()?.to_string();
    let text = std::ffi::CString::new(include_str!("../python/model.py"))?;
    let globals = PyDict::new(py);
    globals.set_item("__name__", format!("{name}._model"))?;
    globals.set_item("Core", py.get_type::<Core>())?;
    globals.set_item("module_name", &name)?;
    for (file, text) in FILES {
        globals.set_item(file, text)?;
    }
    py.run(&text, Some(&globals), None)?;
    let fill = globals.get_item("fill")?;
    let makers: Vec<Maker> = chains.iter().map(|make| Maker(*make)).collect();
    if let Some(fill) = fill {
        fill.call1((module, makers))?;
    }
    Ok(())
}

/// The texts of submodules in Python.
const FILES: [(&str, &str); 2] = [
    ("environment_text", include_str!("../python/environment.py")),
    ("gradients_text", include_str!("../python/gradients.py")),
];
