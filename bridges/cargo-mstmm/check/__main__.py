"""`bridges/check-import`: see the readme of cargo-mstmm."""

from __future__ import annotations

import argparse
import re
import subprocess
import sys
import textwrap
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pinocchio
from harness.trees import imported as names
from harness.trees import reference, urdf
from mpmath import mpf

from . import program
from .by_pinocchio import Peer

SEED = 26

LARGEST = 1e-9
"""The largest difference from Pinocchio, unless the written chain is closer to the reference."""

FLOATING = (
    "a1 alexander alex anymal b1 bolt borinot centauro g1 go1 go2 hector hextilt hyq icub iris laikago quadruped "
    "romeo simple_humanoid solo talos_data/robots/talos_full talos_data/robots/talos_reduced tiago/robots"
).split()
"""The beginnings of the files of robots that no fixed base holds."""

Results = dict[str, np.ndarray]

EXPORTED = "accelerations of the exported file"

QUICK = ("hyq_no_sensors", "panda", "kinova")
README = Path(__file__).resolve().parents[1] / "README.md"


@dataclass
class Outcome:
    file: str
    reason: str = ""
    """Why the file is refused, or cannot be compared."""
    parts: int = 0
    same_again: bool = True
    """Whether the import of the exported chain is the same text."""
    rates: int = 0
    differences: dict[str, float] = field(default_factory=dict)
    errors: dict[str, tuple[float, float]] = field(default_factory=dict)
    """The errors of the chain and of Pinocchio, of quantities that differ by more."""

    @property
    def is_wrong(self) -> bool:
        exported = self.differences.get(EXPORTED, 0.0)
        return exported > LARGEST or any(not own <= peer for own, peer in self.errors.values())

    @property
    def worst(self) -> float:
        return max(self.differences.values(), default=0.0)


def main() -> None:
    options = parse()
    folder = Path(pinocchio.__file__).resolve()
    folder = next(path for path in folder.parents if path.name == "cmeel.prefix")
    folder = folder / "share/example-robot-data/robots"
    files = sorted(folder.rglob("*.urdf"))
    if options.quick:
        files = [path for path in files if path.stem in QUICK]
    outcomes: dict[str, Outcome] = {}
    texts, paths = {}, {}
    for path in files:
        module = "r_" + re.sub(r"\W", "_", str(path.relative_to(folder).with_suffix(""))).lower()
        outcome = outcomes[module] = Outcome(str(path.relative_to(folder)))
        text = written(path, outcome, options)
        if text:
            (options.work / f"{module}.chain").write_text(text)
            texts[module], paths[module] = (text, names.read(text)), path
            outcome.parts = len(re.findall(r"^ {8}part ", text, re.M))
    program.write(options.work, texts)
    program.build(options.work)
    for module, (_, found) in texts.items():
        compare(outcomes[module], paths[module], module, found, options)
    text = table(list(outcomes.values()))
    print(text)
    if options.write:
        write_table(text)
    wrong = [outcome.file for outcome in outcomes.values() if outcome.is_wrong]
    if wrong or not texts:
        sys.exit(f"wrong: {', '.join(wrong) or 'no file was written'}")


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="bridges/check-import", description=__doc__)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--command", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--quick", action="store_true", help="only three robots")
    parser.add_argument("--states", type=int, default=10)
    parser.add_argument("--write", action="store_true", help="write the table of outcomes into the readme")
    return parser.parse_args()


def is_floating(file: str) -> bool:
    return file.startswith(tuple(FLOATING))


def written(path: Path, outcome: Outcome, options: argparse.Namespace) -> str:
    """Returns the text that the command writes, or notes why it writes none."""
    floating = ["--floating"] if is_floating(outcome.file) else []
    command = [options.command, "mstmm", "import", str(path), *floating]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode not in (0, 1):
        raise RuntimeError(f"{path}: {result.stderr}")
    if result.returncode == 1:
        last = result.stderr.strip().splitlines()[-1]
        outcome.reason = last.removeprefix(f"error: {path}:").strip()
    return result.stdout


def compare(outcome: Outcome, path: Path, module: str, found: names.Names, options: argparse.Namespace) -> None:
    """Notes the largest differences."""
    peer = Peer(path, found)
    random = np.random.default_rng(SEED)
    states = peer.states(random, options.states)
    rows = program.run(options.work, module, states)
    joints = len(found.hinges)
    rates = outcome.rates = joints + (6 if found.base else 0)
    own, others = [], []
    for state, row in zip(states, rows, strict=True):
        accelerations, matrix, wrenches = np.split(row, [rates, rates + rates * rates])
        wrenches = wrenches.reshape(joints, 2, 3)
        matrix = matrix.reshape(rates, rates)
        values = (accelerations, matrix, wrenches[:, 0], wrenches[:, 1])
        own.append(dict(zip(("accelerations", "mass matrix", "forces", "moments"), values, strict=True)))
        others.append(peer.solve(state))
    for quantity in own[0]:
        pairs = zip(own, others, strict=True)
        worst = max(difference(one[quantity], other[quantity]) for one, other in pairs)
        outcome.differences[quantity] = worst
    exported = by_export(outcome, module, found, options)
    for state, one in zip(states, others, strict=True):
        worst = difference(exported.solve(state)["accelerations"], one["accelerations"])
        outcome.differences[EXPORTED] = max(worst, outcome.differences.get(EXPORTED, 0.0))
    if outcome.worst > LARGEST:
        judge(outcome, path, peer, found, states, own, others)


def by_export(outcome: Outcome, module: str, found: names.Names, options: argparse.Namespace) -> Peer:
    """Exports the chain, imports it again, and returns Pinocchio's model of the exported file."""
    text, file = (options.work / f"{module}.{ending}" for ending in ("chain", "urdf"))
    run = [options.command, "mstmm"]
    subprocess.run([*run, "export", "--urdf", str(text), "-o", str(file)], check=True)
    floating = ["--floating"] if found.base else []
    again = subprocess.run([*run, "import", str(file), *floating], check=True, capture_output=True, text=True)
    outcome.same_again = without_comments(again.stdout) == without_comments(text.read_text())
    hinges = [names.Hinge(hinge.name, hinge.name) for hinge in found.hinges]
    return Peer(file, names.Names(found.chain, found.base, hinges))


def without_comments(text: str) -> list[str]:
    lines = (re.sub(r"//(?!/).*", "", line).strip() for line in text.splitlines())
    return [line for line in lines if line]


def judge(
    outcome: Outcome,
    path: Path,
    peer: Peer,
    found: names.Names,
    states: np.ndarray,
    own: list[Results],
    others: list[Results],
) -> None:
    """Compares with the reference of fifty digits. The chain has exact right angles where the file rounds them."""
    references = []
    for tolerance in ("1e-12", "0"):
        urdf.RIGHT_ANGLE = mpf(tolerance)
        robot = urdf.read(path, bool(found.base))
        robot = robot.in_order([hinge.joint for hinge in found.hinges])
        references.append([exact(robot, peer, state) for state in states])
    for quantity, worst in outcome.differences.items():
        if worst > LARGEST and quantity not in ("mass matrix", EXPORTED):
            sides = zip((own, others), references, strict=True)
            own_error, peer_error = (
                max(difference(a[quantity], b[quantity]) for a, b in zip(side, right, strict=True))
                for side, right in sides
            )
            outcome.errors[quantity] = own_error, peer_error
        elif worst > LARGEST:
            outcome.errors[quantity] = worst, 0.0


def exact(robot: urdf.Robot, peer: Peer, state: np.ndarray) -> dict[str, np.ndarray]:
    count = len(peer.ids) + (6 if peer.base else 0)
    q, v, efforts = np.split(state, [len(state) - 2 * count, len(state) - count])
    efforts = peer.efforts(v, efforts)
    result = reference.solve(robot, *([mpf(float(x)) for x in part] for part in (q, v, efforts)))
    values = {
        "accelerations": result.accelerations,
        "forces": result.forces,
        "moments": result.moments,
    }
    return {quantity: np.array(value, dtype=float) for quantity, value in values.items()}


def difference(values: np.ndarray, others: np.ndarray) -> float:
    """Returns the largest difference relative to the largest value."""
    if values.size == 0:
        return 0.0
    largest = np.abs(others).max()
    worst = float(np.abs(values - others).max())
    return worst if largest == 0 else worst / float(largest)


def table(outcomes: list[Outcome]) -> str:
    """Returns the outcomes as text."""
    compared = [outcome for outcome in outcomes if not outcome.reason]
    refused = [outcome for outcome in outcomes if outcome.reason]
    close = [outcome for outcome in compared if outcome.worst <= LARGEST]
    worst = max(close, key=lambda outcome: outcome.worst, default=None)
    parts = sum(outcome.parts > 0 for outcome in compared)
    lines = [
        f"Of {len(outcomes)} files, {len(compared)} are written, {parts} of them with parts, and {len(refused)} are "
        f"refused. {len(close)} agree with Pinocchio to 1e-9.",
    ]
    again = sum(outcome.same_again for outcome in compared)
    if worst:
        lines[0] += f" Their largest difference is {worst.worst:.0e} (`{worst.file}`)."
    lines[0] += f" For {again} of them, the import of the exported chain is the same text."
    lines = wrapped(lines[0])
    lines += ["", "| quantity | median of the largest differences | largest, to 1e-9 |", "|---|---:|---:|"]
    for quantity in compared[0].differences if compared else ():
        values = [outcome.differences[quantity] for outcome in compared]
        below = [value for value in values if value <= LARGEST]
        lines.append(f"| {quantity} | {np.median(values):.0e} | {max(below):.0e} |")
    if far := [outcome for outcome in compared if outcome.worst > LARGEST]:
        lines += ["", "| file | quantity | difference | error here | error of Pinocchio |", "|---|---|---:|---:|---:|"]
        for outcome in far:
            for quantity, (own, peer) in outcome.errors.items():
                numbers = f"{outcome.differences[quantity]:.0e} | {own:.0e} | {peer:.0e}"
                lines.append(f"| `{outcome.file}` | {quantity} | {numbers} |")
    if refused:
        lines += ["", "| refused file | reason |", "|---|---|"]
        lines += [f"| `{outcome.file}` | {outcome.reason.split(';')[0].replace('|', ' ')} |" for outcome in refused]
    return "\n".join(lines)


def wrapped(text: str) -> list[str]:
    return textwrap.wrap(text, 120, break_on_hyphens=False)


def write_table(text: str) -> None:
    begin, end = "<!-- outcomes -->", "<!-- end of outcomes -->"
    readme = README.read_text()
    before, rest = readme.split(begin)
    after = rest.split(end)[1]
    README.write_text(f"{before}{begin}\n\n{text}\n\n{end}{after}")


if __name__ == "__main__":
    main()
