#!/usr/bin/env python3
"""A newcomer starts asgard without a file, looks at a sample, and takes the tour that builds a pendulum.

usage: starting_test.py PATH-TO-ASGARD [unittest arguments]       ASGARD_SCREENSHOTS=FOLDER keeps what was seen
"""
import os
import sys
import tempfile
import unittest

from person import Person, isInside
from screen import until

ASGARD = os.path.abspath(sys.argv[1])
VIEWER = "graphicalViewer1"


class Starting(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.person = Person(self, self.folder.name, ASGARD, [])
        self.person.window("firstPage")

    def click(self, x, y):
        self.person.click(VIEWER, self.person.point(VIEWER, x, y, 0))

    def step(self, words):
        """The tour has come to the step that says so."""
        until(f"the tour speaks of {words}", lambda: words in self.person.widget(VIEWER, "tourStep").text)
        self.person.look(words.replace(" ", "-"))

    def inSight(self, *points):
        def areSeen():
            scene, places = self.person.scene(VIEWER, *points)
            return all(isInside(scene.rect, place) for place in places)

        until(f"{points} are in the picture", areSeen)

    def test_a_sample_is_opened_by_a_double_click(self):
        self.person.look("first-page")
        self.person.click("firstPage", self.person.row("firstPage", "samples", "Pendulum").middle, times=2)
        self.person.gone("firstPage")
        until("it is shown", lambda: "Pendulum" in self.person.window(VIEWER).title)
        self.assertFalse(self.person.isModified(VIEWER))
        self.person.look("sample")
        self.person.press(VIEWER, "ctrl+w")  # the last window, and nothing is unsaved
        until("the program ends", lambda: self.person.program.poll() is not None)
        self.assertEqual(self.person.program.returncode, 0)

    def test_the_tour_builds_a_pendulum(self):
        self.person.clickOn("firstPage", "tour")
        self.step("Rod")
        for x in (0, 8):  # the ends of the rods meet at 4
            self.person.menu(VIEWER, "Create", "Body", *(["New from the Library", "Rod"] if x == 0 else ["rod1"]))
            self.click(x, 0)
            if x == 0:
                self.step("the hinge holds to the ground")
                self.person.menu(VIEWER, "Create", "Joint", "Hinge")
                self.click(-3.7, 0)
                self.click(-3.7, 0)
                self.step("right of the first rod")
        self.person.menu(VIEWER, "Create", "Joint", "Hinge")
        self.inSight((12, 0, 0), (12, 0.3, 0.3))
        self.click(8, 0)
        self.click(3.9, 0)
        self.step("Gravity for All Bodies")
        self.person.menu(VIEWER, "Create", "Force", "Gravity for All Bodies")
        self.step("Press Space")
        self.inSight((12, 0, 0), (-3.7, -15, 0))  # where it will hang
        self.person.press(VIEWER, "space")
        self.step("the double pendulum")
        self.person.clickOn(VIEWER, "endTour")
        until("the pane is gone", lambda: not any(one.name == "tour" for one in self.person.window(VIEWER).widgets))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
