#!/usr/bin/env python3
"""Writes NAME.al and NAME.values: balls in tubes and bowls, and these themselves. SI units, g = 9.81.

usage: hollow_cases.py
"""
import math
import os
import sys

import contact_cases
from contact_cases import G, case, gravity, ground

sys.path.insert(0, os.path.join(contact_cases.HERE, "..", "joints"))
from integration import solve  # noqa: E402

TURNED = "-rot {1.5707963267948966 0 0}"  # the axis along z
SHAPES = ("shape_set ball -desc {-sub {-sphere 0.1}}\nshape_set bowl -desc {-sub {-bowl {1 1.1}}}\n"
          f"shape_set hoop -desc {{-sub {{{TURNED} -tube {{1 1.1 0.6}}}}}}\n"
          "shape_set pipe -desc {-sub {-rot {0 0 1.5707963267948966} -tube {0.5 0.6 20}}}\n")
A = 0.9  # from the middle of bowl and hoop to the ball's


def within(shape, mu, place, finish, more="", ball="-restitution 0", zero="b.x^2+b.y^2+b.z^2-0.81"):
    """A ball in something that stands at the origin."""
    x, y, z = place
    return (f"# zero: {zero}\nsimulator -finish {finish}\n" + SHAPES +
            f"body still {shape} -fixed 1 -friction {mu}\n"
            f"body b ball -init_pos {{{x!r} {y!r} {z!r}}} -mass 1 {ball} -friction {mu} {more}\n" + gravity("b"))


def at(angle):
    return A * math.sin(angle), -A * math.cos(angle), 0.0


def swing(name, shape, mu, angle, inertia, speed=0.0):
    """(1 + inertia) a q'' = -g sin q; a ball that rolls has 2/5, one that slides 0."""
    times = [0.2, 0.5, 1, 1.7, 2.5, 3]
    found = solve(lambda t, y: [y[1], -G / A / (1 + inertia) * math.sin(y[0])], [angle, speed / A], times)
    c, s = math.cos(angle), math.sin(angle)
    move = f"-init_dpos {{{speed * c!r} {speed * s!r} 0}} -init_drot {{0 0 {-speed / 0.1 if inertia else 0.0!r}}}"
    rows = []
    for t, (q, w) in zip(times, found):
        rows += [(t, 2, A * math.sin(q), "b.x"), (t, 2, -A * math.cos(q), "b.y"), (t, 0.1, 0, "b.z")]
        rows += [(t, 20 * A, (-A / 0.1 if inertia else 0) * w, "b.wz")]
    case(name, within(shape, mu, at(angle), 3, move), rows)


swing("bowl_rolls", "bowl", 0.9, 1.0, 2 / 5)
swing("bowl_rolls_little", "bowl", 0.9, 0.01, 2 / 5)
swing("bowl_slides", "bowl", 0, 1.2, 0)
swing("hoop_rolls", "hoop", 0.9, 0.8, 2 / 5)
swing("hoop_goes_round", "hoop", 0, 0.0, 0, 6.7)  # v^2 > 5 g a

# Round in a bowl, at one height.
turns = math.sqrt(G / (A * math.cos(0.7)))
wide = A * math.sin(0.7)
case("bowl_circles", within("bowl", 0, at(0.7), 3, f"-init_dpos {{0 0 {-turns * wide!r}}}"),
     [(t, 5, value, q) for t in (0.5, 1, 2, 3) for value, q in
      ((wide * math.cos(turns * t), "b.x"), (-wide * math.sin(turns * t), "b.z"), (-A * math.cos(0.7), "b.y"))])

# Too slow for the whole loop: the ball leaves where cos q = (2 g a - v^2) / (3 g a), and flies on until it meets the hoop.
v = 5.5
leaves = math.acos((2 * G * A - v * v) / (3 * G * A))
fine = [i * 1e-4 for i in range(1, 20000)]
path = solve(lambda t, y: [y[1], -G / A * math.sin(y[0])], [0, v / A], fine)
low = min(i for i, (q, w) in enumerate(path) if q >= leaves) - 1
begin, (q0, w0) = fine[low], path[low]
span = 0.0
for _ in range(50):  # Newton's method, on the time from the last point before
    q, w = solve(lambda t, y: [y[1], -G / A * math.sin(y[0])], [q0, w0], [span])[0] if span else (q0, w0)
    span -= (q - leaves) / w
instant, speed = begin + span, math.sqrt(v * v - 2 * G * A * (1 - math.cos(leaves)))
x0, y0, _ = at(leaves)
vx, vy = speed * math.cos(leaves), speed * math.sin(leaves)
flies = [(instant + s, x0 + vx * s, y0 + vy * s - G * s * s / 2) for s in (0.05, 0.15, 0.25)]
case("hoop_is_left", within("hoop", 0, at(0.0), 1.2, f"-init_dpos {{{v} 0 0}}", zero="b.z"),
     [(t, 3, value, q) for t, x, y in flies for value, q in ((x, "b.x"), (y, "b.y"))] +
     [(instant / 2, 3, A * math.sin(solve(lambda t, y: [y[1], -G / A * math.sin(y[0])], [0, v / A], [instant / 2])[0][0]), "b.x")])


# A ball falls beside the middle of a bowl and bounces.
def bounces(x, y, e, until):
    """Flights (begin, place, velocity) of a point within the ball of radius A."""
    t, p, u, flights = 0.0, [x, y], [0.0, 0.0], []
    while t < until:
        flights.append((t, list(p), list(u)))
        place = lambda s: (p[0] + u[0] * s, p[1] + u[1] * s - G * s * s / 2)  # noqa: E731
        out = lambda s: math.hypot(*place(s)) - A  # noqa: E731
        low = 1e-3
        while out(low + 1e-3) < 0:
            low += 1e-3
        high = low + 1e-3
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (middle, high) if out(middle) < 0 else (low, middle)
        p, t, u = list(place(low)), t + low, [u[0], u[1] - G * low]
        n = [-p[0] / math.hypot(*p), -p[1] / math.hypot(*p)]
        normal = u[0] * n[0] + u[1] * n[1]
        u = [u[i] - (1 + e) * normal * n[i] for i in range(2)]
    return flights


rows = []
flights = bounces(0.2, 0.1, 0.9, 1.5)
for k, (begin, p, u) in enumerate(flights):
    s = ((flights[k + 1][0] if k + 1 < len(flights) else 1.5) - begin) / 2
    rows += [(begin + s, 10, p[0] + u[0] * s, "b.x"), (begin + s, 10, p[1] + u[1] * s - G * s * s / 2, "b.y")]
case("bowl_bounces", within("bowl", 0, (0.2, 0.1, 0.0), 1.5, "", "-restitution 0.9", "b.z"), rows)

# Along the bottom of a pipe: as on a floor.
mu, v = 0.25, 3
rolls = 2 * v / (7 * mu * G)
case("pipe_begins_to_roll", within("pipe", mu, (0.0, -0.4, 0.0), 1, f"-init_dpos {{{v} 0 0}}", zero="b.y+0.4"),
     [(t, 3, v * min(t, rolls) - mu * G * min(t, rolls) ** 2 / 2 + 5 / 7 * v * (t - min(t, rolls)), "b.x") for t in (0.1, rolls, 0.6, 1)] +
     [(1, 30, -5 / 7 * v / 0.1, "b.wz")])

# A ball of 1 kg in a hoop of 3 kg that nothing holds: they swap the speeds that they have against each other.
free = ("# zero: b.z\nsimulator -finish 2\n" + SHAPES + "body hoop hoop -mass 3\nbody b ball -init_dpos {4 0 0} -mass 1\n")
hits = [0.9 / 4 + 1.8 / 4 * k for k in range(5)]


def ball_at(t):
    """The middle goes at 1; against it the ball at 3 and -3, the hoop at -1 and 1."""
    place, last, way = 0.0, 0.0, 1
    for hit in hits + [math.inf]:
        place += way * 3 * (min(t, hit) - last)
        if t <= hit:
            return t + place
        last, way = hit, -way
    raise ValueError(t)


case("hoop_is_free", free, [(t, 8, ball_at(t), "b.x") for t in (0.2, 0.4, 0.9, 1.5, 2)] +
     [(t, 8, (4 * t - ball_at(t)) / 3, "hoop.x") for t in (0.4, 0.9, 2)])

# A tube rolls down a slope on its outside, and a bowl rocks on a floor.
inner, outer = 1.0, 1.1
c, s = math.cos(0.3), math.sin(0.3)
turn = f"{{{math.cos(0.15)!r} 0 0 {math.sin(0.15)!r}}}"
case("hoop_rolls_down", f"# zero: {-s!r}*b.x+{c!r}*b.y-1.1\nsimulator -finish 2\n" + contact_cases.FLOOR + SHAPES.replace("shape_set ball -desc {-sub {-sphere 0.1}}\n", "") +
     f"body ground floor -fixed 1 -init_pos {{{0.5 * s!r} {-0.5 * c!r} 0}} -init_rot {turn} -friction 0.8\n"
     f"body b hoop -init_pos {{{-1.1 * s!r} {1.1 * c!r} 0}} -restitution 0 -friction 0.8\n" + gravity("b"),
     [(t, 5, -G * s / (1 + (inner ** 2 + outer ** 2) / (2 * outer ** 2)) * t * t / 2, f"{c!r}*b.x+{s!r}*b.y") for t in (0.5, 1, 2)])

cube = outer ** 3 - inner ** 3
depth = 3 * (outer ** 4 - inner ** 4) / (8 * cube)  # of the centroid under the middle
about = 2 * (outer ** 5 - inner ** 5) / (5 * cube) - depth ** 2  # inertia over mass, about the centroid


def rocking(t, y):
    q, w = y
    m = about + outer ** 2 + depth ** 2 - 2 * outer * depth * math.cos(q)
    return [w, -(outer * depth * math.sin(q) * w * w + G * depth * math.sin(q)) / m]


times = [0.3, 0.7, 1.2, 2]
tilt = 0.9
case("bowl_rocks", "# zero: b.z\nsimulator -finish 2\n" + SHAPES.replace("shape_set ball -desc {-sub {-sphere 0.1}}\n", "") + ground(0.9) +
     f"body b bowl -init_pos {{{0.0} 1.1 0}} -init_rot {{0 0 {tilt}}} -restitution 0 -friction 0.9\n" + gravity("b"),
     [row for t, (q, w) in zip(times, solve(rocking, [tilt, 0], times))
      for row in ((t, 2, outer * (tilt - q) + depth * math.sin(q), "b.x"), (t, 2, outer - depth * math.cos(q), "b.y"), (t, 10, w, "b.wz"))])

# A rod slides in a bowl on both of its ends: a pendulum of the length from the middle of the bowl to that of the rod.
radius, length = 0.1, 1.0
tube, balls = radius ** 2 * length, radius ** 3 * 4 / 3  # volumes over pi
rod_across = (tube * (length ** 2 / 12 + radius ** 2 / 4) +
              balls * (length ** 2 / 4 + 3 * length * radius / 8 + 2 * radius ** 2 / 5)) / (tube + balls)
hang = math.sqrt(A * A - length * length / 4)
times = [0.2, 0.5, 1, 1.5, 2]
case("rod_in_bowl", "# zero: b.x^2+b.y^2-%r\n# zero: b.z\nsimulator -finish 2\n" % (hang * hang) + SHAPES +
     "shape_set rod -desc {-sub {-rot {0 0 1.5707963267948966} -capsule {0.1 1}}}\nbody still bowl -fixed 1\n"
     f"body b rod -init_pos {{{hang * math.sin(0.5)!r} {-hang * math.cos(0.5)!r} 0}} -init_rot {{0 0 0.5}} -restitution 0\n" + gravity("b"),
     [row for t, (q, w) in zip(times, solve(lambda t, y: [y[1], -G * hang / (hang * hang + rod_across) * math.sin(y[0])], [0.5, 0], times))
      for row in ((t, 2, hang * math.sin(q), "b.x"), (t, 2, -hang * math.cos(q), "b.y"), (t, 10, w, "b.wz"))])
# A box slides along a pipe on its lower edges: its weight wedges it, so friction is larger by the slope of the wall.
low = math.sqrt(0.5 ** 2 - 0.2 ** 2)
slows, v = 0.25 * G * 0.5 / low, 2
case("box_in_pipe", f"# zero: b.y+{low - 0.1!r}\nsimulator -finish 0.7\n" + SHAPES + "shape_set box -desc {-sub {-box {0.6 0.2 0.4}}}\n"
     "body still pipe -fixed 1 -friction 0.25\n"
     f"body b box -init_pos {{0 {0.1 - low!r} 0}} -init_dpos {{{v} 0 0}} -mass 1 -restitution 0 -friction 0.25\n" + gravity("b"),
     [(t, 2, v * min(t, v / slows) - slows * min(t, v / slows) ** 2 / 2, "b.x") for t in (0.1, 0.4, 0.7)])


if __name__ == "__main__":
    contact_cases.main()
