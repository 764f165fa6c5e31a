"""Random states, and their results by Pinocchio from the URDF file.

Pinocchio's free flyer has the quaternion x, y, z, w, the velocity in body axes, and the spatial acceleration: that of the
point less ω × v. Here it has the quaternion w, x, y, z and the velocity in inertial axes.
"""

from __future__ import annotations

import xml.etree.ElementTree as xml
from pathlib import Path

import numpy as np
import pinocchio

from harness.trees.imported import Names

SMOOTHING = {"revolute": 0.1, "continuous": 0.1, "prismatic": 0.01}
"""The `friction_speed` of written texts, by the type of joint."""


class Peer:
    def __init__(self, path: Path, names: Names):
        base = [pinocchio.JointModelFreeFlyer()] if names.base else []
        self.model = pinocchio.buildModelFromUrdf(str(path), *base)
        self.data = self.model.createData()
        self.base = bool(names.base)
        self.ids = [self.model.getJointId(hinge.joint) for hinge in names.hinges]
        if any(index >= self.model.njoints for index in self.ids):
            missing = [hinge.joint for hinge in names.hinges if not self.model.existJointName(hinge.joint)]
            raise ValueError(f"Pinocchio has no joints {', '.join(missing)}")
        count = self.model.njoints - 1 - len(base)
        if count != len(self.ids):
            raise ValueError(f"Pinocchio has {count} joints, the text {len(self.ids)}")
        joints = {joint.get("name"): joint for joint in xml.parse(path).getroot().findall("joint")}
        self.elements = [joints[hinge.joint] for hinge in names.hinges]
        self.places = [self.model.joints[index].idx_v for index in self.ids]

    def states(self, random: np.random.Generator, count: int) -> np.ndarray:
        """Returns coordinates within the limits, rates and efforts."""
        joints, base = len(self.ids), 6 if self.base else 0
        parts = []
        if base:
            quaternions = random.normal(size=(count, 4))
            quaternions /= np.linalg.norm(quaternions, axis=1, keepdims=True)
            parts += [random.uniform(-1, 1, (count, 3)), quaternions]
        ranges = np.array([limits(element) for element in self.elements]).reshape(joints, 2)
        parts.append(random.uniform(ranges[:, 0], ranges[:, 1], (count, joints)))
        parts.append(random.uniform(-2, 2, (count, base + joints)))
        parts += [np.zeros((count, base)), random.uniform(-5, 5, (count, joints))]
        return np.hstack(parts)

    def efforts(self, rates: np.ndarray, efforts: np.ndarray) -> np.ndarray:
        """Returns the efforts of motors, dampers and friction, which `aba` does not have."""
        total = efforts.copy()
        first = len(efforts) - len(self.elements)
        for index, element in enumerate(self.elements):
            dynamics = element.find("dynamics")
            if dynamics is not None:
                damping, friction = (float(dynamics.get(key, "0")) for key in ("damping", "friction"))
                rate, speed = rates[first + index], SMOOTHING[element.get("type", "")]
                total[first + index] -= damping * rate + friction * rate / np.hypot(rate, speed)
        return total

    def solve(self, state: np.ndarray) -> dict[str, np.ndarray]:
        """Returns accelerations, the mass matrix, forces and moments."""
        model, data, first = self.model, self.data, 6 if self.base else 0
        count = first + len(self.ids)
        given_q, given_v, given_efforts = np.split(state, [len(state) - 2 * count, len(state) - count])
        q, v, efforts = pinocchio.neutral(model), np.zeros(model.nv), np.zeros(model.nv)
        for index, angle in zip(self.ids, given_q[7 if self.base else 0 :], strict=True):
            joint = model.joints[index]
            # A continuous joint has cosine and sine of its angle.
            q[joint.idx_q : joint.idx_q + joint.nq] = [angle] if joint.nq == 1 else [np.cos(angle), np.sin(angle)]
        v[self.places], efforts[self.places] = given_v[first:], self.efforts(given_v, given_efforts)[first:]
        turn = np.eye(3)
        if self.base:
            w, x, y, z = given_q[3:7]
            turn = pinocchio.Quaternion(w, x, y, z).toRotationMatrix()
            q[:3], q[3:7] = given_q[:3], (x, y, z, w)
            v[:3], v[3:6] = turn.T @ given_v[:3], given_v[3:6]
        spatial = pinocchio.aba(model, data, q, v, efforts).copy()
        pinocchio.rnea(model, data, q, v, spatial)
        forces = [data.f[index].copy() for index in self.ids]
        pinocchio.forwardKinematics(model, data, q)
        rotations = [data.oMi[index].rotation for index in self.ids]
        matrix = np.array(pinocchio.crba(model, data, q))
        matrix = np.triu(matrix) + np.triu(matrix, 1).T
        order = [*range(first), *self.places]
        accelerations, matrix = spatial[order], matrix[np.ix_(order, order)]
        if self.base:
            accelerations[:3] = turn @ (spatial[:3] + np.cross(v[3:6], v[:3]))
            change = np.eye(count)
            change[:3, :3] = turn.T
            matrix = change.T @ matrix @ change
        return {
            "accelerations": accelerations,
            "mass matrix": matrix,
            "forces": np.array([r @ f.linear for r, f in zip(rotations, forces, strict=True)]).reshape(-1, 3),
            "moments": np.array([r @ f.angular for r, f in zip(rotations, forces, strict=True)]).reshape(-1, 3),
        }


def limits(element: xml.Element) -> list[float]:
    """Returns a range of coordinates that does not reach the limits."""
    large = 0.2 if element.get("type") == "prismatic" else np.pi
    limit = element.find("limit")
    if limit is None or element.get("type") == "continuous":
        return [-large, large]
    low, high = (float(limit.get(key, "0")) for key in ("lower", "upper"))
    if low >= high:
        return [-large, large]
    centre = min(max(0.0, low), high)
    return [max(low, centre - large), min(high, centre + large)]
