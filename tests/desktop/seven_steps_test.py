#!/usr/bin/env python3
"""The seven steps of the dissertation's section 3.2, done with pointer and keys in the running program: from an empty
scene to the played motion of two rods and a ball (Figure 4.6); then one body is led by a trajectory for a while.

usage: seven_steps_test.py PATH-TO-ASGARD [unittest arguments]       ASGARD_SCREENSHOTS=FOLDER keeps what was seen
"""
import csv
import io
import os
import subprocess
import sys
import tempfile
import time
import unittest

from person import Person
from screen import until

ASGARD = os.path.abspath(sys.argv[1])
PICTURE = (12, 24, 705, 655)  # in the graphical viewer's window


class SevenSteps(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def motion(self, person, *quantities):
        """The saved scene's, every tenth of a second."""
        person.saved()
        table = subprocess.run([ASGARD, "simulate", person.file, "--at", "0:0.1:5", "--only", "--quantities",
                                ",".join(quantities)], check=True, capture_output=True, text=True).stdout
        rows = list(csv.reader(io.StringIO(table)))[1:]
        return [[float(cell) for cell in row] for row in rows]

    # --- the steps
    def makeShapes(self, person):
        person.menu(person.graphical, "alt+s", "n")
        person.answer("New Shape", "rod")
        editor = person.window("Shape Editor")
        person.says(r"shape_set rod .*-points")
        person.look("new-shape")
        self.onlyPart(person, editor, "alt+b", r"shape_set rod -desc \{-sub \{-box \{1 1 1\}\}\}")
        self.choosePart(person, editor)
        person.click(editor, (525, 625), times=3)
        for edge in ("10", "1.1", "1.1"):
            person.screen.do("key", "ctrl+a")
            person.type(edge)
            person.screen.do("key", "Tab")
        person.says(r"-box \{10 1.1 1.1\}")
        person.look("rod")
        person.press(editor, "ctrl+n")
        person.answer("New Shape", "ball")
        person.says(r"shape_set ball")
        self.onlyPart(person, editor, "alt+s", r"shape_set ball -desc \{-sub \{-sphere 0.5\}\}")
        person.look("ball")
        person.press(editor, "ctrl+w")

    def choosePart(self, person, editor):
        person.click(editor, (717, 86))

    def onlyPart(self, person, editor, adds, becomes):
        """A new shape begins as a polyhedron: one of another kind takes its place."""
        person.press(editor, adds)
        person.says("-sub.*-sub")
        self.choosePart(person, editor)
        person.click(editor, (792, 420))
        person.says(becomes)

    def exactly(self, person, *values):
        """Types the exact values of what is marked."""
        person.changes(person.graphical, lambda: person.press(person.graphical, "Return"))
        for i, value in enumerate(values):
            person.screen.do("key", "ctrl+a")
            person.type(value)
            person.screen.do("key", "Tab" if i + 1 < len(values) else "Return")

    def createBody(self, person, choose, at):
        person.menu(person.graphical, "alt+c", "b", choose)
        person.click(person.graphical, at)

    def placeBodies(self, person):
        left, top, right, bottom = PICTURE
        middle = ((left + right) / 2, (top + bottom) / 2)
        person.press(person.graphical, "3")
        self.createBody(person, "Up Up Return", middle)
        person.says(r"^body rod1 rod")
        self.exactly(person, "-5", "0", "0")
        person.says(r"^body rod1 rod -init_pos \{-5 0 0\}")
        person.press(person.graphical, "f", "3")
        for _ in range(20):
            x0, y0, x1, y1 = box = person.grey(person.graphical, PICTURE)
            if x1 - x0 < 165:
                break
            # The wheel: more to see, and most of it to the left and below.
            person.click(person.graphical, (right - 230, top + 60), button=5)
        x0, y0, x1, y1 = box
        self.unit = (x1 - x0) / 10
        self.origin = (x1, (y0 + y1) / 2)
        person.look("first-rod")
        self.createBody(person, "Up Up Return", self.at(-15, 0))
        person.says(r"^body rod2 rod")
        self.createBody(person, "Up Return", self.at(10.1, -17))
        self.ball = person.says(r"^body (\w+) ball").group(1)
        person.look("bodies")

    def lookAgain(self, person):
        """Where things are once the strip of times has come below the picture: by both rods, without handles at their ends."""
        person.changes(person.graphical, lambda: person.press(person.graphical, "alt+k"))
        time.sleep(1)
        left, top, right, bottom = PICTURE
        x0, y0, x1, y1 = person.grey(person.graphical, (left, top, right, (top + bottom) // 2))
        self.unit = (x1 - x0) / 20.07
        self.origin = (x1, (y0 + y1) / 2)

    def at(self, x, y):
        return self.origin[0] + x * self.unit, self.origin[1] - y * self.unit

    def describe(self, person):
        """What is meant and not seen: by the text."""
        for body in ("rod1", "rod2"):
            person.append(rf"^body {body} ", " -artbody pendulum -mass 10")
        person.says(r"^body rod2 .*-artbody pendulum -mass 10$")
        person.look("updated")

    def addForces(self, person):
        for body, x in (("rod1", -5), ("rod2", -15)):
            person.menu(person.graphical, "alt+c", "f", "g")
            person.click(person.graphical, self.at(x, 0))
            person.click(person.graphical, self.at(x, -10))
            person.says(rf"^force .*{body}.* -gravitational")
            self.exactly(person, "0", "-10", "0")  # a click is approximate
            person.says(rf"^force .*{body}.* -gravitational \{{0 -10 0\}}")
        person.look("forces")

    def addLinks(self, person):
        person.menu(person.graphical, "alt+c", "l", "p")
        person.click(person.graphical, self.at(-0.2, 0))
        person.click(person.graphical, self.at(0, 0))
        person.says(r"^link -body1 rod1 ")
        person.menu(person.graphical, "alt+c", "l", "b")
        person.click(person.graphical, self.at(-10.2, 0))
        person.click(person.graphical, self.at(-9.8, 0))
        person.says(r"^link -body1 rod2 .*-body2 rod1")
        person.look("links")

    def throwBall(self, person):
        """The handle of a velocity that is zero lies on its body."""
        person.changes(person.graphical, lambda: person.press(person.graphical, "alt+l"))
        person.look("velocities")
        person.drag(person.graphical, self.at(10.1, -17), self.at(7.1, -17))
        person.says(rf"^body {self.ball} .*-init_dpos \{{-")
        person.look("thrown")

    def giveTime(self, person):
        person.press(person.language, "ctrl+Home")
        person.type("simulator -finish 5")
        person.screen.do("key", "Return")
        person.press(person.language, "ctrl+Return")
        person.says(r"\Asimulator -finish 5\n")
        person.press(person.panel, "alt+s")
        person.look("simulated")

    def play(self, person):
        before = person.grey(person.graphical, PICTURE)
        person.press(person.graphical, "space")
        until("it moves", lambda: person.grey(person.graphical, PICTURE) != before)
        person.look("played")
        person.press(person.graphical, "End")
        person.look("last-moment")
        person.press(person.graphical, "Home")

    def leadBall(self, person):
        """A trajectory leads the ball for two seconds, then it is free."""
        person.menu(person.graphical, "alt+c", "j")
        for place in self.path:
            person.click(person.graphical, self.at(*place))
        person.screen.do("key", "Return")
        name = person.says(r"^trajectory (\w+) -points").group(1)
        person.look("trajectory")
        self.lookAgain(person)
        person.menu(person.graphical, "alt+c", "a")
        person.click(person.graphical, self.at(10.1, -17))
        person.click(person.graphical, self.at(*self.path[1]))
        person.append(rf"^constrain {self.ball} -pos {name}", " -to 2")
        person.says(r"^constrain .* -to 2$")
        person.look("led")

    def test_from_an_empty_scene_to_the_played_motion_and_a_trajectory(self):
        person = Person(self, ASGARD, self.folder.name)
        person.look("empty")
        self.makeShapes(person)
        self.placeBodies(person)
        self.describe(person)
        self.addForces(person)
        self.addLinks(person)
        self.throwBall(person)
        self.giveTime(person)
        self.play(person)
        rows = self.motion(person, "rod2.y", "rod1.x", f"{self.ball}.x", f"{self.ball}.y", "rod1.mass")
        self.assertLess(min(row[1] for row in rows), -10)  # it swings down
        for row in rows[:5]:  # and hangs on the origin
            self.assertLess(abs(row[2]), 5.2)
        speeds = [(b[3] - a[3]) / 0.1 for a, b in zip(rows, rows[1:])]
        self.assertGreater(max(abs(a - b) for a, b in zip(speeds, speeds[1:])), 0.5)  # and strikes the ball

        self.path = [(-20, -8), (-24, -14), (-21, -20)]  # where the rods do not reach
        self.leadBall(person)
        rows = self.motion(person, f"{self.ball}.x", f"{self.ball}.y")
        self.assertLess(abs(rows[0][1] - self.path[0][0]) + abs(rows[0][2] - self.path[0][1]), 0.5)
        bends = [max(abs(a[i] - 2 * b[i] + c[i]) for i in (1, 2)) for a, b, c in zip(rows, rows[1:], rows[2:])]
        self.assertGreater(max(bends[:18]), 1e-3)  # led along a curve
        self.assertLess(max(bends[21:]), 1e-6)  # free: straight on
        self.assertGreater(abs(rows[-1][1] - rows[21][1]) + abs(rows[-1][2] - rows[21][2]), 1)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
