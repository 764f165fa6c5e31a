"""Accelerations and joint wrenches of a tree with fifty digits, by Kane's equations in the inertial frame.

The mass matrix is dense, so nothing is shared with recursive methods.
"""

from __future__ import annotations

from dataclasses import dataclass

from mpmath import mp, mpf

from .urdf import Matrix, Robot, Vector, plus, product, rotation, times, transposed

GRAVITY = [mpf(0), mpf(0), mpf("-9.81")]


@dataclass
class Moving:
    """A body in motion; all vectors have inertial components."""

    position: Vector
    rotation: Matrix
    omega: Vector
    alpha: Vector
    """The angular acceleration, at first the one without accelerations of the hinges."""
    acceleration: Vector
    """Of the body's origin, in the same way."""
    arm: Vector
    """From the origin to the centre of mass."""
    inertia: Matrix
    """About the centre of mass."""
    columns: dict[int, tuple[Vector, Vector]]
    """For each rate that moves the body: its angular velocity, and the velocity of its origin."""

    def of_com(self) -> Vector:
        """Returns the acceleration of the centre of mass."""
        return plus(self.acceleration, swung(self.omega, self.alpha, self.arm))


@dataclass(frozen=True)
class Result:
    accelerations: list[mpf]
    forces: list[Vector]
    """For each joint, the force on the outboard body, in inertial axes."""
    moments: list[Vector]
    """The same for the moment on the outboard body, about its origin."""


def solve(robot: Robot, q: list[mpf], v: list[mpf], efforts: list[mpf]) -> Result:
    """Returns the results for coordinates, rates and efforts in the order of the bodies.

    A floating base has position, quaternion (w, x, y, z), inertial velocity and body angular velocity.
    """
    bodies = moving(robot, q, v)
    count = len(v)
    mass, right = mp.zeros(count), mp.matrix(efforts)
    for described, body in zip(robot.bodies, bodies, strict=True):
        m = described.mass.mass
        force, moment = inertial_wrench(m, body)
        speeds = {rate: (w, plus(u, cross(w, body.arm))) for rate, (w, u) in body.columns.items()}
        for i, (w, u) in speeds.items():
            right[i] -= dot(w, moment) + dot(u, force)
            spun = times(body.inertia, w)
            for j, (other_w, other_u) in speeds.items():
                mass[i, j] += m * dot(u, other_u) + dot(spun, other_w)
    solved = list(mp.lu_solve(mass, right))

    for body in bodies:
        for rate, (w, u) in body.columns.items():
            body.alpha = plus(body.alpha, scaled(solved[rate], w))
            body.acceleration = plus(body.acceleration, scaled(solved[rate], u))
    forces: list[Vector] = [[mpf(0)] * 3 for _ in bodies]
    moments: list[Vector] = [[mpf(0)] * 3 for _ in bodies]
    for index in reversed(range(len(bodies))):
        described, body = robot.bodies[index], bodies[index]
        force, moment = inertial_wrench(described.mass.mass, body)
        forces[index] = plus(forces[index], force)
        moments[index] = plus(moments[index], moment, cross(body.arm, force))
        if (parent := described.parent) is not None:
            lever = minus(body.position, bodies[parent].position)
            forces[parent] = plus(forces[parent], forces[index])
            moments[parent] = plus(moments[parent], moments[index], cross(lever, forces[index]))
    start = 1 if robot.floating else 0
    return Result(solved, forces[start:], moments[start:])


def moving(robot: Robot, q: list[mpf], v: list[mpf]) -> list[Moving]:
    """Returns the bodies with their accelerations at zero accelerations of the hinges."""
    zero = [mpf(0)] * 3
    bodies: list[Moving] = []
    rate = 0
    for described in robot.bodies:
        mass = described.mass
        if described.kind == "floating":
            turn = of_quaternion(q[3:7])
            omega = times(turn, v[3:6])
            unit = transposed(turn)
            columns = {i: (zero, [mpf(i == j) for j in range(3)]) for i in range(3)}
            columns |= {3 + i: (unit[i], zero) for i in range(3)}
            position, alpha, acceleration = q[:3], zero, zero
            rate = 6
        else:
            coordinate, speed = q[rate + 1 if robot.floating else rate], v[rate]
            parent = bodies[described.parent] if described.parent is not None else None
            outer = parent.rotation if parent else rotation([mpf(0)] * 3)
            outer_omega, outer_alpha = (parent.omega, parent.alpha) if parent else (zero, zero)
            fixed = product(outer, described.frame.rotation)
            length = mp.sqrt(dot(described.axis, described.axis))
            own_axis = scaled(1 / length, described.axis)
            axis = times(fixed, own_axis)
            arm = times(outer, described.frame.position)
            columns = dict(parent.columns) if parent else {}
            omega, alpha, turn = outer_omega, outer_alpha, fixed
            turning = cross(outer_omega, scaled(speed, axis))
            if described.kind == "slider":
                arm = plus(arm, scaled(coordinate, axis))
            columns = {i: (w, plus(u, cross(w, arm))) for i, (w, u) in columns.items()}
            position = plus(parent.position if parent else zero, arm)
            acceleration = plus(parent.acceleration if parent else zero, swung(outer_omega, outer_alpha, arm))
            if described.kind == "slider":
                acceleration = plus(acceleration, scaled(mpf(2), turning))
                columns[rate] = (zero, axis)
            else:
                omega, alpha = plus(omega, scaled(speed, axis)), plus(alpha, turning)
                turn = product(fixed, about(own_axis, coordinate))
                columns[rate] = (axis, zero)
            rate += 1
        inertia = product(product(turn, mass.inertia), transposed(turn))
        arm = times(turn, mass.com)
        bodies.append(Moving(position, turn, omega, alpha, acceleration, arm, inertia, columns))
    return bodies


def inertial_wrench(mass: mpf, body: Moving) -> tuple[Vector, Vector]:
    """Returns the force and the moment about the centre of mass that this motion needs."""
    force = scaled(mass, minus(body.of_com(), GRAVITY))
    gyroscopic = cross(body.omega, times(body.inertia, body.omega))
    return force, plus(times(body.inertia, body.alpha), gyroscopic)


def swung(omega: Vector, alpha: Vector, arm: Vector) -> Vector:
    """Returns the acceleration of a point of a body relative to another point of it."""
    return plus(cross(alpha, arm), cross(omega, cross(omega, arm)))


def of_quaternion(quaternion: list[mpf]) -> Matrix:
    length = mp.sqrt(dot(quaternion, quaternion))
    w, *axis = (x / length for x in quaternion)
    return rodrigues(axis, w)


def about(axis: Vector, angle: mpf) -> Matrix:
    return rodrigues(scaled(mp.sin(angle / 2), axis), mp.cos(angle / 2))


def rodrigues(axis: Vector, w: mpf) -> Matrix:
    """Returns the rotation of the unit quaternion w, axis: 1 + 2 w [axis] + 2 [axis]²."""
    units = [[mpf(i == j) for j in range(3)] for i in range(3)]
    turned = [cross(axis, unit) for unit in units]
    columns = [
        plus(unit, scaled(2 * w, once), scaled(mpf(2), cross(axis, once)))
        for unit, once in zip(units, turned, strict=True)
    ]
    return transposed(columns)


def cross(a: Vector, b: Vector) -> Vector:
    return [a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))]


def dot(a: Vector, b: Vector) -> mpf:
    return sum((x * y for x, y in zip(a, b, strict=True)), mpf(0))


def minus(a: Vector, b: Vector) -> Vector:
    return [x - y for x, y in zip(a, b, strict=True)]


def scaled(factor: mpf, v: Vector) -> Vector:
    return [factor * x for x in v]
