"""Reference accelerations in long doubles, and a check of the reference."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from .cases import Case
from .recursion import accelerations

Array = np.ndarray[Any, np.dtype[Any]]
Long = np.longdouble


def parts(case: Case, states: Array) -> tuple[Array, Array, Array]:
    """Coordinates, rates and torques: a row for each number, a column for each state."""
    columns = states.astype(Long).T
    q, v, torques = np.split(columns, [case.coordinates, case.coordinates + case.rates])
    if case.balls:
        # They have unit length up to rounding in double precision.
        quaternions = q.reshape(-1, 4, q.shape[1])
        q = (quaternions / np.sqrt((quaternions**2).sum(axis=1, keepdims=True))).reshape(q.shape)
    if case.floating:
        q[3:7] /= np.sqrt((q[3:7] ** 2).sum(axis=0))
    return q, v, torques


def of(case: Case, q: Array, v: Array, torques: Array) -> Array:
    """Returns the accelerations of all hinges."""
    hinges: list[Any]
    if case.balls:
        hinges = list(q.reshape(-1, 4, q.shape[1]))
    else:
        angles = q[7:] if case.floating else q
        hinges = list(np.stack([np.sin(angles), np.cos(angles)], axis=1))
        hinges = [q[:7], *hinges] if case.floating else hinges
    return np.array(accelerations(case, hinges, list(v), list(torques), number=Long))


def after_step(case: Case, q: Array, v: Array, torques: Array, step: float) -> Array:
    """Returns the rates after a step of the classical Runge–Kutta method."""
    h = Long(step)
    sums = [np.zeros_like(q), np.zeros_like(v)]
    rates = coordinate_rates(case, q, v), of(case, q, v, torques)
    for weight, way in ((1, h / 2), (2, h / 2), (2, h), (1, h)):
        sums = [total + weight * rate for total, rate in zip(sums, rates, strict=True)]
        # Like the contenders, which normalise quaternions only after the step.
        at_q, at_v = q + way * rates[0], v + way * rates[1]
        rates = coordinate_rates(case, at_q, at_v), of(case, at_q, at_v, torques)
    return v + h / 6 * sums[1]


def coordinate_rates(case: Case, q: Array, v: Array) -> Array:
    if not case.balls:
        return v
    w, x, y, z = np.moveaxis(q.reshape(-1, 4, q.shape[1]), 1, 0)
    a, b, c = np.moveaxis(v.reshape(-1, 3, v.shape[1]), 1, 0)
    rate = [-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a]
    return (np.stack(rate, axis=1) / 2).reshape(q.shape)


def check(case: Case, q: Array, v: Array, accelerations: Array, torques: Array) -> None:
    """Checks by the torques that the relative error of the accelerations is below 10⁻¹⁴."""
    change = 1e-9
    left = torque_error(case, q, v, accelerations, torques)
    seen = torque_error(case, q, v, accelerations * (1 + change), torques)
    assert left < 1e-14 / change * seen, f"the reference of {case.name} is wrong"


@dataclass
class Moving:
    """A body in motion, in inertial components; rows for components, columns for states."""

    turn: Array
    arm: Array
    """From the inboard body's hinge to this body's hinge."""
    omega: Array
    alpha: Array
    acceleration: Array
    """Of the hinge, relative to a frame that falls freely."""
    axes: Array
    """Of the hinge's rotations."""
    force: Array
    moment: Array
    """The wrench of this body and the bodies outboard of it, about the hinge."""


def torque_error(case: Case, q: Array, v: Array, a: Array, torques: Array) -> float:
    """Returns the error of the torques for these accelerations, relative to the largest moment in any
    hinge, and with a floating base also that of its force, relative to the largest force.

    Uses Newton's and Euler's equations of each body in the inertial frame, independently of the
    recursion.
    """
    count = q.shape[1]
    zero, falling = np.zeros((3, count), Long), np.array(case.gravity, Long)[:, None]
    upright = np.broadcast_to(np.eye(3, dtype=Long)[:, :, None], (3, 3, count))
    ground = Moving(upright, zero, zero, zero, zero - falling, zero, zero, zero)
    bodies: list[Moving] = []
    place_q = place_v = 0
    for body in case.bodies:
        outer = ground if body.parent is None else bodies[body.parent]
        arm = rotated(outer.turn, np.array(body.position, Long)[:, None])
        acceleration = outer.acceleration + swung(outer, arm)
        turn = product(outer.turn, np.array(body.rotation, Long)[:, :, None])
        if body.hinge == "floating":
            acceleration = a[:3] - falling
            place_q, place_v = 3, 3
        if body.hinge in ("ball", "floating"):
            turn = product(turn, rotation(q[place_q : place_q + 4]))
            axes, size = turn, 4
        else:
            axis = np.array([float(name == body.hinge) for name in "xyz"], Long)[:, None]
            turn = product(turn, about(axis, q[place_q]))
            axes, size = rotated(turn, axis)[:, None], 1
        rates = slice(place_v, place_v + axes.shape[1])
        place_q, place_v = place_q + size, rates.stop
        own_omega = np.einsum("ijn,jn->in", axes, v[rates])
        own_alpha = np.einsum("ijn,jn->in", axes, a[rates])
        alpha = outer.alpha + own_alpha + np.cross(outer.omega, own_omega, axis=0)
        moving = Moving(turn, arm, outer.omega + own_omega, alpha, acceleration, axes, zero, zero)
        bodies.append(moving)
        com = rotated(turn, np.array(body.com, Long)[:, None])
        moving.force = Long(body.mass) * (acceleration + swung(moving, com))
        inertia = np.array(body.inertia, Long)[:, :, None]
        world = product(product(turn, inertia), np.swapaxes(turn, 0, 1))
        gyroscopic = np.cross(moving.omega, rotated(world, moving.omega), axis=0)
        moving.moment = rotated(world, alpha) + gyroscopic + np.cross(com, moving.force, axis=0)

    largest = largest_force = np.zeros(count, Long)
    required: list[Array] = []
    for body, moving in zip(reversed(case.bodies), reversed(bodies), strict=True):
        required.insert(0, np.einsum("ijn,in->jn", moving.axes, moving.moment))
        largest = np.maximum(largest, np.abs(moving.moment).max(axis=0))
        largest_force = np.maximum(largest_force, np.abs(moving.force).max(axis=0))
        if body.parent is not None:
            outer = bodies[body.parent]
            outer.force = outer.force + moving.force
            outer.moment = outer.moment + moving.moment + np.cross(moving.arm, moving.force, axis=0)
    scales = [np.broadcast_to(largest, torques.shape)]
    if case.floating:
        required.insert(0, bodies[0].force)
        scales = [np.broadcast_to(largest_force, (3, count)), scales[0][3:]]
    return float((np.abs(np.concatenate(required) - torques) / np.concatenate(scales)).max())


def swung(body: Moving, arm: Array) -> Array:
    """Returns the acceleration of a point of a body relative to its hinge."""
    centripetal = np.cross(body.omega, np.cross(body.omega, arm, axis=0), axis=0)
    return np.asarray(np.cross(body.alpha, arm, axis=0) + centripetal)


def rotated(turn: Array, v: Array) -> Array:
    result: Array = np.einsum("ijn,jn->in", turn, np.broadcast_to(v, (3, turn.shape[2])))
    return result


def product(a: Array, b: Array) -> Array:
    result: Array = np.einsum("ijn,jkn->ikn", a, np.broadcast_to(b, (3, 3, a.shape[2])))
    return result


def about(axis: Array, angle: Array) -> Array:
    """Returns the rotation about an axis of the frame, from the quaternion of half the angle."""
    return rotation(np.concatenate([np.cos(angle / 2)[None], axis * np.sin(angle / 2)]))


def rotation(quaternion: Array) -> Array:
    """Returns the rotation of a unit quaternion, by w² + x² − y² − z² and so on."""
    w, x, y, z = quaternion
    return np.array(
        [
            [w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z],
        ]
    )
