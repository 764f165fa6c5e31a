"""Results of other tools in the conventions of this library.

They differ for a floating base: its rates are the inertial velocity and the angular velocity in its frame;
Pinocchio has the velocity in the frame, too, and accelerations without ω × v. The tangent of the coordinates
is along the rates in both. MuJoCo has the conventions of this library.
"""

from dataclasses import replace

import numpy as np

from .. import reference
from ..cases import Case
from ..reference import Array, rotation
from .inverse import inverse_dynamics
from .questions import States

DYNIBO_GRAVITY = 9.80665
"""In m/s²."""

BASE = slice(0, 3)
TURN = slice(3, 6)


class Pinocchio:
    """Converts results of `answers_pinocchio.cpp`; the first index is that of the state."""

    def __init__(self, case: Case, states: States):
        self.case, self.states, self.n = case, states, case.rates
        if case.floating:
            q, v, a = states.q, states.v, states.accelerations
            self.r = np.moveaxis(rotation(q[:, 3:7].T), 2, 0)
            self.omega = v[:, TURN]
            self.v = along(self.r, v[:, BASE])
            self.a = along(self.r, a[:, BASE])
            self.axes = np.broadcast_to(np.eye(self.n), (len(q), self.n, self.n)).copy()
            self.axes[:, BASE, BASE] = self.r

    def convert(self, question: str, results: Array) -> Array:
        convert = getattr(self, question)
        converted: Array = convert(results).reshape(len(results), -1)
        return converted

    def accelerations(self, results: Array) -> Array:
        if not self.case.floating:
            return results
        drift = np.cross(self.omega, self.v)
        results = results.copy()
        results[:, BASE] += drift
        return self.rotated(results)

    def inverse_dynamics(self, results: Array) -> Array:
        return self.rotated(results)

    def bias_efforts(self, results: Array) -> Array:
        """Accelerations that are zero here are −ω × v there."""
        efforts, m = results[:, : self.n], self.square(results[:, self.n :])
        if not self.case.floating:
            return efforts
        drift = np.cross(self.omega, self.v)
        return self.rotated(efforts - np.einsum("sij,sj->si", m[:, :, BASE], drift))

    def mass_matrix(self, results: Array) -> Array:
        return self.both(self.square(results))

    def inverse_mass_matrix(self, results: Array) -> Array:
        return self.both(self.square(results))

    def coriolis_matrix(self, results: Array) -> Array:
        """The rates of the base are in rotating axes there: C becomes A (C Aᵀ + M d(Aᵀ)/dt)."""
        c, m = np.moveaxis(results.reshape(-1, 2, self.n, self.n), 1, 0)
        if not self.case.floating:
            return np.asarray(c)
        change = np.zeros_like(m)
        change[:, BASE, BASE] = -skew(self.omega) @ np.swapaxes(self.r, 1, 2)
        return np.asarray(self.both(c) + self.axes @ m @ change)

    def jacobian(self, results: Array) -> Array:
        matrix = results.reshape(len(results), 6, self.n)
        return matrix @ np.swapaxes(self.axes, 1, 2) if self.case.floating else matrix

    def regressor(self, results: Array) -> Array:
        """The parameters of a body are m, h, xx, xy, yy, xz, yz and zz; here xx, yy, zz, xy, xz, yz."""
        matrix = results.reshape(len(results), self.n, -1, 10)[..., [0, 1, 2, 3, 4, 6, 9, 5, 7, 8]]
        matrix = matrix.reshape(len(results), self.n, -1)
        return np.asarray(self.axes @ matrix) if self.case.floating else matrix

    def derivatives(self, results: Array) -> Array:
        """By coordinates, rates and accelerations, without the efforts."""
        by_q, by_v, m = np.moveaxis(results[:, : -self.n].reshape(-1, 3, self.n, self.n), 1, 0)
        force = results[:, -self.n :][:, BASE]
        if self.case.floating:
            moved = by_v @ self.turned(self.v)
            moved += m @ (self.turned(self.a) - self.carried(self.turned(self.v)))
            by_q = self.both(by_q) + self.axes @ (moved - self.turned(force))
            by_v = self.both(by_v) - self.axes @ m @ self.drift_by_rates()
            m = self.both(m)
        return np.concatenate([by_q, by_v, m], axis=1)

    def linearize(self, results: Array) -> Array:
        """By coordinates, rates and the efforts of the hinges, then the accelerations."""
        by_q, by_v, by_efforts = np.moveaxis(results[:, : -self.n].reshape(-1, 3, self.n, self.n), 1, 0)
        a = self.accelerations(results[:, -self.n :])
        if self.case.floating:
            inertial = along(self.r, a[:, BASE])
            moved = by_v @ self.turned(self.v) + self.carried(self.turned(self.v)) - self.turned(inertial)
            by_q = self.both(by_q) + self.axes @ moved
            by_v = self.both(by_v) + self.axes @ self.drift_by_rates()
            by_efforts = self.both(by_efforts)[:, :, 6:]
        flat = (matrix.reshape(len(results), -1) for matrix in (by_q, by_v, by_efforts))
        return np.concatenate([*flat, a], axis=1)

    def square(self, results: Array) -> Array:
        return results.reshape(-1, self.n, self.n)

    def rotated(self, vectors: Array) -> Array:
        """Returns vectors with the base's linear components in inertial axes."""
        if not self.case.floating:
            return vectors
        return np.asarray(np.einsum("sij,sj->si", self.axes, vectors))

    def both(self, matrices: Array) -> Array:
        """Converts rows and columns."""
        if not self.case.floating:
            return matrices
        return np.asarray(self.axes @ matrices @ np.swapaxes(self.axes, 1, 2))

    def turned(self, vectors: Array) -> Array:
        """Returns the change of inertial vectors' components in the base's frame due to its rotation."""
        result = np.zeros((len(vectors), self.n, self.n))
        result[:, BASE, TURN] = skew(vectors)
        return result

    def carried(self, matrices: Array) -> Array:
        """Returns ω × of the base's linear components."""
        result = np.zeros_like(matrices)
        result[:, BASE] = skew(self.omega) @ matrices[:, BASE]
        return result

    def drift_by_rates(self) -> Array:
        """Returns the derivative of ω × v by the rates."""
        result = np.zeros((len(self.omega), self.n, self.n))
        result[:, BASE, BASE] = skew(self.omega) @ np.swapaxes(self.r, 1, 2)
        result[:, BASE, TURN] = -skew(self.v)
        return result


def mujoco(case: Case, question: str, results: Array, step: float) -> Array:
    """Derivatives of inverse dynamics are transposed; those of accelerations are in the matrix of a step.

    The rates after a step of the semi-implicit Euler method are v + step · accelerations.
    """
    n = case.rates
    if question == "derivatives":
        matrices = np.swapaxes(results.reshape(-1, 3, n, n), 2, 3)
        return matrices.reshape(len(results), -1)
    if question == "linearize":
        rows = results.reshape(-1, 2 * n, 2 * n)[:, n:]
        by_q, by_v = rows[:, :, :n] / step, (rows[:, :, n:] - np.eye(n)) / step
        return np.concatenate([by_q.reshape(len(rows), -1), by_v.reshape(len(rows), -1)], axis=1)
    return results


def dynibo(case: Case, question: str, states: States, results: Array) -> Array:
    """Matrices are stored by columns, a Jacobian has the angular rows first, and gravity cannot be changed."""
    if question == "jacobian":
        matrices = np.swapaxes(results.reshape(-1, case.rates, 6), 1, 2)
        return np.roll(matrices, 3, axis=1).reshape(len(results), -1)
    if question in ("accelerations", "inverse_dynamics"):
        other = replace(case, gravity=(0.0, 0.0, -DYNIBO_GRAVITY))
        return results + in_long_doubles(case, question, states) - in_long_doubles(other, question, states)
    return results


def in_long_doubles(case: Case, question: str, states: States) -> Array:
    """Returns accelerations or efforts of an arm by the recursions of this folder."""
    q, v, efforts, given = (
        x.T.astype(np.longdouble) for x in (states.q, states.v, states.efforts, states.accelerations)
    )
    if question == "accelerations":
        return reference.of(case, q, v, efforts).T
    hinges = list(np.stack([np.sin(q), np.cos(q)], axis=1))
    return np.array(inverse_dynamics(case, hinges, list(v), list(given), number=np.longdouble)).T


def along(rotations: Array, vectors: Array) -> Array:
    """Returns inertial vectors in the axes of a frame."""
    return np.asarray(np.einsum("sji,sj->si", rotations, vectors))


def skew(vectors: Array) -> Array:
    x, y, z = vectors.T
    zero = np.zeros_like(x)
    return np.moveaxis(np.array([[zero, -z, y], [z, zero, -x], [-y, x, zero]]), 2, 0)
