"""`benches/peers/run`: see README.md."""

import argparse
import os
import subprocess
import sys
from functools import partial
from pathlib import Path

import numpy as np

from . import reference, report
from .answers import run as answers
from .answers.questions import ANSWER_CASES, QUESTIONS
from .build import Builder, Contender, say
from .cases import CASES, Case
from .measure import compare, measure

STEP = 1e-3
"""The step of the integrators in s, the same as in the contenders."""

OWN_ERROR = 1e-9
"""The largest error of this library's code; with a larger error, the run fails."""

OWN_ERROR_SINGLE = 1e-2
"""The largest error in single precision, over all states."""

LONGER = {"B3", "D7"}
"""The cases in which not only accelerations are timed."""


def main() -> None:
    options = parse()
    if "answers" in options.what:
        answers.main(options)
        return
    builder = Builder(options.work, options.clang)
    native, any_processor = builder.own(native=True), builder.own(native=False)
    tables = []
    for name in options.cases:
        case = CASES[name]
        for what in options.what:
            if what != "accelerations" and name not in LONGER and not options.all:
                continue
            if what == "rk4" and case.floating:
                continue
            own = own_contenders(native, any_processor, case, what)
            peers = [*builder.casadi(case, what), builder.pinocchio(case, what)]
            if not case.floating:
                peers.append(builder.mujoco(case, what))
            states, expected = expectation(native, case, what, options.work)
            say(f"timing {name}, {what}")
            judge = partial(compare, reference=expected)
            rows = measure(
                [*own, *peers], states, judge, options.rounds, options.milliseconds, options.core
            )
            tables.append(report.Table(name, what, case.states, rows))
    print(report.write(options.work, options.clang, tables))
    broken = [
        f"{table.case}, {table.what}: {row.contender.name} {row.failure or f'is off by {row.error:.0e}'}"
        for table in tables
        for row in table.rows
        if row.contender.own and not row.error < (OWN_ERROR_SINGLE if row.contender.single else OWN_ERROR)
    ]
    if broken:
        sys.exit("\n".join(broken))


def parse() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="benches/peers/run", description=__doc__)
    parser.add_argument("--work", type=Path, required=True, help=argparse.SUPPRESS)
    parser.add_argument("--clang", required=True, help=argparse.SUPPRESS)
    parser.add_argument("--cases", type=lambda text: text.split(","), help="such as A10,D7")
    parser.add_argument(
        "--what",
        type=lambda text: text.split(","),
        default=list(report.TITLES),
        help="of accelerations,all,rk4; or only answers",
    )
    parser.add_argument(
        "--questions", type=lambda text: text.split(","), default=[], help="of the answers, such as linearize"
    )
    parser.add_argument(
        "--all", action="store_true", help="all and rk4 for all cases, not only for B3 and D7"
    )
    parser.add_argument("--quick", action="store_true", help="fewer and shorter rounds")
    parser.add_argument("--rounds", type=int)
    parser.add_argument("--milliseconds", type=int, help="time of a contender in a round")
    parser.add_argument("--core", type=int, default=max(os.sched_getaffinity(0)), help="to run on")
    options = parser.parse_args()
    options.rounds = options.rounds or (5 if options.quick else 15)
    options.milliseconds = options.milliseconds or (20 if options.quick else 50)
    if "answers" in options.what and len(options.what) > 1:
        parser.error("answers are timed in a separate run")
    is_answers = options.what == ["answers"]
    cases = ANSWER_CASES if is_answers else CASES
    options.cases = options.cases or list(cases)
    known = {*cases, "answers", *report.TITLES, *(question.name for question in QUESTIONS)}
    if unknown := {*options.cases, *options.what, *options.questions} - known:
        parser.error(f"not known: {', '.join(unknown)}")
    return options


def own_contenders(native: Path, any_processor: Path, case: Case, what: str) -> list[Contender]:
    """Returns the contenders; the others are compared with the first one."""
    contenders = [
        Contender("mstmm, native", (str(native), what, case.name), own=True),
        Contender("mstmm, any processor", (str(any_processor), what, case.name), own=True),
    ]
    if what == "all" and not case.floating:
        contenders.append(Contender("mstmm, native, z alone", (str(native), "z", case.name), own=True))
    # The usage text of a contender lists what it computes.
    usage = subprocess.run([native], capture_output=True, text=True).stderr
    if what == "accelerations" and "lanes" in usage and case.name != "G1":
        double, single = ((str(native), mode, case.name) for mode in ("lanes", "lanes32"))
        contenders.append(Contender("mstmm, lanes", double, own=True, wide=True))
        if not case.floating:
            contenders.append(Contender("mstmm, lanes of f32", single, own=True, wide=True, single=True))
    return contenders


def expectation(own: Path, case: Case, what: str, work: Path) -> tuple[Path, np.ndarray]:
    """Returns the states, and the expected results of each."""
    path = work / f"{case.name}.states"
    subprocess.run([own, "states", case.name, str(case.states), path], check=True)
    states = np.fromfile(path).reshape(case.states, case.coordinates + 2 * case.rates)
    q, v, torques = reference.parts(case, states)
    accelerations = reference.of(case, q, v, torques)
    reference.check(case, q, v, accelerations, torques)
    if what == "rk4":
        return path, reference.after_step(case, q, v, torques, STEP).T
    return path, accelerations.T


if __name__ == "__main__":
    main()
