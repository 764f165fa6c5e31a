"""The articulated-body algorithm, optimised as by hand for one mechanism.

The same lines generate CasADi's expressions and, with arrays of long doubles, the reference
accelerations of all contenders. All quantities of a body are in its frame, about its hinge. Gravity is
an upward acceleration of the ground.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from .algebra import (
    Matrix,
    Number,
    Vector,
    add,
    cross,
    dot,
    minus,
    mul,
    neg,
    plus,
    skew,
    square,
    sub,
    symmetric,
    times,
    transposed,
    turned,
)
from .cases import Body, Case
from .hinges import Ball, Floating, Pin, Wrench

Hinge = Pin | Ball | Floating


class Link:
    """A body and its hinge during the three sweeps."""

    def __init__(self, body: Body, hinge: Hinge, before: Link | None, number: Callable[[float], Number]):
        """Outward sweep: rates, and the bias terms."""
        self.hinge, self.before = hinge, before
        # Set by the last sweep.
        self.alpha: Vector
        self.a: Vector
        self.arm = [number(x) if x else 0.0 for x in body.position]
        # The rotation of the hinge's inboard side, often of zeros and ones.
        self.fixed = [[x if x in (0.0, 1.0, -1.0) else number(x) for x in row] for row in body.rotation]
        carried = self.outwards(before.omega if before else [0.0] * 3)
        self.omega: Vector = plus(carried, hinge.rate)
        self.bias = cross(carried, hinge.rate)

        x, y, z = self.omega
        xx, yy, zz, xy, xz, yz = (mul(p, q) for p, q in ((x, x), (y, y), (z, z), (x, y), (x, z), (y, z)))
        # The matrix from a point's position relative to the hinge to its centripetal acceleration.
        self.centripetal = [
            [neg(add(yy, zz)), xy, xz],
            [xy, neg(add(xx, zz)), yz],
            [xz, yz, neg(add(xx, yy))],
        ]
        self.arm_drift = times(before.centripetal, self.arm) if before else [0.0] * 3

        mass, com = number(body.mass), [number(x) if x else 0.0 for x in body.com]
        moments = [mul(mass, x) for x in com]
        j = about_hinge(body, moments, com, number)
        # ω × J ω by the products of ω.
        gyroscopic = [
            add(
                mul(yz, sub(j[2][2], j[1][1])),
                mul(sub(yy, zz), j[1][2]),
                mul(xy, j[0][2]),
                mul(neg(xz), j[0][1]),
            ),
            add(
                mul(xz, sub(j[0][0], j[2][2])),
                mul(sub(zz, xx), j[0][2]),
                mul(yz, j[0][1]),
                mul(neg(xy), j[1][2]),
            ),
            add(
                mul(xy, sub(j[1][1], j[0][0])),
                mul(sub(xx, yy), j[0][1]),
                mul(xz, j[1][2]),
                mul(neg(yz), j[0][2]),
            ),
        ]
        m = square(lambda i, j: mass if i == j else 0.0)
        self.wrench = Wrench(j, skew(moments), m, gyroscopic, times(self.centripetal, moments))

    def outwards(self, v: Vector) -> Vector:
        """Returns components in this body's frame of a vector in the inboard body's frame."""
        return self.hinge.outwards(times(transposed(self.fixed), v))

    def eliminate(self) -> None:
        """Inward sweep: eliminates the hinge, and adds the transmitted wrench to the inboard body."""
        self.released = self.hinge.eliminate(self.wrench, self.bias)
        if not self.before or isinstance(self.hinge, Floating):
            return
        w, fixed = self.hinge.wrench_inwards(self.released), self.fixed
        a, m = turned(fixed, w.a, symmetric), turned(fixed, w.m, symmetric)
        b = turned(fixed, w.b, square)
        # From this hinge to the inboard body's hinge.
        force = plus(times(fixed, w.force), times(m, self.arm_drift))
        moment = plus(times(fixed, w.moment), times(b, self.arm_drift), cross(self.arm, force))
        moved_b = [plus(*rows) for rows in zip(b, columns(cross(self.arm, row) for row in m), strict=True)]
        b_arm = [minus(cross(self.arm, row)) for row in b]
        arm_b = columns(cross(self.arm, row) for row in moved_b)
        to = self.before.wrench
        self.before.wrench = Wrench(
            symmetric(lambda i, j: add(to.a[i][j], sub(a[i][j], b_arm[i][j]), arm_b[i][j])),
            square(lambda i, j: add(to.b[i][j], moved_b[i][j])),
            symmetric(lambda i, j: add(to.m[i][j], m[i][j])),
            plus(to.moment, moment),
            plus(to.force, force),
        )

    def accelerate(self, ground: Vector) -> Vector:
        """Outward sweep: returns the hinge's acceleration and sets those of the body."""
        if isinstance(self.hinge, Floating):
            self.alpha, self.a = self.hinge.alpha, self.hinge.a
            return self.hinge.accelerate()
        before_alpha, before_a = (self.before.alpha, self.before.a) if self.before else ([0.0] * 3, ground)
        a = self.outwards(plus(before_a, cross(before_alpha, self.arm), self.arm_drift))
        self.carried = self.outwards(before_alpha)
        own, self.alpha = self.hinge.accelerate(plus(self.carried, self.bias), a)
        self.a = a
        return own

    def reaction(self) -> Vector:
        """Returns moment and force in the hinge."""
        w = self.released
        moment = plus(times(w.a, self.carried), times(w.b, self.a), w.moment)
        return moment + plus(times(transposed(w.b), self.carried), times(w.m, self.a), w.force)


def columns(vectors: Iterable[Vector]) -> Matrix:
    return transposed(list(vectors))


def about_hinge(body: Body, moments: Vector, com: Vector, number: Callable[[float], Number]) -> Matrix:
    """Returns the inertia tensor."""
    whole = dot(moments, com)

    def entry(i: int, j: int) -> Number:
        own = number(body.inertia[i][j]) if body.inertia[i][j] else 0.0
        return add(own, sub(whole if i == j else 0.0, mul(moments[i], com[j])))

    return symmetric(entry)


def accelerations(
    case: Case,
    coordinates: Sequence[Sequence[Number]],
    rates: Sequence[Number],
    torques: Sequence[Number],
    number: Callable[[float], Number] = float,
    wrenches: bool = False,
) -> list[Number]:
    """Returns the accelerations of all hinges, from sine and cosine of each pin, the quaternion of each
    ball, or the seven coordinates of a floating base, and with `wrenches` moment and force in every hinge
    but this base. `number` converts constants.
    """
    links: list[Link] = []
    place = 0
    for body, own in zip(case.bodies, coordinates, strict=True):
        hinge: Hinge
        if body.hinge == "floating":
            gravity = [number(x) if x else 0.0 for x in case.gravity]
            hinge, place = Floating(own, list(rates[:6]), gravity), 6
        elif body.hinge == "ball":
            here = slice(place, place + 3)
            hinge, place = Ball(own, list(rates[here]), list(torques[here])), place + 3
        else:
            hinge = Pin("xyz".index(body.hinge), own[0], own[1], rates[place], torques[place])
            place += 1
        links.append(Link(body, hinge, None if body.parent is None else links[body.parent], number))
    for link in reversed(links):
        link.eliminate()
    ground = [number(-x) if x else 0.0 for x in case.gravity]
    result = [x for link in links for x in link.accelerate(ground)]
    if wrenches:
        result += [x for link in links if not isinstance(link.hinge, Floating) for x in link.reaction()]
    return result
