"""The values of the course's scenes of vibrations: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from integration import solve


def springs():
    """m x'' = -K x - c x' about the place of rest, m g / K lower, with K = 100 and c = 0, 2, 20."""
    rows, start = Rows(), G / 100
    for t in steps(4, 8):
        low = -0.5 - start
        w = math.sqrt(99)
        dies = math.exp(-t) * (math.cos(w * t) + math.sin(w * t) / w)
        rows.put(t, 0.3, {"free.y": low + start * math.cos(10 * t), "damped.y": low + start * dies,
                          "critical.y": low + start * (1 + 10 * t) * math.exp(-10 * t)})
    return rows


def coupled_pendulums():
    """Two angles; the spring pulls along the line of the bobs, which are balls of 2/5 m r^2 about their centres."""
    rows, at = Rows(), steps(12, 12)
    inertia = 1 + 0.4 * 0.08 ** 2

    def swings(_, y):
        (a, b), places = y[:2], [(math.sin(q), -math.cos(q)) for q in y[:2]]
        dx, dy = 1 + places[1][0] - places[0][0], places[1][1] - places[0][1]
        length = math.hypot(dx, dy)
        pull = (length - 1) / length  # on the first, towards the second
        # The couple of a force (fx, fy) on a bob at (sin q, -cos q) is  sin q fy + cos q fx.
        turns = [pull * (math.sin(q) * dy + math.cos(q) * dx) for q in (a, b)]
        return y[2:] + [(-G * math.sin(a) + turns[0]) / inertia, (-G * math.sin(b) - turns[1]) / inertia]

    for t, y in zip(at, solve(swings, [0.2, 0, 0, 0], at)):
        rows.put(t, 1.5, {"one.x": math.sin(y[0]), "two.x": 1 + math.sin(y[1]), "two.y": -math.cos(y[1])})
    return rows


def swinging_spring():
    rows, at = Rows(), steps(6, 12)

    def swings(_, y):
        length = math.hypot(y[0], y[1])
        pull = -40 * (length - 1) / length
        return [y[2], y[3], pull * y[0], pull * y[1] - G]

    for t, y in zip(at, solve(swings, [0.3, -1.2, 0, 0], at)):
        rows.place(t, 1, "weight", [y[0], y[1], 0])
        rows.put(t, 20, {"coil.force": 40 * (math.hypot(y[0], y[1]) - 1)})
    return rows


def upright_pendulum():
    """(m l^2 + I) q'' = m l (g + y'') sin q, with y = A sin(w t) of the pivot; q' is 0 at the start."""
    rows, at, w = Rows(), steps(1, 10), 200
    inertia = 0.15 ** 2 + (0.3 ** 2 + 0.02 ** 2) / 12

    def leans(t, y):
        return [y[1], 0.15 * (G - 0.02 * w * w * math.sin(w * t)) * math.sin(y[0]) / inertia]

    for t, (q, rate) in zip(at, solve(leans, [0.2, 0], at)):
        rows.put(t, 1, {"pivot.q": q, "rod.x": -0.15 * math.sin(q), "rod.y": 0.02 * math.sin(w * t) + 0.15 * math.cos(q)})
        rows.put(t, 20, {"pivot.dq": rate})
    return rows


def buoy():
    rows, w = Rows(), math.sqrt(2 * G / 0.4)
    for t in steps(4, 8):
        rows.put(t, 0.6, {"buoy.y": -0.1 * math.cos(w * t)})
    return rows


def swing():
    """J q'' = -J' q' - g (m l + M L) sin q, with J = 4/3 M + 2/5 m r^2 + m l^2 and l = 2 - s of the child."""
    rows, at = Rows(), steps(10, 10)

    def swings(t, y):
        length, rate = 2 - 0.1 * (1 - math.cos(4.4 * t)), -0.44 * math.sin(4.4 * t)
        inertia = 1 * (4 + 0.0004) / 12 + 1 + 30 * (0.4 * 0.25 ** 2 + length ** 2)
        return [y[1], (-60 * length * rate * y[1] - G * (30 * length + 1) * math.sin(y[0])) / inertia]

    for t, (q, w) in zip(at, solve(swings, [0.2, 0], at)):
        length = 2 - 0.1 * (1 - math.cos(4.4 * t))
        rows.put(t, 4, {"hook.q": q, "hook.dq": w, "child.x": length * math.sin(q)})
    return rows
