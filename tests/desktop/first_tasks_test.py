#!/usr/bin/env python3
"""First tasks of a newcomer, from an empty scene, with no more than 40 actions each: a car rolls down a slope; planets
go round a sun; a ball rolls off a table; a ball falls and bounces; a pendulum has a graph; a stack falls; a ball is
thrown while the motion plays.
What an action is: person.py.

usage: first_tasks_test.py PATH-TO-ASGARD [unittest arguments]       ASGARD_SCREENSHOTS=FOLDER keeps what was seen
"""
import math
import os
import re
import sys
import tempfile
import unittest

from person import Author, Newcomer
from screen import until

ASGARD = os.path.abspath(sys.argv[1])
MOST = 40  # actions


class FirstTasks(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.author = Author(self, ASGARD, self.folder.name)
        self.newcomer = Newcomer(self.author)

    # --- the tasks
    def test_a_car_rolls_down_a_slope(self):
        self.newcomer.create("Body", "New Box")
        self.newcomer.click(0, 0, 0)
        self.author.says(r"^body body1 block1")
        self.newcomer.enter("size1", "10", "0.5", "3")
        self.author.says(r"-box \{10 0.5 3\}")
        self.newcomer.enter("-init_rotturn1", "-15")  # about the axis that looks at the viewer
        self.author.says(r"^body body1 .*-init_rot \{0 0 -0.2617")
        self.newcomer.choose("-fixed", "y")
        self.author.says(r"^body body1 .*-fixed 1")
        slope = math.radians(-15)

        def above(along, height):
            return (along * math.cos(slope) - height * math.sin(slope),
                    0.25 + along * math.sin(slope) + height * math.cos(slope))

        self.newcomer.frame((*above(-5, 0), 0), (*above(5, 0), 0))
        self.author.look("slope")
        self.newcomer.create("Body", "New Box")
        self.newcomer.click(*above(-3, 0.25), 0)
        self.author.says(r"^body body2 block2 .*-init_rot \{0 0 -0.2617")
        self.newcomer.enter("size1", "2", "0.5", "1.2")
        self.author.says(r"shape_set block2 .*-box \{2 0.5 1.2\}")
        for along, wheels in ((-3.6, 2), (-2.4, 4)):
            self.newcomer.create("Body", "Two Wheels on an Axle")
            place = self.author.says(r"^body body2 .*-init_pos \{(\S+) (\S+) (\S+)\}")
            x, y, z = (float(place.group(i)) for i in (1, 2, 3))
            turn = along + 3  # along the car
            self.newcomer.click(x + turn * math.cos(slope) - 0.15 * math.sin(slope),
                       y + turn * math.sin(slope) - 0.15 * math.cos(slope), z + 0.6)
            self.author.says(rf"^joint hinge{wheels} .*-body2 body2")
        self.author.look("car")
        self.newcomer.create("Force", "Gravity for All Bodies")
        self.author.says(r"^force -body body6 -gravitational \{0 -9.81 0\}")
        self.newcomer.play(MOST)

        rows = self.author.motion(1.5, "body2.x", "body2.y", "body2.z", "hinge3.q")
        landed, last = rows[5], rows[-1]
        rolled = math.dist(landed[1:3], last[1:3])
        self.assertGreater(rolled, 1.5)
        self.assertGreater(last[1], landed[1])
        self.assertLess(last[2], landed[2])
        self.assertLess(abs(last[3] - landed[3]), 1e-3)  # straight on
        self.assertLess(abs(0.3 * (landed[4] - last[4]) - rolled), 1e-3)  # without slipping

    def test_planets_go_round_a_sun(self):
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.click(0, 0, 0)
        self.author.says(r"^body body1 ball1")
        self.newcomer.enter("-mass", "10")
        self.author.says(r"^body body1 .*-mass 10")
        for name, place, radius in (("body2", (0.8, 0, 0.3), "0.08"), ("body3", (-1.2, 0, 0.4), "0.1")):
            self.newcomer.create("Body", "New Sphere")
            self.newcomer.click(*place)
            self.author.says(rf"^body {name} ball")
            self.newcomer.enter("size1", radius)
            self.author.says(rf"-sphere {radius}")
        self.author.look("bodies")
        for planet in ("body2", "body3"):
            self.newcomer.create("Force", "Orbit Round a Body")
            for body in ("body1", planet):
                place = self.author.says(rf"^body {body} .*-init_pos \{{(\S+) (\S+) (\S+)\}}")
                self.newcomer.click(*(float(place.group(i)) for i in (1, 2, 3)))
            self.author.says(rf"^body {planet} .*-init_dpos")
        self.newcomer.create("Force", "Attraction of All Bodies")
        self.author.says(r"^force -body body3 .*body2\.mass")
        self.author.look("orbits")
        self.newcomer.play(MOST)

        bodies = (1, 2, 3)
        rows = self.author.motion(10, *(f"body{i}.{what}" for i in bodies for what in ("x", "y", "z", "dx", "dy", "dz", "mass")))
        states = [[row[1 + 7 * i:8 + 7 * i] for i in range(3)] for row in rows]

        def energy(state):
            return (sum(mass / 2 * (dx * dx + dy * dy + dz * dz) for *_, dx, dy, dz, mass in state)
                    - sum(one[6] * other[6] / math.dist(one[:3], other[:3])
                          for i, one in enumerate(state) for other in state[i + 1:]))

        for planet in (1, 2):
            apart = [math.dist(state[0][:3], state[planet][:3]) for state in states]
            self.assertLess(max(apart) / min(apart), 1.02)  # circles
        self.assertLess(max(math.dist(state[0][:3], states[0][0][:3]) for state in states), 0.02)  # the sun stays
        energies = [energy(state) for state in states]
        self.assertLess(max(energies) - min(energies), 1e-3 * abs(energies[0]))

    def test_a_ball_rolls_off_a_table(self):
        self.newcomer.create("Body", "New Box")
        self.newcomer.click(0, 0, 0)
        self.author.says(r"^body body1 block1")
        self.newcomer.enter("size1", "2", "0.2", "1")
        self.author.says(r"-box \{2 0.2 1\}")
        self.newcomer.choose("-fixed", "y")
        self.author.says(r"^body body1 .*-fixed 1")
        top = float(self.author.says(r"^body body1 .*-init_pos \{\S+ (\S+) ").group(1)) + 0.1
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.click(-0.5, top, 0)
        self.author.says(r"^body body2 ball1")
        self.newcomer.enter("-init_dpos1", "1")
        self.author.says(r"^body body2 .*-init_dpos \{1 0 0\}")
        self.newcomer.create("Force", "Gravity for All Bodies")
        self.author.says(r"^force -body body2 -gravitational \{0 -9.81 0\}")
        self.author.look("table")
        self.newcomer.play(MOST)

        rows = self.author.motion(5, "body2.x", "body2.y")
        on = [row for row in rows if row[1] < 0.9]
        self.assertGreater(len(on), 3)
        for row in on:
            self.assertLess(abs(row[2] - rows[0][2]), 1e-3)  # it stays on the table
        self.assertLess(rows[-1][2], rows[0][2] - 1)  # and falls beyond its edge

    def test_a_ball_falls_and_bounces(self):
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.click(0, 0, 0)
        radius = float(self.author.says(r"^body body1 ball1 -init_pos \{\S+ (\S+) ").group(1))
        self.newcomer.accept("addGravity")
        self.author.says(r"^force -body body1 -gravitational \{0 -9.81 0\}")
        self.newcomer.accept("addFloor")
        self.author.says(r"^body \S+ floor1 .*-fixed 1")
        self.newcomer.click(0, radius, 0)
        self.newcomer.enter("-init_pos2", "2")
        self.author.says(r"^body body1 .*-init_pos \{\S+ 2 ")
        self.author.look("high")
        self.newcomer.play(12)

        rows = self.author.motion(5, "body1.y")
        heights = [row[1] for row in rows]
        self.assertAlmostEqual(min(heights), radius, delta=0.2)
        self.assertGreater(min(heights), radius - 1e-3)
        self.assertGreater(max(heights[8:]), radius + 0.3)  # it bounced
        self.assertAlmostEqual(heights[-1], radius, delta=0.05)

    def test_a_pendulum_has_a_graph(self):
        self.author.press("graphicalViewer1", "3")  # along z
        self.newcomer.actions += 1
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.click(0.8, -0.6, 0)
        x, y = (float(one) for one in self.author.says(r"^body body1 .*-init_pos \{(\S+) (\S+) 0\}").groups())
        for number in x, y:
            self.assertEqual(number, round(number, 2))  # as on a plan: no digits that nobody meant
        self.newcomer.create("Joint", "Hinge")
        self.newcomer.click(x, y, 0)
        self.newcomer.click(0, 0, 0)
        self.author.says(r"^joint hinge1 -type hinge -body1 body1")
        self.newcomer.create("Force", "Gravity for All Bodies")
        self.author.says(r"^force -body body1 -gravitational \{0 -9.81 0\}")
        self.newcomer.click(0, 0, 0)  # the hinge
        self.newcomer.create("Plot")
        self.author.window("newPlot")
        self.author.press("newPlot", "Return")
        self.newcomer.actions += 1
        plot = self.author.says(r"^plot \S+ -values \{\{(.*)\}\} -labels \{\{angle of hinge1\}\}").group(1)
        self.assertRegex(plot, r"^atan2\(body1\.x - hinge1\.px, hinge1\.py - body1\.y\)$")
        self.author.look("graph")
        self.newcomer.play(MOST)

        rows = self.author.motion(6, "body1.x", "body1.y")
        angles = [math.degrees(math.atan2(row[1], -row[2])) for row in rows]
        self.assertAlmostEqual(angles[0], math.degrees(math.atan2(x, -y)), delta=1)
        self.assertAlmostEqual(max(angles), -min(angles), delta=2)  # about straight down

    def test_a_stack_falls(self):
        self.newcomer.create("Body", "New Floor Below All")
        self.author.says(r"^body floor1|^body body1 .*-fixed 1")
        height = 0  # of the stack
        for count in range(1, 4):
            self.newcomer.create("Body", "New Box")
            self.newcomer.click(0, height, 0)
            until("there is another box", lambda: len(self.boxes()) == count)
            middle = self.boxes()[-1][1]
            self.assertGreater(middle, height)
            height = 2 * middle - height
            self.author.look("box")
        self.newcomer.create("Force", "Gravity for All Bodies")
        top, start = max(self.boxes(), key=lambda box: box[1])
        self.author.says(rf"^force -body {top} -gravitational")
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.type(f"-3 {start:g} 0")
        ball = self.author.says(r"^body (\S+) ball1 .*-init_pos \{-3 ").group(1)
        self.author.says(rf"^force -body {ball} -gravitational")  # as all others
        self.newcomer.enter("-init_dpos1", "20")
        self.author.says(rf"^body {ball} .*-init_dpos \{{20 0 0\}}")
        self.newcomer.enter("-mass", "5")
        self.author.says(rf"^body {ball} .*-mass 5")
        self.newcomer.play(MOST)

        rows = self.author.motion(4, f"{top}.y")
        self.assertLess(abs(rows[0][1] - start), 1e-6)
        self.assertLess(rows[-1][1], start - 0.5)

    def boxes(self):
        """Names and heights."""
        return [(name, float(y)) for name, y in
                re.findall(r"^body (\S+) block\d+ .*?-init_pos \{\S+ (\S+) ", self.author.saved(), re.M)]

    def test_a_ball_is_thrown_while_the_motion_plays(self):
        self.author.press("graphicalViewer1", "3")
        self.newcomer.actions += 1
        self.newcomer.create("Body", "New Sphere")
        self.newcomer.click(0, 0, 0)
        self.author.says(r"^body body1 ball1")
        self.newcomer.enter("finish", "600")  # however slow the machine is
        self.author.says(r"^simulator .*-finish 600")
        self.author.giveKeysTo("scene")
        self.author.press("graphicalViewer1", "space")
        self.newcomer.actions += 1
        begun = self.author.widget("graphicalViewer1", "time").text
        until("time runs", lambda: self.author.widget("graphicalViewer1", "time").text != begun)
        start, end = (self.author.point("graphicalViewer1", *at) for at in ((0, 0, 0), (0.5, 0.3, 0)))
        self.author.drag("graphicalViewer1", start, end)
        self.newcomer.actions += 1
        thrown = self.author.says(r"^body body1 .*-init_dpos \{(\S+) (\S+) \S+\}")
        self.author.look("thrown")
        self.assertGreater(float(thrown.group(1)), 0)
        self.assertGreater(float(thrown.group(2)), 0)
        self.assertLessEqual(self.newcomer.actions, MOST)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
