#!/usr/bin/env python3
"""What rests keeps every bit: the rows of 1,000 s are the same text.

usage: rest_test.py ASGARD
"""
import os
import subprocess
import sys
import tempfile

import contact_cases as contacts
import curved_cases  # adds its cases

RESTING = ("stays", "just_stays", "stack_heavy_above", "stack_heavy_below", "million_above", "million_below", "grip_holds", "wheel_rests")


def rows(scene, accuracy):
    """Of each time what stands behind it: places, attitudes, velocities and spins of all bodies."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.al")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene)
        run = subprocess.run([sys.argv[1], "simulate", path, "--csv", path + ".csv", "--at", "0:50:1000", "--accuracy", accuracy],
                             capture_output=True, text=True, check=False)
        if run.returncode:
            raise RuntimeError(run.stderr)
        with open(path + ".csv", encoding="utf-8") as file:
            return [line.strip().split(",", 1)[1] for line in file][1:]


def main():
    faults = 0
    for name in RESTING:
        for accuracy in ("1e-3", "1e-9"):
            found = rows(contacts.CASES[name][0], accuracy)
            if len(found) != 21 or len(set(found)) != 1:
                faults += 1
                print(f"FAIL {name} at {accuracy}: {len(set(found))} rows differ of {len(found)}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
