#!/usr/bin/env python3
"""A reader opens the memo, turns its picture, plays it, uses a menu and quits."""
import subprocess
import sys
import tempfile
import unittest

from screen import Screen, until

ENSEMBLE, MEMO = sys.argv[1], sys.argv[2]


class Reader(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.screen = Screen(self.folder.name)
        self.addCleanup(self.screen.close)
        self.ensemble = subprocess.Popen([ENSEMBLE, MEMO], env=self.screen.environment, stdin=subprocess.DEVNULL)
        self.addCleanup(self.ensemble.wait)
        self.addCleanup(self.ensemble.kill)
        self.window = until("the memo's window is there", lambda: self.screen.windows("memo.ens"))[0]
        self.screen.do("windowactivate", "--sync", self.window)

    def balls(self):
        """Where the picture is grey, seen with the pointer away from it, so that nothing lies over it."""
        self.screen.do("mousemove", "--window", self.window, 30, 20)
        picture = self.screen.picture(self.window)
        return picture.greySpots() if picture else set()

    def still(self):
        """Where the balls are when they stand: two looks that agree."""
        seen = [self.balls()]

        def agrees():
            seen.append(self.balls())
            return seen[-1] and seen[-1] == seen[-2]

        until("the picture stands still", agrees)
        return seen[-1]

    def changed(self, what, before):
        until(what, lambda: self.balls() not in (before, set()))

    def test_opens_turns_plays_shows_menus_and_quits(self):
        at = sorted(self.still())
        x, y = at[len(at) // 2]

        before = self.still()
        self.screen.do("mousemove", "--window", self.window, x, y, "click", 1)
        self.screen.do("mousemove", "--window", self.window, x, y, "mousedown", 1)
        for step in range(1, 9):
            self.screen.do("mousemove", "--window", self.window, x + 15 * step, y + 5 * step)
        self.screen.do("mouseup", 1)
        self.changed("dragging turns the picture", before)

        before = self.still()
        self.screen.do("key", "space")
        self.changed("space plays", before)
        self.assertTrue(self.still())

        before = self.screen.windows()
        self.screen.do("mousemove", "--window", self.window, x, y, "click", 3)
        until("the medium's menu opens", lambda: set(self.screen.windows()) - set(before))
        self.screen.do("key", "Escape")
        until("Escape closes the menu", lambda: not set(self.screen.windows()) - set(before))

        self.screen.do("windowactivate", "--sync", self.window, "key", "ctrl+q")
        until("the program ends", lambda: self.ensemble.poll() is not None)
        self.assertEqual(self.ensemble.returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
