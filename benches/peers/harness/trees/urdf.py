"""Reads a URDF file as a tree of bodies without fixed joints, with fifty digits."""

from __future__ import annotations

import xml.etree.ElementTree as xml
from dataclasses import dataclass, field, replace
from pathlib import Path

from mpmath import mp, mpf

mp.dps = 50

Vector = list[mpf]
Matrix = list[Vector]

RIGHT_ANGLE = mpf("1e-10")
"""An angle that differs by less from a multiple of 90° is taken as this multiple: 1.57079632679 is 90°."""


@dataclass(frozen=True)
class Frame:
    """A frame: its origin and its axes in an outer frame."""

    position: Vector
    rotation: Matrix
    angles: tuple[mpf, mpf, mpf] | None = None
    """Roll, pitch and yaw as the file has them, if the frame comes from a single `origin`."""

    def __matmul__(self, inner: Frame) -> Frame:
        """Returns the inner frame in the outer frame of this one."""
        position = plus(self.position, times(self.rotation, inner.position))
        angles = None
        if is_identity(self.rotation):
            angles = inner.angles
        elif is_identity(inner.rotation):
            angles = self.angles
        return Frame(position, product(self.rotation, inner.rotation), angles)


@dataclass(frozen=True)
class Mass:
    """A mass, its centre, and its inertia tensor about the centre."""

    mass: mpf
    com: Vector
    inertia: Matrix

    def seen_from(self, frame: Frame) -> Mass:
        """Returns the mass in the outer frame of `frame`."""
        com = plus(frame.position, times(frame.rotation, self.com))
        rotated = product(product(frame.rotation, self.inertia), transposed(frame.rotation))
        return Mass(self.mass, com, rotated)

    def __add__(self, other: Mass) -> Mass:
        mass = self.mass + other.mass
        if mass == 0:
            return self
        com = [(self.mass * a + other.mass * b) / mass for a, b in zip(self.com, other.com, strict=True)]
        tensors = [self.about(com), other.about(com)]
        inertia = [[sum(tensor[i][j] for tensor in tensors) for j in range(3)] for i in range(3)]
        return Mass(mass, com, inertia)

    def about(self, point: Vector) -> Matrix:
        """Returns the inertia tensor about a point."""
        arm = [a - b for a, b in zip(point, self.com, strict=True)]
        square = sum(x * x for x in arm)

        def entry(i: int, j: int) -> mpf:
            return self.inertia[i][j] + self.mass * ((square if i == j else 0) - arm[i] * arm[j])

        return [[entry(i, j) for j in range(3)] for i in range(3)]


@dataclass(frozen=True)
class Body:
    """A body and its inboard hinge."""

    name: str
    """The name of the link."""
    joint: str
    """The name of the joint; empty for a floating base."""
    kind: str
    """`pin`, `slider` or `floating`."""
    axis: Vector
    """The axis of the hinge, in the frame of the body."""
    parent: int | None
    """The index of the inboard body, `None` for the ground."""
    frame: Frame
    """The hinge's inboard frame in the frame of the inboard body."""
    mass: Mass
    merged: tuple[str, ...]
    """The links that fixed joints attach to this one."""


@dataclass(frozen=True)
class Robot:
    name: str
    bodies: list[Body]
    """Each after its parent: depth first, in the order of the file."""
    mimics: list[str] = field(default_factory=list)
    """Joints that the file couples to others; here they move freely."""
    dampers: list[str] = field(default_factory=list)
    """Joints whose damping or friction is omitted."""

    @property
    def floating(self) -> bool:
        return self.bodies[0].kind == "floating"

    @property
    def joints(self) -> list[str]:
        return [body.joint for body in self.bodies if body.joint]

    def in_order(self, joints: list[str]) -> Robot:
        """Returns the same robot with its joints in another order, in which parents also come first."""
        old = {body.joint: index for index, body in enumerate(self.bodies)}
        order = [old[joint] for joint in ([""] if self.floating else []) + joints]
        assert sorted(order) == list(range(len(self.bodies))), "not the joints of the file"
        new = {index: place for place, index in enumerate(order)}
        parents = [self.bodies[index].parent for index in order]
        bodies = [
            replace(self.bodies[index], parent=None if parent is None else new[parent])
            for index, parent in zip(order, parents, strict=True)
        ]
        return replace(self, bodies=bodies)


def read(path: Path, floating: bool, right_angles: bool = True) -> Robot:
    """Reads a file. `floating` leaves the root link free; else it is fixed to the ground, and its inertia has
    no effect. With `right_angles`, angles close to a multiple of 90° are this multiple.
    """
    return Reader(xml.parse(path).getroot(), right_angles).robot(floating)


class Reader:
    def __init__(self, root: xml.Element, right_angles: bool):
        self.root, self.right_angles = root, right_angles
        self.links = {name_of(link): link for link in root.findall("link")}
        self.children: dict[str, list[xml.Element]] = {name: [] for name in self.links}
        for joint in root.findall("joint"):
            self.children[linked(joint, "parent")].append(joint)

    def robot(self, floating: bool) -> Robot:
        below = {linked(joint, "child") for joints in self.children.values() for joint in joints}
        roots = set(self.links) - below
        if len(roots) != 1:
            raise ValueError(f"expected one root link, found {len(roots)}")
        (root,) = roots
        self.bodies: list[Body] = []
        if floating:
            self.add(root, "", "floating", [], None, identity())
        else:
            _, _, joints = self.rigid(root)
            self.add_joints(joints, None)
        every = [joint for joints in self.children.values() for joint in joints]
        every = [joint for joint in every if joint.get("type") != "fixed"]
        mimics = [name_of(joint) for joint in every if joint.find("mimic") is not None]
        dampers = [name_of(joint) for joint in every if dissipates(joint)]
        return Robot(self.root.get("name", "robot"), self.bodies, mimics, dampers)

    def add(self, link: str, joint: str, kind: str, axis: Vector, parent: int | None, frame: Frame) -> None:
        """Adds a body and the bodies outboard of it."""
        mass, merged, joints = self.rigid(link)
        index = len(self.bodies)
        self.bodies.append(Body(link, joint, kind, axis, parent, frame, mass, tuple(merged)))
        self.add_joints(joints, index)

    def add_joints(self, joints: list[tuple[xml.Element, Frame]], parent: int | None) -> None:
        kinds = {"revolute": "pin", "continuous": "pin", "prismatic": "slider"}
        for joint, frame in joints:
            name, kind = name_of(joint), joint.get("type", "")
            if kind not in kinds:
                raise ValueError(f"joint {name}: {kind} joints have no translation")
            self.add(linked(joint, "child"), name, kinds[kind], axis_of(joint), parent, frame)

    def rigid(self, link: str) -> tuple[Mass, list[str], list[tuple[xml.Element, Frame]]]:
        """Returns the mass of a link with all that is fixed to it, the names of the links fixed to it, and
        the joints that leave them, with their frames in this link's frame.
        """
        mass, merged, leaving = self.mass(self.links[link]), [], []
        for joint in self.children[link]:
            frame = self.frame(joint.find("origin"))
            if joint.get("type") != "fixed":
                leaving.append((joint, frame))
                continue
            child = linked(joint, "child")
            outer, names, joints = self.rigid(child)
            mass = mass + outer.seen_from(frame)
            merged += [child, *names]
            leaving += [(other, frame @ inner) for other, inner in joints]
        return mass, merged, leaving

    def mass(self, link: xml.Element) -> Mass:
        inertial = link.find("inertial")
        if inertial is None:
            return Mass(mpf(0), [mpf(0)] * 3, [[mpf(0)] * 3 for _ in range(3)])
        found = {name: inertial.find(name) for name in ("mass", "inertia")}
        mass, tensor = (element.attrib if element is not None else {} for element in found.values())

        def entry(i: int, j: int) -> mpf:
            first, second = sorted((i, j))
            return mpf(tensor.get(f"i{'xyz'[first]}{'xyz'[second]}", "0"))

        inertia = [[entry(i, j) for j in range(3)] for i in range(3)]
        about_com = Mass(mpf(mass.get("value", "0")), [mpf(0)] * 3, inertia)
        return about_com.seen_from(self.frame(inertial.find("origin")))

    def frame(self, origin: xml.Element | None) -> Frame:
        if origin is None:
            return identity()
        angles = [self.angle(text) for text in origin.get("rpy", "0 0 0").split()]
        return Frame(vector(origin.get("xyz", "0 0 0")), rotation(angles), tuple(angles))

    def angle(self, text: str) -> mpf:
        angle = mpf(text)
        quarters = mp.nint(angle / (mp.pi / 2))
        exact = quarters * mp.pi / 2
        return exact if self.right_angles and quarters and abs(angle - exact) < RIGHT_ANGLE else angle


def name_of(element: xml.Element) -> str:
    return element.get("name", "")


def linked(joint: xml.Element, which: str) -> str:
    element = joint.find(which)
    assert element is not None, f"joint {name_of(joint)} has no {which}"
    return element.get("link", "")


def dissipates(joint: xml.Element) -> bool:
    dynamics = joint.find("dynamics")
    return dynamics is not None and any(mpf(dynamics.get(name, "0")) for name in ("damping", "friction"))


def axis_of(joint: xml.Element) -> Vector:
    axis = joint.find("axis")
    return vector(axis.get("xyz", "1 0 0") if axis is not None else "1 0 0")


def vector(text: str) -> Vector:
    return [mpf(word) for word in text.split()]


def identity() -> Frame:
    zero = [mpf(0)] * 3
    return Frame(zero, rotation(zero), (mpf(0),) * 3)


def is_identity(m: Matrix) -> bool:
    return all(m[i][j] == (i == j) for i in range(3) for j in range(3))


def quarters_of(angle: mpf) -> int | None:
    """Returns the number of right angles, if it is a whole number."""
    quarters = mp.nint(angle / (mp.pi / 2))
    return int(quarters) if abs(angle - quarters * mp.pi / 2) < mpf("1e-40") else None


def sine_and_cosine(angle: mpf) -> tuple[mpf, mpf]:
    """Returns sine and cosine, exact for multiples of 90°."""
    quarters = quarters_of(angle)
    if quarters is None:
        return mp.sin(angle), mp.cos(angle)
    sine, cosine = ((0, 1), (1, 0), (0, -1), (-1, 0))[quarters % 4]
    return mpf(sine), mpf(cosine)


def rotation(angles: list[mpf]) -> Matrix:
    """Returns A_z(yaw) A_y(pitch) A_x(roll)."""
    (sr, cr), (sp, cp), (sy, cy) = map(sine_and_cosine, angles)
    return [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]


def angles_of(m: Matrix) -> list[mpf]:
    """Returns roll, pitch and yaw of a rotation matrix; at a pitch of ±90° the yaw is zero."""
    if abs(m[2][0]) == 1:
        return [mp.atan2(-m[1][2], m[1][1]), -m[2][0] * mp.pi / 2, mpf(0)]
    pitch = mp.atan2(-m[2][0], mp.sqrt(m[0][0] ** 2 + m[1][0] ** 2))
    return [mp.atan2(m[2][1], m[2][2]), pitch, mp.atan2(m[1][0], m[0][0])]


def plus(*vectors: Vector) -> Vector:
    return [sum(entries, mpf(0)) for entries in zip(*vectors, strict=True)]


def times(m: Matrix, v: Vector) -> Vector:
    return [sum((x * y for x, y in zip(row, v, strict=True)), mpf(0)) for row in m]


def product(a: Matrix, b: Matrix) -> Matrix:
    columns = transposed(b)
    return [
        [sum((x * y for x, y in zip(row, column, strict=True)), mpf(0)) for column in columns] for row in a
    ]


def transposed(m: Matrix) -> Matrix:
    return [list(column) for column in zip(*m, strict=True)]
