#!/usr/bin/env python3
"""Writes NAME.al and NAME.values: wheels, coins, tops and ellipsoids that roll, rock and spin. SI units, g = 9.81.

usage: curved_cases.py
"""
import math

import contact_cases
from contact_cases import G, case, gravity, ground

SHAPES = ("shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.5 0.4}}}\n"
          "shape_set pill -desc {-sub {-rot {1.5707963267948966 0 0} -capsule {0.2 0.6}}}\n"
          "shape_set disc -desc {-sub {-cylinder {0.1 0}}}\n"
          "shape_set cone -desc {-sub {-cone {0.3 0.8}}}\n"
          "shape_set egg -desc {-sub {-ellipsoid {0.3 0.2 0.25}}}\n")


def turned(axis, angle):
    s = math.sin(angle / 2)
    return f"{{{math.cos(angle / 2)!r} {axis[0] * s!r} {axis[1] * s!r} {axis[2] * s!r}}}"


def on_slope(shape, high, angle, mu, finish, more="", turn=None):
    """A floor that rises along +x and a body that touches it `high` below its centre."""
    c, s = math.cos(angle), math.sin(angle)
    return (f"# zero: {-s!r}*b.x+{c!r}*b.y-{high}\nsimulator -finish {finish}\n" + contact_cases.FLOOR + SHAPES +
            f"body ground floor -fixed 1 -init_pos {{{0.5 * s!r} {-0.5 * c!r} 0}} -init_rot {turned((0, 0, 1), angle)} -friction {mu}\n"
            f"body b {shape} -init_pos {{{-high * s!r} {high * c!r} 0}} -init_rot {turn or turned((0, 0, 1), angle)} "
            f"-restitution 0 -friction {mu} {more}\n" + gravity("b"))


def along(angle):
    return f"{math.cos(angle)!r}*b.x+{math.sin(angle)!r}*b.y"


def falls(name, text, angle, rate):
    case(name, text, [(t, 5, -rate * t * t / 2, along(angle)) for t in (0.5, 1, 2)])


def on_floor(shape, high, mu, finish, more="", ground_more=""):
    return (f"# zero: b.y-{high}\nsimulator -finish {finish}\n" + ground(mu, ground_more) + SHAPES +
            f"body b {shape} -init_pos {{0 {high} 0}} -restitution 0 -friction {mu} {more}\n" + gravity("b"))


# A wheel and a capsule roll down on their sides; the wheel's rim alone weighs something.
down = G * math.sin(0.3)
falls("wheel_down", on_slope("wheel", 0.5, 0.3, 0.5, 2), 0.3, down * 2 / 3)
falls("hoop_down", on_slope("wheel", 0.5, 0.3, 0.5, 2, "-mass 2 -inertia {0.3 0.3 0.5}"), 0.3, down / 2)
falls("wheel_slips_down", on_slope("wheel", 0.5, 0.3, 0.05, 2), 0.3, down - 0.05 * G * math.cos(0.3))
side, ends = 0.2 ** 2 * 0.6, 0.2 ** 3 * 4 / 3
falls("capsule_down", on_slope("pill", 0.2, 0.3, 0.5, 2), 0.3, down / (1 + (side / 2 + ends * 2 / 5) / (side + ends)))
# With its axis down the slope the wheel cannot roll, and on flat ground it need not.
half, quarter_turn = 0.15, math.pi / 4
askew = "{%r %r %r %r}" % (math.cos(half) * math.cos(quarter_turn), -math.sin(half) * math.sin(quarter_turn),
                           math.cos(half) * math.sin(quarter_turn), math.sin(half) * math.cos(quarter_turn))
case("wheel_stays", on_slope("wheel", 0.5, 0.3, 0.5, 1000, turn=askew),
     [(t, 0.1, 0, along(0.3)) for t in (1, 1000)])
for name, mu in (("wheel_rests", 0.5), ("wheel_rests_smooth", 0)):
    case(name, on_floor("wheel", 0.5, mu, 1000, f"-init_rot {turned((0, 1, 0), 0.4)}"), [(t, 0.1, 0, q) for t in (1, 1000) for q in ("b.x", "b.z", "b.wy")])
# A wheel slides, and rolls from t = v / (3 mu g) on with 2/3 v.
mu, v = 0.25, 3
rolls = v / (3 * mu * G)
case("wheel_begins_to_roll", on_floor("wheel", 0.5, mu, 1, f"-init_dpos {{{v} 0 0}}"),
     [(t, 2, v * min(t, rolls) - mu * G * min(t, rolls) ** 2 / 2 + 2 / 3 * v * (t - min(t, rolls)), "b.x") for t in (0.1, rolls, 0.6, 1)] +
     [(1, 4, -2 / 3 * v / 0.5, "b.wz")])
# Two wheels carry a plank that is pushed: (M + 2 * 3/8 m) a = F.
plank = ("# zero: b.y-1.1\n# zero: l.y-0.5\nsimulator -finish 1\n" + ground(0.9) + SHAPES + "shape_set plank -desc {-sub {-box {6 0.2 0.4}}}\n" +
         "".join(f"body {name} wheel -init_pos {{{x} 0.5 0}} -mass 2 -restitution 0 -friction 0.9\n" for name, x in (("l", -1), ("r", 1))) +
         "body b plank -init_pos {0 1.1 0} -mass 3 -restitution 0 -friction 0.9\n" + gravity("l", "r", "b") + "force -body b -x 4.5\n")
case("plank_on_wheels", plank, [(t, 1, t * t / 2, "b.x") for t in (0.5, 1)] + [(t, 1, -1 + t * t / 4, "l.x") for t in (0.5, 1)])

# A thin disc rolls in a circle of radius rho, leaning by `lean`: the torque turns its angular momentum.
R, lean, rho = 0.1, 0.3, 0.5
sine, cosine = math.sin(lean), math.cos(lean)
about, across = R * R / 2, R * R / 4
turns = math.sqrt(G * R * sine / (cosine * (about * rho / R + across * sine + R * rho)))
spin = -turns * (rho + R * sine) / R
coin = ("# zero: b.x^2+b.z^2-0.25\nsimulator -finish 3\n" + ground(0.9) + SHAPES +
        f"body b disc -init_pos {{{rho} {R * cosine!r} 0}} -init_rot {turned((0, 0, 1), lean - math.pi / 2)} -mass 1 -restitution 0 -friction 0.9 "
        f"-init_dpos {{0 0 {-turns * rho!r}}} -init_drot {{{spin * cosine!r} {turns + spin * sine!r} 0}}\n" + gravity("b"))
case("coin_in_a_circle", coin.replace("# zero: b.x^2+b.z^2-0.25\n", ""),
     [(t, 2, rho * math.cos(turns * t), "b.x") for t in (0.5, 1, 3)] + [(t, 2, -rho * math.sin(turns * t), "b.z") for t in (0.5, 1, 3)] +
     [(3, 1, R * cosine, "b.y")])

# A symmetric top on its tip precesses steadily: A w^2 cos t - C s w + m g l = 0, s its spin about its axis, A at the tip.
tilt, spin, C, far = 0.4, 300, 0.02, 0.6
A = 0.01 + far * far
w = (C * spin - math.sqrt((C * spin) ** 2 - 4 * A * math.cos(tilt) * G * far)) / (2 * A * math.cos(tilt))
own = spin - w * math.cos(tilt)  # along the axis, which points up from the tip: the body's -y
top = ("simulator -finish 2\n" + ground(1) + SHAPES +
       f"body b cone -init_pos {{{0.4 * math.sin(tilt)!r} {0.4 * math.cos(tilt)!r} 0}} -init_rot {turned((0, 0, 1), math.pi - tilt)} -mass 1 "
       f"-restitution 0 -friction 1 -inertia {{0.01 {C} 0.01}} -init_dpos {{0 0 {-w * far * math.sin(tilt)!r}}} "
       f"-init_drot {{{own * math.sin(tilt)!r} {w + own * math.cos(tilt)!r} 0}}\n" + gravity("b"))
case("top_precesses", top, [(t, 1, far * math.sin(tilt) * math.cos(w * t), "b.x") for t in (0.5, 1, 2)] +
     [(t, 1, -far * math.sin(tilt) * math.sin(w * t), "b.z") for t in (0.5, 1, 2)] + [(2, 1, far * math.cos(tilt), "b.y")])

# An ellipsoid rocks without slipping: its energy gives the time from one side to the other.
a, b, start = 0.3, 0.2, 0.5
inertia = (a * a + b * b) / 5


def rocking(angle):
    """Height of the centre, and the squared distance of the centre from the lowest point."""
    s, c = math.sin(angle), math.cos(angle)
    high = math.hypot(a * s, b * c)
    return high, (a ** 4 * s * s + b ** 4 * c * c) / high ** 2


def rate(angle):
    high, far = rocking(angle)
    return math.sqrt(max(0, 2 * G * (rocking(start)[0] - high) / (inertia + far)))


def quarter(steps=2000):
    """From `start` to 0, with angle = start sin u, which takes the pole at the start away; Gauss's points."""
    total, root = 0, math.sqrt(3 / 5)
    for i in range(steps):
        for x, weight in ((-root, 5 / 9), (0, 8 / 9), (root, 5 / 9)):
            u = (i + 0.5 + x / 2) / steps * math.pi / 2
            angle = start * math.sin(u)
            high, far = rocking(angle)
            fall = (a * a - b * b) * (math.sin(start) ** 2 - math.sin(angle) ** 2) / (rocking(start)[0] + high)  # of the height
            total += weight / 2 * start * math.cos(u) / math.sqrt(2 * G * fall / (inertia + far))
    return total * math.pi / 2 / steps


swing = quarter()
high = rocking(start)[0]
case("ellipsoid_rocks", "simulator -finish 3\n" + ground(2) + SHAPES +
     f"body b egg -init_pos {{0 {high!r} 0}} -init_rot {turned((0, 0, 1), start)} -restitution 0 -friction 2\n" + gravity("b"),
     [(swing * k, 4, (-1 if k % 4 == 1 else 1) * rate(0), "b.wz") for k in (1, 3, 5)] + [(swing * 4, 1, high, "b.y"), (swing * 4, 4, 0, "b.wz"), (swing * 4, 1, 0, "b.x")])

# A ball slides down a smooth cylinder and leaves it where cos f = 2/3 of where it began.
far, first = 0.6, 0.1
leave = math.acos(2 / 3 * math.cos(first))


def slid(to, steps=4000):
    """Time to this angle: f = first + x^2 takes the pole away."""
    total, root, top = 0, math.sqrt(3 / 5), math.sqrt(to - first)
    for i in range(steps):
        for x, weight in ((-root, 5 / 9), (0, 8 / 9), (root, 5 / 9)):
            u = (i + 0.5 + x / 2) / steps * top
            fall = 2 * math.sin(first + u * u / 2) * math.sin(u * u / 2)  # cos first - cos f
            total += weight / 2 * 2 * u / math.sqrt(2 * G / far * fall)
    return total * top / steps


off = slid(leave)
fast = math.sqrt(2 * G * far * (math.cos(first) - math.cos(leave)))
case("ball_leaves_a_cylinder", f"simulator -finish {off + 0.2!r}\n" + contact_cases.FLOOR + SHAPES + "body c wheel -fixed 1\n" +
     f"body b ball -init_pos {{{far * math.sin(first)!r} {far * math.cos(first)!r} 0}} -restitution 0\n" + gravity("b"),
     [(slid(0.5), 1, far * math.sin(0.5), "b.x"), (off, 1, far * math.sin(leave), "b.x"),
      (off + 0.2, 2, far * math.sin(leave) + fast * math.cos(leave) * 0.2, "b.x"),
      (off + 0.2, 2, far * math.cos(leave) - fast * math.sin(leave) * 0.2 - G * 0.02, "b.y")])
# A smooth wheel that slides over the edge of a table turns about it, until it leaves it.
def pace(angle):
    return math.sqrt(1 / 0.25 + 2 * G / 0.5 * (1 - math.cos(angle)))


at = 0.5
for i in range(2000):
    for x, weight in ((-math.sqrt(3 / 5), 5 / 9), (0, 8 / 9), (math.sqrt(3 / 5), 5 / 9)):
        at += weight / 2 * 0.5 / 2000 / pace((i + 0.5 + x / 2) / 2000 * 0.5)
case("wheel_over_an_edge", "simulator -finish 0.8\n" + SHAPES + "shape_set table -desc {-sub {-box {2 1 2}}}\nbody table table -fixed 1 -init_pos {-1 -0.5 0}\n"
     "body b wheel -init_pos {-0.5 0.5 0} -init_dpos {1 0 0} -restitution 0\n" + gravity("b"),
     [(0.4, 1, -0.1, "b.x"), (at, 1, 0.5 * math.sin(0.5), "b.x"), (at, 1, 0.5 * math.cos(0.5), "b.y")])
# A cylinder that stands is pushed at its top a little less than tips it: F h < m g r.
case("drum_stands_pushed", "simulator -finish 10\n" + ground(0.9) + "shape_set drum -desc {-sub {-cylinder {0.3 0.8}}}\n"
     f"body b drum -init_pos {{0 0.4 0}} -mass 1 -restitution 0 -friction 0.9\nforce -body b -offset {{0 0.4 0}} -x {0.3 / 0.8 * G * 0.99999!r}\n" +
     gravity("b"), [(10, 0.1, 0, "b.x"), (10, 0.1, 0.4, "b.y")])
# A wheel across a fixed one rests.
case("wheels_crossed", "# zero: b.y-1\nsimulator -finish 100\n" + SHAPES + f"body c wheel -fixed 1 -init_rot {turned((0, 1, 0), math.pi / 2)} -friction 0.5\n" +
     "body b wheel -init_pos {0 1 0} -restitution 0 -friction 0.5\n" + gravity("b"), [(100, 0.1, 0, "b.x"), (100, 0.1, 0, "b.z")])

# Rolling friction R slows a ball by 5/7 R g / r and a wheel on a slope by 2/3 of it, and holds where R cos f >= r sin f.
slow = 5 / 7 * 0.01 * G / 0.1
stop = 1 / slow
case("rolling_friction", "# zero: b.y-0.1\nsimulator -finish 3\n" + ground(0.5) +
     "body b ball -init_pos {0 0.1 0} -init_dpos {1 0 0} -init_drot {0 0 -10} -restitution 0 -friction 0.5 -rolling_friction 0.01\n" + gravity("b"),
     [(t, 1, min(t, stop) - slow * min(t, stop) ** 2 / 2, "b.x") for t in (0.5, 1, stop, 3)] + [(3, 1, 0, "b.dx")])
falls("wheel_with_rolling_friction", on_slope("wheel", 0.5, 0.3, 0.5, 2, "-rolling_friction 0.06"), 0.3,
      (down - 0.06 / 0.5 * G * math.cos(0.3)) * 2 / 3)
case("held_by_rolling_friction", on_slope("wheel", 0.5, 0.1, 0.5, 1000, "-rolling_friction 0.06"), [(t, 0.1, 0, along(0.1)) for t in (1, 1000)])

# A conveyor takes a block along; a ball between still and moving ground rolls at 2/7 of its speed.
taken = 1 / (0.3 * G)
case("conveyor", "# zero: b.y-0.1\nsimulator -finish 1\n" + ground(0.3, "-surface_velocity {1 0 0}") +
     "shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}\nbody b block -init_pos {0 0.1 0} -mass 1 -restitution 0 -friction 0.3\n" + gravity("b"),
     [(t, 1, 0.3 * G * min(t, taken) ** 2 / 2 + (t - min(t, taken)), "b.x") for t in (0.1, taken, 0.5, 1)])
gripped = 2 / (7 * 0.3 * G)
case("conveyor_turns_a_ball", "# zero: b.y-0.1\nsimulator -finish 1\n" + ground(0.3, "-surface_velocity {1 0 0}") +
     "body b ball -init_pos {0 0.1 0} -mass 1 -restitution 0 -friction 0.3\n" + gravity("b"),
     [(t, 1, 0.3 * G * min(t, gripped) ** 2 / 2 + 2 / 7 * (t - min(t, gripped)), "b.x") for t in (0.05, gripped, 0.5, 1)] +
     [(1, 10, 50 / 7, "b.wz")])

# A car on four wheels rolls down: all of them bear, though three would do.
c, s = math.cos(0.2), math.sin(0.2)
wheels = [(f"w{i}", x, z) for i, (x, z) in enumerate(((-0.7, -0.6), (-0.7, 0.6), (0.7, -0.6), (0.7, 0.6)))]
case("car_down", "".join(f"# zero: {-s!r}*{name}.x+{c!r}*{name}.y-0.1\n" for name, _, _ in wheels) + "simulator -finish 1\n" +
     contact_cases.FLOOR + f"body ground floor -fixed 1 -init_pos {{{0.5 * s!r} {-0.5 * c!r} 0}} -init_rot {turned((0, 0, 1), 0.2)} -friction 1\n"
     f"shape_set chassis -desc {{-sub {{-box {{2 0.1 1}}}}}}\nbody b chassis -init_pos {{{-0.2 * s!r} {0.2 * c!r} 0}} "
     f"-init_rot {turned((0, 0, 1), 0.2)} -mass 10\n" + gravity("b") +
     "".join(f"body {name} ball -init_pos {{{x * c - 0.1 * s!r} {x * s + 0.1 * c!r} {z}}} -mass 1 -restitution 0 -friction 1\n"
             f"joint j{name} -type hinge -body1 {name} -offset1 {{0 0 0}} -body2 b\n" + gravity(name) for name, x, z in wheels),
     [(t, 5, -G * s * 14 / 15.6 * t * t / 2, along(0.2)) for t in (0.2, 0.5, 1)] +
     [(1, 50, G * s * 14 / 15.6 / 0.1, f"{name}.wz") for name, _, _ in wheels])


if __name__ == "__main__":
    contact_cases.main()
