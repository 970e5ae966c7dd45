#!/usr/bin/env python3
"""Writes NAME.al and NAME.values: bodies in contact with friction, with closed forms. SI units, g = 9.81.

usage: contact_cases.py
"""
import math
import os

G = 9.81
HERE = os.path.dirname(os.path.abspath(__file__))
FLOOR = "shape_set floor -desc {-sub {-box {60 1 4}}}\nshape_set ball -desc {-sub {-sphere 0.1}}\n"


def gravity(*bodies):
    return "".join(f"force -body {body} -gravitational {{0 -{G} 0}}\n" for body in bodies)


def ground(friction, more=""):
    return FLOOR + f"body ground floor -fixed 1 -init_pos {{0 -0.5 0}} -friction {friction} {more}\n"


def slope(angle, mu, speed, finish, radius=None, static=None):
    """A floor that rises along +x, and a body on it: a box of 0.4 x 0.2 x 0.3, or a ball."""
    c, s = math.cos(angle), math.sin(angle)
    turn = f"{{{math.cos(angle / 2)!r} 0 0 {math.sin(angle / 2)!r}}}"
    high = radius or 0.1
    friction = f"-friction {mu}" + (f" -static_friction {static}" if static else "")
    shape = "ball" if radius else "block"
    return (f"# zero: {-s!r}*b.x+{c!r}*b.y-{high}\nsimulator -finish {finish}\n" + FLOOR +
            "shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}\n"
            f"body ground floor -fixed 1 -init_pos {{{0.5 * s!r} {-0.5 * c!r} 0}} -init_rot {turn} {friction}\n"
            f"body b {shape} -init_pos {{{-high * s!r} {high * c!r} 0}} -init_rot {turn} -mass 1 -restitution 0 {friction} "
            f"-init_dpos {{{speed * c!r} {speed * s!r} 0}}\n" + gravity("b"))


def along(angle, high):
    return f"{math.cos(angle)!r}*b.x+{math.sin(angle)!r}*b.y"


CASES = {}


def case(name, text, rows):
    CASES[name] = (text, rows)


# A block thrown up an incline stops and stays: t = v / (g (sin a + mu cos a)).
a, mu, v = 0.3, 0.4, 5
slowing = G * (math.sin(a) + mu * math.cos(a))
stop = v / slowing
case("thrown_up", slope(a, mu, v, 3),
     [(t, 2, v * min(t, stop) - slowing * min(t, stop) ** 2 / 2, along(a, 0.1)) for t in (0.2, 0.5, stop, 1, 3)] +
     [(t, 5, 0, "b.dx") for t in (1, 3)])
# The same stays where it is with more friction, for a thousand seconds, to the last bit.
case("stays", slope(0.5, 0.6, 0, 1000), [(t, 0.1, 0, along(0.5, 0.1)) for t in (1, 10, 1000)])
# What the static coefficient holds; beyond it the block slides with the other one.
case("held_by_static", slope(0.5, 0.3, 0, 10, static=0.6), [(t, 0.1, 0, along(0.5, 0.1)) for t in (1, 10)])
# A billionth of friction more than the slope's tangent holds, a billionth less slides: by 2 mm in a thousand seconds.
for name, part in (("just_stays", 1e-9), ("just_slides", -1e-9)):
    mu = math.tan(0.5) * (1 + part)
    slides = -G * (math.sin(0.5) - mu * math.cos(0.5)) if part < 0 else 0
    case(name, slope(0.5, repr(mu), 0, 1000), [(t, 1, slides * t * t / 2, along(0.5, 0.1)) for t in (500, 1000)])
slides = -G * (math.sin(0.5) - 0.3 * math.cos(0.5))
case("slides", slope(0.5, 0.3, 0, 1, static=0.5), [(t, 1, slides * t * t / 2, along(0.5, 0.1)) for t in (0.25, 0.5, 1)])
# A ball slides, and rolls from t = 2 v / (7 mu g) on with 5/7 v.
mu, v = 0.25, 3
rolls = 2 * v / (7 * mu * G)


def rolled(t):
    slid = min(t, rolls)
    return v * slid - mu * G * slid ** 2 / 2 + 5 / 7 * v * (t - slid)


case("begins_to_roll", "# zero: b.y-0.1\nsimulator -finish 1\n" + ground(mu) +
     f"body b ball -init_pos {{0 0.1 0}} -init_dpos {{{v} 0 0}} -friction {mu} -mass 1 -restitution 0\n" + gravity("b"),
     [(t, 2, rolled(t), "b.x") for t in (0.1, 0.3, rolls, 0.6, 1)] + [(1, 20, -5 / 7 * v / 0.1, "b.wz"), (0.1, 20, -2.5 * mu * G * 0.1 / 0.1, "b.wz")])
# Down a slope: it rolls with 5/7 g sin a, or slides where friction is less than 2/7 tan a.
case("rolls_down", slope(0.3, 0.5, 0, 2, radius=0.1), [(t, 6, -5 / 14 * G * math.sin(0.3) * t * t, along(0.3, 0.1)) for t in (0.5, 1, 2)])
free = G * (math.sin(0.6) - 0.1 * math.cos(0.6))
case("slides_down", slope(0.6, 0.1, 0, 2, radius=0.1), [(t, 10, -free * t * t / 2, along(0.6, 0.1)) for t in (0.5, 1, 2)] +
     [(2, 40, 2.5 * 0.1 * G * math.cos(0.6) * 2 / 0.1, "b.wz")])
# A box down a slope of 1 : 2, across x, where each sum y + z / 2 of its corners is the same.
tilt, mu = math.atan(0.5), 0.3
down = (-math.sin(tilt), math.cos(tilt))
case("slides_down_across", f"# zero: {math.cos(tilt)!r}*b.y+{math.sin(tilt)!r}*b.z-0.05\nsimulator -finish 0.5\n"
     "shape_set ramp -desc {-sub {-box {1 1 8}}}\nshape_set box -desc {-sub {-box {0.2 0.1 0.4}}}\n"
     f"body ramp ramp -init_pos {{0 {-0.5 * down[1]!r} {0.5 * down[0]!r}}} -init_rot {{{tilt!r} 0 0}} -fixed 1 -friction {mu}\n"
     f"body b box -init_pos {{0 {0.05 * down[1]!r} {-0.05 * down[0]!r}}} -init_rot {{{tilt!r} 0 0}} -restitution 0 -mass 1 -friction {mu}\n" + gravity("b"),
     [(t, 1, G * (math.sin(tilt) - mu * math.cos(tilt)) * t * t / 2, f"{down[0]!r}*b.y+{down[1]!r}*b.z") for t in (0.2, 0.5)] +
     [(0.5, 1, 0, "b.wx")])
# A box on a floor, pushed across the way that planes of motion are looked for first.
for name, force in (("pushed_rests", 1), ("pushed_slides", 3.5)):
    case(name, "# zero: b.y-0.05\nsimulator -finish 1\n" + ground(mu) +
         "shape_set box -desc {-sub {-box {0.2 0.1 0.4}}}\n"
         f"body b box -init_pos {{0 0.05 0}} -mass 1 -friction {mu} -restitution 0\nforce -body b -z {force}\n" + gravity("b"),
         [(t, 1, max(0, force - mu * G) * t * t / 2, "b.z") for t in (0.5, 1)] + [(1, 1, 0, "b.wx")])

def pushed(force, start, t, steps=40000):
    """Where a point of mass 1 is that begins to slip at `start`: the midpoint rule, in which friction is taken at
    the mean velocity, and two extrapolations of it."""
    def ends(count):
        step = (t - start) / count
        speed, place = [0.0, 0.0], [0.0, 0.0]
        for k in range(count):
            push = force(start + (k + 0.5) * step)
            ahead = [v + step / 2 * f for v, f in zip(speed, push)]
            size = math.hypot(*ahead)
            mean = [a * max(0, 1 - step / 2 * mu * G / size) for a in ahead]
            place = [x + step * v for x, v in zip(place, mean)]
            speed = [2 * v - u for v, u in zip(mean, speed)]
        return place
    if t <= start:
        return 0, 0
    one, two, four = (ends(steps * k) for k in (1, 2, 4))
    better = [[(4 * q - p) / 3 for p, q in zip(a, b)] for a, b in ((one, two), (two, four))]
    return [(16 * q - p) / 15 for p, q in zip(*better)]


# A force that grows across another one, and one that goes round: the way of the slip turns, from the first instant on.
for name, x, z, start, finish, force in (
        ("pushed_across", "2", "t", math.sqrt((mu * G) ** 2 - 4), 3, lambda t: (2, t)),
        ("pushed_round", "3*cos(t)", "3*sin(t)", 0, 6, lambda t: (3 * math.cos(t), 3 * math.sin(t)))):
    case(name, f"# zero: b.y-0.05\nsimulator -finish {finish}\n" + ground(mu) +
         "shape_set box -desc {-sub {-box {0.2 0.1 0.2}}}\n"
         f"body b box -init_pos {{0 0.05 0}} -mass 1 -friction {mu} -restitution 0\nforce -body b -x {x} -z {z}\n" + gravity("b"),
         [(t, 1, place, "b." + axis) for t in (finish / 2, finish - 0.5, finish)
          for axis, place in zip("xz", pushed(force, start, t))])
# A box put down on a belt that runs that way.
alike = 1 / (mu * G)
case("belt_across", f"# zero: b.y-0.05\nsimulator -finish 1\n" + ground(mu, "-surface_velocity {0 0 1}") +
     "shape_set box -desc {-sub {-box {0.2 0.1 0.2}}}\n"
     f"body b box -init_pos {{0 0.05 -0.5}} -mass 1 -friction {mu} -restitution 0\n" + gravity("b"),
     [(t, 1, mu * G * min(t, alike) ** 2 / 2 + max(0, t - alike) - 0.5, "b.z") for t in (0.2, alike, 1)] + [(1, 1, 0, "b.wx")])
# A plank on two blocks, pulled by a force that grows.
yields = math.sqrt(0.25 * 1) * G
case("plank_pulled", f"# zero: b.y-0.05\nsimulator -finish {yields + 1!r}\nshape_set post -desc {{-sub {{-box {{0.1 1 0.4}}}}}}\n"
     "shape_set plank -desc {-sub {-box {1.4 0.1 0.2}}}\n" +
     "".join(f"body s{i} post -init_pos {{{x} -0.5 0}} -fixed 1 -friction 0.25\n" for i, x in ((1, -0.5), (2, 0.5))) +
     "body b plank -init_pos {0 0.05 0} -friction 1 -restitution 0 -mass 1\nforce -body b -x t\n" + gravity("b"),
     [(yields + t, 1, t ** 3 / 6, "b.x") for t in (0, 0.5, 1)])
# A block on a cart: one speed from t = v / (mu g (1 + m / M)) on.
mu, v, m, big = 0.3, 4, 1, 3
together = v / (mu * G * (1 + m / big))
case("cart", "# zero: b.y-0.3\n# zero: c.y-0.1\nsimulator -finish 2\n" + ground(0) +
     "shape_set cart -desc {-sub {-box {8 0.2 1}}}\nshape_set block -desc {-sub {-box {0.2 0.2 0.2}}}\n"
     f"body c cart -init_pos {{0 0.1 0}} -mass {big} -friction {mu} -restitution 0\n"
     f"body b block -init_pos {{0 0.3 0}} -init_dpos {{{v} 0 0}} -mass {m} -friction {mu} -restitution 0\n" + gravity("b", "c"),
     [(t, 8, v * min(t, together) - mu * G * min(t, together) ** 2 / 2 + (t - min(t, together)), "b.x") for t in (0.5, 1, together, 1.5, 2)] +
     [(t, 8, mu * G * m / big * min(t, together) ** 2 / 2 + (t - min(t, together)), "c.x") for t in (0.5, 1, together, 1.5, 2)])
# A ball meets the floor obliquely: it sticks, or it slips with mu times the normal impulse.
for name, vx, w in (("bounce_sticks", 5, 0), ("bounce_slips", 1, 50)):
    slip, normal = vx + 0.1 * w, (1 + 0.8) * 4
    impulse = min(0.2 * normal, 2 / 7 * slip)
    case(name, "# zero: b.z\nsimulator -finish 0.3\n" + ground(0.2, "-restitution 0.8") +
         f"body b ball -init_pos {{0 0.5 0}} -init_dpos {{{vx} -4 0}} -init_drot {{0 0 {w}}} -friction 0.2 -mass 1 -restitution 0.8\n",
         [(0.2, 5, vx - impulse, "b.dx"), (0.2, 5, 3.2, "b.dy"), (0.2, 50, w - 2.5 * impulse / 0.1, "b.wz")])
# Stacks, a pyramid and three balls stand.
BLOCK = "shape_set block -desc {-sub {-box {1 1 1}}}\n"
stack = "".join(f"body b{i} block -init_pos {{{0.1 * (i % 2)} {0.5 + i} 0}} -friction 0.5 -restitution 0\n" for i in range(6))
case("stack", "# zero: b5.y-5.5\nsimulator -finish 20\n" + ground(0.5) + BLOCK + stack + gravity(*(f"b{i}" for i in range(6))),
     [(t, 1, 0.1, "b5.x") for t in (1, 20)] + [(20, 1, 2.5, "b2.y")])
pyramid = [(f"b{row}{k}", 1.1 * (k - (3 - row) / 2), 0.5 + row) for row in range(4) for k in range(4 - row)]
case("pyramid", "# zero: b30.y-3.5\nsimulator -finish 20\n" + ground(0.5) + BLOCK +
     "".join(f"body {name} block -init_pos {{{x!r} {y!r} 0}} -friction 0.5 -restitution 0\n" for name, x, y in pyramid) +
     gravity(*(name for name, _, _ in pyramid)), [(20, 1, x, name + ".x") for name, x, _ in pyramid])

# Two balls below and one above stand if their friction is at least 2 - sqrt 3.
HIGH = 0.5 + math.sqrt(3) / 2
case("three_balls", "# zero: l.y-0.5\nsimulator -finish 10\n" + ground(0.27) + "shape_set large -desc {-sub {-sphere 0.5}}\n" +
     "".join(f"body {name} large -init_pos {{{x} {y!r} 0}} -friction 0.27 -restitution 0\n"
             for name, x, y in (("l", -0.5, 0.5), ("r", 0.5, 0.5), ("top", 0, HIGH))) + gravity("l", "r", "top"),
     [(10, 1, HIGH, "top.y"), (10, 1, -0.5, "l.x")])

# A contact of the pair has its own friction, whatever its bodies have.
a, mu, v = 0.3, 0.4, 5
case("pair_friction", slope(a, 0, v, 3) + f"contact -body1 b -body2 ground -friction {mu}\n",
     [(t, 2, v * min(t, stop) - slowing * min(t, stop) ** 2 / 2, along(a, 0.1)) for t in (0.2, 0.5, stop, 1, 3)])
# Of three balls that fall on one floor one bounces as the pair says, one of the floor's group meets it, one does not.
down, fall = 0.4, math.sqrt(2 * 0.4 / G)


def bounced(e):
    return lambda t: down - G * t * t / 2 if t < fall else e * G * fall * (t - fall) - G * (t - fall) ** 2 / 2


case("pair_bounces", "# zero: a.z\nsimulator -finish 0.5\n" + ground(0, "-ct 1") +
     "".join(f"body {name} ball -init_pos {{{x} 0.5 0}} {more}\n" for name, x, more in (("a", -1, ""), ("b", 0, "-ct 1"), ("c", 1, ""))) +
     gravity("a", "b", "c") + "contact soft -body1 ground -body2 a -restitution 0.5\n"
     "contact -body1 b -body2 ground -collide 1\ncontact -body1 c -body2 ground -collide 0\n",
     [(t, 1, 0.1 + bounced(0.5)(t), "a.y") for t in (0.2, 0.4)] + [(t, 1, 0.1 + bounced(1)(t), "b.y") for t in (0.2, 0.4, 0.5)] +
     [(t, 1, 0.5 - G * t * t / 2, "c.y") for t in (0.2, 0.5)])

# ---------------------------------------------------------------- forces of contacts, beside those of joints and ropes

# A block that slides up an incline, and then stands.
a, mu, v = 0.3, 0.4, 5
weight, slowing = G, G * (math.sin(a) + mu * math.cos(a))
stop = v / slowing
c, s = math.cos(a), math.sin(a)
normal, slides, holds = G * c, -mu * G * c, G * s  # along the slope, upwards
case("forces_on_a_slope", slope(a, mu, v, 3) + "contact on -body1 b -body2 ground\n",
     [(t, 10, normal, "on.n") for t in (0.2, 1.5)] + [(0.2, 10, c * slides - s * normal, "on.fx"), (0.2, 10, s * slides + c * normal, "on.fy"),
      (1.5, 10, c * holds - s * normal, "on.fx"), (1.5, 10, s * holds + c * normal, "on.fy"), (0.2, 5, v - slowing * 0.2, "on.slip"),
      (1.5, 5, 0, "on.slip"), (0.2, 2, 2, "on.state"), (1.5, 2, 1, "on.state")] +
     [(t, 1, -0.1 * f / normal, f"(on.px-b.x)*{c!r}+(on.py-b.y)*{s!r}") for t, f in ((0.2, slides), (1.5, holds))])  # no couple about the centre
# A ladder against a smooth wall, on a floor that holds it.
a, mu, length, thick = math.radians(70), 0.5, 2, 0.02
c, s = math.cos(a), math.sin(a)
foot = (-length / 2 * c + thick / 2 * s, -length / 2 * s - thick / 2 * c)  # corners, from the centre
foot = min(((sx * length / 2 * c - sy * thick / 2 * s, sx * length / 2 * s + sy * thick / 2 * c) for sx in (-1, 1) for sy in (-1, 1)), key=lambda p: p[1])
head = max(((sx * length / 2 * c - sy * thick / 2 * s, sx * length / 2 * s + sy * thick / 2 * c) for sx in (-1, 1) for sy in (-1, 1)), key=lambda p: p[0])
wall = 2 * G * -foot[0] / (head[1] - foot[1])
case("ladder", f"# zero: l.y-{-foot[1]!r}\nsimulator -finish 5\n" + ground(mu) + f"shape_set ladder -desc {{-sub {{-box {{{length} {thick} 0.4}}}}}}\n"
     f"shape_set wall -desc {{-sub {{-box {{1 8 4}}}}}}\nbody wall wall -fixed 1 -init_pos {{0.5 4 0}}\n"
     f"body l ladder -mass 2 -restitution 0 -friction {mu} -init_pos {{{-head[0]!r} {-foot[1]!r} 0}} -init_rot {{0 0 {a!r}}}\n" + gravity("l") +
     "contact below -body1 l -body2 ground\ncontact beside -body1 wall -body2 l\n",
     [(t, 20, value, name) for t in (0, 1, 5) for value, name in ((2 * G, "below.n"), (wall, "below.fx"), (wall, "beside.n"), (wall, "beside.fx"),
      (0, "beside.fy"), (1, "below.state"))])
# A beam on a hinge, held by a rope, carries a box; a push on the box that friction bears goes into the hinge.
case("beam", "# zero: box.y-0.35\nsimulator -finish 4\nshape_set beam -desc {-sub {-box {4 0.2 0.5}}}\nshape_set box -desc {-sub {-box {0.5 0.5 0.5}}}\n"
     "body beam beam -mass 3 -friction 0.5 -restitution 0\nbody box box -mass 2 -init_pos {1 0.35 0} -friction 0.5 -restitution 0\n"
     "joint pin -type hinge -body1 beam -offset1 {-2 0 0}\nrope r -points {{beam {2 0 0}} {2 3 0}}\ncontact on -body1 box -body2 beam\n" +
     gravity("beam", "box") + "force -body box -x {t < 2 ? 4 : 0}\n",
     [(1, 50, 2 * G, "on.n"), (1, 50, -4, "on.fx"), (3, 50, 2 * G, "on.n"), (3, 50, 0, "on.fx"),
      (1, 50, (3 * G * 2 + 2 * G * 3 + 4 * 0.35) / 4, "r.tension"), (3, 50, (3 * G * 2 + 2 * G * 3) / 4, "r.tension"),
      (1, 50, -4, "pin.fx"), (3, 50, 0, "pin.fx"), (1, 50, 5 * G - (3 * G * 2 + 2 * G * 3 + 4 * 0.35) / 4, "pin.fy"),
      (3, 50, 5 * G - (3 * G * 2 + 2 * G * 3) / 4, "pin.fy")])
# A block hangs by a rope over the edge of a table and draws another one, beside a third that stands.
mu, m, hung = 0.3, 2, 1
gains = G * (hung - mu * m) / (m + hung)
case("over_an_edge", "# zero: a.y-1.1\n# zero: c.y-1.1\nsimulator -finish 0.8\nshape_set table -desc {-sub {-box {6 1 4}}}\n"
     "shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}\nbody table table -fixed 1 -init_pos {-3 0.5 0} -friction 0.3\n"
     f"body a block -mass {m} -init_pos {{-2 1.1 0}} -friction {mu} -restitution 0\nbody h block -mass {hung} -init_pos {{0.2 0.5 0}}\n"
     f"body c block -mass 1 -init_pos {{-3 1.1 0}} -friction {mu} -restitution 0\nrope r -points {{{{a {{0 0 0}}}} {{0.2 1.1 0}} {{h {{0 0 0}}}}}}\n"
     "contact on -body1 a -body2 table\ncontact stands -body1 table -body2 c\n" + gravity("a", "h", "c"),
     [(t, 20, value, name) for t in (0.3, 0.7) for value, name in ((gains * t * t / 2 - 2, "a.x"), (m * G, "on.n"), (-mu * m * G, "on.fx"),
      (hung * (G - gains), "r.tension"), (gains * t, "on.slip"), (2, "on.state"), (G, "stands.n"), (-G, "stands.fy"), (1, "stands.state"))])
# Expressions that switch hold a block against a growing pull, and the floor carries their part along its normal.
LYING = "shape_set block -desc {-sub {-box {0.4 0.2 0.3}}}\nbody b block -mass 2 -init_pos {0 0.1 0} -restitution 0\ncontact k -body1 b -body2 ground\n"
case("sign_holds", "# zero: b.x\n# zero: b.z\nsimulator -finish 1.9\n" + ground(0) + LYING + gravity("b") +
     "force -body b -x {-3*sign(b.dx) + 1.5*t} -y {-9*sign(b.dx)}\n",
     [(t, 30, 2 * G + 4.5 * t, "k.n") for t in (0.5, 1.2, 1.8)])
along = "b.dx/hypot(b.dx,b.dz)"
case("direction_holds", "# zero: b.x\n# zero: b.z\nsimulator -finish 2.6\n" + ground(0) + LYING + gravity("b") +
     f"force -body b -x {{-6*{along} + 2*t}} -y {{-4*{along}}} -z {{-6*b.dz/hypot(b.dx,b.dz) + t}}\n",
     [(t, 30, 2 * G + 4 * t / 3, "k.n") for t in (0.5, 1.2, 2.5)])
# The link of two contacts: a block is let go when its load on the table exceeds what is allowed.
case("let_go_by_load", "# zero: b.z\nsimulator -finish 3\n" + ground(0.5) + "shape_set block -desc {-sub {-box {0.2 0.2 0.2}}}\n"
     "body b block -mass 1 -init_pos {0 0.1 0} -friction 0.5 -restitution 0\nbody w block -mass 1 -init_pos {5 3 0}\n"
     "joint holds -type fixed -body1 w -release {on.n > 20}\ncontact on -body1 b -body2 ground\n" + gravity("b", "w") + "force -body b -y {-t*10}\n",
     [(t, 3, 3 - G * max(0, t - (20 - G) / 10) ** 2 / 2, "w.y") for t in (0.5, 1, 1.3, 1.6)])
# A man in a lift, whose drive has three functions of the time.
case("lift", "# zero: man.x\nsimulator -finish 6\nshape_set cabin -desc {-sub {-pos {0 -0.05 0} -box {2 0.1 2}}}\n"
     "shape_set man -desc {-sub {-box {0.5 1.8 0.4}}}\nbody cabin cabin -mass 400\n"
     "joint shaft -type slider -body1 cabin -axis {0 1 0} -speed {t < 2 ? t : t < 4 ? 2 : 6 - t}\n"
     "body man man -mass 80 -restitution 0 -init_pos {0 0.9 0}\ncontact feet -body1 man -body2 cabin\n" + gravity("man", "cabin"),
     [(t, 1000, 80 * (G + a), "feet.fy") for t, a in ((1, 1), (3, 0), (5, -1))] + [(6, 10, 8.9, "man.y"), (6, 10, 0, "cabin.dy")])
# A pawl narrower than the wheel falls on it and stays, while the wheel turns on:  I w' = 5 - w  with I = m r^2 / 2.
case("pawl", "# zero: wheel.x\nsimulator -finish 1\nshape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.4 0.1}}}\n"
     "shape_set pawl -desc {-sub {-box {0.6 0.05 0.08}}}\nbody wheel wheel -mass 5 -restitution 0\n"
     "joint axle -type hinge -body1 wheel -offset1 {0 0 0} -motor 5 -damping 1\n"
     "body pawl pawl -mass 0.2 -restitution 0 -init_pos {0.3 0.65 0} -init_rot {0 0 -0.3}\n"
     "joint pin -type hinge -body1 pawl -offset1 {0.3 0 0}\n" + gravity("pawl"),
     [(t, 5, 5 * (1 - math.exp(-t / 0.4)), "axle.dq") for t in (0.1, 0.5, 1)] + [(t, 1, 0, "pin.dq") for t in (0.5, 1)] +
     [(1, 1, 0.4, "hypot(pawl.px(-0.3,-0.025,0), pawl.py(-0.3,-0.025,0))")])
# Three dominoes: the first falls, and all lie still at last.
case("dominoes", "# zero: d0.z\nsimulator -finish 4\n" + ground(0.5) + "shape_set slab -desc {-sub {-box {0.2 2 1}}}\n" +
     "".join(f"body d{i} slab -init_pos {{{1.2 * i} 1 0}} -friction 0.3 -restitution 0{' -init_drot {0 0 -1.6}' if i == 0 else ''}\n" for i in range(3)) +
     gravity("d0", "d1", "d2"), [(4, 1, 0, f"d{i}.{q}") for i in range(3) for q in ("dx", "dy", "wz")])
# What lies or falls beside the plane in which a box stands does not press the box into the floor.
SLAB = "shape_set slab -desc {-sub {-box {0.6 0.3 0.6}}}\n"
for name, mu in (("ball_beside_the_middle", 0.5), ("ball_beside_the_middle_smooth", 0)):
    case(name, "# zero: s.y-0.15\nsimulator -finish 1\n" + ground(mu) + SLAB + "shape_set small -desc {-sub {-sphere 0.15}}\n" +
         f"body s slab -init_pos {{0 0.15 0}} -friction {mu} -restitution 0\n"
         f"body b small -init_pos {{0.05 0.8 0.08}} -friction {mu} -restitution 0\n" + gravity("s", "b"),
         [(t, 1, y, e) for t in (0.3, 1) for y, e in ((0.15, "s.y"), (0.45, "b.y"), (0.08, "b.z"), (0, "s.dx"), (0, "s.wx"), (0, "s.wz"))])
case("slab_beside_the_middle", "# zero: b.y-0.45\nsimulator -finish 10\n" + ground(0.5) + SLAB +
     "body s slab -init_pos {0 0.15 0} -friction 0.5 -restitution 0\nbody b slab -init_pos {0 0.45 0.2} -friction 0.5 -restitution 0\n" +
     gravity("s", "b"), [(10, 1, 0.15, "s.y"), (10, 1, 0.45, "b.y"), (10, 1, 0.2, "b.z"), (10, 1, 0, "s.wx")])

# A block that carries a weight beside its middle slides straight on, for its friction acts where its pressure has its
# centre, below the centre of mass; so does one that drops flat, whose blow of mu m v takes the same from its way.
BESIDE = "shape_set loaded -desc {-sub {-box {1 0.2 1}} -sub {-pos {0 0.2 0.4} -density 20 -box {0.2 0.2 0.2}}}\n"
mu, v = 0.3, 2
for name, drop in (("loaded_beside", 0), ("loaded_beside_drops", 0.2)):
    fall = math.sqrt(2 * drop / G)
    left = v - mu * G * fall
    case(name, f"# zero: b.qx\nsimulator -finish 1\n" + ground(mu) + BESIDE +
         f"body b loaded -init_pos {{0 {0.1 + drop} 0}} -init_dpos {{{v} 0 0}} -restitution 0 -friction {mu}\n" + gravity("b"),
         [(1, 1, v * fall + left ** 2 / (2 * mu * G), "b.px(0,0,0)"), (1, 1, 0, "b.pz(0,0,0)"), (1, 1, 0, "b.qy"), (0.4, 1, 0, "b.wy")])


# It slides and turns: by many steps of Runge and Kutta in the plane. The pressure's centre follows from the couples that keep
# the block flat, and these from the friction there, so that each step finds it by repetition.
LOADED = [(1 * 0.2 * 1, (0, 0, 0), (1, 0.2, 1)), (20 * 0.2 ** 3, (0, 0.2, 0.4), (0.2, 0.2, 0.2))]


def turns_on(parts, high, t, velocity, spin, mu, count=500):
    """Parts of mass, place and sizes on a square base of 1, `high` above it."""
    mass = sum(m for m, _, _ in parts)
    centre = [sum(m * at[i] for m, at, _ in parts) / mass for i in range(3)]
    high += centre[1]
    about, crossed = 0, 0  # I_yy, and I_yz: the block is alike on both sides of its plane of y and z
    for m, at, (a, b, c) in parts:
        y, z, x = at[1] - centre[1], at[2] - centre[2], at[0] - centre[0]
        about += m * (a * a + c * c) / 12 + m * (x * x + z * z)
        crossed -= m * y * z
    half = 0.5
    reach = half * (math.sqrt(2) + math.asinh(1)) / 3

    def rates(state):
        x, z, turn, vx, vz, w = state
        px = pz = turning = 0.0
        for _ in range(400):
            sx, sz, sw = vx + w * pz, vz - w * px, reach * w
            speed = math.hypot(sx, sz, sw)
            fx, fz, couple = (-mu * mass * G * s / speed for s in (sx, sz, sw))
            turning = (pz * fx - px * fz + reach * couple) / about
            ixy, iyz = crossed * math.sin(turn), crossed * math.cos(turn)
            mx, mz = ixy * turning + w * w * iyz, iyz * turning - w * w * ixy
            pz += 0.1 * (-(high * fz + mx) / (mass * G) - pz)
            px += 0.1 * ((mz - high * fx) / (mass * G) - px)
        return vx, vz, w, fx / mass, fz / mass, turning

    state, h = [0.0, centre[2], 0.0, velocity, 0.0, spin], t / count
    for _ in range(count):
        k1 = rates(state)
        k2 = rates([s + h / 2 * k for s, k in zip(state, k1)])
        k3 = rates([s + h / 2 * k for s, k in zip(state, k2)])
        k4 = rates([s + h * k for s, k in zip(state, k3)])
        state = [s + h / 6 * (a + 2 * b + 2 * c + d) for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state


mu, v, w = 0.2, 2, 3
turned = {t: turns_on(LOADED, 0.1, t, v, w, mu) for t in (0.2, 0.5)}
case("loaded_turns", "# zero: b.qx\nsimulator -finish 0.5\n" + ground(mu) + BESIDE +
     f"body b loaded -init_pos {{0 0.1 0}} -init_dpos {{{v} 0 0}} -init_drot {{0 {w} 0}} -restitution 0 -friction {mu}\n" + gravity("b"),
     [(t, 2, value, name) for t, s in turned.items() for value, name in
      ((s[0], "b.x"), (s[1], "b.z"), (math.sin(s[2] / 2), "b.qy"), (s[3], "b.dx"), (s[4], "b.dz"), (s[5], "b.wy"))])

# A pillar so high that its friction would tip it, if it did not spin: the centre of its pressure moves by more than half the
# base, should a step look for it one way and the other.
mu, v, w = 0.5, 1, 20
turned = {t: turns_on([(4, (0, 0, 0), (1, 4, 1))], 2, t, v, w, mu, 200) for t in (0.02, 0.05)}
case("pillar_turns", "# zero: b.qx\nsimulator -finish 0.05\n" + ground(mu) + "shape_set pillar -desc {-sub {-box {1 4 1}}}\n"
     f"body b pillar -init_pos {{0 2 0}} -init_dpos {{{v} 0 0}} -init_drot {{0 {w} 0}} -restitution 0 -friction {mu}\n" + gravity("b"),
     [(t, 20, value, name) for t, s in turned.items() for value, name in
      ((s[0], "b.x"), (s[1], "b.z"), (math.sin(s[2] / 2), "b.qy"), (s[3], "b.dx"), (s[4], "b.dz"), (s[5], "b.wy"))])

# A can that spins on its end: friction brakes it with the couple mu m g 2 R / 3 of a round face, and then it stands.
mu, w, radius = 0.1, 10, 0.2
braking = mu * G * 2 * radius / 3 / (radius ** 2 / 2)
case("can_spins", "# zero: b.y-0.2\nsimulator -finish 2\n" + ground(mu) + f"shape_set can -desc {{-sub {{-cylinder {{{radius} 0.4}}}}}}\n"
     f"body b can -init_pos {{0 0.2 0}} -init_drot {{0 {w} 0}} -restitution 0 -friction {mu}\n" + gravity("b"),
     [(t, 5, max(0, w - braking * t), "b.wy") for t in (0.3, 1, 1.5, 2)] + [(2, 1, 0, "b.x")])

# Rest is rest for 1,000 s: stacks of ten whose masses grow to 1000 times or shrink so, and two of a ratio of a million.
for name, masses in (("stack_heavy_above", [10 ** (i / 3) for i in range(10)]), ("stack_heavy_below", [10 ** (3 - i / 3) for i in range(10)]),
                     ("million_above", [1, 1e6, 1]), ("million_below", [1e6, 1, 1e6])):
    names = [f"b{i}" for i in range(len(masses))]
    case(name, f"# zero: {names[-1]}.y-{len(masses) - 0.5}\nsimulator -finish 1000\n" + ground(0.5) + BLOCK +
         "".join(f"body {n} block -mass {m!r} -init_pos {{{0.1 * (i % 2)} {0.5 + i} 0}} -friction 0.5 -restitution 0\n"
                 for i, (n, m) in enumerate(zip(names, masses))) + gravity(*names),
         [(1000, 1, 0.1 * (i % 2), n + ".x") for i, n in enumerate(names)] + [(1000, 1, 0.5 + i, n + ".y") for i, n in enumerate(names)])
# A box held between two jaws that are pushed: it holds with 2 mu F > m g, and slides by what is missing.
for name, part, falls in (("grip_holds", 1 + 1e-9, False), ("grip_slides", 1 - 1e-9, True)):
    mu, m = 0.5, 2
    force = part * m * G / (2 * mu)
    lag = m * G - 2 * mu * force
    case(name, "# zero: jaw1.y-1\nsimulator -finish " + ("200" if falls else "1000") + "\nshape_set cube -desc {-sub {-box {0.2 0.2 0.2}}}\n" +
         f"body box cube -mass {m} -init_pos {{0 1 0}} -friction {mu} -restitution 0\n" +
         "".join(f"body jaw{k} cube -mass 1 -init_pos {{{(-0.2, 0.2)[k - 1]:.1f} 1 0}} -friction {mu} -restitution 0\n"
                 f"joint rail{k} -type slider -body1 jaw{k} -axis {{1 0 0}}\nforce -body jaw{k} -x {force if k == 1 else -force!r}\n"
                 for k in (1, 2)) + gravity("box"),
         [(200, 0.6, 1 - lag / m * 200 ** 2 / 2, "box.y")] if falls else [(1000, 1, 1, "box.y")])

# A seesaw whose heavier box goes down: both boxes stick, and all turns as one; a'' is integrated by many small steps of Runge and
# Kutta. It falls on its end after 0.687 s and again, each box slips, flies and lands; at last it lies on its end.
def seesaw_turns(t, start=0.0, count=20000):
    whole = 10 * (3 ** 2 + 0.06 ** 2) / 12 + 13 * (0.3 ** 2 / 6 + 1.2 ** 2 + 0.18 ** 2)

    def bends(turn):
        return G * (3 * 1.2 * math.cos(turn) + 13 * 0.18 * math.sin(turn)) / whole

    turn, speed, h = start, 0.0, t / count
    for _ in range(count):
        k1 = bends(turn)
        k2 = bends(turn + h / 2 * speed)
        k3 = bends(turn + h / 2 * speed + h * h / 4 * k1)
        k4 = bends(turn + h * speed + h * h / 2 * k2)
        turn += h * speed + h * h * (k1 + k2 + k3) / 6
        speed += h * (k1 + 2 * k2 + 2 * k3 + k4) / 6
    return turn


lies = math.asin(0.5 / math.hypot(1.5, 0.03)) - math.atan2(0.03, 1.5)


def seesaw(name, high, times, lying):
    """It starts with its right end up by that angle. `lying`: boxes that still lie on it at the end."""
    c, s = math.cos(high), math.sin(high)
    case(name, "# zero: plank.y-0.5\nsimulator -finish 3\n" + FLOOR + "shape_set plank -desc {-sub {-box {3 0.06 0.4}}}\n"
         "shape_set box -desc {-sub {-box {0.3 0.3 0.3}}}\nbody ground floor -fixed 1 -init_pos {0 -0.5 0} -friction 0.5\n"
         f"body plank plank -mass 10 -restitution 0 -friction 0.5 -init_pos {{0 0.5 0}} -init_rot {{0 0 {high}}}\njoint pivot -type hinge -body1 plank\n" +
         "".join(f"body {box} box -mass {mass} -restitution 0 -friction 0.5 -init_pos {{{c * x - 0.18 * s!r} {0.5 + s * x + 0.18 * c!r} 0}} "
                 f"-init_rot {{0 0 {high}}}\n" for box, mass, x in (("left", 5, -1.2), ("right", 8, 1.2))) + gravity("plank", "left", "right"),
         [(t, 2, math.sin(-seesaw_turns(t, -high) / 2), "plank.qz") for t in times] +
         [(t, 2, math.sin(-lies / 2), "plank.qz") for t in (2.2, 3)] + [(3, 2, math.sin(-lies / 2), b + ".qz") for b in lying])


seesaw("seesaw", 0, (0.2, 0.4, 0.6), ("left", "right"))
seesaw("seesaw_tilted", 0.2, (0.2, 0.4, 0.6, 0.8), ("right",))


# A ladder slides down between smooth walls until the wall would have to pull, leaves it, lies down on the floor, and slides on. Its
# middle is at L (cos, sin) + H (sin, cos) of its angle; own integration, as above.
def ladder_falls(angle, times, finish, count=20000):
    L, H, inertia = 1, 0.02, (2 ** 2 + 0.04 ** 2) / 12

    def bends(turn, speed, leans):
        c, s = math.cos(turn), math.sin(turn)
        dx, dy, ddx, ddy = -L * s + H * c, L * c - H * s, -L * c - H * s, -L * s - H * c
        whole, rest = inertia + dy * dy, dy * ddy
        if leans:
            whole, rest = whole + dx * dx, rest + dx * ddx
        bend = -(rest * speed * speed + G * dy) / whole
        return bend, dx * bend + ddx * speed * speed

    turn, speed, x, along, leans, h, rows, t = angle, 0.0, L * math.cos(angle) + H * math.sin(angle), 0.0, True, finish / count, [], 0.0
    for k in range(count + 1):
        t = k * h
        for at in times:
            if abs(at - t) < h / 2:
                rows.append((at, 3, x + (at - t) * along, "ladder.x"))
                rows.append((at, 3, math.sin((math.pi - max(turn, 0)) / 2), "ladder.qz"))
        if leans and bends(turn, speed, True)[1] < 0: # the wall would have to pull
            leans = False
        k1 = bends(turn, speed, leans)[0]
        k2 = bends(turn + h / 2 * speed, speed + h / 2 * k1, leans)[0]
        k3 = bends(turn + h / 2 * speed + h * h / 4 * k1, speed + h / 2 * k2, leans)[0]
        k4 = bends(turn + h * speed + h * h / 2 * k2, speed + h * k3, leans)[0]
        if turn > 0:
            turn += h * speed + h * h * (k1 + k2 + k3) / 6
            speed += h * (k1 + 2 * k2 + 2 * k3 + k4) / 6
        if leans:
            along = (-L * math.sin(turn) + H * math.cos(turn)) * speed
            x = L * math.cos(turn) + H * math.sin(turn)
        else:
            x += h * along
    return rows


a = math.radians(45)
case("ladder_falls", "simulator -finish 1\nshape_set floor -desc {-sub {-box {8 0.2 2}}}\nshape_set wall -desc {-sub {-box {0.2 4 2}}}\n"
     "shape_set ladder -desc {-sub {-box {2 0.04 0.4}}}\nbody floor floor -fixed 1 -init_pos {3 -0.1 0}\nbody wall wall -fixed 1 -init_pos {-0.1 2 0}\n"
     f"body ladder ladder -mass 10 -restitution 0 -init_pos {{{1.02 * math.cos(a)!r} {1.02 * math.sin(a)!r} 0}} -init_rot {{0 0 {math.pi - a!r}}}\n" +
     gravity("ladder"), ladder_falls(a, (0.2, 0.3, 0.4, 0.5, 0.6, 1.0), 1.0))


# A cradle of five balls on hinges: as many as are drawn aside swing as one, touch all the time without a force, and as many leave.
def swings(angle, bend, t, count=20000):
    speed, h = 0.0, t / count
    for _ in range(count):
        k1 = -bend * math.sin(angle)
        k2 = -bend * math.sin(angle + h / 2 * speed)
        k3 = -bend * math.sin(angle + h / 2 * speed + h * h / 4 * k1)
        k4 = -bend * math.sin(angle + h * speed + h * h / 2 * k2)
        angle += h * speed + h * h * (k1 + k2 + k3) / 6
        speed += h * (k1 + 2 * k2 + 2 * k3 + k4) / 6
    return angle


def cradle(aside, t):
    ball, rod = 4 / 3 * math.pi * 0.05 ** 3, math.pi * 0.004 ** 2 * 0.5
    whole = ball * (0.5 ** 2 + 0.4 * 0.05 ** 2) + rod * (0.25 ** 2 + (3 * 0.004 ** 2 + 0.5 ** 2) / 12)
    turned = swings(-0.6, G * (ball * 0.5 + rod * 0.25) / whole, t)
    turns = [min(turned, 0) if k < aside else max(turned, 0) if k >= 5 - aside else 0 for k in range(5)]
    return [(t, 2, 0.1 * k + 0.5 * math.sin(turns[k]), f"b{k}.px(0,0,0)") for k in range(5)]


for name, aside, times in (("cradle_of_one", 1, (0.5, 1.4, 2.1, 3.0)), ("cradle_of_two", 2, (0.2, 0.5, 0.7))):
    case(name, f"simulator -finish {times[-1]}\nshape_set ball -desc {{-sub {{-sphere 0.05}} -sub {{-pos {{0 0.25 0}} -cylinder {{0.004 0.5}}}}}}\n" +
         "".join(f"body b{k} ball -init_pos {{{0.1 * k + 0.5 * math.sin(a)!r} {-0.5 * math.cos(a)!r} 0}} -init_rot {{0 0 {a}}}\njoint h{k} -type hinge -body1 b{k} -offset1 {{0 0.5 0}}\n"
                 for k, a in enumerate([-0.6] * aside + [0] * (5 - aside))) + gravity(*(f"b{k}" for k in range(5))),
         [row for t in times for row in cradle(aside, t)])


def main():
    for name, (text, rows) in CASES.items():
        with open(os.path.join(HERE, name + ".al"), "w", encoding="utf-8") as file:
            file.write(text)
        with open(os.path.join(HERE, name + ".values"), "w", encoding="utf-8") as file:
            file.write("".join(f"{float(t)!r} {scale:.3g} {float(value)!r} {expression}\n" for t, scale, value, expression in rows))
    return 0


if __name__ == "__main__":
    main()
