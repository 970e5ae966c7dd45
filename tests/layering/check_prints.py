#!/usr/bin/env python3
"""Fails where a program prints by another way than common/terminal.

usage: check_prints.py ROOT

What is printed may be a document's: terminal.h makes it fit for a terminal. Prints each violation as file:line: text.
"""
import os
import re
import sys

from lint import files, report

# The place that prints, the table of numbers that may go to standard output, and tools for developers.
ALLOWED = {os.path.join("common", "terminal", "terminal.cpp"), os.path.join("medium-asgard", "batch", "output.cpp"),
           os.path.join("host", "sgml", "round_trip_run.cpp"), os.path.join("host", "authoring", "write_at_length.cpp")}
PRINTS = re.compile(r"\bstd::(cout|cerr|clog|print|println|puts|putchar)\b|\b(stdout|stderr)\b|(?<![\w.>])v?f?printf\(|\bputs\(|"
                    r"\bperror\(|\bpsignal\(|\bq(Warning|Debug|Info|Critical|Fatal)\(|\bqC(Warning|Debug|Info|Critical)\(|"
                    r"/dev/(stdout|stderr|tty)")


def violations(_, text):
    for number, line in enumerate(text.split("\n"), 1):
        if PRINTS.search(line.split("//")[0]):
            yield number, line.strip() + ": programs print by terminal/terminal.h"


if __name__ == "__main__":
    root = sys.argv[1]
    sources = [path for path in files(root, ("common", "host", "medium-asgard"), (".h", ".cpp"))
               if not path.endswith("_test.cpp") and path not in ALLOWED]
    sys.exit(report(root, sources, violations, least=100))
