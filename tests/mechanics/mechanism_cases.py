"""The values of mechanisms and of what a motor controls: rows of time, expression, value, scale."""
import math

import cases
from cases import G, Rows, steps
from integration import solve
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
