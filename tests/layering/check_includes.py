#!/usr/bin/env python3
"""Fails when a file of a module includes a module of ours that the module does not declare to use.

usage: check_includes.py ROOT FOLDER MODULE[,MODULE...]

A module is a folder that holds a CMakeLists.txt with an asgard_module() call; its includes are written
"module/header.h". The first MODULE is the folder's own name. Prints each violation as file:line: text.
"""
import os
import re
import sys

INCLUDE = re.compile(r'^\s*#\s*include\s*["<]([A-Za-z_-]+)/[^">]+[">]')
CALL = re.compile(r'asgard_module\(\s*([A-Za-z_-]+)')


def modules(root):
    names = {}
    for top in ("common", "host", "medium-asgard"):
        for folder, _, files in os.walk(os.path.join(root, top)):
            if "CMakeLists.txt" in files:
                with open(os.path.join(folder, "CMakeLists.txt"), encoding="utf-8") as f:
                    for name in CALL.findall(f.read()):
                        names[name] = folder
    return names


def main():
    root, folder, allowed = sys.argv[1], sys.argv[2], set(sys.argv[3].split(","))
    ours = modules(root)
    others = [os.path.realpath(f) for f in ours.values()]
    faults = 0
    for here, folders, files in os.walk(folder):
        folders[:] = [d for d in folders if os.path.realpath(os.path.join(here, d)) not in others]
        for file in sorted(files):
            if not file.endswith((".h", ".cpp")):
                continue
            # Tests, and headers for them, may look further: what they use is declared as TEST_USES.
            if re.search(r"_(test|testing)\.|^testing\.h$", file):
                continue
            path = os.path.join(here, file)
            with open(path, encoding="utf-8") as f:
                for number, line in enumerate(f, 1):
                    match = INCLUDE.match(line)
                    if match and match.group(1) in ours and match.group(1) not in allowed:
                        print(f"{os.path.relpath(path, root)}:{number}: {line.strip()} "
                              f"is not allowed: {sys.argv[3].split(',')[0]} does not use {match.group(1)}")
                        faults += 1
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
