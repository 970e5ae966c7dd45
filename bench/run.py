#!/usr/bin/env python3
"""Charts us against hand-written loops and other engines, on shared scenes, in one run.

usage: run.py [--build DIR] [--scenes S1,S2a,...] [--programs plain,asgard,...] [--budget SECONDS] [--rounds N] [--contacts] [--write]

Configures and builds a release with every driver whose library is installed, runs all of them one after the other, and
prints, for each scene and error, the cheapest run that came so near: the hand-written loop, us, the best other engine,
and SUNDIALS. With --write the dissertation's figures and the other goals are measured too, and docs/performance/ and the
tables of docs/performance.md are written anew. With --build nothing is built: the programs are taken from DIR/bin.
With --contacts the cases of bench/contacts are measured in place of the shared scenes, and --write writes their tables;
without other engines (--programs plain,asgard) only the one beside the hand-written loops.
"""
import argparse
import collections
import csv
import math
import os
import subprocess
import sys

import contact_pages
import figures
import pages

HERE = os.path.dirname(os.path.abspath(__file__))
SOURCE = os.path.dirname(HERE)
PROGRAMS = ("plain", "asgard", "sundials", "simbody", "mujoco", "dart", "bullet", "bullet_double", "ode")
ENGINES = PROGRAMS[3:]
CONTACT_PROGRAMS = ("plain", "asgard", "siconos", *ENGINES)
SPANS = {"S1": 60, "S2a": 5, "S2b": 5, "S3": 10, "S4": 10, "S5": 1, "S6": 1}
LEVELS = {"S1": (1e-2, 1e-4, 1e-6, 1e-9), "S2a": (1e-2, 1e-4, 1e-6, 1e-9), "S2b": (1e-2, 1e-4, 1e-6, 1e-9),
          "S3": (1e-4,), "S4": (1e-2, 1e-9), "S5": (0,), "S6": (1e-6,)}

Row = collections.namedtuple("Row", "program scene setting parameter error seconds least note")


def build():
    folder = os.path.join(SOURCE, "build", "bench")
    subprocess.run(["cmake", "--preset", "release", "-B", folder, "-DBENCH=ON", "-DBENCH_PEERS=ON"], cwd=SOURCE, check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["ninja", "-C", folder, "bench"], check=True, stdout=subprocess.DEVNULL)
    return folder


def rows_in(text):
    """A library may write lines of its own between the rows."""
    table = [fields for fields in csv.reader(text.splitlines()) if len(fields) == len(Row._fields)]
    return [Row(*fields[:3], *map(float, fields[3:7]), fields[7]) for fields in table]


def measured(folder, arguments):
    """The rows of all programs that there are; in several rounds, each row with the least of its times."""
    best = {}
    for number in range(arguments.rounds):
        for program in arguments.programs:
            path = os.path.join(folder, "bin", "bench_" + program + ("_contacts" if arguments.contacts else ""))
            if not os.path.exists(path):
                if number == 0:
                    print(f"{program}: not built here", file=sys.stderr)
                continue
            command = [path, "--budget", str(arguments.budget)]
            if arguments.scenes:
                command += ["--scenes", arguments.scenes]
            ran = subprocess.run(command, stdout=subprocess.PIPE, text=True)
            if ran.returncode != 0:
                print(f"{program}: ended with {ran.returncode}", file=sys.stderr)
            for row in rows_in(ran.stdout):
                key = (row.program, row.scene, row.setting, row.parameter, row.note if row.program == "plain" else "")
                old = best.get(key)
                if old:
                    row = row._replace(seconds=min(row.seconds, old.seconds), least=min(row.least, old.least))
                best[key] = row
    return list(best.values())


def kind(scene):
    return scene.split()[0]


def cheapest(rows, scene, level, chosen):
    found = [r for r in rows if r.scene == scene and r.error <= level and math.isfinite(r.seconds) and chosen(r)]
    return min(found, key=lambda r: r.least) if found else None


CHOICES = (("hand-written", lambda r: r.program == "plain"),
           ("our motion", lambda r: r.program == "asgard" and r.setting == "motion"),
           ("with its error", lambda r: r.program == "asgard" and r.setting == "with estimate"),
           ("all", lambda r: r.program == "asgard" and r.setting == "all"),
           ("best engine", lambda r: r.program in ENGINES),
           ("SUNDIALS", lambda r: r.program == "sundials"))


def comparison(rows):
    """(scene, level, {column: Row or None})."""
    scenes = list(dict.fromkeys(r.scene for r in rows if kind(r.scene) in SPANS and r.scene != "S4 energy"))
    for scene in sorted(scenes, key=kind):
        for level in LEVELS[kind(scene)]:
            yield scene, level, {name: cheapest(rows, scene, level, chosen) for name, chosen in CHOICES}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build")
    parser.add_argument("--scenes")
    parser.add_argument("--programs", type=lambda text: text.split(","))
    parser.add_argument("--budget", type=float, default=0.2)
    parser.add_argument("--rounds", type=int, default=1)
    parser.add_argument("--rows", help="a file of measurements to read instead of running the programs")
    parser.add_argument("--keep", help="a file of measurements: what is not measured now is taken from there")
    parser.add_argument("--no-figures", action="store_true", help="with --write: leave the dissertation's figures as they are")
    parser.add_argument("--contacts", action="store_true")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    arguments.programs = arguments.programs or (CONTACT_PROGRAMS if arguments.contacts else PROGRAMS)
    folder = arguments.build or build()
    if arguments.rows:
        with open(arguments.rows, encoding="utf-8") as file:
            rows = rows_in(file.read().split("\n", 1)[1])
    else:
        rows = measured(folder, arguments)
    if arguments.keep:
        with open(arguments.keep, encoding="utf-8") as file:
            kept = rows_in(file.read().split("\n", 1)[1])
        now = {(r.program, r.scene) for r in rows}
        rows += [r for r in kept if (r.program, r.scene) not in now]
    if arguments.contacts:
        print(contact_pages.table(rows))
        if arguments.write:
            contact_pages.write(SOURCE, folder, rows)
        return
    compared = list(comparison(rows))
    print(pages.comparison_table(compared, SPANS, kind))
    if arguments.write:
        pages.write(SOURCE, folder, rows, compared, SPANS, kind, figures, not arguments.no_figures)


if __name__ == "__main__":
    main()
