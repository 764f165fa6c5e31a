"""`benches/peers/check-trees`: see README.md."""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

import numpy as np
from mpmath import mpf

from ..build import say
from . import by_pinocchio, program, reference
from .robots import MODELS_BY_NAME, Model
from .urdf import Robot

SEED = 24

LARGEST = 1e-9
"""The largest difference from Pinocchio, unless this library is closer to the reference."""

QUANTITIES = ("accelerations", "forces", "moments")


def main() -> None:
    options = parse()
    options.work.mkdir(parents=True, exist_ok=True)
    print("| robot | degrees of freedom | | to Pinocchio | error | Pinocchio's error |")
    print("|---|---:|---|---:|---:|---:|")
    failed = []
    for name in options.robots:
        model = MODELS_BY_NAME[name].printed() if options.printed else MODELS_BY_NAME[name]
        try:
            lines, is_right = check(model, options)
        except subprocess.CalledProcessError as error:
            lines, is_right = [f"| {name} | | {Path(error.cmd[0]).name} fails | | | |"], False
        print("\n".join(lines), flush=True)
        if not is_right:
            failed.append(name)
    if failed:
        sys.exit(f"wrong: {', '.join(failed)}")


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="benches/peers/check-trees", description=__doc__)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument(
        "--robots", type=lambda text: text.split(","), default=list(MODELS_BY_NAME), help="such as HyQ,G1"
    )
    parser.add_argument("--states", type=int, default=200, help="compared with Pinocchio")
    parser.add_argument("--references", type=int, default=20, help="of these, compared with the reference")
    parser.add_argument(
        "--printed", action="store_true", help="print all texts, also those that were written by hand"
    )
    options = parser.parse_args()
    if unknown := set(options.robots) - set(MODELS_BY_NAME):
        parser.error(f"not known: {', '.join(unknown)}")
    return options


def check(model: Model, options: argparse.Namespace) -> tuple[list[str], bool]:
    """Returns the lines of the table for a robot, and whether it passes."""
    say(model.name)
    robot, text = model.robot(), model.text()
    program.write(options.work, model, text)
    states = random_states(robot, options.states)
    accelerations, *wrenches = program.run(options.work, model, robot, states)
    peers = by_pinocchio.solve(model, robot, states)
    # The text has right angles where the file rounds them, so each has its own reference.
    some = states[: options.references]
    own_references, peer_references = (
        exact(other, some) for other in (robot, model.robot(right_angles=False))
    )
    own = [
        worst_of_both(accelerations, peers[0]),
        *(difference(values, peer) for values, peer in zip(wrenches, peers[1:], strict=True)),
    ]
    lines, is_right = [], True
    for index, quantity in enumerate(QUANTITIES):
        count = options.references
        values = accelerations[:count, 0] if index == 0 else wrenches[index - 1][:count]
        own_error = difference(values, own_references[index])
        peer_error = difference(peers[index][:count], peer_references[index])
        is_right = is_right and (own[index] <= LARGEST or own_error <= peer_error)
        rates = len(peers[0][0])
        errors = (f"{x:.0e}" for x in (own[index], own_error, peer_error))
        lines.append(f"| {model.name} | {rates} | {quantity} | {' | '.join(errors)} |")
    return lines, is_right


def random_states(robot: Robot, count: int) -> np.ndarray:
    """Returns coordinates, rates and efforts; there is no effort in the floating base."""
    random = np.random.default_rng(SEED)
    joints, base = len(robot.joints), 6 if robot.floating else 0
    parts = []
    if base:
        quaternions = random.normal(size=(count, 4))
        quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
        parts += [random.uniform(-1, 1, (count, 3)), quaternions]
    pins = np.array([body.kind == "pin" for body in robot.bodies if body.joint])
    parts.append(random.uniform(-1, 1, (count, joints)) * np.where(pins, np.pi, 0.1))
    parts.append(random.uniform(-2, 2, (count, base + joints)))
    parts += [np.zeros((count, base)), random.uniform(-5, 5, (count, joints))]
    return np.hstack(parts)


def exact(robot: Robot, states: np.ndarray) -> list[np.ndarray]:
    """Returns accelerations, forces and moments by the reference."""
    joints, base = len(robot.joints), 6 if robot.floating else 0
    coordinates = joints + (7 if base else 0)
    results: list[list[np.ndarray]] = [[], [], []]
    for state in states:
        parts = np.split(state, [coordinates, coordinates + base + joints])
        result = reference.solve(robot, *([mpf(float(x)) for x in part] for part in parts))
        quantities = (result.accelerations, result.forces, result.moments)
        for column, values in zip(results, quantities, strict=True):
            column.append(np.array(values, dtype=float))
    return [np.array(column) for column in results]


def worst_of_both(accelerations: np.ndarray, peer: np.ndarray) -> float:
    """Compares the accelerations of `accelerations` and of `solve_into`."""
    return max(difference(accelerations[:, index], peer) for index in range(2))


def difference(values: np.ndarray, others: np.ndarray) -> float:
    """Returns the largest difference relative to the largest value in the same state."""
    across = tuple(range(1, values.ndim))
    differences = np.abs(values - others).max(axis=across) / np.abs(others).max(axis=across)
    return float(np.where(np.isnan(differences), np.inf, differences).max())


if __name__ == "__main__":
    main()
