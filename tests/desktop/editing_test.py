#!/usr/bin/env python3
"""A document is edited in the medium's own windows, as users do it: host, medium and viewers on a display.

usage: editing_test.py PATH-TO-ENSEMBLE PATH-TO-MEMO [unittest arguments]
"""
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from screen import Screen, until

ENSEMBLE, MEMO = os.path.abspath(sys.argv[1]), sys.argv[2]


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
        self.screen = Screen(self.folder.name)
        self.addCleanup(self.screen.close)
        self.ensemble = subprocess.Popen([ENSEMBLE, self.file], env=self.screen.environment, stdin=subprocess.DEVNULL)
        self.addCleanup(self.ensemble.wait)
        self.addCleanup(self.ensemble.kill)
        self.host = until("the document's window is there", lambda: self.screen.windows("memo.ens.*Ensemble"))[0]

    def bytes(self):
        with open(self.file, "rb") as file:
            return file.read()

    def title(self, window):
        return self.screen.output("xdotool", "getwindowname", window).decode()

    def press(self, window, *keys):
        def active():
            self.screen.output("xdotool", "windowactivate", window)
            return self.screen.output("xdotool", "getactivewindow").decode().strip() == window

        until(f"{self.title(window)} is active", active)
        self.screen.do("key", "--clearmodifiers", *keys)

    def typed(self, window, text):
        """At the beginning of the text."""
        self.press(window, "ctrl+Home")
        self.screen.do("type", "--clearmodifiers", "--delay", 10, text)

    def viewer(self):
        """The first language viewer, opened by the host's command as soon as there is such a command."""
        def opened():
            self.press(self.host, "ctrl+l")
            end = time.monotonic() + 5
            while time.monotonic() < end:
                if found := self.screen.windows("Language Viewer"):
                    return found
                time.sleep(0.1)
            return None

        return until("there is a language viewer", opened)[0]

    def is_modified(self):
        return "*" in self.title(self.host)

    def saved(self):
        """The file's bytes once the document is modified and the host has written what it has."""
        until("the document is modified", self.is_modified)
        self.press(self.host, "ctrl+s")
        until("the document is saved", lambda: not self.is_modified())
        return self.bytes()

    def test_an_update_is_a_step_of_the_documents_undo_and_changes_only_its_bytes(self):
        viewer = self.viewer()
        self.assertIn("memo.ens", self.title(viewer))
        # The text begins with an empty line; body b2 stands in its third.
        self.press(viewer, "ctrl+Home", "Down", "Down", "End")
        self.screen.do("type", "--clearmodifiers", "--delay", 10, " -color red")
        self.assertFalse(self.is_modified())  # a draft is nobody's but the viewer's
        self.press(viewer, "ctrl+Return")
        end = self.original.index(b"\nbody b3")
        changed = self.original[:end] + b" -color red" + self.original[end:]
        self.assertEqual(self.saved(), changed)

        self.press(self.host, "ctrl+z")
        self.assertEqual(self.saved(), self.original)
        self.press(viewer, "ctrl+shift+z")  # asked for in the medium's window, done by the host
        self.assertEqual(self.saved(), changed)
        self.press(viewer, "ctrl+z")
        self.assertEqual(self.saved(), self.original)

        # The viewer's text followed all of that: what is typed now is the only change.
        self.typed(viewer, "# {1} ")
        self.press(viewer, "ctrl+Return")
        begin = self.original.index(b"\nshape_set")
        self.assertEqual(self.saved(), self.original[:begin] + b"# \\{1\\} " + self.original[begin:])

    def test_viewers_stay_in_step_and_a_faulty_text_is_undone_like_any(self):
        one = self.viewer()
        self.press(one, "ctrl+l")
        two = until("there is a second viewer", lambda: self.screen.windows("Language Viewer 2"))[0]
        for viewer, text in ((two, "# two"), (one, "# one ")):
            self.typed(viewer, text)
            self.press(viewer, "ctrl+Return")
            changed = self.saved()
        begin = self.original.index(b"\nshape_set")
        self.assertEqual(changed, self.original[:begin] + b"# one # two" + self.original[begin:])

        self.typed(two, "nonsense ")
        self.press(two, "ctrl+Return")
        self.assertIn(b"{nonsense # one", self.saved())
        self.press(one, "ctrl+z")
        self.assertEqual(self.saved(), changed)

    def ball(self):
        """The middle of the left one of the two balls, in the host's window."""
        def seen():
            picture = self.screen.picture(self.host)
            spots = sorted(picture.greySpots()) if picture else []
            left = [spot for spot in spots if spot[0] < spots[0][0] + 60]
            return left and [sum(one) / len(left) for one in zip(*left)]

        return until("a ball is seen", seen)

    def test_a_body_is_dragged_in_the_documents_own_picture(self):
        x, y = (round(c) for c in self.ball())
        self.press(self.host, "Escape")
        self.screen.do("mousemove", "--window", self.host, x, y, "click", 1)
        before = set(self.screen.windows())
        self.screen.do("click", 3)
        until("the medium's menu opens", lambda: set(self.screen.windows()) - before)
        menus = set(self.screen.windows())
        self.screen.do("key", "--delay", 60, *["Up"] * 9, "Right")  # from the end: what is there is always enabled
        until("the menu of handles opens", lambda: set(self.screen.windows()) - menus)
        self.screen.do("key", "Return")
        until("the menu is closed", lambda: not set(self.screen.windows()) - before)
        time.sleep(1)
        self.assertFalse(self.is_modified())
        self.screen.do("mousemove", "--window", self.host, x, y, "keydown", "shift", "mousedown", 1)
        for step in range(1, 9):
            self.screen.do("mousemove", "--window", self.host, x + 3 * step, y - 5 * step)
            time.sleep(0.05)
        self.assertFalse(self.is_modified())  # not before it is let go
        self.screen.do("mouseup", 1, "keyup", "shift")
        changed = self.saved()
        self.assertNotEqual(changed, self.original)
        place = rb"(body b2 .*-init_pos) \\\{[-0-9. ]*\\\}"
        self.assertRegex(changed, place)
        self.assertEqual(re.sub(place, rb"\1", changed), re.sub(place, rb"\1", self.original))
        self.press(self.host, "ctrl+z")
        self.assertEqual(self.saved(), self.original)

    def test_a_dead_medium_takes_no_text_and_no_draft_with_it(self):
        viewer = self.viewer()
        self.typed(viewer, "# kept")
        self.press(viewer, "ctrl+Return")
        until("the document is modified", self.is_modified)
        self.typed(viewer, "# typed ")
        until("there is a draft", lambda: "*" in self.title(viewer))
        time.sleep(3)  # what is typed is kept within a second
        before = children(self.ensemble.pid)
        for pid in before:
            os.kill(pid, signal.SIGKILL)
        until("another process is there", lambda: set(children(self.ensemble.pid)) - set(before))
        again = until("its window is open again", lambda: self.screen.windows("Language Viewer"))[0]
        until("the draft is there", lambda: "*" in self.title(again))
        self.press(again, "ctrl+Return")
        until("the draft is in the document", lambda: "*" not in self.title(again))
        self.assertIn(b"{# typed # kept\nshape_set", self.saved())
        self.typed(again, "# and on ")
        self.press(again, "ctrl+Return")
        self.assertIn(b"{# and on # typed # kept\nshape_set", self.saved())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
