#!/usr/bin/env python3
"""Random bodies dropped into fixed tubes and bowls, and onto their rims: does any go through a wall?

usage: random_hollows.py ASGARD [--count N] [--seed S] [--seconds T] [--most M]

Boxes, capsules and tetrahedra of 0.3 m without friction, by seed within the hollow or across its rim. Of each written
time the ends of its edges and places between them are compared with the wall, here and without the engine: a place is
within the wall by at most DEEP, and by AT_STOP where the motion has stopped with a sentence. A scene that takes over M
seconds of a processor counts as not ended. T ends the trial early.
"""
import argparse
import csv
import itertools
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
import time

INNER, OUTER, HALF, DEEP, AT_STOP = 0.5, 0.6, 2.0, 2e-6, 4e-4
MOST_UNENDED, MOST_STOPS = 0.1, 0.4  # shares; those across a rim come to rest there, which stops
BOX = [(a * 0.1, b * 0.075, c * 0.15) for a, b, c in itertools.product((-1, 1), repeat=3)]
TETRAHEDRON = [(x - 0.075, y - 0.075, z - 0.075) for x, y, z in ((0, 0, 0), (0.3, 0, 0), (0, 0.3, 0), (0, 0, 0.3))]
SHAPES = {  # vertices, radius around them
    "-box {0.2 0.15 0.3}": (BOX, 0.0),
    "-capsule {0.05 0.3}": ([(0, -0.15, 0), (0, 0.15, 0)], 0.05),
    "-points {{0 0 0} {0.3 0 0} {0 0.3 0} {0 0 0.3}}": (TETRAHEDRON, 0.0),
}


def turned(q, v):
    w, x, y, z = q
    t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])]
    return [v[0] + w * t[0] + y * t[2] - z * t[1], v[1] + w * t[1] + z * t[0] - x * t[2], v[2] + w * t[2] + x * t[1] - y * t[0]]


def depth(place, is_bowl):
    """Of a place in the wall; below 0: it is outside."""
    x, y, z = place
    if is_bowl:
        across, above = math.sqrt(x * x + y * y + z * z), y
    else:
        across, above = math.hypot(x, z), abs(y) - HALF
    return min(across - INNER, OUTER - across, -above)


def scene_of(seed):
    dice = random.Random(seed)
    is_bowl, shape, restitution = dice.random() < 0.5, dice.choice(list(SHAPES)), dice.choice([0, 0.3, 0.7])
    is_at_rim = dice.random() < 0.3
    wall = f"-bowl {{{INNER} {OUTER}}}" if is_bowl else f"-tube {{{INNER} {OUTER} {2 * HALF}}}"
    top = 0 if is_bowl else HALF
    place = (dice.uniform(0.3, 0.6), top + 0.4, dice.uniform(-0.1, 0.1)) if is_at_rim else (dice.uniform(-0.1, 0.1), -0.1, dice.uniform(-0.1, 0.1))
    pull = "0 -9.81 0" if is_bowl or is_at_rim else "9.81 0 0"
    turn = " ".join(repr(dice.uniform(-1, 1)) for _ in range(3))
    spin = f"{dice.uniform(-3, 3)} {dice.uniform(-3, 3)} 0"
    text = (f"simulator -finish 1 -accuracy 1e-4\nshape_set w -desc {{-sub {{{wall}}}}}\nshape_set s -desc {{-sub {{{shape}}}}}\n"
            f"body w w -fixed 1\nbody b s -mass 1 -init_pos {{{place[0]} {place[1]} {place[2]}}} -init_rot {{{turn}}} -init_drot {{{spin}}} "
            f"-restitution {restitution}\nforce -body b -gravitational {{{pull}}}\n")
    return text, shape, is_bowl, is_at_rim


def deepest(rows, shape, is_bowl):
    """How deep, and when. Capsules: their axis, within their radius of the wall."""
    vertices, radius = SHAPES[shape]
    found = (-math.inf, 0.0)
    for row in rows:
        if not row["b.x"]:
            continue
        q = [float(row["b.q" + n]) for n in "wxyz"]
        middle = [float(row["b." + n]) for n in "xyz"]
        ends = [[a + b for a, b in zip(middle, turned(q, v))] for v in vertices]
        places = [[a + (b - a) * k / 40 for a, b in zip(p, r)] for p, r in itertools.combinations(ends, 2) for k in range(41)]
        found = max(found, (max(depth(place, is_bowl) for place in places), float(row["t"])))
        if radius and not is_bowl:
            found = max(found, *((math.hypot(p[0], p[2]) + radius - INNER, float(row["t"])) for p in places
                                 if abs(p[1]) < HALF and math.hypot(p[0], p[2]) < INNER), (-1.0, 0.0))
    return found


def play(asgard, seed, folder, most):
    """"", and how it ended; or the fault."""
    text, shape, is_bowl, is_at_rim = scene_of(seed)
    base = os.path.join(folder, "scene")
    with open(base + ".al", "w", encoding="utf-8") as file:
        file.write(text)
    for end in (".csv",):
        if os.path.exists(base + end):
            os.remove(base + end)
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (most, most))
    run = subprocess.run([asgard, "simulate", base + ".al", "--csv", base + ".csv", "--at", "0:0.01:1"], capture_output=True, text=True,
                         preexec_fn=limit, check=False)
    if run.returncode < 0:
        return "", "unended"
    with open(base + ".csv", encoding="utf-8") as file:
        deep, when = deepest(list(csv.DictReader(file)), shape, is_bowl)
    if deep > (AT_STOP if run.returncode else DEEP):
        return f"seed {seed}: {shape} {deep:.3g} m within the {'bowl' if is_bowl else 'tube'} at {when:g}, exit code {run.returncode}\n{text}", "through"
    return "", "stopped at rim" if run.returncode and is_at_rim else "stopped" if run.returncode else "right"


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("asgard")
    arguments.add_argument("--count", type=int, default=30)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--seconds", type=float, default=1e9)
    arguments.add_argument("--most", type=int, default=10)
    asked = arguments.parse_args()
    ended, faults, begin = {}, 0, time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        for seed in range(asked.seed, asked.seed + asked.count):
            if time.monotonic() - begin > asked.seconds:
                break
            fault, end = play(asked.asgard, seed, folder, asked.most)
            ended[end] = ended.get(end, 0) + 1
            if fault:
                faults += 1
                print("FAIL", fault)
    count = sum(ended.values())
    print(", ".join(f"{n} {end}" for end, n in sorted(ended.items())))
    if ended.get("unended", 0) > MOST_UNENDED * count or sum(n for end, n in ended.items() if end.startswith("stopped")) > MOST_STOPS * count:
        print("FAIL too many do not end, or stop")
        faults += 1
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
