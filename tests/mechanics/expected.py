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
import exchange_cases  # noqa: E402
import mechanism_cases  # noqa: E402
import motion_cases  # noqa: E402
import rubbing_cases  # noqa: E402
import simple_cases  # noqa: E402
import standing_cases  # noqa: E402
import swinging_cases  # noqa: E402
import vibration_cases  # noqa: E402

# By the folder of their values: the scenes of the gallery, and those that stand in course/.
MODULES = {HERE: (simple_cases, mechanism_cases, swinging_cases, standing_cases, everyday_cases, clock_cases),
           os.path.join(HERE, "course"): (motion_cases, rubbing_cases, exchange_cases, vibration_cases)}


def scenes():
    """Folder and function by scene: `yo_yo` is the function of yo-yo.al."""
    return {name.replace("_", "-"): (folder, function) for folder, modules in MODULES.items() for module in modules
            for name, function in vars(module).items()
            if callable(function) and function.__module__ == module.__name__ and not function.__code__.co_argcount}


def main():
    found = scenes()
    for name in sys.argv[1:] or found:
        folder, function = found[name]
        with open(os.path.join(folder, name + ".values"), "w", encoding="utf-8") as file:
            file.write("".join(f"{t!r} {scale:.3g} {value!r} {expression}\n" for t, expression, value, scale in function()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
