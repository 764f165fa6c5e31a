//! What the README states and shows: its figures, its program and its picture.
//!
//! The picture is drawn from the results of the README's program. `MSTMM_BLESS=1 cargo test --test readme` writes it.

#[path = "readme/figures.rs"]
mod figures;
#[path = "readme/picture.rs"]
mod picture;

use std::path::{Path, PathBuf};

/// A file of the repository.
fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn read(name: &str) -> String {
    std::fs::read_to_string(path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}
