"""Pins, balls and the floating base: their rotations, and the wrench that they transmit.

The bodies outboard of a hinge need the wrench

    moment = A α + B a + moment0        A and M symmetric
    force  = Bᵀ α + M a + force0

for an angular acceleration α and an acceleration a at the hinge, in the frame of the body. A free hinge
transmits only its motor's torque about its axes. Its elimination gives the wrench as a function of the
inboard body's motion. About the hinge's axes this wrench is exactly the torque, so A and B are zero
after a ball, and a row of both is zero after a pin.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from .algebra import (
    Matrix,
    Number,
    Vector,
    add,
    by_lower,
    by_upper,
    dot,
    factors,
    mul,
    neg,
    plus,
    solve_symmetric,
    square,
    sub,
    symmetric,
    times,
    transposed,
    turned,
)


@dataclass
class Wrench:
    a: Matrix
    b: Matrix
    m: Matrix
    moment: Vector
    force: Vector


class Pin:
    """A rotation about an axis k of the frame; i and j are the other axes."""

    def __init__(self, axis: int, sine: Number, cosine: Number, rate: Number, torque: Number):
        self.k, self.i, self.j = axis, (axis + 1) % 3, (axis + 2) % 3
        self.sine, self.cosine = sine, cosine
        self.square, self.product = sine * sine, sine * cosine
        self.rate, self.torque = ([x if i == axis else 0.0 for i in range(3)] for x in (rate, torque))

    def outwards(self, v: Vector) -> Vector:
        """Returns outboard components of a vector in inboard components."""
        return self._turned(v, self.sine)

    def inwards(self, v: Vector) -> Vector:
        return self._turned(v, -self.sine)

    def _turned(self, v: Vector, sine: Number) -> Vector:
        result = list(v)
        result[self.i] = add(mul(self.cosine, v[self.i]), mul(sine, v[self.j]))
        result[self.j] = sub(mul(self.cosine, v[self.j]), mul(sine, v[self.i]))
        return result

    def wrench_inwards(self, w: Wrench) -> Wrench:
        a, b, m = self._matrix(w.a, True), self._matrix(w.b, False), self._matrix(w.m, True)
        return Wrench(a, b, m, self.inwards(w.moment), self.inwards(w.force))

    def _matrix(self, m: Matrix, is_symmetric: bool) -> Matrix:
        """Returns R m Rᵀ; the block of i and j is rotated by the double angle."""
        i, j, k = self.i, self.j, self.k
        difference, both = sub(m[i][i], m[j][j]), add(m[i][j], m[j][i])
        on = add(mul(self.square, difference), mul(self.product, both))
        off = sub(mul(self.product, difference), mul(self.square, both))
        column = self.inwards([row[k] for row in m])
        row = column if is_symmetric else self.inwards(m[k])
        result = [[0.0] * 3 for _ in range(3)]
        for p in (i, j):
            result[p][k], result[k][p] = column[p], row[p]
        result[k][k] = m[k][k]
        result[i][i], result[j][j] = sub(m[i][i], on), add(m[j][j], on)
        result[i][j] = add(m[i][j], off)
        result[j][i] = result[i][j] if is_symmetric else add(m[j][i], off)
        return result

    def tensor_inwards(self, m: Matrix) -> Matrix:
        """Returns a symmetric matrix in inboard components."""
        return self._matrix(m, True)

    def eliminate(self, w: Wrench, bias: Vector) -> Wrench:
        """Eliminates the hinge from a wrench; `bias` is the angular acceleration due to the rates."""
        k, torque = self.k, self.torque[self.k]
        column = [row[k] for row in w.a] + w.b[k]
        inverse = 1.0 / column[k]
        left = sub(torque, w.moment[k])
        self.gain = [mul(x, inverse) for x in column]
        self.own = mul(left, inverse)

        def entry(matrix: Matrix, i: int, j: int) -> Number:
            return 0.0 if k in (i, j) else sub(matrix[i % 3][j % 3], mul(self.gain[i], column[j]))

        a = symmetric(lambda i, j: entry(w.a, i, j))
        b = square(lambda i, j: entry(w.b, i, j + 3))
        m = symmetric(lambda i, j: entry(w.m, i + 3, j + 3))
        moment = [add(w.moment[i], mul(self.gain[i], left), dot(a[i], bias)) for i in range(3)]
        moment[k] = torque
        by_bias = times(transposed(b), bias)
        force = [add(w.force[i], mul(self.gain[i + 3], left), by_bias[i]) for i in range(3)]
        return Wrench(a, b, m, moment, force)

    def accelerate(self, alpha: Vector, a: Vector) -> tuple[Vector, Vector]:
        """Returns the hinge's acceleration and the body's angular acceleration, from α and a without it."""
        k, both = self.k, alpha + a
        others = (mul(self.gain[i], both[i]) for i in range(6) if i != k)
        new = sub(self.own, add(*others))
        return [sub(new, alpha[k])], [new if i == k else alpha[i] for i in range(3)]


class Ball:
    """A rotation by a unit quaternion."""

    def __init__(self, quaternion: Sequence[Number], rate: Vector, torque: Vector):
        w, x, y, z = quaternion
        x2, y2, z2 = x + x, y + y, z + z
        xx, yy, zz = x * x2, y * y2, z * z2
        xy, xz, yz = x * y2, x * z2, y * z2
        wx, wy, wz = w * x2, w * y2, w * z2
        self.rotation = [
            [1.0 - (yy + zz), xy - wz, xz + wy],
            [xy + wz, 1.0 - (xx + zz), yz - wx],
            [xz - wy, yz + wx, 1.0 - (xx + yy)],
        ]
        self.rate, self.torque = rate, torque

    def outwards(self, v: Vector) -> Vector:
        return times(transposed(self.rotation), v)

    def inwards(self, v: Vector) -> Vector:
        return times(self.rotation, v)

    def wrench_inwards(self, w: Wrench) -> Wrench:
        """A and B are zero."""
        m = turned(self.rotation, w.m, symmetric)
        return Wrench(w.a, w.b, m, self.inwards(w.moment), self.inwards(w.force))

    def tensor_inwards(self, m: Matrix) -> Matrix:
        return turned(self.rotation, m, symmetric)

    def eliminate(self, w: Wrench, _bias: Vector) -> Wrench:
        """Eliminates by A = L D Lᵀ: its acceleration is L⁻ᵀ D⁻¹ y with y = L⁻¹ (torque − moment0 − B a)."""
        self.lower, inverse = factors(w.a)
        left = by_lower(self.lower, [sub(self.torque[i], w.moment[i]) for i in range(3)])
        columns = [by_lower(self.lower, column) for column in transposed(w.b)]
        scaled = [list(map(mul, column, inverse)) for column in columns]
        self.own = list(map(mul, left, inverse))
        self.gain = transposed(scaled)
        m = symmetric(lambda i, j: sub(w.m[i][j], dot(scaled[i], columns[j])))
        force = [add(w.force[i], dot(columns[i], self.own)) for i in range(3)]
        zeros = square(lambda _i, _j: 0.0)
        return Wrench(zeros, zeros, m, self.torque, force)

    def accelerate(self, alpha: Vector, a: Vector) -> tuple[Vector, Vector]:
        new = by_upper(self.lower, [sub(self.own[i], dot(self.gain[i], a)) for i in range(3)])
        return [sub(new[i], alpha[i]) for i in range(3)], new


class Floating:
    """A floating base; its rates are the inertial velocity and the angular velocity in its frame."""

    def __init__(self, coordinates: Sequence[Number], rates: Vector, gravity: Vector):
        self.ball = Ball(coordinates[3:], rates[3:], [0.0] * 3)
        self.rate, self.gravity = rates[3:], gravity

    def outwards(self, v: Vector) -> Vector:
        return self.ball.outwards(v)

    def eliminate(self, w: Wrench, _bias: Vector) -> Wrench:
        """Solves for the accelerations with which there is no wrench, by L D Lᵀ of all six rows."""
        both = transposed(w.b)
        matrix = [row + w.b[i] for i, row in enumerate(w.a)] + [both[i] + row for i, row in enumerate(w.m)]
        solved = solve_symmetric(matrix, [neg(x) for x in w.moment + w.force])
        self.alpha, self.a = solved[:3], solved[3:]
        return w

    def accelerate(self) -> Vector:
        """Returns the accelerations of the base; gravity is the acceleration of its frame of reference."""
        return plus(self.ball.inwards(self.a), self.gravity) + self.alpha
