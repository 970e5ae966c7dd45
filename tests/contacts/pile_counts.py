#!/usr/bin/env python3
"""How much work do stacks and piles take? Counts of `--stats`, which are the same on every machine.

usage: pile_counts.py ASGARD

Each line of CASES has a scene and the most of each count that it may take. `seed` names a pile of random_piles.py.
"""
import json
import math
import re
import subprocess
import sys
import tempfile
import os

import random_piles


def stack(count, apart):
    lines = ["simulator -finish 3 -accuracy 1e-3", "shape_set brick -desc {-sub {-box {1 0.5 1}}}",
             "shape_set ground -desc {-sub {-box {20 1 20}}}", "body floor ground -init_pos {0 -0.5 0} -fixed 1 -friction 0.5"]
    for k in range(count):
        lines.append(f"body b{k} brick -init_pos {{0 {0.25 + apart + (0.5 + apart) * k!r} 0}} -friction 0.5 -restitution 0")
        lines.append(f"force -body b{k} -gravitational {{0 -9.81 0}}")
    return "\n".join(lines) + "\n"


def three_balls():
    """One lies on two others, which friction alone keeps together."""
    lines = ["simulator -finish 1 -accuracy 1e-3", "shape_set ground -desc {-sub {-plane}}", "shape_set ball -desc {-sub {-sphere 0.5}}",
             "body floor ground -fixed 1 -restitution 0"]
    for name, place in (("left", "-0.5 0.5"), ("right", "0.5 0.5"), ("top", f"0 {(1 + math.sqrt(3)) / 2!r}")):
        lines += [f"body {name} ball -mass 1 -init_pos {{{place} 0}} -friction 0.27 -restitution 0",
                  f"force -body {name} -gravitational {{0 -9.81 0}}", f"contact -body1 {name} -body2 floor -friction 0.09"]
    return "\n".join(lines) + "\n"


def pile(seed, finish, accuracy=random_piles.ACCURACY):
    text = re.sub(r"-finish \S+", f"-finish {finish!r}", random_piles.Pile(seed).text(), count=1)
    return re.sub(r"-accuracy \S+", f"-accuracy {accuracy!r}", text, count=1)


def wall(seed, finish, accuracy):
    """Of random_piles.py, one run."""
    return pile(seed, finish, accuracy).replace("simulator ", "simulator -method dop853 ", 1)


def chain(links, finish, accuracy="1e-6"):
    """Links on hinges that swing in a plane until one hits another."""
    lines = [f"simulator -finish {finish!r} -accuracy {accuracy}", "shape_set l -desc {-sub {-box {0.1 0.02 0.02}}}"]
    for k in range(links):
        to = f" -body2 l{k - 1} -offset2 {{0.05 0 0}}" if k else ""
        lines += [f"body l{k} l -mass 0.1 -init_pos {{{0.05 + 0.1 * k!r} 0 0}}", f"joint j{k} -type hinge -body1 l{k} -offset1 {{-0.05 0 0}}{to}",
                  f"force -body l{k} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines) + "\n"


def struck(ball, finish):
    """Three equal boxes on each other, without friction and with full bounce as in a new scene, and a ball that flies at them."""
    lines = [f"simulator -finish {finish!r} -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}",
             "shape_set block -desc {-sub {-box {1 1 1}}}", "shape_set ball -desc {-sub {-sphere 0.5}}", "body floor floor -fixed 1"]
    for k, z in enumerate((0.805, 0.913, 0.85)):
        lines.append(f"body b{k} block -init_pos {{0.416 {0.5 + k!r} {z!r}}}")
        lines.append(f"force -body b{k} -gravitational {{0 -9.81 0}}")
    lines += [f"body ball ball -init_pos {{-3 {ball!r} 0.8}} -init_dpos {{10 0 0}}", "force -body ball -gravitational {0 -9.81 0}"]
    return "\n".join(lines) + "\n"


def two_cubes(finish):
    """Two tilted cubes with the friction of a new scene, dropped on each other."""
    lines = [f"simulator -finish {finish!r} -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}",
             "shape_set cube -desc {-sub {-box {1 1 1}}}", "body floor floor -fixed 1 -friction 0.3 -restitution 0"]
    for k, (place, turn) in enumerate((("0 1.5 0", "0.3 0.2 0.42"), ("0.3 3.2 0.1", "0.1 0.5 -0.4"))):
        lines.append(f"body b{k} cube -friction 0.3 -restitution 0 -init_pos {{{place}}} -init_rot {{{turn}}}")
        lines.append(f"force -body b{k} -gravitational {{0 -9.81 0}}")
    return "\n".join(lines) + "\n"


def hit_with_friction(count, height, speed):
    """Boxes on each other as a new scene makes them, not quite above each other, and a ball that flies at them."""
    lines = ["simulator -finish 2 -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", "shape_set block -desc {-sub {-box {1 1 1}}}",
             "shape_set ball -desc {-sub {-sphere 0.5}}", "body floor floor -fixed 1 -friction 0.3 -restitution 0"]
    for k in range(count):
        z = (0.805, 0.913, 0.85)[k % 3]
        lines.append(f"body b{k} block -init_pos {{0.416 {0.5 + k!r} {z!r}}} -friction 0.3 -restitution 0")
        lines.append(f"force -body b{k} -gravitational {{0 -9.81 0}}")
    lines += [f"body ball ball -init_pos {{-3 {height!r} 0.8}} -init_dpos {{{speed} 0 0}} -friction 0.3 -restitution 0.7",
              "force -body ball -gravitational {0 -9.81 0}"]
    return "\n".join(lines) + "\n"


def dominoes(count, speed):
    """Dominoes on a floor as a new scene makes them, and a ball without friction that rolls at them, in one plane."""
    lines = ["simulator -finish 2 -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", "shape_set stone -desc {-sub {-box {0.02 0.1 0.05}}}",
             "shape_set ball -desc {-sub {-sphere 0.02}}", "body floor floor -fixed 1 -friction 0.4"]
    for k in range(count):
        lines.append(f"body d{k} stone -init_pos {{{0.05 * k!r} 0.05 0}} -restitution 0 -friction 0.3")
        lines.append(f"force -body d{k} -gravitational {{0 -9.81 0}}")
    lines += [f"body ball ball -init_pos {{-0.2 0.08 0}} -init_dpos {{{speed} 0 0}} -restitution 0.5", "force -body ball -gravitational {0 -9.81 0}"]
    return "\n".join(lines) + "\n"


def dominoes_askew(count, finish):
    """High dominoes with the friction of a new scene, and a large ball that hits the first beside its middle."""
    lines = [f"simulator -finish {finish!r} -accuracy 1e-2", "shape_set floor -desc {-sub {-plane}}", "shape_set stone -desc {-sub {-box {0.2 1 0.5}}}",
             "shape_set ball -desc {-sub {-sphere 0.5}}", "body floor floor -fixed 1 -friction 0.3 -restitution 0"]
    for k in range(count):
        lines.append(f"body d{k} stone -init_pos {{{0.5 * k!r} 0.5 0}} -restitution 0 -friction 0.3")
        lines.append(f"force -body d{k} -gravitational {{0 -9.81 0}}")
    lines += ["body ball ball -init_pos {-2 0.5 -0.0333333} -init_dpos {3 0 0} -restitution 0 -friction 0.3",
              "force -body ball -gravitational {0 -9.81 0}"]
    return "\n".join(lines) + "\n"


def pyramid(finish):
    """Six blocks in a pyramid with the friction of a new scene, and a ball that flies at the second row."""
    lines = [f"simulator -finish {finish!r} -accuracy 1e-2", "shape_set floor -desc {-sub {-plane}}", "shape_set block -desc {-sub {-box {1 1 1}}}",
             "shape_set ball -desc {-sub {-sphere 0.5}}", "body floor floor -fixed 1 -friction 0.3 -restitution 0"]
    places = [(0.5 + row, 1.05 * (k - (2 - row) / 2)) for row in range(3) for k in range(3 - row)]
    lines += [f"body b{n} block -friction 0.3 -restitution 0 -init_pos {{0 {y!r} {z!r}}}" for n, (y, z) in enumerate(places)]
    lines += ["body b6 ball -friction 0.3 -restitution 0 -init_pos {-3 1.2 0.1} -init_dpos {10 0 0}"]
    return "\n".join(lines + [f"force -body b{n} -gravitational {{0 -9.81 0}}" for n in range(7)]) + "\n"


def row_of_dominoes(count, finish):
    """A row on a table, of which the first stands on its edge, tilted beyond its balance."""
    lines = [f"simulator -finish {finish!r}", "shape_set stone -desc {-sub {-box {0.06 0.4 0.2}}}", "shape_set table -desc {-sub {-box {8 0.1 0.8}}}",
             "body table table -fixed 1 -friction 0.6 -init_pos {2 -0.05 0}"]
    s, c = math.sin(0.2), math.cos(0.2)
    for k in range(count):
        place = f"{0.25 * k!r} 0.2" if k else f"{0.03 - 0.03 * c + 0.2 * s!r} {0.03 * s + 0.2 * c!r}"
        lines.append(f"body d{k} stone -mass 0.5 -restitution 0 -friction 0.2 -static_friction 0.6 -init_pos {{{place} 0}}" +
                     ("" if k else " -init_rot {0 0 -0.2}"))
        lines.append(f"force -body d{k} -gravitational {{0 -9.81 0}}")
    return "\n".join(lines) + "\n"


def braked_can():
    """A can that falls flat while it moves, is braked, tips and lands on its side."""
    return ("simulator -finish 1.2\nshape_set floor -desc {-sub {-box {30 1 30}}}\nshape_set can -desc {-sub {-cylinder {0.06 0.3}}}\n"
            "body floor floor -fixed 1 -friction 0.8 -restitution 0 -init_pos {0 -0.5 0}\n"
            "body can can -mass 1 -friction 0.8 -restitution 0 -init_pos {0 0.17 0} -init_dpos {1.8 0 0}\nforce -body can -gravitational {0 -9.81 0}\n")


def can_off(velocity):
    """A can that slides over the edge of a table, tips over it and falls."""
    return (f"simulator -finish 0.8\nshape_set table -desc {{-sub {{-box {{1 0.05 1}}}}}}\nshape_set can -desc {{-sub {{-cylinder {{0.04 0.1}}}}}}\n"
            "body table table -fixed 1 -init_pos {0 -0.025 0} -friction 0.2\n"
            f"body can can -mass 0.3 -init_pos {{0.2 0.05 0}} -init_dpos {{{velocity}}} -friction 0.2 -restitution 0\n"
            "force -body can -gravitational {0 -9.81 0}\n")


def tablecloth():
    """A cloth that is pulled from under a glass, which lands on its edge in part."""
    return ("simulator -finish 1\nshape_set table -desc {-sub {-box {2 0.1 1}}}\nshape_set cloth -desc {-sub {-box {1.4 0.012 0.7}}}\n"
            "shape_set glass -desc {-sub {-cylinder {0.04 0.16}}}\nbody table table -fixed 1 -init_pos {0 -0.05 0} -friction 0.3\n"
            "body cloth cloth -mass 0.2 -init_pos {0 0.006 0} -friction 0.3 -restitution 0\n"
            "body glass glass -mass 0.3 -init_pos {0.3 0.092 0} -friction 0.3 -restitution 0\nforce -body cloth -x {min(40*t,15)}\n"
            "force -body cloth -gravitational {0 -9.81 0}\nforce -body glass -gravitational {0 -9.81 0}\n")


def struck_tower():
    """Four boxes with much friction, a little beside each other, that a ball hits at the third one."""
    lines = ["simulator -finish 0.1 -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", "shape_set box -desc {-sub {-box {0.1 0.1 0.1}}}",
             "shape_set ball -desc {-sub {-sphere 0.04}}", "body floor floor -fixed 1 -friction 0.6 -restitution 0",
             "body ball ball -mass 1 -restitution 0.3 -init_pos {-0.3 0.2633059085543874 0.01} -init_dpos {3.542301210811698 0 0} -friction 0.6",
             "force -body ball -gravitational {0 -9.81 0}"]
    for k, z in enumerate((0, -0.009797238970423132, -0.00018259651632236348, -0.0020203574084504752)):
        lines += [f"body b{k} box -mass 1 -init_pos {{0 {0.05 + 0.1 * k:g} {z}}} -friction 0.6 -restitution 0",
                  f"force -body b{k} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines) + "\n"


def flush_tower(count, finish):
    """Equal boxes whose sides are flush, with little friction, and a ball that hits them beside their middle."""
    lines = [f"simulator -finish {finish!r} -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", "shape_set block -desc {-sub {-box {0.5 0.5 0.5}}}",
             "shape_set ball -desc {-sub {-sphere 0.2}}", "body floor floor -fixed 1 -friction 0.1"]
    for k in range(count):
        lines.append(f"body b{k} block -init_pos {{{0.05 if k % 4 == 3 else 0.0!r} {0.25 + 0.5 * k!r} 0}} -friction 0.1 -restitution 0")
        lines.append(f"force -body b{k} -gravitational {{0 -9.81 0}}")
    lines += [f"body ball ball -init_pos {{-0.5 {0.34 * count!r} 0.1}} -init_dpos {{5 0 0}} -friction 0.1 -restitution 0",
              "force -body ball -gravitational {0 -9.81 0}"]
    return "\n".join(lines) + "\n"


def jammed_tower():
    """Three equal boxes that a ball hits aside: they jam while slow slips turn."""
    body = "-friction 1 -restitution 0.4"
    lines = ["simulator -finish 0.246 -accuracy 1e-3", "shape_set floor -desc {-sub {-box {40 1 40}}}",
             "shape_set box -desc {-sub {-box {0.5 0.25 0.5}}}", "shape_set ball -desc {-sub {-sphere 0.2}}",
             f"body floor floor -init_pos {{0 -0.5 0}} -fixed 1 {body}"]
    places = (("b1 box", "0.05 0.125 0", "0 0 0"), ("b2 box", "0.05 0.375 0", "0 0 0"), ("b3 box", "0 0.625 0", "0 0 0"),
              ("ball ball", "-0.8 0.6226 0.1", "5.635 1 0"))
    for name, place, velocity in places:
        lines += [f"body {name} -init_pos {{{place}}} -init_dpos {{{velocity}}} {body}",
                  f"force -body {name.split()[0]} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines) + "\n"


def hinged_boxes():
    """Two flat boxes on a hinge that slide over a floor and turn."""
    lines = ["simulator -finish 2 -accuracy 1e-6", "shape_set floor -desc {-sub {-plane}}", "shape_set box -desc {-sub {-box {1 0.4 0.6}}}",
             "body floor floor -fixed 1 -friction 0.3"]
    for name, x, velocity, spin in (("a", 0, "3 0 1", 2), ("b", 1.1, "3 0 -0.2", -1)):
        lines.append(f"body {name} box -init_pos {{{x} 0.2 0}} -init_dpos {{{velocity}}} -init_drot {{0 {spin} 0}} -friction 0.3 -restitution 0")
        lines.append(f"force -body {name} -gravitational {{0 -9.81 0}}")
    lines.append("joint h -type hinge -axis {0 1 0} -body1 a -offset1 {0.55 0 0} -body2 b -offset2 {-0.55 0 0}")
    return "\n".join(lines) + "\n"


def rough_post(size, friction, velocity, spin):
    """A tall post on a rough floor, pushed and turned: it slips, turns, and tips."""
    height = float(size.split()[1])
    return "\n".join([
        "simulator -finish 0.2 -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", f"shape_set post -desc {{-sub {{-box {{{size}}}}}}}",
        f"body floor floor -fixed 1 -friction {friction}",
        f"body post post -restitution 0 -friction {friction} -init_pos {{0 {height / 2!r} 0}} -init_dpos {{{velocity}}} "
        f"-init_drot {{0 {spin} 0}}", "force -body post -gravitational {0 -9.81 0}"]) + "\n"


def pin(restitution):
    """A bowling pin as a plain cylinder, hit off its middle: it rattles down to lie on its side."""
    return ("simulator -finish 3\nshape_set lane -desc {-sub {-box {20 0.2 2}}}\nshape_set ball -desc {-sub {-sphere 0.11}}\n"
            "shape_set pin -desc {-sub {-cylinder {0.055 0.38}}}\n"
            f"body lane lane -fixed 1 -init_pos {{8 -0.1 0}} -friction 0.2 -restitution {restitution}\n"
            f"body ball ball -mass 6 -init_pos {{0 0.11 0.03}} -init_dpos {{6 0 0}} -friction 0.2 -restitution {restitution}\n"
            f"body p pin -mass 1.5 -init_pos {{3 0.19 0}} -friction 0.2 -restitution {restitution}\n"
            "force -body ball -gravitational {0 -9.81 0}\nforce -body p -gravitational {0 -9.81 0}\n")


LOG_AND_DISC = """simulator -finish 1.2
shape_set floor -desc {-sub {-plane}}
shape_set disc -desc {-sub {-cylinder {0.2 0.04}}}
body floor floor -fixed 1 -friction 0.2
body low disc -mass 1 -init_pos {0 0.2 0} -init_rot {1.5707963267948966 0 0} -friction 0.2 -restitution 0.3
body top disc -mass 0.7 -init_pos {0.010 0.760 -0.019} -init_rot {-0.469 1.042 -0.440} -init_dpos {0.25 0 0.10} -friction 0.2 -restitution 0.3
force -body top -gravitational {0 -9.81 0}
force -body low -gravitational {0 -9.81 0}
"""

def spinning(beneath):
    """A wheel that spins so fast that its rim is thrown outward more than it falls."""
    return ("simulator -finish 1\nshape_set wheel -desc {-sub {-rot {1.5707963267948966 0 0} -cylinder {0.1 0.04}}}\n" + beneath +
            "body wheel wheel -init_pos {0 0.35 0} -init_drot {0 0 -30} -mass 1 -friction 0.1 -restitution 0.5\n"
            "force -body wheel -gravitational {0 -9.81 0}\n")


def dropped(low, top, friction, restitution):
    """A tilted body that is dropped on another, with what both have in a text."""
    lines = ["simulator -finish 1.2", "shape_set floor -desc {-sub {-plane}}", "shape_set can -desc {-sub {-cylinder {0.1 0.3}}}",
             "shape_set disc -desc {-sub {-cylinder {0.2 0.04}}}", "shape_set plank -desc {-sub {-box {0.6 0.04 0.1}}}",
             "shape_set box -desc {-sub {-box {0.2 0.1 0.3}}}", f"body floor floor -fixed 1 -friction {friction}"]
    for name, text in (("low", low), ("top", top)):
        lines += [f"body {name} {text} -friction {friction} -restitution {restitution}", f"force -body {name} -gravitational {{0 -9.81 0}}"]
    return "\n".join(line for line in lines if "low -grav" not in line or "-fixed" not in low) + "\n"


def bowling():
    """A ball slides into ten pins."""
    lines = ["simulator -finish 4", "shape_set lane -desc {-sub {-box {24 0.2 3}}}", "shape_set ball -desc {-sub {-sphere 0.108}}",
             "shape_set pin -desc {-sub {-cylinder {0.05 0.38}}}", "body lane lane -fixed 1 -init_pos {8 -0.1 0} -friction 0.1",
             "body ball ball -mass 7 -init_pos {0 0.108 0.03} -init_dpos {8 0 0} -friction 0.1 -restitution 0.2"]
    places = [(10 + 0.264 * row, 0.305 * (k - row / 2)) for row in range(4) for k in range(row + 1)]
    lines += [f"body pin{n} pin -mass 1.5 -init_pos {{{x} 0.19 {z}}} -friction 0.4 -restitution 0.2" for n, (x, z) in enumerate(places)]
    return "\n".join(lines + [f"force -body {body} -gravitational {{0 -9.81 0}}" for body in ["ball"] + [f"pin{n}" for n in range(10)]]) + "\n"


def cans():
    """A ball rolls into six cans that stand in a triangle."""
    lines = ["simulator -finish 1.2 -accuracy 1e-2", "shape_set floor -desc {-sub {-plane}}", "shape_set can -desc {-sub {-cylinder {0.4 1}}}",
             "shape_set ball -desc {-sub {-sphere 0.5}}", "body floor floor -fixed 1 -friction 0.3",
             "body ball ball -friction 0.3 -init_pos {-3 0.5 -0.0333} -init_dpos {4 0 0}"]
    places = [(row, 1.1 * (k - row / 2)) for row in range(3) for k in range(row + 1)]
    lines += [f"body c{n} can -friction 0.3 -init_pos {{{x} 0.5 {z}}}" for n, (x, z) in enumerate(places)]
    lines += [f"force -body {body} -gravitational {{0 -9.81 0}}" for body in ["ball"] + [f"c{n}" for n in range(6)]]
    return "\n".join(lines).replace("-friction 0.3", "-friction 0.3 -restitution 0") + "\n"


def belt(second=-0.8):
    """Boxes drop on a belt, ride, and fall off its end onto each other."""
    lines = ["simulator -finish 5", "shape_set belt -desc {-sub {-box {3 0.1 0.6}}}", "shape_set floor -desc {-sub {-plane}}",
             "shape_set box -desc {-sub {-box {0.2 0.2 0.2}}}",
             "body belt belt -fixed 1 -init_pos {0 0.95 0} -friction 0.5 -surface_velocity {1 0 0}", "body floor floor -fixed 1 -friction 0.5"]
    for name, x in (("a", -1.3), ("b", second), ("c", -0.3)):
        lines += [f"body {name} box -mass 2 -init_pos {{{x} 1.3 0}} -friction 0.5 -restitution 0.1", f"force -body {name} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines) + "\n"


def tilted_cubes():
    """Two cubes fall on each other, tilted, and come to lie."""
    lines = ["simulator -finish 1.5 -accuracy 1e-3", "shape_set floor -desc {-sub {-plane}}", "shape_set block -desc {-sub {-box {1 1 1}}}",
             "body floor floor -fixed 1 -friction 0.3 -restitution 0"]
    for name, start in (("b0", "-init_pos {0 1 0} -init_rot {0.2 0.1 0.3}"), ("b1", "-init_pos {0.1 2.6 0.05} -init_rot {0.3 0.1 0.2}")):
        lines += [f"body {name} block -friction 0.3 -restitution 0 {start}", f"force -body {name} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines) + "\n"


def creeping():
    """A box at rest that a force turns about, of 0.3 % more than friction can hold."""
    return ("simulator -finish 6\nshape_set p -desc {-sub {-plane}}\nshape_set b -desc {-sub {-box {0.2 0.1 0.2}}}\n"
            "body f p -fixed 1 -friction 0.3\nbody b b -init_pos {0 0.05 0} -friction 0.3 -restitution 0 -mass 1.2\n"
            "force -body b -gravitational {0 -9.81 0}\n"
            "force -body b -x {3.5416*cos(0.5*t)-50.0*b.dx} -z {3.5416*sin(0.5*t)-50.0*b.dz}\n")


def car(accuracy=1e-4):
    """Four wheels on springs drive down a kerb."""
    quarter = math.acos(-1) / 2
    lines = [f"simulator -finish 1.2 -accuracy {accuracy}", "shape_set road -desc {-sub {-box {10 0.5 6}}}", "shape_set kerb -desc {-sub {-box {3 0.05 6}}}",
             f"shape_set wheel -desc {{-sub {{-rot {{{quarter!r} 0 0}} -cylinder {{0.2 0.1}}}}}}", "shape_set hub -desc {-sub {-sphere 0.05}}",
             "shape_set chassis -desc {-sub {-box {2 0.3 1}}}", "body road road -fixed 1 -init_pos {4 -0.25 0} -friction 0.9",
             "body kerb kerb -fixed 1 -init_pos {0.5 0.025 0} -friction 0.9", "body chassis chassis -mass 100 -init_pos {0.5 0.5 0} -init_dpos {3 0 0} -ct 1"]
    for name, x, z in (("fl", 1.2, -0.6), ("fr", 1.2, 0.6), ("rl", -0.2, -0.6), ("rr", -0.2, 0.6)):
        lines += [f"body hub{name} hub -mass 2 -init_pos {{{x} 0.25 {z}}} -init_dpos {{3 0 0}} -ct 1",
                  f"body wheel{name} wheel -mass 5 -init_pos {{{x} 0.25 {z}}} -init_dpos {{3 0 0}} -init_drot {{0 0 -15}} -friction 0.9 -restitution 0 -ct 1",
                  f"joint s{name} -type slider -body1 hub{name} -body2 chassis -axis {{0 1 0}} -stiffness 5000 -damping 400 -rest 0.05",
                  f"joint a{name} -type hinge -body1 wheel{name} -body2 hub{name}",
                  f"force -body hub{name} -gravitational {{0 -9.81 0}}", f"force -body wheel{name} -gravitational {{0 -9.81 0}}"]
    return "\n".join(lines + ["force -body chassis -gravitational {0 -9.81 0}"]) + "\n"


def can_hit_from_under_another():
    """The rims of both are nearly in one another, and cross all around as the lower one slides."""
    return ("simulator -finish 0.35 -accuracy 1e-2\nshape_set floor -desc {-sub {-plane}}\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
            "shape_set can -desc {-sub {-cylinder {0.4 1}}}\nbody floor floor -fixed 1 -friction 0.3 -restitution 0\n"
            "body c0 can -friction 0.3 -restitution 0 -init_pos {-0.02 0.5 0}\nbody c1 can -friction 0.3 -restitution 0 -init_pos {-0.02 1.5 -0.02}\n"
            "body ball ball -friction 0.3 -restitution 0 -init_pos {-4 0.8 0} -init_dpos {10 0 0}\n"
            + "".join(f"force -body {name} -gravitational {{0 -9.81 0}}\n" for name in ("c0", "c1", "ball")))


CASES = [
    # Friction at the centres of pressure had no answer that was found: these stopped at the ball's blow.
    ("a ball hits a wall with friction", wall(33, 0.2363, 0.00104), {"steps": 900}),
    ("a ball hits a wall with friction, again", wall(33, 0.2363, 0.00105), {"steps": 900}),
    # Redundant conditions with a tilt made forces negative that the laws had found, at one instant again and again.
    ("bricks without friction that bounce", wall(10, 0.571, 0.001), {"steps": 900}),
    # What was left of a rate by rounding was no contact, and no hop: bricks "came to rest on each other" 200 times.
    ("bricks without friction that lean", wall(29, 0.2827, 0.00102), {"steps": 2600}),
    # A rim that slides bends its gap, which pulls it down where its points go up: it hopped without end.
    ("a pin that rattles down", pin(0.4), {"evaluations": 30000, "collisions": 150}),
    ("a disc on a disc that lies", LOG_AND_DISC, {"collisions": 150}),
    # With a factorization for each look for the centres of pressure, and derivatives by differences: 10076 evaluations.
    ("two hinged boxes that slide and turn", hinged_boxes(), {"steps": 250, "rejected_steps": 120, "evaluations": 5000}),
    # Newton's method for the forces of a slip began without friction, which lifts a post that tips: none were found.
    ("a rough post that tips", rough_post("1.0132 2.2397 0.84745", 1.04, "0.88936 0 -0.0518", 1.97), {"evaluations": 9000}),
    ("a rough high post that tips", rough_post("1.212 3.2375 0.8319", 0.81253, "0.011106 0 0.024323", 2.3128), {"evaluations": 20000}),
    # The laws of friction went from centre to centre without end where they began at those without friction.
    ("a rough post that starts to tip", rough_post("0.34993 2.2939 0.58759", 1.1125, "-0.1643 0 0.2377", 4.8387), {"evaluations": 20000}),
    # Corners of equal faces were found anew again and again: 1121 steps.
    ("six flush boxes that a ball hits", flush_tower(6, 0.13), {"steps": 900, "collisions": 600}),
    # Steps that found at each of their stages that nothing moves: 9 and 766 evaluations for the balls.
    ("ten boxes at rest", stack(10, 0), {"steps": 0, "rejected_steps": 0, "evaluations": 150, "collisions": 0}),
    ("three balls that stand", three_balls(), {"steps": 0, "rejected_steps": 0, "evaluations": 80, "collisions": 0}),
    ("ten boxes that fall on each other", stack(10, 0.05), {"steps": 60, "rejected_steps": 10, "evaluations": 1000}),
    # Slips of next to nothing turned to and fro: 2100 steps, 2357 rejected, 75162 evaluations. With friction at each
    # corner in a blow: 993, 1335, 37566.
    ("a tray, slips that turn", pile(1, 0.38), {"steps": 500, "rejected_steps": 500, "evaluations": 15000}),
    # An edge of a tilted box landed anew at the instant at which it had landed: 20002 events.
    ("a tray, edges on each other", pile(4, 0.55), {"steps": 6000, "collisions": 300}),
    # Corners of boxes without friction landed again from less than a ten-thousandth of the accuracy: 14386 steps. At accuracies
    # that differ by hundredths 530 to 2600, and 3000 to 9700 collisions.
    ("a wall without friction", pile(6, 0.55), {"steps": 5000, "collisions": 15000}),
    # The search for the centres of the faces of a blow went round without end: "the impulses were not found".
    ("a wall with friction that a ball hits", pile(33, 0.2357, 0.1), {"steps": 600, "collisions": 1000}),
    # A slow slip that swung within steps ended a contact each microsecond: over 20000 steps.
    ("dropped boxes, a slow slip", pile(14, 0.65), {"steps": 6000, "collisions": 400}),
    # Where edges of two boxes are next to parallel, their crossing ended a contact at one instant without end.
    ("a stack that a ball hits", struck(2, 2), {"steps": 6000, "collisions": 300}),
    # A corner beside a face and beneath its plane was looked at anew for each 1e-9 that it sank. Of other tilts that differ
    # by hundredths some take five times as many steps: slips that die away turn to and fro.
    ("two tilted cubes", two_cubes(1.0), {"evaluations": 32000, "collisions": 140}),
    # An edge whose end was beneath a face, beside it, came down on the border of the face unseen: it stopped at 0.584 s.
    ("two tilted cubes that come to lie", tilted_cubes(), {"steps": 2000, "collisions": 500}),
    # With friction a vertex beside a face ended a contact each 4e-10 s, a ball on the edge of a box that tips met it at one
    # instant without end, and a tilt of 1e-7 of two faces made forces of 1e5 N, with a new step for each.
    ("two boxes with friction that a ball hits", hit_with_friction(2, 1.5, 10), {"steps": 3000, "collisions": 200}),
    ("three boxes with friction that a ball hits", hit_with_friction(3, 2.0, 20), {"steps": 850, "collisions": 100}),
    # The contact of the ball, rounded, moved the stones out of their plane: slips flipped without end, and stopped at 0.709 s.
    ("three dominoes that a ball hits", dominoes(3, 1), {"steps": 1300, "collisions": 250}),
    # Of two faces next to parallel the one had the other's normal: its far corner let go each 3e-8 s without end.
    ("two dominoes that a ball hits askew", dominoes_askew(2, 0.82), {"steps": 1500, "evaluations": 25000, "collisions": 400}),
    # Blows whose many impulses were not found stopped it at 0.2 s, or took five seconds each.
    ("a pyramid that a ball hits", pyramid(0.21), {"steps": 450, "evaluations": 9000, "collisions": 120}),
    # What lay on a stone sank by its resolution without having been open, and hit it for that, each 5 us without end.
    ("three dominoes that a fast ball hits", dominoes(3, 2), {"steps": 900, "collisions": 250}),
    ("three dominoes that a slow ball hits", dominoes(3, 0.5), {"steps": 1000, "collisions": 100}),
    # Its upper rim was no piece that may land: it went through the floor.
    ("a can that falls flat and tips", braked_can(), {"steps": 100, "collisions": 10}),
    # Every fourth corner of its rim carried, and none where the rim crosses the edge of the table: no end at 0.18 s.
    ("a can that slides off a table", can_off("1.8 0 0"), {"steps": 900, "collisions": 20}),
    ("a can that slides off a table askew", can_off("1.8 0 0.3"), {"steps": 1300, "collisions": 60}),
    # Slips that die away turn to and fro: at accuracies that differ by hundredths 1600 to 15800.
    ("a tablecloth", tablecloth(), {"steps": 20000, "collisions": 60}),
    # Each slides a hundredth as fast as the next: the slowest counted as at rest with the first that stopped, which stopped all at
    # 1.2497 s; more of them ended likewise. Of seven the steps were 1746.
    ("five dominoes in a row", row_of_dominoes(5, 1.6), {"steps": 900, "collisions": 250}),
    ("seven dominoes in a row", row_of_dominoes(7, 1.6), {"steps": 1200, "collisions": 350}),
    # The end of its hops was told by its rim's material points: 3999 hits, and in a groove no end.
    ("a spinning wheel on a table", spinning("shape_set table -desc {-sub {-box {2 0.2 1}}}\nbody table table -fixed 1 -friction 0.3\n"),
     {"collisions": 30}),
    ("a spinning wheel in a groove", spinning("shape_set block -desc {-sub {-box {0.2 0.2 0.4}}}\n"
     "body b1 block -init_pos {-0.17 0.1 0} -fixed 1 -friction 0.1\nbody b2 block -init_pos {0.17 0.1 0} -fixed 1 -friction 0.1\n"), {"collisions": 60}),
    # A disc that leans on an edge and the floor slips by micrometres a second, in directions that turn to and fro: over 60000 steps.
    ("a disc that leans on a box", dropped("box -fixed 1 -init_pos {0 0.05 0} -init_rot {0 0.657 0}", "disc -mass 0.7 -init_pos "
     "{0.030 0.460 -0.041} -init_rot {0.608 -0.011 -1.157} -init_dpos {-0.11 0 -0.09}", 0.4, 0.3), {"steps": 1200}),
    # Friction turns about where the stages of a step go beyond so slow a slip: its stiffness was not seen.
    ("a plank on a can", dropped("can -mass 1 -init_pos {0 0.1 0} -init_rot {1.5707963267948966 0 0}", "plank -mass 0.7 -init_pos "
     "{0.057 0.560 -0.034} -init_rot {0.300 0.914 0.406} -init_dpos {0.03 0 -0.19}", 0.2, 0.3), {"steps": 5000}),
    # Slips that began with a thousandth of the acceleration of their friction turned back at once by the errors of stages, and
    # one that stopped turned the others: no end at 0.721 s. Most steps are there still, where one foot just holds.
    ("a disc that slides off a can", dropped("can -fixed 1 -init_pos {0 0.1 0} -init_rot {1.5707963267948966 0 0}", "disc -mass 0.7 -init_pos "
     "{0.095 0.560 -0.053} -init_rot {-0.649 0.141 -0.331} -init_dpos {-0.03 0 -0.15}", 0.4, 0), {"steps": 1200}),
    # At rest nothing is fast: each slip was as slow as the rounding, and turned back within 1e-11 s.
    ("a box that creeps about", creeping(), {"steps": 160}),
    # A slip kept a part of the way in which it began, and the first implicit step the stiffness of its start: no end at 0.809 s.
    # At one of fifty accuracies its wheels tremble, and slip when the rear ones come off the kerb: 1400 to 3900 steps.
    ("a car that drives down a kerb", car(1.02e-4), {"steps": 320}),
    # Wheels that hardly approach closed 1e-11 s after each other by rounding, and slipped in turns: no end at 0.82 s.
    ("a car that drives down a kerb, coarsely", car(1e-3), {"steps": 270}),
    # Two corners of faces next to parallel counted as bodies that pass each other: no end at 4.044 s.
    ("boxes off a belt", belt(), {"steps": 5000, "collisions": 1700}),
    # Where they hit each other a step lasted for four doubles, in which rounding alone made them approach: they met there
    # without end.
    ("boxes off a belt, one a little later", belt(-0.802), {"steps": 5000, "collisions": 1700}),
    # A blow that ran to and fro until 1e-8 m/s were left was no rest, and pressed the pins together without end at 2.309 s.
    ("ten pins", bowling(), {"steps": 14000, "collisions": 800}),
    # On sixteen points of its rim each a can had forces that took seconds to find, and blows with answers of chance: 160.
    ("six cans that a ball hits", cans(), {"steps": 500, "evaluations": 12000, "collisions": 110}),
    # Crossings of rims began anew each 0.02 rad: 10352 evaluations, 1102 pairs looked at.
    ("a can that is hit from under another one", can_hit_from_under_another(), {"evaluations": 5500, "pair_tests": 500}),
    # Redundant forces that just held: each step found that they did not.
    ("a disc that leans on a loose box", dropped("box -mass 1 -init_pos {0 0.05 0} -init_rot {0 0.432 0}", "disc -mass 0.7 -init_pos "
     "{0.095 0.460 -0.055} -init_rot {-0.308 -1.394 1.380} -init_dpos {-0.03 0 0.00}", 0.6, 0), {"steps": 5500}),
    # Friction that shifts the centre at which it acts had several answers, which steps took in turns, and came to an end of one:
    # "no forces keep the conditions" at 0.0593 s.
    ("a tower that a ball hits", struck_tower(), {"steps": 1000, "collisions": 100}),
    # Forces that its jam left followed slips that they turned, and were none: "there is no solution" at 0.2439 s.
    ("a tower that jams", jammed_tower(), {"steps": 15000, "collisions": 6000}),
    # Rounding beside the plane woke 180 unknowns.
    ("a chain in a plane whose links hit each other", chain(20, 2), {"largest_component": 220, "steps": 2500}),
    # After the blow the joints moved two links into each other, and the motion stopped.
    ("three links that hit each other, roughly", chain(3, 3, "1e-2"), {"evaluations": 60000, "collisions": 2}),
    ("three links that hit each other", chain(3, 3, "3e-3"), {"evaluations": 60000, "collisions": 2}),
    # Velocities of 1e-34 hit each other without end.
    ("a wall that stands", pile(5, 0.1), {"steps": 200, "collisions": 20}),
]


def main():
    asgard, faults = sys.argv[1], 0
    with tempfile.TemporaryDirectory() as folder:
        path, stats = os.path.join(folder, "scene.al"), os.path.join(folder, "stats.json")
        for name, text, most in CASES:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            run = subprocess.run([asgard, "simulate", path, "--csv", os.devnull, "--stats", stats], capture_output=True,
                                 text=True, check=False)
            if run.returncode != 0:
                print(f"{name}: {run.stderr.strip().splitlines()[-1] if run.stderr.strip() else run.returncode}")
                faults += 1
                continue
            with open(stats, encoding="utf-8") as file:
                counts = json.load(file)
            took = {count: counts[count] for count in most}
            is_more = any(took[count] > most[count] for count in most)
            faults += is_more
            print(f"{name}: {took}" + (f", more than {most}" if is_more else ""))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
