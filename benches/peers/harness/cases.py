"""The mechanisms that are timed, as data for all tools."""

from dataclasses import dataclass

from .trees import urdf
from .trees.robots import MODELS_BY_NAME

Vector = tuple[float, float, float]
Matrix = tuple[Vector, Vector, Vector]

ZERO: Vector = (0.0, 0.0, 0.0)
ONE: Matrix = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
# Exact rotations by 90° about x: the URDF has them to sixteen digits.
UP: Matrix = ((1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0))
DOWN: Matrix = ((1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0))


@dataclass(frozen=True)
class Body:
    """A body and its inboard hinge; both frames have their origin at the hinge."""

    hinge: str
    """`x`, `y` or `z`: a pin about this axis; `ball`; `floating`, only of the first body."""
    parent: int | None
    """The index of the inboard body, `None` for the ground."""
    position: Vector
    """The position of the hinge, in the frame of the inboard body."""
    rotation: Matrix
    """The rotation matrix from the hinge's inboard frame to the frame of the inboard body."""
    mass: float
    com: Vector
    inertia: Matrix
    """The inertia about the centre of mass."""


@dataclass(frozen=True)
class Case:
    """A chain with its first hinge on the ground, or a tree with a floating base."""

    name: str
    gravity: Vector
    bodies: tuple[Body, ...]

    @property
    def coordinates(self) -> int:
        return sum({"ball": 4, "floating": 7}.get(body.hinge, 1) for body in self.bodies)

    @property
    def rates(self) -> int:
        return sum({"ball": 3, "floating": 6}.get(body.hinge, 1) for body in self.bodies)

    @property
    def balls(self) -> bool:
        """A case has either only balls or, apart from a floating base, only pins."""
        return self.bodies[0].hinge == "ball"

    @property
    def floating(self) -> bool:
        return self.bodies[0].hinge == "floating"

    @property
    def states(self) -> int:
        """The number of states: too many angles for branch prediction."""
        return 4096 if self.rates <= 40 else 256 if self.rates <= 300 else 64


def diagonal(x: float, y: float, z: float) -> Matrix:
    return ((x, 0.0, 0.0), (0.0, y, 0.0), (0.0, 0.0, z))


def tensor(xx: float, yy: float, zz: float, xy: float, xz: float, yz: float) -> Matrix:
    return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))


def chain(name: str, hinges: list[str], inertia: Matrix) -> Case:
    """Bodies of 1 kg and 1 m in a row along x."""
    bodies = (
        Body(hinge, before(index), (float(index > 0), 0.0, 0.0), ONE, 1.0, (0.5, 0.0, 0.0), inertia)
        for index, hinge in enumerate(hinges)
    )
    return Case(name, (0.0, -9.8, 0.0), tuple(bodies))


def before(index: int) -> int | None:
    """Returns the inboard body in a chain."""
    return index - 1 if index else None


def panda() -> Case:
    """The Franka Emika Panda, joints 1 to 7, from its public URDF."""
    joints = [
        ((0.0, 0.0, 0.333), ONE),
        ((0.0, 0.0, 0.0), DOWN),
        ((0.0, -0.316, 0.0), UP),
        ((0.0825, 0.0, 0.0), UP),
        ((-0.0825, 0.384, 0.0), DOWN),
        ((0.0, 0.0, 0.0), UP),
        ((0.088, 0.0, 0.0), UP),
    ]
    links = [
        (
            4.970684,
            (0.003875, 0.002081, -0.04762),
            tensor(0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169),
        ),
        (
            0.646926,
            (-0.003141, -0.02872, 0.003495),
            tensor(0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704),
        ),
        (
            3.228604,
            (0.027518, 0.039252, -0.066502),
            tensor(0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805),
        ),
        (
            3.587895,
            (-0.05317, 0.104419, 0.027454),
            tensor(0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641),
        ),
        (
            1.225946,
            (-0.011953, 0.041065, -0.038437),
            tensor(0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229),
        ),
        (
            1.666555,
            (0.060149, -0.014117, -0.010517),
            tensor(0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341),
        ),
        (
            0.735522,
            (0.010517, -0.004252, 0.061597),
            tensor(0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741),
        ),
    ]
    bodies = (
        Body("z", before(index), position, rotation, mass, com, inertia)
        for index, ((position, rotation), (mass, com, inertia)) in enumerate(zip(joints, links, strict=True))
    )
    return Case("D7", (0.0, 0.0, -9.81), tuple(bodies))


def robot(name: str) -> Case:
    """A robot of the check of trees, from its URDF file; its pins are about positive axes."""

    def matrix(m: urdf.Matrix) -> Matrix:
        x, y, z = ((float(a), float(b), float(c)) for a, b, c in m)
        return (x, y, z)

    def body(described: urdf.Body) -> Body:
        hinge = "floating"
        if described.kind == "pin":
            hinge = "xyz"[described.axis.index(1)]
        elif described.kind != "floating":
            raise ValueError(f"{described.joint} is not a pin")
        mass = described.mass
        x, y, z = map(float, described.frame.position)
        com_x, com_y, com_z = map(float, mass.com)
        return Body(
            hinge,
            described.parent,
            (x, y, z),
            matrix(described.frame.rotation),
            float(mass.mass),
            (com_x, com_y, com_z),
            matrix(mass.inertia),
        )

    bodies = tuple(map(body, MODELS_BY_NAME[name].robot().bodies))
    return Case(name, (0.0, 0.0, -9.81), bodies)


# Only the moment about z is used; the others make the inertia physical.
ROD = diagonal(0.01, 1 / 12, 1 / 12)
CUBE = diagonal(1 / 6, 1 / 6, 1 / 6)

CASES = {
    case.name: case
    for case in [
        *(chain(f"A{count}", ["z"] * count, ROD) for count in (3, 10, 100, 1000)),
        *(chain(f"B{count}", ["ball"] * count, CUBE) for count in (3, 10, 100)),
        *(chain(f"C{count}", ["zy"[index % 2] for index in range(count)], CUBE) for count in (7, 30)),
        panda(),
        *map(robot, ["HyQ", "G1"]),
    ]
}
