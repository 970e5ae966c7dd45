#!/usr/bin/env python3
"""Writes NAME.values: what each scene of the mechanics course must give, computed without the engine.

usage: expected.py [NAME ...]

The lines are those of ../joints/expected.py, and so is the module that solves differential equations.
"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, os.pardir, "joints"))

import clock_cases  # noqa: E402
import everyday_cases  # noqa: E402
import mechanism_cases  # noqa: E402
import simple_cases  # noqa: E402
import standing_cases  # noqa: E402
import swinging_cases  # noqa: E402

MODULES = (simple_cases, mechanism_cases, swinging_cases, standing_cases, everyday_cases, clock_cases)


def scenes():
    """Function by scene: `yo_yo` is the function of yo-yo.al."""
    return {name.replace("_", "-"): function for module in MODULES for name, function in vars(module).items()
            if callable(function) and function.__module__ == module.__name__ and not function.__code__.co_argcount}


def main():
    found = scenes()
    for name in sys.argv[1:] or found:
        with open(os.path.join(HERE, name + ".values"), "w", encoding="utf-8") as file:
            file.write("".join(f"{t!r} {scale:.3g} {value!r} {expression}\n" for t, expression, value, scale in found[name]()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
