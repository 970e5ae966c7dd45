"""The values of mechanisms and of what a motor controls: rows of time, expression, value, scale."""
import math

import cases
from cases import G, Rows, steps
from integration import solve
from rope_cases import first
from vectors import solved


def bricard():
    return cases.bricard()


def governor():
    return cases.governor()


def four_bar():
    """The linkage of the joints' tests, whose coupler is called rod."""
    rows = Rows()
    for t, expression, value, scale in cases.four_bar():
        if t < 2.5 and not expression.startswith("p3.f"):
            rows.put(t, scale, {expression.replace("rod.", "coupler."): value})
    return rows


def slider_crank():
    """M(a) a'' + M'(a) a'^2 / 2 + V'(a) = couple, a the crank's angle, b the rod's: sin b = -(r / l) sin a, k = b' / a'."""
    rows, at, r, l = Rows(), steps(2, 8), 0.1, 0.3
    own = 0.0005 + 0.5 * 0.05 ** 2

    def rod(a):
        b = math.asin(-r / l * math.sin(a))
        return b, -r * math.cos(a) / (l * math.cos(b))

    def rate(_, y):
        a, w = y
        b, k = rod(a)
        s, c, sb, cb = math.sin(a), math.cos(a), math.sin(b), math.cos(b)
        k1 = r * s / (l * cb) + k * k * math.tan(b)
        x, z = -r * s - l / 2 * sb * k, r * c + l / 2 * cb * k
        x1, z1 = -r * c - l / 2 * (cb * k * k + sb * k1), -r * s + l / 2 * (cb * k1 - sb * k * k)
        p, p1 = -r * s - l * sb * k, -r * c - l * (cb * k * k + sb * k1)
        mass = own + 0.4 * (x * x + z * z) + 0.003 * k * k + 0.8 * p * p
        half = 0.4 * (x * x1 + z * z1) + 0.003 * k * k1 + 0.8 * p * p1
        return [w, (1.5 - 0.1 * w - G * (0.5 * r / 2 * c + 0.4 * z) - half * w * w) / mass]

    for t, (a, w) in zip(at, solve(rate, [0, 0], at)):
        b, _ = rod(a)
        rows.put(t, 10, {"axle.q": a})
        rows.put(t, 100, {"axle.dq": w})
        rows.put(t, 2, {"piston.x": r * math.cos(a) + l * math.cos(b)})
    return rows


def robot_arm():
    """Two links in their plane; the motors carry the weights, so that no gravity is left."""
    rows, at, long, half = Rows(), steps(3, 9), 0.5, 0.2
    first, second = 0.09 + 4 * 0.25 ** 2 + 2 * long ** 2, 0.03 + 2 * half ** 2

    def rate(_, y):
        a, b, u, v = y
        shoulder, elbow = 60 * (1 - a) - 18 * u, 20 * (-1.2 - (b - a)) - 4 * (v - u)
        c, s = 2 * long * half * math.cos(b - a), 2 * long * half * math.sin(b - a)
        return [u, v] + solved([[first, c], [c, second]], [shoulder - elbow + s * v * v, elbow - s * u * u])

    for t, (a, b, u, v) in zip(at, solve(rate, [0, 0, 0, 0], at)):
        rows.put(t, 2, {"shoulder.q": a, "elbow.q": b - a, "fore.x": long * math.cos(a) + half * math.cos(b)})
        rows.put(t, 20, {"shoulder.dq": u, "elbow.dq": v - u})
    return rows


def cart_pendulum():
    """(M + m) x'' - m l (cos q q'' - sin q q'^2) = u,  (I + m l^2) q'' - m l cos q x'' = m g l sin q."""
    rows, at, l, m = Rows(), steps(6, 12), 0.4, 0.2

    def rate(_, y):
        x, q, v, w = y
        push = 3 * x + 4 * v - 45 * q - 10 * w
        c, s = m * l * math.cos(q), m * l * math.sin(q)
        return [v, w] + solved([[1 + m, -c], [-c, 0.0107 + m * l * l]], [push - s * w * w, G * s])

    for t, (x, q, v, w) in zip(at, solve(rate, [0, 0.3, 0, 0], at)):
        rows.put(t, 2, {"track.q": x, "pivot.q": q - 0.3, "pole.x": x - l * math.sin(q)})
        rows.put(t, 20, {"track.dq": v, "pivot.dq": w})
    return rows


def hooke():
    return Rows(row for row in cases.hooke() if not row[1].endswith(".wy"))


def trebuchet():
    """Arm a, weight b, stone x y: the sling's length and, while the floor bears, the stone's height are conditions."""
    rows, m, arm, stone = Rows(), 60, 4, 0.5
    s0 = 0.74
    start_x, start_y = -1.5 * math.sqrt(1 - s0 * s0), 1.2 - 1.5 * s0
    angle = math.asin(s0)
    y0 = [angle, 0.0, start_x + math.sqrt(1.21 - (start_y - 0.06) ** 2), 0.06, 0.0, 0.0, 0.0, 0.0]
    own = 1.4 + arm * 0.25 + m * 0.25

    def parts(y, floor):
        """Rates of a, b, x, y and the two forces: along the sling and of the floor."""
        a, b, x, z, u, v, p, q = y
        c, s, k = math.cos(a), math.sin(a), m * 0.5 * 0.3
        dx, dz = x + 1.5 * c, z - (1.2 - 1.5 * s)
        ra, rp, rq = -1.5 * s * dx + 1.5 * c * dz, dx, dz  # half the rate of the square of the sling
        ex, ez = p - 1.5 * s * u, q + 1.5 * c * u
        bend = ex * ex + ez * ez + (-1.5 * c * dx - 1.5 * s * dz) * u * u
        # The weight's centre: (0.5 cos a + 0.3 sin b, 1.2 + 0.5 sin a - 0.3 cos b).
        mix = k * (math.sin(b - a))
        matrix = [[own, mix, 0, 0, -ra, 0], [mix, 0.9 + m * 0.09, 0, 0, 0, 0], [0, 0, stone, 0, -rp, 0], [0, 0, 0, stone, -rq, -1.0],
                  [ra, 0, rp, rq, 0, 0], [0, 0, 0, 1.0, 0, 0] if floor else [0, 0, 0, 0, 0, 1.0]]
        turn = k * math.cos(b - a)
        right = [-turn * v * v + G * c * (arm * 0.5 - m * 0.5), turn * u * u - m * G * 0.3 * math.sin(b), 0, -stone * G, -bend, 0]
        return solved(matrix, right)

    def rate(floor):
        return lambda t, y: y[4:] + parts(y, floor)[:4]

    lifts = first(0.05, 0.3, lambda t: parts(solve(rate(True), y0, [t])[0], True)[5] < 0)
    up = solve(rate(True), y0, [lifts])[0]

    def swung(t):
        return solve(rate(False), up, [t], start=lifts)[0]

    frees = first(0.48, 0.62, lambda t: swung(t)[6] > 0 and swung(t)[7] < swung(t)[6] * math.tan(math.radians(40)))
    gone = swung(frees)
    for t in [0.1, lifts, 0.3, 0.4, 0.5, frees, 0.7, 1.0, 1.4]:
        y = solve(rate(True), y0, [t])[0] if t <= lifts else swung(min(t, frees))
        s = max(0, t - frees)
        rows.put(t, 20, {"stone.x": y[2] + gone[6] * s, "stone.y": y[3] + gone[7] * s - G * s * s / 2})
        if s == 0:
            rows.put(t, 5, {"axle.q": y[0] - angle})
    return rows
