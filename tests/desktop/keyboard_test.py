#!/usr/bin/env python3
"""A report with a heading, a formula, a table, a figure and a reference is written and exported by keys alone.

usage: keyboard_test.py PATH-TO-ENSEMBLE [unittest arguments]
"""
import base64
import os
import re
import sys
import tempfile
import unittest

from person import Person
from screen import until

ENSEMBLE = os.path.abspath(sys.argv[1])
WINDOW = "documentWindow"
EMPTY = ("DOCUMENT REPORT\n<REPORT>\n<TITLE>{Keys}</TITLE>\n<BODY>\n<PARAGRAPH>{}</PARAGRAPH>\n</BODY>\n</REPORT>\n")
DOT = base64.b64decode("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==")


class Keyboard(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = self.path("report.ens")
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(EMPTY)
        with open(self.path("dot.png"), "wb") as file:
            file.write(DOT)
        self.person = Person(self, self.folder.name, ENSEMBLE, [self.file], "1100x1000x24")
        self.person.activate(WINDOW)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def keys(self, *keys):
        self.person.press(WINDOW, *keys)

    def write(self, text):
        self.person.activate(WINDOW)
        self.person.type(text)

    def answer(self, dialog, text, *keys):
        """Types into the field that has the keyboard when the dialog opens."""
        self.person.window(dialog)
        self.person.activate(dialog)
        self.person.type(text)
        self.person.screen.do("key", *keys, "Return")
        self.person.gone(dialog)

    def saved(self):
        until("the document is modified", lambda: self.person.isModified(WINDOW))
        self.keys("ctrl+s")
        until("the document is saved", lambda: not self.person.isModified(WINDOW))
        with open(self.file, encoding="utf-8") as file:
            return file.read()

    def test_a_report_is_written_without_a_pointer(self):
        self.keys("ctrl+e", "ctrl+End")
        self.write("Falling")
        self.keys("ctrl+alt+1", "End", "Return")
        self.write("One")
        self.keys("Return")
        self.write("Two ")
        self.assertIn("<HEADING>{Falling}</HEADING>", self.saved())

        self.keys("Up", "End", "ctrl+shift+f")
        self.answer("formulaDialog", "E = m g h", "alt+n")
        self.assertRegex(self.saved(), r"\{E = m g h\}")

        self.keys("ctrl+End", "Home", "Return", "Up", "ctrl+F12")
        self.answer("tableDialog", "")
        self.write("alpha")
        self.keys("Tab")
        self.write("beta")
        self.assertRegex(self.saved(), r"(?s)<CELL.*alpha.*<CELL.*beta.*Two")

        self.keys("ctrl+End", "ctrl+shift+r")
        self.answer("referenceDialog", "Falling")
        self.assertRegex(self.saved(), r"(?s)Two .*<REF TO=")

        self.keys("ctrl+End", "ctrl+shift+i")
        dialogs = ("imageDialog", WINDOW)
        until("a file is asked for", lambda: any(one.active and one.name not in dialogs
                                                 for one in self.person.windows()))
        self.person.type(self.path("dot.png"))
        self.person.screen.do("key", "Return")
        self.answer("imageDialog", "A dot")
        self.assertRegex(self.saved(), r"(?s)<FIGURE.*<IMAGE[^>]*A dot")

        self.keys("ctrl+shift+e")
        self.person.window("Export PDF")
        self.person.screen.do("key", "Return")
        self.person.gone("Export PDF")
        until("there is a PDF", lambda: os.path.exists(self.path("report.pdf")))
        until("it is whole", lambda: re.search(rb"%%EOF\s*$", open(self.path("report.pdf"), "rb").read()))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
