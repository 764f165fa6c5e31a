"""Runs contenders in rounds and compares their results with the reference."""

import json
import os
import resource
import statistics
import subprocess
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from .build import Contender

MEMORY = 8 << 30
"""The memory limit of a contender in bytes, which protects the machine."""


@dataclass
class Measured:
    contender: Contender
    rounds: list[float] = field(default_factory=list)
    """ns per evaluation: the median of each round's batches."""
    fastest: float = float("inf")
    """ns per evaluation, of all batches."""
    error: float = float("nan")
    """The error of an acceleration relative to the largest in its state; the largest over all states."""
    typical_error: float = float("nan")
    """The median error over all states."""
    failure: str = ""

    @property
    def nanoseconds(self) -> float:
        return statistics.median(self.rounds) if self.rounds else float("nan")

    def ratio(self, other: "Measured") -> float:
        """Returns the ratio of this contender's time to that of another, in the same rounds."""
        if not self.rounds or not other.rounds:
            return float("nan")
        return statistics.median(a / b for a, b in zip(self.rounds, other.rounds, strict=True))


def measure(
    contenders: list[Contender],
    states: Path,
    compare: Callable[["Measured", np.ndarray], None],
    rounds: int,
    milliseconds: int,
    core: int,
) -> list[Measured]:
    """Runs each contender once per round, so that disturbances affect all of them.

    `compare` is called with the results of each contender.
    """
    all_measured = [Measured(contender) for contender in contenders]
    results = states.with_suffix(".results")
    for index in range(rounds):
        for measured in all_measured:
            if measured.failure:
                continue
            # The first round also writes results.
            files = [str(measured.contender.states or states), str(results) if index == 0 else "-"]
            command = [*measured.contender.command, *files, str(milliseconds)]
            run = subprocess.run(command, capture_output=True, text=True, preexec_fn=lambda: confine(core))
            if run.returncode:
                words = run.stderr.strip().splitlines() or [f"ends with {run.returncode}"]
                measured.failure = words[-1].strip()
                continue
            times = json.loads(run.stdout)
            each = [time / times["evaluations"] for time in times["nanoseconds"]]
            measured.rounds.append(statistics.median(each))
            measured.fastest = min(measured.fastest, *each)
            if index == 0:
                compare(measured, np.fromfile(results))
    return all_measured


def confine(core: int) -> None:
    os.sched_setaffinity(0, {core})
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_STACK, (256 << 20, 256 << 20))


def compare(measured: Measured, results: np.ndarray, reference: np.ndarray) -> None:
    """Sets the errors; the results begin with the accelerations of each state."""
    rows = results.reshape(reference.shape[0], -1)[:, : reference.shape[1]]
    errors = np.abs(rows - reference).max(axis=1) / np.abs(reference).max(axis=1)
    # NaN is an infinite error.
    errors = np.where(np.isnan(errors), np.inf, errors)
    measured.error, measured.typical_error = float(errors.max()), float(np.median(errors))
