#!/usr/bin/env python3
"""Text is dragged out of a document that is read, into one that another program writes.

usage: dragging_test.py PATH-TO-ENSEMBLE [unittest arguments]
"""
import os
import sys
import tempfile
import unittest

from person import Person
from screen import until

ENSEMBLE = os.path.abspath(sys.argv[1])


def memo(word):
    """Full of one word, so that any place in the middle of its page is on a letter."""
    line = "<PARAGRAPH><TEXT>{" + " ".join([word] * 400) + "}</TEXT></PARAGRAPH>\n"
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Words}</SUBJECT>\n<BODY>\n" + line * 2 + "</BODY>\n</CMEMO>\n"


class Dragging(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.person = Person(self, self.folder.name, ENSEMBLE, [self.file("source", "dragged")], "1500x1000x24")
        self.source = self.shown("source", 0)
        self.person.start(ENSEMBLE, [self.file("target", "here")])
        self.target = self.shown("target", 760)

    def file(self, name, word):
        path = os.path.join(self.folder.name, name + ".ens")
        with open(path, "w", encoding="utf-8") as file:
            file.write(memo(word))
        return path

    def bytes(self, name):
        with open(os.path.join(self.folder.name, name + ".ens"), encoding="utf-8") as file:
            return file.read()

    def shown(self, name, left):
        """The title of its window, which stands in its half of the screen."""
        def named():
            return next((one for one in self.person.windows() if name in (one.title or "")), None)

        window = until(f"{name} has a window", named)
        self.person.screen.do("windowsize", window.id, 700, 900, "windowmove", window.id, left, 20)
        frame = 30  # more than the window manager draws about it

        def placed():
            x, y, width = self.placed(window.title)
            return width == 700 and 0 <= x - left <= frame and 0 <= y - 20 <= frame

        until(f"{name} stands in its half", placed)
        return window.title

    def placed(self, title):
        """The left, the top and the width of what is inside its frame."""
        words = self.person.screen.output("xdotool", "getwindowgeometry", "--shell", self.person.window(title).id)
        values = dict(line.split("=") for line in words.decode().split())
        return tuple(int(values[name]) for name in ("X", "Y", "WIDTH"))

    def selectAllToDrag(self):
        self.person.press(self.source, "ctrl+a")
        until("the text is selected", lambda: self.person.action(self.source, "Edit", "Copy").enabled)

    def write(self):
        self.person.press(self.target, "ctrl+e")
        until("the other document is written", lambda: self.person.action(self.target, "Edit", "Write").checked)

    def test_its_words_come_into_the_other_and_stay_where_they_were(self):
        self.write()
        self.selectAllToDrag()
        start = self.person.widget(self.source, "pages").middle
        end = self.person.widget(self.target, "pages").middle
        (fromX, fromY, _), (toX, toY, _) = self.placed(self.source), self.placed(self.target)
        self.person.drag(self.source, start, (end[0] + toX - fromX, end[1] + toY - fromY))
        until("the other document is modified", lambda: self.person.isModified(self.target))
        self.person.press(self.target, "ctrl+s")
        until("it is saved", lambda: not self.person.isModified(self.target))
        self.assertIn("dragged", self.bytes("target"))
        self.assertIn("here", self.bytes("target"))
        self.assertEqual(self.bytes("source"), memo("dragged"))
        self.assertFalse(self.person.isModified(self.source))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
