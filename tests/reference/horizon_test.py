#!/usr/bin/env python3
"""Holds the horizon of `asgard simulate` (from where on a motion is not predictable) against perturbation experiments.

usage: horizon_test.py ASGARD

The experiments share nothing with the engine: a double pendulum by the classical Runge-Kutta rule with steps that leave only
rounding, and a billiard as a loop over its bounces. Each is computed once as it is and again from starts that differ by one
unit in the last place; the horizon is the median time at which these part by more than the accuracy. Within 20 % (pendulum) and 10 % (billiard): exit 0.
"""
import json
import math
import os
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
WITHIN = {"double_pendulum.al": 0.2, "sinai_billiard.al": 0.1}  # no tolerance is below 64 units in the last place
ACCURACIES = (1e-2, 1e-4, 1e-6, 1e-8)


def pendulum_rates(y):
    a, b, u, v = y
    d = a - b
    bottom = 3 - math.cos(2 * d)
    return (u, v,
            (-29.43 * math.sin(a) - 9.81 * math.sin(a - 2 * b) - 2 * math.sin(d) * (v * v + u * u * math.cos(d))) / bottom,
            2 * math.sin(d) * (2 * u * u + 19.62 * math.cos(a) + v * v * math.cos(d)) / bottom)


def pendulum(a, b, finish=40.0, step=5e-4, every=20):
    """Places (upper, lower) at every 0.01 s."""
    y, places = (a, b, 0.0, 0.0), [(a, b)]
    for i in range(1, round(finish / step) + 1):
        k1 = pendulum_rates(y)
        k2 = pendulum_rates([p + step / 2 * q for p, q in zip(y, k1)])
        k3 = pendulum_rates([p + step / 2 * q for p, q in zip(y, k2)])
        k4 = pendulum_rates([p + step * q for p, q in zip(y, k3)])
        y = [p + step / 6 * (q + 2 * r + 2 * s + t) for p, q, r, s, t in zip(y, k1, k2, k3, k4)]
        if i % every == 0:
            places.append((y[0], y[1]))
    return places, 0.01


def billiard(vx, vy, finish=100.0, every=0.05):
    """Places of the ball's centre, a point between lines at 1.75 and a circle of radius 1.25, at every 0.05 s."""
    x, y, t, places, due = -1.5, 0.375, 0.0, [], 0.0
    while due <= finish:
        hits = [((1.75 - x) / vx, "x") if vx > 0 else ((-1.75 - x) / vx, "x"),
                ((1.75 - y) / vy, "y") if vy > 0 else ((-1.75 - y) / vy, "y")]
        b, speed2 = x * vx + y * vy, vx * vx + vy * vy
        root = b * b - speed2 * (x * x + y * y - 1.5625)
        if b < 0 and root > 0:
            hits.append(((-b - math.sqrt(root)) / speed2, "disc"))
        free, what = min(hits)
        while due <= finish and due <= t + free:
            places.append((x + vx * (due - t), y + vy * (due - t)))
            due += every
        x, y, t = x + vx * (t + free - t), y + vy * (t + free - t), t + free  # times are rounded as they stand
        if what == "x":
            vx = -vx
        elif what == "y":
            vy = -vy
        else:
            nx, ny = x / math.hypot(x, y), y / math.hypot(x, y)
            along = 2 * (vx * nx + vy * ny)
            vx, vy = vx - along * nx, vy - along * ny
    return places, every


def partings(compute, start, size_of):
    """accuracy -> the median time at which neighbours part."""
    truth, every = compute(*start)
    size = size_of(truth)
    found = {accuracy: [] for accuracy in ACCURACIES}
    for i in range(len(start)):
        for towards in (math.inf, -math.inf):
            near = list(start)
            near[i] = math.nextafter(near[i], towards)
            places, _ = compute(*near)
            gaps = [max(math.dist([p], [q]) for p, q in zip(a, b)) if compute is pendulum else math.dist(a, b)
                    for a, b in zip(truth, places)]
            for accuracy in ACCURACIES:
                found[accuracy].append(next((k * every for k, gap in enumerate(gaps) if gap > accuracy * size), math.inf))
    return {accuracy: statistics.median(times) for accuracy, times in found.items()}


def told(asgard, scene, accuracy):
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        subprocess.run([asgard, "simulate", os.path.join(HERE, "horizon", scene), "--accuracy", repr(accuracy), "--csv",
                        os.path.join(folder, "out.csv"), "--stats", stats], check=True, capture_output=True, timeout=300)
        return json.load(open(stats, encoding="utf-8"))["predictable_until"]


def main():
    experiments = {
        # The box that holds both pendulums, their balls of radius 0.1 included: angles along x.
        "double_pendulum.al": partings(pendulum, (2.0943951023931953, 2.9670597283903604),
                                       lambda places: max(map(max, places)) - min(map(min, places)) + 0.2),
        "sinai_billiard.al": partings(billiard, (0.8125, 0.5), lambda places: 4.0),
    }
    failed = 0
    for scene, parted in experiments.items():
        for accuracy in ACCURACIES:
            until = told(sys.argv[1], scene, accuracy)
            ok = until is not None and abs(until - parted[accuracy]) <= WITHIN[scene] * parted[accuracy]
            failed += not ok
            print(f"{'ok  ' if ok else 'FAIL'} {scene} {accuracy:g}: predictable until {until}, perturbed starts part at "
                  f"{parted[accuracy]:.4g} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
