"""Articulated bodies, written as well as one would write them by hand for one mechanism.

The same lines make CasADi's expressions and, with arrays of long doubles, the accelerations that all
contenders are held against. Numbers of a mechanism are plain floats, so that its zeros vanish: a sum
or product with a float zero in it is not formed.

Everything of a body is in its own frame, about its hinge. What a body and all beyond it ask of its
hinge is the wrench

    moment = A α + B a + moment0        A and M symmetric, their upper halves kept
    force  = Bᵀ α + M a + force0

for an angular acceleration α and an acceleration a of the hinge. Weight is left away: the ground
falls upwards instead. A hinge that moves freely takes from this what it cannot transmit, exactly: after
a ball A and B are zero, after a pin a row of both.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from .cases import Body, Case

Number = Any
"""A float, an expression, or an array."""
Vector = list[Number]
Matrix = list[list[Number]]


def is_zero(x: Number) -> bool:
    return isinstance(x, float) and x == 0.0


def mul(a: Number, b: Number) -> Number:
    if is_zero(a) or is_zero(b):
        return 0.0
    for one, other in ((a, b), (b, a)):
        if isinstance(one, float) and abs(one) == 1.0:
            return other if one == 1.0 else -other
    return a * b


def add(*terms: Number) -> Number:
    """A sum from left to right."""
    left = [term for term in terms if not is_zero(term)]
    return sum(left[1:], start=left[0]) if left else 0.0


def sub(a: Number, b: Number) -> Number:
    return a if is_zero(b) else -b if is_zero(a) else a - b


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    return add(*(mul(x, y) for x, y in zip(a, b)))


def plus(*vectors: Vector) -> Vector:
    return [add(*entries) for entries in zip(*vectors)]


def cross(a: Sequence[Number], b: Sequence[Number]) -> Vector:
    return [sub(mul(a[i], b[j]), mul(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def times(m: Matrix, v: Sequence[Number]) -> Vector:
    return [dot(row, v) for row in m]


def transposed(m: Matrix) -> Matrix:
    return [list(column) for column in zip(*m)]


def symmetric(entry) -> Matrix:
    """From its upper half, so that both halves are the same numbers."""
    upper = {(i, j): entry(i, j) for i in range(3) for j in range(i, 3)}
    return [[upper[min(i, j), max(i, j)] for j in range(3)] for i in range(3)]


ZEROS: Matrix = [[0.0] * 3 for _ in range(3)]


class Pin:
    """A turn about an axis of the frame, and the two axes that it turns."""

    def __init__(self, axis: int, sine: Number, cosine: Number):
        self.k, self.i, self.j = axis, (axis + 1) % 3, (axis + 2) % 3
        self.sine, self.cosine = sine, cosine
        self.square, self.product = sine * sine, sine * cosine

    def outwards(self, v: Vector) -> Vector:
        """Inboard components into outboard ones."""
        return self._turned(v, self.sine)

    def inwards(self, v: Vector) -> Vector:
        return self._turned(v, -self.sine)

    def _turned(self, v: Vector, sine: Number) -> Vector:
        result = list(v)
        result[self.i] = add(mul(self.cosine, v[self.i]), mul(sine, v[self.j]))
        result[self.j] = sub(mul(self.cosine, v[self.j]), mul(sine, v[self.i]))
        return result

    def matrix_inwards(self, m: Matrix, is_symmetric: bool) -> Matrix:
        """R m Rᵀ. The part of its block that a turn changes is turned by twice the angle."""
        i, j, k = self.i, self.j, self.k
        difference, sum_ = sub(m[i][i], m[j][j]), add(m[i][j], m[j][i])
        shift = add(mul(self.square, difference), mul(self.product, sum_))
        skew = sub(mul(self.product, difference), mul(self.square, sum_))
        column = self.inwards([row[k] for row in m])
        row = column if is_symmetric else self.inwards(m[k])
        result = [[0.0] * 3 for _ in range(3)]
        for p in (i, j):
            result[p][k], result[k][p] = column[p], row[p]
        result[k][k] = m[k][k]
        result[i][i], result[j][j] = sub(m[i][i], shift), add(m[j][j], shift)
        result[i][j] = add(m[i][j], skew)
        result[j][i] = result[i][j] if is_symmetric else add(m[j][i], skew)
        return result


class Ball:
    """A turn by a unit quaternion."""

    def __init__(self, quaternion: Sequence[Number]):
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

    def outwards(self, v: Vector) -> Vector:
        return times(transposed(self.rotation), v)

    def inwards(self, v: Vector) -> Vector:
        return times(self.rotation, v)

    def matrix_inwards(self, m: Matrix, is_symmetric: bool) -> Matrix:
        """R m Rᵀ, of a symmetric matrix: there is no other beyond a ball."""
        assert is_symmetric
        half = [self.inwards(row) for row in m]
        return symmetric(lambda i, j: dot(self.rotation[i], [row[j] for row in half]))


@dataclass
class Wrench:
    """What a body and all beyond it ask of its hinge, as above."""

    a: Matrix
    b: Matrix
    m: Matrix
    moment: Vector
    force: Vector


class Link:
    """A body on its way through the three sweeps."""

    def __init__(self, body: Body, hinge: Pin | Ball, rate: Vector, inertial: "Inertial"):
        self.body, self.hinge, self.rate, self.inertial = body, hinge, rate, inertial

    def outwards(self, v: Vector) -> Vector:
        """Components of the body before into those of this one."""
        constant = [list(row) for row in self.body.rotation]
        return self.hinge.outwards(times(transposed(constant), v))

    def velocities(self, omega_before: Vector, before: "Link | None") -> None:
        """The angular velocity, and what it alone accelerates."""
        carried = self.outwards(omega_before)
        self.omega = plus(carried, self.rate)
        self.drift = cross(carried, self.rate)
        x, y, z = self.omega
        xx, yy, zz = mul(x, x), mul(y, y), mul(z, z)
        xy, xz, yz = mul(x, y), mul(x, z), mul(y, z)
        # The acceleration of a point is `centripetal` times its way from the hinge.
        self.centripetal = [
            [-add(yy, zz) if not is_zero(add(yy, zz)) else 0.0, xy, xz],
            [xy, -add(xx, zz) if not is_zero(add(xx, zz)) else 0.0, yz],
            [xz, yz, -add(xx, yy) if not is_zero(add(xx, yy)) else 0.0],
        ]
        own = self.inertial
        j = own.j
        self.wrench = Wrench(
            [list(row) for row in j],
            [list(row) for row in own.b],
            [[own.mass if i == k else 0.0 for k in range(3)] for i in range(3)],
            # ω × J ω by the products of ω.
            [
                add(
                    mul(yz, sub(j[2][2], j[1][1])),
                    mul(sub(yy, zz), j[1][2]),
                    mul(xy, j[0][2]),
                    mul(-xz if not is_zero(xz) else 0.0, j[0][1]),
                ),
                add(
                    mul(xz, sub(j[0][0], j[2][2])),
                    mul(sub(zz, xx), j[0][2]),
                    mul(yz, j[0][1]),
                    mul(-xy if not is_zero(xy) else 0.0, j[1][2]),
                ),
                add(
                    mul(xy, sub(j[1][1], j[0][0])),
                    mul(sub(xx, yy), j[0][1]),
                    mul(xz, j[1][2]),
                    mul(-yz if not is_zero(yz) else 0.0, j[0][2]),
                ),
            ],
            times(self.centripetal, own.moments),
        )
        arm = list(self.body.position)
        self.arm_drift = times(before.centripetal, arm) if before else [0.0] * 3

    def release(self, torque: Vector) -> Wrench:
        """Lets the hinge move under its torque: the wrench for what the body before does alone."""
        is_pin = isinstance(self.hinge, Pin)
        self.released = self._release_pin(torque) if is_pin else self._release_ball(torque)
        return self.released

    def _release_pin(self, torque: Vector) -> Wrench:
        w, k = self.wrench, self.hinge.k
        column = [w.a[i][k] for i in range(3)] + [w.b[k][i] for i in range(3)]
        inverse = 1.0 / column[k]
        gain = [mul(x, inverse) for x in column]
        left = sub(torque[k], w.moment[k])
        self.gain, self.own = gain, mul(left, inverse)

        def reduced(i: int, j: int) -> Number:
            block = (w.a, w.b, w.m)[(i >= 3) + (j >= 3)]
            entry = block[i % 3][j % 3]
            # Exactly: the hinge transmits no moment about its axis.
            return 0.0 if k in (i, j) else sub(entry, mul(gain[i], column[j]))

        a = symmetric(reduced)
        b = [[reduced(i, j + 3) for j in range(3)] for i in range(3)]
        m = symmetric(lambda i, j: reduced(i + 3, j + 3))
        drift = self.drift
        moment = [
            torque[k] if i == k else add(w.moment[i], mul(gain[i], left), dot(a[i], drift))
            for i in range(3)
        ]
        force = [
            add(w.force[i], mul(gain[i + 3], left), dot([b[j][i] for j in range(3)], drift))
            for i in range(3)
        ]
        return Wrench(a, b, m, moment, force)

    def _release_ball(self, torque: Vector) -> Wrench:
        """By L D Lᵀ of A: with y = L⁻¹ (τ − moment0 − B a) the angular acceleration is L⁻ᵀ D⁻¹ y."""
        w = self.wrench
        lower, inverse = factors(w.a)
        left = forwards(lower, [sub(torque[i], w.moment[i]) for i in range(3)])
        columns = [forwards(lower, [w.b[i][j] for i in range(3)]) for j in range(3)]
        scaled = [[mul(columns[j][i], inverse[i]) for i in range(3)] for j in range(3)]
        self.lower = lower
        self.own = [mul(left[i], inverse[i]) for i in range(3)]
        self.gain = [[scaled[j][i] for j in range(3)] for i in range(3)]
        m = symmetric(lambda i, j: sub(w.m[i][j], dot(scaled[i], columns[j])))
        force = [add(w.force[i], dot(columns[i], self.own)) for i in range(3)]
        return Wrench(ZEROS, ZEROS, m, torque, force)

    def add_to(self, before: "Link", w: Wrench) -> None:
        """Hands a released wrench on to the body before."""
        hinge, fixed = self.hinge, [list(row) for row in self.body.rotation]
        is_pin = isinstance(hinge, Pin)
        a = turned(fixed, hinge.matrix_inwards(w.a, True), True) if is_pin else ZEROS
        b = turned(fixed, hinge.matrix_inwards(w.b, False), False) if is_pin else ZEROS
        m = turned(fixed, hinge.matrix_inwards(w.m, True), True)
        moment, force = (times(fixed, hinge.inwards(v)) for v in (w.moment, w.force))
        # The way to this hinge, about whose end all of it was until now.
        arm, drift = list(self.body.position), self.arm_drift
        force = plus(force, times(m, drift))
        moment = plus(moment, times(b, drift), cross(arm, force))
        arm_b = transposed([cross(arm, column) for column in m])
        moved = [[add(b[i][j], arm_b[i][j]) for j in range(3)] for i in range(3)]
        b_arm = [[-x if not is_zero(x) else x for x in cross(arm, row)] for row in b]
        arm_moved = transposed([cross(arm, row) for row in moved])
        to = before.wrench
        to.a = symmetric(lambda i, j: add(to.a[i][j], sub(a[i][j], b_arm[i][j]), arm_moved[i][j]))
        to.b = [[add(to.b[i][j], moved[i][j]) for j in range(3)] for i in range(3)]
        to.m = symmetric(lambda i, j: add(to.m[i][j], m[i][j]))
        to.moment, to.force = plus(to.moment, moment), plus(to.force, force)

    def accelerate(self, alpha: Vector, a: Vector) -> tuple[Vector, Vector, Vector]:
        """The hinge's acceleration, and α and a of the body, from those of the body before."""
        a = plus(a, cross(alpha, self.body.position), self.arm_drift)
        a, alpha = self.outwards(a), self.outwards(alpha)
        self.carried = alpha, a
        alpha = plus(alpha, self.drift)
        if isinstance(self.hinge, Pin):
            k = self.hinge.k
            others = [i for i in range(6) if i != k]
            both = alpha + a
            new = sub(self.own, add(*(mul(self.gain[i], both[i]) for i in others)))
            own = sub(new, alpha[k])
            return [own], [new if i == k else alpha[i] for i in range(3)], a
        new = backwards(self.lower, [sub(self.own[i], dot(self.gain[i], a)) for i in range(3)])
        return [sub(new[i], alpha[i]) for i in range(3)], new, a


    def reaction(self) -> Vector:
        """Moment and force that the hinge transmits, once the body is accelerated."""
        (alpha, a), w = self.carried, self.released
        moment = plus(times(w.a, alpha), times(w.b, a), w.moment)
        return moment + plus(times(transposed(w.b), alpha), times(w.m, a), w.force)


@dataclass
class Inertial:
    """Of a body alone, about its hinge."""

    mass: Number
    moments: Vector
    j: Matrix
    b: Matrix

    @staticmethod
    def of(body: Body, number) -> "Inertial":
        mass = number(body.mass)
        com = [0.0 if x == 0.0 else number(x) for x in body.com]
        moments = [mul(mass, x) for x in com]
        square = dot(com, com)

        def entry(i: int, j: int) -> Number:
            own = number(body.inertia[i][j]) if body.inertia[i][j] else 0.0
            return add(own, sub(mul(mass, square) if i == j else 0.0, mul(moments[i], com[j])))

        x, y, z = moments
        minus = [0.0 if is_zero(v) else -v for v in moments]
        skew = [[0.0, minus[2], y], [z, 0.0, minus[0]], [minus[1], x, 0.0]]
        return Inertial(mass, moments, symmetric(entry), skew)


def turned(rotation: Matrix, m: Matrix, is_symmetric: bool) -> Matrix:
    """R m Rᵀ for a constant R, which is sparse."""
    half = [times(rotation, row) for row in m]
    entry = lambda i, j: dot(rotation[i], [row[j] for row in half])  # noqa: E731
    return symmetric(entry) if is_symmetric else [[entry(i, j) for j in range(3)] for i in range(3)]


def factors(a: Matrix) -> tuple[tuple[Number, Number, Number], Vector]:
    """L, its three entries below ones, and D⁻¹ of a symmetric matrix."""
    first = 1.0 / a[0][0]
    l10, l20 = mul(a[0][1], first), mul(a[0][2], first)
    second = 1.0 / sub(a[1][1], mul(l10, a[0][1]))
    rest = sub(a[1][2], mul(l20, a[0][1]))
    l21 = mul(rest, second)
    third = 1.0 / sub(sub(a[2][2], mul(l20, a[0][2])), mul(l21, rest))
    return (l10, l20, l21), [first, second, third]


def forwards(lower: tuple[Number, Number, Number], v: Vector) -> Vector:
    l10, l20, l21 = lower
    second = sub(v[1], mul(l10, v[0]))
    return [v[0], second, sub(sub(v[2], mul(l20, v[0])), mul(l21, second))]


def backwards(lower: tuple[Number, Number, Number], v: Vector) -> Vector:
    l10, l20, l21 = lower
    second = sub(v[1], mul(l21, v[2]))
    return [sub(sub(v[0], mul(l20, v[2])), mul(l10, second)), second, v[2]]


def accelerations(
    case: Case,
    hinges: Sequence[Sequence[Number]],
    rates: Sequence[Number],
    torques: Sequence[Number],
    number=float,
    wrenches: bool = False,
) -> list[Number]:
    """Of all hinges, from sine and cosine of each pin or the quaternion of each ball; and then, if
    asked for, moment and force in every hinge.
    """
    links: list[Link] = []
    omega: Vector = [0.0] * 3
    efforts: list[Vector] = []
    place = 0
    for body, coordinates in zip(case.bodies, hinges):
        rate, torque = [0.0] * 3, [0.0] * 3
        if body.hinge == "ball":
            rate, torque = list(rates[place : place + 3]), list(torques[place : place + 3])
            hinge, place = Ball(coordinates), place + 3
        else:
            axis = "xyz".index(body.hinge)
            rate[axis], torque[axis] = rates[place], torques[place]
            hinge, place = Pin(axis, *coordinates), place + 1
        link = Link(body, hinge, rate, Inertial.of(body, number))
        link.velocities(omega, links[-1] if links else None)
        omega = link.omega
        links.append(link)
        efforts.append(torque)

    for index in reversed(range(len(links))):
        released = links[index].release(efforts[index])
        if index:
            links[index].add_to(links[index - 1], released)

    result: list[Number] = []
    alpha: Vector = [0.0] * 3
    a: Vector = [0.0 if x == 0.0 else number(-x) for x in case.gravity]
    for link in links:
        own, alpha, a = link.accelerate(alpha, a)
        result += own
    reactions = [x for link in links for x in link.reaction()] if wrenches else []
    return result + reactions
