#!/usr/bin/env python3
"""Scenes without contacts and joints take no more work than they did: steps and evaluations, which are the same on every machine.

usage: counts_test.py ASGARD [--write]

counts.csv has what each scene took at each accuracy; 2 % more (or three more, of few) fails. What takes less may be written
anew: --write.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
TABLE = os.path.join(HERE, "counts.csv")
COUNTS = ("steps", "rejected_steps", "evaluations")
ACCURACIES = ("1e-3", "1e-6", "1e-9")
# Bodies that move freely, by forces and links (a to c), balls that meet (d), held bodies (e), and larger problems (f).
SCENES = ("a01_ballistic_spin", "a05_driven_resonance", "a07_kepler_e09", "a10_figure_eight", "a12_foucault", "b01_free_symmetric_top",
          "b03_dzhanibekov", "b04_heavy_top", "b06_world_torque_offaxis", "c01_pendulum_large_amplitude", "c03_spherical_pendulum",
          "c05b_two_rods_ball_attached", "c06b_stiff_chain_1e8", "c09_link_extra_mass_underdamped", "d02_oblique_unequal",
          "d05_bounce_1000", "e02_release_recapture_jump", "e06_paddle_hits_ball", "f01_pleiades", "f04_iftomm_a01_simple_pendulum")


def taken(asgard, scene, accuracy, stats):
    subprocess.run([asgard, "simulate", os.path.join(HERE, scene + ".al"), "--times", os.path.join(HERE, scene + ".times"), "--accuracy",
                    accuracy, "--csv", os.devnull, "--stats", stats], check=True, capture_output=True, timeout=120)
    with open(stats, encoding="utf-8") as file:
        found = json.load(file)
    return {count: found[count] for count in COUNTS}


def main():
    asgard, faults = sys.argv[1], 0
    with tempfile.TemporaryDirectory() as folder:
        rows = [{"scene": scene, "accuracy": accuracy} | taken(asgard, scene, accuracy, os.path.join(folder, "stats"))
                for scene in SCENES for accuracy in ACCURACIES]
    if "--write" in sys.argv:
        with open(TABLE, "w", encoding="utf-8") as file:
            table = csv.DictWriter(file, ("scene", "accuracy") + COUNTS, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)
        return 0
    with open(TABLE, encoding="utf-8") as file:
        for row, before in zip(rows, csv.DictReader(file), strict=True):
            for count in COUNTS:
                if row[count] > max(1.02 * int(before[count]), int(before[count]) + 3):
                    faults += 1
                    print(f"FAIL {row['scene']} at {row['accuracy']}: {row[count]} {count}, before {before[count]}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
