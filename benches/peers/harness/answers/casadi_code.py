"""C code of the answers for one case, by CasADi."""

import re
from collections.abc import Callable
from pathlib import Path

import casadi

from ..algebra import solve_symmetric
from ..cases import Case
from ..casadi_code import plain_function
from ..recursion import accelerations
from .inverse import inverse_dynamics, mass_matrix

SX = casadi.SX


class Symbols:
    """The arguments of all answers."""

    def __init__(self, case: Case):
        self.case = case
        n = case.rates
        self.q = SX.sym("q", case.coordinates)
        self.v, self.torques, self.a = (SX.sym(name, n) for name in ("v", "torques", "a"))
        self.x, self.y = SX.sym("x", 3 * n), SX.sym("y", n)
        self.all = [self.q, self.v, self.torques, self.a, self.x, self.y]
        self.hinges: list[list[SX]] = []
        place = 0
        for body in case.bodies:
            size = {"ball": 4, "floating": 7}.get(body.hinge, 1)
            own = casadi.vertsplit(self.q[place : place + size])
            self.hinges.append([casadi.sin(own[0]), casadi.cos(own[0])] if size == 1 else own)
            place += size

    def accelerations(self) -> SX:
        rows = accelerations(self.case, self.hinges, casadi.vertsplit(self.v), casadi.vertsplit(self.torques))
        return casadi.vertcat(*rows)

    def inverse_dynamics(self, a: SX) -> SX:
        rows = inverse_dynamics(self.case, self.hinges, casadi.vertsplit(self.v), casadi.vertsplit(a))
        return casadi.vertcat(*rows)

    def bias_efforts(self) -> SX:
        zeros = [0.0] * self.case.rates
        return casadi.vertcat(*inverse_dynamics(self.case, self.hinges, casadi.vertsplit(self.v), zeros))

    def mass_matrix(self) -> SX:
        return SX(casadi.vertcat(*(casadi.horzcat(*row) for row in mass_matrix(self.case, self.hinges))))

    def inverse_mass_matrix(self) -> SX:
        n, m = self.case.rates, self.mass_matrix()
        rows = [[m[i, j] if m.has_nz(i, j) else 0.0 for j in range(n)] for i in range(n)]
        units = ([float(i == j) for i in range(n)] for j in range(n))
        return casadi.horzcat(*(casadi.vertcat(*solve_symmetric(rows, unit)) for unit in units))

    def tangent(self) -> SX:
        """Returns the derivative of the coordinates by a motion along the rates."""
        blocks = []
        place = 0
        for body in self.case.bodies:
            if body.hinge == "floating":
                blocks.append(SX.eye(3))
                place += 3
            if body.hinge in ("ball", "floating"):
                w, x, y, z = casadi.vertsplit(self.q[place : place + 4])
                rows = [[-x, -y, -z], [w, -z, y], [z, w, -x], [-y, x, w]]
                blocks.append(casadi.vertcat(*(casadi.horzcat(*row) for row in rows)) / 2)
                place += 4
            else:
                blocks.append(SX.eye(1))
                place += 1
        return casadi.diagcat(*blocks)

    def along_rates(self, function: SX) -> SX:
        """Returns the Jacobian by a motion along the rates.

        It has fewer operations than the product of the Jacobian by quaternions with `tangent`.
        """
        motion = SX.sym("motion", self.case.rates)
        moved = casadi.substitute(function, self.q, self.q + self.tangent() @ motion)
        return casadi.substitute(casadi.jacobian(moved, motion), motion, SX.zeros(self.case.rates))

    def motors(self) -> SX:
        """Returns the efforts of the hinges, without those of a floating base, which are zero."""
        return self.torques[6:] if self.case.floating else self.torques


Answer = Callable[[Symbols], list[SX]]


def derivatives(s: Symbols) -> list[SX]:
    efforts = s.inverse_dynamics(s.a)
    return [s.along_rates(efforts), casadi.jacobian(efforts, s.v), s.mass_matrix(), efforts]


def linearize(s: Symbols) -> list[SX]:
    """Differentiates forward dynamics."""
    a = s.accelerations()
    return [s.along_rates(a), casadi.jacobian(a, s.v), casadi.jacobian(a, s.motors()), a]


def linearize_by_components(s: Symbols) -> list[SX]:
    """Differentiates forward dynamics by the components of quaternions, as users do."""
    a = s.accelerations()
    by_q = casadi.jacobian(a, s.q) @ s.tangent()
    return [by_q, casadi.jacobian(a, s.v), casadi.jacobian(a, s.motors()), a]


def linearize_by_inverse(s: Symbols) -> list[SX]:
    """Multiplies derivatives of inverse dynamics by the inverse mass matrix."""
    inverse = s.inverse_mass_matrix()
    a = inverse @ (s.torques - s.bias_efforts())
    efforts = s.inverse_dynamics(s.a)
    by_q, by_v = s.along_rates(efforts), casadi.jacobian(efforts, s.v)
    by_q, by_v = casadi.substitute([by_q, by_v], [s.a], [a])
    start = 6 if s.case.floating else 0
    return [-inverse @ by_q, -inverse @ by_v, inverse[:, start:], a]


def push(s: Symbols) -> list[SX]:
    n, a = s.case.rates, s.accelerations()
    motion = casadi.vertcat(s.tangent() @ s.x[:n], s.x[n:])
    return [casadi.jtimes(a, casadi.vertcat(s.q, s.v, s.torques), motion), a]


def pull(s: Symbols) -> list[SX]:
    a = s.accelerations()
    variables = [s.q, s.v, s.torques]
    by_all = casadi.gradient(casadi.dot(s.y, a), casadi.vertcat(*variables))
    ends = [s.case.coordinates, s.case.coordinates + s.case.rates, by_all.numel()]
    by_q, by_v, by_torques = casadi.vertsplit(by_all, [0, *ends])
    return [s.tangent().T @ by_q, by_v, by_torques[6:] if s.case.floating else by_torques, a]


ANSWERS: dict[str, tuple[Answer, bool]] = {
    "accelerations": (lambda s: [s.accelerations()], False),
    "inverse_dynamics": (lambda s: [s.inverse_dynamics(s.a)], True),
    "bias_efforts": (lambda s: [s.bias_efforts()], True),
    "mass_matrix": (lambda s: [s.mass_matrix()], True),
    "inverse_mass_matrix": (lambda s: [s.inverse_mass_matrix()], False),
    "derivatives": (derivatives, True),
    "linearize": (linearize, True),
    "linearize by components": (linearize_by_components, True),
    "linearize by inverse": (linearize_by_inverse, True),
    "push": (push, True),
    "pull": (pull, True),
}
"""The results of each answer, a matrix by rows, and whether CasADi's simplification is on: it saves operations
but makes as many divisions of the products with a reciprocal.
"""


def generate(case: Case, name: str, path: Path) -> int:
    """Writes `core.h` and returns the number of CasADi's instructions."""
    answer, simplify = ANSWERS[name]
    casadi.GlobalOptions.setSimplificationOnTheFly(simplify)
    symbols = Symbols(case)
    results = casadi.vertcat(*(casadi.densify(casadi.vec(result.T)) for result in answer(symbols)))
    core = casadi.Function("core", symbols.all, [casadi.cse(results)])
    generator = casadi.CodeGenerator("core.c", {"with_header": False, "verbose": False})
    generator.add(core)
    base = 7 if case.floating else 0
    defines = {
        "BASE": base,
        "COORDINATES": case.coordinates,
        "RATES": case.rates,
        "PINS": sum(body.hinge in "xyz" for body in case.bodies),
        "RESULTS": results.numel(),
    }
    lines = [f"#define {name} {value}" for name, value in defines.items()]
    names = ["q", "v", "torques", "a", "x", "y", "sines", "cosines"]
    code = with_shared_trigonometry(plain_function(generator.dump(), names), base)
    path.write_text("\n".join([*lines, code]))
    return int(core.n_instructions())


def with_shared_trigonometry(code: str, base: int) -> str:
    """Takes sines and cosines of the angles from arrays."""
    angles: dict[str, int] = {}
    lines = []
    for line in code.splitlines():
        if found := re.match(r"\s*(a\d+)=(?:(q)\[(\d+)\]|(sin|cos)\((a\d+)\)|.*);$", line):
            target, q, index, function, argument = found.groups()
            if function and argument in angles:
                array = "sines" if function == "sin" else "cosines"
                line = f"  {target}={array}[{angles[argument] - base}];"
            angles.pop(target, None)
            if q:
                angles[target] = int(index)
        lines.append(line)
    return "\n".join(lines) + "\n"
