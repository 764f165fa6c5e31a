//! Building of images by cargo.

use std::env;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{Context, Result, ensure};

use crate::board::Processor;
use crate::case::Case;

const TARGET: &str = "thumbv7em-none-eabihf";

/// The linker's message for an image with a reachable panic.
const PANIC: &str = "undefined symbol: this_firmware_can_panic";

/// A cargo with the target, if the usual cargo does not have it; `tools` makes it.
const OTHER_CARGO: &str = "FIRMWARE_CARGO";

fn cargo() -> String {
    env::var(OTHER_CARGO).unwrap_or_else(|_| "cargo".into())
}

/// Returns the target folder for the images of a processor.
fn folder(processor: Processor) -> PathBuf {
    let target = env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let here = || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../target");
    target.unwrap_or_else(here).join(processor.name())
}

/// Returns the cargo command that builds an image for a processor.
fn building(name: &str, processor: Processor) -> Command {
    let mut command = Command::new(cargo());
    command
        .args(["build", "--release", "--quiet", "--package", "image", "--target", TARGET])
        .args(["--bin", name, "--target-dir"])
        .arg(folder(processor))
        .current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."))
        .env("RUSTFLAGS", format!("-C target-cpu={}", processor.name()))
        // Variables that cargo sets for its children do not apply to another cargo.
        .env_remove("CARGO_ENCODED_RUSTFLAGS");
    command
}

/// Builds an image and returns its path.
pub fn image(name: &str, processor: Processor) -> Result<PathBuf> {
    let status = building(name, processor).status().context("cargo does not start")?;
    ensure!(status.success(), "{name} cannot be built for the {}", processor.name());
    Ok(folder(processor).join(TARGET).join("release").join(name))
}

/// Returns whether the linker rejects a step with an index that may be out of bounds, because of the panic.
pub fn control_is_refused() -> Result<bool> {
    let mut command = building(Case::ALL[0].name(), Processor::CortexM4);
    let output = command.args(["--features", "control"]).output()?;
    Ok(!output.status.success() && String::from_utf8_lossy(&output.stderr).contains(PANIC))
}

/// Returns the compiler that builds the images, with its version.
pub fn compiler() -> Result<String> {
    let output = Command::new(cargo()).arg("--version").output()?;
    Ok(String::from_utf8_lossy(&output.stdout).trim().into())
}
