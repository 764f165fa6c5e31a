"""Vectors and matrices that generate no operations for zeros and ones.

A number is a float, an expression or an array. Floats are those of the mechanism: a sum or a product
with a float zero in it is not formed, nor is a product with a float one.
"""

from collections.abc import Callable, Sequence
from typing import Any

Number = Any
Vector = list[Number]
Matrix = list[Vector]
Lower = tuple[Number, Number, Number]
"""Three entries below a diagonal of ones: 10, 20 and 21."""


def is_zero(x: Number) -> bool:
    return isinstance(x, float) and x == 0.0


def neg(x: Number) -> Number:
    return 0.0 if is_zero(x) else -x


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
    return a if is_zero(b) else neg(b) if is_zero(a) else a - b


def dot(a: Sequence[Number], b: Sequence[Number]) -> Number:
    return add(*map(mul, a, b))


def plus(*vectors: Vector) -> Vector:
    return list(map(add, *vectors))


def minus(v: Sequence[Number]) -> Vector:
    return list(map(neg, v))


def cross(a: Sequence[Number], b: Sequence[Number]) -> Vector:
    return [sub(mul(a[i], b[j]), mul(a[j], b[i])) for i, j in ((1, 2), (2, 0), (0, 1))]


def times(m: Matrix, v: Sequence[Number]) -> Vector:
    return [dot(row, v) for row in m]


def square(entry: Callable[[int, int], Number]) -> Matrix:
    return [[entry(i, j) for j in range(3)] for i in range(3)]


def symmetric(entry: Callable[[int, int], Number]) -> Matrix:
    """Returns the symmetric matrix of an upper half, with the same entries in both halves."""
    upper = {(i, j): entry(i, j) for i in range(3) for j in range(i, 3)}
    return square(lambda i, j: upper[min(i, j), max(i, j)])


def transposed(m: Matrix) -> Matrix:
    return square(lambda i, j: m[j][i])


def turned(rotation: Matrix, m: Matrix, shape: Callable[[Callable[[int, int], Number]], Matrix]) -> Matrix:
    """Returns R m Rᵀ."""
    half = [times(rotation, row) for row in m]
    return shape(lambda i, j: dot(rotation[i], [row[j] for row in half]))


def skew(v: Vector) -> Matrix:
    """Returns the matrix of the cross product with a vector."""
    x, y, z = v
    return [[0.0, neg(z), y], [z, 0.0, neg(x)], [neg(y), x, 0.0]]


def factors(a: Matrix) -> tuple[Lower, Vector]:
    """L and D⁻¹ of a symmetric matrix L D Lᵀ."""
    first = 1.0 / a[0][0]
    l10, l20 = mul(a[0][1], first), mul(a[0][2], first)
    second = 1.0 / sub(a[1][1], mul(l10, a[0][1]))
    rest = sub(a[1][2], mul(l20, a[0][1]))
    l21 = mul(rest, second)
    third = 1.0 / sub(sub(a[2][2], mul(l20, a[0][2])), mul(l21, rest))
    return (l10, l20, l21), [first, second, third]


def by_lower(lower: Lower, v: Vector) -> Vector:
    """L⁻¹ v."""
    l10, l20, l21 = lower
    second = sub(v[1], mul(l10, v[0]))
    return [v[0], second, sub(sub(v[2], mul(l20, v[0])), mul(l21, second))]


def by_upper(lower: Lower, v: Vector) -> Vector:
    """L⁻ᵀ v."""
    l10, l20, l21 = lower
    second = sub(v[1], mul(l21, v[2]))
    return [sub(sub(v[0], mul(l20, v[2])), mul(l10, second)), second, v[2]]


def solve_symmetric(a: list[Vector], b: Vector) -> Vector:
    """Returns A⁻¹ b of a symmetric matrix of any size by A = L D Lᵀ."""
    count = len(b)
    rest, lower, inverse = [list(row) for row in a], [[0.0] * count for _ in range(count)], []
    for k in range(count):
        inverse.append(1.0 / rest[k][k])
        for i in range(k + 1, count):
            lower[i][k] = mul(rest[i][k], inverse[k])
            for j in range(k + 1, i + 1):
                rest[i][j] = sub(rest[i][j], mul(lower[i][k], rest[j][k]))
    y: Vector = []
    for i in range(count):
        y.append(sub(b[i], dot(lower[i][:i], y)))
    x = [mul(value, factor) for value, factor in zip(y, inverse, strict=True)]
    for i in reversed(range(count)):
        x[i] = sub(x[i], dot([lower[j][i] for j in range(i + 1, count)], x[i + 1 :]))
    return x
