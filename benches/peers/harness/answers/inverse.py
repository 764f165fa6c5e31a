"""Inverse dynamics and mass matrix, optimised as by hand for one mechanism, in the frames of the bodies.

The same lines generate CasADi's expressions, as `recursion.py` does for accelerations.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from ..algebra import (
    Matrix,
    Number,
    Vector,
    add,
    cross,
    dot,
    mul,
    plus,
    sub,
    symmetric,
    times,
    transposed,
    turned,
)
from ..cases import Case
from ..hinges import Ball, Floating, Pin
from ..recursion import Hinge, Link

UNITS: Matrix = [[float(i == j) for j in range(3)] for i in range(3)]


def links_of(
    case: Case,
    coordinates: Sequence[Sequence[Number]],
    rates: Sequence[Number],
    number: Callable[[float], Number],
) -> list[Link]:
    """Returns the links with their velocities."""
    links: list[Link] = []
    place = 0
    for body, own in zip(case.bodies, coordinates, strict=True):
        hinge: Hinge
        if body.hinge == "floating":
            hinge, place = Floating(own, list(rates[:6]), [0.0] * 3), 6
        elif body.hinge == "ball":
            hinge, place = Ball(own, list(rates[place : place + 3]), [0.0] * 3), place + 3
        else:
            hinge = Pin("xyz".index(body.hinge), own[0], own[1], rates[place], 0.0)
            place += 1
        links.append(Link(body, hinge, None if body.parent is None else links[body.parent], number))
    return links


def inverse_dynamics(
    case: Case,
    coordinates: Sequence[Sequence[Number]],
    rates: Sequence[Number],
    accelerations: Sequence[Number],
    number: Callable[[float], Number] = float,
) -> list[Number]:
    """Returns the efforts for given accelerations."""
    links = links_of(case, coordinates, rates, number)
    ground = [number(-x) if x else 0.0 for x in case.gravity]
    place = 0
    for link in links:
        before = link.before
        if isinstance(link.hinge, Floating):
            link.a = link.outwards(plus(list(accelerations[:3]), ground))
            link.alpha, place = list(accelerations[3:6]), 6
            continue
        before_alpha, before_a = (before.alpha, before.a) if before else ([0.0] * 3, ground)
        size = 3 if isinstance(link.hinge, Ball) else 1
        own = list(accelerations[place : place + size])
        if isinstance(link.hinge, Pin):
            own = [own[0] if i == link.hinge.k else 0.0 for i in range(3)]
        place += size
        link.a = link.outwards(plus(before_a, cross(before_alpha, link.arm), link.arm_drift))
        link.alpha = plus(link.outwards(before_alpha), link.bias, own)
    efforts: list[Number] = []
    wrenches: dict[int, tuple[Vector, Vector]] = {id(link): ([0.0] * 3, [0.0] * 3) for link in links}
    for link in reversed(links):
        w, (moment, force) = link.wrench, wrenches[id(link)]
        moment = plus(times(w.a, link.alpha), times(w.b, link.a), w.moment, moment)
        force = plus(times(transposed(w.b), link.alpha), times(w.m, link.a), w.force, force)
        efforts = [*along(link, moment, force), *efforts]
        if link.before:
            inboard = wrenches[id(link.before)]
            moment, force = inwards(link, moment, force)
            wrenches[id(link.before)] = plus(inboard[0], moment), plus(inboard[1], force)
    return efforts


def along(link: Link, moment: Vector, force: Vector) -> list[Number]:
    """Returns the components of a wrench along the rates of a hinge."""
    if isinstance(link.hinge, Pin):
        return [moment[link.hinge.k]]
    if isinstance(link.hinge, Floating):
        return [*link.hinge.ball.inwards(force), *moment]
    return moment


def inwards(link: Link, moment: Vector, force: Vector) -> tuple[Vector, Vector]:
    """Returns moment and force about the inboard body's hinge, in its frame."""
    assert not isinstance(link.hinge, Floating)
    force = times(link.fixed, link.hinge.inwards(force))
    moment = times(link.fixed, link.hinge.inwards(moment))
    return plus(moment, cross(link.arm, force)), force


def mass_matrix(
    case: Case,
    coordinates: Sequence[Sequence[Number]],
    number: Callable[[float], Number] = float,
) -> list[list[Number]]:
    """Returns the mass matrix by composite bodies (Featherstone 2008, section 6.2)."""
    links = links_of(case, coordinates, [0.0] * case.rates, number)
    firsts, place = {}, 0
    for link in links:
        firsts[id(link)] = place
        place += 1 if isinstance(link.hinge, Pin) else 6 if isinstance(link.hinge, Floating) else 3
    matrix: list[list[Number]] = [[0.0] * case.rates for _ in range(case.rates)]
    masses = {id(link): body.mass for link, body in zip(links, case.bodies, strict=True)}
    tensors = {id(link): link.wrench.a for link in links}
    # The matrix b is the skew matrix of the first moments.
    moments = {id(link): [link.wrench.b[2][1], link.wrench.b[0][2], link.wrench.b[1][0]] for link in links}
    for link in reversed(links):
        here = id(link)
        mass, first, tensor = masses[here], moments[here], tensors[here]
        axes = [UNITS[link.hinge.k]] if isinstance(link.hinge, Pin) else UNITS
        start = firsts[here] + (3 if isinstance(link.hinge, Floating) else 0)
        for index, axis in enumerate(axes):
            moment, force = times(tensor, axis), cross(axis, first)
            column, at = start + index, link
            while True:
                for row, entry in enumerate(along(at, moment, force), firsts[id(at)]):
                    matrix[row][column] = matrix[column][row] = entry
                if not at.before:
                    break
                moment, force = inwards(at, moment, force)
                at = at.before
        if isinstance(link.hinge, Floating):
            for i in range(3):
                matrix[i][i] = number(mass)
        elif link.before:
            inboard = id(link.before)
            first, tensor = composite_inwards(link, mass, first, tensor, number)
            masses[inboard] += mass
            moments[inboard] = plus(moments[inboard], first)
            own = tensors[inboard]
            tensors[inboard] = symmetric(lambda i, j, own=own, new=tensor: add(own[i][j], new[i][j]))
    return matrix


def composite_inwards(
    link: Link, mass: float, first: Vector, tensor: Matrix, number: Callable[[float], Number]
) -> tuple[Vector, Matrix]:
    """Returns first moments and inertia tensor about the inboard body's hinge, in its frame."""
    hinge, arm = link.hinge, link.arm
    assert not isinstance(hinge, Floating)
    first = times(link.fixed, hinge.inwards(first))
    tensor = hinge.tensor_inwards(tensor)
    tensor = turned(link.fixed, tensor, symmetric)
    # Twice the first moments about the arm's end, and the mass, moved along the arm.
    twice = [add(mul(2.0, h), mul(number(mass), x)) for h, x in zip(first, arm, strict=True)]
    whole = dot(arm, twice)

    def entry(i: int, j: int) -> Number:
        if i == j:
            return add(tensor[i][i], sub(whole, mul(arm[i], twice[i])))
        both = add(mul(arm[i], first[j]), mul(first[i], arm[j]), mul(mul(number(mass), arm[i]), arm[j]))
        return sub(tensor[i][j], both)

    return [add(h, mul(number(mass), x)) for h, x in zip(first, arm, strict=True)], symmetric(entry)
