#!/usr/bin/env python3
"""`asgard explain`: what it says of the scenes in explain/, held against the texts beside them.

usage: explain_test.py PATH-TO-ASGARD [--write | unittest arguments]

The texts are what the engine should say; --write writes them again, to be read before they are kept.
"""
import json
import os
import platform
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
    text = re.sub(r"estimated at [1-9]\S*", "estimated at #", text)
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

    def test_what_acts_at_rest_and_in_motion(self):
        self.compare("acting")

    def explained(self, *lines, arguments=(), code=0):
        text = "shape_set s -desc {-sub {-sphere 1}}\n" + "\n".join(lines) + "\n"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "a.al")
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
            ran = run(path, *arguments)
        self.assertEqual((ran.returncode, ran.stderr == ""), (code, code == 0))
        return ran.stdout

    def test_small_terms_and_numbers_are_told(self):
        said = self.explained("body b s", "body c s -init_pos {5 0 0} -init_dpos {1e16 0 0}",
                              "simulator -finish 1 -collisions 0", "force -body b -x {-1e14*b.x + c.x}")
        self.assertIn("-1e+14*b.x + c.x", said)
        said = self.explained("simulator -finish 1", "body b s", "force -body b -x {sin(b.x)^1.23456789012e-310+1}")
        self.assertIn("e-310", said)

    def test_laws_with_other_numbers_are_not_the_same(self):
        scene = ["body b s", "body c s -init_pos {9 0 0}", "body d s -init_pos {18 0 0}",
                 "force -body b -gravitational {0 -9.81 0}", "force -body c -gravitational {0 -1000 0}",
                 "force -body d -gravitational {0 -9.81 0}"]
        self.assertIn("likewise d.dy\n    with other numbers c.dy", self.explained(*scene))
        self.assertIn("c.dy' = -1000", self.explained(*scene, arguments=("--all",)))

    def test_a_trajectory_holds_nothing_between_its_curves(self):
        scene = ("body b s", "trajectory p -bezier {{0 1 {0 0 0} {1 0 0}} {3 4 {5 5 5} {6 5 5}}}")
        self.assertIn("its place from t = 0 to 1, from 3 to 4\n", self.explained(*scene, "constrain b -pos p"))
        self.assertIn("its place from t = 0 to 5\n", self.explained(*scene, "constrain b -pos p -to 5"))

    def test_what_is_cut_says_how_to_see_it_whole(self):
        path = os.path.join(HERE, "pend.al")
        cut, whole = run(path).stdout, run(path, "--all").stdout
        self.assertIn("(--all shows all)", cut)
        self.assertNotIn("--all", whole)
        self.assertGreater(len(whole), len(cut))

    def test_a_long_force_hides_nothing_else(self):
        text = self.explained("shape_set plane -desc {-sub {-box {20 1 4}}}", "body plane plane -fixed 1 -init_pos {0 -1.5 0}",
                              "body b s -mass 1 -restitution 0", "force -body b -gravitational {0 -9.81 0}",
                              "force -body b -x {1e-9*(" + "+".join(f"sin({i}*t)" for i in range(1, 40)) + ")}")
        line = text.split("\n")[1]
        self.assertTrue(line.endswith(" (--all shows all)"), line)
        self.assertIn(" ...; plane, on which it ", line)

    def test_what_stopped_before_it_began_is_not_said_to_be_integrated(self):
        text = self.explained("body b s -mass 1", "force -body b -x {1/t}", code=1)
        self.assertIn("not solved: its motion stopped where it would have begun. 0 steps", text)
        self.assertNotIn("integrated by ,", text)

    def test_what_rests_is_not_said_to_be_exact_since_nothing_is_integrated(self):
        rests = self.explained("shape_set plane -desc {-sub {-box {20 2 4}}}", "body plane plane -fixed 1 -init_pos {0 -2 0}",
                               "body b s", "force -body b -gravitational {0 -9.81 0}")
        self.assertIn("estimated at 0; nothing is integrated, gaps of resting bodies are within", rests)

    def test_the_memo_of_the_dissertation(self):
        self.compare("memo")

    def test_the_rods_and_the_ball_of_the_dissertation(self):
        self.compare("pend")

    def test_every_form_of_an_expression_down_to_the_processors(self):
        scene = os.path.join(HERE, "friction.al")
        ran = run(scene, "--expressions", "block.dx")
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        # What is the same on every processor is held against a text; it has no line of an instruction.
        portable, code = [], []
        for line in ran.stdout.split("\n"):
            if not line.startswith(" "):
                listed = code if line.startswith("Machine code") else portable
            listed.append(line)
        if WRITE:
            with open(os.path.join(HERE, "expressions.txt"), "w", encoding="utf-8") as file:
                file.write("\n".join(portable))
        with open(os.path.join(HERE, "expressions.txt"), encoding="utf-8") as file:
            self.assertEqual("\n".join(portable), file.read())
        for heading in ("Names:", "Equations:", "Graph:", "Tape of the equations:"):
            self.assertIn(heading, portable)
        if platform.machine() == "x86_64":
            self.assertIn("Machine code of the equations:", code)
            self.assertIn("        ret", code)
            self.assertTrue(any(re.match(r"        v?mulsd xmm|        v?movsd ", line) for line in code))
            self.assertFalse(any(re.search(r"mov rax, \d", line) for line in code), "an address")
        interpreted = subprocess.run([ASGARD, "explain", scene, "--expressions", "block.dx"], capture_output=True,
                                     text=True, env={**os.environ, "ASGARD_INTERPRET": "1"})
        self.assertEqual(interpreted.stdout.split("\n"), portable)

    def test_derivatives_calls_and_a_body_that_stays(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "swing.al")
            with open(path, "w", encoding="utf-8") as file:
                file.write("simulator -finish 1\nshape_set ball -desc {-sub {-sphere 1}}\nbody b ball\n"
                           "body still ball -fixed 1\nforce -body b -x {cos(b.x)}\n")
            told = run(path, "--expressions", "b").stdout
            self.assertIn("    dy1'/dy0 = -(sin(y0)/c0)", told)
            if platform.machine() == "x86_64":
                self.assertRegex(told, r"mov rax, cos\n +call rax\n")
                self.assertRegex(told, r"mov rax, sin\n +call rax\n")
            self.assertIn("Nothing of still is computed", run(path, "--expressions", "still").stdout)
            self.assertEqual(run(path, "--expressions", "nobody").returncode, 1)
            told = json.loads(run(path, "--expressions", "b.x", "--json", "-").stdout)
            self.assertEqual(told["expressions"][0]["unknowns"], ["b.x", "b.dx"])

    def test_what_is_only_seen_is_said_to_be(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "tumble.al")
            text = ("simulator -finish 1\nshape_set brick -desc {-sub {-box {1 2 3}}}\n"
                    "body b brick -init_drot {1 2 3}\n")
            for force, seen in (("{-b.y}", True), ("{-b.y*b.qw}", False)):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text + f"force -body b -y {force}\n")
                self.assertEqual("to be seen" in run(path).stdout, seen)

    def test_json_says_the_same_with_every_component(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "out.json")
            ran = run(os.path.join(HERE, "pend.al"), "--json", path)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            with open(path, encoding="utf-8") as file:
                told = json.load(file)
        self.assertEqual(list(told), ["acting", "components", "not_modelled", "pairs"])
        self.assertEqual(list(told["pairs"]), ["candidates", "tested", "left_out", "never"])
        for component in told["components"]:
            self.assertEqual(list(component), ["unknowns", "reads", "equations", "earlier", "model", "method", "order", "steps",
                                               "evaluations", "why"])
            self.assertEqual(len(component["unknowns"]), len(component["equations"]))
            if component["model"] == "closed-form":
                self.assertEqual(component["steps"], 0)
        modelled = [u for component in told["components"] for u in component["unknowns"]]
        left = [u for entry in told["not_modelled"] for u in entry["what"].split(", ")]
        self.assertEqual(len(set(modelled + left)), 3 * 13)
        self.assertIn({"a": "b1", "b": "b2", "why": "linked"}, told["pairs"]["never"])

    def test_joints_and_gears_are_why_two_never_meet(self):
        text = "shape_set s -desc {-sub {-box {1 1 1}}}\n" + "".join(
            f"body {name} s -init_pos {{{0.6 * k} 0 0}}\n" for k, name in enumerate("abc")) + (
            "joint h -type hinge -body1 a -body2 b\njoint i -type hinge -body1 c\ngear g -joint1 h -joint2 i -ratio 1\n")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "gears.al")
            with open(path, "w", encoding="utf-8") as file:
                file.write("simulator -finish 0.1\n" + text)
            told = run(path).stdout
        self.assertIn("never, since joints join them: a-b", told)
        self.assertIn("never, since a gear couples them: a-c", told)

    def test_a_parameter_changes_what_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "push.al")
            with open(path, "w", encoding="utf-8") as file:
                file.write("simulator -finish 1\nparameter push -value 0 -min 0 -max 9\n"
                           "shape_set ball -desc {-sub {-sphere 1}}\nbody b ball\nforce -body b -y {push * t}\n")
            self.assertIn(", dy,", run(path).stdout.split("Not modelled:")[1])
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
