#!/usr/bin/env python3
"""Random scenes of friction, stacks, impacts, joints, gears and ropes against motions computed without the engine.

usage: random_truth.py ASGARD [--count N] [--seed S] [--only FAMILY] [--keep FOLDER]

families.py has the kinds of scenes. The accuracy asked is 1e-3 to 1e-9, by the seed. A run is right when

  it ends       without a word
  accuracy      its places are within the accuracy of the scene's size at 40 times, or within ROUNDING of it
  estimate      the error that it states is at least LEAST of the true one, where that one is more than rounding

and SHARE of the estimates are to be at most 30 times the error. Exit 0 when all hold.
"""
import argparse
import collections
import concurrent.futures
import json
import os
import random
import re
import subprocess
import sys
import tempfile

import families

ROUNDING, LEAST, SHARE, SAMPLES = 1e-11, 0.3, 0.95, 40
Found = collections.namedtuple("Found", "family fault ratio")  # ratio: of the estimate to the error, or None


def check(asgard, seed, only, folder):
    dice = random.Random(seed)
    family = next((f for f in families.ALL if f.__name__ == only), families.ALL[seed % len(families.ALL)])
    accuracy, scene = 10.0 ** -dice.randint(3, 9), family(dice)
    times = [min(scene.finish, scene.finish * (i + 1) / SAMPLES) for i in range(SAMPLES)]
    paths = [os.path.join(folder, f"{seed}.{end}") for end in ("al", "times", "json")]
    with open(paths[0], "w", encoding="utf-8") as file:
        file.write(scene.text(accuracy))
    with open(paths[1], "w", encoding="utf-8") as file:
        file.write("".join(f"{t!r}\n" for t in times))
    command = [asgard, "simulate", paths[0], "--times", paths[1], "--csv", "-", "--only", "--quantities", ",".join(scene.quantities), "--stats", paths[2]]
    at = f"{family.__name__} at {accuracy:g}"
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=60)
    except subprocess.TimeoutExpired:
        return Found(family.__name__, f"{at} takes over 60 s", None)
    told = next((line for line in run.stderr.splitlines() if re.search("error:|warning:|Stopped", line)), "")
    if run.returncode != 0 or told:
        return Found(family.__name__, f"{at}: {told or run.stderr.strip()[:200]}", None)
    stated = re.search(r" of (\S+) m[ ,]", run.stderr)  # none: "accurate to rounding"
    size = float(stated.group(1)) if stated else 1.0
    rows = [[float(cell) for cell in line.split(",")][1:] for line in run.stdout.splitlines()[1:]]
    error = max(abs(a - b) for row, wanted in zip(rows, scene.values(times)) for a, b in zip(row, wanted)) / size
    with open(paths[2], encoding="utf-8") as file:
        estimate = json.load(file)["error_estimate"] or 0.0
    if error > max(accuracy, ROUNDING):
        return Found(family.__name__, f"{at} is off by {error:.2g}, its estimate is {estimate:.2g}", None)
    if error <= ROUNDING:
        return Found(family.__name__, "", None)
    low = f"{at}: the estimate {estimate:.2g} is {estimate / error:.2g} of the error" if estimate < LEAST * error else ""
    return Found(family.__name__, low, estimate / error)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("asgard")
    parser.add_argument("--count", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="")
    parser.add_argument("--keep", default="")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as made:
        seeds = range(options.seed, options.seed + options.count)
        with concurrent.futures.ProcessPoolExecutor(2) as pool:
            jobs = [pool.submit(check, options.asgard, seed, options.only, options.keep or made) for seed in seeds]
            answers = [job.result() for job in jobs]
    faults = [(seed, one) for seed, one in zip(seeds, answers) if one.fault]
    for seed, one in faults:
        print(f"FAIL {seed}: {one.fault}")
    ratios = [one.ratio for one in answers if one.ratio is not None]
    high = sum(ratio > 30 for ratio in ratios)
    print(f"{options.count} scenes: {len(faults)} wrong; of {len(ratios)} with an error above rounding {high} have an estimate over 30 times the error")
    return 1 if faults or high > (1 - SHARE) * len(ratios) else 0


if __name__ == "__main__":
    sys.exit(main())
