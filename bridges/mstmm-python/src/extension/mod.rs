//! The extension module.

mod arrays;
mod core;
mod describe;
mod errors;
mod job;
mod recorder;

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyModule};

pub use self::core::Maker;

use self::core::Core;

/// Fills the Python module with the classes of all chains.
///
/// # Errors
/// Those of Python.
#[doc(hidden)]
pub fn fill(module: &Bound<'_, PyModule>, makers: Vec<Maker>) -> PyResult<()> {
    let py = module.py();
    let name = module.name()?.to_string();
    let globals = PyDict::new(py);
    globals.set_item("__name__", format!("{name}._model"))?;
    globals.set_item("Core", py.get_type::<Core>())?;
    globals.set_item("module_name", &name)?;
    for (file, text) in FILES {
        globals.set_item(file, text)?;
    }
    for text in TEXTS {
        py.run(&std::ffi::CString::new(text)?, Some(&globals), None)?;
    }
    let fill = globals.get_item("fill")?;
    if let Some(fill) = fill {
        fill.call1((module, makers))?;
    }
    Ok(())
}

/// The texts of the module in Python, which share their names.
const TEXTS: [&str; 4] = [
    include_str!("../python/recording.py"),
    include_str!("../python/parameters.py"),
    include_str!("../python/model.py"),
    include_str!("../python/stubs.py"),
];

/// The texts of submodules in Python.
const FILES: [(&str, &str); 2] = [
    ("environment_text", include_str!("../python/environment.py")),
    ("gradients_text", include_str!("../python/gradients.py")),
];
