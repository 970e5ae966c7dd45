"""Random scenes of friction, stacks, joints and ropes whose motion closed forms or least coordinates give.

A family takes dice and returns a Scene. SI units; the plane of motion is x, y, and gravity may lean in place of a slope,
so that bodies stand on the floor to the last bit.
"""
import math
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "joints"))

from integration import solve  # noqa: E402
from vectors import solved  # noqa: E402

G = 9.81


class Scene:
    """Lines of the language, the last time, and of each quantity its value at a time."""

    def __init__(self, lines, finish, quantities, values):
        self.lines, self.finish, self.quantities, self.values = lines, finish, quantities, values

    def text(self, accuracy):
        return "\n".join([f"simulator -finish {self.finish!r} -accuracy {accuracy!r}"] + self.lines) + "\n"


def listed(*numbers):
    return "{" + " ".join(repr(float(x)) for x in numbers) + "}"


FLOOR = ["shape_set ground -desc {-sub {-plane}}", "body floor ground -fixed 1 -restitution 0 -friction 1"]


def pair(friction, static=None):
    """The friction of a body on the floor, whose own is 1: a pair has the geometric mean."""
    text = f"-friction {friction ** 2!r}"
    return text if static is None else text + f" -static_friction {static ** 2!r}"


def moved(x, v, a, t):
    return x + v * t + a * t * t / 2


def piecewise(start, legs):
    """Legs (duration, acceleration) along a line from (place, velocity); the last one has no end."""
    def at(t):
        x, v = start
        for lasts, a in legs:
            if t <= lasts:
                return moved(x, v, a, t)
            x, v, t = moved(x, v, a, lasts), v + a * lasts, t - lasts
        return x
    return at


def many(function):
    """Of a function of one time one of a list of times."""
    return lambda times: [function(t) for t in times]


def integrated(rate, start, value):
    return lambda times: [value(t, y) for t, y in zip(times, solve(rate, start, times))]


# --- friction ---------------------------------------------------------------------------------

def slope(dice):
    """A block goes up a slope, stops, and stays or slides back."""
    angle, friction, speed = dice.uniform(0.1, 0.9), dice.uniform(0.05, 0.9), dice.uniform(0.5, 3)
    static = friction * dice.uniform(1, 1.3)
    up, back = G * (math.sin(angle) + friction * math.cos(angle)), G * (math.sin(angle) - friction * math.cos(angle))
    holds = math.tan(angle) <= static
    at = piecewise((0, speed), [(speed / up, -up), (math.inf, 0 if holds else -back)])
    lines = FLOOR + ["shape_set cube -desc {-sub {-box {0.4 0.2 0.3}}}",
                     f"body b cube -mass {dice.uniform(0.1, 10)!r} -init_pos {{0 0.1 0}} -init_dpos {listed(speed, 0, 0)} -restitution 0 {pair(friction, static)}",
                     f"force -body b -gravitational {listed(-G * math.sin(angle), -G * math.cos(angle), 0)}"]
    return Scene(lines, speed / up * dice.uniform(1.2, 2.5), ["b.x"], many(lambda t: [at(t)]))


def rolls(dice):
    """A ball, cylinder or hoop slips until its rim rests on the ground, and rolls from there on."""
    kind, inertia = dice.choice((("ball", 0.4), ("cylinder", 0.5), ("hoop", 0.9)))
    radius, friction, mass = dice.uniform(0.1, 0.5), dice.uniform(0.1, 0.6), dice.uniform(0.2, 5)
    v, w = dice.uniform(0.5, 3), dice.uniform(-10, 5)
    slips = v + w * radius  # of the rim, forwards; the spin is about z
    turn = abs(slips) / (friction * G * (1 + 1 / inertia))
    at = piecewise((0, v), [(turn, -math.copysign(friction * G, slips)), (math.inf, 0)])
    shape = f"-sphere {radius!r}" if kind == "ball" else f"-rot {{1.5707963267948966 0 0}} -cylinder {listed(radius, 0.4)}"
    across = 0.4 if kind == "ball" else 0.5
    lines = FLOOR + [f"shape_set round -desc {{-sub {{{shape}}}}}",
                     f"body b round -mass {mass!r} -inertia {listed(*(mass * radius ** 2 * k for k in (across, across, inertia)))}"
                     f" -init_pos {listed(0, radius, 0)} -init_dpos {listed(v, 0, 0)} -init_drot {listed(0, 0, w)} -restitution 0 {pair(friction)}",
                     f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, turn * dice.uniform(1.5, 3) + 0.1, ["b.x"], many(lambda t: [at(t)]))


def rolls_out(dice):
    """Rolling friction brings a rolling ball to rest."""
    radius, v = dice.uniform(0.1, 0.5), dice.uniform(0.3, 2)
    arm = radius * dice.uniform(0.01, 0.05)
    brake = arm * G / (radius * 1.4)
    at = piecewise((0, v), [(v / brake, -brake), (math.inf, 0)])
    lines = FLOOR + [f"shape_set round -desc {{-sub {{-sphere {radius!r}}}}}",
                     f"body b round -init_pos {listed(0, radius, 0)} -init_dpos {listed(v, 0, 0)} -init_drot {listed(0, 0, -v / radius)}"
                     f" -restitution 0 -friction 0.8 -rolling_friction {arm!r}",
                     f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, v / brake * dice.uniform(0.7, 1.4), ["b.x"], many(lambda t: [at(t)]))


def oscillates(dice):
    """A block on a spring with dry friction: half swings about shifted middles until friction holds it."""
    mass, stiffness, friction = dice.uniform(0.5, 3), dice.uniform(20, 200), dice.uniform(0.05, 0.4)
    omega, shift, start = math.sqrt(stiffness / mass), friction * mass * G / stiffness, dice.uniform(0.2, 0.6)
    middles, x = [], start
    while abs(x) > shift and len(middles) < 100:
        middles.append((x, math.copysign(shift, x)))
        x = 2 * middles[-1][1] - x
    rests = x

    def at(t):
        k = int(t * omega / math.pi)
        if k >= len(middles):
            return rests
        begins, middle = middles[k]
        return middle + (begins - middle) * math.cos(omega * t - math.pi * k)
    lines = FLOOR + ["shape_set cube -desc {-sub {-box {0.3 0.2 0.3}}}",
                     f"body b cube -mass {mass!r} -init_pos {listed(start, 0.1, 0)} -restitution 0 {pair(friction)}",
                     f"force -body b -gravitational {listed(0, -G, 0)}",
                     f"spring -body1 b -x -3 -y 0.1 -z 0 -stiffness {stiffness!r} -rest 3"]
    return Scene(lines, math.pi / omega * dice.uniform(1, min(len(middles) + 1, 6)), ["b.x"], many(lambda t: [at(t)]))


def pulled_stack(dice):
    """A box on a sled that a growing force pulls over ice: together, until friction no longer takes the box along."""
    upper, lower, friction, parts = dice.uniform(0.5, 3), dice.uniform(0.5, 3), dice.uniform(0.1, 0.6), dice.uniform(0.3, 2)
    grows = friction * G * (upper + lower) / parts  # grows t / (m + M) = mu g
    at_part = (grows * parts ** 3 / 6 / (upper + lower), grows * parts ** 2 / 2 / (upper + lower))

    def at(t):
        if t <= parts:
            both = grows * t ** 3 / 6 / (upper + lower)
            return [both, both]
        s, (x, v) = t - parts, at_part
        pull = (grows * parts - friction * upper * G) / lower
        return [x + v * s + pull * s ** 2 / 2 + grows * s ** 3 / 6 / lower, moved(x, v, friction * G, s)]
    lines = FLOOR + ["shape_set sled -desc {-sub {-box {8 0.2 0.5}}}", "shape_set cube -desc {-sub {-box {0.3 0.2 0.3}}}",
                     f"body s sled -mass {lower!r} -init_pos {{0 0.1 0}} -restitution 0", f"body b cube -mass {upper!r} -init_pos {{0 0.3 0}} -restitution 0",
                     f"contact -body1 b -body2 s -friction {friction!r} -restitution 0",
                     f"force -body s -x {{{grows!r}*t}}"] + [f"force -body {b} -gravitational {listed(0, -G, 0)}" for b in "sb"]
    finish = parts * dice.uniform(1.1, 1.6)
    while at(finish)[0] - at(finish)[1] > 3.5:  # the box still stands on the sled
        finish = (finish + parts) / 2
    return Scene(lines, finish, ["s.x", "b.x"], many(at))


def stands(dice):
    """A stack on a slope that is not steep enough: nothing moves."""
    count, friction = dice.randint(2, 6), dice.uniform(0.2, 0.8)
    angle = math.atan(friction) * dice.uniform(0.2, 0.9)
    lines = FLOOR + ["shape_set cube -desc {-sub {-box {2 0.25 2}}}"]
    names = [f"b{i}" for i in range(count)]
    for i, name in enumerate(names):
        lines += [f"body {name} cube -mass {10 ** dice.uniform(-1, 1)!r} -init_pos {listed(0, 0.125 + 0.25 * i, 0)} -restitution 0 -friction {friction ** (2 if i == 0 else 1)!r}",
                  f"force -body {name} -gravitational {listed(G * math.sin(angle), -G * math.cos(angle), 0)}"]
    lines += [f"contact -body1 {a} -body2 {b} -friction {friction!r} -restitution 0" for a, b in zip(names, names[1:])]
    values = [x for i in range(count) for x in (0, 0.125 + 0.25 * i)]
    return Scene(lines, dice.uniform(1, 5), [f"{name}.{axis}" for name in names for axis in "xy"], many(lambda t: values))


# --- impacts ----------------------------------------------------------------------------------

def bounces(dice):
    """A spinning ball on a rough floor: each impact slips or sticks."""
    radius, friction, back = dice.uniform(0.1, 0.3), dice.uniform(0.05, 0.5), dice.uniform(0.5, 0.95)
    height, v, w = dice.uniform(0.5, 2), dice.uniform(-2, 2), dice.uniform(-20, 20)
    state, legs, t = (0.0, v, height, 0.0, w), [], 0.0  # x, vx, height of the lowest point, vy, spin
    for _ in range(4):
        x, vx, y, vy, spin = state
        fall = (vy + math.sqrt(vy * vy + 2 * G * y)) / G
        legs.append((t, state))
        x, hit, t = x + vx * fall, G * fall - vy, t + fall
        slip = vx + spin * radius
        blow = min(friction * (1 + back) * hit, abs(slip) * 2 / 7)  # per mass; 2/7 of the slip stops it
        vx, spin = vx - math.copysign(blow, slip), spin - math.copysign(blow, slip) * 2.5 / radius
        state = (x, vx, 0.0, back * hit, spin)
    last = t - 1e-3 * (t - legs[-1][0])

    def at(t):
        began, (x, vx, y, vy, _) = next(leg for leg in reversed(legs) if leg[0] <= t)
        return [x + vx * (t - began), radius + moved(y, vy, -G, t - began)]
    lines = ["shape_set ground -desc {-sub {-plane}}", "body floor ground -fixed 1 -friction 1",
             f"shape_set ball -desc {{-sub {{-sphere {radius!r}}}}}",
             f"body b ball -init_pos {listed(0, radius + height, 0)} -init_dpos {listed(v, 0, 0)} -init_drot {listed(0, 0, w)} -restitution {back!r} {pair(friction)}",
             f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, last * dice.uniform(0.5, 1), ["b.x", "b.y"], many(at))


def meets_stop(dice):
    """A slider falls on the stop of its joint, several times."""
    back, drop, slant = dice.uniform(0.4, 0.9), dice.uniform(0.2, 1), dice.uniform(0.2, 1.5)
    pull = G * math.sin(slant)
    fall = math.sqrt(2 * drop / pull)
    hits = [(fall, back * pull * fall)]
    while len(hits) < 4:
        t, v = hits[-1]
        hits.append((t + 2 * v / pull, v * back))

    def at(t):
        before = [hit for hit in hits if hit[0] <= t]
        q = moved(0, 0, -pull, t) if not before else moved(-drop, before[-1][1], -pull, t - before[-1][0])
        return [q * math.cos(slant), q * math.sin(slant)]
    lines = ["shape_set cube -desc {-sub {-box {0.2 0.2 0.2}}}", f"body b cube -mass {dice.uniform(0.1, 10)!r}",
             f"joint rail -type slider -body1 b -axis {listed(math.cos(slant), math.sin(slant), 0)} -limits {{{-drop!r} {{}}}} -limit_restitution {back!r}",
             f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, hits[-1][0] * dice.uniform(0.5, 0.99), ["b.x", "b.y"], many(at))


# --- joints, gears, ropes -----------------------------------------------------------------------

def brakes(dice):
    """A pendulum on a hinge with dry friction, until it comes to rest the first time or swings on."""
    mass, length, start = dice.uniform(0.5, 3), dice.uniform(0.3, 1), dice.uniform(0.5, 1.4)
    inertia, torque = mass * length ** 2 * 1.2, dice.uniform(0.02, 0.3) * mass * G * length
    stiff = mass * G * length

    def leg(sign):
        return lambda t, y: [y[1], (-stiff * math.sin(y[0]) - sign * torque) / inertia]
    legs, t, angle = [], 0.0, start
    while len(legs) < 4 and abs(stiff * math.sin(angle)) > torque:
        rate, step = leg(-math.copysign(1, angle)), 0.05
        now, y = 0.0, [angle, 0.0]
        while True:  # towards the next turning point
            after = solve(rate, y, [step])[0]
            if now > 0 and after[1] * angle > 0:
                if step < 1e-15:
                    break
                step /= 2 if step > 1e-3 else 1
                if step <= 1e-3:  # Newton on the angular velocity
                    s = 0.0
                    for _ in range(20):
                        z = solve(rate, y, [s])[0] if s > 0 else y
                        s = max(0.0, s - z[1] / rate(0, z)[1])
                    now, y = now + s, solve(rate, y, [s])[0] if s > 0 else y
                    break
                continue
            now, y = now + step, after
        legs.append((t, angle, rate))
        t, angle = t + now, y[0]
    rests = abs(stiff * math.sin(angle)) <= torque

    def values(times):
        found = {}
        ends = [begins for begins, _, _ in legs[1:]] + [t]
        for (begins, first, rate), ends_at in zip(legs, ends):
            inside = [x for x in times if begins < x <= ends_at]
            found.update(zip(inside, (y[0] for y in solve(rate, [first, 0.0], [x - begins for x in inside]))))
        at = lambda x: start if x == 0 else found.get(x, angle)  # noqa: E731
        return [[length * math.sin(at(x)), -length * math.cos(at(x))] for x in times]
    lines = ["shape_set bob -desc {-sub {-sphere 0.1}}",
             f"body b bob -mass {mass!r} -inertia {listed(*[0.2 * mass * length ** 2] * 3)} -init_pos {listed(length * math.sin(start), -length * math.cos(start), 0)}",
             f"joint pin -type hinge -body1 b -offset1 {listed(-length * math.sin(start), length * math.cos(start), 0)} -friction {torque!r}",
             f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, t * (1.3 if rests else dice.uniform(0.5, 1)), ["b.x", "b.y"], values)


def chain(dice):
    """Two to four rods on hinges in a row, by the equations of their angles from straight down."""
    count = dice.randint(2, 4)
    lengths, masses = [dice.uniform(0.3, 1) for _ in range(count)], [dice.uniform(0.3, 2) for _ in range(count)]
    starts = [dice.uniform(-1.2, 1.2) for _ in range(count)]

    def arm(k, i):  # of the centre of rod k, along rod i
        return lengths[i] if i < k else lengths[i] / 2 if i == k else 0.0
    inertia = [[sum(masses[k] * arm(k, i) * arm(k, j) for k in range(count)) for j in range(count)] for i in range(count)]
    loads = [sum(masses[k] * arm(k, i) for k in range(count)) for i in range(count)]

    def rate(_, y):
        angles, speeds = y[:count], y[count:]
        matrix = [[inertia[i][j] * math.cos(angles[i] - angles[j]) + (masses[i] * lengths[i] ** 2 / 12 if i == j else 0)
                   for j in range(count)] for i in range(count)]
        right = [-sum(inertia[i][j] * math.sin(angles[i] - angles[j]) * speeds[j] ** 2 for j in range(count))
                 - G * loads[i] * math.sin(angles[i]) for i in range(count)]
        return list(speeds) + solved(matrix, right)

    def centres(_, y):
        return [value for k in range(count) for value in (sum(arm(k, i) * math.sin(y[i]) for i in range(count)),
                                                          -sum(arm(k, i) * math.cos(y[i]) for i in range(count)))]
    places, lines = centres(0, starts), ["shape_set rod -desc {-sub {-box {0.1 0.1 0.1}}}"]
    for k in range(count):
        tensor = masses[k] * lengths[k] ** 2 / 12
        lines += [f"body b{k} rod -mass {masses[k]!r} -inertia {listed(tensor, tensor, tensor)} -init_pos {listed(places[2 * k], places[2 * k + 1], 0)} -init_rot {listed(0, 0, starts[k])}",
                  f"force -body b{k} -gravitational {listed(0, -G, 0)}",
                  f"joint pin{k} -type hinge -body1 b{k} -offset1 {listed(0, lengths[k] / 2, 0)}" + (f" -body2 b{k - 1} -offset2 {listed(0, -lengths[k - 1] / 2, 0)}" if k else "")]
    return Scene(lines + ["contact -body1 b0 -body2 b2 -collide 0"] * (count > 2) + ["contact -body1 b0 -body2 b3 -collide 0",
                 "contact -body1 b1 -body2 b3 -collide 0"] * (count > 3), dice.uniform(0.5, 1.5), [f"b{k}.{axis}" for k in range(count) for axis in "xy"],
                 integrated(rate, starts + [0.0] * count, centres))


def atwood(dice):
    """Two weights on a rope over a wheel with inertia."""
    left, right, wheel, radius = dice.uniform(0.5, 3), dice.uniform(0.5, 3), dice.uniform(0.1, 2), dice.uniform(0.1, 0.4)
    pull = (left - right) * G / (left + right + wheel / 2)  # of the left one, down
    lines = [f"shape_set disc -desc {{-sub {{-rot {{1.5707963267948966 0 0}} -cylinder {listed(radius, 0.05)}}}}}", "shape_set bob -desc {-sub {-sphere 0.05}}",
             f"body w disc -mass {wheel!r} -inertia {listed(*(wheel * radius ** 2 * k for k in (0.25, 0.25, 0.5)))}", "joint pin -type hinge -body1 w",
             f"body a bob -mass {left!r} -init_pos {listed(-radius, -2, 0)}", f"body b bob -mass {right!r} -init_pos {listed(radius, -2, 0)}",
             f"rope r -points {{{{a}} {{w {{0 0 0}} {radius!r}}} {{b}}}}"] + [f"force -body {x} -gravitational {listed(0, -G, 0)}" for x in "ab"]
    finish = math.sqrt(2 * dice.uniform(0.3, 1.2) / max(abs(pull), 0.1))
    return Scene(lines, finish, ["a.y", "b.y"], many(lambda t: [-2 - pull * t * t / 2, -2 + pull * t * t / 2]))


def weak_motor(dice):
    """A motor of limited force brings a slider with drag to the speed that is asked, and holds it."""
    mass, speed, force = dice.uniform(0.5, 3), dice.uniform(0.5, 2), dice.uniform(2, 10)
    drag = force / speed * dice.uniform(0.1, 0.8)
    rate = drag / mass
    reached = -math.log(1 - speed * drag / force) / rate

    def run(t):
        return force / drag * (t - (1 - math.exp(-rate * t)) / rate)
    lines = ["shape_set cube -desc {-sub {-box {0.2 0.2 0.2}}}", f"body b cube -mass {mass!r}",
             f"joint rail -type slider -body1 b -axis {{1 0 0}} -speed {speed!r} -max_motor {force!r} -damping {drag!r}"]
    return Scene(lines, reached * dice.uniform(1.2, 2.5), ["b.x"], many(lambda t: [run(t) if t <= reached else run(reached) + speed * (t - reached)]))


def geared(dice):
    """Two wheels in mesh; a couple drives one, a weight hangs on the rim of neither: a steady acceleration moves a rider."""
    one, other, ratio, couple = dice.uniform(0.1, 2), dice.uniform(0.1, 2), dice.choice((-1, 1)) * dice.uniform(0.3, 3), dice.uniform(0.5, 5)
    alpha = couple / (one + other / ratio ** 2)  # of the first; the second turns by 1/ratio of it
    arm = dice.uniform(0.3, 1)
    lines = ["shape_set disc -desc {-sub {-sphere 0.1}}"]
    for name, inertia, mass in (("a", one, 1.0), ("b", other, 1.0)):
        tensor = inertia - mass * arm ** 2
        if tensor <= 0:
            tensor, mass = inertia / 2, inertia / 2 / arm ** 2
        lines += [f"body {name} disc -mass {mass!r} -inertia {listed(tensor, tensor, tensor)} -init_pos {listed(arm, 0, 5 if name == 'b' else 0)}",
                  f"joint {name}j -type hinge -body1 {name} -offset1 {listed(-arm, 0, 0)}" + (f" -motor {couple!r}" if name == "a" else "")]
    lines.append(f"gear g -joint1 aj -joint2 bj -ratio {ratio!r}")

    def at(t):
        turn = alpha * t * t / 2
        return [arm * math.cos(turn), arm * math.sin(turn), arm * math.cos(turn / ratio), arm * math.sin(turn / ratio)]
    return Scene(lines, math.sqrt(2 * dice.uniform(1, 6) / alpha), ["a.x", "a.y", "b.x", "b.y"], many(at))


def ladder(dice):
    """A smooth bar slides down a wall, and leaves it."""
    half, radius, start, share = dice.uniform(0.5, 1.5), 0.05, dice.uniform(0.2, 0.8), dice.uniform(0.2, 0.4)
    # Angle from upright; share: moment of inertia over m half^2. Place along the wall and the floor: half sin, half cos.
    leaning = lambda t, y: [y[1], G / half * math.sin(y[0]) / (1 + share)]  # noqa: E731

    def floor_only(_, y):
        s, c = math.sin(y[0]), math.cos(y[0])
        return [y[1], (G / half * s - s * c * y[1] ** 2) / (share + s * s), y[3], 0.0]

    def pressed(y):
        return math.cos(y[0]) * leaning(0, y)[1] - math.sin(y[0]) * y[1] ** 2
    # The wall's force ends where cos = 2/3 of what it was at the start.
    leaves = math.acos(2 / 3 * math.cos(start))
    low, high = 0.0, 0.0
    while solve(leaning, [start, 0.0], [high + 0.1])[0][0] < leaves:
        high += 0.1
    low, high = high, high + 0.1
    base = solve(leaning, [start, 0.0], [low])[0] if low > 0 else [start, 0.0]
    s = 0.05
    for _ in range(30):
        y = solve(leaning, base, [s])[0]
        s = min(0.1, max(1e-9, s - (y[0] - leaves) / y[1]))
    parts, at_part = low + s, solve(leaning, base, [s])[0]
    free = [at_part[0], at_part[1], half * math.sin(at_part[0]), half * math.cos(at_part[0]) * at_part[1]]
    lasts = 0.0  # until the bar lies down, nearly
    while solve(floor_only, free, [lasts + 0.01])[0][0] < 1.4:
        lasts += 0.01

    def values(times):
        before, after = [t for t in times if t <= parts], [t for t in times if t > parts]
        rows = [[half * math.sin(y[0]), half * math.cos(y[0])] for y in solve(leaning, [start, 0.0], before)]
        return rows + [[y[2], half * math.cos(y[0])] for y in solve(floor_only, free, [t - parts for t in after])]
    mass = dice.uniform(0.5, 5)
    lines = ["shape_set ground -desc {-sub {-plane}}", f"body floor ground -fixed 1 -init_pos {listed(0, -radius, 0)}",
             f"body wall ground -fixed 1 -init_pos {listed(-radius, 0, 0)} -init_rot {listed(0, 0, -math.pi / 2)}",
             f"shape_set bar -desc {{-sub {{-capsule {listed(radius, 2 * half)}}}}}",
             f"body b bar -mass {mass!r} -inertia {listed(*[mass * half ** 2 * share] * 3)} -init_rot {listed(0, 0, start)} -restitution 0"
             f" -init_pos {listed(half * math.sin(start), half * math.cos(start), 0)}",
             f"force -body b -gravitational {listed(0, -G, 0)}"]
    return Scene(lines, parts + lasts * dice.uniform(0.3, 1), ["b.x", "b.y"], values)


ALL = (slope, rolls, rolls_out, oscillates, pulled_stack, stands, bounces, meets_stop, brakes, chain, atwood, weak_motor, geared, ladder)
