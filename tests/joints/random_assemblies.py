#!/usr/bin/env python3
"""Random assemblies of bodies on joints, trees with loops: do joints stay closed, is energy kept?

usage: random_assemblies.py ASGARD [--count N] [--seed S] [--keep FOLDER]

An assembly has up to six bodies. Each is joined to the ground or an earlier one; some are joined twice, which closes a
loop that the start allows. Nothing takes energy away. A run is right when it reaches its end without a word, its joints'
points miss each other by less than GAP of its size at every time, and its energy changes by less than ENERGY of the
largest kinetic energy. Assemblies that stop are told, and may be few: a loop can reach a singular position.
"""
import argparse
import concurrent.futures
import math
import os
import random
import subprocess
import sys
import tempfile

GAP, ENERGY, ACCURACY = 1e-12, 1e-3, 1e-5
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


def listed(v):
    return "{" + " ".join(repr(x) for x in v) + "}"


class Assembly:
    def __init__(self, seed):
        self.dice = random.Random(seed)
        self.lines = ["simulator -finish 1 -accuracy %r -collisions 0" % ACCURACY, "shape_set box -desc {-sub {-box {0.6 0.3 0.2}}}"]
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
        self.bodies.append((place, axis, angle))
        self.lines.append(f"body b{i} box -mass {mass!r} -init_pos {listed(place)} -init_rot {listed([angle * a for a in axis])}")
        self.lines.append(f"force -body b{i} -gravitational {{0 {-GRAVITY} 0}}")

    def local(self, body, point):
        if body is None:
            return point
        place, axis, angle = self.bodies[body]
        return rotated(axis, -angle, [a - b for a, b in zip(point, place)])

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
        if kind not in ("ball", "fixed", "distance"):
            line += f" -axis {listed(unit(dice))}"
        self.lines.append(line)
        for axis, k in zip("xyz", range(3)):
            if kind in MEETING:
                first = f"b{one}.p{axis}({','.join(map(repr, offset))})"
                to = repr(second[k]) if other is None else f"b{other}.p{axis}({','.join(map(repr, second))})"
                self.gaps.append(f"{first}-({to})")
        if kind == "distance":
            self.gaps.append(f"{name}.q-({math.dist(point, far)!r})")

    def text(self):
        return "\n".join(self.lines) + "\n"


def check(asgard, seed, folder):
    """(fault or "", stopped)"""
    assembly = Assembly(seed)
    path = os.path.join(folder, f"{seed}.al")
    with open(path, "w", encoding="utf-8") as file:
        file.write(assembly.text())
    kinetic = "+".join(f"b{i}.mass/2*(b{i}.dx^2+b{i}.dy^2+b{i}.dz^2)" for i in range(len(assembly.bodies)))
    command = [asgard, "simulate", path, "--csv", "-", "--at", "0:0.05:1", "--only", "--quantities",
               ",".join(["scene.energy", kinetic] + [gap.replace(",", ", ") for gap in assembly.gaps])]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return "takes over 60 s", False
    if run.returncode != 0:
        first = run.stderr.strip().splitlines()[0] if run.stderr.strip() else f"exit {run.returncode}"
        return first, "Stopped at" in first
    if "error" in run.stderr or "warning" in run.stderr:
        return run.stderr.strip().splitlines()[0], False
    rows = [[float(cell) for cell in line.split(",")] for line in run.stdout.splitlines()[1:]]
    most = max(max(abs(x) for x in row[3:]) for row in rows) if assembly.gaps else 0
    if not most <= GAP * 2:
        return f"a joint gapes by {most:.2g}", False
    largest = max(row[2] for row in rows)
    change = max(abs(row[1] - rows[0][1]) for row in rows)
    if not change <= ENERGY * max(largest, 1e-9):
        return f"energy changes by {change:.2g} of {largest:.2g}", False
    return "", False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", default="")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        folder = options.keep or made
        seeds = range(options.seed, options.seed + options.count)
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            answers = list(pool.map(lambda seed: check(options.asgard, seed, folder), seeds))
    stops = [(seed, fault) for seed, (fault, stopped) in zip(seeds, answers) if stopped]
    faults = [(seed, fault) for seed, (fault, stopped) in zip(seeds, answers) if fault and not stopped]
    for seed, fault in stops:
        print(f"stops {seed}: {fault}")
    for seed, fault in faults:
        print(f"FAIL {seed}: {fault}")
    print(f"{options.count} assemblies: {len(stops)} stop, {len(faults)} wrong")
    return 1 if faults or len(stops) > MOST_STOPS * options.count else 0


if __name__ == "__main__":
    sys.exit(main())
