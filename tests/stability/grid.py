#!/usr/bin/env python3
"""400 scenes over stiffness, mass ratio and scale: is any silently wrong?

usage: grid.py ASGARD TRUTH [--every N] [--from N] [--only TEXT] [--accuracies A,A] [--limit S] [--csv FILE] [--keep DIR]

Each scene runs at each accuracy. A run is good when its error is at most ten times that, or when it says itself that it is not
(a message, an estimate or a horizon in its statistics); a run that needs longer than the limit is too slow. Exit 0: none is silently
wrong, and at most one in fifty has no truth. ASGARD: the program; TRUTH: stability_truth. Seconds are of CPU, all threads together.
"""
import argparse
import csv
import json
import math
import os
import resource
import signal
import subprocess
import sys
import tempfile

import grid_scenes

PROMISE = 10  # times the accuracy asked
PATIENCE = 20  # as long by the clock as by the processor


def errorOf(scene, truth, rows):
    """Largest scaled error and its time; the measure is the accuracy's own (simulation/accuracy/accuracy.h), by the scene's size."""
    low, high = [math.inf] * 3, [-math.inf] * 3
    for places in truth:
        for (p, _), radius in zip(places, scene.radii):
            low = [min(a, b - radius) for a, b in zip(low, p)]
            high = [max(a, b + radius) for a, b in zip(high, p)]
    size = max(b - a for a, b in zip(low, high))
    worst, when = 0, scene.times[0]
    for places, row, t in zip(truth, rows, scene.times):
        for b, ((p, q), radius) in enumerate(zip(places, scene.radii)):
            error = math.dist(p, [row[f"b{b}.{c}"] for c in "xyz"])
            if q:
                found = [row[f"b{b}.q{c}"] for c in "wxyz"]
                error = max(error, radius * 2 * min(math.dist(q, found), math.dist(q, [-x for x in found])))
            if not error <= worst * size:
                worst, when = error / size, t
    return worst, when


def patience(limit):
    resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 5))


def cpu_seconds():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(asgard, scene, accuracy, limit, folder):
    path, stats = os.path.join(folder, "scene.al"), os.path.join(folder, "stats.json")
    with open(path, "w", encoding="utf-8") as file:
        file.write(scene.text)
    if os.path.exists(stats):
        os.remove(stats)
    times = os.path.join(folder, "times")
    with open(times, "w", encoding="utf-8") as file:
        file.write("\n".join(repr(t) for t in scene.times) + "\n")
    ran = subprocess.run([asgard, "simulate", path, "--times", times, "--accuracy", repr(accuracy), "--stats", stats],
                         capture_output=True, text=True, timeout=PATIENCE * limit, preexec_fn=lambda: patience(limit))
    if ran.returncode == -signal.SIGXCPU:
        raise subprocess.TimeoutExpired(ran.args, limit)
    told = json.load(open(stats)) if os.path.exists(stats) else {}
    rows = [{name: float(cell) if cell else math.nan for name, cell in row.items()}
            for row in csv.DictReader(ran.stdout.splitlines())]
    return ran, rows, told


def judge(scene, truth, accuracy, ran, rows, told):
    if ran.returncode != 0:
        return "stopped", math.nan, ran.stderr.strip()[-200:]
    error, when = errorOf(scene, truth, rows)
    if error <= accuracy:
        return "within", error, ""
    if error <= PROMISE * accuracy:
        return "within ten", error, ""
    horizon = told.get("predictable_until")
    if "warning" in ran.stderr or (told.get("error_estimate") or 0) > accuracy or (horizon is not None and horizon < when):
        return "warned", error, ran.stderr.strip()[-200:]
    return "SILENT", error, f"at t = {when:g}, estimate {told.get('error_estimate')}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("truth")
    parser.add_argument("--every", type=int, default=1)
    parser.add_argument("--from", dest="first", type=int, default=0)
    parser.add_argument("--only", default="")
    parser.add_argument("--accuracies", default="1e-3,1e-6")
    parser.add_argument("--limit", type=float, default=60)
    parser.add_argument("--csv")
    parser.add_argument("--keep", help="where scenes are written that are not within ten times the accuracy")
    options = parser.parse_args()
    counts, table = {}, ["scene,accuracy,verdict,error,estimate,seconds,steps"]
    with tempfile.TemporaryDirectory() as folder:
        for number, (name, scene) in enumerate(grid_scenes.scenes()):
            if number % options.every != options.first % options.every or options.only not in name:
                continue
            try:
                truth = scene.places(options.truth)
            except subprocess.CalledProcessError as why:
                counts["without truth"] = counts.get("without truth", 0) + 1
                print(f"without truth: {name}: {why.stderr.strip()}", flush=True)
                continue
            for accuracy in (float(a) for a in options.accuracies.split(",")):
                begin, told = cpu_seconds(), {}
                try:
                    ran, rows, told = run(os.path.abspath(options.asgard), scene, accuracy, options.limit, folder)
                    verdict, error, why = judge(scene, truth, accuracy, ran, rows, told)
                except subprocess.TimeoutExpired:
                    verdict, error, why = "too slow", math.nan, f"over {options.limit:g} s"
                seconds = cpu_seconds() - begin
                counts[verdict] = counts.get(verdict, 0) + 1
                table.append(f"{name},{accuracy:g},{verdict},{error:.3g},{told.get('error_estimate')},{seconds:.3f},{told.get('steps')}")
                if verdict not in ("within", "within ten"):
                    print(f"{verdict}: {name}, accuracy {accuracy:g}: error {error:.3g} {why}", flush=True)
                    if options.keep:
                        os.makedirs(options.keep, exist_ok=True)
                        with open(os.path.join(options.keep, name.replace(" ", "_") + ".al"), "w", encoding="utf-8") as file:
                            file.write(scene.text)
    if options.csv:
        with open(options.csv, "w", encoding="utf-8") as file:
            file.write("\n".join(table) + "\n")
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(counts.items())))
    blind = counts.get("without truth", 0)
    return 1 if counts.get("SILENT") or 50 * blind >= sum(counts.values()) - blind else 0


if __name__ == "__main__":
    sys.exit(main())
