#!/usr/bin/env python3
"""Fails where a line of a page (a file NAME.md) is longer than 120 characters.

usage: check_lines.py ROOT

Rows of tables and the targets of links cannot be broken, so they do not count. Prints each violation as
file:line: sentence.
"""
import os
import re
import sys

LONGEST = 120
TARGET = re.compile(r"\]\([^)]*\)|<?https?://\S+")


def violations(text):
    """(line, its length) for each line that is too long."""
    for number, line in enumerate(text.split("\n"), 1):
        length = len(TARGET.sub("", line))
        if length > LONGEST and not line.lstrip().startswith("|"):
            yield number, length


def pages(root):
    for here, folders, files in os.walk(root):
        # Builds hold pages of others; folders that begin with a point hold no page of ours.
        folders[:] = [f for f in folders if not f.startswith(".") and not (here == root and f in ("build", "shared"))]
        for file in files:
            if file.endswith(".md"):
                yield os.path.relpath(os.path.join(here, file), root)


def main():
    root, faults, seen = sys.argv[1], 0, 0
    for path in sorted(pages(root)):
        seen += 1
        with open(os.path.join(root, path), encoding="utf-8") as f:
            for number, length in violations(f.read()):
                print(f"{path}:{number}: the line has {length} characters: break it before the {LONGEST + 1}st")
                faults += 1
    assert seen > 30, "this is no root of the project"
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
