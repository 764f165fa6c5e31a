"""`benches/peers/run --what answers`: times the answers of this library and of other tools."""

import argparse
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np

from ..build import Contender, say
from ..cases import Case
from ..measure import Measured, measure
from ..reference import Array
from . import conventions, tables
from .build import AnswersBuilder
from .order import DepthFirst
from .questions import ANSWER_CASES, QUESTIONS, States, count_of_states, shapes, states_from

STEP = 1e-3
"""The step of MuJoCo's models in s."""

LARGEST_DIFFERENCE = 1e-9
"""The run fails if no other tool gives the results of this library within this relative difference."""

LARGEST_DIFFERENCE_OF_FINITE = 1e-4
"""The same for finite differences."""

FINITE = {"derivatives", "linearize"}
"""The questions for which MuJoCo takes finite differences."""

LANES = {"accelerations", "linearize"}
"""The questions that are also timed with eight states at a time."""


def main(options: argparse.Namespace) -> None:
    builder = AnswersBuilder(options.work, options.clang)
    own = builder.own(native=True)
    measured = []
    for name in options.cases:
        case = ANSWER_CASES[name]
        path, states = states_of(own, case, builder)
        for question in QUESTIONS:
            if options.questions and question.name not in options.questions:
                continue
            contenders = [Contender("mstmm", (str(own), question.name, name), own=True)]
            if question.name in LANES and name in ("D7", "B3"):
                command = (str(own), f"{question.name}_lanes", name)
                contenders.append(Contender("mstmm, lanes", command, own=True, wide=True))
            contenders += builder.peers(case, question.name)
            say(f"timing {name}, {question.title}")
            judge = judge_of(case, question.name, states)
            rows = measure(contenders, path, judge, options.rounds, options.milliseconds, options.core)
            measured.append(tables.Answered(name, question, rows))
    print(tables.write(options.work, options.clang, measured))
    broken = [f"{each.case}, {each.question.title}" for each in measured if is_wrong(each)]
    if broken:
        sys.exit("no other tool confirms the results: " + "; ".join(broken))


def is_wrong(answered: tables.Answered) -> bool:
    def confirms(row: Measured) -> bool:
        is_finite = row.contender.name == "MuJoCo" and answered.question.name in FINITE
        return row.error < (LARGEST_DIFFERENCE_OF_FINITE if is_finite else LARGEST_DIFFERENCE)

    peers = [row for row in answered.rows if not row.contender.own and not row.failure]
    return bool(peers) and not any(map(confirms, peers))


def states_of(own: Path, case: Case, builder: AnswersBuilder) -> tuple[Path, States]:
    """Writes the states, also in the order of Pinocchio and MuJoCo."""
    basic, path = builder.work / f"{case.name}.basic.states", builder.work / f"{case.name}.answers.states"
    subprocess.run([own, "states", case.name, str(count_of_states(case)), basic], check=True)
    states = states_from(case, basic)
    states.write(path)
    DepthFirst.of(case).states(states).write(builder.depth_first_states(case))
    return path, states


def judge_of(case: Case, question: str, states: States) -> Callable[[Measured, Array], None]:
    """Returns the comparison of results with the first contender's, which are those of this library."""
    first: list[Array] = []
    depth_first = DepthFirst.of(case)
    pinocchio = conventions.Pinocchio(depth_first.case, depth_first.states(states))
    sizes = [int(np.prod([count for _, count in shape])) for shape in shapes(case, question)]

    def judge(measured: Measured, results: Array) -> None:
        rows = results.reshape(len(states.q), -1)
        name = measured.contender.name
        if name == "Pinocchio":
            rows = depth_first.restore(question, pinocchio.convert(question, rows))
        elif name == "MuJoCo":
            rows = depth_first.restore(question, conventions.mujoco(case, question, rows, STEP))
        elif name == "dynibo":
            rows = conventions.dynibo(case, question, states, rows)
        if not first:
            first.append(rows)
        errors = differences(rows, first[0], sizes)
        measured.error, measured.typical_error = float(errors.max()), float(np.median(errors))

    return judge


def differences(rows: Array, expected: Array, sizes: list[int]) -> Array:
    """Returns the largest difference of each state, relative to the largest entry of the same matrix.

    Only the matrices that both have are compared.
    """
    result = np.zeros(len(rows))
    start = 0
    for size in sizes:
        block = slice(start, start := start + size)
        if start > rows.shape[1]:
            break
        difference = np.abs(rows[:, block] - expected[:, block]).max(axis=1)
        result = np.maximum(result, difference / np.abs(expected[:, block]).max(axis=1))
    # NaN is an infinite difference.
    return np.where(np.isnan(result), np.inf, result)
