#!/usr/bin/env python3
"""check_lines.py finds long lines of prose and code, and neither tables nor links."""
import unittest

from check_lines import violations


class Lines(unittest.TestCase):
    def test_long_prose_and_code_are_found(self):
        text = "\n".join(["short", "a " * 61, "    " + "c" * 117])
        self.assertEqual(list(violations(text)), [(2, 122), (3, 121)])

    def test_tables_links_and_120_characters_are_not(self):
        text = "\n".join(["| " + "a " * 99, "[page](" + "b" * 130 + ")", "https://" + "c" * 130, "d" * 120, "é" * 120])
        self.assertEqual(list(violations(text)), [])


if __name__ == "__main__":
    unittest.main()
