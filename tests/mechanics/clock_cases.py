"""The values of a pendulum clock, which an own integration ticks through: rows of time, expression, value, scale.

Two coordinates: the wheel's angle a and the pendulum's b. A pin is a circle, a pallet a polygon; while they touch the gap of pin
and pallet is 0, and a multiplier keeps it so until it would pull. A pin that strikes does not bounce.
"""
import math

from cases import G, Rows, steps
from integration import extrapolated

PINS, RADIUS, PIN = 12, 0.1, 0.002
HALF = 2.5 * math.pi / PINS
HIGH, FAR = RADIUS / math.cos(HALF), RADIUS * math.tan(HALF)
DRUM, WEIGHT = 0.008, 0.08
WHEEL = 5e-5 + WEIGHT * DRUM ** 2
ARM, DAMPING = 0.22, 0.01
PENDULUM = 0.00627 + ARM ** 2
STEP = 2e-3


def turned(angle, point):
    c, s = math.cos(angle), math.sin(angle)
    return c * point[0] - s * point[1], s * point[0] + c * point[1]


def polygon(side, corners):
    """Counterclockwise, about the pendulum's pivot."""
    c, s = math.cos(HALF), math.sin(HALF)
    points = [(side * (away * c - deep * s), -away * s - deep * c) for away, deep in corners]
    area = sum(p[0] * q[1] - p[1] * q[0] for p, q in zip(points, points[1:] + points[:1]))
    return points if area > 0 else points[::-1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


NEAR, BEYOND = FAR - PIN, FAR + PIN
PALLETS = [polygon(-1, [(NEAR, -0.0012), (NEAR - 0.018, 0.0026), (NEAR - 0.018, -0.012), (NEAR, -0.012)]),
           polygon(1, [(BEYOND, -0.0012), (BEYOND + 0.018, 0.0026), (BEYOND + 0.018, -0.012), (BEYOND, -0.012)])]


def pin(k, a):
    angle = math.pi / 2 + HALF + 2 * math.pi * k / PINS + a
    return RADIUS * math.cos(angle), RADIUS * math.sin(angle)


def nearest(points, at):
    """The pallet's feature that is nearest: an edge, or the corner that begins it."""
    best = None
    for i, (p, q) in enumerate(zip(points, points[1:] + points[:1])):
        way = q[0] - p[0], q[1] - p[1]
        part = dot((at[0] - p[0], at[1] - p[1]), way) / dot(way, way)
        far = math.dist(at, (p[0] + way[0] * min(max(part, 0), 1), p[1] + way[1] * min(max(part, 0), 1)))
        if best is None or far < best[0]:
            best = far, (i, False) if 0 < part < 1 else ((i + (part >= 1)) % len(points), True)
    return best[1]


def of_feature(points, feature, at):
    """How far it is, the point of it there, and the normal."""
    i, is_corner = feature
    p, q = points[i], points[(i + 1) % len(points)]
    if is_corner:
        far = math.dist(at, p)
        return far, p, ((at[0] - p[0]) / far, (at[1] - p[1]) / far)
    long = math.dist(p, q)
    normal = (q[1] - p[1]) / long, (p[0] - q[0]) / long
    far = dot((at[0] - p[0], at[1] - p[1]), normal)
    return far, (at[0] - far * normal[0], at[1] - far * normal[1]), normal


def feature_of(k, pallet, state):
    at = pin(k, state[0])
    return nearest(PALLETS[pallet], turned(-state[1], (at[0], at[1] - HIGH)))


def touch(k, pallet, feature, state):
    """Of a pin and a pallet's feature: the gap, its derivatives by a and b, what its second rate has without accelerations."""
    a, b, u, v = state
    at = pin(k, a)
    about = at[0], at[1] - HIGH
    far, on, normal = of_feature(PALLETS[pallet], feature, turned(-b, about))
    n, on = turned(b, normal), turned(b, on)
    moves = -at[1], at[0]  # of the pin, by a
    carried = -on[1], on[0]  # of the pallet's point, by b
    by_a, by_b = dot(n, moves), -dot(n, carried)
    relative = moves[0] * u - carried[0] * v, moves[1] * u - carried[1] * v
    if feature[1]:
        more = -dot(n, at) * u * u + dot(n, on) * v * v + (dot(relative, relative) - dot(n, relative) ** 2) / far
    else:  # the normal turns with the pallet
        turns = -n[1], n[0]
        more = -dot(n, at) * u * u + 2 * dot(turns, moves) * u * v - dot(n, about) * v * v
    return far - PIN, by_a, by_b, more


def push(state, contact):
    """The multiplier and the accelerations."""
    a, b, u, v = state
    wheel, swing = -WEIGHT * G * DRUM / WHEEL, -(G * ARM * math.sin(b) + DAMPING * v) / PENDULUM
    if contact is None:
        return 0.0, wheel, swing
    _, by_a, by_b, more = touch(*contact, state)
    force = -(by_a * wheel + by_b * swing + more) / (by_a ** 2 / WHEEL + by_b ** 2 / PENDULUM)
    return force, wheel + by_a * force / WHEEL, swing + by_b * force / PENDULUM


def after(state, contact, step):
    moved = extrapolated(lambda _, y: [y[2], y[3], *push(y, contact)[1:]], 0.0, state, step)[0]
    if contact is not None:  # drift
        gap, by_a, by_b, _ = touch(*contact, moved)
        moved[0] -= gap / by_a
        moved[2] = -by_b * moved[3] / by_a
    return moved


def met(state, but):
    """The pin and pallet that are in each other and approach, and where; none: None."""
    for k in range(PINS):
        for pallet in (0, 1):
            if (k, pallet) != but and math.dist(pin(k, state[0]), (0, HIGH)) < 0.11:
                contact = k, pallet, feature_of(k, pallet, state)
                gap, by_a, by_b, _ = touch(*contact, state)
                if gap < 0 and by_a * state[2] + by_b * state[3] < 0:
                    return contact
    return None


def ended(state, contact):
    """What ends a step before its end: something strikes, a contact opens, or the pin comes to another edge or corner."""
    struck = met(state, contact and contact[:2])
    if struck:
        return "strikes", struck
    if contact and push(state, contact)[0] < 0:
        return "opens", None
    if contact and feature_of(*contact[:2], state) != contact[2]:
        return "goes on", (*contact[:2], feature_of(*contact[:2], state))
    return None


def tick(state, finish, contact):
    """To the finish or the next event: how long it took, the state and the contact."""
    step = min(STEP, finish)
    moved = after(state, contact, step)
    what = ended(moved, contact)
    if not what:
        return step, moved, contact
    low, high = 0.0, step
    for _ in range(60):
        middle = (low + high) / 2
        if not low < middle < high:
            break
        found = ended(after(state, contact, middle), contact)
        low, high, what = (low, middle, found) if found else (middle, high, what)
    moved = after(state, contact, high)
    if what[0] != "strikes":
        return high, moved, what[1]
    _, by_a, by_b, _ = touch(*what[1], moved)
    blow = -(by_a * moved[2] + by_b * moved[3]) / (by_a ** 2 / WHEEL + by_b ** 2 / PENDULUM)
    moved = [moved[0], moved[1], moved[2] + by_a * blow / WHEEL, moved[3] + by_b * blow / PENDULUM]
    return high, moved, what[1] if push(moved, what[1])[0] > 0 else None


def escapement():
    rows, state, contact, t = Rows(), [0.02, 0.08, 0.0, 0.0], None, 0.0
    for at in steps(6, 24):
        while t < at:
            took, state, contact = tick(state, at - t, contact)
            t = at if took == at - t else t + took
        rows.put(at, 0.2, {"pivot.q": state[1] - 0.08})
        rows.put(at, 1, {"arbor.q": state[0] - 0.02})
        rows.put(at, 0.01, {"weight.y": -0.15 + DRUM * (state[0] - 0.02)})
    return rows
