"""The values of each scene: rows of time, expression, value, scale. Letters as in the scenes; SI units."""
import math

from integration import solve
from vectors import add, attitude, cross, dot, product, solved, sub, times, turned, turned_back

G = 9.81


class Rows(list):
    """put(t, scale, {expression: value})."""

    def put(self, t, scale, values):
        for expression, value in values.items():
            self.append((t, expression, float(value), scale))

    def vector(self, t, scale, prefix, names, values):
        self.put(t, scale, {prefix + name: value for name, value in zip(names.split(), values)})

    def place(self, t, scale, body, at):
        self.vector(t, scale, body + ".", "x y z", at)

    def force(self, t, scale, joint, force):
        self.vector(t, scale, joint + ".", "fx fy fz", force)

    def couple(self, t, scale, joint, couple):
        self.vector(t, scale, joint + ".", "tx ty tz", couple)


def steps(last, count):
    return [last * (i + 1) / count for i in range(count)]


# --- one coordinate ---------------------------------------------------------------------------

def rod_on_hinge():
    """w^2 = 3 g sin a for the angle a below the horizontal; the pin bears 5/2 m g sin a along the rod and m g cos a / 4 across."""
    rows, at = Rows(), steps(3, 10)
    mean = 1.0  # K(sin 45 degrees) by the arithmetic-geometric mean
    other = math.sqrt(0.5)
    for _ in range(6):
        mean, other = (mean + other) / 2, math.sqrt(mean * other)
    quarter = math.pi / (2 * mean) / math.sqrt(1.5 * G)
    for k in (1, 3, 5):
        rows.put(k * quarter, 2, {"pin.q": -math.pi / 2})
        rows.put(k * quarter, 20, {"pin.dq": math.sqrt(3 * G) * (1 if k == 3 else -1), "rod.wz": math.sqrt(3 * G) * (1 if k == 3 else -1)})
        rows.force(k * quarter, 1000, "pin", [0, 2.5 * 2 * G, 0])
    for t, (a, w) in zip(at, solve(lambda t, y: [y[1], 1.5 * G * math.cos(y[0])], [0, 0], at)):
        rows.put(t, 2, {"rod.x": math.cos(a) / 2, "rod.y": -math.sin(a) / 2, "pin.q": -a})
        along, across = 5 * G * math.sin(a), 0.5 * G * math.cos(a)
        rows.force(t, 1000, "pin", [-along * math.cos(a) + across * math.sin(a), along * math.sin(a) + across * math.cos(a), 0])
    return rows


def slider_crank():
    rows = Rows()
    for t in [0.025] + steps(0.5, 9):
        a, r, l, w, m = 20 * t, 0.05, 0.12, 20, 2
        root = math.sqrt(l * l - (r * math.sin(a)) ** 2)
        ahead = r * math.cos(a)
        x = ahead + root
        v = -r * math.sin(a) * w * (1 + ahead / root)
        # root root' = -r^2 sin cos w; once more: root root'' = -r^2 cos(2a) w^2 - root'^2
        rate = -r * r * math.sin(a) * math.cos(a) * w / root
        pull = m * (-ahead * w * w + (-r * r * math.cos(2 * a) * w * w - rate * rate) / root)
        side = pull * -r * math.sin(a) / root
        rows.put(t, 0.3, {"guide.q": x - 0.17, "piston.x": x, "rod.q": l})
        rows.put(t, 6, {"piston.dx": v, "pivot.dq": w, "pivot.q": a})
        rows.put(t, 20, {"pivot.motor": pull * v / w, "pivot.tz": pull * v / w})
        rows.force(t, 200, "rod", [-pull, -side, 0])
        rows.force(t, 200, "pivot", [pull, side, 0])
        rows.put(t, 200, {"guide.fy": -side})
    return rows


def bricard():
    """From rest to rest; the motion is the same backwards, and so returns after twice as long (Masarati and others, IFToMM A04)."""
    rows, half = Rows(), 2.49585575684436
    starts = {"a": (0.5, 0, 0), "b": (1, -0.5, 0), "c": (1, -1, 0.5), "d": (0.5, -1, 1), "e": (0, -0.5, 1)}
    for body, place in starts.items():
        rows.vector(half, 20, body + ".", "dx dy dz wx wy wz", [0] * 6)
        rows.vector(2 * half, 20, body + ".", "dx dy dz wx wy wz", [0] * 6)
        rows.place(2 * half, 3, body, place)
    return rows


def torsion_dry():
    """Half swings about +-1/8, each 1/4 shorter; sticks at 0.1 (x = q + 2.1)."""
    rows = Rows()
    for t in steps(12.5, 25) + [12.566370614359, 12.6, 13.0, 15.0]:
        n = min(int(2 * t / math.pi), 7)
        sign, s = (-1) ** n, min(t, 4 * math.pi) - n * math.pi / 2
        size = 2.1 - 0.25 * n - 0.125
        x = sign * (0.125 + size * math.cos(2 * s))
        moving = t < 4 * math.pi
        rows.put(t, 2, {"wire.q": x - 2.1})
        rows.put(t, 10, {"wire.dq": -2 * sign * size * math.sin(2 * s) if moving else 0})
        if t > 12.57:
            rows.couple(t, 20, "wire", [0, 0, 0])
    return rows


def torsion_damped():
    """2 q'' + 0.6 q' + 8 q = cos 3t."""
    rows = Rows()
    d, w = 0.15, math.sqrt(4 - 0.15 ** 2)
    # A cos 3t + B sin 3t:  (8 - 18) A + 1.8 B = 1,  -1.8 A + (8 - 18) B = 0
    a, b = solved([[-10, 1.8], [-1.8, -10]], [1, 0])
    c = -a
    e = (1.5 - 3 * b + d * c) / w
    for t in steps(6, 12):
        decay, cosine, sine = math.exp(-d * t), math.cos(w * t), math.sin(w * t)
        q = a * math.cos(3 * t) + b * math.sin(3 * t) + decay * (c * cosine + e * sine)
        rate = -3 * a * math.sin(3 * t) + 3 * b * math.cos(3 * t) + decay * ((e * w - d * c) * cosine - (c * w + d * e) * sine)
        rows.put(t, 2, {"wire.q": q})
        rows.put(t, 10, {"wire.dq": rate})
        rows.put(t, 30, {"wire.tz": math.cos(3 * t) - 0.6 * rate - 8 * q, "wire.motor": math.cos(3 * t)})
    return rows


def rod_stop():
    """Between hits q'' = -3/2 g cos q; each hit halves the rate and turns it round."""
    rows, at = Rows(), [0.3, 0.6, 1.0, 1.3, 1.5, 1.9, 2.1, 2.5, 2.7]

    def rate(_, y):
        return [y[1], -1.5 * G * math.cos(y[0])]

    hits, t, y = [], 0.0, [0.0, 0.0]
    while t < max(at):
        low, high = t + 1e-3, t + 0.9
        while solve(rate, y, [high], start=t)[0][0] > -math.pi / 2:
            high += 0.1
        for _ in range(60):
            middle = (low + high) / 2
            if solve(rate, y, [middle], start=t)[0][0] > -math.pi / 2:
                low = middle
            else:
                high = middle
        hits.append((t, y))
        t, y = high, [-math.pi / 2, -0.5 * solve(rate, y, [high], start=t)[0][1]]
    for time in at:
        start, state = [hit for hit in hits if hit[0] < time][-1]
        q, w = solve(rate, state, [time], start=start)[0]
        rows.put(time, 10, {"pin.q": q})
        rows.put(time, 50, {"pin.dq": w})
    return rows


def clutch():
    """2 w' = 4 - 0.3 w up to 10, then the motor gives 3."""
    rows = Rows()
    for t in steps(18, 9):
        w = min(10, 4 / 0.3 * (1 - math.exp(-0.15 * t)))
        rows.put(t, 20, {"axle.dq": w, "axle.motor": 4 if w < 10 else 3, "axle.tz": (4 if w < 10 else 3) - 0.3 * w})
    return rows


def rail():
    """Sliding from t0 with speed v0: v = v0 + 4 (cos t0 - cos t) - 2 s (t - t0), s the sign of v."""
    rows, at = Rows(), steps(9.4, 40)
    t, x, v, slides, pieces = 0.0, 0.0, 0.0, 0, []

    def speed(u):
        return v + 4 * (math.cos(t) - math.cos(u)) - 2 * slides * (u - t)

    def place(u):
        return x + (v + 4 * math.cos(t)) * (u - t) - 4 * (math.sin(u) - math.sin(t)) - slides * (u - t) ** 2

    def first(ended):
        """The first time after t at which it is so."""
        u = t
        while not ended(u + 1e-3):
            u += 1e-3
        low, high = u, u + 1e-3
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (low, middle) if ended(middle) else (middle, high)
        return high

    while t < 9.4:
        pieces.append((t, x, v, slides))
        if slides == 0:
            blocked = 1 if x >= 0.8 else -1 if x <= -0.5 else 0
            t = first(lambda u: abs(4 * math.sin(u)) > 2 and math.copysign(1, math.sin(u)) != blocked)
            v, slides = 0.0, int(math.copysign(1, math.sin(t)))
            continue
        end = first(lambda u: speed(u) * slides < 0 or not -0.5 <= place(u) <= 0.8)
        if speed(end) * slides > 1e-6:  # a stop
            t, x, v = end, 0.8 if slides > 0 else -0.5, -0.3 * speed(end)
            slides = -slides if abs(v) > 1e-5 else 0
        else:
            t, x, v = end, place(end), 0.0
            goes_on = abs(4 * math.sin(t)) > 2
            slides = int(math.copysign(1, math.sin(t))) if goes_on else 0
    for time in at:
        t, x, v, slides = [piece for piece in pieces if piece[0] < time][-1]
        rows.put(time, 2, {"rail.q": place(time) if slides else x})
        rows.put(time, 20, {"rail.dq": speed(time) if slides else 0})
    return rows


def released():
    """A rod falls as q'' = -3/2 g cos q and is free from then on; the pin bears m g sqrt(100 s^2 + c^2) / 4, s = -sin q."""
    rows, depth = Rows(), math.sqrt((6400 / G ** 2 - 1) / 99)

    def rate(_, y):
        return [y[1], -1.5 * G * math.cos(y[0])]

    low, high = 0.1, 0.48
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if -math.sin(solve(rate, [0, 0], [middle])[0][0]) < depth else (low, middle)
    for body, pin, t0 in (("a", "let", 0.7), ("b", "break", high)):
        q, w = solve(rate, [0, 0], [t0])[0]
        x, y = math.cos(q) / 2, math.sin(q) / 2
        for t in [0.2, 0.34, 0.5, 0.69, 0.8, 1.0, 1.2]:
            s = t - t0
            if s < 0:
                p, u = solve(rate, [0, 0], [t])[0]
                rows.put(t, 5, {body + ".x": math.cos(p) / 2, body + ".y": math.sin(p) / 2})
                rows.put(t, 20, {body + ".wz": u})
            else:
                rows.put(t, 5, {body + ".x": x - y * w * s, body + ".y": y + x * w * s - G * s * s / 2})
                rows.put(t, 20, {body + ".wz": w, pin + ".fx": 0, pin + ".fy": 0})
    for t in [0.2, 0.5, 0.8, 1.2]:  # c is let go with b, which it does not touch
        rows.put(t, 5, {"c.y": -G * max(0, t - high) ** 2 / 2})
    return rows


def released_meet():
    """Equal balls swap their velocities where their gap closes after the release; c comes back from a wall at x = 1."""
    rows = Rows()
    for t in [0.3, 0.6, 0.75, 0.9, 1.2, 1.6, 2.0]:
        rows.put(t, 2, {"a.x": min(t, 0.8), "b.x": 1 + max(0, t - 0.8), "e.x": t, "f.x": 0.5})
        rows.put(t, 2, {"g.x": min(t, 0.4), "h.x": 0.6 + max(0, t - 0.4)})
        rows.put(t, 2, {"c.x": t if t < 1 else max(2 - t, 0.7), "d.x": 0.5 - max(0, t - 1.3)})
    return rows


def cut():
    """A constant force, and free swings until a force or a place is reached; then straight on."""
    rows, snap, leave = Rows(), math.pi / 12, math.asin(0.6) / 3
    for t in [0.1, 0.2, 0.25, 0.4, 0.6, 1.0, 2.0]:
        rows.put(t, 5, {"a.x": t * t if t < 0.5 else 0.25 + (t - 0.5)})
        rows.put(t, 5, {"b.x": 1 + math.sin(2 * t) / 2 if t < snap else 1.25 + math.sqrt(0.75) * (t - snap)})
        rows.put(t, 5, {"s.force": 2 * math.sin(2 * t) if t < snap else 0})
        rows.put(t, 5, {"c.y": math.sin(3 * t) / 3 if t < leave else 0.2 + 0.8 * (t - leave)})
        lost = (0.125 if t >= snap else 0) + (0.18 if t >= leave else 0)  # with the spring and the link
        rows.put(t, 5, {"scene.energy": 0.5 * min(2 * t, 1) ** 2 + 1 - lost})
    return rows


def drives():
    """Couple of the arm: I q'' + m g l cos q."""
    rows = Rows()
    for t in steps(2, 8):
        q, rate, second = 0.5 * math.sin(2 * t), math.cos(2 * t), -2 * math.sin(2 * t)
        rows.put(t, 3, {"lift.q": q, "carry.q": t * t / 4, "slide.x": t * t / 4})
        rows.put(t, 10, {"lift.dq": rate, "carry.dq": t / 2, "follow.dq": 3 * rate, "follow.q": 3 * q})
        rows.put(t, 100, {"lift.motor": 0.7 * second + 2 * G * 0.5 * math.cos(q), "follow.motor": 0.4 * 3 * second})
        if t < 2:
            rows.put(t, 10, {"carry.motor": 1.5})
    return rows


def begun():
    """Each value is -from and how far the joint has gone; a spring of both swings by cos 2t."""
    rows = Rows()
    for t in steps(3, 12):
        rows.put(t, 3, {"pin.q": 0.2 + 0.3 * math.cos(2 * t), "rail.q": -0.1 + 0.4 * math.cos(2 * t),
                        "block.x": 2.6 + 0.4 * math.cos(2 * t)})
        rows.put(t, 3, {"first.q": 7 + t, "second.q": -1 - t / 2})
        rows.put(t, 3, {"thread.q": 1 + 2 * t, "nut.x": t / 2 / math.pi})
        rows.put(t, 3, {"sleeve.q1": 0.4 + 3 * t, "sleeve.q2": min(0.7 * t - 0.2, 1.2)})
        rows.put(t, 3, {"table.q1": 1 + 0.3 * t, "table.q2": 2 - 0.2 * t, "table.q3": 3 + t})
        rows.put(t, 3, {"hooke.q1": 0.1 + 2 * t, "hooke.q2": 0.2})
        rows.put(t, 3, {"lift.q": 0.5 + math.sin(2 * t), "lift.dq": 2 * math.cos(2 * t)})
    return rows


# --- steady or straight motion ------------------------------------------------------------------

def conical_pendulum():
    rows, a = Rows(), 0.7
    about, along = 1.0016 / 12 + 0.25, 0.0032 / 12
    w = math.sqrt(G * 0.5 / (math.cos(a) * (about - along)))
    for t in steps(4, 12):
        out = [math.cos(w * t), 0, -math.sin(w * t)]
        rows.place(t, 1.7, "rod", add(times(0.5 * math.sin(a), out), [0, -0.5 * math.cos(a), 0]))
        rows.put(t, 20, {"rod.wy": w, "rod.wx": 0})
        rows.force(t, 500, "pin", add(times(-w * w * 0.5 * math.sin(a), out), [0, G, 0]))
        rows.couple(t, 20, "pin", [0, 0, 0])
        rows.put(t, 10, {"pin.q": math.acos(math.cos(w * t))})
    return rows


def hooke():
    """tan q2 = cos b tan q1."""
    rows, w, c, s = Rows(), 4, math.cos(0.6), math.sin(0.6)
    for t in steps(3, 12):
        a = w * t
        turns = round(a / math.pi)
        q = math.atan(c * math.tan(a)) + turns * math.pi
        rest = 1 - (s * math.sin(a)) ** 2
        ratio = c / rest
        second = c * 2 * s * s * math.sin(a) * math.cos(a) / rest ** 2 * w * w
        rows.put(t, 3, {"in.q": a, "out.q": q})
        rows.put(t, 30, {"out.dq": ratio * w, "two.wy": ratio * w * s})
        rows.put(t, 300, {"in.motor": 0.3 * second * ratio})
    return rows


def screw():
    rows = Rows()
    for t in steps(3, 6):
        for body, joint, pitch in (("nut", "turn", 0.3), ("left", "back", -0.7)):
            k = 2 * math.pi / pitch
            a = -G * 2 / (2 + 0.05 * k * k)
            rows.put(t, 4, {body + ".y": a * t * t / 2})
            rows.put(t, 100, {joint + ".q": k * a * t * t / 2, joint + ".dq": k * a * t, body + ".wy": k * a * t})
            rows.force(t, 200, joint, [0, 2 * (a + G), 0])
            rows.couple(t, 20, joint, [0, 0.05 * k * a, 0])
    return rows


def cylindrical():
    rows, at = Rows(), steps(4, 10)
    whole = 0.06 + 1.5 * 0.09
    rate = lambda t, y: [y[1], -1.5 * G * 0.3 * math.sin(y[0]) / whole]
    for t, (q, w) in zip(at, solve(rate, [0, 4], at)):
        slid = 0.4 * t + (2 * t / 3 - 2 * math.sin(3 * t) / 9) / 1.5
        rows.put(t, 4, {"rail.q1": q, "rail.q2": slid})
        rows.put(t, 30, {"rail.dq1": w, "rail.dq2": 0.4 + (2 - 2 * math.cos(3 * t)) / 4.5})
        rows.place(t, 4, "arm", [slid, -0.3 * math.cos(q), -0.3 * math.sin(q)])
        turn = rate(t, [q, w])[1]
        y, z = -0.3 * math.cos(q), -0.3 * math.sin(q)
        rows.force(t, 300, "rail", [2 * math.sin(3 * t), 1.5 * (-turn * z - w * w * y + G), 1.5 * (turn * y - w * w * z)])
    return rows


def planar():
    """In the plane a body falls by g sin 0.3 along -axis2 and turns evenly; the plane bears m g cos 0.3 below the centre of mass."""
    rows, c, s = Rows(), math.cos(0.3), math.sin(0.3)
    normal, along, across = [-s, c, 0], [c, s, 0], [0, 0, -1]
    for t in steps(2, 8):
        ahead, aside, q = 2 * t - G * s * t * t / 2, -0.5 * t, 3 * t
        rows.place(t, 3, "slab", add(times(ahead, along), times(aside, across)))
        point = add(times(0.2 * math.cos(q), along), times(0.2 * math.sin(q), across))
        rows.put(t, 3, {"table.q1": ahead + dot(point, along) - 0.2, "table.q2": aside + dot(point, across), "table.q3": q})
        force = times(2 * G * c, normal)
        rows.force(t, 200, "table", force)
        rows.couple(t, 200, "table", cross(times(-1, add(point, times(-0.1, normal))), force))
    return rows


def dumbbell():
    rows = Rows()
    for t in steps(3, 8):
        centre = [t, 4 * t - G * t * t / 2, 0.5 * t]
        out = [math.cos(3 * t), math.sin(3 * t), 0]
        rows.place(t, 34, "a", add(centre, times(-2 / 3, out)))
        rows.place(t, 34, "b", add(centre, times(1 / 3, out)))
        rows.force(t, 300, "rod", times(2 / 3 * 9, out))
        rows.put(t, 34, {"rod.q": 1})
    return rows


def gears():
    rows = Rows()
    for t in steps(3, 8):
        two = 2 * (1 - math.cos(3 * t)) / 9 / (0.5 + 4 * 0.3)
        rows.put(t, 11, {"two.q": two, "one.q": -2 * two})
        inertia, motor, ratio = (0.2, 0.7, 0.4), (0.3, 0, 1), (1, 1, -2)
        push = -sum(c * m / i for c, m, i in zip(ratio, motor, inertia)) / sum(c * c / i for c, i in zip(ratio, inertia))
        for name, i, m, c in zip(("left", "right", "cage"), inertia, motor, ratio):
            rows.put(t, 11, {name + ".q": (m + push * c) / i * t * t / 2})
        fall = -G * 2 / (2 + 0.25 / 0.04)
        rows.put(t, 11, {"weight.y": fall * t * t / 2, "drum.q": 5 * fall * t * t / 2})
    return rows


def meshing():
    """Rack and pinion, two wheels: as they touch, without -ct. The couple sin 2t turns 0.09 + 3 * 0.3^2, and 2 turns 0.24 + 0.02 * 4."""
    rows = Rows()
    for t in steps(3, 8):
        turned = (t / 2 - math.sin(2 * t) / 4) / (0.09 + 3 * 0.3 ** 2)
        rows.put(t, 11, {"axle.q": turned, "rail.q": 0.3 * turned, "one.q": t * t / 0.32, "two.q": -2 * t * t / 0.32})
    return rows


def turns():
    """A torsion pendulum,  rz = 10 sin 2t. A free top: its axis e goes round L with |L| / I1, and  w = L / I1 + n (1 - I3 / I1) e."""
    rows, L, n = Rows(), (1.0, 0.0, 6.0), 3.0
    length = math.hypot(L[0], L[2])
    u = [x / length for x in L]
    along = u[2]  # of e = z at the start
    across = [-along * x for x in u]
    across[2] += 1
    third = [u[1] * across[2] - u[2] * across[1], u[2] * across[0] - u[0] * across[2], u[0] * across[1] - u[1] * across[0]]
    for t in steps(10, 10):
        s, c = math.sin(length * t) / length, (1 - math.cos(length * t)) / length
        sums = [L[i] * t - n * (along * u[i] * t + across[i] * s + third[i] * c) for i in range(3)]
        rows.put(t, 40, {"wheel.rz": 10 * math.sin(2 * t), "top.rx": sums[0], "top.ry": sums[1], "top.rz": sums[2],
                         "ball.rx": 0.5 * t, "ball.ry": -2 * t, "ball.rz": 0})
    return rows


def gyroscope():
    """The axle turns the spin of 40 and the place of the wheel by 2 rad/s."""
    rows = Rows()
    for t in steps(3, 6):
        out, side = [math.cos(2 * t), 0, -math.sin(2 * t)], [math.sin(2 * t), 0, math.cos(2 * t)]
        rows.place(t, 1.6, "wheel", times(0.5, out))
        rows.put(t, 100, {"axle.q": 40 * t, "axle.dq": 40, "turn.motor": 0})
        rows.couple(t, 500, "axle", times(-0.2 * 40 * 2, side))
        rows.force(t, 500, "axle", times(-3 * 4 * 0.5, out))
    return rows


# --- own integrations ---------------------------------------------------------------------------

def spherical_pendulum():
    rows, at = Rows(), steps(6, 8)

    def pull(x, v):  # along x, over the mass, so that |x| stays 1
        return -(dot(v, v) - G * x[1]) / dot(x, x)

    def rate(t, y):
        x, v = y[:3], y[3:]
        return v + add(times(pull(x, v), x), [0, -G, 0])

    for t, y in zip(at, solve(rate, [0.8, -0.6, 0, 0, 0, 1.7], at)):
        rows.place(t, 1.7, "ball", y[:3])
        rows.force(t, 300, "rod", times(3 * pull(y[:3], y[3:]), y[:3]))
        rows.vector(t, 20, "ball.", "dx dy dz wx wy wz", y[3:] + [1, 2, 3])
    return rows


def double_pendulum():
    rows, at = Rows(), steps(4, 10)
    i1, i2 = 1 * (1 + 0.0025) / 12, 0.5 * (0.49 + 0.0025) / 12

    def turns(a, b, u, w):  # angular accelerations
        c, s = math.cos(a - b), math.sin(a - b)
        k = 0.5 * 1 * 0.35
        return solved([[i1 + 0.25 + 0.5, k * c], [k * c, i2 + 0.5 * 0.35 ** 2]],
                      [-k * s * w * w - (0.5 + 0.5) * G * math.sin(a), k * s * u * u - 0.5 * 0.35 * G * math.sin(b)])

    for t, (a, b, u, w) in zip(at, solve(lambda t, y: y[2:] + turns(*y), [1.2, -0.4, 0, 0], at)):
        rows.put(t, 3, {"first.q": a - 1.2, "second.q": b - a + 1.6})
        rows.put(t, 60, {"one.wz": u, "two.wz": w})
        rows.place(t, 3, "two", [math.sin(a) + 0.35 * math.sin(b), -math.cos(a) - 0.35 * math.cos(b), 0])
        p, q = turns(a, b, u, w)
        bent = lambda angle, turn, w: [math.cos(angle) * turn - math.sin(angle) * w * w, math.sin(angle) * turn + math.cos(angle) * w * w]
        one, two = bent(a, p, u), bent(b, q, w)
        lower = [0.5 * (one[0] + 0.35 * two[0]), 0.5 * (one[1] + 0.35 * two[1] + G)]
        rows.force(t, 1000, "second", lower + [0])
        rows.force(t, 1000, "first", [lower[0] + 0.5 * one[0], lower[1] + 0.5 * one[1] + G, 0])
    return rows


def four_bar(turn=(0.0, 0.0, 0.0)):
    """Three angles from the x axis, two conditions: crank + rod = base + lever."""
    rows, at, r = Rows(), steps(3, 10), attitude(list(turn))
    lengths, masses = (0.3, 1.0, 0.8), (0.5, 1.0, 0.8)
    inertia = [m * (l * l + 0.0025) / 12 for m, l in zip(masses, lengths)]
    # mass matrix of three angles: the crank carries the rod's end
    l1, l2, l3 = lengths
    m1, m2, m3 = masses

    def turns(y):
        a, b, c, u, v, w = y
        k = m2 * l1 * l2 / 2
        cosine, sine = math.cos(a - b), math.sin(a - b)
        matrix = [[inertia[0] + m1 * l1 * l1 / 4 + m2 * l1 * l1, k * cosine, 0, -l1 * math.sin(a), l1 * math.cos(a)],
                  [k * cosine, inertia[1] + m2 * l2 * l2 / 4, 0, -l2 * math.sin(b), l2 * math.cos(b)],
                  [0, 0, inertia[2] + m3 * l3 * l3 / 4, l3 * math.sin(c), -l3 * math.cos(c)],
                  [-l1 * math.sin(a), -l2 * math.sin(b), l3 * math.sin(c), 0, 0],
                  [l1 * math.cos(a), l2 * math.cos(b), -l3 * math.cos(c), 0, 0]]
        right = [2 - k * sine * v * v - (m1 / 2 + m2) * G * l1 * math.cos(a),
                 k * sine * u * u - m2 * G * l2 / 2 * math.cos(b),
                 -m3 * G * l3 / 2 * math.cos(c),
                 l1 * math.cos(a) * u * u + l2 * math.cos(b) * v * v - l3 * math.cos(c) * w * w,
                 l1 * math.sin(a) * u * u + l2 * math.sin(b) * v * v - l3 * math.sin(c) * w * w]
        return solved(matrix, right)

    a = 0.8
    px, py = l1 * math.cos(a), l1 * math.sin(a)
    far = math.hypot(0.9 - px, py)
    b = math.atan2(-py, 0.9 - px) + math.acos((1 + far * far - l3 * l3) / (2 * far))
    c = math.atan2(py + math.sin(b), px + math.cos(b) - 0.9)
    start = (a, b, c)
    for t, y in zip(at, solve(lambda t, y: y[3:] + turns(y)[:3], [a, b, c, 0, 0, 0], at)):
        a, b, c = y[:3]
        rod = [l1 * math.cos(a) + l2 / 2 * math.cos(b), l1 * math.sin(a) + l2 / 2 * math.sin(b), 0]
        rows.place(t, 1.7, "rod", turned(r, rod))
        rows.put(t, 500, {"p1.dq": y[3], "p3.dq": y[5] - y[4]})
        rows.put(t, 5, {"p1.q": a - start[0], "p2.q": b - a - start[1] + start[0], "p4.q": c - start[2]})
        # what the lever's end does to the lever: the two multipliers, against the direction of the loop
        push = turns(y)[3:]
        rows.force(t, 5000, "p3", turned(r, [push[0], push[1], 0]))
    return rows


def four_bar_tilted():
    return four_bar((0.5, -0.8, 0.3))


def tumbling(inertia, couple=lambda q: [0, 0, 0]):
    """Rates of an attitude and a spin in the body's axes, about the point of the inertia (rows)."""
    def rate(t, y):
        q, w = y[:4], y[4:7]
        momentum = [dot(row, w) for row in inertia]
        turn = solved(inertia, add(turned_back(q, couple(q)), cross(momentum, w)))
        return times(0.5, product(q, [0.0] + w)) + turn
    return rate


def point_inertia(mass, at):
    return [[mass * ((dot(at, at) if i == k else 0) - at[i] * at[k]) for k in range(3)] for i in range(3)]


def total(*matrices):
    return [[sum(m[i][k] for m in matrices) for k in range(3)] for i in range(3)]


def diagonal(values):
    return [[values[i] if i == k else 0.0 for k in range(3)] for i in range(3)]


def welded():
    rows, at = Rows(), steps(3, 8)
    masses = {"a": 2.0, "b": 1.0, "c": 0.5}
    places = {"a": [0.0, 0, 0], "b": [1.0, 0.5, 0], "c": [0.0, 0, 1]}
    own = [(0.16 + 0.36) / 12, (1 + 0.36) / 12, (1 + 0.16) / 12]
    centre = times(1 / 3.5, [sum(masses[n] * places[n][i] for n in masses) for i in range(3)])
    inertia = total(*[total(diagonal(times(masses[n], own)), point_inertia(masses[n], sub(places[n], centre))) for n in masses])
    velocity = add([1, 2, 3], cross([1, 2, 3], centre))
    rate = tumbling(inertia)
    for t, y in zip(at, solve(rate, [1, 0, 0, 0, 1, 2, 3], at)):
        q, w = y[:4], y[4:7]
        middle = add(add(centre, times(t, velocity)), [0, -G * t * t / 2, 0])
        turn = rate(t, y)[4:7]
        for n in masses:
            rows.place(t, 39, n, add(middle, turned(q, sub(places[n], centre))))
        out = sub(places["b"], centre)
        force = turned(q, add(cross(turn, out), cross(w, cross(w, out))))  # of mass 1; gravity falls with it
        couple = turned(q, add(add([own[i] * turn[i] for i in range(3)], cross(w, [own[i] * w[i] for i in range(3)])),
                               cross([0, 0.5, 0], turned_back(q, force))))
        rows.force(t, 600, "ab", force)
        rows.couple(t, 600, "ab", couple)
    return rows


def top():
    rows, at = Rows(), steps(2, 8)
    s, c = math.sin(0.5), math.cos(0.5)
    start = attitude([0, 0, 0.5])
    inertia = diagonal([0.02 + 0.16, 0.03, 0.02 + 0.16])
    spin = turned_back(start, [-60 * s, 60 * c + 2, 0])
    rate = tumbling(inertia, lambda q: cross(turned(q, [0, 0.4, 0]), [0, -G, 0]))
    for t, y in zip(at, solve(rate, start + spin, at)):
        q, w, turn = y[:4], y[4:7], rate(t, y)[4:7]
        rows.place(t, 1.1, "top", turned(q, [0, 0.4, 0]))
        rows.vector(t, 300, "top.", "wx wy wz", turned(q, w))
        pull = turned(q, add(cross(turn, [0, 0.4, 0]), cross(w, cross(w, [0, 0.4, 0]))))
        rows.force(t, 3000, "point", add(pull, [0, G, 0]))
    return rows


def governor():
    """Spindle p, arms a from the vertical; the sleeve hangs at 2 l cos a of l = 1/2.

    T = (I(a) p'^2 + J(a) a'^2) / 2,  V(a); the motor turns the spindle.
    """
    rows, at = Rows(), steps(3, 8)
    m, l, sleeve = 0.8, 0.5, 0.5
    plain = 0.05 + 0.02

    def parts(a):  # I, I', J, J', V'
        s, c = math.sin(a), math.cos(a)
        across, along = 0.03, 0.004
        i = plain + 2 * (m * (l / 2 * s) ** 2 + across * s * s + along * c * c)
        i1 = 2 * (m * l * l / 4 + across - along) * 2 * s * c
        j = 2 * (m * l * l / 4 + across) + sleeve * (2 * l * s) ** 2
        j1 = sleeve * 4 * l * l * 2 * s * c
        # slide.q = 2 l (cos a0 - cos a); V = -2 m g l/2 cos a - sleeve g 2 l cos a + 30 (q - 0.1)^2 / 2
        q = 2 * l * (math.cos(0.8) - c)
        v1 = m * G * l * s + sleeve * G * 2 * l * s + 30 * (q - 0.1) * 2 * l * s
        return i, i1, j, j1, v1

    def rate(t, y):
        p, a, u, w = y
        i, i1, j, j1, v1 = parts(a)
        return [u, w, (0.5 * math.sin(2 * t) - i1 * w * u) / i, (i1 * u * u / 2 - j1 * w * w / 2 - v1) / j]

    for t, (p, a, u, w) in zip(at, solve(rate, [0, 0.8, 9, 0], at)):
        rows.put(t, 5, {"axle.q": p, "upper1.q": a - 0.8, "upper2.q": 0.8 - a, "slide.q": math.cos(0.8) - math.cos(a)})
        rows.put(t, 50, {"axle.dq": u, "upper1.dq": w})
        rows.place(t, 1.4, "right", [0.25 * math.sin(a) * math.cos(p), -0.25 * math.cos(a), -0.25 * math.sin(a) * math.sin(p)])
    return rows


BY_NAME = {case.__name__: case for case in (
    rod_on_hinge, slider_crank, bricard, torsion_dry, torsion_damped, rod_stop, clutch, rail, released, released_meet, cut, drives, conical_pendulum, hooke, screw, cylindrical,
    planar, begun, dumbbell, gears, meshing, turns, gyroscope, spherical_pendulum, double_pendulum, four_bar, four_bar_tilted, welded, top, governor)}
