#!/usr/bin/env python3
"""`asgard explain`: what it says of the scenes in explain/, held against the texts beside them.

usage: explain_test.py PATH-TO-ASGARD [--write | unittest arguments]

The texts are what the engine should say; --write writes them again, to be read before they are kept.
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

ASGARD, WRITE = None, False
HERE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "explain")


def run(scene, *arguments):
    return subprocess.run([ASGARD, "explain", scene, *arguments], capture_output=True, text=True, timeout=60)


def without_counts(text):
    """Where something is integrated, counts and method are the engine's affair; the texts have # for them."""
    if "integrated by" not in text:
        return text
    text = re.sub(r"\d+ steps?, \d+ evaluations?", "# steps, # evaluations", text)
    text = re.sub(r"in \d+ tests?\.", "in # tests.", text)
    return re.sub(r"integrated by \S+ \(order \d+\)", "integrated by #", text)


class Explain(unittest.TestCase):
    def compare(self, name):
        ran = run(os.path.join(HERE, name + ".al"))
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        if WRITE:
            with open(os.path.join(HERE, name + ".txt"), "w", encoding="utf-8") as file:
                file.write(without_counts(ran.stdout))
        with open(os.path.join(HERE, name + ".txt"), encoding="utf-8") as file:
            self.assertEqual(without_counts(ran.stdout), file.read())

    def test_a_ballistic_ball_takes_no_step(self):
        self.compare("ballistic")

    def test_two_pendulums_are_one_kind_and_lie_in_their_plane(self):
        self.compare("two-pendulums")

    def test_a_block_that_friction_stops(self):
        self.compare("friction")

    def test_the_memo_of_the_dissertation(self):
        self.compare("memo")

    def test_the_rods_and_the_ball_of_the_dissertation(self):
        self.compare("pend")

    def test_json_says_the_same_with_every_component(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "out.json")
            ran = run(os.path.join(HERE, "pend.al"), "--json", path)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            with open(path, encoding="utf-8") as file:
                told = json.load(file)
        self.assertEqual(list(told), ["components", "not_modelled", "pairs"])
        self.assertEqual(list(told["pairs"]), ["candidates", "tested", "never"])
        for component in told["components"]:
            self.assertEqual(list(component), ["unknowns", "reads", "equations", "model", "method", "order", "steps",
                                               "evaluations", "why"])
            self.assertEqual(len(component["unknowns"]), len(component["equations"]))
            if component["model"] == "closed-form":
                self.assertEqual(component["steps"], 0)
        modelled = [u for component in told["components"] for u in component["unknowns"]]
        left = [u for entry in told["not_modelled"] for u in entry["what"].split(", ")]
        self.assertEqual(len(set(modelled + left)), 3 * 13)
        self.assertIn({"a": "b1", "b": "b2", "why": "linked"}, told["pairs"]["never"])

    def test_a_parameter_changes_what_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "push.al")
            with open(path, "w", encoding="utf-8") as file:
                file.write("simulator -finish 1\nparameter push -value 0 -min 0 -max 9\n"
                           "shape_set ball -desc {-sub {-sphere 1}}\nbody b ball\nforce -body b -y {push * t}\n")
            self.assertIn("b.dy", run(path).stdout.split("Not modelled:")[1])
            moved = run(path, "--set", "push=2").stdout
            self.assertIn("b.dy' =", moved.split("Not modelled:")[0])
            self.assertEqual(run(path, "--set", "push=99").returncode, 1)

    def test_what_cannot_be_read_is_refused(self):
        self.assertEqual(run("no-such-file.al").returncode, 1)
        self.assertEqual(subprocess.run([ASGARD, "explain"], capture_output=True).returncode, 2)


if __name__ == "__main__":
    ASGARD = os.path.abspath(sys.argv.pop(1))
    WRITE = "--write" in sys.argv
    sys.argv = [a for a in sys.argv if a != "--write"]
    unittest.main(verbosity=1)
