"""The goals that the figures are compared with."""

from collections.abc import Callable
from dataclasses import dataclass

BY_COMPONENTS = "CasADi by components"
"""CasADi's derivative by the components of quaternions, multiplied onto the tangent."""


@dataclass(frozen=True)
class Figures:
    """Times in ns of the fastest batches, by case, question and contender."""

    times: dict[tuple[str, str, str], float]

    def own(self, case: str, question: str) -> float | None:
        return self.times.get((case, question, "mstmm"))

    def lanes(self, case: str, question: str) -> float | None:
        return self.times.get((case, question, "mstmm, lanes"))

    def peer(self, case: str, question: str, name: str) -> float | None:
        """Returns the time of the fastest contender whose name begins so."""
        times = [
            time
            for (of_case, of_question, contender), time in self.times.items()
            if (of_case, of_question) == (case, question) and contender.startswith(name)
        ]
        return min(times, default=None)

    def user_of_casadi(self, case: str, question: str) -> float | None:
        """Returns the time of CasADi's derivative of forward dynamics with respect to all coordinates."""
        by_components = self.times.get((case, question, BY_COMPONENTS))
        return by_components or self.times.get((case, question, "CasADi"))


@dataclass(frozen=True)
class Goal:
    name: str
    title: str
    limit: float
    at_most: bool
    figure: Callable[[Figures], float | None]

    def is_met(self, reached: float) -> bool:
        return reached <= self.limit if self.at_most else reached >= self.limit


def ratio(a: float | None, b: float | None) -> float | None:
    return a / b if a and b else None


def in_forward_dynamics(name: str, case: str, question: str, limit: float) -> Goal:
    return Goal(
        name,
        f"{case}, {question} / forward dynamics",
        limit,
        True,
        lambda f: ratio(f.own(case, question), f.own(case, "accelerations")),
    )


def faster_than(name: str, case: str, question: str, peer: str, limit: float) -> Goal:
    return Goal(
        name,
        f"{case}, {question}, {peer} / this library",
        limit,
        False,
        lambda f: ratio(f.peer(case, question, peer), f.own(case, question)),
    )


def at_most_casadi(name: str, case: str, question: str, limit: float) -> Goal:
    return Goal(
        name,
        f"{case}, {question}, this library / CasADi's fastest",
        limit,
        True,
        lambda f: ratio(f.own(case, question), f.peer(case, question, "CasADi")),
    )


def goals_of(cases: list[str]) -> list[Goal]:
    """Returns the goals G1 to G6 and G8, and those of trees."""
    goals: list[Goal] = []
    # G1 to G4, whose limits differ by case: A and B in forward dynamics, the stretch goal, then ratios.
    for case, linearize, stretch, aba, stretch_aba, casadi in (
        ("D7", 4.0, 3.0, 4.5, 6.5, 0.3),
        ("B3", 7.5, 5.5, 6.0, 8.0, 0.6),
    ):
        goals += [
            in_forward_dynamics("G1", case, "inverse_dynamics", 0.6),
            faster_than("G1", case, "inverse_dynamics", "Pinocchio", 7.0),
            at_most_casadi("G1", case, "inverse_dynamics", 1.1),
            faster_than("G2", case, "mass_matrix", "Pinocchio", 6.0),
            faster_than("G2", case, "inverse_mass_matrix", "Pinocchio", 6.0),
            faster_than("G2", case, "jacobian", "Pinocchio", 5.0),
            faster_than("G2", case, "regressor", "Pinocchio", 5.5),
            faster_than("G3", case, "derivatives", "Pinocchio", 6.0),
            at_most_casadi("G3", case, "derivatives", casadi),
            in_forward_dynamics("G4", case, "linearize", linearize),
            faster_than("G4", case, "linearize", "Pinocchio", aba),
            at_most_casadi("G4", case, "linearize", 0.5),
            Goal(
                "G4",
                f"{case}, linearize, this library / CasADi's `jacobian`",
                0.35,
                True,
                lambda f, case=case: ratio(f.own(case, "linearize"), f.user_of_casadi(case, "linearize")),
            ),
            in_forward_dynamics("G4, stretch", case, "linearize", stretch),
            faster_than("G4, stretch", case, "linearize", "Pinocchio", stretch_aba),
        ]
    goals += [
        faster_than("G2", "D7", question, "dynibo", 6.0)
        for question in ("inverse_dynamics", "mass_matrix", "jacobian")
    ]
    goals += [
        Goal(
            "G5",
            "D7, linearize / forward dynamics, both 8 states at a time",
            4.5,
            True,
            lambda f: ratio(f.lanes("D7", "linearize"), f.lanes("D7", "accelerations")),
        ),
        Goal(
            "G5",
            "D7, linearize 8 states at a time, Pinocchio / this library",
            25.0,
            False,
            lambda f: ratio(f.peer("D7", "linearize", "Pinocchio"), f.lanes("D7", "linearize")),
        ),
    ]
    for case, limit in (("D7", 2.1), ("B3", 2.6), ("B30", 2.6)):
        for question in ("push", "pull"):
            goals.append(in_forward_dynamics("G6", case, question, limit))
            goals.append(at_most_casadi("G6", case, question, 0.85))
    goals += [
        faster_than("G8", "B30", "linearize", "Pinocchio", 2.0),
        faster_than("trees", "HyQ", "linearize", "Pinocchio", 4.0),
    ]
    return [goal for goal in goals if goal.title.split(",")[0] in cases]
