#!/usr/bin/env python3
"""Figure 5.7: COUNT pendulums for 10 s, the first with RATIO^2 times the others' gravity; with ONLY just that one of them.

usage: pendulums.py COUNT RATIO [ONLY]

A pendulum's angle is the x of a body: nothing but the swing is computed.
"""
import sys


def scene(count, ratio, only=None):
    lines = ["simulator -finish 10 -collisions 0", "shape_set ball -desc {-sub {-sphere 0.1}}"]
    for i in range(count) if only is None else [only]:
        gravity = 10 * (ratio ** 2 if i == 0 else 1)
        lines.append(f"body b{i} ball -mass 1 -init_pos {{{0.5 + i / (count - 1):.17g} 0 0}}")
        lines.append(f"force -body b{i} -x {{-{gravity:.17g}*sin(b{i}.x)}} -y 0 -z 0")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(scene(int(sys.argv[1]), float(sys.argv[2]), int(sys.argv[3]) if len(sys.argv) > 3 else None), end="")
