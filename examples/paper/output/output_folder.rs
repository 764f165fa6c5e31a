//! The folder of the files.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// Creates the folder `paper` in cargo's target folder, whatever the current folder is.
pub fn create() -> Result<PathBuf, io::Error> {
    let folder = target_folder()?.join("paper");
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

fn target_folder() -> Result<PathBuf, io::Error> {
    match env::var_os("CARGO_TARGET_DIR") {
        Some(folder) => std::path::absolute(folder),
        None => {
            let package = Path::new(env!("CARGO_MANIFEST_DIR"));
            let workspace = package.parent().unwrap_or(package);
            Ok(workspace.join("target"))
        }
    }
}

/// The path for people: relative if the file is in the current folder.
pub fn shown(path: &Path) -> PathBuf {
    let current = env::current_dir().unwrap_or_default();
    path.strip_prefix(&current).unwrap_or(path).to_owned()
}
