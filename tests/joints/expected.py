#!/usr/bin/env python3
"""Writes NAME.values beside NAME.al: what each scene must give, computed without the engine.

usage: expected.py [NAME ...]

A line has a time, a scale, a value and an expression: at accuracy A the run's value may be off by A times the scale. Values are
closed forms, or own integrations of the least coordinates (integration.py).
"""
import math
import os
import sys

import cases
import rope_cases
import servo_cases

BY_NAME = cases.BY_NAME | {case.__name__: case for case in rope_cases.CASES + servo_cases.CASES}
HERE = os.path.dirname(os.path.abspath(__file__))


def written(rows):
    return "".join(f"{t!r} {scale:.3g} {value!r} {expression}\n" for t, expression, value, scale in rows)


def main():
    for name in sys.argv[1:] or BY_NAME:
        with open(os.path.join(HERE, name + ".values"), "w", encoding="utf-8") as file:
            file.write(written(BY_NAME[name]()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
