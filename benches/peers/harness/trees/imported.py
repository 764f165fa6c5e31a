"""A URDF file as the text of a chain, by `cargo mstmm import`."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from ..paths import ROOT

STEP = re.compile(r"\b(pin|slider|planar|floating)(?:\([^()]*\))? (\w+)\s*->")
"""A step of a route: a hinge."""

PASSIVE = re.compile(r"\b(?:damping|friction|friction_speed|limits|limit_stiffness|start) = [^;]*;\s*")


@dataclass(frozen=True)
class Text:
    text: str
    chain: str
    """The name of the chain."""
    hinges: list[str]
    """The names of the hinges in Rust, in the order of the coordinates."""


@dataclass(frozen=True)
class Hinge:
    name: str
    """The method in Rust."""
    joint: str


@dataclass(frozen=True)
class Names:
    chain: str
    base: str
    """The first body, if it floats."""
    hinges: list[Hinge]
    """In any order."""


def run(file: Path, floating: bool, snap: str) -> Text:
    """Imports a file without dampers, friction and limits. The coordinates are those of the file, depth first."""
    command = ["cargo", "run", "--quiet", "--package", "cargo-mstmm", "--", "mstmm", "import", str(file)]
    options = ["--snap", snap, *(["--floating"] if floating else [])]
    result = subprocess.run([*command, *options], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    text = PASSIVE.sub("", result.stdout)
    names = read(text)
    return Text(text, names.chain, [hinge.name for hinge in names.hinges])


def read(text: str) -> Names:
    """Reads names from routes and comments."""
    comment = " ".join(line.removeprefix("//").strip() for line in text.splitlines() if line.startswith("//"))
    joints = dict(re.findall(r"([\w.]+) is the joint (.+?)[,.](?: |$)", comment))
    chain = re.search(r"pub chain (\w+)", text)
    parts = dict(re.findall(r"^ {8}part (\w+)[^{]*\{\n(.*?)^ {8}\}$", text, re.M | re.S))
    routes = re.sub(r"^ {8}(?:part|body|///).*?^ {8}\}$\n", "", text, flags=re.M | re.S)
    paths = []
    # In the order of the text: hinges, and hinges of parts where they are set.
    instance = re.compile(rf"-> ({'|'.join(parts)})(?:\([^()]*\))? (\w+);") if parts else re.compile(r"(?!)()()")
    found = [*STEP.finditer(routes), *instance.finditer(routes)]
    for match in sorted(found, key=lambda match: match.start()):
        if match.re is STEP:
            paths.append(match[2])
        else:
            paths += [f"{match[2]}.{hinge}" for _, hinge in STEP.findall(parts[match[1]])]
    hinges = [Hinge(path.replace(".", "_"), joints.get(path, path.replace(".", "_"))) for path in paths]
    assert chain is not None
    return Names(chain[1], base(routes), hinges)


def base(routes: str) -> str:
    """Returns the first body, if no hinge holds it."""
    lines = (line.strip() for line in routes.splitlines())
    starts = (re.match(r"(?:[A-Z]\w* (\w+)(?:;| ->|$)|ground\b)", line) for line in lines)
    start = next(match for match in starts if match)
    return start[1] or ""
