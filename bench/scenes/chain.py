#!/usr/bin/env python3
"""A chain of COUNT rods on links of tightness K, hanging from its end and let go level, for 1 s.

usage: chain.py COUNT K
"""
import sys


def scene(count, tightness):
    lines = ["simulator -finish 1 -collisions 0", "shape_set rod -desc {-sub {-box {1 0.1 0.1}}}"]
    for i in range(count):
        to = "-x 0 -y 0 -z 0" if i == 0 else f"-body2 r{i - 1} -offset2 {{0.5 0 0}}"
        lines += [f"body r{i} rod -mass 1 -init_pos {{{i + 0.5} 0 0}}",
                  f"force -body r{i} -gravitational {{0 -10 0}}",
                  f"link -body1 r{i} -offset1 {{-0.5 0 0}} {to} -tightness {tightness:.17g}"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    print(scene(int(sys.argv[1]), float(sys.argv[2])), end="")
