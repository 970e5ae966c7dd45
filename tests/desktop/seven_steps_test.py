#!/usr/bin/env python3
"""The seven steps of the dissertation's section 3.2, done with pointer and keys in the running program: from an empty
scene to the played motion of two rods and a ball (Figure 4.6); then one body is led by a trajectory for a while.

usage: seven_steps_test.py PATH-TO-ASGARD [unittest arguments]       ASGARD_SCREENSHOTS=FOLDER keeps what was seen
"""
import os
import sys
import tempfile
import unittest

from person import Author, Newcomer, isInside
from screen import until

ASGARD = os.path.abspath(sys.argv[1])
VIEWER = "graphicalViewer1"
BALL = (10.1, -17)  # where it is made: within reach of the rods
MOST = 40  # actions of a newcomer
PATH = [(-20, -8), (-24, -14), (-21, -20)]  # where the rods do not reach


class SevenSteps(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def click(self, author, x, y):
        author.click(VIEWER, author.point(VIEWER, x, y, 0))

    # --- the steps
    def makeShapes(self, author):
        author.menu(VIEWER, "Shapes", "New Shape")
        author.answer("New Shape", "rod")
        author.says(r"shape_set rod .*-points")
        author.look("new-shape")
        self.firstPart(author, "addBox", r"shape_set rod -desc \{-sub \{-box \{1 1 1\}\}\}")
        for field, edge in (("size1", "10"), ("size2", "1.1"), ("size3", "1.1")):
            author.clickOn("shapeEditor", field)
            until(f"{field} has the keyboard", lambda: author.widget("shapeEditor", field).focus)
            author.fill("shapeEditor", edge)
            author.screen.do("key", "Tab")
        author.says(r"-box \{10 1.1 1.1\}")
        author.look("rod")
        author.menu("shapeEditor", "File", "New Shape")
        author.answer("New Shape", "ball")
        author.says(r"shape_set ball")
        self.firstPart(author, "addSphere", r"shape_set ball -desc \{-sub \{-sphere 0.5\}\}")
        author.look("ball")
        author.menu("shapeEditor", "File", "Close")
        author.gone("shapeEditor")

    def firstPart(self, author, adds, becomes):
        """It takes the place of the polyhedron as which a new shape begins, and is chosen."""
        author.clickOn("shapeEditor", adds)
        author.says(becomes)

    def createBody(self, author, shape, place):
        author.menu(VIEWER, "Create", "Body", shape)
        author.click(VIEWER, place)

    def placeBodies(self, author):
        author.menu(VIEWER, "View", "Along z: the Plane x y")
        self.createBody(author, "rod", author.widget(VIEWER, "scene").middle)
        author.says(r"^body rod1 rod")
        author.exactly("rod1", "-5", "0", "0")
        author.says(r"^body rod1 rod -init_pos \{-5 0 0\}")
        author.menu(VIEWER, "View", "Frame All")
        author.menu(VIEWER, "View", "Along z: the Plane x y")
        self.seeMore(author)
        author.look("first-rod")
        self.createBody(author, "rod", author.point(VIEWER, -15, 0, 0))
        author.says(r"^body rod2 rod")
        self.createBody(author, "ball", author.point(VIEWER, *BALL, 0))
        self.ball = author.says(r"^body (\w+) ball").group(1)
        author.look("bodies")

    def seeMore(self, author):
        """Turns the wheel, above and right of the middle, until all is seen that is pointed at later."""
        for _ in range(40):
            scene, places = author.scene(VIEWER, *[(*at, 0) for at in (BALL, *PATH, (10, 2))])
            if all(isInside(scene.rect, place, 20) for place in places):
                return
            left, top, width, height = scene.rect
            author.click(VIEWER, (left + width * 2 / 3, top + height / 10), button=5)
        self.fail("the wheel does not bring all into sight")

    def describe(self, author):
        """What is meant and not seen: by the text."""
        for body in ("rod1", "rod2"):
            author.append(rf"^body {body} ", " -artbody pendulum -mass 10")
        author.says(r"^body rod2 .*-artbody pendulum -mass 10$")
        author.look("updated")

    def addForces(self, author):
        for body, x in (("rod1", -5), ("rod2", -15)):
            author.menu(VIEWER, "Create", "Force", "Gravity for One Body")
            self.click(author, x, 0)
            author.type("0 -10 0")  # a click is approximate
            author.screen.do("key", "Return")
            author.says(rf"^force .*{body}.* -gravitational \{{0 -10 0\}}")
        author.look("forces")

    def addLinks(self, author):
        author.menu(VIEWER, "Create", "Link", "Body to Point")
        self.click(author, -0.2, 0)
        self.click(author, 0, 0)
        author.says(r"^link -body1 rod1 ")
        author.menu(VIEWER, "Create", "Link", "Body to Body")
        self.click(author, -10.2, 0)
        self.click(author, -9.8, 0)
        author.says(r"^link -body1 rod2 .*-body2 rod1")
        author.look("links")

    def throwBall(self, author):
        """The handle of a velocity that is zero lies on its body."""
        author.menu(VIEWER, "Handles", "None")  # one that lay on it would stand beside it
        author.menu(VIEWER, "Handles", "Velocities")
        x, y = BALL
        author.hint(VIEWER, author.point(VIEWER, x, y, 0), f"velocity of {self.ball}")
        author.look("velocities")
        author.drag(VIEWER, author.point(VIEWER, x, y, 0), author.point(VIEWER, x - 3, y, 0), key="shift")
        author.says(rf"^body {self.ball} .*-init_dpos \{{-")
        author.look("thrown")

    def giveTime(self, author):
        author.giveKeysTo("text")
        author.press(VIEWER, "ctrl+Home")
        author.type("simulator -finish 5")
        author.screen.do("key", "Return")
        author.press(VIEWER, "ctrl+Return")
        author.says(r"\Asimulator -finish 5\n")
        author.giveKeysTo("scene")
        author.press(VIEWER, "F5")
        author.look("simulated")

    def play(self, author):
        before = author.colorBox()
        author.press(VIEWER, "space")
        until("it moves", lambda: author.colorBox() != before)
        author.look("played")
        author.press(VIEWER, "End")
        author.look("last-moment")
        author.press(VIEWER, "Home")

    def leadBall(self, author):
        """A trajectory leads the ball for two seconds, then it is free."""
        author.menu(VIEWER, "Create", "Trajectory")
        for place in PATH:
            self.click(author, *place)
        author.screen.do("key", "Return")
        name = author.says(r"^trajectory (\w+) -points").group(1)
        author.widget(VIEWER, "timeStrip")  # which takes room of the picture
        author.look("trajectory")
        author.menu(VIEWER, "Create", "Attach Trajectory")
        self.click(author, *BALL)
        self.click(author, *PATH[1])
        author.append(rf"^constrain {self.ball} -pos {name}", " -to 2")
        author.says(r"^constrain .* -to 2$")
        author.look("led")

    def test_from_an_empty_scene_to_the_played_motion_and_a_trajectory(self):
        author = Author(self, ASGARD, self.folder.name)
        author.look("empty")
        self.makeShapes(author)
        self.placeBodies(author)
        self.describe(author)
        self.addForces(author)
        self.addLinks(author)
        self.throwBall(author)
        self.giveTime(author)
        self.play(author)
        rows = author.motion(5, "rod2.y", "rod1.x", f"{self.ball}.x", f"{self.ball}.y", "rod1.mass")
        self.assertLess(min(row[1] for row in rows), -10)  # it swings down
        for row in rows[:5]:  # and hangs on the origin
            self.assertLess(abs(row[2]), 5.2)
        speeds = [(b[3] - a[3]) / 0.1 for a, b in zip(rows, rows[1:])]
        self.assertGreater(max(abs(a - b) for a, b in zip(speeds, speeds[1:])), 0.5)  # and strikes the ball

        self.leadBall(author)
        rows = author.motion(5, f"{self.ball}.x", f"{self.ball}.y")
        self.assertLess(abs(rows[0][1] - PATH[0][0]) + abs(rows[0][2] - PATH[0][1]), 0.5)
        bends = [max(abs(a[i] - 2 * b[i] + c[i]) for i in (1, 2)) for a, b, c in zip(rows, rows[1:], rows[2:])]
        self.assertGreater(max(bends[:18]), 1e-3)  # led along a curve
        self.assertLess(max(bends[21:]), 1e-6)  # free: straight on
        self.assertGreater(abs(rows[-1][1] - rows[21][1]) + abs(rows[-1][2] - rows[21][2]), 1)

    def test_a_newcomer_needs_few_actions(self):
        """The same, without a word of the language: bodies, their values in Properties, weights, hinges, the time."""
        author = Author(self, ASGARD, self.folder.name)
        newcomer = Newcomer(author)
        author.press(VIEWER, "3")  # along z
        newcomer.actions += 1
        newcomer.createByTool("createBody", "New Box")
        newcomer.type("-5 0 0")
        author.says(r"^body body1 block1 .*-init_pos \{-5 0 0\}")
        newcomer.enter("size1", "10", "1", "1")
        author.says(r"-box \{10 1 1\}")
        newcomer.createByTool("createBody", "block1")
        newcomer.type("-15 0 0")
        author.says(r"^body body2 block1 .*-init_pos \{-15 0 0\}")
        newcomer.createByTool("createBody", "New Sphere")
        newcomer.type("{} {} 0".format(*BALL))
        author.says(r"^body body3 ball1")
        newcomer.enter("size1", "0.5")
        author.says(r"-sphere 0.5")
        newcomer.enter("-init_dpos1", "-3")
        author.says(r"^body body3 .*-init_dpos \{-3 0 0\}")
        newcomer.frame((-20, 0, 0), (*BALL, 0))
        author.look("bodies")
        newcomer.click(-5, 0, 0)
        newcomer.click(-15, 0, 0, key="shift")
        newcomer.enter("-mass", "10")
        author.says(r"^body body2 .*-mass 10")
        newcomer.createByTool("createForce", "Gravity for the Selected Bodies")
        author.says(r"^force -body body2 -gravitational \{0 -9.81 0\}")
        author.row(VIEWER, "elements", "Forces (2)")
        for count, rod, x, at in ((1, "body1", -5, "0 0 0"), (2, "body2", -15, "-10 0 0")):
            newcomer.createByTool("createJoint", "Hinge")
            newcomer.click(x, 0, 0)
            newcomer.type(at)
            author.says(rf"^joint hinge{count} -type hinge -body1 {rod} ")
            author.row(VIEWER, "elements", f"Joints ({count})")  # the scene that is clicked on next
        author.look("hinges")
        newcomer.enter("finish", "5")
        author.says(r"^simulator .*-finish 5")
        newcomer.play(MOST)

        rows = author.motion(5, "body2.y", "body1.x", "body3.x", "body3.y", "body1.mass")
        self.assertLess(min(row[1] for row in rows), -10)  # it swings down
        speeds = [(b[3] - a[3]) / 0.1 for a, b in zip(rows, rows[1:])]
        self.assertGreater(max(abs(a - b) for a, b in zip(speeds, speeds[1:])), 0.5)  # and strikes the ball
        self.assertEqual(rows[0][5], 10)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
