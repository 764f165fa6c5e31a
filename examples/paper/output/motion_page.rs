//! Pages that show the motions with all forces.

use std::io;
use std::path::{Path, PathBuf};

use mstmm_look::PageOptions;

use crate::compare::Comparison;
use crate::system::System;

/// Returns the name of the file of a system.
pub fn file_name(system: &System) -> String {
    format!("{}.html", system.file_stem)
}

/// Writes the page of a comparison to `folder` and returns the file.
pub fn write(folder: &Path, comparison: &Comparison) -> Result<PathBuf, io::Error> {
    let System { label, title, .. } = &comparison.system;
    let path = folder.join(file_name(&comparison.system));
    let options = PageOptions::default().title(format!("{label}: {title}"));
    comparison.motion.write_html_with(&path, &options)?;
    Ok(path)
}
