#!/usr/bin/env python3
"""The list of `asgard simulate --events` against the instants of closed forms.

usage: events_test.py ASGARD
"""
import csv
import math
import os
import subprocess
import sys
import tempfile

import contact_cases as contacts

G = contacts.G
HANG = """simulator -finish 2
shape_set ball -desc {-sub {-sphere 0.1}}
body b ball -mass 1 -ct 1
body c ball -mass 1 -init_pos {0 0 3} -ct 1
force -body b -gravitational {0 -9.81 0}
force -body c -gravitational {0 -9.81 0}
rope r -points {{b} {0 1 0}} -length 1.5
joint j -type slider -body1 c -axis {0 1 0} -limits {-1 {}} -release {t > 1.5}
"""
BRAKE = """simulator -finish 3
shape_set ball -desc {-sub {-sphere 0.1}}
body b ball -mass 1 -init_dpos {2 0 0}
joint rail -type slider -body1 b -axis {1 0 0} -friction 4
force -body b -x {t < 1 ? 0 : 6}
"""


def cases():
    """Of each: the scene, and its instants: time, kind, names."""
    stop = 5 / (G * (math.sin(0.3) + 0.4 * math.cos(0.3)))
    yield "thrown_up", contacts.CASES["thrown_up"][0], [(stop, "stick", "ground b")]
    rolls = 2 * 3 / (7 * 0.25 * G)
    yield "begins_to_roll", contacts.CASES["begins_to_roll"][0], [(rolls, "stick", "ground b")]
    together = 4 / (0.3 * G * (1 + 1 / 3))
    yield "cart", contacts.CASES["cart"][0], [(together, "stick", "c b")]
    gone = (20 - G) / 10
    yield "let_go", contacts.CASES["let_go_by_load"][0], [(gone, "release", "w holds"), (gone + math.sqrt(2 * 2.9 / G), "impact", "ground w")]
    yield "hangs", HANG, [(math.sqrt(2 * 0.5 / G), "taut", "b r"), (math.sqrt(2 / G), "limit", "c j"), (1.5, "release", "c j")]
    yield "brake", BRAKE, [(0.5, "stick", "b rail"), (1, "slip", "b rail")]
    falls = math.sqrt(2 * 0.4 / G)
    yield "pair_bounces", contacts.CASES["pair_bounces"][0], [(falls, "impact", "ground a"), (falls, "impact", "ground b")]


def main():
    faults = 0
    for name, scene, expected in cases():
        with tempfile.TemporaryDirectory() as folder:
            base = os.path.join(folder, "scene")
            with open(base + ".al", "w", encoding="utf-8") as file:
                file.write(scene)
            subprocess.run([sys.argv[1], "simulate", base + ".al", "--csv", base + ".csv", "--events", base + ".events", "--accuracy", "1e-9"],
                           check=True, capture_output=True)
            with open(base + ".events", encoding="utf-8") as file:
                found = list(csv.DictReader(file))
        listed = [(float(row["time"]), row["kind"], row["names"]) for row in found]
        right = len(listed) == len(expected) and all(
            abs(a[0] - b[0]) < 1e-9 and a[1:] == b[1:] for a, b in zip(listed, expected))
        if not right or any((row["impulse"] != "") != (row["kind"] == "impact") for row in found):
            faults += 1
            print(f"FAIL {name}: {found}, and not {expected}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
