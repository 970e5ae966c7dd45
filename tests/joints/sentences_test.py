#!/usr/bin/env python3
"""Scenes with joints and ropes that cannot be as they are written: the sentence that says so, and those that are right.

usage: sentences_test.py ASGARD
"""
import os
import subprocess
import sys
import tempfile

SHAPES = "shape_set rod -desc {-sub {-box {1 0.1 0.1}}}\nsimulator -finish 2\nbody a rod -mass 1 -init_pos {0.5 0 0}\n"
DRUM = ("body h rod -fixed 1 -init_pos {0 3 0}\nbody b rod -mass 1 -init_pos %s\nrope r -points {{h {0 0 0} 0.2} {b}}\n"
        "force -body b -gravitational {0 -9.81 0}")
PIN = "joint pin -type hinge -body1 a -offset1 {-0.5 0 0} "
HELD = "body h rod -mass 1 -init_pos {0 3 0}\n"
# Two boxes on a floor, below a press.
PRESS = ("shape_set ground -desc {-sub {-box {4 0.2 4}}}\nbody floor ground -fixed 1 -friction 0.5 -init_pos {10 -0.1 0}\nshape_set b -desc {-sub {-box {0.4 0.4 0.4}}}\n"
         "foreach {n h} {low 0.2 high 0.6} {body $n b -restitution 0 -friction 0.5 -init_pos [list 10 $h 0]; force -body $n -gravitational {0 -9.81 0}}\n"
         "body press b -restitution 0 -friction 0.5 -init_pos {10 %s 0}\n")
HOLD = "trajectory way -points {{0 10 %s 0} {2 10 0.9 0}}\ntrajectory turn -bezier {{0 2 {0 0 0}}}\nconstrain press -pos way\nconstrain press -rot turn"
SIDE = "body side b -restitution 0 -friction 0.5 -init_pos {10.4 0.2 0}\nforce -body side -gravitational {0 -9.81 0}\n"
STILL = "trajectory still -points {{%s 10.4 0.2 0} {%s 10.4 0.2 0}}\nconstrain side -pos still\n"
RAM = "joint ram -type slider -body1 press -axis {0 1 0} "
CRUSH = 'bodies "low" and "high" are pressed between "floor" and "press", neither of which gives way: they would be crushed'
FLOOR = "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1 -init_pos {0 %s 0}%s\n"
DOWN = "joint ram -type slider -body1 a -axis {0 1 0} "
AGAINST = 'body "a" is pressed against "floor", which does not give way'
DRIVES = AGAINST + ': joint "%s" drives on with whatever force it takes: let it stop before, or give it -max_motor.'
# A box a hair above a platform that a driven carriage takes along.
LIFT = ("shape_set lift -desc {-sub {-box {4 1 4}}}\nshape_set small -desc {-sub {-box {1 1 1}}}\nbody carriage small -mass 1 -init_pos {20 -0.5 0}\n"
        "joint rail -type slider -body1 carriage -axis {0 1 0} -speed 0.5\nbody lift lift -mass 1 -init_pos {10 -0.5 0}\n"
        "joint weld -type slider -body1 lift -body2 carriage -axis {1 0 0}\nbody box small -mass 1 -init_pos {10 0.50001 0}%s\n"
        "force -body box -gravitational {0 -9.81 0}")
# What is added, and what asgard says; "": nothing, and the motion reaches its end.
CASES = (
    (PIN + "-speed {t>1 ? 1 : 0}\njoint pin2 -type hinge -body1 a -offset1 {-0.5 0 0} -speed 0",
     "Stopped at t = 1: no forces keep the conditions of pin, pin2, which contradict each other."),
    (PIN + "-speed {sin(t)}\njoint pin2 -type hinge -body1 a -offset1 {-0.5 0 0} -speed {sin(t)}", ""),
    ("trajectory r -points {{0 0.5 0 0} {2 1 0 0}}\nconstrain a -pos r\njoint pin -type ball -body1 a",
     "no forces keep the conditions of pin, which contradict how its bodies are held"),
    ("trajectory r -points {{0 0.5 0 0} {2 0.5 0 0}}\nconstrain a -pos r\njoint pin -type ball -body1 a", ""),
    (PIN + "-position {t>1 ? 1 : 0}", "Stopped at t = 1: what begins here wants the bodies of pin elsewhere at once"),
    (HELD + "trajectory w -points {{1 0 1 0} {2 1 1 0}}\nconstrain h -pos w\n" + PIN + "-body2 h",
     "Stopped at t = 1: what begins here wants the bodies of pin elsewhere at once"),
    (PIN + "-position {0.1*t}\nbody b rod -init_pos {0 5 0}", ""),
    ("body v rod -mass 10 -inertia {1 1 1} -ct 1 -init_pos {10 0 0}\nbody w rod -mass 10 -inertia {1 1 1} -ct 1 -init_pos {11 0 0}\n"
     "body k rod -mass 2 -ct 1 -init_pos {10.8 0 0.1}\njoint h1 -type hinge -body1 v -motor 2\njoint h2 -type hinge -body1 w\n"
     "joint c1 -type hinge -body1 k -offset1 {-0.5 0 0} -body2 v\njoint c2 -type hinge -body1 k -offset1 {0.5 0 0} -body2 w\n"
     "force -body k -gravitational {0 -9.81 0}", "the joints stand in a singular position, as a flat linkage does"),
    ("body v rod -mass 10 -inertia {1 1 1} -ct 1 -init_pos {10 0 0}\nbody w rod -mass 10 -inertia {1 1 1} -ct 1 -init_pos {11 0 0}\n"
     "body k rod -mass 2 -ct 1 -init_pos {10.8 0 0.1}\njoint h1 -type hinge -body1 v -motor 2\njoint h2 -type hinge -body1 w\n"
     "joint c1 -type hinge -body1 k -offset1 {-0.5 0 0} -body2 v\njoint c2 -type hinge -body1 k -offset1 {0.5 0 0} -body2 w\n"
     "force -body k -gravitational {0 -9.81 0}\nbody u rod -init_pos {30 0 0}\njoint far -type hinge -body1 u -speed 1",
     "the joints stand in a singular position, as a flat linkage does"),
    (PRESS % "1.2" + HOLD % "1.2", CRUSH + "."),
    (PRESS % "1" + HOLD % "1", CRUSH + "."),
    (PRESS % "1.2" + RAM + "-speed -0.2", CRUSH + '; joint "ram" drives on with whatever force it takes: let it stop before, or give it -max_motor.'),
    (PRESS % "1.2" + RAM + "-position {-0.2*t}", CRUSH + '; joint "ram" drives on'),
    (PRESS % "1.2" + RAM + "-speed -0.2 -max_motor 50", ""),
    (FLOOR % (-0.3, "") + DOWN + "-speed -0.5", "Stopped at t = 0.5: " + DRIVES % "ram"),
    (FLOOR % (-0.3, " -restitution 0") + DOWN + "-position {-0.5*t}", "Stopped at t = 0.5: " + DRIVES % "ram"),
    (FLOOR % (-0.05, "") + DOWN + "-speed -0.5", "Stopped at t = 0: " + DRIVES % "ram"),
    (FLOOR % (-0.05, " -restitution 0") + DOWN + "-position {-0.5*t}", "Stopped at t = 0: " + DRIVES % "ram"),
    (FLOOR % (-0.3, " -restitution 0") + DOWN + "-speed -0.5 -max_motor 50", ""),
    (FLOOR % (-0.05, " -restitution 0") + DOWN + "-speed {t < 1 ? 0 : 1-t}", "Stopped at t = 1: " + DRIVES % "ram"),
    (PRESS % "1" + RAM + "-speed {t < 1 ? 0 : 1-t}", "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on with whatever force it takes'),
    (PRESS % "1" + RAM + "-position {t < 1 ? 0 : -0.2*(t-1)^2}", "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + RAM + "-speed {t < 1 ? 0 : 1-t}", "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + STILL % (0, 0.5) + RAM + "-speed {t < 1 ? 0 : 1-t}", "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + STILL % (1.5, 2) + RAM + "-speed {t < 1 ? 0 : 1-t}", "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + "trajectory turn -bezier {{0 2 {0 0 0}}}\nconstrain side -rot turn\n" + RAM + "-speed {t < 1 ? 0 : 1-t}",
     "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + "joint old -type slider -body1 side -axis {0 0 1} -speed 0 -release {t > 0.5}\n" + RAM + "-speed {t < 1 ? 0 : 1-t}",
     "Stopped at t = 1: " + CRUSH + '; joint "ram" drives on'),
    (PRESS % "1" + SIDE + RAM + "-speed {t < 1 ? 0 : t-1}", ""),
    (PRESS.replace("{10 %s 0}", "{10 1.2 0} -init_rot {0 0 0.1}") + RAM + "-speed -0.2", CRUSH + '; joint "ram" drives on'),
    (PRESS.replace("{10 %s 0}", "{10 1.2 0} -init_rot {0.03 0 0.05}") + RAM + "-speed -0.2", CRUSH + '; joint "ram" drives on'),
    ("body b rod -mass 1 -init_pos {0.5 -1 0}\nshape_set k -desc {-sub {-box {0.4 0.4 0.4}}}\nbody c k -init_pos {0.5 -0.5 0}\n" + DOWN + "-speed -0.5\n"
     "joint lift -type slider -body1 b -axis {0 1 0} -speed 0.5", 'body "c" is pressed between "a" and "b", neither of which gives way: it would be crushed; '
     'joints "lift" and "ram" drive on with whatever force they take: let them stop before, or give them -max_motor.'),
    (FLOOR % (-0.3, " -restitution 0") + PIN + "-speed -0.5", DRIVES % "pin"),
    (FLOOR % (-0.3, " -restitution 0") + "trajectory r -points {{0 0.5 0 0} {2 0.5 -1 0}}\nconstrain a -pos r", AGAINST + "."),
    ("body b rod -init_pos {2 0 0}\njoint left -type slider -body1 a -axis {1 0 0} -speed 0.5\njoint right -type slider -body1 b -axis {1 0 0} -speed -0.5",
     'bodies "a" and "b" are pressed together, neither of which gives way: joints "left" and "right" drive on'),
    (PIN + "-offset2 {0 2 0} -release 1", ""),
    (PIN + "-offset2 {0 2 0} -release {t > 1}", "its bodies miss each other by 2 at the start"),
    (PIN + "-motor {log(1-t)}", 'the joint "pin" on body "a", -motor "log(1-t)", is not finite'),
    ("joint u -type universal -body1 a -axis {1 0 0} -axis2 {1 0 0}",
     ':4:1: error: joint "u": -axis and -axis2 are parallel, and a universal joint wants two directions'),
    ("joint u -type universal -body1 a -axis {1 0 0} -axis2 {1 1 0}",
     ':4:1: error: joint "u": -axis and -axis2 must be perpendicular; change one of them'),
    ("hindge u -body1 a", "a hinge: joint NAME -type hinge -body1 B"),
    ("body c rod -mass 1 -ct 1 -init_pos {0.4 3 0}\nbody p rod -mass 1 -ct 1 -init_pos {1.1 3 0}\n"
     "joint main -type hinge -body1 c -offset1 {-0.4 0 0} -speed 2\n"
     "joint big -type distance -body1 c -offset1 {0.4 0 0} -body2 p -offset2 {0 0 0}\njoint guide -type slider -body1 p -axis {1 0 0}",
     'no forces keep the conditions of main, big, guide: the joints lock there, and joint "main" drives on, as a crank that is longer than its rod does'),
    ("joint p -type planar -body1 a -axis {0 0 1} -axis2 {0 0 -2}",
     ':4:1: error: joint "p": -axis and -axis2 are parallel, and a planar joint wants two directions'),
    ("rope r -points {{a} {0 1 0}} -length 1",
     ':4:1: error: rope "r": its -length is 0.118 under what it measures at the start'),
    ("body w rod -fixed 1 -init_pos {0 3 0}\nbody b rod -mass 1 -inertia {1 1 1} -init_pos {0.1 2 0} -init_dpos {6 0 0}\n"
     "body v rod -fixed 1 -init_pos {-2 3 0}\nforce -body b -gravitational {0 -9.81 0}\n"
     "rope r -points {{-2.1 2 0} {v {0 0 0} 0.1} {w {0 0 0} 0.1} {b}}",
     'warning: rope "r": it would lift off the wheel of body "w" at t = '),
    (DRUM % "{-0.2 2 0}", ""),
    (DRUM % "{0.2 2 0}", ':6:1: warning: rope "r": leads askew from the one side of the wheel at point 1, and straight from the other'),
    (DRUM % "{-0.2 2 0} -init_dpos {0 0 2}",
     ':6:1: warning: rope "r": it leads more than 5.7 degrees out of the plane of the wheel of body "h" at t = '),
    (DRUM % "{-0.2 2 0} -init_dpos {0 0 6.5}", 'rope "r" at the wheel of body "h" leads '),
    (DRUM % "{-0.2 2 0} -init_dpos {0 0 6.5}", " degrees out of its plane and over its side, which is not modelled; let the motion finish"),
    (PIN + "-position {t*t} -limits {-1 0.49}",
     "Stopped at t = 0.7: no forces of pin keep all that is to hold here: there is no solution; pin has -limits {-1 0.49}; -position of pin "
     "goes on against its -limits with whatever force it takes: let it stay within them, or give it -max_motor."),
    (PIN + "-position {t*t} -limits {-1 0.49} -max_motor 20", ""),
    (PIN + "-speed 1 -limits {-1 0.5}",
     "Stopped at t = 0.5: no forces of pin were found that last: what they hold opens, closes or slips without end, and no time goes on; "
     "pin has -limits {-1 0.5}; -speed of pin goes on against its -limits with whatever force it takes: let it stay within them, or give it "
     "-max_motor."),
    (PIN + "-limits {-1 1} -release {a.x}", ':4:76: error: -release of joint "pin": it wants a comparison, as {t > 2}'),
    ("joint pin -type ball -body1 a -offset1 {-0.5 0 0} -offset2 {0 1 0}",
     ':4:1: error: joint "pin": its bodies miss each other by 1 at the start'),
    (LIFT % "", ""),
    (LIFT % " -init_dpos {0 0.5 0}", 'Bodies "lift" and "box" are 1e-05 apart at the start, and bounce without loss: they hop for ever'),
    ("joint pin -type ball -body1 a -offset1 {0 0 0}\nbody b rod -init_pos {0 5 0} -init_dpos {1 0 0}\n"
     "joint nail -type ball -body1 b", ':6:1: warning: joint "nail": the velocities at the start differ by 1 from'),
)


def main():
    asgard, failed = sys.argv[1], 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "scene.al")
        for added, sentence in CASES:
            with open(path, "w", encoding="utf-8") as file:
                file.write(SHAPES + added + "\n")
            run = subprocess.run([asgard, "simulate", path, "--csv", os.path.join(folder, "out.csv")], capture_output=True, text=True, timeout=60)
            is_right = sentence in run.stderr if sentence else run.returncode == 0 and "error" not in run.stderr and "warning" not in run.stderr
            if not is_right:
                failed += 1
                print(f"FAIL {added}\n  says {run.stderr.strip()}\n  not  {sentence}")
    print(f"{len(CASES)} scenes, {failed} wrong")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
