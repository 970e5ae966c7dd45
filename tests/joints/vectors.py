"""Vectors of three numbers, quaternions (w x y z) and small linear systems as lists."""
import math


def add(a, b):
    return [x + y for x, y in zip(a, b)]


def sub(a, b):
    return [x - y for x, y in zip(a, b)]


def times(k, a):
    return [k * x for x in a]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def norm(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return times(1 / norm(a), a)


def product(p, q):
    """Of quaternions."""
    w, v = p[0] * q[0] - dot(p[1:], q[1:]), cross(p[1:], q[1:])
    return [w] + [p[0] * q[i] + q[0] * p[i] + v[i - 1] for i in (1, 2, 3)]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def turned(q, v):
    """v, given along the axes of a body of attitude q, along the world's."""
    u = times(2, cross(q[1:], v))
    return add(add(v, times(q[0], u)), cross(q[1:], u))


def turned_back(q, v):
    return turned(conjugate(q), v)


def attitude(v):
    """The quaternion of a rotation vector."""
    angle = norm(v)
    if angle == 0:
        return [1.0, 0.0, 0.0, 0.0]
    return [math.cos(angle / 2)] + times(math.sin(angle / 2) / angle, v)


def attitude_rate(q, spin):
    """Of a spin along the world's axes."""
    return times(0.5, product([0.0] + list(spin), q))


def solved(matrix, right):
    """Gauss, with the largest pivot of each column."""
    n = len(right)
    rows = [list(row) + [b] for row, b in zip(matrix, right)]
    for i in range(n):
        k = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[k] = rows[k], rows[i]
        for r in range(i + 1, n):
            f = rows[r][i] / rows[i][i]
            if f:
                for c in range(i, n + 1):
                    rows[r][c] -= f * rows[i][c]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(rows[i][c] * x[c] for c in range(i + 1, n))) / rows[i][i]
    return x
