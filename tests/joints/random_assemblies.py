#!/usr/bin/env python3
"""Random assemblies of bodies on joints, trees with loops: is the motion right, do joints stay closed, is energy kept?

usage: random_assemblies.py ASGARD [--peer PROGRAM] [--count N] [--seed S] [--keep FOLDER]

An assembly has up to six bodies. Each is joined to the ground or an earlier one; some are joined twice, which closes a
loop that the start allows. Nothing takes energy away. A run is right when it reaches its end without a word, its joints'
points miss each other by less than GAP of its size at every time, and its energy changes by less than ENERGY of the
largest kinetic energy. With --peer, assembly_motion.cpp as a program: its places are also those of that other
formulation, within the accuracy asked, which is 1e-3 to 1e-8 by the seed. Assemblies that stop are told, and may be
few: a loop can reach a singular position.
"""
import argparse
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile

GAP, ENERGY = 1e-12, 1e-3
TIMES = [i / 20 for i in range(21)]
PEER_STEPS = 2000
ROUNDING = 1e-12
PEER_PRECISION = 0.1  # the peer's own error over what is allowed; beyond it the peer says nothing
MOST_STOPS = 0.05
TYPES = ("hinge", "hinge", "hinge", "ball", "slider", "fixed", "universal", "cylindrical", "distance", "planar")
MEETING = ("hinge", "ball", "fixed", "universal")  # their points stay together
GRAVITY = 9.81


def rotated(axis, angle, v):
    """v turned about the unit axis (Rodrigues)."""
    c, s = math.cos(angle), math.sin(angle)
    dot = sum(a * b for a, b in zip(axis, v))
    cross = (axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0])
    return [c * v[i] + s * cross[i] + (1 - c) * dot * axis[i] for i in range(3)]


def unit(dice):
    while True:
        v = [dice.uniform(-1, 1) for _ in range(3)]
        size = math.sqrt(sum(x * x for x in v))
        if 0.1 < size < 1:
            return [x / size for x in v]


def perpendicular(v):
    least = min(range(3), key=lambda k: abs(v[k]))
    w = [-v[least] * x for x in v]
    w[least] += 1
    size = math.sqrt(sum(x * x for x in w))
    return [x / size for x in w]


def listed(v):
    return "{" + " ".join(repr(x) for x in v) + "}"


class Assembly:
    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.accuracy = 10.0 ** -(3 + seed % 6)
        self.peer = []
        self.lines = ["simulator -finish 1 -accuracy %r -collisions 0" % self.accuracy, "shape_set box -desc {-sub {-box {0.6 0.3 0.2}}}"]
        self.bodies, self.gaps, self.joints = [], [], 0
        dice = self.dice
        for i in range(dice.randint(1, 6)):
            self.add_body(i)
            self.join(i, dice.choice([None] + list(range(i))), dice.choice(TYPES))
        for i in range(len(self.bodies)):
            if dice.random() < 0.3:
                others = [None] + [k for k in range(len(self.bodies)) if k != i]
                self.join(i, dice.choice(others), dice.choice(("distance", "distance", "ball", "hinge")))

    def add_body(self, i):
        dice = self.dice
        place, axis, angle = [dice.uniform(-1, 1) for _ in range(3)], unit(dice), dice.uniform(0, 3)
        mass = 10 ** dice.uniform(-1, 1)
        self.bodies.append((place, axis, angle, mass))
        self.lines.append(f"body b{i} box -mass {mass!r} -init_pos {listed(place)} -init_rot {listed([angle * a for a in axis])}")
        self.lines.append(f"force -body b{i} -gravitational {{0 {-GRAVITY} 0}}")

    def local(self, body, point):
        if body is None:
            return point
        return self.turned_back(body, [a - b for a, b in zip(point, self.bodies[body][0])])

    def turned_back(self, body, v):
        if body is None:
            return v
        _, axis, angle, _ = self.bodies[body]
        return rotated(axis, -angle, v)

    def join(self, one, other, kind):
        dice, name = self.dice, f"j{self.joints}"
        self.joints += 1
        place = self.bodies[one][0]
        point = [x + dice.uniform(-0.6, 0.6) for x in place]
        offset = self.local(one, point)
        far = [x + dice.uniform(-1, 1) for x in point] if kind == "distance" else point
        second = self.local(other, far)
        line = f"joint {name} -type {kind} -body1 b{one} -offset1 {listed(offset)} -offset2 {listed(second)}"
        if other is not None:
            line += f" -body2 b{other}"
        first = unit(dice)
        _, axis, angle, _ = self.bodies[one]
        along = rotated(axis, angle, first)  # the world's axes
        if kind not in ("ball", "fixed", "distance"):
            line += f" -axis {listed(first)}"
        if kind == "universal":
            along = perpendicular(along)
            line += f" -axis2 {listed(self.turned_back(other, along))}"
        self.lines.append(line)
        self.peer.append([kind, one, -1 if other is None else other] + offset + second + first + self.turned_back(other, along))
        for axis, k in zip("xyz", range(3)):
            if kind in MEETING:
                first = f"b{one}.p{axis}({','.join(map(repr, offset))})"
                to = repr(second[k]) if other is None else f"b{other}.p{axis}({','.join(map(repr, second))})"
                self.gaps.append(f"{first}-({to})")
        if kind == "distance":
            self.gaps.append(f"{name}.q-({math.dist(point, far)!r})")

    def text(self):
        return "\n".join(self.lines) + "\n"

    def peer_text(self):
        """As assembly_motion.cpp reads it."""
        a, b, c = (0.6 ** 2 / 12, 0.3 ** 2 / 12, 0.2 ** 2 / 12)
        rows = [["bodies", len(self.bodies)]]
        for place, axis, angle, mass in self.bodies:
            inertia = [mass * (b + c), mass * (a + c), mass * (a + b)]
            attitude = [math.cos(angle / 2)] + [math.sin(angle / 2) * x for x in axis]
            rows.append([mass] + inertia + place + attitude + [0.0] * 6)
        rows += [["joints", len(self.peer)]] + self.peer + [["times", len(TIMES) - 1], TIMES[1:]]
        return "\n".join(" ".join(str(x) if isinstance(x, (str, int)) else repr(x) for x in row) for row in rows) + "\n"


def difference(peer, assembly, rows, size):
    """From the peer's places: the largest over what the accuracy allows, and the peer's own error over that."""
    run = subprocess.run([peer, str(PEER_STEPS)], input=assembly.peer_text(), capture_output=True, text=True, timeout=120)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip())
    allowed, worst, unsure = assembly.accuracy * size, 0.0, 0.0
    for row, line in zip(rows[1:], run.stdout.splitlines()):
        places = [float(x) for x in line.split()]
        worst = max([worst] + [math.dist(row[i:i + 3], places[1 + i - 3:4 + i - 3]) for i in range(3, 3 + 3 * len(assembly.bodies), 3)])
        unsure = max(unsure, places[-1])
    # Half the steps make sixteen times the error of a method of order 4.
    return worst / allowed, unsure / 15 / allowed


class Found:
    """Of a run: fault (or ""), whether it stopped; where there is a peer, error and estimate over the accuracy."""

    def __init__(self, fault="", stopped=False, error=None, estimate=None):
        self.fault, self.stopped, self.error, self.estimate = fault, stopped, error, estimate

    def honest(self):
        return 0.3 * self.error <= self.estimate <= 30 * self.error


def check(asgard, peer, seed, folder):
    assembly = Assembly(seed)
    path = os.path.join(folder, f"{seed}.al")
    with open(path, "w", encoding="utf-8") as file:
        file.write(assembly.text())
    bodies = range(len(assembly.bodies))
    kinetic = "+".join(f"b{i}.mass/2*(b{i}.dx^2+b{i}.dy^2+b{i}.dz^2)" for i in bodies)
    places = [f"b{i}.{axis}" for i in bodies for axis in "xyz"]
    stats = os.path.join(folder, f"{seed}.json")
    command = [asgard, "simulate", path, "--stats", stats, "--csv", "-", "--at", "0:0.05:1", "--only", "--quantities",
               ",".join(["scene.energy", kinetic] + places + [gap.replace(",", ", ") for gap in assembly.gaps])]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return Found("takes over 60 s")
    if run.returncode != 0:
        first = run.stderr.strip().splitlines()[0] if run.stderr.strip() else f"exit {run.returncode}"
        return Found(first, "Stopped at" in first)
    rows = [[float(cell) for cell in line.split(",")] for line in run.stdout.splitlines()[1:]]
    told = next((line for line in run.stderr.splitlines() if "error" in line.split(":")[0] or "warning" in line), "")
    gaps = max((abs(x) for row in rows for x in row[3 + len(places):]), default=0)
    if not gaps <= GAP * 2:
        return Found(f"a joint gapes by {gaps:.2g}")
    largest = max(row[2] for row in rows)
    change = max(abs(row[1] - rows[0][1]) for row in rows)
    if not told and not change <= ENERGY * max(largest, 1e-9):
        return Found(f"energy changes by {change:.2g} of {largest:.2g}")
    size = float(re.search(r" of (\S+) m[ ,]", run.stderr).group(1))
    error, unsure = difference(peer, assembly, rows, size) if peer else (None, 1)
    if unsure > PEER_PRECISION:
        return Found("says " + told if told else "", bool(told))
    if error > 1 + PEER_PRECISION and not told:
        return Found(f"is off by {error:.2g} times its accuracy of {assembly.accuracy:g}", error=error)
    with open(stats, encoding="utf-8") as file:
        estimate = json.load(file)["error_estimate"] / assembly.accuracy
    seen = error if error > 10 * unsure and error * assembly.accuracy > ROUNDING else None
    return Found("says " + told if told else "", bool(told), seen, estimate)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--peer", default="")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        folder = options.keep or made
        seeds = range(options.seed, options.seed + options.count)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda seed: check(options.asgard, options.peer, seed, folder), seeds))
    told = [(seed, one) for seed, one in zip(seeds, answers) if one.fault]
    stops = [one for _, one in told if one.stopped]
    for seed, one in told:
        print(f"{'stops' if one.stopped else 'FAIL'} {seed}: {one.fault}")
    print(f"{options.count} assemblies: {len(stops)} stop or warn, {len(told) - len(stops)} wrong")
    compared = [one for one in answers if one.error is not None]
    if compared:
        print(f"{len(compared)} differ from the peer by more than its own error, by at most {max(one.error for one in compared):.2g}"
              f" of the accuracy; the estimate is 0.3 to 30 times that in {sum(map(Found.honest, compared))}, at least"
              f" {min(one.estimate / one.error for one in compared):.2g} times")
    return 1 if len(told) > len(stops) or len(stops) > MOST_STOPS * options.count else 0


if __name__ == "__main__":
    sys.exit(main())
