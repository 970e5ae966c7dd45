#!/usr/bin/env python3
"""Random piles of 3 to 20 bodies as people build them: do they come to rest, without sinking in, without new energy?

usage: random_piles.py ASGARD [--count N] [--seed S] [--seeds S,S,...] [--seconds T] [--most M] [--kind K] [--accuracy A]
                       [--keep FOLDER]

Kinds: boxes dropped on each other, boxes and balls into a tray, dominoes, a tower and a wall hit by a ball, what is
round on boxes; of `pair`, two boxes that tumble, by its name alone. Frictions and restitutions differ from pile to pile. A pile is right when it reaches its end without a
word and within M seconds of a processor, when no two bodies overlap by more than SUNK of the smaller one at any of its times (by the
separating axes of boxes and balls, computed here), and when its energy grows by less than GAIN of what it could lose.
Piles that stop are told, and may be few. T ends the trial early: piles so far count. Too many piles take too long yet
for ./test (docs/numerics/limits.md), which plays some that are quick, and so guards that none of these sinks in, gains
energy or stops. At length:

    nice -n 10 tests/contacts/random_piles.py build/release/bin/asgard --count 10000
"""
import argparse
import collections
import itertools
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
import time

SUNK, GAIN, ACCURACY = 1e-9, 1e-3, 1e-4
MOST_STOPS = 0.03
GRAVITY = 9.81
FLOOR = (40.0, 1.0, 40.0)


# ------------------------------------------------------------------------------------------------ vectors

def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def axes_of(q):
    """The columns of the matrix of the unit quaternion (w, x, y, z)."""
    w, x, y, z = q
    return ((1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
            (2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
            (2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)))


def gap_of_boxes(a, b):
    """Below 0: how far they overlap. Above: at most their distance (Gottschalk et al. 1996, fifteen axes)."""
    (place_a, axes_a, half_a), (place_b, axes_b, half_b) = a, b
    between = [p - q for p, q in zip(place_b, place_a)]
    best = -math.inf
    for axis in itertools.chain(axes_a, axes_b, (cross(u, v) for u in axes_a for v in axes_b)):
        length = math.sqrt(dot(axis, axis))
        if length < 1e-6:
            continue
        reach = sum(h * abs(dot(u, axis)) for h, u in zip(half_a, axes_a)) + sum(h * abs(dot(u, axis)) for h, u in zip(half_b, axes_b))
        best = max(best, (abs(dot(between, axis)) - reach) / length)
    return best


def gap_of_ball(place, radius, box):
    at, axes, half = box
    between = [p - q for p, q in zip(place, at)]
    local = [dot(between, axis) for axis in axes]
    outside = [abs(x) - h for x, h in zip(local, half)]
    far = math.sqrt(sum(max(x, 0) ** 2 for x in outside))
    return (far if far > 0 else max(outside)) - radius


# ------------------------------------------------------------------------------------------------ piles

class Pile:
    def __init__(self, seed, kind=""):
        self.dice = random.Random(seed)
        self.kind = kind or self.dice.choice(list(KINDS))
        self.lines, self.bodies, self.shapes = [], [], {}
        dice = self.dice
        self.friction = dice.choice((0, 0.1, 0.3, 0.5, 0.8))
        self.restitution = dice.choice((0, 0, 0.2, 0.5))
        self.finish = 3
        self.box("floor", FLOOR, (0, -0.5, 0), fixed=True)
        {**KINDS, **ASKED}[self.kind](self, dice.randint(3, 20))

    def shape(self, desc):
        if desc not in self.shapes:
            self.shapes[desc] = f"s{len(self.shapes)}"
            self.lines.append(f"shape_set {self.shapes[desc]} -desc {{-sub {{{desc}}}}}")
        return self.shapes[desc]

    def body(self, name, desc, place, form, size, more="", fixed=False):
        of = self.shape(desc)
        at = " ".join(repr(float(x)) for x in place)
        self.lines.append(f"body {name} {of} -init_pos {{{at}}} -friction {self.friction} -restitution {self.restitution} {more}"
                          + (" -fixed 1" if fixed else ""))
        if not fixed:
            self.lines.append(f"force -body {name} -gravitational {{0 -{GRAVITY} 0}}")
        self.bodies.append((name, form, size, fixed, place))

    def box(self, name, edges, place, more="", fixed=False):
        desc = "-box {" + " ".join(repr(float(x)) for x in edges) + "}"
        self.body(name, desc, place, "box", [x / 2 for x in edges], more, fixed)

    def ball(self, name, radius, place, more=""):
        self.body(name, f"-sphere {radius!r}", place, "ball", radius, more)

    def name(self):
        return f"b{len(self.bodies)}"

    def turned(self, most):
        dice = self.dice
        return "-init_rot {" + " ".join(repr(dice.uniform(-most, most)) for _ in range(3)) + "}"

    def text(self, accuracy=ACCURACY):
        return f"simulator -finish {self.finish} -accuracy {accuracy!r}\n" + "\n".join(self.lines) + "\n"


def dropped(pile, count):
    """Boxes above each other, a little beside and a little turned, or exactly straight."""
    dice = pile.dice
    tilt = dice.choice((0, 0, 0.1, 0.6))
    beside = dice.choice((0, 0.1, 0.3))
    height = 0.0
    for _ in range(min(count, 10)):
        edges = [dice.uniform(0.3, 1) for _ in range(3)] if dice.random() < 0.5 else [0.6, 0.4, 0.6]
        room = math.hypot(*edges) / 2 if tilt else edges[1] / 2
        height += room + dice.choice((0.02, 0.1, 0.3))
        place = (dice.uniform(-1, 1) * beside * edges[0], height, dice.uniform(-1, 1) * beside * edges[2])
        pile.box(pile.name(), edges, place, pile.turned(tilt) if tilt else "")
        height += room


def tray(pile, count):
    """Balls and boxes that fall into a tray."""
    dice = pile.dice
    wide = 2.0
    for k, (x, z) in enumerate(((1, 0), (-1, 0), (0, 1), (0, -1))):
        edges = (0.2, 1.0, wide + 0.4) if x else (wide + 0.4, 1.0, 0.2)
        pile.box(f"w{k}", edges, (x * (wide / 2 + 0.1), 0.5, z * (wide / 2 + 0.1)), fixed=True)
    cells = [(x, y, z) for y in range(3) for x in range(3) for z in range(3)]
    for k in range(count):
        x, y, z = cells[k]
        place = ((x - 1) * 0.6 + dice.uniform(-0.05, 0.05), 0.5 + y * 0.7, (z - 1) * 0.6 + dice.uniform(-0.05, 0.05))
        if dice.random() < 0.5:
            pile.ball(pile.name(), dice.choice((0.15, 0.2, 0.25)), place)
        else:
            pile.box(pile.name(), [dice.uniform(0.2, 0.3) for _ in range(3)], place, pile.turned(dice.choice((0, 0.5))))


def dominoes(pile, count):
    dice = pile.dice
    high, thick, wide = 1.0, 0.15, 0.5
    apart = dice.uniform(0.35, 0.8)
    spin = dice.uniform(-3, -1)
    for k in range(count):
        more = f"-init_drot {{0 0 {spin!r}}}" if k == 0 else ""
        pile.box(pile.name(), (thick, high, wide), (k * apart, high / 2, 0), more)


def tower(pile, count):
    """A tower, hit by a ball from the side."""
    dice = pile.dice
    edges = (0.5, dice.choice((0.25, 0.5)), 0.5)
    for k in range(min(count, 12) - 1):
        pile.box(pile.name(), edges, (dice.choice((0, 0.05)) * (k % 2), (k + 0.5) * edges[1], 0))
    height = dice.uniform(0.3, 0.9) * edges[1] * (min(count, 12) - 1)
    pile.ball(pile.name(), 0.2, (-1.5, max(height, 0.25), dice.choice((0, 0.1))), f"-init_dpos {{{dice.uniform(2, 6)!r} 1 0}}")


def wall(pile, count):
    """Bricks in a bond; a ball hits them, or they only stand."""
    dice = pile.dice
    across = dice.choice((2, 3, 4))
    edges = (0.5, 0.25, 0.25)
    placed = 0
    for row in itertools.count():
        for k in range(across):
            if placed == count - 1:
                break
            pile.box(pile.name(), edges, (k * 0.52 + (row % 2) * 0.26, (row + 0.5) * edges[1], 0))
            placed += 1
        if placed == count - 1:
            break
    speed = dice.choice((0, 2, 5))
    pile.ball(pile.name(), 0.2, (0.5, 0.5, 1.5), f"-init_dpos {{0 1 {-speed!r}}}")


def rounds(pile, count):
    """Balls, wheels and capsules dropped on boxes."""
    dice = pile.dice
    for k in range(min(count, 8)):
        x = (k // 2) * 1.0
        if k % 2 == 0:
            pile.box(pile.name(), (0.6, 0.3, 0.6), (x, 0.15, 0))
            continue
        radius, high = 0.15, 0.3
        place = (x + dice.uniform(-0.1, 0.1), 0.8, dice.uniform(-0.1, 0.1))
        form = dice.choice(("sphere", "cylinder", "capsule"))
        if form == "sphere":
            pile.ball(pile.name(), radius, place)
        else:
            turn = dice.choice(("", f"-init_rot {{{math.pi / 2!r} 0 0}}"))
            pile.body(pile.name(), f"-{form} {{{radius} {high}}}", place, "other", math.hypot(radius, high), turn)


def pair(pile, _):
    """Two boxes that tumble onto a floor, one onto the other."""
    dice = pile.dice
    pile.finish = 1.5
    for k in range(2):
        place = (dice.uniform(-0.05, 0.05), 0.4 + 0.6 * k, dice.uniform(-0.05, 0.05))
        pile.box(pile.name(), [dice.uniform(0.2, 0.4) for _ in range(3)], place, pile.turned(0.5))


KINDS = {"dropped": dropped, "tray": tray, "dominoes": dominoes, "tower": tower, "wall": wall, "rounds": rounds}
ASKED = {"pair": pair}  # by --kind alone


# ------------------------------------------------------------------------------------------------ judgement

def read(out):
    lines = out.splitlines()
    names = lines[0].split(",")
    rows = []
    for line in lines[1:]:
        cells = line.split(",")
        if "" in cells:
            break
        rows.append([float(cell) for cell in cells])
    return {name: k for k, name in enumerate(names)}, rows


def deepest(pile, columns, row):
    """The largest overlap as part of the smaller body's size."""
    at = []
    for name, form, size, fixed, place in pile.bodies:
        if form == "other":
            continue
        first = columns[name + ".x"]
        q = row[first + 6:first + 10]
        where = row[first:first + 3]
        at.append((form, size, where, axes_of(q) if form == "box" else None, fixed,
                   math.sqrt(dot(size, size)) if form == "box" else size))
    worst = 0.0
    for (one, size, where, axes, fixed, radius), (two, other, there, turned, held, reach) in itertools.combinations(at, 2):
        if fixed and held:
            continue
        if math.dist(where, there) > radius + reach:
            continue
        if one == "ball" and two == "ball":
            gap = math.dist(where, there) - size - other
        elif one == "box" and two == "box":
            gap = gap_of_boxes((where, axes, size), (there, turned, other))
        elif one == "ball":
            gap = gap_of_ball(where, size, (there, turned, other))
        else:
            gap = gap_of_ball(there, other, (where, axes, size))
        worst = max(worst, -gap / min(radius, reach))
    return worst


def check(asgard, seed, options, folder):
    """(kind, fault or "", stopped, seconds)"""
    pile = Pile(seed, options.kind)
    path = os.path.join(folder, f"{seed}.al")
    with open(path, "w", encoding="utf-8") as file:
        file.write(pile.text(options.accuracy))
    # On one thread: with more, the limit would count what is solved ahead, too.
    command = [asgard, "simulate", path, "--csv", "-", "--at", f"0:0.05:{pile.finish}", "--quantities", "scene.energy", "--threads", "1"]
    limit = int(options.most)
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    run = subprocess.run(command, capture_output=True, text=True, check=False,
                         preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    took = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    if run.returncode < 0:
        return pile.kind, f"takes over {limit} s" if took > 0.9 * limit else f"ends by signal {-run.returncode}", False, took
    errors = [line for line in run.stderr.splitlines() if "error:" in line or "warning:" in line]
    first = errors[0] if errors else ""
    if not run.stdout.strip():
        return pile.kind, first or f"exit {run.returncode}", False, took
    columns, rows = read(run.stdout)
    worst = max(deepest(pile, columns, row) for row in rows)
    if worst > SUNK:
        return pile.kind, f"sinks in by {worst:.2g} of the size", False, took
    energy = [row[columns["scene.energy"]] for row in rows]
    scale = max(energy[0] - min(energy), 1e-6 * abs(energy[0])) or 1
    gain = max((b - a for a, b in zip(energy, energy[1:])), default=0) / scale
    if gain > GAIN:
        return pile.kind, f"energy grows by {gain:.2g}", False, took
    if run.returncode != 0:
        return pile.kind, first or f"exit {run.returncode}", True, took
    return pile.kind, "", False, took


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seeds", default="")
    parser.add_argument("--seconds", type=float, default=math.inf)
    parser.add_argument("--most", type=float, default=60)
    parser.add_argument("--kind", default="", choices=["", *KINDS, *ASKED])
    parser.add_argument("--accuracy", type=float, default=ACCURACY)
    parser.add_argument("--keep", default="")
    options = parser.parse_args()
    began, answers = time.monotonic(), []
    with tempfile.TemporaryDirectory() as made:
        named = [int(seed) for seed in options.seeds.split(",") if seed]
        for seed in named or range(options.seed, options.seed + options.count):
            if time.monotonic() - began > options.seconds:
                break
            kind, fault, stopped, took = check(options.asgard, seed, options, options.keep or made)
            answers.append((seed, kind, fault, stopped, took))
            if fault:
                print(f"{'stops' if stopped else 'FAIL'} {seed} {kind}: {fault}", flush=True)
    stops = sum(1 for answer in answers if answer[3])
    faults = sum(1 for answer in answers if answer[2] and not answer[3])
    by_kind = collections.defaultdict(list)
    for _, kind, _, _, took in answers:
        by_kind[kind].append(took)
    for kind, times in sorted(by_kind.items()):
        print(f"{kind}: {len(times)} piles, median {sorted(times)[len(times) // 2]:.2g} s, longest {max(times):.2g} s")
    print(f"{len(answers)} piles: {stops} stop, {faults} wrong")
    return 1 if faults or stops > (0 if named else MOST_STOPS * max(len(answers), 30)) else 0


if __name__ == "__main__":
    sys.exit(main())
