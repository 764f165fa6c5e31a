//! The arguments for the crate `mstmm` that a project depends on.

use clap::Args;
use std::path::PathBuf;

use super::Failure;
use crate::new::Dependency;

/// The crate `mstmm` of a project.
#[derive(Args, Debug)]
pub struct DependencyArguments {
    /// Depend on the crate mstmm in this folder; without `--path`, `--git` and `--version` on the checkout that this
    /// command was built from
    #[arg(long, value_name = "FOLDER")]
    path: Option<PathBuf>,
    /// Depend on the crate mstmm in this git repository
    #[arg(long, value_name = "URL", conflicts_with_all = ["path", "version"])]
    git: Option<String>,
    /// Depend on this version of the crate mstmm in the registry
    #[arg(long, value_name = "VERSION", conflicts_with = "path")]
    version: Option<String>,
}

impl DependencyArguments {
    /// Returns the dependency.
    ///
    /// # Errors
    ///
    /// If the folder has no package `mstmm`.
    pub fn choose(&self) -> Result<Dependency, Failure> {
        if let Some(path) = &self.path {
            return Dependency::in_folder(path);
        }
        if let Some(url) = &self.git {
            return Ok(Dependency::Git(url.clone()));
        }
        Ok(match &self.version {
            Some(version) => Dependency::Version(version.clone()),
            None => Dependency::default(),
        })
    }
}
