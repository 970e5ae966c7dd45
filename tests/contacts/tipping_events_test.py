#!/usr/bin/env python3
"""The list of `asgard simulate --events` of bodies that tip: no slips but those that one sees.

usage: tipping_events_test.py ASGARD
"""
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import contact_cases as contacts  # noqa: E402
from events_test import events  # noqa: E402


def tipped_box():
    return ("simulator -finish 1.6\nshape_set ground -desc {-sub {-plane}}\nshape_set box -desc {-sub {-box {0.5 1 0.5}}}\n"
            "body floor ground -fixed 1 -friction 0.4\nbody b box -init_pos {0 0.5 0} -mass 2 -friction 0.4 -restitution 0\n"
            "force -body b -offset {0 0.5 0} -x 5 -y 0 -z 0\n" + contacts.gravity("b"))


def box_on_a_belt():
    return ("simulator -finish 1.5\nshape_set belt -desc {-sub {-box {40 0.2 2}}}\nshape_set box -desc {-sub {-box {0.3 1.5 0.3}}}\n"
            "trajectory way -bezier {{0 4 {0 -0.1 0} {0 -0.1 0} {20 -0.1 0}}}\ntrajectory still -bezier {{0 4 {0 0 0}}}\n"
            "body belt belt -friction 0.5\nconstrain belt -pos way\nconstrain belt -rot still\n"
            "body b box -init_pos {0 0.75 0} -friction 0.5 -restitution 0\n" + contacts.gravity("b"))


def main():
    """A box that tips over its edge slips once, when it has turned far: not as its corners leave the ground."""
    faults = 0
    for name, scene, expected in (("a box that a force tips", tipped_box(), ["slip"]),
                                  ("a box on a belt that gathers speed", box_on_a_belt(), ["slip", "impact"])):
        times = []
        for accuracy in ("1e-3", "1e-6", "1e-9"):
            found = events(scene, accuracy=accuracy)
            times.append([float(row["time"]) for row in found])
            if [row["kind"] for row in found] != expected or any(abs(a - b) > 1e-3 for a, b in zip(times[0], times[-1])):
                faults += 1
                print(f"FAIL {name} at {accuracy}: {found}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
