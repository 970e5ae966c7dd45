#!/usr/bin/env python3
"""A document is edited in the medium's own windows, as users do it: host, medium and viewers on a display.

usage: editing_test.py PATH-TO-ENSEMBLE PATH-TO-MEMO [unittest arguments]
"""
import os
import re
import shutil
import signal
import sys
import tempfile
import unittest

from person import Person
from screen import until

ENSEMBLE, MEMO = os.path.abspath(sys.argv[1]), sys.argv[2]
HOST, VIEWER, SECOND = "documentWindow", "languageViewer1", "languageViewer2"


def children(pid):
    found = []
    for task in os.listdir(f"/proc/{pid}/task"):
        with open(f"/proc/{pid}/task/{task}/children") as file:
            found += map(int, file.read().split())
    return found


class Editing(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = os.path.join(self.folder.name, "memo.ens")
        shutil.copy(MEMO, self.file)
        self.original = self.bytes()
        self.person = Person(self, self.folder.name, ENSEMBLE, [self.file], "1100x1000x24")
        self.person.window(HOST)

    def bytes(self):
        with open(self.file, "rb") as file:
            return file.read()

    def typed(self, viewer, text):
        """At the beginning of the text; a draft is nobody's but the viewer's."""
        self.person.press(viewer, "ctrl+Home")
        self.person.type(text)
        until("there is a draft", lambda: self.person.isModified(viewer))

    def update(self, viewer):
        self.person.press(viewer, "ctrl+Return")
        until("the draft is in the document", lambda: not self.person.isModified(viewer))

    def openViewer(self):
        """By the host's command, as soon as there is such a command."""
        self.person.offered(HOST, "Asgard", "New Language Viewer")
        self.person.menu(HOST, "Asgard", "New Language Viewer")
        self.person.window(VIEWER)

    def isModified(self):
        return self.person.isModified(HOST)

    def saved(self):
        """The file's bytes once the document is modified and the host has written what it has."""
        until("the document is modified", self.isModified)
        self.person.press(HOST, "ctrl+s")
        until("the document is saved", lambda: not self.isModified())
        return self.bytes()

    def test_an_update_is_a_step_of_the_documents_undo_and_changes_only_its_bytes(self):
        self.openViewer()
        self.assertIn("memo.ens", self.person.window(VIEWER).title)
        # The text begins with an empty line; body b2 stands in its third.
        self.person.press(VIEWER, "ctrl+Home", "Down", "Down", "End")
        self.person.type(" -color red")
        until("there is a draft", lambda: self.person.isModified(VIEWER))
        self.assertFalse(self.isModified())
        self.update(VIEWER)
        end = self.original.index(b"\nbody b3")
        changed = self.original[:end] + b" -color red" + self.original[end:]
        self.assertEqual(self.saved(), changed)

        self.person.press(HOST, "ctrl+z")
        self.assertEqual(self.saved(), self.original)
        self.person.press(VIEWER, "ctrl+shift+z")  # asked for in the medium's window, done by the host
        self.assertEqual(self.saved(), changed)
        self.person.press(VIEWER, "ctrl+z")
        self.assertEqual(self.saved(), self.original)

        # The viewer's text followed all of that: what is typed now is the only change.
        self.typed(VIEWER, "# {1} ")
        self.update(VIEWER)
        begin = self.original.index(b"\nshape_set")
        self.assertEqual(self.saved(), self.original[:begin] + b"# \\{1\\} " + self.original[begin:])

    def test_viewers_stay_in_step_and_a_faulty_text_is_undone_like_any(self):
        self.openViewer()
        self.person.press(VIEWER, "ctrl+l")
        self.person.window(SECOND)
        for viewer, text in ((SECOND, "# two"), (VIEWER, "# one ")):
            self.typed(viewer, text)
            self.update(viewer)
            changed = self.saved()
        begin = self.original.index(b"\nshape_set")
        self.assertEqual(changed, self.original[:begin] + b"# one # two" + self.original[begin:])

        self.typed(SECOND, "nonsense ")
        self.update(SECOND)
        self.assertIn(b"{nonsense # one", self.saved())
        self.person.press(VIEWER, "ctrl+z")
        self.assertEqual(self.saved(), changed)

    def ball(self):
        """The middle of the left one of the two balls, in the host's window."""
        def seen():
            left, top, *_ = self.person.widget(HOST, "pages").rect
            picture = self.person.picture(HOST, "pages")
            spots = sorted(picture.greySpots()) if picture else []
            ball = [spot for spot in spots if spot[0] < spots[0][0] + 60]
            return ball and [first + sum(one) / len(ball) for first, one in zip((left, top), zip(*ball))]

        return until("a ball is seen", seen)

    def test_a_body_is_dragged_in_the_documents_own_picture(self):
        x, y = self.ball()
        self.person.press(HOST, "Escape")
        self.person.click(HOST, (x, y))
        self.person.click(HOST, (x, y), button=3)
        self.person.choose("Handles", "Positions")
        until("positions have handles", lambda: self.person.action(HOST, "Asgard", "Handles", "Positions").checked)
        self.person.offered(HOST, "Asgard", "Play")  # the motion is known
        self.assertFalse(self.isModified())
        x, y = self.ball()  # the picture may be another since it was clicked
        held = self.person.drag(HOST, (x, y), (x + 24, y - 40), key="shift")
        self.assertFalse(any(window.modified for window in held))  # not before it is let go
        changed = self.saved()
        self.assertNotEqual(changed, self.original)
        place = rb"(body b2 .*-init_pos) \\\{[-0-9. ]*\\\}"
        self.assertRegex(changed, place)
        self.assertEqual(re.sub(place, rb"\1", changed), re.sub(place, rb"\1", self.original))
        self.person.press(HOST, "ctrl+z")
        self.assertEqual(self.saved(), self.original)

    def kept(self):
        """The journal's bytes: the document's text, and what the host was told of the medium's windows."""
        journal = os.path.join(self.folder.name, ".local", "state", "ensemble", "unsaved")
        for name in os.listdir(journal):
            if name.endswith(".kept"):
                with open(os.path.join(journal, name), "rb") as file:
                    return file.read()
        return b""

    def test_a_dead_medium_takes_no_text_and_no_draft_with_it(self):
        self.openViewer()
        self.typed(VIEWER, "# kept")
        self.update(VIEWER)
        until("the document is modified", self.isModified)
        self.typed(VIEWER, "# typed ")
        until("the host keeps the draft", lambda: b"# typed " in self.kept())
        ensemble = self.person.program.pid
        before = children(ensemble)
        for pid in before:
            os.kill(pid, signal.SIGKILL)
        until("another process is there", lambda: set(children(ensemble)) - set(before))
        until("the draft is there again", lambda: self.person.isModified(VIEWER))
        self.update(VIEWER)
        until("the host knows that the draft is in the text",
              lambda: b"{# typed # kept" in self.kept() and self.kept().count(b"# typed ") == 1)
        self.assertIn(b"{# typed # kept\nshape_set", self.saved())
        self.typed(VIEWER, "# and on ")
        self.update(VIEWER)
        self.assertIn(b"{# and on # typed # kept\nshape_set", self.saved())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
