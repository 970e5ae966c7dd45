"""The values of the course's scenes of friction between moving bodies: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from integration import solve


def stick_slip():
    """It rides with v up to K x = mu_s m g, slides back about c = mu m g / K to 2 c - x, where it is as fast as the belt."""
    rows, k, v = Rows(), 100, 0.2
    off, c, w = 0.6 * G / k, 0.4 * G / k, 10
    # x - c = size cos(w s - phase), from off - c with the speed v back to c - off with the speed v.
    size, phase = math.hypot(off - c, v / w), math.atan2(v / w, off - c)
    first, rides = off / v, 2 * (off - c) / v
    slides = (2 * math.pi - 2 * math.atan((off - c) * w / v)) / w
    for t in [0.1, 0.25, 0.4, 0.8, 1.1, 1.7, 2.3, 3.0]:
        u = t - first
        if u < 0:
            x, state = v * t, 1
        else:
            u %= slides + rides
            x, state = (c + size * math.cos(w * u - phase), 2) if u < slides else (2 * c - off + v * (u - slides), 1)
        rows.put(t, 0.2, {"block.x": x})
        rows.put(t, 1, {"rub.state": state})
    return rows


def ball_on_turntable():
    """m v' = F and 2/5 m R^2 w' = r x F with no slip give  v' = 2/7 W x v: a circle, however far from the middle."""
    rows, rate, v = Rows(), 2 / 7 * 3, 0.6
    for t in steps(8, 8):
        a = rate * t
        rows.place(t, 1.5, "ball", [0.5 + v / rate * math.sin(a), 0.15, v / rate * (math.cos(a) - 1)])
    return rows


def friction_wheels():
    """I w' = -mu N R of both up to R w = r u."""
    rows, rub, r1, r2, i1, i2 = Rows(), 0.25 * 20, 0.3, 0.1, 0.09, 0.01
    alike = 10 * r1 / (rub * (r1 * r1 / i1 + r2 * r2 / i2))
    for t in [alike / 2, alike, 1.0, 3.0]:
        s = min(t, alike)
        rows.put(t, 30, {"large.wz": 10 - rub * r1 * s / i1, "small.wz": -rub * r2 * s / i2})
        rows.put(t, 30, {"small.rz": -rub * r2 / i2 * (s * s / 2 + s * (t - s))})
    return rows


def brake_shoe():
    rows, slowing = Rows(), 0.4 * 50 * 0.2 / 0.5
    for t in [1.0, 2.0, 20 / slowing, 3.0, 4.0]:
        s = min(t, 20 / slowing)
        rows.put(t, 30, {"wheel.wz": 20 - slowing * s, "axle.q": 20 * s - slowing * s * s / 2})
        rows.put(t, 1, {"shoe.y": 0.25})
    return rows


def record():
    """1/2 m R^2 w' = 2/3 mu m g R."""
    rows, gain = Rows(), 4 / 3 * 0.3 * G / 0.15
    alike = 3.5 / gain
    for t in [alike / 2, alike, 0.5, 1.0]:
        s = min(t, alike)
        rows.put(t, 3.5, {"record.wy": gain * s, "record.ry": gain * s * s / 2 + 3.5 * (t - s)})
    return rows


def two_slopes():
    rows, mu, a, b = Rows(), 0.1, math.pi / 6, math.pi / 3
    gain = G / 5 * (4 * math.sin(a) - math.sin(b) - mu * (4 * math.cos(a) + math.cos(b)))
    for t in steps(1, 4):
        s = gain * t * t / 2
        rows.put(t, 2, {"left.x": -(0.5 + s) * math.cos(a) - 0.05 * math.sin(a), "right.y": -(0.8 - s) * math.sin(b) + 0.05 * math.cos(b)})
        rows.put(t, 20, {"thread.tension": 4 * (G * math.sin(a) - mu * G * math.cos(a) - gain)})
    return rows


def sledge():
    rows = Rows()
    for name, angle in (("level", 0), ("lifted", math.pi / 6)):
        normal = 10 * G - 40 * math.sin(angle)
        gain = (40 * math.cos(angle) - 0.3 * normal) / 10
        for t in steps(2, 4):
            rows.put(t, 3, {name + ".x": gain * t * t / 2, name + ".y": 0.1})
            rows.put(t, 100, {f"under_{name}.n": normal, f"under_{name}.fx": -0.3 * normal})
    return rows


def rotor():
    rows, r, w = Rows(), math.sqrt(4 - 0.04) - 0.15, 4
    for t in steps(3, 6):
        rows.place(t, 4, "man", [r * math.cos(w * t), 0, -r * math.sin(w * t)])
        rows.put(t, 3000, {"wall.fy": 80 * G, "hypot(wall.fx, wall.fz)": 80 * w * w * r})
    return rows


def bridge():
    rows = Rows()
    for t in steps(4, 4):
        right = 4000 * G / 2 + 3000 * G * (1 + 2 * t) / 10
        rows.put(t, 70000, {"hanger.tension": right, "bearing.fy": 7000 * G - right})
        rows.put(t, 10, {"lorry.x": -4 + 2 * t})
    return rows


def log_on_lorry():
    """m a' = F and 1/2 m R^2 w' = F R; the lower edge goes with the lorry:  a' + R w' = a."""
    rows = Rows()
    for t in steps(2, 4):
        rows.put(t, 4, {"log.x": 2 + 0.5 * t * t / 2, "log.y": 0.4})
        rows.put(t, 20, {"log.wz": t / 0.3})
    return rows


def braking_lorry():
    rows = Rows()
    for t in steps(4, 8):
        s, u = min(t, 2.5), min(t, 10 / (0.3 * G))
        rows.put(t, 20, {"lorry.x": 10 * s - 2 * s * s, "crate.x": -4 + 10 * u - 0.3 * G * u * u / 2})
        rows.put(t, 20, {"crate.rz": 0})
    return rows


def pendulum_strikes():
    """The ball comes with sqrt(2 g l) after a quarter swing, K(sin 45 degrees) sqrt(l / g); the block leaves with (1 + e) m v / (m + M)."""
    rows, mean, other = Rows(), 1.0, math.sqrt(0.5)
    for _ in range(6):
        mean, other = (mean + other) / 2, math.sqrt(mean * other)
    strikes = math.pi / 2 / mean / math.sqrt(G)
    v = 1.5 / 3 * math.sqrt(2 * G)
    stops = v / (0.3 * G)
    for t in [strikes / 2, 0.8, 1.0, strikes + stops, 3.0, 4.0]:
        s = min(max(0, t - strikes), stops)
        rows.put(t, 2, {"block.x": 0.2 + v * s - 0.3 * G * s * s / 2})
        rows.put(t, 5, {"block.dx": v - 0.3 * G * s if s > 0 else 0})
    rows.put(4.0, 2, {"block.x - 0.2": v * v / (0.6 * G)})
    return rows


def crate_tips():
    """About its front edge, in the lorry's frame:  I q'' = m (5 y + g x) with the centre at x, y of it. The edge keeps its place
    while the force along the platform is less than that across it."""
    rows, at = Rows(), steps(0.7, 7)
    inertia = 0.625 * 4 / 3

    def centre(q):
        return 0.75 * math.sin(q) - 0.25 * math.cos(q), 0.75 * math.cos(q) + 0.25 * math.sin(q)

    def tips(_, u):
        x, y = centre(u[0])
        return [u[1], (5 * y + G * x) / inertia]

    for t, (q, w) in zip(at, solve(tips, [0, 0], at)):
        (x, y), turn = centre(q), tips(t, [q, w])[1]
        if not abs(y * turn - x * w * w - 5) < -x * turn - y * w * w + G:
            raise ValueError("the edge slips")
        rows.place(t, 10, "crate", [10 * t - 2.5 * t * t + 0.25 + x, 0.1 + y, 0])
        rows.put(t, 5, {"crate.wz": -w})
    return rows


def kerb():
    """Drawn by more than m g x / (r - h) the wheel turns about the kerb's edge:  3/2 m r^2 q'' = m g r sin q - F r cos q."""
    rows, r, at = Rows(), 0.4, steps(0.4, 4)
    far = math.sqrt(r * r - 0.09)
    pull = 1.05 * G * far / 0.3
    start = [math.asin(far / r), 0]
    for t, (q, _) in zip(at, solve(lambda _, y: [y[1], (G * math.sin(y[0]) - pull * math.cos(y[0])) / (1.5 * r)], start, at)):
        rows.place(t, 0.9, "climbs", [-r * math.sin(q), 0.1 + r * math.cos(q), 1])
        rows.place(t, 0.9, "stays", [-far, r, -1])
    return rows


def bosuns_chair():
    rows = Rows()
    for t in [1.0, 10.0]:
        rows.put(t, 1000, {"line.tension": 40 * G, "seat.n": 30 * G})
        rows.put(t, 1, {"board.y": 0, "man.y": 0.45})
    return rows


def ladder_climbed():
    """The couples about the foot give the wall's force; the foot holds while that is at most 0.4 times all weights."""
    rows, a = Rows(), math.pi / 3
    wall = 4 * math.sin(a)  # the upper corner's height

    def force(s):
        """With the man so far from the middle; arms of the weights from the lower corner."""
        arm = 2 * math.cos(a) - 0.02 * math.sin(a)
        return G * (10 * arm + 80 * (arm + s * math.cos(a))) / wall

    # -1.5 + t - 1/2 from the first second on, until force(s) = 0.4 * 90 g
    slips = (0.4 * 90 * wall / 80 - (2 * math.cos(a) - 0.02 * math.sin(a)) * 90 / 80) / math.cos(a) + 2
    for t in [1.5, 2.0, 2.5, slips - 0.01]:
        rows.put(t, 900, {"head.n": force(t - 2), "foot.n": 90 * G, "abs(foot.fx)": force(t - 2)})
        rows.put(t, 4, {"ladder.y": 2 * math.sin(a) + 0.02 * math.cos(a)})
        rows.put(t, 1, {"foot.state": 1})
    rows.put(slips + 0.01, 1, {"foot.state": 2})
    return rows


def ball_on_rails():
    """The axis at which it turns is h below the middle:  (m + I / h^2) a = m g sin a."""
    rows, a, h = Rows(), 0.2, 0.08
    gain = G * math.sin(a) / (1 + 0.4 * 0.01 / h ** 2)
    for t in steps(1.5, 5):
        s = gain * t * t / 2
        rows.place(t, 4, "ball", [(s - 2) * math.cos(a) + h * math.sin(a), (2 - s) * math.sin(a) + h * math.cos(a), 0])
        rows.put(t, 40, {"ball.wz": -gain * t / h})
    return rows


def wheel_on_axle():
    rows, a, r = Rows(), 0.1, 0.01
    gain = G * math.sin(a) / (1 + 0.011 / r ** 2)
    for t in steps(6, 6):
        s = gain * t * t / 2
        rows.place(t, 1, "wheel", [(s - 1) * math.cos(a) + r * math.sin(a), (1 - s) * math.sin(a) + r * math.cos(a), 0])
        rows.put(t, 10, {"wheel.rz": -s / r})
    return rows


def overhang():
    rows, x = Rows(), -0.12
    for n in (4, 3, 2, 1):
        x += 0.99 * 0.24 / (2 * n)
        for t in (1.0, 100.0):
            rows.place(t, 0.5, f"book{n}", [x, 0.03 * (4 - n) + 0.015, 0])
            rows.put(t, 1, {f"book{n}.rz": 0})
    return rows


def log_on_wedge():
    """Down the wedge by s, back by X:  (m + M) X'' = m s'' cos a  and  3/2 s'' = g sin a + X'' cos a."""
    rows, m, big, a = Rows(), 1, 3, math.atan2(1, 2)
    down = G * math.sin(a) / (1.5 - m * math.cos(a) ** 2 / (m + big))
    back = m * down * math.cos(a) / (m + big)
    for t in steps(0.5, 5):
        s, x = down * t * t / 2, back * t * t / 2
        rows.put(t, 3, {"wedge.dx": -back * t, "log.x": 0.2 + 0.1 * math.sin(a) + s * math.cos(a) - x,
                        "log.y": 0.9 + 0.1 * math.cos(a) - s * math.sin(a)})
        rows.put(t, 30, {"log.wz": -down * t / 0.1})
    return rows
