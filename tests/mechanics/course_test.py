#!/usr/bin/env python3
"""Checks that each scene of docs/mechanics.md is there, has values from elsewhere and an answer, and that no scene is left out.

usage: course_test.py ROOT

Values are NAME.values beside the scene, of the gallery's in this folder, of tests/reference NAME.ref.csv. All scenes of the
gallery's course and of course/ must be on the page, once each.
"""
import glob
import os
import re
import sys

ROW = re.compile(r"^\| (.+?) \| `([\w/-]+)\.al` \| (.+?) \|$", re.M)
GALLERY = os.path.join("medium-asgard", "samples", "mechanics")
MECHANICS = os.path.join("tests", "mechanics")
LEAST = 160


def places(name):
    """The scene and its values, without their extensions."""
    folder, _, scene = name.rpartition("/")
    if not folder:
        return os.path.join(GALLERY, scene), os.path.join(MECHANICS, scene)
    within = os.path.join("tests", folder) if folder != "course" else os.path.join(MECHANICS, folder)
    return os.path.join(within, scene), os.path.join(within, scene)


def lines_of(path):
    if not os.path.exists(path):
        return 0
    with open(path, encoding="utf-8") as file:
        return sum(1 for line in file if line.strip())


def faults(root, page):
    rows = [match.groups() for match in ROW.finditer(page)]
    names = [name for _, name, _ in rows]
    if len(rows) < LEAST:
        yield f"the page has {len(rows)} scenes, not {LEAST}"
    lines = [line for line in page.splitlines() if line.startswith("|") and not line.startswith(("| scene |", "|---"))]
    if len(lines) != len(rows):
        yield f"{len(lines) - len(rows)} rows of the page are no scene with a file and an answer"
    for name in sorted({name for name in names if names.count(name) > 1}):
        yield f"{name} is on the page twice"
    for name in names:
        scene, values = (os.path.join(root, place) for place in places(name))
        if not lines_of(scene + ".al"):
            yield f"{name}: there is no scene"
        # A table begins with the names of its columns.
        if not lines_of(values + ".values") and lines_of(values + ".ref.csv") < 2:
            yield f"{name}: there are no values"
    for folder, prefix in ((GALLERY, ""), (os.path.join(MECHANICS, "course"), "course/")):
        found = glob.glob(os.path.join(root, folder, "*.al"))
        if not found:
            yield f"{folder} has no scenes"
        for path in sorted(found):
            if prefix + os.path.basename(path)[:-len(".al")] not in names:
                yield f"{path} is not on the page"


def main():
    root = sys.argv[1]
    with open(os.path.join(root, "docs", "mechanics.md"), encoding="utf-8") as file:
        found = list(faults(root, file.read()))
    for fault in found:
        print("FAIL " + fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
