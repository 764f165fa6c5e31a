"""Tables and JSON of what was measured."""

import json
import math
import os
import platform
import subprocess
from dataclasses import dataclass
from pathlib import Path

from .measure import Measured

WRONG = 1e-6
"""From this error on accelerations are called wrong."""

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
            wrong = " **wrong**" if row.error > WRONG else ""
            cells = [name, digits(row.nanoseconds), f"{self.own.ratio(row):.2f}", f"{row.error:.0e}{wrong}", f"{row.typical_error:.0e}"]
            lines.append(f"| {' | '.join(cells)} |")
        return [*lines, ""]

    def json(self) -> dict:
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
    """Three digits."""
    return f"{nanoseconds:.1f}" if nanoseconds < 100 else f"{float(f'{nanoseconds:.3g}'):.0f}"


def machine(clang: str) -> list[str]:
    """What the figures are of."""
    model = next(
        (line.split(":", 1)[1].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("model name")),
        platform.processor(),
    )
    first = lambda *command: subprocess.run(command, capture_output=True, text=True).stdout.splitlines()[0]  # noqa: E731
    packages = (Path(__file__).parents[1] / "requirements.txt").read_text().split()
    return [model, first("rustc", "--version"), first(clang, "--version"), *packages]


def write(work: Path, clang: str, tables: list[Table]) -> str:
    about = machine(clang)
    text = "\n".join([", ".join(about) + ".", "", *(line for table in tables for line in table.lines())])
    (work / "report.md").write_text(text)
    document = {"machine": about, "load": os.getloadavg(), "tables": [table.json() for table in tables]}
    (work / "report.json").write_text(json.dumps(document, indent=1))
    return text
