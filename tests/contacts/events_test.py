#!/usr/bin/env python3
"""The list of `asgard simulate --events` against the instants of closed forms.

usage: events_test.py ASGARD
"""
import csv
import math
import os
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "joints"))

import contact_cases as contacts  # noqa: E402
from integration import solve  # noqa: E402

G = contacts.G
HANG = """simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
body b ball -mass 1 -ct 1
body c ball -mass 1 -init_pos {0 0 3} -ct 1
force -body b -gravitational {0 -9.81 0}
force -body c -gravitational {0 -9.81 0}
rope r -points {{b} {0 1 0}} -length 1.5
joint j -type slider -body1 c -axis {0 1 0} -limits {-1 {}} -release {t > 1.5}
"""
BRAKE = """simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
body b ball -mass 1 -init_dpos {2 0 0}
joint rail -type slider -body1 b -axis {1 0 0} -friction 4
force -body b -x {t < 1 ? 0 : 6}
"""
DROPS = f"""simulator -finish 70
shape_set floor -desc {{-sub {{-plane}}}}
shape_set ball -desc {{-sub {{-sphere 0.1}}}}
body ground floor -fixed 1
body b ball -mass 1 -init_pos {{0 0.6 0}} -restitution 0.5
force -body b -gravitational {{0 -{G} 0}}
"""
PUMP = """simulator -finish 120
shape_set f -desc {-sub {-box {2 0.2 2}}}
shape_set s -desc {-sub {-sphere 0.1}}
body floor f -fixed 1
body b s -mass 1 -init_pos {0 0.25 0} -restitution 0.9
force -body b -gravitational {0 -9.81 0}
force -body b -y {t < 60 ? 1.1*sign(b.dy) : 0}
"""
BRICK = """simulator -finish 2
shape_set floor -desc {-sub {FLOOR}}
shape_set brick -desc {-sub {-box {0.3 0.2 0.2}}}
body ground floor -fixed 1 -friction 0.2
body b brick -mass 1 -init_pos {0 0.5 0} -init_drot {0.3 0 -1} -restitution 0.5 -friction 0.2
force -body b -gravitational {0 -9.81 0}
"""
# A spring that is four times as strong on the other side.
SWINGS = """simulator -finish 4
shape_set ball -desc {-sub {-sphere 0.1}}
body b ball -mass 1 -init_pos {1 0 0}
force -body b -x {b.x > 0 ? -b.x : -4*b.x}
"""
# Friction would turn the rod into the floor faster than the floor can push it away.
PAINLEVE = f"""simulator -finish 1
shape_set floor -desc {{-sub {{-plane}}}}
shape_set rod -desc {{-sub {{-box {{2 0.001 0.001}}}}}}
body ground floor -fixed 1 -friction 2
body rod rod -init_pos {{{-math.cos(1)!r} {math.sin(1) + 0.0005 * math.cos(1)!r} 0}} -init_rot {{0 0 -1}} -init_dpos {{3 0 0}} -mass 1 \\
    -inertia {{0.001 0.333333333 0.333333333}} -center {{0 0 0}} -restitution 0 -friction 2
force -body rod -gravitational {{0 -{G} 0}}
"""


def wedge(x, way, turn):
    """A box with an edge at x on a rod's axis, its middle towards `way` (degrees), turned by `turn`."""
    half = 0.01 * math.sqrt(2)
    return (f"{{-pos {{{x + half * math.cos(math.radians(way))!r} {half * math.sin(math.radians(way))!r} 0}} -rot {{0 0 {math.radians(turn)!r}}} "
            "-box {0.02 0.02 0.4}}")


def fall_lasts(turned, height, accelerated):
    """A rod falls by an angle about one point from rest: 2/3 w^2 = g height(angle), whose first rate at 0 is w' = `accelerated`."""
    count = 2000  # Simpson's rule on angle = s^2, where dt / ds = 2 s / w is smooth

    def late(s):
        return 2 * s / math.sqrt(1.5 * G * height(s * s)) if s else math.sqrt(2 / accelerated)

    step = math.sqrt(turned) / count
    return step / 3 * sum(late(k * step) * (1 if k in (0, count) else 4 if k % 2 else 2) for k in range(count + 1))


def first_angle(low, high, is_over):
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if is_over(middle) else (middle, high)
    return high


def tipping_rod(mu):
    """A thin rod stands on its lower end, 0.05 rad from upright; the scene, and when it slips."""
    scene = (f"simulator -finish 1.4\nshape_set floor -desc {{-sub {{-plane}}}}\nshape_set rod -desc {{-sub {wedge(-1, 30, -15)}}}\n"
             f"body floor floor -fixed 1 -friction {mu}\nbody rod rod -mass 1 -center {{0 0 0}} -inertia {{0.1 {1 / 3!r} {1 / 3!r}}} -restitution 0 "
             f"-friction {mu} -init_pos {{{math.sin(0.05)!r} {math.cos(0.05)!r} 0}} -init_rot {{0 0 {math.pi / 2 - 0.05!r}}}\n" + contacts.gravity("rod"))

    def height(turned):
        return 2 * math.sin(0.05 + turned / 2) * math.sin(turned / 2)

    def slips(turned):
        s, c = math.sin(0.05 + turned), math.cos(0.05 + turned)
        square, rate = 1.5 * G * height(turned), 0.75 * G * s
        return abs(rate * c - square * s) > mu * (G - rate * s - square * c)

    until = 1e-3
    while not slips(until):
        until += 1e-3
    return scene, fall_lasts(first_angle(until - 1e-3, until, slips), height, 0.75 * G * math.sin(0.05))


def smooth_ladder():
    """A thin ladder of 2 m slides down between a smooth floor and a smooth wall, from 70 degrees; it leaves the wall at 2/3 of its height."""
    a = math.radians(70)
    scene = ("simulator -finish 0.7\nshape_set side -desc {-sub {-plane}}\n"
             f"shape_set ladder -desc {{-sub {wedge(1, -120, 15)} -sub {wedge(-1, -35, 10)}}}\nbody floor side -fixed 1\n"
             f"body wall side -fixed 1 -init_rot {{0 0 {-math.pi / 2!r}}}\nbody ladder ladder -mass 10 -center {{0 0 0}} "
             f"-inertia {{0.1 {10 / 3!r} {10 / 3!r}}} -restitution 0 -init_pos {{{math.cos(a)!r} {math.sin(a)!r} 0}} "
             f"-init_rot {{0 0 {math.pi - a!r}}}\n" + contacts.gravity("ladder"))
    return scene, fall_lasts(a - math.asin(math.sin(a) * 2 / 3), lambda b: 2 * math.cos(a - b / 2) * math.sin(b / 2), 0.75 * G * math.cos(a))


def cases():
    """Of each: the scene, and its instants: time, kind, names."""
    stop = 5 / (G * (math.sin(0.3) + 0.4 * math.cos(0.3)))
    yield "thrown_up", contacts.CASES["thrown_up"][0], [(stop, "stick", "ground b")]
    rolls = 2 * 3 / (7 * 0.25 * G)
    yield "begins_to_roll", contacts.CASES["begins_to_roll"][0], [(rolls, "stick", "ground b")]
    together = 4 / (0.3 * G * (1 + 1 / 3))
    yield "cart", contacts.CASES["cart"][0], [(together, "stick", "c b")]
    gone = (20 - G) / 10
    yield "let_go", contacts.CASES["let_go_by_load"][0], [(gone, "release", "w holds"), (gone + math.sqrt(2 * 2.9 / G), "impact", "ground w")]
    yield "hangs", HANG, [(math.sqrt(2 * 0.5 / G), "taut", "b r"), (math.sqrt(2 / G), "limit", "c j"), (1.5, "release", "c j")]
    yield "brake", BRAKE, [(0.5, "stick", "b rail"), (1, "switch", "b"), (1, "slip", "b rail")]
    yield "swings", SWINGS, [(math.pi / 2, "switch", "b"), (math.pi, "switch", "b")]
    for mu in (0.3, 1):
        scene, slips = tipping_rod(mu)
        yield f"tipping_rod, friction {mu}", scene, [(slips, "slip", "floor rod")]
    scene, leaves = smooth_ladder()
    yield "smooth_ladder", scene, [(leaves, "open", "wall ladder")]
    falls = math.sqrt(2 * 0.4 / G)
    yield "pair_bounces", contacts.CASES["pair_bounces"][0], [(falls, "impact", "ground a"), (falls, "impact", "ground b")]


COIN = """simulator -finish 2
shape_set ground -desc {-sub {-plane}}
body ground ground -fixed 1 -friction 0.3
shape_set coin -desc {-sub {-cylinder {0.1 0.01}}}
body coin coin -mass 0.1 -restitution 0 -friction 0.3 -init_pos {0 0.09999958361103672 0} -init_rot {0 0 -1.4707963267948965}
force -body coin -gravitational {0 -9.81 0}
"""


# A box falls onto one end of a plank and throws the box that lies on the other, which slides down again.
THROWS = """simulator -finish 2
shape_set ground -desc {-sub {-box {8 0.2 2}}}
body ground ground -fixed 1 -init_pos {0 -0.1 0} -friction 0.5
shape_set plank -desc {-sub {-box {3.0 0.06 0.4}}}
shape_set box -desc {-sub {-box {0.3 0.3 0.3}}}
body plank plank -mass 10 -restitution 0 -friction 0.5 -init_pos {0 0.5 0} -init_rot {0 0 0.25}
joint pivot -type hinge -body1 plank
body left box -mass 2 -restitution 0 -friction 0.5 -init_pos {-1.2072276187185877 0.37751948480248854 0} -init_rot {0 0 0.25}
body right box -mass 8 -restitution 0 -friction 0.5 -init_pos {1.2 2.0064103054652436 0}
foreach b {plank left right} {force -body $b -gravitational {0 -9.81 0}}
"""
# A table with one leg short by 0.01 mm, that a force tips to and fro.
SHORT = """simulator -finish 2
shape_set ground -desc {-sub {-plane}}
shape_set table -desc {-sub {-pos {0 0.5 0} -box {1 0.1 1}} -sub {-pos {0.4 0.225 0.4} -box {0.1 0.45 0.1}}
    -sub {-pos {-0.4 0.225 0.4} -box {0.1 0.45 0.1}} -sub {-pos {0.4 0.225 -0.4} -box {0.1 0.45 0.1}}
    -sub {-pos {-0.4 0.225005 -0.4} -box {0.1 0.44999 0.1}}}
body ground ground -fixed 1 -friction 0.4
body table table -restitution 0 -friction 0.4
force -body table -gravitational {0 -9.81 0}
force -body table -offset {-0.3 0.5 -0.3} -x 0 -y {-3*sin(3*t)} -z 0
"""


def kerb():
    box = "shape_set NAME -desc {-sub {-pos {0 Y 0} -box {SIZE}}}\nbody NAME NAME -fixed 1 -friction 1 -init_pos {X 0 0}\n"
    scene = "simulator -finish 2\nset roll [expr {-2/0.15}]\n"
    for name, x, y, size in (("road", 6, -0.5, "16 1 1.6"), ("kerb", 1.5, 0.03, "0.3 0.06 1.6")):
        scene += box.replace("NAME", name).replace("X", str(x)).replace("Y", str(y)).replace("SIZE", size)
    scene += ("shape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.15 0.1}}}\nshape_set chassis -desc {-sub {-box {1.2 0.15 0.4}}}\n"
              "shape_set hub -desc {-sub {-sphere 0.04}}\n"
              "body chassis chassis -mass 20 -init_pos {0 0.35 0} -init_dpos {2 0 0} -friction 1 -restitution 0\n")
    for end, x in (("rear", -0.4), ("front", 0.4)):
        scene += (f"body wheel_{end} wheel -mass 2 -friction 1 -restitution 0 -init_pos {{{x} 0.15 0}} -init_dpos {{2 0 0}} -init_drot [list 0 0 $roll]\n"
                  f"body hub_{end} hub -mass 0.5 -ct 1 -init_pos {{{x} 0.15 0}} -init_dpos {{2 0 0}}\n"
                  f"joint slide_{end} -type slider -body1 hub_{end} -body2 chassis -axis {{0 1 0}} -stiffness 2000 -damping 150\n"
                  f"joint axle_{end} -type hinge -body1 wheel_{end} -body2 hub_{end} -offset1 {{0 0 0}}\n"
                  f"contact -body1 wheel_{end} -body2 chassis -collide 0\n")
    return scene + "foreach b {chassis wheel_rear hub_rear wheel_front hub_front} {force -body $b -gravitational {0 -9.81 0}}\n"


def events(scene, accuracy="1e-9"):
    """The list."""
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "scene")
        with open(base + ".al", "w", encoding="utf-8") as file:
            file.write(scene)
        run = subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--events", base + ".events", "--accuracy", accuracy],
                             capture_output=True, text=True, check=False)
        if run.returncode or "Stopped at" in run.stderr:
            raise RuntimeError(f"exit code {run.returncode}: {run.stderr}")
        with open(base + ".events", encoding="utf-8") as file:
            return list(csv.DictReader(file))


def check_hops():
    """Hops of half the speed each end after three times the fall; of hops that are hardly shorter a hundred are listed."""
    faults = 0
    falls = math.sqrt(2 * 0.5 / G)
    for restitution in (0.5, 0.99):
        found = events(DROPS.replace("-restitution 0.5", f"-restitution {restitution}"))
        impacts = [float(row["time"]) for row in found if row["kind"] == "impact"]
        rests = [float(row["time"]) for row in found if row["kind"] == "rest"]
        end = falls * (1 + 2 * restitution / (1 - restitution))
        good = (len(rests) == 1 and abs(rests[0] - end) < 4e-4 and found[-1]["kind"] == "rest" and len(impacts) <= 100 and
                all(abs(t - falls * (1 + 2 * sum(restitution ** i for i in range(1, k + 1)))) < 1e-8 for k, t in enumerate(impacts[:15])))
        if not good or (restitution > 0.9) != (len(impacts) == 100):
            faults += 1
            print(f"FAIL hops of {restitution}: {len(impacts)} impacts from {impacts[:3]}, rest {rests}, and not {end}")
    return faults


def check_growing_hops():
    """A force that drives a ball higher with each hop, until it lets go: only what comes after the highest is left out."""
    found = events(PUMP)
    listed = [float(row["time"]) for row in found if row["kind"] == "impact"]
    omitted = [row for row in found if row["kind"] == "omitted"]
    hops = [b - a for a, b in zip(listed, listed[1:])]
    highest = hops.index(max(hops))
    good = (len(omitted) == 1 and highest > 60 and len(listed) == highest + 100 and int(omitted[0]["names"].split()[2]) > 0 and
            all(b > 0.98 * a for a, b in zip(hops[:highest], hops[1:highest])))
    if not good:
        print(f"FAIL growing hops: {len(listed)} impacts, the highest after {highest}, omitted {omitted}")
    return 0 if good else 1


def check_half_space():
    """A brick that rattles down hops as often on a half space as on a slab: how low a hop no longer counts is of the smaller body."""
    hops = [sum(row["kind"] == "impact" for row in events(BRICK.replace("FLOOR", floor), accuracy="1e-4"))
            for floor in ("-plane", "-pos {0 -0.5 0} -box {9 1 9}")]
    if hops[0] != hops[1] or not hops[0]:
        print(f"FAIL a brick on a half space and on a slab: {hops} impacts")
        return 1
    return 0


def check_finish():
    """A seesaw strikes the floor just before the end: the step that is ended before the blow is taken up again."""
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "scene")
        with open(base + ".al", "w", encoding="utf-8") as file:
            file.write(contacts.CASES["seesaw"][0])
        subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--accuracy", "1e-4", "--finish", "0.7"],
                       capture_output=True, check=True)
        with open(base + ".csv", encoding="utf-8") as file:
            last = float(file.read().splitlines()[-1].split(",")[0])
    if abs(last - 0.7) > 1e-9:
        print(f"FAIL a blow just before the finish: the motion ends at {last}, and not at 0.7")
        return 1
    return 0


def check_loose():
    """At 1e-3 these play to their end, and as at 1e-9. Of the car a step is long where a wheel leaves the kerb's face."""
    return (check_ends("a car on a kerb", kerb(), ("chassis.x", "chassis.y", "wheel_front.y", "wheel_rear.y")) +
            check_ends("a seesaw that throws", THROWS, ("left.x", "left.y", "right.x", "plank.qz")) +
            check_ends("a table with a short leg", SHORT, ("table.x", "table.y", "table.qz")))


def check_ends(name, scene, quantities):
    ends = []
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "scene")
        with open(base + ".al", "w", encoding="utf-8") as file:
            file.write(scene)
        for accuracy in ("1e-3", "1e-9"):
            run = subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--accuracy", accuracy],
                                 capture_output=True, text=True, check=False)
            if run.returncode or "Stopped at" in run.stderr:
                print(f"FAIL {name} at {accuracy}: {run.stderr}")
                return 1
            with open(base + ".csv", encoding="utf-8") as file:
                last = list(csv.DictReader(file))[-1]
            ends.append([float(last[quantity]) for quantity in quantities])
    if any(abs(a - b) > 5e-3 for a, b in zip(*ends)):
        print(f"FAIL {name}: at 1e-3 {ends[0]}, at 1e-9 {ends[1]}")
        return 1
    return 0


def flush_ladder(spin, push):
    """A ladder leans with its back on a table's edge; its foot is pushed towards the table until it stands flush with it."""
    angle = math.pi / 3
    c, s = math.cos(angle), math.sin(angle)
    return f"""simulator -finish 2
shape_set table -desc {{-sub {{-box {{2 1 2}}}}}}
shape_set floor -desc {{-sub {{-plane}}}}
shape_set ladder -desc {{-sub {{-box {{2 0.06 0.4}}}}}}
body floor floor -fixed 1
body table table -fixed 1 -init_pos {{1 0.5 0}}
body ladder ladder -mass 10 -restitution 0 -init_pos {{{-c / s + c - 0.03 * s!r} {s + 0.03 * c!r} 0}} -init_rot {{0 0 {angle!r}}} -init_drot {{0 {spin} 0}}
force -body ladder -gravitational {{0 -{G} 0}}
force -body ladder -offset {{-1 0 0}} -x {push}
"""


EGGS = f"""simulator -finish 1 -accuracy 1e-4
shape_set egg -desc {{-sub {{-ellipsoid {{0.1 0.15 0.1}}}}}}
body low egg -fixed 1
body high egg -mass 0.5 -init_pos {{0.02 0.4 0.01}} -friction 0.4 -restitution 0
force -body high -gravitational {{0 -{G} 0}}
"""


# A press that is held comes down on a box.
PRESS = f"""simulator -finish 2
shape_set ground -desc {{-sub {{-plane}}}}
shape_set box -desc {{-sub {{-box {{0.4 0.4 0.4}}}}}}
body floor ground -fixed 1
body a box -restitution 0 -init_pos {{0 0.2 0}}
body press box -restitution 0 -init_pos {{0 0.7 0}}
trajectory still -bezier {{{{0 2 {{0 0 0}}}}}}
trajectory down -points {{{{0 0 0.7 0}} {{1 0 0.4 0}}}}
constrain press -pos down
constrain press -rot still
force -body a -gravitational {{0 -{G} 0}}
"""


def check_names():
    """A contact that ends a motion is told by its bodies, also one that is not modelled."""
    run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", os.devnull], input=EGGS, capture_output=True, text=True, check=False)
    if not ('"low"' in run.stderr and '"high"' in run.stderr and "an ellipsoid" in run.stderr):
        print(f"FAIL an egg on an egg: {run.stderr}")
        return 1
    run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", os.devnull], input=PRESS, capture_output=True, text=True, check=False)
    if 'Stopped at t = 0.333333: body "a" is pressed between "floor" and "press"' not in run.stderr:
        print(f"FAIL a box in a press: {run.stderr}")
        return 1
    faults = 0
    for speed in (3, 5, 8):  # behind the jam it sticks, sticks and slips again, lifts off
        scene = PAINLEVE.replace("-init_dpos {3 0 0}", f"-init_dpos {{{speed} 0 0}}")
        run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", os.devnull], input=scene, capture_output=True, text=True, check=False)
        if run.returncode or '"ground" and "rod" jam at t = 0' not in run.stderr:
            faults += 1
            print(f"FAIL a rod that jams at {speed} m/s: {run.stderr}")
    return faults


def stiff_floor(stiffness, damping, step, until):
    """The jammed rod on a floor that gives way, little and without a rebound: its velocities when it has stopped to slip."""
    x, y = math.cos(-1) + 0.0005 * math.sin(-1), math.sin(-1) - 0.0005 * math.cos(-1)  # of its end, from its middle
    u, v, w, depth, sticks = 3.0, 0.0, 0.0, 0.0, False
    for _ in range(round(until / step)):
        slips, parts = u - w * y, v + w * x
        normal = max(0, stiffness * depth - damping * parts) if depth > 0 or parts < 0 else 0
        sticks = sticks or slips <= 0
        holds = -(slips / step - 3 * x * y * normal) / (1 + 3 * y * y)
        along = max(-2 * normal, min(2 * normal, holds)) if sticks else -2 * normal
        u, v, w = u + step * along, v + step * (normal - G), w + step * 3 * (x * normal - y * along)
        depth -= step * (v + w * x)
    return u, v, w


def check_jam():
    """Painleve's rod goes on, turning about its end, which has stopped; so it does on a floor that hardly gives way."""
    x, y = math.cos(-1) + 0.0005 * math.sin(-1), math.sin(-1) - 0.0005 * math.cos(-1)
    inertia = 0.333333333
    spin = 3 * y / (x * x + y * y + inertia)  # about the end nothing turns it

    def x_of(angle):  # of the end, from the middle
        return math.cos(angle) * x - math.sin(angle) * y

    turned = solve(lambda _, s: [s[1], G * x_of(s[0]) / (x * x + y * y + inertia)], [0.0, spin], [0.1, 0.3, 0.4])
    right = [(0, spin)] + [tuple(state) for state in turned]
    rail = f"joint rail -type slider -body1 rod -axis {{{math.cos(1)!r} {math.sin(1)!r} 0}} -release {{t > 0.25}}\n"
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, "scene")
        faults = 0
        for accuracy, begin in (("1e-3", 0), ("1e-9", 0), ("1e-9", 0.25)):  # later: when a rail lets it go
            with open(base + ".al", "w", encoding="utf-8") as file:
                file.write(PAINLEVE + (rail if begin else ""))
            times = "".join(f"{begin + after!r}\n" for after in (0, 0.1, 0.3, 0.4))
            run = subprocess.run([sys.argv[1], "simulate", base + ".al", "--times", "/dev/stdin", "--csv", "-", "--accuracy", accuracy, "--only",
                                  "--quantities", "rod.dx,rod.dy,rod.wz", "--events", base + ".events"], input=times, capture_output=True,
                                 text=True, check=False)
            rows = [[float(cell) for cell in line.split(",")] for line in run.stdout.splitlines()[1:]]
            with open(base + ".events", encoding="utf-8") as file:
                jams = [(float(row["time"]), row["names"]) for row in csv.DictReader(file) if row["kind"] == "inconsistent"]
            off = max(max(abs(row[3] - w), abs(row[1] - w * (math.sin(a) * x + math.cos(a) * y)), abs(row[2] + w * x_of(a)))
                      for row, (a, w) in zip(rows, right)) if len(rows) == 4 else math.inf
            if off > 10 * float(accuracy) or jams != [(begin, "ground rod")]:
                faults += 1
                print(f"FAIL a rod that jams at {begin} s, asked {accuracy}: {rows}, off by {off}, and not {right}; {jams}; {run.stderr[:400]}")
    stiff = stiff_floor(1e9, 3e6, 1e-8, 1e-4)
    if max(abs(a - b) for a, b in zip(stiff, (spin * y, -spin * x, spin))) > 1e-3:
        faults += 1
        print(f"FAIL a rod that jams on a stiff floor: {stiff}, and not {spin * y}, {-spin * x}, {spin}")
    return faults


def check_flush_ladder():
    """It passes the wall, topples and lies on the floor, its end against the table, alike at each accuracy."""
    faults = 0
    for spin, push in ((0, 300), (0, 100), (0.6, 300), (0.01, 300)):
        ways = []
        with tempfile.TemporaryDirectory() as folder:
            base = os.path.join(folder, "scene")
            with open(base + ".al", "w", encoding="utf-8") as file:
                file.write(flush_ladder(spin, push))
            for accuracy in ("1e-3", "1e-6"):
                run = subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--at", "0:0.05:2", "--accuracy", accuracy],
                                     capture_output=True, text=True, check=False)
                if run.returncode:
                    print(f"FAIL a ladder flush with a table, spin {spin}, push {push}, at {accuracy}: {run.stderr}")
                    return faults + 1
                with open(base + ".csv", encoding="utf-8") as file:
                    ways.append([[float(row[f"ladder.{axis}"]) for axis in "xyz"] for row in csv.DictReader(file)])
        apart = max(abs(a - b) for one, other in zip(*ways) for a, b in zip(one, other))
        x, y = ways[1][-1][:2]
        if apart > 1e-3 or abs(x + 1) > 1e-6 or abs(y - 0.03) > 1e-6:
            print(f"FAIL a ladder flush with a table, spin {spin}, push {push}: apart {apart}, it ends at {x} {y}")
            faults += 1
    return faults


def check_coin():
    """A coin topples: it lies flat on its floor then, and neither falls through it nor stops, in whatever unit of time."""
    for accuracy, unit in (("1e-3", 1), ("1e-6", 1), ("1e-3", 3600), ("1e-3", 1e-3)):
        with tempfile.TemporaryDirectory() as folder:
            base = os.path.join(folder, "scene")
            with open(base + ".al", "w", encoding="utf-8") as file:
                file.write(COIN.replace("-finish 2", f"-finish {2 * unit}").replace("-9.81", repr(-9.81 / unit ** 2)))
            run = subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--accuracy", accuracy], capture_output=True, check=False)
            with open(base + ".csv", encoding="utf-8") as file:
                last = list(csv.DictReader(file))[-1]
        if run.returncode or abs(float(last["coin.y"] or 0) - 0.005) > 1e-7:
            print(f"FAIL a coin that topples at {accuracy}, {unit} s a unit: exit code {run.returncode}, it ends at {last['coin.y']}")
            return 1
    return 0


def tilted_coin(radius, height, tilt, restitution, friction):
    return f"""simulator -finish {12 * math.sqrt(radius / G)!r}
shape_set ground -desc {{-sub {{-plane}}}}
body ground ground -fixed 1 -friction {friction}
shape_set coin -desc {{-sub {{-cylinder {{{radius} {height}}}}}}}
body coin coin -restitution {restitution} -friction {friction} -init_pos {{0 {radius * math.sin(tilt) + height / 2 * math.cos(tilt)!r} 0}} -init_rot {{0 0 {tilt}}}
force -body coin -gravitational {{0 -{G} 0}}
"""


def check_tilted_coins():
    """Coins that stand tilted come to lie flat, at whatever speed their far sides land, and whether or not these bounce."""
    faults = 0
    for radius, height, tilt, restitution, friction, accuracy in (
            (1, 0.2, 0.1, 0.5, 0.3, "1e-2"), (1, 0.2, 0.1, 0, 0.3, "1e-2"), (11.6, 1.16, 0.3, 0.5, 0.3, "1e-3"), (1, 0.05, 0.8, 0.5, 0.3, "1e-2"),
            (1, 0.1, 0.5, 0, 0.3, "1e-2"), (1, 0.1, 0.5, 0, 0.3, "1e-3"), (1, 0.1, 0.5, 0, 0.3, "1e-6")):
        run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", "-", "--accuracy", accuracy], input=tilted_coin(radius, height, tilt, restitution, friction),
                             capture_output=True, text=True, check=False)
        last = list(csv.DictReader(run.stdout.splitlines()))[-1]
        if run.returncode or abs(float(last["coin.y"]) - height / 2) > 1e-5 * radius:
            faults += 1
            print(f"FAIL a coin of {radius} x {height} tilted by {tilt}, bounce {restitution}, at {accuracy}: it ends at {last['coin.y']}; {run.stderr}")
    return faults


def block_off(table, place, turn=""):
    return f"""simulator -finish 0.4 -accuracy 1e-6
shape_set ground -desc {{-sub {{-plane}}}}
shape_set table -desc {{-sub {{{turn} {table}}}}}
shape_set block -desc {{-sub {{-box {{0.1 0.1 0.1}}}}}}
body floor ground -fixed 1 -friction 0.3
body bd table -init_pos {{0 0.05 0}} -friction 0.2 -restitution 0 -fixed 1
body b block -init_pos {{{place}}} -friction 0.2 -restitution 0 -mass 1 -init_dpos {{0.8 0 0}}
force -body b -gravitational {{0 -{G} 0}}
"""


def check_slides_off():
    """A block slides off a round table, whose outermost corner is at the edge of the square one, as off that; and off the
    corner of a square table beside the middle, where one of its own corners leaves an edge askew to its way."""
    ways = []
    for table in ("-cylinder {0.4 0.1}", "-box {0.8 0.1 0.8}"):
        run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", "-", "--at", "0:0.1:0.3", "--only", "--quantities", "b.x,b.y,b.wz"],
                             input=block_off(table, "0.3 0.15 0"), capture_output=True, text=True, check=False)
        ways.append([float(x) for x in run.stdout.strip().splitlines()[-1].split(",")] if run.returncode == 0 else [])
    faults = 0
    if len(ways[0]) != 4 or max(abs(a - b) for a, b in zip(*ways)) > 1e-5:
        print(f"FAIL a block that slides off a round table: {ways}")
        faults += 1
    for beside in ("0.02", "0.001"):
        scene = block_off("-box {0.6 0.1 0.6}", "0.28 0.15 " + beside, turn="-rot {0 0.7853981633974483 0}")
        run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", os.devnull], input=scene, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            print(f"FAIL a block {beside} beside the corner: {run.stderr}")
            faults += 1
    return faults


def check_round_over_a_corner():
    """What is round goes over the corner of a table turned by 45 degrees as over the edge of a square one, where its side is over the corner."""
    faults = 0
    for body in ("-rot {0 0 1.5707963267948966} -cylinder {0.1 0.4}", "-rot {0 0 1.5707963267948966} -capsule {0.1 0.3}",
                 "-rot {1.5707963267948966 0 0} -cylinder {0.1 0.4}"):
        ways = []
        for table in ("-rot {0 0.7853981633974483 0} -box {0.9899494936611666 0.1 0.9899494936611666}", "-box {1.4 0.1 1.4}"):
            scene = f"""simulator -finish 0.5 -accuracy 1e-7
shape_set table -desc {{-sub {{{table}}}}}
shape_set round -desc {{-sub {{{body}}}}}
body table table -init_pos {{0 1 0}} -fixed 1 -friction 0.3
body b round -init_pos {{0.3 1.15 0}} -init_dpos {{1.9 0 0}} -mass 1 -friction 0.3 -restitution 0
force -body b -gravitational {{0 -{G} 0}}
"""
            run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", "-", "--at", "0:0.1:0.4", "--only", "--quantities", "b.x,b.y,b.wz"],
                                 input=scene, capture_output=True, text=True, check=False)
            ways.append([float(x) for x in run.stdout.strip().splitlines()[-1].split(",")] if run.returncode == 0 else [])
        if len(ways[0]) != 4 or max(abs(a - b) for a, b in zip(*ways)) > 1e-6:
            print(f"FAIL {body} over a corner: {ways}")
            faults += 1
    return faults


def check_hit_beside():
    """A box slides in a plane of the axes, and hits another beside its middle: it turns on the floor, and does not sink in."""
    box = "-mass 1 -friction 0.3 -restitution 0.5"
    scene = f"""simulator -finish 1
shape_set floor -desc {{-sub {{-box {{8 1 8}}}}}}
shape_set box -desc {{-sub {{-box {{0.2 0.1 0.2}}}}}}
body floor floor -init_pos {{0 -0.5 0}} -fixed 1 -friction 0.3 -restitution 0.5
body a box -init_pos {{0 0.05 0}} -init_dpos {{2 0 0}} {box}
body b box -init_pos {{0.4 0.05 0.05}} {box}
force -body a -gravitational {{0 -{G} 0}}
force -body b -gravitational {{0 -{G} 0}}
"""
    run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", "-", "--at", "0:0.1:1", "--only", "--quantities", "a.y,a.wy"],
                         input=scene, capture_output=True, text=True, check=False)
    rows = [line.split(",") for line in run.stdout.strip().splitlines()[1:]] if run.returncode == 0 else []
    heights, turns = [float(row[1]) for row in rows], [abs(float(row[2])) for row in rows]
    if not rows or max(turns) < 0.1 or max(abs(y - 0.05) for y in heights) > 1e-6:
        print(f"FAIL a box that is hit beside its middle: heights {heights}, turns {turns}; {run.stderr[:300]}")
        return 1
    return 0


def check_accuracies(known):
    """The thin rods and the ladder at the loosest and the tightest accuracy."""
    faults = 0
    for name, scene, ((time, kind, names),) in (case for case in known if case[0].startswith(("tipping_rod", "smooth_ladder"))):
        for accuracy, within in (("1e-3", 1e-3), ("1e-10", 1e-10)):
            found = [(float(row["time"]), row["kind"], row["names"]) for row in events(scene, accuracy=accuracy)]
            if len(found) != 1 or found[0][1:] != (kind, names) or abs(found[0][0] - time) > within:
                faults += 1
                print(f"FAIL {name} at {accuracy}: {found}, and not {kind} of {names} at {time!r}")
    return faults


def main():
    known = list(cases())
    faults = (check_jam() + check_accuracies(known) + check_hit_beside() + check_round_over_a_corner() + check_slides_off() + check_tilted_coins() + check_hops() + check_growing_hops() + check_half_space() + check_finish() + check_loose() + check_coin() +
              check_flush_ladder() + check_names())
    for name, scene, expected in known:
        found = events(scene)
        listed = [(float(row["time"]), row["kind"], row["names"]) for row in found]
        right = len(listed) == len(expected) and all(
            abs(a[0] - b[0]) < 1e-9 and a[1:] == b[1:] for a, b in zip(listed, expected))
        if not right or any((row["impulse"] != "") != (row["kind"] == "impact") for row in found):
            faults += 1
            print(f"FAIL {name}: {found}, and not {expected}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
