"""Accelerations and joint wrenches by Pinocchio, from the URDF file."""

from __future__ import annotations

import numpy as np
import pinocchio

from .robots import Model
from .urdf import Robot


def solve(model: Model, robot: Robot, states: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Returns accelerations, forces and moments for all states, in the order and in the frames of the robot.

    Pinocchio's free flyer has the quaternion x, y, z, w, the velocity in body axes, and the spatial
    acceleration: that of the point less ω × v.
    """
    base = [pinocchio.JointModelFreeFlyer()] if model.floating else []
    pin = pinocchio.buildModelFromUrdf(str(model.path), *base)
    data = pin.createData()
    ids = [pin.getJointId(joint) for joint in robot.joints]
    places_q, places_v = ([getattr(pin.joints[i], name) for i in ids] for name in ("idx_q", "idx_v"))
    # A continuous joint has cosine and sine of its angle.
    unbounded = [pin.joints[i].nq == 2 for i in ids]
    first_q, first_v = (7, 6) if model.floating else (0, 0)
    count = first_v + len(ids)
    results: list[list[np.ndarray]] = [[], [], []]
    for state in states:
        given_q, given_v, given_efforts = np.split(state, [first_q + len(ids), first_q + len(ids) + count])
        q, v, efforts = pinocchio.neutral(pin), np.zeros(pin.nv), np.zeros(pin.nv)
        for place, angle, is_unbounded in zip(places_q, given_q[first_q:], unbounded, strict=True):
            if is_unbounded:
                q[place : place + 2] = np.cos(angle), np.sin(angle)
            else:
                q[place] = angle
        v[places_v], efforts[places_v] = given_v[first_v:], given_efforts[first_v:]
        if model.floating:
            w, x, y, z = given_q[3:7]
            turn = pinocchio.Quaternion(w, x, y, z).toRotationMatrix()
            q[:3], q[3:7] = given_q[:3], (x, y, z, w)
            v[:3], v[3:6] = turn.T @ given_v[:3], given_v[3:6]
        spatial = pinocchio.aba(pin, data, q, v, efforts).copy()
        pinocchio.rnea(pin, data, q, v, spatial)
        pinocchio.forwardKinematics(pin, data, q)
        accelerations = spatial[places_v]
        if model.floating:
            linear = turn @ (spatial[:3] + np.cross(v[3:6], v[:3]))
            accelerations = np.concatenate([linear, spatial[3:6], accelerations])
        results[0].append(accelerations)
        results[1].append(np.array([data.oMi[i].rotation @ data.f[i].linear for i in ids]))
        results[2].append(np.array([data.oMi[i].rotation @ data.f[i].angular for i in ids]))
    accelerations, forces, moments = map(np.array, results)
    return accelerations, forces, moments
