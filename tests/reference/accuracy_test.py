#!/usr/bin/env python3
"""Is the accuracy kept, what does that cost, and is the estimate of the error worth its name?

usage: accuracy_test.py ASGARD [--accuracies A,A,...] [--scenes PREFIX,...] [--methods M,M,...] [--csv FILE]

Per scene and accuracy, from the loosest on:

  kept      the error at the times of the reference is within the accuracy, or within what the scene's JSON states that doubles
            cannot avoid, or the run says itself that it is not (estimate over the accuracy)
  band      the estimate is 0.3 to 30 times the error of the whole motion, at 640 times, against our own run at 1e-13. The
            samples of a reference alone say too little: some lie where all has come to rest. Counted also against these.
            Not counted: errors under 1e-12, scenes that state an amplification of rounding, motion without integration.
  work      evaluations at A over those at 10 A (of each decade, where there are several between two accuracies), where the same methods took most steps

Prints a table by accuracy (evaluations of all scenes; the largest error over the accuracy, where the scene states no floor;
pairs in the band), and what is outside.

Exit 0 when all are kept, the band holds 95 % of the pairs, and nineteen in twenty ratios of work are at most 2.
With --methods, each of these is asked for by name instead of the engine's choice: then only work is told.
"""
import argparse
import collections
import glob
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile

import compare

HERE = os.path.dirname(os.path.abspath(__file__))
TIGHT = 1e-13
LEAST = 1e-12


def simulate(asgard, scene, times, accuracy, folder, more=()):
    out, stats = os.path.join(folder, "out.csv"), os.path.join(folder, "stats.json")
    run = subprocess.run([asgard, "simulate", scene, "--times", times, "--accuracy", repr(accuracy), "--csv", out, "--stats",
                          stats, *more], capture_output=True, text=True, timeout=600)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip()[-300:])
    return out, json.load(open(stats, encoding="utf-8"))


def span(asgard, scene):
    """Start and finish, from the rows that a run without times gives."""
    rows = subprocess.run([asgard, "simulate", scene, "--csv", "-", "--accuracy", "1e-2"], capture_output=True, text=True,
                          timeout=600, check=True).stdout.splitlines()
    return float(rows[1].split(",")[0]), float(rows[-1].split(",")[0])


def write_times(path, start, finish):
    """Equally spaced times, and others that come ever nearer to the start, where stiff motion settles."""
    times = {start + (finish - start) * i / 500 for i in range(501)}
    times |= {start + (finish - start) * 10 ** (-i / 20) for i in range(140)}
    with open(path, "w", encoding="utf-8") as f:
        f.write("\n".join(repr(t) for t in sorted(times)) + "\n")


def truth(asgard, base, folder):
    """Our own tight run as a reference for compare.py, and its estimate; the scene's own times are added to NAME.all."""
    name = os.path.join(folder, "truth")
    shutil.copy(base + ".json", name + ".json")
    write_times(name + ".times", *span(asgard, base + ".al"))
    out, stats = simulate(asgard, base + ".al", name + ".times", TIGHT, folder)
    shutil.copy(out, name + ".ref.csv")
    both = {float(line) for path in (base, name) for line in open(path + ".times", encoding="utf-8") if line.strip()}
    with open(name + ".all", "w", encoding="utf-8") as f:
        f.write("\n".join(repr(t) for t in sorted(both)) + "\n")
    return name, stats["error_estimate"]


def methods_of(stats):
    count = collections.Counter()
    for component in stats["component_list"]:
        count[component["method"]] += component["steps"]
    return count.most_common(1)[0][0] if count else ""


class Table:
    def __init__(self):
        self.rows = ["scene,method,accuracy,error,error_of_motion,estimate,evaluations,ratio"]
        self.missed, self.sampled, self.whole, self.ratios = [], [], [], []
        self.evaluations, self.largest = collections.Counter(), {}

    def count(self, name, accuracy, error, work):
        self.evaluations[accuracy] += work
        if error is not None:
            self.largest[accuracy] = max(self.largest.get(accuracy, (0, "")), (error / accuracy, name))

    def by_accuracy(self):
        def band(pairs, accuracy):
            mine = [p[0] for p in pairs if p[2] == accuracy]
            return f"{sum(mine)} of {len(mine)}"

        for accuracy, work in sorted(self.evaluations.items(), reverse=True):
            most, name = self.largest.get(accuracy, (0, ""))
            print(f"{accuracy:g}: {work} evaluations; largest error / accuracy {most:.2g} ({name}); band {band(self.whole, accuracy)},"
                  f" at the samples {band(self.sampled, accuracy)}")
        print(f"all: {sum(self.evaluations.values())} evaluations")

    def judge(self, name, accuracy, error, whole, estimate):
        for true, pairs in ((error, self.sampled), (whole, self.whole)):
            if true is not None and true > LEAST:
                pairs.append((0.3 * true <= estimate <= 30 * true, name, accuracy, estimate / true))

    def summary(self):
        inside = {}
        self.by_accuracy()
        for label, pairs in (("the whole motion", self.whole), ("the reference's samples", self.sampled)):
            kept = sum(p[0] for p in pairs)
            inside[label] = kept / len(pairs) if pairs else 1
            print(f"estimate 0.3 to 30 times the error of {label}: {kept} of {len(pairs)}, {100 * inside[label]:.1f} %")
            for p in pairs:
                if not p[0]:
                    print(f"    {p[1]} at {p[2]:g}: {p[3]:.2g} times")
        large = [r for r in self.ratios if r[3] > 2]
        print(f"work at A more than twice that at 10 A: {len(large)} of {len(self.ratios)}")
        for name, method, accuracy, ratio in large:
            print(f"    {name} by {method} at {accuracy:g}: {ratio:.2f} times")
        print(f"not kept: {len(self.missed)}")
        for text in self.missed:
            print(f"    {text}")
        return inside["the whole motion"] >= 0.95 and len(large) <= len(self.ratios) / 20 and not self.missed


def scene_rows(asgard, base, accuracies, method, folder, table):
    name = os.path.basename(base)
    more = ["--method", method] if method else []
    states_floor = "double_precision_error_growth" in json.load(open(base + ".json", encoding="utf-8"))["reference"]
    tight, before = None, {}
    for accuracy in accuracies:
        times = tight[0] + ".all" if tight else base + ".times"
        out, stats = simulate(asgard, base + ".al", times, accuracy, folder, more)
        estimate, work = stats["error_estimate"], stats["evaluations"]
        ok, error, _ = compare.compare(base, out, accuracy, say=lambda text: None)
        if estimate is not None and not ok and estimate <= accuracy:
            table.missed.append(f"{name} at {accuracy:g}: error {error:.3g}, estimate {estimate:.3g}")
        table.count(name, accuracy, None if states_floor else error, work)
        whole = None
        if not method and stats["steps"] > 0 and not states_floor:
            if tight is None:
                tight = truth(asgard, base, folder)
                out, _ = simulate(asgard, base + ".al", tight[0] + ".all", accuracy, folder)
            whole = compare.compare(tight[0], out, accuracy, say=lambda text: None)[1]
            if whole < 3 * tight[1]:
                whole = None  # no better known than that
            table.judge(name, accuracy, error, whole, estimate)
        chosen, ratio = methods_of(stats), None
        if chosen in before and work > 0:
            decades = math.log10(before[chosen][0] / accuracy)
            ratio = (work / before[chosen][1]) ** (1 / decades)
            table.ratios.append((name, chosen, accuracy, ratio))
        before = {chosen: (accuracy, work)} if work else {}
        table.rows.append(f"{name},{chosen},{accuracy:g},{error:.3g},{whole},{estimate},{work},{ratio}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--accuracies", default="1e-2,1e-3,1e-4,1e-5,1e-6,1e-7,1e-8,1e-9,1e-10")
    parser.add_argument("--scenes", default="")
    parser.add_argument("--methods", default="")
    parser.add_argument("--csv")
    options = parser.parse_args()
    accuracies = sorted((float(a) for a in options.accuracies.split(",")), reverse=True)
    prefixes = tuple(options.scenes.split(","))
    table = Table()
    with tempfile.TemporaryDirectory() as folder:
        for path in sorted(glob.glob(os.path.join(HERE, "*.al"))):
            if os.path.basename(path).startswith(prefixes):
                for method in options.methods.split(","):
                    try:
                        scene_rows(options.asgard, path[:-3], accuracies, method, folder, table)
                    except (RuntimeError, subprocess.TimeoutExpired) as why:
                        table.missed.append(f"{os.path.basename(path)} {method}: {why}")
    if options.csv:
        with open(options.csv, "w", encoding="utf-8") as f:
            f.write("\n".join(table.rows) + "\n")
    return 0 if table.summary() else 1


if __name__ == "__main__":
    sys.exit(main())
