"""A program for each robot that evaluates its generated code, as a crate in the work folder."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import numpy as np

from ..paths import ROOT
from .imported import Text
from .robots import Model
from .urdf import Robot

MANIFEST = f"""[package]
name = "trees"
version = "0.1.0"
edition = "2024"

[dependencies]
mstmm = {{ path = "{ROOT}" }}

[profile.dev]
debug = false

[workspace]
"""

# For each state: accelerations by both functions, then force and moment of each hinge on its outboard body,
# in inertial axes, about the body's input.
PROGRAM = """//! Evaluates the generated code for all states of a file.

use mstmm::prelude::*;

include!("{name}.chain");

fn main() -> Result<(), Box<dyn std::error::Error>> {{
    let paths: Vec<String> = std::env::args().skip(1).collect();
    let [states, results] = paths.as_slice() else {{ return Err("{name} STATES RESULTS".into()) }};
    let bytes = std::fs::read(states)?;
    let numbers: Vec<f64> = bytes.as_chunks().0.iter().map(|&eight| f64::from_le_bytes(eight)).collect();

    {mutable}chain = {chain}::<f64>::new();
{setters}    let mut state = chain.initial_state();
    let (coordinates, rates) = (state.q.len(), state.v.len());
    let mut at = chain.workspace();
    let mut written: Vec<u8> = Vec::new();
    for numbers in numbers.chunks_exact(coordinates + 2 * rates) {{
        state.q.as_mut_slice().copy_from_slice(&numbers[..coordinates]);
        state.v.as_mut_slice().copy_from_slice(&numbers[coordinates..coordinates + rates]);
        let efforts = &numbers[coordinates + rates..];
        let inputs = {chain}Inputs {{
{inputs}        }};
        let accelerations = chain.accelerations(&state, &inputs)?;
        chain.solve_into(&state, &inputs, &mut at)?;
        let points = [
{points}        ];
        let wrenches = points.iter().flat_map(|point| [point.force(), -point.moment()]);
        let results = accelerations.iter().chain(at.accelerations().iter()).copied();
        let results = results.chain(wrenches.flat_map(|vector| [vector.x, vector.y, vector.z]));
        written.extend(results.flat_map(f64::to_le_bytes));
    }}
    Ok(std::fs::write(results, written)?)
}}
"""


def write(work: Path, model: Model, text: Text) -> None:
    """Writes the text of a robot and its program."""
    folder = work / "crate/src/bin"
    folder.mkdir(parents=True, exist_ok=True)
    (work / "crate/Cargo.toml").write_text(MANIFEST)
    name = model.name.lower()
    first = 6 if model.floating else 0
    setters = [f"    chain.set_{parameter}(0.0)?;\n" for parameter in model.undamped]
    inputs = [f"            {hinge}: efforts[{first + i}],\n" for i, hinge in enumerate(text.hinges)]
    points = [f"            at.{hinge}().output(),\n" for hinge in text.hinges]
    program = PROGRAM.format(
        name=name,
        chain=text.chain,
        mutable="let mut " if setters else "let ",
        setters="".join(setters),
        inputs="".join(inputs),
        points="".join(points),
    )
    replace(folder / f"{name}.chain", text.text)
    replace(folder / f"{name}.rs", program)


def replace(path: Path, text: str) -> None:
    """Writes a file unless it has this text, so that nothing is built again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def run(
    work: Path, model: Model, robot: Robot, states: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Builds the program and returns accelerations (by both functions), forces and moments for all states."""
    name = model.name.lower()
    files = [work / f"{name}.states", work / f"{name}.results"]
    states.tofile(files[0])
    environment = {**os.environ, "CARGO_TARGET_DIR": str(work / "target")}
    build = ["cargo", "build", "--quiet", "--bin", name]
    subprocess.run(build, cwd=work / "crate", env=environment, check=True)
    subprocess.run([work / "target/debug" / name, *files], check=True)
    rows = np.fromfile(files[1]).reshape(len(states), -1)
    rates = 2 * (len(robot.joints) + (6 if robot.floating else 0))
    wrenches = rows[:, rates:].reshape(len(states), -1, 2, 3)
    return rows[:, :rates].reshape(len(states), 2, -1), wrenches[:, :, 0], wrenches[:, :, 1]
