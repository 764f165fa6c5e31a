"""Reference accelerations in long doubles, and a check of the reference."""

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
    return q, v, torques


def of(case: Case, q: Array, v: Array, torques: Array) -> Array:
    """Returns the accelerations of all hinges."""
    hinges = q.reshape(-1, 4, q.shape[1]) if case.balls else np.stack([np.sin(q), np.cos(q)], axis=1)
    return np.array(accelerations(case, list(hinges), list(v), list(torques), number=Long))


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


def torque_error(case: Case, q: Array, v: Array, a: Array, torques: Array) -> float:
    """Returns the error of the torques for these accelerations, relative to the largest moment in any
    hinge.

    Uses Newton's and Euler's equations of each body in the inertial frame, independently of the
    recursion.
    """
    count = q.shape[1]
    turn = np.broadcast_to(np.eye(3, dtype=Long)[:, :, None], (3, 3, count))
    omega, alpha = np.zeros((3, count), Long), np.zeros((3, count), Long)
    acceleration = np.zeros((3, count), Long) - np.array(case.gravity, Long)[:, None]
    bodies = []
    place_q = place_v = 0
    for body in case.bodies:
        arm = rotated(turn, np.array(body.position, Long)[:, None])
        acceleration = acceleration + np.cross(alpha, arm, axis=0)
        acceleration = acceleration + np.cross(omega, np.cross(omega, arm, axis=0), axis=0)
        turn = product(turn, np.array(body.rotation, Long)[:, :, None])
        if body.hinge == "ball":
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
        alpha = alpha + own_alpha + np.cross(omega, own_omega, axis=0)
        omega = omega + own_omega
        com = rotated(turn, np.array(body.com, Long)[:, None])
        of_com = acceleration + np.cross(alpha, com, axis=0)
        of_com = of_com + np.cross(omega, np.cross(omega, com, axis=0), axis=0)
        inertia = np.array(body.inertia, Long)[:, :, None]
        world = product(product(turn, inertia), np.swapaxes(turn, 0, 1))
        moment = rotated(world, alpha) + np.cross(omega, rotated(world, omega), axis=0)
        bodies.append((arm, com, Long(body.mass) * of_com, moment, axes))

    force, moment = np.zeros((2, 3, count), Long)
    largest = np.zeros(count, Long)
    taken: list[Array] = []
    for arm, com, own_force, own_moment, axes in reversed(bodies):
        force = force + own_force
        moment = moment + own_moment + np.cross(com, own_force, axis=0)
        taken.insert(0, np.einsum("ijn,in->jn", axes, moment))
        largest = np.maximum(largest, np.abs(moment).max(axis=0))
        # From here on about the inboard body's hinge.
        moment = moment + np.cross(arm, force, axis=0)
    return float((np.abs(np.concatenate(taken) - torques) / largest).max())


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
