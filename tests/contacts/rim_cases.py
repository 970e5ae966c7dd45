#!/usr/bin/env python3
"""Writes NAME.al and NAME.values: a can whose rim slides on an edge, a round side or another rim. SI units, g = 9.81.

The equations are derived here once more, and otherwise than in the engine: the angle at which the rim touches is a
coordinate of its own, whose rate is that of the contact along the rim; the force is that with which the rim's point
keeps its velocity across the normal.

usage: rim_cases.py
"""
import functools
import math
import os
import sys

import contact_cases
from contact_cases import G, case, gravity

sys.path.insert(0, os.path.join(contact_cases.HERE, "..", "joints"))
from integration import solve  # noqa: E402
from vectors import attitude, cross, dot, norm, times, turned, turned_back, unit  # noqa: E402
from vectors import add as sum_of_two  # noqa: E402

R, HIGH, MASS = 0.1, 0.3, 1.0
ACROSS, ALONG = MASS * (3 * R * R + HIGH * HIGH) / 12, MASS * R * R / 2
CAN = f"shape_set can -desc {{-sub {{-cylinder {{{R} {HIGH}}}}}}}\n"


def add(*all_of_them):
    return functools.reduce(sum_of_two, all_of_them)


class Rim:
    """Of the can's lower end, at an angle."""

    def __init__(self, q, angle):
        self.axis = turned(q, [0, 1, 0])
        self.out = turned(q, [math.cos(angle), 0, math.sin(angle)])
        self.along = turned(q, [-math.sin(angle), 0, math.cos(angle)])
        self.arm = add(times(-HIGH / 2, self.axis), times(R, self.out))


class Edge:
    """Along z through the origin, of a table at x < 0 and y < 0."""
    text = ("shape_set table -desc {-sub {-box {1 0.5 1}}}\n"
            "body table table -fixed 1 -init_pos {-0.5 -0.25 0}\n")
    angles = 0

    def meet(self, rim, spin, velocity, place, more):
        """The normal, its rate, and those of the angles at which the curves touch."""
        line = [0, 0, 1]
        normal = cross(rim.along, line)
        side = -1 if dot(normal, rim.out) > 0 else 1
        size = norm(normal)
        n = times(side / size, normal)
        across = cross(line, n)
        rate = -dot(velocity, across) / (R * dot(rim.along, across))
        turns = add(cross(spin, rim.along), times(-rate, rim.out))
        change = times(side / size, cross(turns, line))
        return n, add(change, times(-dot(n, change), n)), [rate]

    def is_met(self, n, place, more):
        return n[0] > 0 and n[1] > 0


class Side:
    """Of a cylinder along z that lies below the origin."""
    radius = 0.2
    text = (f"shape_set log -desc {{-sub {{-rot {{1.5707963267948966 0 0}} -cylinder {{{radius} 1}}}}}}\n"
            f"body log log -fixed 1 -init_pos {{0 {-radius} 0}}\n")
    angles = 0

    def meet(self, rim, spin, velocity, place, more):
        flat = [1, 1, 0]
        from_axis = [place[0], place[1] + self.radius, 0]
        n = times(1 / self.radius, from_axis)
        moved = [x * y for x, y in zip(velocity, flat)]
        tangent = [x * y for x, y in zip(rim.along, flat)]
        turns = cross(spin, rim.along)
        rate = -(dot(moved, rim.along) + dot(from_axis, turns)) / (R * dot(tangent, tangent) - dot(from_axis, rim.out))
        return n, times(1 / self.radius, add(moved, times(R * rate, tangent))), [rate]

    def is_met(self, n, place, more):
        return abs(place[2]) < 0.5


class Other:
    """The upper rim of a can that stands, whose angle is 0 at the origin."""
    radius = 0.15
    text = (f"shape_set low -desc {{-sub {{-cylinder {{{radius} 0.4}}}}}}\n"
            f"body low low -fixed 1 -init_pos {{{-radius} -0.2 0}}\n")
    angles = 1

    def meet(self, rim, spin, velocity, place, more):
        angle = more[0]
        out, along = [math.cos(angle), 0, math.sin(angle)], [-math.sin(angle), 0, math.cos(angle)]
        normal = cross(rim.along, along)
        side = -1 if dot(normal, rim.out) > 0 else 1
        size = norm(normal)
        n = times(side / size, normal)
        both = dot(cross(rim.along, along), n)
        rate = -dot(cross(velocity, along), n) / (R * both)
        other = -dot(cross(velocity, rim.along), n) / (self.radius * both)
        turns = add(cross(spin, rim.along), times(-rate, rim.out))
        change = times(side / size, add(cross(turns, along), cross(rim.along, times(-other, out))))
        return n, add(change, times(-dot(n, change), n)), [rate, other]

    def is_met(self, n, place, more):
        return n[1] > 0 and n[0] * math.cos(more[0]) + n[2] * math.sin(more[0]) > 0


def inertia_times(q, w, inverse):
    local = turned_back(q, w)
    sizes = [ACROSS, ALONG, ACROSS]
    return turned(q, [x / s if inverse else x * s for x, s in zip(local, sizes)])


def rates(support):
    def rate(t, y):
        centre, q, velocity, spin, angles = y[:3], y[3:7], y[7:10], y[10:13], y[13:]
        q = unit(q)
        rim = Rim(q, angles[0])
        at = add(velocity, cross(spin, rim.arm))
        n, n_rate, moved = support.meet(rim, spin, at, add(centre, rim.arm), angles[1:])
        arm_rate = add(cross(spin, rim.arm), times(R * moved[0], rim.along))
        free_spin = times(-1, inertia_times(q, cross(spin, inertia_times(q, spin, False)), True))
        free = dot(n_rate, at) + dot(n, add([0, -G, 0], cross(free_spin, rim.arm), cross(spin, arm_rate)))
        by_force = inertia_times(q, cross(rim.arm, n), True)
        force = -free / (1 / MASS + dot(n, cross(by_force, rim.arm)))
        assert force > 0 and support.is_met(n, add(centre, rim.arm), angles[1:])
        assert dot(n, rim.out) < 0 < dot(n, rim.axis)
        half = [0.0] + times(0.5, spin)
        q_rate = [-dot(half[1:], q[1:])] + add(times(q[0], half[1:]), cross(half[1:], q[1:]))
        return velocity + q_rate + add([0, -G, 0], times(force / MASS, n)) + add(free_spin, times(force, by_force)) + moved
    return rate


def lowest(rotation):
    """The angle of the rim's lowest point."""
    right, far = (turned(attitude(rotation), axis)[1] for axis in ([1, 0, 0], [0, 0, 1]))
    return math.atan2(-far, -right)


def slides(name, support, rotation, angle, spin, finish):
    """The rim touches at the origin, where its point has no velocity across the normal."""
    q = attitude(rotation)
    rim = Rim(q, angle)
    centre = times(-1, rim.arm)
    more = [0.0] * support.angles
    n = support.meet(rim, spin, [0.0, 0, 0], [0.0, 0, 0], more)[0]
    velocity = times(-dot(n, cross(spin, rim.arm)), n)
    times_of = [finish / 4, finish / 2, finish]
    found = solve(rates(support), centre + q + velocity + spin + [angle] + more, times_of)
    numbers = "{%r %r %r}"
    case(name, f"simulator -finish {finish}\n" + CAN + support.text +
         f"body b can -mass {MASS} -restitution 0 -init_pos {numbers % tuple(centre)} -init_rot {numbers % tuple(rotation)} "
         f"-init_dpos {numbers % tuple(velocity)} -init_drot {numbers % tuple(spin)}\n" + gravity("b"),
         [(t, size, y[i], "b." + of) for t, y in zip(times_of, found)
          for i, of, size in ((0, "x", 1), (1, "y", 1), (2, "z", 1), (10, "wx", 20), (11, "wy", 20), (12, "wz", 20))])


slides("rim_on_edge", Edge(), [-0.1, 0.4, -0.9], 5.5, [-1.0, -0.2, 3.1], 0.12)
slides("rim_on_edge_flat", Edge(), [0.4, -0.6, -1.1], 0.9, [1.2, 0.7, -3.9], 0.12)
slides("rim_on_side", Side(), [0.0, -0.7, -0.7], lowest([0.0, -0.7, -0.7]), [2.3, 1.9, 3.2], 0.12)
slides("rim_on_side_turns", Side(), [-0.8, 0.5, -0.4], lowest([-0.8, 0.5, -0.4]), [0.7, -3.1, 0.2], 0.12)
slides("rim_on_rim", Other(), [0.4, 0.2, -0.6], 0.8, [0.6, -3.8, 3.0], 0.12)
slides("rim_on_rim_goes_round", Other(), [-0.5, 1.1, -0.6], 5.3, [-3.8, -2.4, -3.6], 0.12)


def tips(name, beside):
    """A glass tips over the edge of a board: a pendulum above it. `beside` the middle of the board its ends are two."""
    radius, high, out = 0.03, 0.12, 0.01
    turning = MASS * (3 * radius ** 2 + high ** 2) / 12 + MASS * (out ** 2 + high ** 2 / 4)

    def place(angle):
        c, s = math.cos(angle), math.sin(angle)
        return -out * c - high / 2 * s, -out * s + high / 2 * c

    instants = [0.05, 0.1, 0.2]
    found = solve(lambda t, y: [y[1], -MASS * G * place(y[0])[0] / turning], [0.0, 0.0], instants)
    rows = []
    for t, (angle, spin) in zip(instants, found):
        x, y = place(angle)
        rows += [(t, 0.1, x, "b.x"), (t, 0.1, y, "b.y"), (t, 0.1, beside, "b.z"), (t, 10, spin, "b.wz")]
    case(name, f"simulator -finish 0.2\nshape_set glass -desc {{-sub {{-cylinder {{{radius} {high}}}}}}}\n"
         "shape_set board -desc {-sub {-box {0.8 0.05 0.6}}}\n"
         "body board board -fixed 1 -init_pos {0.4 -0.025 0} -friction 2\n"
         f"body b glass -mass {MASS} -restitution 0 -init_pos {{{-out} {high / 2} {beside}}} -friction 2\n" + gravity("b"), rows)


tips("glass_tips", 0.0)
tips("glass_tips_beside_the_middle", 0.01)


if __name__ == "__main__":
    contact_cases.main()
