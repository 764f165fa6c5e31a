"""Tables and JSON of the measurements."""

import json
import math
import os
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from .measure import Measured

WRONG = 1e-6
"""Accelerations with a larger error are called wrong."""

TITLES = {
    "accelerations": "accelerations",
    "all": "accelerations and reactions",
    "rk4": "a step of the classical Runge–Kutta method",
}


@dataclass(frozen=True)
class Table:
    case: str
    what: str
    states: int
    rows: list[Measured]

    @property
    def own(self) -> Measured:
        return self.rows[0]

    def lines(self) -> list[str]:
        lines = [
            f"## {self.case}: {TITLES[self.what]}, {self.states} states",
            "",
            f"| | ns | `{self.own.contender.name}` / it | largest error | typical |",
            "|---|---:|---:|---:|---:|",
        ]
        for row in sorted(self.rows, key=lambda row: (bool(row.failure), row.nanoseconds)):
            name = f"`{row.contender.name}`" if row.contender.own else row.contender.name
            if row.failure:
                lines.append(f"| {name} | – | – | – | {row.failure} |")
                continue
            wrong = " **wrong**" if row.error > WRONG and not row.contender.single else ""
            cells = [
                name,
                digits(row.nanoseconds),
                f"{self.own.ratio(row):.2f}",
                f"{row.error:.0e}{wrong}",
                f"{row.typical_error:.0e}",
            ]
            lines.append(f"| {' | '.join(cells)} |")
        return [*lines, ""]

    def summary(self, wide: bool) -> str | None:
        """Compares the fastest code of this library with the fastest correct alternative, for one state at
        a time or for several.
        """
        rows = [row for row in self.rows if row.contender.wide == wide and row.error <= WRONG]
        own = [row for row in rows if row.contender.own and not row.contender.single]
        others = [row for row in rows if not row.contender.own]
        if not own or not others:
            return None
        best, alternative = (min(rows, key=lambda row: row.nanoseconds) for rows in (own, others))
        cells = [
            f"{self.case}, {TITLES[self.what]}",
            f"`{best.contender.name}`",
            digits(best.nanoseconds),
            alternative.contender.name,
            digits(alternative.nanoseconds),
            f"{best.ratio(alternative):.2f}",
        ]
        return f"| {' | '.join(cells)} |"

    def json(self) -> dict[str, Any]:
        def number(value: float) -> float | None:
            return value if math.isfinite(value) else None

        rows = [
            {
                "name": row.contender.name,
                "own": row.contender.own,
                "nanoseconds": number(row.nanoseconds),
                "fastest": number(row.fastest),
                "own_ratio": number(self.own.ratio(row)),
                "error": number(row.error),
                "typical_error": number(row.typical_error),
                "failure": row.failure or None,
                "rounds": row.rounds,
            }
            for row in self.rows
        ]
        return {"case": self.case, "what": self.what, "states": self.states, "contenders": rows}


def digits(nanoseconds: float) -> str:
    """Returns a time with three digits."""
    return f"{nanoseconds:.1f}" if nanoseconds < 100 else f"{float(f'{nanoseconds:.3g}'):.0f}"


def machine(clang: str) -> list[str]:
    """Returns the machine and the versions of all tools."""
    lines = Path("/proc/cpuinfo").read_text().splitlines()
    models = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    compilers = [first_line("rustc", "--version"), first_line(clang, "--version")]
    packages = (Path(__file__).parents[1] / "requirements.txt").read_text().split()
    return [*models[:1], *compilers, *packages]


def first_line(*command: str) -> str:
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]


def write(work: Path, clang: str, tables: list[Table]) -> str:
    about = machine(clang)
    summaries = [table.summary(wide) for wide in (False, True) for table in tables]
    lines = [
        ", ".join(about) + ".",
        "",
        "| | | ns | fastest alternative | ns | ratio |",
        "|---|---|---:|---|---:|---:|",
        *(line for line in summaries if line),
        "",
        *(line for table in tables for line in table.lines()),
    ]
    text = "\n".join(lines)
    (work / "report.md").write_text(text)
    document = {"machine": about, "load": os.getloadavg(), "tables": [table.json() for table in tables]}
    (work / "report.json").write_text(json.dumps(document, indent=1))
    return text
