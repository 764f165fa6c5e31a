"""The order of bodies that Pinocchio and MuJoCo need: the bodies of each branch in a row."""

from dataclasses import dataclass, replace

import numpy as np

from ..cases import Case
from ..reference import Array
from .questions import States, shapes


@dataclass(frozen=True)
class DepthFirst:
    """A case with its bodies in this order."""

    original: Case
    case: Case
    coordinates: Array
    """For each coordinate its index in the original case."""
    rates: Array
    bodies: Array

    @staticmethod
    def of(case: Case) -> "DepthFirst":
        bodies: list[int] = []

        def visit(parent: int | None) -> None:
            for index, body in enumerate(case.bodies):
                if body.parent == parent:
                    bodies.append(index)
                    visit(index)

        visit(None)
        places = {old: new for new, old in enumerate(bodies)}
        moved = (case.bodies[old] for old in bodies)
        reordered = [
            body if body.parent is None else replace(body, parent=places[body.parent]) for body in moved
        ]
        return DepthFirst(
            case,
            replace(case, bodies=tuple(reordered)),
            indices(case, bodies, {"ball": 4, "floating": 7}),
            indices(case, bodies, {"ball": 3, "floating": 6}),
            np.array(bodies),
        )

    @property
    def tip(self) -> int:
        """Returns the index of the original case's last body."""
        return list(self.bodies).index(len(self.bodies) - 1)

    def states(self, states: States) -> States:
        direction = np.split(states.direction, 3, axis=1)
        return States(
            states.q[:, self.coordinates],
            states.v[:, self.rates],
            states.efforts[:, self.rates],
            states.accelerations[:, self.rates],
            np.concatenate([part[:, self.rates] for part in direction], axis=1),
            states.weights[:, self.rates],
        )

    def restore(self, question: str, results: Array) -> Array:
        """Returns results in the original order."""
        base = 6 if self.case.floating else 0
        order = {
            "rates": np.argsort(self.rates),
            "motors": np.argsort(self.rates[base:] - base),
            "parameters": np.argsort(parameters(self.bodies)),
        }
        parts, start = [], 0
        for shape in shapes(self.case, question):
            size = int(np.prod([count for _, count in shape]))
            part = results[:, start : start + size]
            if part.shape[1] < size:
                break
            start += size
            part = part.reshape(len(results), *(count for _, count in shape))
            for axis, (kind, _) in enumerate(shape, 1):
                if kind in order:
                    part = np.take(part, order[kind], axis=axis)
            parts.append(part.reshape(len(results), -1))
        return np.concatenate(parts, axis=1)


def indices(case: Case, bodies: list[int], sizes: dict[str, int]) -> Array:
    """Returns the original indices of numbers, of which a pin has one and other hinges `sizes`."""
    counts = [sizes.get(body.hinge, 1) for body in case.bodies]
    starts = np.cumsum([0, *counts])
    return np.concatenate([np.arange(starts[body], starts[body + 1]) for body in bodies])


def parameters(bodies: Array) -> Array:
    return np.asarray((10 * bodies[:, None] + np.arange(10)).ravel())
