"""The values of what swings, spins and strikes: rows of time, expression, value, scale."""
import math

from cases import G, Rows, diagonal, steps, tumbling
from integration import solve
from vectors import cross, dot, solved, turned


def double_pendulum():
    rows, at, m, long, half = Rows(), steps(3, 8), 0.8, 0.5, 0.25
    first, second = 0.021 + half ** 2 + m * long ** 2, 0.017 + m * half ** 2

    def rate(_, y):
        a, b, u, v = y
        c, s = m * long * half * math.cos(b - a), m * long * half * math.sin(b - a)
        return [u, v] + solved([[first, c], [c, second]], [-G * math.cos(a) * (half + m * long) + s * v * v, -G * math.cos(b) * m * half - s * u * u])

    for t, (a, b, u, v) in zip(at, solve(rate, [0, 0, 0, 0], at)):
        rows.put(t, 2, {"upper.y": half * math.sin(a), "lower.x": long * math.cos(a) + half * math.cos(b)})
        rows.put(t, 5, {"first.q": a, "second.q": b - a})
        rows.put(t, 50, {"first.dq": u, "second.dq": v - u})
    return rows


def spring_chain():
    rows, root = Rows(), math.sqrt(20 / 0.2)
    for t in steps(8, 10):
        for i in range(1, 6):
            aside = sum(-0.05 * math.sin(k * math.pi / 6) * math.sin(k * i * math.pi / 6) * math.cos(2 * root * math.sin(k * math.pi / 12) * t)
                        for k in range(1, 6))
            rows.put(t, 2, {f"g{i}.x": 0.4 * (i - 3) + aside})
    return rows


def gyroscope():
    rows, at = Rows(), steps(4, 8)
    rate = tumbling(diagonal([0.12, 0.145, 0.145]), lambda q: cross(turned(q, [0.2, 0, 0]), [0, -2 * G, 0]))
    for t, y in zip(at, solve(rate, [1, 0, 0, 0, 30, 0, 0], at)):
        rows.place(t, 1, "wheel", turned(y[:4], [0.2, 0, 0]))
        rows.vector(t, 300, "wheel.", "wx wy wz", turned(y[:4], y[4:7]))
    return rows


def foucault():
    """A spherical pendulum as the stars see it; the ground turns by W t under it."""
    rows, at, w = Rows(), steps(15, 10), 2 * math.pi / 60

    def rate(_, y):
        r, v = y[:3], y[3:]
        pull = (dot(v, v) - G * r[1]) / 4
        return v + [-pull * r[0], -G - pull * r[1], -pull * r[2]]

    for t, y in zip(at, solve(rate, [0.6, -1.9078784028338913, 0, 0, 0, -w * 0.6], at)):
        c, s = math.cos(w * t), math.sin(w * t)
        rows.place(t, 1.4, "bob", [y[0] * c - y[2] * s, y[1], y[0] * s + y[2] * c])
    return rows


def newtons_cradle():
    """One ball swings at a time: the first on its side, and the last on the other."""
    rows, a0 = Rows(), 0.5
    mean, other = 1.0, math.cos(a0 / 2)
    for _ in range(6):
        mean, other = (mean + other) / 2, math.sqrt(mean * other)
    quarter = math.pi / (2 * mean) * math.sqrt(0.5 / G)
    for t in steps(4, 10) + [quarter / 2, 2 * quarter]:
        a, _ = solve(lambda _, y: [y[1], -G / 0.5 * math.sin(y[0])], [-a0, 0], [t])[0]
        for i in range(1, 6):
            angle = a if (i == 1 and a < 0) or (i == 5 and a > 0) else 0
            rows.put(t, 1, {f"ball{i}.x": 0.1 * (i - 3) + 0.5 * math.sin(angle), f"ball{i}.y": -0.5 * math.cos(angle)})
    return rows


def billiards():
    rows, v = Rows(), 1.5
    hits = (0.8 - 0.05 * math.sqrt(3)) / v
    for t in [0.3, 0.6, 1.0, 1.5]:
        s, ahead = max(0, t - hits), min(t, hits)
        rows.put(t, 2, {"cue.x": -0.8 + v * ahead - v / 5 * s, "cue.z": 0, "red.x": 3 / 5 * v * s, "red.z": -0.05 - math.sqrt(3) / 5 * v * s,
                        "blue.x": 3 / 5 * v * s, "blue.z": 0.05 + math.sqrt(3) / 5 * v * s})
    return rows


def bungee():
    """A fall of the rope's length; then a vibration about the place of rest while the rope pulls, as long again and again."""
    rows, l, w = Rows(), 12, math.sqrt(120 / 70)
    falls, sag = math.sqrt(2 * l / G), G / w ** 2
    v = G * falls
    size = math.hypot(sag, v / w)
    pulls = 2 * (math.pi - math.atan2(v / w, sag)) / w  # y + l + sag = size cos(w s - phase), from +sag down and back
    for t in [1, falls, 2.5, 3, 4, 5, 6, 8, 10, 12]:
        s = t % (2 * falls + pulls)
        on = s - falls
        if 0 <= on <= pulls:
            y = -l - sag + sag * math.cos(w * on) - v / w * math.sin(w * on)
        else:
            s = min(s, 2 * falls + pulls - s)
            y = -G * s * s / 2
        rows.put(t, 34, {"jumper.y": y})
    return rows


def orbit():
    rows, e, a = Rows(), 0.6, 1.0
    for t in steps(7, 14):
        mean = 2 * t % (2 * math.pi)
        angle = mean if mean < math.pi else mean - 0.1
        for _ in range(60):
            angle -= (angle - e * math.sin(angle) - mean) / (1 - e * math.cos(angle))
        rows.put(t, 2, {"comet.x": a * (math.cos(angle) - e), "comet.z": -a * math.sqrt(1 - e * e) * math.sin(angle)})
    return rows
