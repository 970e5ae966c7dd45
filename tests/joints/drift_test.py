#!/usr/bin/env python3
"""Joints do not drift: two rods on hinges that turn slowly for 1e6 s, some 160 times round, and gears and a rack beside them.

usage: drift_test.py ASGARD

The gap of each joint stays within 1e-12 of a rod's length, and energy within the accuracy.
"""
import subprocess
import sys

TURN = 1e-3
SCENE = f"""simulator -finish 1e6
shape_set rod -desc {{-sub {{-box {{1 0.05 0.05}}}}}}
shape_set wheel -desc {{-sub {{-rot {{1.5707963267948966 0 0}} -cylinder {{0.3 0.1}}}}}}
body a rod -mass 1 -init_pos {{0.5 0 0}} -init_dpos {{0 {TURN / 2} 0}} -init_drot {{0 0 {TURN}}}
body b rod -mass 1 -init_pos {{1.5 0 0}} -init_dpos {{0 {2.5 * TURN} 0}} -init_drot {{0 0 {3 * TURN}}}
joint one -type hinge -body1 a -offset1 {{-0.5 0 0}}
joint two -type hinge -body1 a -offset1 {{0.5 0 0}} -body2 b
body c wheel -mass 1 -init_pos {{0 3 0}} -init_drot {{0 0 {TURN}}}
body d wheel -mass 2 -init_pos {{1 3 0}} -init_drot {{0 0 {-2 * TURN}}}
joint three -type hinge -body1 c -offset1 {{0 0 0}}
joint four -type hinge -body1 d -offset1 {{0 0 0}}
gear meshed -joint1 four -joint2 three -ratio -2
"""
GAPS = ("a.px(-0.5,0,0)", "a.py(-0.5,0,0)", "a.px(0.5,0,0)-b.px(-0.5,0,0)", "a.py(0.5,0,0)-b.py(-0.5,0,0)", "c.x", "d.y-3")


def main():
    faults = 0
    for accuracy in ("1e-3", "1e-6"):
        run = subprocess.run([sys.argv[1], "simulate", "-", "--csv", "-", "--at", "0:2500:1000000", "--accuracy", accuracy, "--only",
                              "--quantities", ",".join(GAPS + ("four.q+2*three.q", "scene.energy"))],
                             input=SCENE, capture_output=True, text=True, check=True)
        rows = [[float(cell) for cell in line.split(",")[-len(GAPS) - 2:]] for line in run.stdout.splitlines() if line[0].isdigit()]
        gap = max(abs(cell) for row in rows for cell in row[:-2])
        turned = max(abs(row[-2]) for row in rows)  # angles reach 1000: rounding of them
        energy = max(abs(row[-1] / rows[0][-1] - 1) for row in rows)
        print(f"{accuracy}: {len(rows)} times, gap {gap:.1e}, gear {turned:.1e}, energy {energy:.1e}")
        faults += not (len(rows) == 401 and gap <= 1e-12 and turned <= 1e-12 * 1000 and energy <= float(accuracy))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
