"""The scenes of the grid: ten kinds over stiffness, mass ratio and scale, each with its truth.

A scene is made in units of its own (lengths and masses about 1), then turned, moved and scaled at random;
nothing is 0 that need not be. Truth is a formula, or an integration that shares nothing with the engine (truth.cpp).
"""
import math
import random
import subprocess

STIFFNESSES = (1e2, 1e4, 1e6, 1e9, 1e12)
RATIOS = (1, 1e2, 1e4, 1e6)
SCALES = (1, 1e-6, 1e3, 1e-3, 1e6)
FAR = 1e6  # lengths from the origin, for some


# Quaternions w x y z.
def product(p, q):
    return (p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
            p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0])


def about(axis, angle):
    size = math.sqrt(sum(a * a for a in axis))
    if size == 0:
        return (1, 0, 0, 0)
    return (math.cos(angle / 2), *(math.sin(angle / 2) * a / size for a in axis))


def turned(q, v):
    w = product(product(q, (0, *v)), (q[0], -q[1], -q[2], -q[3]))
    return w[1:]


def vector(v):
    return "{" + " ".join(f"{x:.17g}" for x in v) + "}"


class Frame:
    """Where the scene's own units lie in the world."""

    def __init__(self, rng, scale, far, aligned=False):
        self.length, self.mass = scale, scale ** 3
        self.turn = (1, 0, 0, 0) if aligned else about([rng.gauss(0, 1) for _ in range(3)], rng.uniform(0, 2 * math.pi))
        self.at = [rng.uniform(-1, 1) * (FAR if far else 3) for _ in range(3)]

    def place(self, p):
        return [self.length * (a + b) for a, b in zip(self.at, turned(self.turn, p))]

    def along(self, v):
        return [self.length * x for x in turned(self.turn, v)]

    def spin(self, w):
        return turned(self.turn, w)

    def box(self, sizes):
        return vector([self.length * s for s in sizes])


class Scene:
    """Bodies come first that move; `radii` has theirs, places() says where they are, fixed ones have the radius 0."""

    def __init__(self, name, frame, finish, collisions=False):
        self.name, self.frame = name, frame
        self.finish = finish
        self.times = [finish * k / 8 for k in range(1, 9)]
        self.lines = [f"simulator -start 0 -finish {finish!r} -collisions {int(collisions)}"]
        self.names, self.radii, self.planar, self.truth = [], [], [], None

    @property
    def text(self):
        return "\n".join(self.lines) + "\n"

    def body(self, shape, radius, mass, at, velocity=(0, 0, 0), attitude=(1, 0, 0, 0), spin=(0, 0, 0), more=""):
        name, f = f"b{len(self.names)}", self.frame
        self.names.append(name)
        if radius:
            self.radii.append(f.length * radius)
        self.lines += [f"shape_set s_{name} -desc {{-sub {{{shape}}}}}",
                       f"body {name} s_{name} -mass {mass * f.mass!r} -init_pos {vector(f.place(at))} "
                       f"-init_dpos {vector(f.along(velocity))} -init_rot {vector(product(f.turn, attitude))} "
                       f"-init_drot {vector(f.spin(spin))} {more}"]
        return name

    def ball(self, radius, mass, at, velocity=(0, 0, 0), **more):
        return self.body(f"-sphere {radius * self.frame.length!r}", radius, mass, at, velocity, **more)

    def force(self, body, components):
        e = " ".join(f"-{a} {{{c}}}" for a, c in zip("xyz", components))
        self.lines.append(f"force -body {body} {e}")

    def gravity(self, body, g):
        self.lines.append(f"force -body {body} -gravitational {vector(self.frame.along(g))}")

    # In the plane z = 0 of the scene's own units; truth.cpp knows no others.
    def rod(self, mass, at, angle, velocity=(0, 0), spin=0):
        sizes = (0.1, 1, 0.1)
        inertia = mass * (sizes[0] ** 2 + sizes[1] ** 2) / 12
        name = self.body(f"-box {self.frame.box(sizes)}", math.hypot(*sizes) / 2, mass, (*at, 0), (*velocity, 0),
                         about((0, 0, 1), angle), (0, 0, spin))
        self.planar.append(f"body {mass!r} {inertia!r} {at[0]!r} {at[1]!r} {angle!r} "
                           f"{velocity[0]!r} {velocity[1]!r} {spin!r}")
        return name

    def link(self, one, offset, other, to, stiffness, mass):
        damping, f = 2 * math.sqrt(stiffness * mass), self.frame
        end = (f"-body2 b{other} -offset2 {vector([f.length * x for x in (*to, 0)])}" if other >= 0 else
               " ".join(f"-{a} {x!r}" for a, x in zip("xyz", f.place((*to, 0)))))
        self.lines.append(f"link -body1 b{one} -offset1 {vector([f.length * x for x in (*offset, 0)])} {end} "
                          f"-tightness {stiffness * f.mass!r} -damping {damping * f.mass!r}")
        self.planar.append(f"link {one} {offset[0]!r} {offset[1]!r} {other} {to[0]!r} {to[1]!r} "
                           f"{stiffness!r} {damping!r}")

    def planar_gravity(self, g):
        for k in range(len(self.radii)):
            self.gravity(f"b{k}", (0, -g, 0))
        self.planar.append(f"gravity 0 {-g!r}")

    def places(self, program):
        """Position and attitude (None: not compared) of each body at each time."""
        if self.truth:
            return [[(self.frame.place(p), product(self.frame.turn, q) if q else None) for p, q in self.truth(t)]
                    for t in self.times]
        asked = "\n".join(self.planar) + "\ntimes " + " ".join(repr(t) for t in self.times) + "\n"
        ran = subprocess.run([program], input=asked, capture_output=True, text=True, check=True)
        rows = [[float(x) for x in line.split()] for line in ran.stdout.splitlines()[1:]]
        return [[(self.frame.place((row[k], row[k + 1], 0)),
                  product(self.frame.turn, about((0, 0, 1), row[k + 2]))) for k in range(0, len(row), 3)]
                for row in rows]


def oscillation(w, damping, x, v):
    """x'' = -w^2 x - damping x': the position at a time."""
    half = damping / 2
    rest = half * half - w * w
    if abs(rest) < 1e-12 * w * w:
        return lambda t: (x + (v + half * x) * t) * math.exp(-half * t)
    if rest < 0:
        r = math.sqrt(-rest)
        return lambda t: math.exp(-half * t) * (x * math.cos(r * t) + (v + half * x) / r * math.sin(r * t))
    r = math.sqrt(rest)
    slow, fast = -w * w / (half + r), -half - r
    a = (v - fast * x) / (slow - fast)
    return lambda t: a * math.exp(slow * t) + (x - a) * math.exp(fast * t)


# Two balls on a spring between them, as expressions; the damping is none, slight or heavy.
def spring(rng, k, ratio, frame):
    m, w = (1, ratio), math.sqrt(k * (1 + 1 / ratio))
    damping = rng.choice((0, 0.02, 3)) * w
    finish = min(2, 250 / w) if damping < w else 2
    s = Scene("spring", frame, finish)
    v = [rng.uniform(-1, 1) for _ in range(6)]
    x, dx = 0.3, rng.uniform(-1, 1)
    drift = (v[0] + ratio * (v[0] + dx)) / (1 + ratio)
    a = s.ball(0.1, m[0], (0, 0, 0), (v[0], v[1], v[2]))
    b = s.ball(0.1, m[1], (1 + x, 0, 0), (v[0] + dx, v[4], v[5]))
    stretch = f"({k * frame.mass!r}*({b}.x-{a}.x-{frame.length!r})+{damping / (1 + 1 / ratio) * frame.mass!r}*({b}.dx-{a}.dx))"
    s.force(a, (stretch, "0", "0"))
    s.force(b, ("-" + stretch, "0", "0"))
    moves = oscillation(w, damping, x, dx)

    def truth(t):
        centre, gap = ratio * (1 + x) / (1 + ratio) + drift * t, 1 + moves(t)
        return [((centre - gap * ratio / (1 + ratio), v[1] * t, v[2] * t), None),
                ((centre + gap / (1 + ratio), v[4] * t, v[5] * t), None)]
    s.truth = truth
    return s


# A rod hangs from a place by a link, pulled out a little, and swings; its mass is the ratio's.
def pendulum(rng, k, ratio, frame):
    s = Scene("pendulum", frame, 1.5)
    angle, pulled = rng.uniform(0.3, 2.5), rng.choice((0, 1e-3, 0.02))
    s.rod(ratio, (math.sin(angle) * (0.5 + pulled), -math.cos(angle) * (0.5 + pulled)), angle, spin=rng.uniform(-2, 2))
    s.link(0, (0, 0.5), -1, (0, 0), k * ratio, ratio)
    s.planar_gravity(10)
    return s


# Two rods held together at their ends, in free flight.
def pair(rng, k, ratio, frame):
    s = Scene("pair", frame, 1.5)
    s.rod(1, (0, 0), 0, (0.3, 0.1), rng.uniform(1, 5))
    s.rod(ratio, (0.5, 0.5), -math.pi / 2, (0, 0), rng.uniform(-2, 2) / math.sqrt(ratio))
    s.link(0, (0, 0.5), 1, (0, -0.5), k * ratio, ratio / (1 + ratio))
    return s


def chain(rng, k, ratio, frame):
    s = Scene("chain", frame, 1)
    masses = [1, ratio] if rng.random() < 0.5 else [ratio, 1]
    angle, x, y = rng.uniform(0.5, 2), 0, 0
    for n, mass in enumerate(masses):
        end = (x + math.sin(angle), y - math.cos(angle))
        s.rod(mass, ((x + end[0]) / 2, (y + end[1]) / 2), angle)
        reduced = mass if n == 0 else masses[n - 1] * mass / (masses[n - 1] + mass)
        s.link(n, (0, 0.5), n - 1, (0, 0) if n == 0 else (0, -0.5), k * max(masses), reduced)
        (x, y), angle = end, angle + rng.uniform(-0.5, 0.5)
    s.planar_gravity(10)
    return s


# Three balls joined by links at their surfaces, spinning; one is heavy.
def net(rng, k, ratio, frame):
    s = Scene("net", frame, 1)
    masses, spin = (1, ratio, 3), rng.uniform(1, 4)
    corners = [(math.cos(a), math.sin(a)) for a in (0.2, 2.3, 4.4)]
    for mass, (x, y) in zip(masses, corners):
        radius, inertia = 0.2, 0.4 * mass * 0.04
        s.ball(radius, mass, (x, y, 0), (-spin * y, spin * x, 0), spin=(0, 0, spin))
        s.planar.append(f"body {mass!r} {inertia!r} {x!r} {y!r} 0 {-spin * y!r} {spin * x!r} {spin!r}")
    for a, b in ((0, 1), (1, 2), (2, 0)):
        (xa, ya), (xb, yb) = corners[a], corners[b]
        half = ((xb - xa) / 2, (yb - ya) / 2)
        s.link(a, half, b, (-half[0], -half[1]), k * ratio, masses[a] * masses[b] / (masses[a] + masses[b]))
    return s


# Two balls between two walls, elastic or not: every impact by a formula. "Stiffness" is how narrow the gap is. The balls
# are large against their ways: impacts of small ones amplify rounding aside without bounds.
def walls(rng, k, ratio, frame):
    radius = 10
    gap = 0.2 + 2 / math.log10(k)
    width = gap + 4 * radius
    s = Scene("walls", frame, 2, collisions=True)
    e = rng.choice((1, 1, 0.97))
    wall = f"-box {frame.box((5, 200, 200))}"
    x = [radius + 0.3 * gap, width - radius - 0.3 * gap]
    v, m = [rng.uniform(0.5, 1), rng.uniform(-1, -0.5)], (1, ratio)
    for n in range(2):
        s.ball(radius, m[n], (x[n], 0, 0), (v[n], 0, 0), more=f"-restitution {e}")
    for at in (-2.5, width + 2.5):
        s.body(wall, 0, 1, (at, 0, 0), more="-fixed 1")
    limits, t = (radius, width - radius), 0
    state = [(0, list(x), list(v))]
    while t < s.finish:
        hits = []
        if v[0] < 0:
            hits.append(((limits[0] - x[0]) / v[0], 0))
        if v[1] > 0:
            hits.append(((limits[1] - x[1]) / v[1], 1))
        if v[0] > v[1]:
            hits.append(((x[1] - x[0] - 2 * radius) / (v[0] - v[1]), 2))
        if not hits:
            break
        after, what = min(hits)
        t, x = t + after, [a + b * after for a, b in zip(x, v)]
        if what < 2:
            v[what] *= -e
        else:
            impulse = (1 + e) * (v[0] - v[1]) / (1 + 1 / ratio)
            v = [v[0] - impulse, v[1] + impulse / ratio]
        state.append((t, list(x), list(v)))

    def truth(at):
        t, x, v = [row for row in state if row[0] <= at][-1]
        return [((a + b * (at - t), 0, 0), None) for a, b in zip(x, v)]
    s.truth = truth
    return s


# A ball on a stiff critical link over a floor that it strikes on its way to the link's end: stiffness and collisions.
def floor(rng, k, ratio, frame):
    w, e = math.sqrt(k), rng.choice((0.9, 0.5, 1))
    target = rng.uniform(0.02, 0.2)  # where the link draws the ball's lowest point to
    speed = -w * rng.uniform(3, 8)   # thrown down hard, so that it overshoots
    s = Scene("floor", frame, min(2, 30 / w), collisions=True)
    s.ball(0.1, ratio, (0, 1.1, 0), (0, speed, 0), more=f"-restitution {e}")
    s.body(f"-box {frame.box((3, 0.5, 3))}", 0, 1, (0, -0.25, 0), more="-fixed 1")
    end = " ".join(f"-{a} {x!r}" for a, x in zip("xyz", frame.place((0, target + 0.1, 0))))
    s.lines.append(f"link -body1 b0 {end} -tightness {k * ratio * frame.mass!r}")
    pieces, t, x, v = [], 0, 1 - target, speed
    while True:  # x(t) = (x + (v + w x) t) e^-wt meets -target at most once going down
        pieces.append((t, x, v))
        move = oscillation(w, 2 * w, x, v)
        rise = v + w * x
        if rise >= 0 and x > -target:
            break
        lowest = v / (w * rise) if rise != 0 and v / (w * rise) > 0 else 0  # where x' = 0
        if not move(lowest) < -target:
            break
        low, high = 0, lowest
        for _ in range(200):
            middle = (low + high) / 2
            low, high = (middle, high) if move(middle) > -target else (low, middle)
        after = (low + high) / 2
        speed = (v - w * rise * after) * math.exp(-w * after)
        t, x, v = t + after, -target, -e * speed

    def truth(at):
        t, x, v = [p for p in pieces if p[0] <= at][-1]
        return [((0, oscillation(w, 2 * w, x, v)(at - t) + target + 0.1, 0), None)]
    s.truth = truth
    return s


# Two masses that attract each other; eccentricity in the place of stiffness.
def kepler(rng, k, ratio, frame):
    e = {1e2: 0, 1e4: 0.5, 1e6: 0.9, 1e9: 0.97, 1e12: 0.99}[k]
    total, axis = 1 + ratio, 1
    strength = (2 * math.pi) ** 2 / total  # a turn takes 1
    s = Scene("kepler", frame, 3)
    far = axis * (1 + e)
    speed = math.sqrt(strength * total * (1 - e) / far)
    at = [(-ratio / total * far, 0, 0), (far / total, 0, 0)]
    velocity = [(0, -ratio / total * speed, 0), (0, speed / total, 0)]
    names = [s.ball(0.001, m, p, v) for m, p, v in zip((1, ratio), at, velocity)]
    a, b = names
    cube = f"(({b}.x-{a}.x)^2+({b}.y-{a}.y)^2+({b}.z-{a}.z)^2)^1.5"
    pull = strength * ratio * frame.mass * frame.length ** 3
    s.force(a, [f"{pull!r}*({b}.{c}-{a}.{c})/{cube}" for c in "xyz"])
    s.force(b, [f"{-pull!r}*({b}.{c}-{a}.{c})/{cube}" for c in "xyz"])

    def truth(t):
        mean = 2 * math.pi * (t + 0.5)
        anomaly = mean
        for _ in range(200):
            anomaly -= (anomaly - e * math.sin(anomaly) - mean) / (1 - e * math.cos(anomaly))
        x, y = -(math.cos(anomaly) - e), -math.sqrt(1 - e * e) * math.sin(anomaly)
        return [((-ratio / total * x, -ratio / total * y, 0), None), ((x / total, y / total, 0), None)]
    s.truth = truth
    return s


# A velocity that follows cos t at the rate K, and a slow one that follows it: time constants 1 to K.
def relaxation(rng, k, ratio, frame):
    s = Scene("relaxation", frame, 4)
    v = [rng.uniform(-1, 1), rng.uniform(-1, 1)]
    a, b = s.ball(0.1, 1, (0, 0, 0), (v[0], 0, 0)), s.ball(0.1, ratio, (0, 1, 0), (v[1], 0, 0))
    s.force(a, (f"{-k * frame.mass!r}*({a}.dx-{frame.length!r}*cos(t))", "0", "0"))
    s.force(b, (f"{-ratio * frame.mass!r}*({b}.dx-{a}.dx)", "0", "0"))
    p, q = k * k / (k * k + 1), k / (k * k + 1)
    r = v[0] - p
    # v_a = p cos t + q sin t + r e^-kt; v_b' + v_b = v_a.
    c, d, f = (p - q) / 2, (p + q) / 2, r / (1 - k)
    g = v[1] - c - f

    def truth(t):
        xa = p * math.sin(t) + q * (1 - math.cos(t)) - r / k * math.expm1(-k * t)
        xb = c * math.sin(t) + d * (1 - math.cos(t)) - f / k * math.expm1(-k * t) - g * math.expm1(-t)
        return [((xa, 0, 0), None), ((xb, 1, 0), None)]
    s.truth = truth
    return s


# A free symmetric top whose inertias are 1 to the ratio (a needle or a plate), faster with the stiffness.
def top(rng, k, ratio, frame):
    rate = k ** 0.25
    slender = rng.random() < 0.5
    axial = 1 / ratio if slender else min(ratio, 2) / 2 + 0.5
    s = Scene("top", frame, min(5, 300 / rate))
    spin = [rate * x for x in turned(about((1, 0, 0), rng.uniform(0.1, 1)), (0, 0, 1))]
    inertia = [frame.mass * frame.length ** 2 * x for x in (1, 1, axial)]
    s.ball(0.5, 1, (0, 0, 0), spin=spin, more=f"-inertia {vector(inertia)}")
    momentum = [spin[0], spin[1], spin[2] * axial]

    def truth(t):
        size = math.sqrt(sum(x * x for x in momentum))
        # The body turns about its axis at w3 (1 - I3/I1), the whole about L at |L|/I1.
        return [((0, 0, 0), product(about(momentum, size * t), about((0, 0, 1), spin[2] * (1 - axial) * t)))]
    s.truth = truth
    return s


KINDS = (spring, pendulum, pair, chain, net, walls, floor, kepler, relaxation, top)
ALIGNED = (spring, relaxation)  # their forces are written along the world's x


def scenes():
    """All 400, in an order that mixes kinds; (name, scene)."""
    number = 0
    for i, k in enumerate(STIFFNESSES):
        for j, ratio in enumerate(RATIOS):
            for turn in range(2):
                for n, kind in enumerate(KINDS):
                    rng = random.Random(f"{kind.__name__} {k} {ratio} {turn}")
                    scale = SCALES[(i + 2 * j + 3 * turn + n) % len(SCALES)]
                    far = turn == 1 and (i + j + n) % 4 == 0
                    frame = Frame(rng, scale, far, kind in ALIGNED or (kind is walls and turn == 0))
                    scene = kind(rng, k, ratio, frame)
                    yield (f"{number:03} {scene.name} k={k:g} ratio={ratio:g} scale={scale:g}{' far' if far else ''}", scene)
                    number += 1
