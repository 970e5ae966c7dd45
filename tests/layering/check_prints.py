#!/usr/bin/env python3
"""Fails where a program prints by another way than medium-asgard/terminal.

usage: check_prints.py ROOT

What is printed may be a document's: terminal.h makes it fit for a terminal. Prints each violation as file:line: text.
"""
import os
import re
import sys

# The place that prints, the table of numbers that may go to standard output, and a tool for developers.
ALLOWED = {os.path.join("medium-asgard", "terminal", "terminal.cpp"), os.path.join("medium-asgard", "batch", "output.cpp"),
           os.path.join("host", "sgml", "round_trip_run.cpp")}
PRINTS = re.compile(r"\bstd::(cout|cerr|clog|print|println|puts|putchar)\b|\b(stdout|stderr)\b|(?<![\w.>])v?f?printf\(|\bputs\(|"
                    r"\bperror\(|\bpsignal\(|\bq(Warning|Debug|Info|Critical|Fatal)\(|\bqC(Warning|Debug|Info|Critical)\(|"
                    r"/dev/(stdout|stderr|tty)")


def main():
    root, faults, seen = sys.argv[1], 0, 0
    for top in ("host", "medium-asgard"):
        for here, _, files in os.walk(os.path.join(root, top)):
            for file in sorted(files):
                path = os.path.relpath(os.path.join(here, file), root)
                if not file.endswith((".h", ".cpp")) or file.endswith("_test.cpp") or path in ALLOWED:
                    continue
                seen += 1
                with open(os.path.join(root, path), encoding="utf-8") as f:
                    for number, line in enumerate(f, 1):
                        if PRINTS.search(line.split("//")[0]):
                            print(f"{path}:{number}: {line.strip()}: programs print by terminal/terminal.h")
                            faults += 1
    assert seen > 100, "this is no root of the project"
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
