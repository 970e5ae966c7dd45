#!/usr/bin/env python3
"""A reader opens the memo, turns its picture, moves a ball and takes it back, plays it, uses a menu and quits."""
import sys
import tempfile
import unittest

from person import Person
from screen import until

ENSEMBLE, MEMO = sys.argv[1], sys.argv[2]
WINDOW = "documentWindow"


class Reader(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.person = Person(self, self.folder.name, ENSEMBLE, [MEMO], "1100x1000x24")
        self.person.activate(WINDOW)

    def balls(self):
        """Where the page is grey, seen with the pointer away from it, so that nothing lies over it."""
        window = self.person.window(WINDOW)
        self.person.screen.do(*self.person.at(window, self.person.widget(WINDOW, "page").middle))
        left, top, *_ = self.person.widget(WINDOW, "pages").rect
        picture = self.person.picture(WINDOW, "pages")
        return {(left + x, top + y) for x, y in picture.greySpots()} if picture else set()

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

    def isChanged(self):
        return self.person.window(WINDOW).modified

    def aBall(self):
        at = sorted(self.still())
        return at[len(at) // 2]

    def test_opens_turns_moves_plays_shows_menus_and_quits(self):
        before = self.still()
        x, y = self.aBall()
        self.person.drag(WINDOW, (x, y), (x + 60, y + 20))
        self.changed("dragging turns the picture", before)
        self.assertFalse(self.isChanged())

        before = self.still()
        x, y = self.aBall()
        self.person.click(WINDOW, (x, y))
        self.person.drag(WINDOW, (x, y), (x + 40, y))
        self.changed("dragging the ball that a click selected moves it", before)
        until("the memo has a change", self.isChanged)
        self.person.press(WINDOW, "ctrl+z")
        until("the memo is as it was", lambda: not self.isChanged())
        x, y = self.aBall()

        before = self.still()
        self.person.press(WINDOW, "space")
        self.changed("space plays", before)
        self.assertTrue(self.still())

        self.person.click(WINDOW, (x, y), button=3)
        until("the medium's menu opens", self.person.menus)
        self.person.screen.do("key", "Escape")
        until("Escape closes the menu", lambda: not self.person.menus())

        self.person.press(WINDOW, "ctrl+q")
        until("the program ends", lambda: self.person.program.poll() is not None)
        self.assertEqual(self.person.program.returncode, 0)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
