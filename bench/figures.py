"""The dissertation's two measurements again: Figure 5.7 (time constants) and Figure 5.11 (collisions), with our own engine.

Costs are evaluations of single equations, which are exact and the same on every machine, and processor time of the whole
command but for reading.
"""
import collections
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "scenes"))
import collisions  # noqa: E402
import pendulums  # noqa: E402

Cost = collections.namedtuple("Cost", "seconds equation_evaluations steps discarded collisions history_bytes")
PATIENCE = 60  # seconds on the wall for one run of a series; larger ones of that series are left out then


def cost(asgard, scene, options=(), patience=PATIENCE):
    """What a run cost; None when it took too long."""
    with tempfile.TemporaryDirectory() as folder:
        stats = os.path.join(folder, "stats.json")
        command = [asgard, "simulate", "-", "--csv", "/dev/null", "--at", "0:1:0", "--stats", stats, *options]
        try:
            ran = subprocess.run(command, input=scene, text=True, capture_output=True, timeout=patience)
        except subprocess.TimeoutExpired:
            return None
        if ran.returncode != 0:
            print(f"figures: {' '.join(options)}: {ran.stderr.strip()[:200]}", file=sys.stderr)
            return None
        with open(stats, encoding="utf-8") as file:
            s = json.load(file)
    return Cost(s["seconds"], s["equation_evaluations"], s["steps"], s["discarded_steps"], s["collisions"], s["history_bytes"])


def added(costs):
    return Cost(*(sum(values) for values in zip(*costs)))


FIGURE_5_7 = (("together, original*", ("--method", "original", "--whole")),
              ("partitioned, original*", ("--method", "original")),
              ("together, trapezoidal*", ("--method", "trapezoidal", "--accuracy", "1e-2", "--whole")),
              ("partitioned, trapezoidal*", ("--method", "trapezoidal", "--accuracy", "1e-2")),
              ("together, today", ("--whole",)),
              ("partitioned, today", ()))


def figure_5_7(asgard, counts=(10, 1000), ratios=(1, 3, 10, 30, 100, 300, 1000)):
    """Rows (count, ratio, case, Cost)."""
    rows, gone = [], set()
    for count in counts:
        alone = {}  # by pendulum: of the slow ones once
        for ratio in ratios if count < 1000 else (1, 10, 100, 1000):
            scene = pendulums.scene(count, ratio)
            for case, options in FIGURE_5_7:
                if (count, case) in gone or (count >= 1000 and "--whole" in options):
                    continue
                found = cost(asgard, scene, options)
                if found is None:
                    gone.add((count, case))
                else:
                    rows.append((count, ratio, case, found))
            for i in range(count):
                if i == 0 or i not in alone:
                    alone[i] = cost(asgard, pendulums.scene(count, ratio, i))
            rows.append((count, ratio, "sum of separate runs", added(alone.values())))
    return rows


FIGURE_5_11 = (("1 no collisions, one component", 0, ("--whole",)),
               ("2 no collisions, components", 0, ()),
               ("3 collisions, one component", 1, ("--whole",)),
               ("4 collisions, components, events", 1, ()),
               ("5 collisions, components, no events", 1, ("--no-events",)))


def figure_5_11(asgard, counts=(3, 10, 30, 100, 300, 1000, 10000)):
    """Rows (bodies, method, case, Cost)."""
    rows, gone = [], set()
    for count in counts:
        for method in ("auto", "original"):
            for case, collide, options in FIGURE_5_11:
                if (method, case) in gone or (count >= 10000 and (method == "original" or case[0] not in "24")):
                    continue
                found = cost(asgard, collisions.scene(count, collide), ("--method", method, *options))
                if found is None or ("--whole" in options and found.seconds > 5):
                    gone.add((method, case))
                if found:
                    rows.append((count, method, case, found))
    return rows
