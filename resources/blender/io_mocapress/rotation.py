# SPDX-License-Identifier: GPL-3.0-or-later
"""Rotations as unit quaternions (w, x, y, z) and points as (x, y, z), in double precision.

Blender's mathutils stores single precision, which adds up along a chain of joints.
"""
from math import atan2, cos, hypot, pi, remainder, sin, sqrt

IDENTITY = (1.0, 0.0, 0.0, 0.0)
ORIGIN = (0.0, 0.0, 0.0)


def add(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a, factor):
    return (a[0] * factor, a[1] * factor, a[2] * factor)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def length(a):
    return sqrt(dot(a, a))


def multiply(p, q):
    """The turn by `q`, then by `p`."""
    a, b, c, d = p
    w, x, y, z = q
    return (a * w - b * x - c * y - d * z,
            a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x,
            a * z + b * y - c * x + d * w)


def inverse(q):
    return (q[0], -q[1], -q[2], -q[3])


def normalised(q):
    size = sqrt(dot(q, q))
    return tuple(x / size for x in q) if size > 0 else IDENTITY


def rotate(q, v):
    w, x, y, z = q
    u = 2 * (y * v[2] - z * v[1])
    s = 2 * (z * v[0] - x * v[2])
    t = 2 * (x * v[1] - y * v[0])
    return (v[0] + w * u + y * t - z * s,
            v[1] + w * s + z * u - x * t,
            v[2] + w * t + x * s - y * u)


def about_axis(axis, angle):
    """A turn about axis 0, 1 or 2, in radians."""
    q = [cos(angle / 2), 0.0, 0.0, 0.0]
    q[1 + axis] = sin(angle / 2)
    return tuple(q)


def from_rows(m):
    """The quaternion of a rotation matrix, whose rows may have more than three numbers."""
    trace = m[0][0] + m[1][1] + m[2][2]
    if trace > 0:
        return normalised((1 + trace, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]))
    i = max(range(3), key=lambda axis: m[axis][axis])
    j, k = (i + 1) % 3, (i + 2) % 3
    q = [m[k][j] - m[j][k], 0.0, 0.0, 0.0]
    q[1 + i] = 1 + m[i][i] - m[j][j] - m[k][k]
    q[1 + j] = m[j][i] + m[i][j]
    q[1 + k] = m[k][i] + m[i][k]
    return normalised(q)


def from_angles(axes, angles):
    """Turns about three axes, the leftmost first, as a BVH lists them."""
    q = about_axis(axes[0], angles[0])
    q = multiply(q, about_axis(axes[1], angles[1]))
    return multiply(q, about_axis(axes[2], angles[2]))


def angles(q, axes, before=None):
    """The inverse for three different axes. Of all angles that say the same turn, the nearest to
    those `before`."""
    columns = [rotate(q, tuple(float(i == axis) for i in range(3))) for axis in axes]
    m = [[column[axis] for column in columns] for axis in axes]
    sign = 1 if (axes[1] - axes[0]) % 3 == 1 else -1
    across = hypot(m[0][0], m[0][1])
    middle = atan2(sign * m[0][2], across)
    if across > 1e-9:
        found = (atan2(-sign * m[1][2], m[2][2]), middle, atan2(-sign * m[0][1], m[0][0]))
    else:  # the first axis and the last are one
        found = (atan2(sign * m[2][1], m[1][1]), middle, 0.0)
    if before is None:
        return found
    other = (found[0] + pi, pi - found[1], found[2] + pi)
    nearest = [tuple(b + remainder(a - b, 2 * pi) for a, b in zip(one, before))
               for one in (found, other)]
    return min(nearest, key=lambda one: sum(abs(a - b) for a, b in zip(one, before)))


def axis_angle(q):
    """(angle, x, y, z)"""
    sine = length(q[1:])
    if sine < 1e-12:
        return (0.0, 0.0, 1.0, 0.0)
    return (2 * atan2(sine, q[0]), *(x / sine for x in q[1:]))


def between(pairs):
    """The rotation that best turns each first vector of the pairs into its second; of several such,
    the smallest.

    It is the eigenvector of Davenport's symmetric matrix (Wahba's problem) with the largest
    eigenvalue, found by squaring the matrix until nothing else is left of it."""
    size = sum(length(a) * length(b) for a, b in pairs)
    if size == 0:
        return IDENTITY
    m = [[0.0] * 4 for _ in range(4)]
    for a, b in pairs:
        # The matrices of left multiplication by b and right multiplication by a.
        for j in range(4):
            unit = tuple(float(i == j) for i in range(4))
            column = multiply(multiply((0.0, *b), unit), (0.0, *a))
            for i in range(4):
                m[i][j] -= column[i] / size
    m[0][0] += 1e-7  # prefers no turn where the vectors leave a choice
    for i in range(4):
        m[i][i] += 1  # no eigenvalue below zero
    for _ in range(40):
        m = [[sum(m[i][k] * m[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
        largest = max(abs(x) for row in m for x in row)
        m = [[x / largest for x in row] for row in m]
    return normalised(max(m, key=lambda row: dot(row, row)))
