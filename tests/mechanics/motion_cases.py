"""The values of the course's scenes of motion and forces: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from integration import solve


def two_balls_fall():
    """y = h - g t^2 / 2 of both; after the bounce as before it, backwards."""
    rows, lands = Rows(), math.sqrt(2 * 1.95 / G)
    for t in [0.2, 0.4, 0.6, 0.7, 0.9, 1.1]:
        s = min(t, 2 * lands - t)
        for name, x in (("dropped", 0), ("thrown", 0.3 + 3 * t)):
            rows.place(t, 4, name, [x, 2 - G * s * s / 2, 0])
            rows.put(t, 10, {name + ".dy": -G * s if t < lands else G * s})
    return rows


def pursuit():
    """10 t = 2 t^2 / 2 at t = 10."""
    rows = Rows()
    for t in [2.0, 5.0, 10.0, 12.0]:
        rows.put(t, 150, {"lorry.x": 10 * t, "car.x": t * t, "car.x - lorry.x": t * t - 10 * t})
        rows.put(t, 25, {"car.dx": 2 * t})
    return rows


def projectile():
    """Lands after 2 v sin a / g, at v^2 sin 2a / g; without friction it slides on with v cos a."""
    rows, v = Rows(), 15
    for name, degrees, z in (("low", 30, -1), ("middle", 45, 0), ("high", 60, 1)):
        a = math.radians(degrees)
        lands = 2 * v * math.sin(a) / G
        for t in [0.5, 1.0, lands, 2.4, 3.0]:
            s = min(t, lands)
            rows.place(t, 40, name, [v * math.cos(a) * t, 0.1 + v * math.sin(a) * s - G * s * s / 2, z])
    return rows


def monkey():
    """In the frame that falls the dart goes straight to the monkey, 10 m away: they meet when their centres are 0.25 m apart."""
    rows, meet, m, big, e, v = Rows(), 9.75 / 20, 0.1, 4, 0.2, 20
    for t in [0.2, 0.4, 0.6, 0.8]:
        s = max(0, t - meet)
        dart = v * min(t, meet) + (m - e * big) / (m + big) * v * s
        hit = 10 + m * (1 + e) / (m + big) * v * s
        for name, way in (("dart", dart), ("monkey", hit)):
            rows.place(t, 10, name, [0.8 * way, 0.6 * way - G * t * t / 2, 0])
    return rows


def cycloid():
    """The point that is lowest at the start: v t - R sin(v t / R), R - R cos(v t / R)."""
    rows, v, r = Rows(), 1.5, 0.3
    for t in [0.3, 0.8, 1.3, 2 * math.pi * r / v, 2.5]:
        a = v * t / r
        rows.put(t, 4, {"wheel.px(0,-0.3,0)": v * t - r * math.sin(a), "wheel.py(0,-0.3,0)": r - r * math.cos(a)})
        rows.put(t, 4, {"wheel.pdx(0,-0.3,0)": v * (1 - math.cos(a)), "wheel.pdy(0,-0.3,0)": v * math.sin(a)})
    return rows


def pushed_pair():
    rows = Rows()
    for t in steps(2, 4):
        rows.put(t, 4, {"one.x": t * t, "two.x": 0.2 + t * t, "two.y": 0.1})
        rows.put(t, 20, {"between.n": 6, "between.fx": -6})
    return rows


def train():
    rows = Rows()
    for t in steps(5, 5):
        rows.put(t, 50, {"engine.x": t * t, "first.x": t * t - 8, "second.x": t * t - 16})
        rows.put(t, 14000, {"front.fx": 6000, "rear.fx": 2000})
    return rows


def parachute():
    """With V = sqrt(m g / k), u = v / V and s = g t / V:  u = (u0 + tanh s) / (1 + u0 tanh s), and the way is
    V^2 / g log(cosh s + u0 sinh s)."""
    rows, way, start = Rows(), 0.0, 0.0
    for k, begin, at in ((0.25, 0, [2.0, 5.0, 8.0]), (25, 8, [8.2, 9.0, 11.0, 14.0])):
        limit = math.sqrt(80 * G / k)
        u = start / limit
        for t in at:
            s = G * (t - begin) / limit
            y = way + limit ** 2 / G * math.log(math.cosh(s) + u * math.sinh(s))
            v = limit * (u + math.tanh(s)) / (1 + u * math.tanh(s))
            rows.put(t, 300, {"jumper.y": -y})
            rows.put(t, 60, {"jumper.dy": -v})
        way, start = y, v
    return rows


def plumb_line():
    """In the waggon:  (m l^2 + 2/5 m r^2) q'' = -m l (g sin q + a cos q). At a tan of -a / g it would hang still."""
    rows, a = Rows(), 2
    at = steps(4, 8)
    for t, (q, w) in zip(at, solve(lambda _, y: [y[1], -(G * math.sin(y[0]) + a * math.cos(y[0])) / (1 + 0.4 * 0.01)], [0, 0], at)):
        rows.put(t, 16, {"waggon.x": a * t * t / 2, "lamp.x": a * t * t / 2 + math.sin(q), "lamp.y": -math.cos(q)})
        rows.put(t, 3, {"cord.q": q, "cord.dq": w})
    return rows


def jerked_board():
    """Together while m F / (m + M) <= mu m g; else the crate gains mu g and the board (F - mu m g) / M."""
    rows, mu = Rows(), 0.3
    for t in steps(0.5, 5):
        rows.put(t, 2, {"board_gentle.x": t * t, "crate_gentle.x": t * t})
        rows.put(t, 2, {"board_jerk.x": (30 - mu * G) / 4 * t * t / 2, "crate_jerk.x": mu * G * t * t / 2, "crate_jerk.rz": 0})
    return rows


def turntable():
    rows, r, w = Rows(), 0.3, 2
    for t in steps(5, 5):
        rows.place(t, 0.6, "coin", [r * math.cos(w * t), 0.025, -r * math.sin(w * t)])
        rows.put(t, 1, {"hypot(hold.fx, hold.fz)": 0.02 * w * w * r, "hold.n": 0.02 * G, "hold.state": 1})
    return rows


def turning_shaft():
    """A q'' = (A - C) w^2 sin q cos q - m g l sin q, A about the hinge, C along the rod."""
    rows, w, l = Rows(), 6, 0.5
    along, about = 0.04 ** 2 / 6, (1 + 0.04 ** 2) / 12 + l * l
    at = steps(4, 8)

    def swings(_, y):
        return [y[1], ((about - along) * w * w * math.cos(y[0]) - G * l) * math.sin(y[0]) / about]

    for t, (q, rate) in zip(at, solve(swings, [0.3, 0], at)):
        rows.put(t, 2, {"pin.q": q, "rod.y": -l * math.cos(q), "rod.x": l * math.sin(q) * math.cos(w * t),
                        "rod.z": -l * math.sin(q) * math.sin(w * t)})
        rows.put(t, 10, {"pin.dq": rate})
    return rows


def tunnel():
    rows, radius = Rows(), 6371000
    w = math.sqrt(G / radius)
    for t in [600.0, math.pi / 2 / w, 2000.0, math.pi / w, 4000.0, 2 * math.pi / w]:
        rows.put(t, 2 * radius, {"stone.y": radius * math.cos(w * t)})
        rows.put(t, 8000, {"stone.dy": -radius * w * math.sin(w * t)})
    return rows


def binary_stars():
    rows, w = Rows(), math.sqrt(3)
    for t in steps(12, 8):
        for name, r in (("heavy", -1 / 3), ("light", 2 / 3)):
            rows.place(t, 1.5, name, [r * math.cos(w * t), r * math.sin(w * t), 0])
    return rows


def rocket_falls_back():
    """r = a (1 - cos n), t = sqrt(a^3 / k) (n - sin n) with k = g R^2 and 1/a = 2/R - v^2/k: an ellipse without width."""
    rows, radius, v = Rows(), 6371000, 8000
    k = G * radius * radius
    a = 1 / (2 / radius - v * v / k)
    pace = math.sqrt(a ** 3 / k)
    first = math.acos(1 - radius / a)
    for n in [first + (2 * math.pi - 2 * first) * i / 6 for i in (1, 2, 3, 4)]:
        t = pace * (n - math.sin(n) - first + math.sin(first))
        rows.put(t, 2e7, {"shell.y": a * (1 - math.cos(n))})
        rows.put(t, 1e4, {"shell.dy": math.sqrt(k / a) * math.sin(n) / (1 - math.cos(n))})
    return rows
