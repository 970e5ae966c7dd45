#!/usr/bin/env python3
"""Figure 5.11: two pendulums, a ball that hits one of them twice and the other once, and bodies elsewhere that hit nothing.

usage: collisions.py COUNT [0|1]      bodies in all, at least 3; 0: collisions are ignored

The pendulums are rods on links, the other bodies swing along y, three metres apart.
"""
import sys


def scene(count, collisions=1):
    lines = [f"simulator -finish 3 -collisions {collisions}",
             "shape_set rod -desc {-sub {-box {0.1 1 0.1}}}",
             "shape_set ball -desc {-sub {-sphere 0.1}}"]
    for name, x in (("left", -1), ("right", 1)):
        lines += [f"body {name} rod -mass 1 -init_pos {{{x} -0.5 0}}",
                  f"force -body {name} -gravitational {{0 -10 0}}",
                  f"link -body1 {name} -offset1 {{0 0.5 0}} -x {x} -y 0 -z 0 -tightness 1000"]
    lines.append("body ball ball -mass 0.1 -init_pos {0 -0.8 0} -init_dpos {3 0 0}")
    for i in range(count - 3):
        lines.append(f"body o{i} ball -mass 1 -init_pos {{{5 + 3 * i} {0.5 + 0.01 * (i % 100):.17g} 0}}")
        lines.append(f"force -body o{i} -x 0 -y {{-10*sin(o{i}.y)}} -z 0")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(scene(int(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 1), end="")
