#!/usr/bin/env python3
"""Fails where a line of a page (a file NAME.md) is longer than 120 characters.

usage: check_lines.py ROOT

Rows of tables and the targets of links cannot be broken, so they do not count. Prints each violation as
file:line: sentence.
"""
import re
import sys

from lint import files, report

LONGEST = 120
TARGET = re.compile(r"\]\([^)]*\)|<?https?://\S+")


def violations(text):
    """(line, its length) for each line that is too long."""
    for number, line in enumerate(text.split("\n"), 1):
        length = len(TARGET.sub("", line))
        if length > LONGEST and not line.lstrip().startswith("|"):
            yield number, length


def sentences(_, text):
    for number, length in violations(text):
        yield number, f"the line has {length} characters: break it before the {LONGEST + 1}st"


if __name__ == "__main__":
    root = sys.argv[1]
    sys.exit(report(root, files(root, [""], ".md"), sentences, least=30))
