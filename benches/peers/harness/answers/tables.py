"""Tables and JSON of the answers."""

import json
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..measure import Measured
from ..report import digits, machine
from .goals import BY_COMPONENTS, Figures, goals_of
from .questions import QUESTIONS, Question

LESS_ACCURATE = 1e-9
"""A larger difference makes a variant less accurate than another one."""

PEERS = ["Pinocchio", "CasADi", BY_COMPONENTS, "CasADi −M⁻¹∂ID", "MuJoCo", "dynibo"]


@dataclass(frozen=True)
class Answered:
    case: str
    question: Question
    rows: list[Measured]

    def best(self, name: str) -> Measured | None:
        """Returns the fastest variant of a contender, without variants that are less accurate."""
        rows = [
            row
            for row in self.rows
            if row.rounds and row.contender.name.removesuffix(", fast math") == name
        ]
        least = min((row.error for row in rows), default=0.0)
        accurate = [row for row in rows if row.error <= max(LESS_ACCURATE, 10 * least)]
        return min(accurate, key=lambda row: row.fastest, default=None)


def write(work: Path, clang: str, measured: list[Answered]) -> str:
    """Writes `answers.md` and `answers.json`, and returns the text."""
    about = machine(clang)
    cases = list(dict.fromkeys(each.case for each in measured))
    lines = [", ".join(about) + ".", ""]
    for case in cases:
        lines += table(case, [each for each in measured if each.case == case])
    lines += goals(cases, measured)
    text = "\n".join(lines)
    (work / "answers.md").write_text(text)
    document = {"machine": about, "load": os.getloadavg(), "answers": [json_of(each) for each in measured]}
    (work / "answers.json").write_text(json.dumps(document, indent=1))
    return text


def table(case: str, answered: list[Answered]) -> list[str]:
    """Returns the table of times, then that of differences."""
    peers = [name for name in PEERS if any(each.best(name) for each in answered)]
    unit, unit_of_lanes = (forward_dynamics(answered, name) for name in ("mstmm", "mstmm, lanes"))
    head = f"| {case} | ns | FD | {' | '.join(peers)} |"
    lines = [f"## {case}", "", head, f"|---|{'---:|' * (2 + len(peers))}"]
    for each in answered:
        others = [each.best(name) for name in peers]
        if own := each.best("mstmm"):
            cells = [each.question.title, digits(own.fastest), f"{own.fastest / unit:.2f}"]
            for row in others:
                cells.append(f"{digits(row.fastest)} ({factor(row.fastest / own.fastest)})" if row else "")
            lines.append(f"| {' | '.join(cells)} |")
        if lanes := each.best("mstmm, lanes"):
            cells = [f"({factor(row.fastest / lanes.fastest)})" if row else "" for row in others]
            title = f"{each.question.title}, `f64x8`, per state"
            cells = [title, digits(lanes.fastest), f"{lanes.fastest / unit_of_lanes:.2f}", *cells]
            lines.append(f"| {' | '.join(cells)} |")
    lines += ["", f"| {case}, differences | {' | '.join(peers)} |", f"|---|{'---:|' * len(peers)}"]
    for each in answered:
        others = [each.best(name) for name in peers]
        cells = [f"{row.error:.0e} ({row.typical_error:.0e})" if row else "" for row in others]
        lines.append(f"| {' | '.join([each.question.title, *cells])} |")
    return [*lines, ""]


def factor(ratio: float) -> str:
    return f"{ratio:.1f}" if ratio >= 10 else f"{ratio:.2f}"


def forward_dynamics(answered: list[Answered], name: str) -> float:
    rows = [each.best(name) for each in answered if each.question == QUESTIONS[0]]
    return rows[0].fastest if rows and rows[0] else float("nan")


def goals(cases: list[str], measured: list[Answered]) -> list[str]:
    """Returns the table of goals with the figures of this run."""
    times = {
        (each.case, each.question.name, name): row.fastest
        for each in measured
        for name in ["mstmm", "mstmm, lanes", *PEERS]
        if (row := each.best(name))
    }
    lines = ["## Goals", "", "| | goal | reached | |", "|---|---|---:|---|"]
    for goal in goals_of(cases):
        reached = goal.figure(Figures(times))
        if reached is None:
            continue
        sign = "≤" if goal.at_most else "≥"
        verdict = "met" if goal.is_met(reached) else "missed"
        lines.append(f"| {goal.name} | {goal.title} {sign} {goal.limit:g} | {reached:.2f} | {verdict} |")
    return [*lines, ""]


def json_of(each: Answered) -> dict[str, Any]:
    rows = [
        {
            "name": row.contender.name,
            "fastest": row.fastest if row.rounds else None,
            "nanoseconds": row.nanoseconds if row.rounds else None,
            "difference": row.error if row.rounds else None,
            "typical_difference": row.typical_error if row.rounds else None,
            "failure": row.failure or None,
            "rounds": row.rounds,
        }
        for row in each.rows
    ]
    return {"case": each.case, "question": each.question.name, "contenders": rows}
