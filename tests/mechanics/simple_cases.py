"""The values of scenes that have closed forms or one coordinate: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from integration import solve
from rope_cases import first


def incline():
    rows, a, v = Rows(), math.pi / 6, 4.0
    slowing = G * (math.sin(a) + 0.4 * math.cos(a))
    stop = v / slowing
    for t in [0.1, 0.3, stop, 0.6, 2.0]:
        s = min(t, stop)
        way = 0.15 + v * s - slowing * s * s / 2
        rows.place(t, 1.2, "block", [way * math.cos(a) - 0.08 * math.sin(a), way * math.sin(a) + 0.08 * math.cos(a), 0])
    return rows


def atwood():
    rows = Rows()
    a = 0.2 * G / (2.2 + 0.25)
    for t in steps(1.5, 5):
        rows.put(t, 1.8, {"down.py(0,0,0)": 0.9 - a * t * t / 2, "up.py(0,0,0)": a * t * t / 2})
        rows.put(t, 10, {"wheel.wz": a * t / 0.15})
        rows.put(t, 20, {"thread.tension1": 1.2 * (G - a), "thread.tension2": G + a})
    return rows


def backspin():
    rows, v, w, r, mu = Rows(), 2.0, 60.0, 0.1, 0.3
    rolls = 2 * (v + r * w) / (7 * mu * G)
    for t in [0.2, v / (mu * G), rolls, 1.5, 3.0]:
        s = min(t, rolls)
        rows.put(t, 1, {"ball.x": v * s - mu * G * s * s / 2 + (v - mu * G * rolls) * (t - s)})
        rows.put(t, 60, {"ball.wz": w - 2.5 * mu * G * s / r})
    return rows


def conveyor():
    rows = Rows()
    for name, mu in (("cardboard", 0.7), ("wood", 0.5), ("steel", 0.3)):
        together = 1.5 / (mu * G)
        for t in [0.1, 0.3, 0.5, 1.0, 3.0]:
            s = min(t, together)
            rows.put(t, 4.8, {name + ".x": -0.4 + mu * G * s * s / 2 + 1.5 * (t - s)})
            rows.put(t, 15, {name + ".dx": mu * G * s})
    return rows


def wedge():
    rows, c, m, big = Rows(), 0.5, 1, 2
    back = -m * G * math.sin(c) * math.cos(c) / (big + m * math.sin(c) ** 2)
    along = (big + m) * G * math.sin(c) / (big + m * math.sin(c) ** 2)
    high = 1.2 * math.tan(c)
    x, y = 0.16 * math.cos(c) + 0.08 * math.sin(c), high - 0.16 * math.sin(c) + 0.08 * math.cos(c)
    for t in steps(0.56, 4):
        s = along * t * t / 2
        rows.put(t, 2.1, {"block.x": x + back * t * t / 2 + s * math.cos(c), "block.y": y - s * math.sin(c)})
        rows.put(t, 10, {"wedge.dx": back * t})
    return rows


def yo_yo():
    rows = Rows()
    a = G / (1 + 0.00008 / (0.2 * 0.01 ** 2))
    for t in steps(0.9, 6):
        rows.put(t, 0.9, {"yoyo.y": -0.1 - a * t * t / 2})
        rows.put(t, 180, {"yoyo.wz": -a * t / 0.01})
        rows.put(t, 2, {"thread.tension": 0.2 * (G - a)})
    return rows


def tackle():
    rows, m, w = Rows(), 3, 0.1
    load = 10 + 2 * w
    a = G * (4 * m - load) / (load + 16 * m + 15 * w)
    for t in steps(1.2, 4):
        rows.put(t, 1.8, {"load.py(0,0,0)": -1.4 + a * t * t / 2, "end.py(0,0,0)": -0.4 - 2 * a * t * t})
        rows.put(t, 30, {f"{name}.wz": sign * k * a * t / 0.06
                         for name, k, sign in (("low1", 1, 1), ("top1", 2, -1), ("low2", 3, 1), ("top2", 4, -1))})
        rows.put(t, 100, {"line.tension5": m * (G - 4 * a), "line.tension1": m * (G - 4 * a) - 10 * w / 2 * a})
    return rows


def full_circle():
    """Swings a'' = -g sin a / r, up to where the string would push; then a parabola."""
    rows, r = Rows(), 0.5
    at = [0.1, 0.25, 0.4, 0.5, 0.6]

    def swings(_, y):
        return [y[1], -G / r * math.sin(y[0])]

    def pull(y):
        return r * y[1] ** 2 + G * math.cos(y[0])

    for name, middle, v in (("slow", -1.3, 2.8), ("middle", 0, 4.4), ("fast", 1.3, 5.0)):
        leaves = first(0.2, 0.6, lambda t: pull(solve(swings, [0, v / r], [t])[0]) < 0) if name == "middle" else 9
        for t in at + ([] if name == "middle" else [0.9, 1.2]):
            a, w = solve(swings, [0, v / r], [min(t, leaves)])[0]
            s = max(0, t - leaves)
            rows.put(t, 1, {name + ".x": middle + r * math.sin(a) + r * w * math.cos(a) * s,
                            name + ".y": -r * math.cos(a) + r * w * math.sin(a) * s - G * s * s / 2})
            rows.put(t, 10, {f"string_{name}.tension": 0 if s > 0 else 0.1 * pull([a, w])})
    return rows


def ladder():
    """On its lower side foot and head keep to floor and wall; from the instant at which the wall's force is 0 on x' is constant."""
    rows, l, d = Rows(), 1.0, 0.03
    inertia = (4 * l * l + 4 * d * d) / 12
    x, y = lambda a: l * math.cos(a) + d * math.sin(a), lambda a: l * math.sin(a) + d * math.cos(a)

    def leans(_, u):
        a, w = u
        mass = l * l + d * d - 2 * l * d * math.sin(2 * a) + inertia
        return [w, (2 * l * d * math.cos(2 * a) * w * w - G * (l * math.cos(a) - d * math.sin(a))) / mass]

    def drawn(t):
        """x'': what the wall must give."""
        a, w = solve(leans, start, [t])[0]
        turn = leans(0, [a, w])[1]
        return (d * math.cos(a) - l * math.sin(a)) * turn - x(a) * w * w

    def slides(_, u):
        a, w = u[:2]
        rate = l * math.cos(a) - d * math.sin(a)  # y' / a'
        # (y'^2 + I a'^2) / 2 + g y is constant.
        return [w, (-G * rate + rate * y(a) * w * w) / (rate * rate + inertia)]

    start = [math.radians(70), 0.0]
    leaves = first(0.3, 0.8, lambda t: drawn(t) < 0)
    a0, w0 = solve(leans, start, [leaves])[0]
    speed = (d * math.cos(a0) - l * math.sin(a0)) * w0
    for t in [0.2, 0.4, leaves, 0.7, 0.8]:
        a, w = solve(leans, start, [t])[0] if t <= leaves else solve(slides, [a0, w0], [t], start=leaves)[0]
        rows.put(t, 3, {"ladder.x": x(a) if t <= leaves else x(a0) + speed * (t - leaves), "ladder.y": y(a)})
        rows.put(t, 10, {"ladder.wz": -w})
        rows.put(t, 200, {"head.fx": 10 * drawn(t) if t < leaves else 0})
    return rows
