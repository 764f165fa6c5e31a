"""Prints a robot as the text of a chain, without parts."""

from __future__ import annotations

import re
from dataclasses import dataclass

from mpmath import mp, mpf

from .urdf import Body, Frame, Matrix, Robot, Vector, angles_of, is_identity, quarters_of

DIGITS = 20
"""The digits of a number that is not short."""

KEYWORDS = frozenset(
    # Rust's, with those of newer editions.
    "abstract as async await become box break const continue crate do dyn else enum extern false final fn "
    "for gen if impl in let loop macro match mod move mut override priv pub ref return self static struct "
    "super trait true try type typeof unsafe unsized use virtual where while yield "
    # The language's.
    "body hinge param ground gravity part last load spring moving repeat method results answers at turned "
    "from weld pin slider screw cylindrical universal ball planar floating elastic "
    # Methods that every chain has.
    "accelerations accelerations_into assemble clone closure configuration_rate_into default derivative_into "
    "energy implicit_derivative_into initial_state kinetic_energy new no_inputs normalize parameters points "
    "potential_energy q q_mut set_time solve_into t time v v_mut workspace "
    # Points that every body has.
    "input output com".split()
)
"""Names that a body, a hinge or a point must not have."""


@dataclass(frozen=True)
class Text:
    text: str
    chain: str
    """The name of the chain."""
    hinges: list[str]
    """The names of the hinges, in the order of the coordinates."""


def write(robot: Robot, source: str, gravity: str = "[0, 0, -9.81] m/s^2") -> Text:
    """Returns the text. Its coordinates have the order of the robot's bodies, which is depth first."""
    writer = Writer(robot)
    name = camel(robot.name) if camel(robot.name) != "T" else "Robot"
    lines = [
        *comments(robot, source),
        "mstmm_chain! {",
        f"    /// The robot `{robot.name}`.",
        f"    pub chain {name} {{",
        f"        gravity = {gravity};",
        "",
        *(f"        {line}" for line in writer.lines()),
        "    }",
        "}",
    ]
    hinges = [hinge for hinge in writer.hinges if hinge]
    return Text("\n".join(line.rstrip() for line in lines) + "\n", name, hinges)


def comments(robot: Robot, source: str) -> list[str]:
    freedom = sum(6 if body.kind == "floating" else 1 for body in robot.bodies)
    lines = [f"// {robot.name}, {len(robot.bodies)} bodies, {freedom} degrees of freedom. Source: {source}."]
    lists = {f"Merged into {body.name}": body.merged for body in robot.bodies}
    lists["Free here, coupled by `mimic` in the file"] = tuple(robot.mimics)
    lists["Without the damping and friction of the file"] = tuple(robot.dampers)
    for title, names in lists.items():
        if names:
            lines += wrapped(f"// {title}: {', '.join(names)}.", "//     ")
    return lines


class Writer:
    def __init__(self, robot: Robot):
        self.robot = robot
        self.children: dict[int | None, list[int]] = {None: []}
        for index, body in enumerate(robot.bodies):
            self.children[index] = []
            self.children[body.parent].append(index)
        names = Names()
        self.bodies = [names.unique(snake(body.name), "_link") for body in robot.bodies]
        joints = [snake(body.joint) if body.joint else "" for body in robot.bodies]
        self.hinges = [names.unique(joint, "_joint") if joint else "" for joint in joints]
        # The points of a body have their own names.
        self.points = [Names().unique(joint, "_joint") if joint else "" for joint in joints]
        # Equal blocks are one type.
        self.types: dict[str, str] = {}
        types = Names()
        for index, body in enumerate(robot.bodies):
            block = "\n".join(self.block(index))
            if block not in self.types:
                self.types[block] = types.unique(camel(body.name), "Link")

    def lines(self) -> list[str]:
        lines: list[str] = []
        for block, name in self.types.items():
            lines += [f"body {name} {{", *(f"    {line}" for line in block.splitlines()), "}"]
        lines += ["", *self.routes(), ""]
        for kind, effort in (("pin", "torque"), ("slider", "force")):
            if names := [
                hinge for hinge, body in zip(self.hinges, self.robot.bodies, strict=True) if body.kind == kind
            ]:
                lines += wrapped(f"hinge {', '.join(names)} {{ {effort} = input; }}", "    ")
        return lines

    def block(self, index: int) -> list[str]:
        """Returns the fields of a body type."""
        body = self.robot.bodies[index]
        mass = body.mass
        if mass.mass <= 0:
            raise ValueError(f"link {body.name} moves and has no mass")
        lines = [
            f"mass = {number(mass.mass)} kg;",
            f"com = {position(mass.com)};",
            f"inertia = {inertia(mass.inertia)} kg*m^2 about com;",
        ]
        children = self.children[index]
        for child in children:
            # A branch leaves from a named point, the only child continues the route.
            place = "output" if len(children) == 1 else f"point {self.points[child]}"
            lines.append(f"{place} = {frame(self.robot.bodies[child].frame)};")
        return lines

    def routes(self) -> list[str]:
        """Returns the routes: each continues while a body has a single child."""
        begun: list[tuple[str, list[int]]] = []
        if self.robot.floating:
            begun.append(("", self.path(0)))
        for index, body in enumerate(self.robot.bodies):
            if body.parent is None and body.joint:
                begun.append((ground(body.frame), self.path(index)))
            elif body.parent is not None and len(self.children[body.parent]) > 1:
                begin = f"{self.bodies[body.parent]}.{self.points[index]}"
                begun.append((begin, self.path(index)))
        lines: list[str] = []
        for begin, path in begun:
            steps = [begin] if begin else []
            steps += [step for index in path for step in self.steps(index)]
            lines += wrapped(" -> ".join(steps) + ";", "    ", at=" -> ")
        return lines

    def path(self, index: int) -> list[int]:
        path = [index]
        while len(self.children[path[-1]]) == 1:
            path += self.children[path[-1]]
        return path

    def steps(self, index: int) -> list[str]:
        body, block = self.robot.bodies[index], "\n".join(self.block(index))
        named = f"{self.types[block]} {self.bodies[index]}"
        return [f"{hinge_kind(body)} {self.hinges[index]}", named] if body.joint else [named]


class Names:
    """Names that are used once and are no keywords."""

    def __init__(self) -> None:
        self.used: set[str] = set()

    def unique(self, name: str, suffix: str) -> str:
        """Returns the name, with the suffix or a number if it is used or a keyword."""
        if name in KEYWORDS or name in self.used or name.removesuffix("_mut") in self.used:
            name += suffix
        plain, count = name, 2
        while name in self.used:
            name, count = f"{plain}{count}", count + 1
        self.used.add(name)
        return name


def snake(name: str) -> str:
    name = re.sub(r"\W", "_", name)
    name = re.sub(r"(?<=[a-z0-9])(?=[A-Z][a-z])", "_", name).lower()
    name = re.sub(r"__+", "_", name).strip("_")
    return name if name[:1].isalpha() else f"n{name}"


def camel(name: str) -> str:
    return "".join(word[:1].upper() + word[1:] for word in snake(name).split("_"))


def hinge_kind(body: Body) -> str:
    nonzero = [i for i, x in enumerate(body.axis) if x]
    if len(nonzero) > 1:
        return f"{body.kind}([{', '.join(map(number, body.axis))}])"
    (axis,) = nonzero
    return f"{body.kind}({'-' if body.axis[axis] < 0 else ''}{'xyz'[axis]})"


def ground(place: Frame) -> str:
    words = ["ground"]
    if any(place.position):
        words += ["at", position(place.position)]
    if not is_identity(place.rotation):
        words += ["turned", orientation(place)]
    return " ".join(words)


def frame(place: Frame) -> str:
    turned = "" if is_identity(place.rotation) else f" turned {orientation(place)}"
    return position(place.position) + turned


def orientation(place: Frame) -> str:
    angles = place.angles or angles_of(place.rotation)
    return f"rpy({', '.join(map(angle, angles))})"


def angle(value: mpf) -> str:
    quarters = quarters_of(value)
    if quarters is None:
        return f"{number(value)} rad"
    return f"{90 * quarters} deg" if quarters else "0"


def position(v: Vector) -> str:
    return f"[{', '.join(map(number, v))}] m"


def inertia(m: Matrix) -> str:
    off = [m[0][1], m[0][2], m[1][2]]
    entries = [m[i][i] for i in range(3)]
    form = "tensor" if any(off) else "diag"
    return f"{form}({', '.join(map(number, entries + off if any(off) else entries))})"


def number(value: mpf) -> str:
    text = mp.nstr(value, DIGITS, min_fixed=-5, max_fixed=DIGITS)
    mantissa, e, exponent = text.partition("e")
    mantissa = mantissa.removesuffix(".0")
    return mantissa + e + exponent if mantissa not in ("0", "-0") else "0"


def wrapped(line: str, indent: str, at: str = ", ", width: int = 108) -> list[str]:
    """Breaks a line, before an arrow or after a comma."""
    arrow = at == " -> "
    pieces = line.split(at)
    lines, current = [], pieces[0]
    for piece in pieces[1:]:
        if len(current) + len(at) + len(piece) > width:
            lines.append(current if arrow else current + ",")
            current = f"{indent}-> {piece}" if arrow else indent + piece
        else:
            current += at + piece
    return [*lines, current]
