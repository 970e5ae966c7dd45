#!/usr/bin/env python3
"""Draws the charts of docs/numerics/measurements.md, Stability, from what the tests measured.

usage: charts.py STABILITY_TEST BENCH_CHART FOLDER [GRID.csv ...]

STABILITY_TEST and BENCH_CHART are programs of a build, FOLDER is docs/numerics; GRID.csv is what grid.py --csv wrote.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

CHARTS = {
    "newton": ("Newton's longest step", "two rods in full swing, backward Euler; predicted: 0.27 (m/(k W w²))^(1/4)",
               "tightness of the links", "step, s"),
    "order": ("Fixed steps on stiff links", "two rods in full swing, k = 1e8, 0.2 s; points that are missing failed",
              "step, s", "error, m"),
    "grazing": ("Time of impact of grazing spheres", "1000 hits each, against long double", "depth over radius", "error, s"),
    "grid": ("400 scenes: the error beside the accuracy asked", "over both accuracies; worst of each kind and stiffness",
             "stiffness", "error / accuracy"),
}


def marks(program):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "marks.json")
        subprocess.run([program, "--gtest_output=json:" + path], check=True, stdout=subprocess.DEVNULL)
        with open(path, encoding="utf-8") as file:
            tests = [test for suite in json.load(file)["testsuites"] for test in suite["testsuite"]]
    for test in tests:
        for name, value in test.items():
            if name.startswith("mark|"):
                _, chart, series, x = name.split("|")
                yield chart, series, float(x), float(value)


def grid(files):
    worst = {}
    for path in files:
        with open(path, encoding="utf-8") as file:
            for row in csv.DictReader(file):
                if row["verdict"] in ("within", "within ten"):
                    _, kind, k = row["scene"].split()[:3]
                    dashed = "*" if kind in ("top", "walls") else ""  # more kinds than colours
                    place = (kind + dashed, float(k.split("=")[1]))
                    worst[place] = max(worst.get(place, 1e-12), float(row["error"]) / float(row["accuracy"]))
    for (kind, k), error in sorted(worst.items()):
        yield "grid", kind, k, error


def main():
    program, drawer, folder, *files = sys.argv[1:]
    points = list(marks(program)) + list(grid(files))
    for chart, texts in CHARTS.items():
        lines = [f"{series},{x:g},{y:g}" for c, series, x, y in points if c == chart]
        if lines:
            subprocess.run([drawer, os.path.join(folder, chart + ".svg"), *texts], input="\n".join(lines) + "\n", text=True,
                           check=True)


if __name__ == "__main__":
    main()
