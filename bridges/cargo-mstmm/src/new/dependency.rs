//! The requirement of a project on the crate `mstmm`.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::commands::Failure;

/// The source of the crate `mstmm`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Dependency {
    /// A folder, absolute.
    Folder(PathBuf),
    /// The URL of a git repository.
    Git(String),
    /// A version in the registry.
    Version(String),
}

impl Default for Dependency {
    /// The checkout that this command was built from; if it does not exist any more, the version of this command.
    fn default() -> Self {
        let checkout = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
        Dependency::in_folder(&checkout)
            .unwrap_or_else(|_| Dependency::Version(env!("CARGO_PKG_VERSION").to_owned()))
    }
}

impl Dependency {
    /// Returns the crate in a folder.
    ///
    /// # Errors
    ///
    /// If the folder has no package `mstmm`.
    pub fn in_folder(folder: &Path) -> Result<Self, Failure> {
        let shown = folder.display();
        let absolute =
            folder.canonicalize().map_err(|error| Failure(format!("{shown}: {error}")))?;
        let manifest = super::super::commands::read(&absolute.join("Cargo.toml"))?;
        let is_mstmm = manifest.lines().any(|line| line.trim() == "name = \"mstmm\"");
        match is_mstmm {
            true => Ok(Dependency::Folder(absolute)),
            false => Err(Failure(format!("{shown}: the folder has no package `mstmm`"))),
        }
    }

    /// Returns the value of its key in `Cargo.toml`, without features.
    #[must_use]
    pub fn requirement(&self) -> String {
        let (key, value) = self.entry();
        format!("{{ {key} = {} }}", quoted(&value))
    }

    /// Returns the value of the key of a crate of the repository, in a folder of it, with features in quotes.
    #[must_use]
    pub fn with_features(&self, folder: &str, features: &str) -> String {
        let (key, value) = match self {
            Dependency::Folder(path) => ("path", path.join(folder).display().to_string()),
            _ => self.entry(),
        };
        format!("{{ {key} = {}, features = [{features}] }}", quoted(&value))
    }

    /// Returns the value of its key in `Cargo.toml` without the feature `std`.
    #[must_use]
    pub fn without_std(&self) -> String {
        let (key, value) = self.entry();
        format!("{{ {key} = {}, default-features = false }}", quoted(&value))
    }

    fn entry(&self) -> (&'static str, String) {
        match self {
            Dependency::Folder(path) => ("path", path.display().to_string()),
            Dependency::Git(url) => ("git", url.clone()),
            Dependency::Version(version) => ("version", version.clone()),
        }
    }
}

/// Returns a text as a basic string of TOML.
fn quoted(text: &str) -> String {
    let escape = |letter: char| match letter {
        '"' | '\\' => format!("\\{letter}"),
        letter if letter.is_control() => format!("\\u{:04x}", letter as u32),
        letter => letter.to_string(),
    };
    format!("\"{}\"", text.chars().map(escape).collect::<String>())
}

impl fmt::Display for Dependency {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Dependency::Folder(path) => {
                write!(f, "mstmm in the folder {}: the path is absolute", path.display())
            }
            Dependency::Git(url) => write!(f, "mstmm in the git repository {url}"),
            Dependency::Version(version) => {
                write!(f, "version {version} of mstmm, which must be in the registry")
            }
        }
    }
}
