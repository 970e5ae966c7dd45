#!/usr/bin/env python3
"""A cube comes down on the corner of another one, all but flush with it: no corner sinks in.

usage: flush_corners.py ASGARD [--seeds FROM:TO]

The upper cube touches the lower one at one corner, turned by so little that the edges cross between the corners: one
corner of each lies over the other's face, its neighbour 1e-10 to 1e-5 m beside it. As the cube comes down, these land
within a millionth of a second of each other. Depths are those of the separating axes, not of the program.
"""
import argparse
import math
import os
import random
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from random_piles import axes_of, gap_of_boxes, read  # noqa: E402

HALF, FINISH, STEP = 0.25, 0.01, 5e-5
SUNK = 2e-9 * HALF


def quaternion(axis, angle):
    s = math.sin(angle / 2)
    return (math.cos(angle / 2), *(s * x for x in axis))


def times(p, q):
    a, b, c, d = p
    e, f, g, h = q
    return (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f,
            a * h + b * g - c * f + d * e)


def scene(dice):
    """The upper cube's lower face goes through the corner (1, 1, 1) of the lower cube."""
    yaw = 10 ** dice.uniform(-10, -5) * dice.choice((1, -1))
    roll, pitch = -10 ** dice.uniform(-5, -3), 10 ** dice.uniform(-7, -4)
    q = times(times(quaternion((0, 1, 0), yaw), quaternion((1, 0, 0), pitch)), quaternion((0, 0, 1), roll))
    up = axes_of(q)[1]
    x, z = (dice.uniform(-1, 1) * abs(yaw) for _ in range(2))
    y = 2 * HALF + (up[0] * (HALF - x) + up[2] * (HALF - z) + HALF) / up[1]
    size = math.sqrt(sum(c * c for c in q[1:]))
    turned = [2 * math.atan2(size, q[0]) * c / size for c in q[1:]]
    spin = [dice.uniform(-1, 1) * 1e-2 for _ in range(3)]
    numbers = lambda values: " ".join(repr(v) for v in values)  # noqa: E731
    return f"""simulator -finish {FINISH} -accuracy 1e-4
shape_set cube -desc {{-sub {{-box {{0.5 0.5 0.5}}}}}}
body low cube -fixed 1 -init_pos {{0 {HALF} 0}} -friction 0.5 -restitution {dice.choice((0, 0.2))}
body high cube -init_pos {{{numbers((x, y, z))}}} -init_rot {{{numbers(turned)}}} -init_drot {{{numbers(spin)}}} \\
    -friction 0.5 -restitution 0
force -body high -gravitational {{0 -9.81 0}}
"""


def deepest(columns, rows):
    """The largest overlap at any of these times, in m."""
    half, straight = (HALF, HALF, HALF), axes_of((1, 0, 0, 0))
    first = columns["high.x"]
    worst = 0.0
    for row in rows:
        high = (row[first:first + 3], axes_of(row[first + 6:first + 10]), half)
        worst = max(worst, -gap_of_boxes(((0, HALF, 0), straight, half), high))
    return worst


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--seeds", default="110:270")
    options = parser.parse_args()
    first, last = (int(seed) for seed in options.seeds.split(":"))
    faults = 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "cubes.al")
        for seed in range(first, last):
            with open(path, "w", encoding="utf-8") as file:
                file.write(scene(random.Random(seed)))
            run = subprocess.run([options.asgard, "simulate", path, "--csv", "-", "--at", f"0:{STEP}:{FINISH}"],
                                 capture_output=True, text=True, check=False, timeout=100)
            depth = deepest(*read(run.stdout)) if run.returncode == 0 else math.nan
            if not depth <= SUNK:
                faults += 1
                print(f"FAIL {seed}: exit {run.returncode}, sinks in by {depth:.2g} m: {run.stderr[-200:]}")
    print(f"{last - first} cubes, {faults} wrong")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
