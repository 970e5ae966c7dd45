"""The values of the course's scenes of energy, momentum, rotation, equilibrium and control: rows of time, expression, value, scale."""
import math

from cases import G, Rows, steps
from integration import solve


def spring_gun():
    """On the spring x'' = -w^2 (x - c) about c = -m g / K, x = y - 0.3; free from x = 0 on, up to K x0^2 / (2 m g) over the start."""
    rows, m, k = Rows(), 0.1, 200
    w, c = math.sqrt(k / m), -m * G / k
    size = 0.1 + c
    leaves = math.acos(c / size) / w
    v = size * w * math.sin(w * leaves)
    top = leaves + v / G
    for t in [leaves / 2, leaves, 0.3, top, 0.8, 1.0]:
        s = t - leaves
        y, speed = (v * s - G * s * s / 2, v - G * s) if s > 0 else (c - size * math.cos(w * t), size * w * math.sin(w * t))
        rows.put(t, 1, {"ball.y": 0.3 + y})
        rows.put(t, 5, {"ball.dy": speed})
    rows.put(top, 1, {"ball.y - 0.2": k * 0.01 / (2 * m * G)})
    return rows


def gliders():
    """Their faces meet after 0.4 s; then (m - e M) v / (m + M) and (1 + e) m v / (m + M)."""
    rows, v = Rows(), 2
    for name, e in (("springs", 1), ("wood", 0.5), ("putty", 0)):
        for t in [0.3, 0.6, 1.2, 2.0]:
            s = max(0, t - 0.4)
            rows.put(t, 3, {f"one_{name}.x": -1 + v * (t - s) + (1 - 3 * e) / 4 * v * s, f"two_{name}.x": (1 + e) / 4 * v * s})
    return rows


def spring_carts():
    """The length is 0.4 - 0.2 cos(w t) up to 0.4, with w^2 = K (1/m + 1/M); the centre of mass stays."""
    rows = Rows()
    w = math.sqrt(300 * 1.5)
    leaves = math.pi / 2 / w
    for t in [leaves / 2, leaves, 0.2, 0.5, 1.0]:
        s = max(0, t - leaves)
        length = 0.4 - 0.2 * math.cos(w * (t - s)) + 0.2 * w * s
        grown = length - 0.2
        rows.put(t, 4, {"light.x": -0.1 - grown * 2 / 3, "heavy.x": 0.1 + grown / 3})
        rows.put(t, 4, {"light.dx + 2*heavy.dx": 0})
    rows.put(1.0, 4, {"light.dx": -0.2 * w * 2 / 3, "heavy.dx": 0.2 * w / 3})
    return rows


def man_in_boat():
    rows = Rows()
    for t in [1.0, 2.0, 3.0, 4.0, 5.0]:
        s = min(t / 4, 1)
        way = 3 * s * s * (3 - 2 * s)
        rows.put(t, 3, {"boat.x": -0.4 * way, "man.x": -1.5 + 0.6 * way, "80*man.x + 120*boat.x": -120})
    return rows


def balls_drop():
    """The big ball M turns its speed v round, then meets the small one, which comes with v: it leaves with (3 M - m) / (M + m) v."""
    rows, big, small = Rows(), 0.5, 0.05
    lands, v = math.sqrt(2 / G), math.sqrt(2 * G)
    up, down = (3 * big - small) / (big + small) * v, (big - 3 * small) / (big + small) * v
    for t in [0.2, 0.4, 0.5, 0.7, 0.9, 1.0]:
        s = t - lands
        fallen = 1 - G * t * t / 2
        rows.put(t, 7, {"big.y": 0.1 + (fallen if s < 0 else down * s - G * s * s / 2)})
        rows.put(t, 7, {"small.y": 0.23 + (fallen if s < 0 else up * s - G * s * s / 2)})
    return rows


def falling_weight():
    rows, m, r, inertia = Rows(), 0.5, 0.05, 0.04
    a = m * G / (m + inertia / r ** 2)
    for t in steps(2, 4):
        rows.put(t, 1.2, {"weight.y": -0.5 - a * t * t / 2})
        rows.put(t, 20, {"axle.q": -a * t * t / 2 / r, "thread.tension": m * (G - a)})
    return rows


def reversible_pendulum():
    """k^2 + d^2 over d is the same for d = 1/2 and d = 1/6; k^2 = 1/12."""
    rows, at = Rows(), steps(4, 8)
    for t, (q, w) in zip(at, solve(lambda _, y: [y[1], -G * 1.5 * math.sin(y[0])], [0.8, 0], at)):
        rows.put(t, 2, {"knife_far.q": q, "knife_near.q": q})
        rows.put(t, 6, {"knife_far.dq": w, "knife_near.dq": w})
    return rows


def spool():
    """v / R is its spin and v (1 - r/R) the thread's speed:  (M + I / R^2) a = T (1 - r/R),  m (g - a (1 - r/R)) = T."""
    rows, m, big, inertia = Rows(), 0.5, 2, 0.09
    part = 1 - 0.1 / 0.3
    a = m * G * part / (big + inertia / 0.09 + m * part ** 2)
    for t in steps(1.5, 5):
        way = a * t * t / 2
        rows.put(t, 2, {"spool.x": way, "weight.y": -0.5 - part * way, "spool.rz": -way / 0.3})
        rows.put(t, 20, {"thread.tension": m * (G - part * a)})
    return rows


def lamp():
    """T1 cos 30 = T2 cos 45,  T1 sin 30 + T2 sin 45 = m g."""
    rows = Rows()
    left = 10 * G / (0.5 + math.sqrt(3) / 2)
    for t in [0.5, 10.0]:
        rows.put(t, 200, {"left.tension": left, "right.tension": left * math.sqrt(1.5)})
        rows.place(t, 1, "lamp", [0, 0, 0])
    return rows


def roof():
    """Rafters at 45 degrees: S sin 45 = P / 2, and the tie bears S cos 45."""
    rows = Rows()
    for t in [1.0, 10.0]:
        rows.put(t, 1000, {"tie.fx": -500, "wall.fx": 500, "wall.fy": 500, "rollers.fy": 500, "hypot(heel.fx, heel.fy)": 500 * math.sqrt(2)})
        rows.put(t, 1, {"left.y": 0.5, "foot.x": 1})
    return rows


def cruise_control():
    """v' = 0.8 (20 - v) - g sin a."""
    rows = Rows()
    limit = 20 - G * math.sin(0.05) / 0.8
    for t in steps(10, 5):
        v = limit * (1 - math.exp(-0.8 * t))
        rows.put(t, 200, {"road.q": limit * t - v / 0.8})
        rows.put(t, 20, {"road.dq": v})
    return rows


def held_arm():
    """(m L^2 / 3 + its thickness) q'' = 40 (1 - q) - 8 q' - m g L/2 cos q."""
    rows, at = Rows(), steps(3, 6)
    inertia = 2 * (1.01 / 12 + 0.25)
    for t, (q, w) in zip(at, solve(lambda _, y: [y[1], (40 * (1 - y[0]) - 8 * y[1] - G * math.cos(y[0])) / inertia], [0, 0], at)):
        rows.put(t, 2, {"shoulder.q": q, "shoulder.dq": w})
        rows.put(t, 40, {"shoulder.motor": 40 * (1 - q) - 8 * w})
    return rows


def crane():
    """In the trolley  (m l^2 + I) q'' = -m l (g sin q + a cos q), a = 1/2, 0, -1/2, 0 for two seconds each."""
    rows, state = Rows(), [0.0, 0.0]
    part = 1 / (4 + 0.5 ** 2 / 6 / 4)
    places = {2: 1, 4: 3, 6: 4, 8: 4}
    for begin, a in ((0, 0.5), (2, 0), (4, -0.5), (6, 0)):
        states = solve(lambda _, y: [y[1], -part * (G * math.sin(y[0]) + a * math.cos(y[0]))], state, [begin + 1, begin + 2], start=begin)
        for t, (q, w) in zip((begin + 1.0, begin + 2.0), states):
            rows.put(t, 5, {"cable.q": q, "cable.dq": w, "load.y": -4 * math.cos(q)})
        state = states[-1]
        rows.put(begin + 2.0, 5, {"trolley.x": places[begin + 2], "load.x": places[begin + 2] + 4 * math.sin(state[0])})
    return rows


def percussion():
    """With I of the rod about its hinge and d to the blow:  I w = m (v - u) d  and  w d - u = e v. Then the rod swings."""
    rows, m, d, e, v, inertia = Rows(), 0.5, 0.6, 0.6, 4, 2 * 0.81 / 3
    meet = 0.4 / v
    w = (1 + e) * m * v * d / (inertia + m * d * d)
    u = w * d - e * v
    for t in [0.05, 0.3, 0.5, 0.8]:
        s = max(0, t - meet)
        q, rate = solve(lambda _, y: [y[1], -G * 2 * 0.45 / inertia * math.sin(y[0])], [0, w], [s])[0] if s else (0, 0)
        rows.put(t, 1, {"ball.x": -0.47 + v * (t - s) + u * s, "pin.q": q, "rod.x": 0.45 * math.sin(q)})
        rows.put(t, 5, {"pin.dq": rate})
    return rows


def climbing_monkey():
    """The ring goes down as far as the bananas go up; with 10 kg on both sides  20 y'' = 9 s''  for the way s along the rope."""
    rows = Rows()
    for t in [0.5, 1.0, 1.5, 2.0, 3.0]:
        s = min(t / 2, 1)
        way = 1.2 * s * s * (3 - 2 * s)
        rows.put(t, 4, {"bananas.y": -3 + 0.45 * way, "ring.y": -3 - 0.45 * way, "monkey.y": -3 + 0.55 * way})
        push = 1.2 * 6 / 4 * (1 - 2 * s) if t < 2 else 0
        if t != 2:
            rows.put(t, 200, {"rope.tension": 10 * (G + 0.45 * push)})
    return rows


def tilted_rod():
    """The lower end strikes with v, beside the middle by x:  m u = (1 + e) v / (1/m + x^2 / I), which turns it by x / I of that."""
    rows, inertia, a = Rows(), 0.09, 0.5
    fall = 1.5 - 0.5 * math.sin(a) - 0.02
    strikes, x = math.sqrt(2 * fall / G), 0.5 * math.cos(a)
    v = G * strikes
    blow = 1.5 * v / (1 + x * x / inertia)
    for t in [0.2, 0.4, strikes + 0.02, 0.55]:
        s = max(0, t - strikes)
        rows.put(t, 2, {"rod.y": 1.5 - G * (t - s) ** 2 / 2 - v * s + blow * s - G * s * s / 2, "rod.x": 0})
        rows.put(t, 10, {"rod.wz": -blow * x / inertia if s > 0 else 0})
    return rows
