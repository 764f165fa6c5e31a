"""The questions that are timed, their states and their results."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..cases import CASES, CUBE, Case, Vector, chain
from ..reference import Array

ANSWER_CASES = {
    case.name: case
    for case in (CASES["D7"], CASES["B3"], chain("B30", ["ball"] * 30, CUBE), CASES["HyQ"], CASES["G1"])
}

TIPS: dict[str, Vector] = {
    "D7": (0.0, 0.0, 0.107),
    "B3": (1.0, 0.0, 0.0),
    "B30": (1.0, 0.0, 0.0),
    "HyQ": (0.346, 0.0, 0.0),
    "G1": (0.0, 0.0, 0.0),
}
"""A point of the last body, in its frame: the flange, the end of the last cube, a foot, a wrist."""

SEED = 25
LARGEST_ACCELERATION = 5.0
"""In rad/s² or m/s²."""


@dataclass(frozen=True)
class Question:
    name: str
    """Its name in the commands of all contenders, and the keyword in `answers`."""
    title: str


QUESTIONS = [
    Question("accelerations", "forward dynamics"),
    Question("inverse_dynamics", "inverse dynamics"),
    Question("bias_efforts", "bias efforts"),
    Question("mass_matrix", "mass matrix"),
    Question("inverse_mass_matrix", "inverse mass matrix"),
    Question("coriolis_matrix", "Coriolis matrix"),
    Question("jacobian", "Jacobian of the tip"),
    Question("regressor", "regressor"),
    Question("derivatives", "derivatives of inverse dynamics, with M"),
    Question("linearize", "A and B, with accelerations"),
    Question("push", "J x, with accelerations"),
    Question("pull", "yᵀJ, with accelerations"),
]


def count_of_states(case: Case) -> int:
    """Returns the number of states: many angles for branch prediction, but few enough for the cache."""
    return 2048 if case.rates <= 10 else 1024 if case.rates <= 20 else 256


@dataclass(frozen=True)
class States:
    """The parts of all states; a row for each state."""

    q: Array
    v: Array
    efforts: Array
    accelerations: Array
    direction: Array
    weights: Array

    def write(self, path: Path) -> None:
        parts = [self.q, self.v, self.efforts, self.accelerations, self.direction, self.weights]
        np.concatenate(parts, axis=1).tofile(path)


def parts(case: Case, numbers: Array) -> States:
    n = case.rates
    sizes = [case.coordinates, n, n, n, 3 * n, n]
    columns = np.split(numbers.reshape(-1, sum(sizes)), np.cumsum(sizes)[:-1], axis=1)
    return States(*columns)


def shapes(case: Case, question: str) -> list[list[tuple[str, int]]]:
    """Returns what rows and columns of an answer's matrices and vectors belong to, and their numbers."""
    n = case.rates
    rates, motors = ("rates", n), ("motors", n - 6 if case.floating else n)
    vector, matrix = [rates], [rates, rates]
    return {
        "mass_matrix": [matrix],
        "inverse_mass_matrix": [matrix],
        "coriolis_matrix": [matrix],
        "jacobian": [[("velocity", 3), rates], [("angular velocity", 3), rates]],
        "regressor": [[rates, ("parameters", 10 * len(case.bodies))]],
        "derivatives": [matrix, matrix, matrix],
        "linearize": [matrix, matrix, [rates, motors], vector],
        "push": [vector, vector],
        "pull": [vector, vector, [motors], vector],
    }.get(question, [vector])


def states_from(case: Case, basic: Path) -> States:
    """Extends states of coordinates, rates and efforts by the other parts."""
    n = case.rates
    states = np.fromfile(basic).reshape(-1, case.coordinates + 2 * n)
    random = np.random.default_rng(SEED)
    accelerations = random.uniform(-LARGEST_ACCELERATION, LARGEST_ACCELERATION, (len(states), n))
    others = random.uniform(-1.0, 1.0, (len(states), 4 * n))
    if case.floating:
        # A floating base has no effort, and so no direction of an effort.
        others[:, 2 * n : 2 * n + 6] = 0.0
    return parts(case, np.concatenate([states, accelerations, others], axis=1))
