"""Long runs of scenes that are nothing but collisions: `collisions.py ASGARD`; README.md says what they show."""

import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile


def galperin(n):
    return f"""simulator -finish 10
shape_set wall -desc {{-sub {{-box {{1 2 2}}}}}}
shape_set ball -desc {{-sub {{-sphere 0.1}}}}
body wall wall -fixed 1 -init_pos {{-0.5 0 0}}
body light ball -mass 1 -init_pos {{1.1 0 0}}
body heavy ball -mass {100 ** n} -init_pos {{2.3 0 0}} -init_dpos {{-1 0 0}}
"""


def gas(per_edge):
    lines = ["simulator -finish 10", "shape_set ball -desc {-sub {-sphere 0.05}}"]
    for axis in range(3):
        edges = [4, 4, 4]
        edges[axis] = 1
        lines.append(f"shape_set wall{axis} -desc {{-sub {{-box {{{edges[0]} {edges[1]} {edges[2]}}}}}}}")
        for side in (-1.5, 1.5):
            place = [0, 0, 0]
            place[axis] = side
            lines.append(f"body w{axis}{int(side > 0)} wall{axis} -fixed 1 -init_pos {{{place[0]} {place[1]} {place[2]}}}")
    draw = random.Random(1)
    for i in range(per_edge ** 3):
        cell = (i // per_edge ** 2, i // per_edge % per_edge, i % per_edge)
        place = " ".join(repr(-1 + (c + 0.5) * 2 / per_edge) for c in cell)
        velocity = " ".join(repr(draw.uniform(-1, 1) * 3 ** 0.5) for _ in range(3))
        lines.append(f"body b{i} ball -mass 1 -init_pos {{{place}}} -init_dpos {{{velocity}}}")
    return "\n".join(lines) + "\n"


def run(asgard, scene, folder):
    text, stats, rows = folder / "scene.al", folder / "stats.json", folder / "rows.csv"
    text.write_text(scene)
    done = subprocess.run([asgard, "simulate", text, "--stats", stats, "--csv", rows, "--at", "0:10:10"], check=False)
    with rows.open() as file:
        return done.returncode, json.loads(stats.read_text()), list(csv.DictReader(file))


def energy(row):
    return sum(float(value) ** 2 for name, value in row.items() if name.startswith("b") and name.endswith((".dx", ".dy", ".dz")))


def main():
    faults = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for n, expected in enumerate((3, 31, 314, 3141, 31415, 314159)):
            code, stats, _ = run(sys.argv[1], galperin(n), folder)
            good = code == 0 and stats["collisions"] == expected
            faults += not good
            print(f"{'ok  ' if good else 'FAIL'} Galperin {n}: {stats['collisions']} of {expected}, {stats['seconds']:.3g} s")
        code, stats, rows = run(sys.argv[1], gas(8), folder)
        drift = abs(energy(rows[-1]) / energy(rows[0]) - 1)
        good = code == 0 and drift < 1e-12 and stats["collisions"] > 20000
        faults += not good
        print(f"{'ok  ' if good else 'FAIL'} 512 balls, 10 s: {stats['collisions']} collisions, energy changes by {drift:.2g}, "
              f"{stats['pair_tests'] / stats['collisions'] / 2:.3g} pair tests each in each of two runs, {stats['seconds']:.3g} s")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
