#!/usr/bin/env python3
"""Scenes with joints against values that were computed without the engine.

usage: joints_test.py ASGARD [--accuracies A,A,...] [--scenes NAME,...] [--folder FOLDER] [--values FOLDER]

The values are beside the scenes, or in a folder of their own.

Of each NAME.al at each accuracy A:

  values    at the times of NAME.values what it lists is off by at most A times its scale, or 1e-10 of it
  joints    each expression that a line "# zero: EXPRESSION" of the scene names stays within 1e-12 of the scene's size, at 400 times
  estimate  the error that the run states is at least 0.3 times the true one (against a run at 1e-12) or rounding, and, but for
            one in twenty, at most 30 times
  the same  a second run gives the same bytes (at the first accuracy)
  no jams   none warns that a contact jams

Exit 0 when all hold.
"""
import argparse
import glob
import json
import math
import os
import re
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TIGHT = 1e-12
ROUNDING = 1e-10  # of values and of estimates
GAP = 1e-12


def simulate(asgard, scene, times, accuracy, quantities, folder):
    """The table, the error that the run states, and the scene's size."""
    paths = [os.path.join(folder, name) for name in ("times", "out.csv", "stats.json")]
    with open(paths[0], "w", encoding="utf-8") as file:
        file.write("\n".join(repr(t) for t in times) + "\n")
    command = [asgard, "simulate", scene, "--times", paths[0], "--accuracy", repr(accuracy), "--csv", paths[1], "--stats", paths[2]]
    if quantities:
        command += ["--quantities", ",".join(quantities)]
    run = subprocess.run(command, capture_output=True, text=True, timeout=120)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip()[-400:])
    if " jam at t = " in run.stderr:
        raise RuntimeError("no contact jams: " + run.stderr.strip()[-400:])
    with open(paths[1], encoding="utf-8") as file:
        text = file.read()
    with open(paths[2], encoding="utf-8") as file:
        estimate = json.load(file)["error_estimate"]
    stated = re.search(r" of (\S+) m[ ,]", run.stderr)
    return text, estimate, float(stated.group(1)) if stated else width(text)


def width(text):
    """Of the box of the centres, where a run that is accurate to rounding states no size."""
    columns = list(zip(*rows_of(text)))
    return max(max(column) - min(column) for column, name in zip(columns, text.splitlines()[0].split(","))
               if re.fullmatch(r"\w+\.[xyz]", name)) or 1.0


def rows_of(text):
    return [[float(cell) for cell in line.split(",")] for line in text.splitlines()[1:]]


def expected(base):
    """By time: scale, value, expression."""
    found = {}
    with open(base + ".values", encoding="utf-8") as file:
        for line in file:
            time, scale, value, expression = line.split(" ", 3)
            found.setdefault(float(time), []).append((float(scale), float(value), expression.strip()))
    return found


def zeros(base):
    with open(base + ".al", encoding="utf-8") as file:
        return [line.split(":", 1)[1].strip() for line in file if line.startswith("# zero:")]


def value_faults(text, accuracy, at, quantities):
    """What of the values is not met, and the largest error over what is allowed."""
    rows = {row[0]: row[-len(quantities):] for row in rows_of(text)}
    worst, faults = 0.0, []
    for time, wanted in at.items():
        for scale, value, expression in wanted:
            off = abs(rows[time][quantities.index(expression)] - value)
            allowed = max(accuracy, ROUNDING) * scale
            worst = max(worst, off / allowed)
            if not off <= allowed:
                faults.append(f"{expression} at {time:g} is off by {off:.3g} of {value:.6g}, {off / scale:.2g} of the scale")
    return faults, worst


def error_of(text, truth, size):
    """The largest error of a place, and the same with attitudes of bodies half as large as the scene."""
    place = both = 0.0
    head = text.splitlines()[0].split(",")
    bodies = [(head.index(name[:-2] + "x"), head.index(name)) for name in head if re.fullmatch(r"\w+\.qw", name)]
    for row, other in zip(rows_of(text), rows_of(truth)):
        for x, q in bodies:
            moved = math.dist(row[x:x + 3], other[x:x + 3]) / size
            turned = min(math.dist(row[q:q + 4], [sign * c for c in other[q:q + 4]]) for sign in (1, -1))
            place, both = max(place, moved), max(both, moved, turned)
    return place, both


def check(asgard, base, values, accuracies, folder, honest):
    at = expected(values)
    quantities = sorted({expression for wanted in at.values() for _, _, expression in wanted})
    gaps = zeros(base)
    many = [min(max(at) * i / 399, max(at)) for i in range(400)]
    name, faults, truth = os.path.basename(base), [], None
    for accuracy in accuracies:
        text, estimate, size = simulate(asgard, base + ".al", sorted(at), accuracy, quantities, folder)
        wrong, worst = value_faults(text, accuracy, at, quantities)
        faults += [f"{name} at {accuracy:g}: {fault}" for fault in wrong[:5]]
        motion = simulate(asgard, base + ".al", many, accuracy, gaps, folder)[0]
        truth = truth or simulate(asgard, base + ".al", many, TIGHT, [], folder)[0]
        gap = [max(abs(row[k - len(gaps)]) for row in rows_of(motion)) / size for k in range(len(gaps))]
        faults += [f"{name} at {accuracy:g}: {text} reaches {g:.3g} of the size" for text, g in zip(gaps, gap) if not g <= GAP]
        place, both = error_of(motion, truth, size)
        both = max(both, worst * max(accuracy, ROUNDING))  # angles of joints are estimated, too
        if not 0.3 * place <= max(estimate, ROUNDING):
            faults.append(f"{name} at {accuracy:g}: the estimate is {estimate:.2g}, the error {place:.2g}")
        honest.append((estimate <= max(30 * both, ROUNDING), f"{name} at {accuracy:g}: {estimate / max(both, 1e-16):.2g}"))
        if accuracy == accuracies[0] and simulate(asgard, base + ".al", many, accuracy, gaps, folder)[0] != motion:
            faults.append(f"{name}: another run gave other bytes")
        print(f"{name} {accuracy:g}: values {worst:.2g} of what is allowed, gaps {max(gap, default=0):.1e}, "
              f"estimate {estimate:.2g}, error {place:.2g} to {both:.2g}", flush=True)
    return faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--accuracies", default="1e-3,1e-6,1e-9")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--folder", default=HERE)
    parser.add_argument("--values", default="")
    options = parser.parse_args()
    names = [name for name in options.scenes.split(",") if name]
    faults, honest = [], []
    with tempfile.TemporaryDirectory() as folder:
        for path in sorted(glob.glob(os.path.join(options.values or options.folder, "*.values"))):
            values = path[:-len(".values")]
            base = os.path.join(options.folder, os.path.basename(values))
            if not names or os.path.basename(base) in names:
                faults += check(options.asgard, base, values, [float(a) for a in options.accuracies.split(",")], folder, honest)
    large = [text for is_honest, text in honest if not is_honest]
    print(f"estimates over 30 times the error: {len(large)} of {len(honest)}; " + "; ".join(large))
    if len(large) > 0.05 * len(honest) + 1:
        faults.append("too many estimates are too large")
    for fault in faults:
        print("FAIL " + fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
