"""The values of what rolls, spins, stands and tips: rows of time, expression, value, scale."""
import math

from cases import G, Rows, diagonal, steps, tumbling
from integration import solve
from vectors import attitude, cross, turned


def rolling_race():
    rows, c, s = Rows(), math.cos(0.2), math.sin(0.2)
    for name, part in (("ball", 5 / 7), ("cylinder", 2 / 3), ("hoop", 1 / 2)):
        for t in steps(1.6, 4):
            way = part * G * s * t * t / 2
            rows.put(t, 2.5, {name + ".x": 0.12 * s + way * c, name + ".y": 0.12 * c - way * s})
            rows.put(t, 30, {name + ".wz": -part * G * s * t / 0.12})
    return rows


def coin():
    """Steady: dL/dt = W x L is the couple of the floor's force about the centre, of mass 1."""
    rows, a, r, h, circle = Rows(), 0.3, 0.1, 0.01, 0.4
    s, c = math.sin(a), math.cos(a)
    about, across = r * r / 2, (3 * r * r + h * h) / 12
    low, high = r * s - h / 2 * c, r * c + h / 2 * s
    w = math.sqrt(low * G / ((across - about) * s * c + about * c * (circle + low) / r + high * circle))
    spin = -w * (circle + low) / r
    for t in steps(4, 8):
        x, z = math.cos(w * t), -math.sin(w * t)
        rows.place(t, 1, "coin", [circle * x, high, circle * z])
        rows.vector(t, 40, "coin.", "wx wy wz", [spin * c * x, w + spin * s, spin * c * z])
    return rows


def bowl():
    """(1 + j) a q'' = -g sin q, j = 2/5 of the ball that rolls; the third keeps its height."""
    rows, a, q = Rows(), 0.88, 1.0
    w, x, y = math.sqrt(G / (a * math.cos(q))), a * math.sin(q), -a * math.cos(q)
    for name, inertia, middle in (("rolls", 2 / 5, -2.3), ("slides", 0, 0)):
        at = steps(6, 8)
        for t, (angle, rate) in zip(at, solve(lambda t, s, j=inertia: [s[1], -G / a / (1 + j) * math.sin(s[0])], [q, 0], at)):
            rows.place(t, 6, name, [middle + a * math.sin(angle), -a * math.cos(angle), 0])
            rows.vector(t, 60, name + ".", "wx wy wz", [0, 0, -rate * a / 0.12 if inertia else 0])
    for t in steps(6, 8):
        rows.place(t, 6, "circles", [2.3 + x * math.cos(w * t), y, -x * math.sin(w * t)])
    return rows


def top():
    rows, at, l = Rows(), steps(1, 5), 0.07
    start, side = attitude([0, 0, 0.2]), 0.0004 + 0.3 * l * l
    rate = tumbling(diagonal([side, 0.0003, side]), lambda q: cross(turned(q, [0, l, 0]), [0, -0.3 * G, 0]))
    for t, y in zip(at, solve(rate, start + [0, 200, 0], at)):
        rows.place(t, 0.25, "top", turned(y[:4], [0, l, 0]))
        rows.vector(t, 1000, "top.", "wx wy wz", turned(y[:4], y[4:7]))
    return rows


def pyramid():
    rows = Rows()
    places = {"a": (-0.22, 0), "b": (0, 0), "c": (0.22, 0), "d": (-0.11, 1), "e": (0.11, 1), "f": (0, 2)}
    for t in [0.1, 0.25, 0.6, 1.1, 2.0]:
        for name, (x, row) in places.items():
            rows.put(t, 0.4, {name + ".x": x + 0.01 * (1 - math.cos(4 * math.pi * t)), name + ".y": 0.1 + 0.2 * row})
    return rows


def arch():
    """7 blocks between the radii 0.7 and 1 with plane sides stand still; the lamp swings about its hook, 0.35 above it."""
    rows, step, start = Rows(), math.pi / 7, 0.5
    middle = math.cos(step / 2) * (0.7 + 0.1 * (0.7 + 2 * 1) / (0.7 + 1))  # of a block's weight
    weight = 7 * (1 - 0.7 ** 2) / 2 * math.sin(step) * 0.4 * 2000 * G
    ball, wire = 5000 * 4 / 3 * math.pi * 0.06 ** 3, 5000 * math.pi * 0.005 ** 2 * 0.29
    turning = ball * (0.4 * 0.06 ** 2 + 0.35 ** 2) + wire * (0.29 ** 2 / 12 + 0.005 ** 2 / 4 + 0.145 ** 2)
    moment = ball * 0.35 + wire * 0.145
    long = moment / (ball + wire)

    def rate(_, y):
        return [y[1], -G * moment / turning * math.sin(y[0])]

    at = steps(2, 8)
    for t, (a, w) in zip(at, solve(rate, [start, 0], at)):
        for i in range(7):
            b = (i + 0.5) * step
            rows.put(t, 0.7, {f"stone{i}.x": middle * math.cos(b), f"stone{i}.y": middle * math.sin(b)})
        upwards = rate(t, [a, w])[1] * math.sin(a) + w * w * math.cos(a)
        rows.put(t, 0.7, {"lamp.x": long * math.sin(a), "lamp.y": 0.7 - long * math.cos(a)})
        rows.put(t, 10 * weight, {"left.n+right.n": weight + (ball + wire) * G + moment * upwards})
    return rows


def car():
    """It settles on its springs before the bump; on the bump a wheel keeps the sum of both radii; behind it, it rides."""
    rows, stiffness, rate = Rows(), 4000 / 20, 300 / 20 / 2
    turns, low = math.sqrt(stiffness - rate ** 2), G / stiffness
    for t in steps(0.4, 4):
        damped = math.exp(-rate * t) * (math.cos(turns * t) + rate / turns * math.sin(turns * t))
        rows.put(t, 1, {"chassis.y": 0.35 - low * (1 - damped), "slide_front.q": low * (1 - damped), "slide_rear.q": low * (1 - damped)})
        rows.put(t, 5, {"chassis.x": 2 * t, "wheel_front.x": 0.4 + 2 * t})
        rows.put(t, 1, {"wheel_front.y": 0.15, "wheel_rear.y": 0.15})
    rows.put(0.55, 1, {"hypot(wheel_front.x-1.5,wheel_front.y+0.45)": 0.65})
    for t in [3.5, 4.0]:
        rows.put(t, 1, {"wheel_front.y": 0.15, "wheel_rear.y": 0.15, "chassis.y": 0.35 - low})
    return rows


def dominoes():
    """Until it strikes, the first turns by a about its edge; the last ends flat, and stays."""
    rows, w, h = Rows(), 0.06, 0.4

    def rate(_, y):
        return [y[1], G * (h * math.sin(y[0]) - w * math.cos(y[0])) / 2 / ((w * w + h * h) / 3)]

    at = steps(0.43, 4)
    for t, (a, _) in zip(at, solve(rate, [0.2, 0], at)):
        s, c = math.sin(a), math.cos(a)
        rows.put(t, 1.5, {"d0.x": (w - w * c + h * s) / 2, "d0.y": (w * s + h * c) / 2, "d1.x": 0.25})
    for t in [1.4, 1.6]:
        rows.put(t, 1.5, {"d5.y": w / 2})
    return rows


def tipping():
    """The tall one turns by a about its lower edge; the low one slides with m v' = F - mu m g."""
    rows, m, inertia = Rows(), 5, 5 * (0.09 + 0.25) / 12 + 5 * (0.15 ** 2 + 0.25 ** 2)

    def rate(t, y):
        s, c = math.sin(y[0]), math.cos(y[0])
        return [y[1], (8 * t * (0.15 * s + 0.5 * c) - m * G * (0.15 * c - 0.25 * s)) / inertia]

    tips, slides = m * G * 0.15 / 0.5 / 8, 0.25 * m * G / 8
    for t in [1.0, 1.5, slides, 1.7, tips, 2.0, 2.2, 2.4]:
        a, w = solve(rate, [0, 0], [t], start=tips)[0] if t > tips else (0, 0)
        s, c, on = math.sin(a), math.cos(a), max(0, t - slides)
        rows.put(t, 1.5, {"tall.x": 0.15 - 0.15 * c + 0.25 * s, "tall.y": 0.15 * s + 0.25 * c, "low.x": 8 * on ** 3 / 6 / m})
        rows.put(t, 10, {"tall.wz": -w, "low.dx": 4 * on * on / m})
    return rows
