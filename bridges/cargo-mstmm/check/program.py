"""A crate with all texts, which evaluates their generated code."""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import numpy as np

from harness.trees.imported import Names

ROOT = Path(__file__).resolve().parents[3]

MANIFEST = f"""[package]
name = "imported"
version = "0.1.0"
edition = "2024"

[dependencies]
mstmm = {{ path = "{ROOT}" }}

[profile.dev]
debug = false
incremental = false

[workspace]
"""

MAIN = """//! Evaluates the chain with a name for all states of a file.

#[allow(dead_code)]
mod chains;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [name, states, results] = arguments.as_slice() else { return Err("NAME STATES RESULTS".into()) };
    let bytes = std::fs::read(states)?;
    let numbers: Vec<f64> = bytes.as_chunks().0.iter().map(|&eight| f64::from_le_bytes(eight)).collect();
    let mut found: Vec<f64> = Vec::new();
    chains::solve(name, &numbers, &mut found)?;
    let bytes: Vec<u8> = found.into_iter().flat_map(f64::to_le_bytes).collect();
    Ok(std::fs::write(results, bytes)?)
}
"""

# A state has coordinates, rates and efforts of the base and then of the joints, in the order of the names. The results
# are accelerations, the mass matrix, and force and moment on the outboard body of each hinge, in the same order.
MODULE = """use mstmm::prelude::*;

include!("{module}.chain");

pub fn solve(numbers: &[f64], found: &mut Vec<f64>) -> Result<(), Box<dyn std::error::Error>> {{
    let chain = {chain}::<f64>::new();
    let mut at = chain.workspace();
    let mut order: Vec<usize> = Vec::new();
{order}    let count = order.len();
    for numbers in numbers.chunks_exact({length}) {{
        let (q, rest) = numbers.split_at({coordinates});
        let (v, efforts) = rest.split_at(count);
        let mut state = chain.initial_state();
{state}        let inputs = {inputs};
        let accelerations = chain.accelerations(&state, &inputs)?;
        found.extend(order.iter().map(|&row| accelerations[row]));
        // Chains with many rates have no `mass_matrix` that returns by value.
        let mut matrix = mstmm::nalgebra::SMatrix::<f64, {rates}, {rates}>::zeros();
        chain.mass_matrix_into(&state, &inputs, &mut matrix)?;
        found.extend(order.iter().flat_map(|&row| order.iter().map(move |&column| (row, column))).map(|at| matrix[at]));
        chain.solve_into(&state, &inputs, &mut at)?;
        let _ = (&q, &efforts);
{points}    }}
    Ok(())
}}
"""


def write(work: Path, texts: dict[str, tuple[str, Names]]) -> None:
    """Writes the crate; each text has the name of its module."""
    folder = work / "crate/src/chains"
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        if old.stem not in texts:
            old.unlink()
    (work / "crate/Cargo.toml").write_text(MANIFEST)
    replace(work / "crate/src/main.rs", MAIN)
    arms = [f'        "{module}" => {module}::solve(numbers, found),\n' for module in texts]
    chains = "".join(f"mod {module};\n" for module in texts) + (
        "\npub fn solve(name: &str, numbers: &[f64], found: &mut Vec<f64>) "
        "-> Result<(), Box<dyn std::error::Error>> {\n    match name {\n"
        + "".join(arms)
        + '        _ => Err("no such chain".into()),\n    }\n}\n'
    )
    replace(work / "crate/src/chains.rs", chains)
    for module, (text, names) in texts.items():
        asked = text.replace("        gravity =", "        answers = mass_matrix;\n        gravity =", 1)
        replace(folder / f"{module}.chain", asked)
        replace(folder / f"{module}.rs", rust(module, text, names))


def rust(module: str, text: str, names: Names) -> str:
    order, state, points = [], [], []
    base = 6 if names.base else 0
    if names.base:
        order.append("    order.extend(0..6);\n")
        state.append("        state.q.as_mut_slice()[..7].copy_from_slice(&q[..7]);\n")
        state.append("        state.v.as_mut_slice()[..6].copy_from_slice(&v[..6]);\n")
    for index, hinge in enumerate(names.hinges):
        word = coordinate(text, hinge.name)
        rate = {"angle": "rate", "position": "velocity"}[word]
        order.append(
            f"    order.push({{ let mut state = chain.initial_state(); state.{hinge.name}_mut().set_{rate}(1.0); "
            'state.v.iter().position(|&rate| rate == 1.0).ok_or("no rate")? });\n'
        )
        first_q, first_v = index + (7 if base else 0), index + base
        state.append(
            f"        state.{hinge.name}_mut().set_{word}(q[{first_q}]).set_{rate}(v[{first_v}]);\n"
        )
        points.append(
            f"        let point = at.{hinge.name}().output();\n"
            "        found.extend([point.force(), -point.moment()].iter().flat_map(|w| [w.x, w.y, w.z]));\n"
        )
    fields = [f"{hinge.name}: efforts[{index + base}]" for index, hinge in enumerate(names.hinges)]
    inputs = f"{names.chain}Inputs {{ {', '.join(fields)} }}" if fields else "chain.no_inputs()"
    count = len(names.hinges)
    coordinates, rates = count + (7 if base else 0), count + base
    return MODULE.format(
        module=module,
        chain=names.chain,
        order="".join(order),
        length=coordinates + 2 * rates,
        coordinates=coordinates,
        rates=rates,
        state="".join(state),
        inputs=inputs,
        points="".join(points),
    )


def coordinate(text: str, hinge: str) -> str:
    """Returns the coordinate of a hinge; in a part it has its inner name there."""
    for kind, name in re.findall(r"\b(pin|slider)(?:\([^()]*\))? (\w+)\s*->", text):
        if hinge == name or hinge.endswith(f"_{name}"):
            return "angle" if kind == "pin" else "position"
    raise ValueError(f"{hinge} is no pin or slider")


def replace(path: Path, text: str) -> None:
    """Writes a file unless it has this text, so that nothing is built again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def build(work: Path) -> None:
    environment = {**os.environ, "CARGO_TARGET_DIR": str(work / "target")}
    subprocess.run(["cargo", "build", "--quiet"], cwd=work / "crate", env=environment, check=True)


def run(work: Path, module: str, states: np.ndarray) -> np.ndarray:
    """Returns a row of results for each state."""
    files = [work / f"{module}.states", work / f"{module}.results"]
    states.tofile(files[0])
    subprocess.run([work / "target/debug/imported", module, *files], check=True)
    return np.fromfile(files[1]).reshape(len(states), -1)
