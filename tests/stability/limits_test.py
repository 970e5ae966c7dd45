#!/usr/bin/env python3
"""Limits of methods, predicted and measured (docs/numerics/measurements.md, Stability).

A prediction comes from the method's own formula on the linear model of the scene, the measurement
from whole runs of asgard.

usage: limits_test.py PATH-TO-ASGARD [unittest arguments]
"""
import csv
import io
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest

ASGARD = None

OSCILLATOR = """simulator -start 0 -finish 10 -collisions 0
shape_set ball -desc {-sub {-sphere 0.5}}
body b ball -mass 1 -init_pos {1 0 0}
force -body b -x {-100*b.x}
"""

# Two rods, 1 m by 0.1 by 0.1, 1 kg, hang from the origin, a little aside.
PENDULUM = """simulator -start 0 -finish 1 -collisions 0
parameter k -value 5000
shape_set rod -desc {-sub {-box {0.1 1 0.1}}}
body a rod -mass 1 -init_pos {0 -0.5 0} -init_dpos {0.001 0 0}
body b rod -mass 1 -init_pos {0 -1.5 0}
link -body1 a -offset1 {0 0.5 0} -x 0 -y 0 -z 0 -tightness $k
link -body1 b -offset1 {0 0.5 0} -body2 a -offset2 {0 -0.5 0} -tightness $k
force -body a -y -10
force -body b -y -10
"""

# A rod on a stiff link, pulled a micrometre along it: critically damped, both eigenvalues -sqrt(k).
STRETCHED = """simulator -start 0 -finish 1 -collisions 0
shape_set rod -desc {-sub {-box {0.1 1 0.1}}}
body a rod -mass 1 -init_pos {0 -0.500001 0}
link -body1 a -offset1 {0 0.5 0} -x 0 -y 0 -z 0 -tightness 1e8
"""



# The two rods turn as one, so fast that stiff directions turn within a long step.
SWING = (PENDULUM.replace("-value 5000", "-value 1e8").replace("-init_dpos {0.001 0 0}", "-init_dpos {2.85 0 0} -init_drot {0 0 5.7}")
         .replace("-1.5 0}", "-1.5 0} -init_dpos {8.55 0 0} -init_drot {0 0 5.7}").replace("-finish 1", "-finish 0.5"))


def chain(count):
    """That many rods, hanging as PENDULUM's do."""
    lines = [PENDULUM.split("body a")[0]]
    for n in range(count):
        lines.append(f"body {chr(97 + n)} rod -mass 1 -init_pos {{0 {-0.5 - n} 0}}"
                     + (" -init_dpos {0.001 0 0}" if n == 0 else ""))
    for n in range(count):
        end = f"-body2 {chr(96 + n)} -offset2 {{0 -0.5 0}}" if n else "-x 0 -y 0 -z 0"
        lines.append(f"link -body1 {chr(97 + n)} -offset1 {{0 0.5 0}} {end} -tightness $k")
        lines.append(f"force -body {chr(97 + n)} -y -10")
    return "\n".join(lines) + "\n"


def times(matrix, x):
    return [sum(a * b for a, b in zip(row, x)) for row in matrix]


def links(k, count):
    """x'' = -W(k x + C x') of the links' sideways extensions: W, and the diagonal of C."""
    inertia, arm = (1 + 0.01) / 12, 0.5
    own, between = 1 + arm**2 / inertia, 1 - arm**2 / inertia
    # Link n pulls rod n at its upper end, against the lower one of rod n - 1.
    w = [[0] * count for _ in range(count)]
    for n in range(count):
        w[n][n] = 2 * own if n else own
        if n:
            w[n][n - 1] = w[n - 1][n] = -between
    return w, [2 * math.sqrt(k / (2 if n else 1)) for n in range(count)]


def rates(model, state):
    k, w, c = model
    x, v = state[:len(c)], state[len(c):]
    return list(v) + [-a for a in times(w, [k * xi + ci * vi for xi, ci, vi in zip(x, c, v)])]


def euler(model, h, y):
    return [a + h * b for a, b in zip(y, rates(model, y))]


def symplectic(model, h, y):
    half = len(y) // 2
    v = euler(model, h, y)[half:]
    return [x + h * u for x, u in zip(y[:half], v)] + v


def rk4(model, h, y):
    move = lambda by, slope: [a + by * b for a, b in zip(y, slope)]
    k1 = rates(model, y)
    k2 = rates(model, move(h / 2, k1))
    k3 = rates(model, move(h / 2, k2))
    k4 = rates(model, move(h, k3))
    return [a + h / 6 * (p + 2 * q + 2 * r + s) for a, p, q, r, s in zip(y, k1, k2, k3, k4)]


def bisect(low, high, fails, steps):
    for _ in range(steps):
        middle = (low + high) / 2
        low, high = (low, middle) if fails(middle) else (middle, high)
    return (low + high) / 2


def predicted(step, k, count=2):
    """The step from which on the linear map grows."""
    model, rounds = (k, *links(k, count)), 4000 if count == 2 else 1200

    def grows(h):
        y, growth = [math.sin(1 + n) for n in range(2 * count)], 0
        for n in range(rounds):
            y = step(model, h, y)
            # Velocities count by what they are to extensions.
            size = max(abs(a) / (1 if i < count else math.sqrt(k)) for i, a in enumerate(y))
            y = [a / size for a in y]
            growth += math.log(size) if n >= rounds / 2 else 0
        return growth > 0
    return bisect(0.1 / math.sqrt(k), 2 / math.sqrt(k), grows, 24 if count == 2 else 14)


def fastest(k, count=2):
    """The largest rate of the links' linear model, by powers of (1 + rates/r)."""
    model = (k, *links(k, count))
    y = [math.sin(1 + n) for n in range(2 * count)]
    for _ in range(3000):
        y = rates(model, y)
        size = max(abs(a) / (1 if i < count else math.sqrt(k)) for i, a in enumerate(y))
        y = [a / size for a in y]
    return size


class Limits(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def run_asgard(self, command, scene, *arguments):
        path = os.path.join(self.folder, "scene.al")
        with open(path, "w", encoding="utf-8") as file:
            file.write(scene)
        return subprocess.run([ASGARD, command, path, *arguments], capture_output=True, text=True, timeout=200)

    def rows(self, scene, method, step, *arguments):
        ran = self.run_asgard("simulate", scene, "--method", method, "--fixed-step", repr(step), *arguments)
        return ran.returncode, [{name: float(cell) if cell else math.nan for name, cell in row.items()}
                                for row in csv.DictReader(io.StringIO(ran.stdout))]

    def fails(self, scene, method, step, finish):
        """Does the upper rod, which hangs all but still, leave its place? Swinging bounds what grows."""
        code, rows = self.rows(scene, method, step, "--finish", repr(finish), "--quantities", "a.y", "--only")
        return code != 0 or any(not abs(r["a.y"] + 0.5) < 0.05 for r in rows)

    def measured(self, scene, method, k, expected):
        scene = scene.replace("-value 5000", f"-value {k}")
        finish = 4000 * expected
        return bisect(0.9 * expected, 1.1 * expected,
                      lambda h: self.fails(scene, method, h, finish), 6)

    def check_pendulum(self, method, step, k, count=2):
        expected = predicted(step, k, count)
        found = self.measured(PENDULUM if count == 2 else chain(count), method, k, expected)
        self.assertLess(abs(found / expected - 1), 0.02, f"{method} k={k}: {expected} predicted, {found} measured")

    # Rows 1 to 4: explicit methods on links. The dampers are ours (reduced mass), so the limits are
    # not the table's but those of the same formulas.
    def test_forward_euler_on_links(self):
        for k in (5e3, 1e6, 1e8):
            self.check_pendulum("forward-euler", euler, k)

    def test_rk4_on_links(self):
        for k in (5e3, 1e6, 1e8):
            self.check_pendulum("rk4", rk4, k)

    def test_symplectic_euler_on_links_with_explicit_damping(self):
        for k in (5e3, 1e6, 1e8):
            self.check_pendulum("symplectic-euler", symplectic, k)

    # Rows 5 and 6: a chain of ten.
    def test_explicit_methods_on_a_chain(self):
        for k in (5e3, 1e6):
            self.check_pendulum("rk4", rk4, k, 10)
        self.check_pendulum("forward-euler", euler, 1e6, 10)
        self.check_pendulum("symplectic-euler", symplectic, 1e6, 10)

    # Row 7: adaptive steps that stability binds are, in the mean, as long as it allows on the real axis.
    def test_adaptive_steps_stand_at_the_limit(self):
        for method, limit in (("dopri5", 3.307), ("tsit5", 3.507), ("dop853", 6.394)):
            for k in (1e6, 1e7):
                stats = os.path.join(self.folder, "stats.json")
                scene = PENDULUM.replace("-value 5000", f"-value {k}")
                self.run_asgard("simulate", scene, "--method", method, "--accuracy", "1e-3", "--stats", stats)
                with open(stats, encoding="utf-8") as file:
                    steps = max(c["steps"] for c in json.load(file)["component_list"])
                self.assertLess(abs(fastest(k) / steps / limit - 1), 0.03, f"{method} k={k}: {fastest(k) / steps}")

    # Row 8: 2/w.
    def test_symplectic_euler_on_an_oscillator(self):
        arguments = ("--finish", "4000", "--at", "0:4:4000")
        for step, stable in ((0.1999, True), (0.2001, False)):
            code, rows = self.rows(OSCILLATOR, "symplectic-euler", step, *arguments)
            self.assertEqual(code == 0 and all(abs(r["b.x"]) < 100 for r in rows), stable, step)

    # Row 9: 2 sqrt(2)/w.
    def test_rk4_on_an_oscillator(self):
        arguments = ("--finish", "4000", "--at", "0:4:4000")
        for step, stable in ((0.2827, True), (0.2830, False)):
            code, rows = self.rows(OSCILLATOR, "rk4", step, *arguments)
            self.assertEqual(code == 0 and all(abs(r["b.x"]) < 100 for r in rows), stable, step)

    def energy_change(self, method):
        _, rows = self.rows(OSCILLATOR, method, 0.01, "--finish", "10", "--at", "0:10:10")
        first, last = (0.5 * r["b.dx"] ** 2 + 50 * r["b.x"] ** 2 for r in rows)
        return last / first - 1

    # Rows 10 and 11: energy after 1000 steps with w h = 0.1.
    def test_energy_of_an_oscillator(self):
        self.assertAlmostEqual(self.energy_change("rk4"), -1000 * 0.1**6 / 72, delta=2e-7)
        self.assertAlmostEqual(self.energy_change("backward-euler"), (1 + 0.01) ** -1000 - 1, delta=1e-4)
        self.assertAlmostEqual(self.energy_change("trapezoidal"), 0, delta=1e-11)
        self.assertAlmostEqual(self.energy_change("midpoint"), 0, delta=1e-11)
        self.assertAlmostEqual(self.energy_change("tr-bdf2"), -7.3e-4, delta=0.5e-4)
        self.assertAlmostEqual(self.energy_change("radau5"), -2.8e-7, delta=0.2e-7)
        self.assertLess(abs(self.energy_change("symplectic-euler")), 0.11)

    def link_velocity(self, method, step, count):
        _, rows = self.rows(STRETCHED, method, step, "--finish", repr(count * step), "--quantities", "a.dy", "--only",
                            "--at", f"0:{step!r}:{count * step!r}")
        return [r["a.dy"] for r in rows]

    # Row 18: two equal eigenvalues z: R(z)^n (1 + n ...), step 21 over step 20.
    def test_ringing_of_the_trapezoidal_rule(self):
        for step, expected, within in ((1e-4, 0.350, 0.005), (1e-3, -0.700, 0.002), (1e-2, -1.009, 0.002)):
            v = self.link_velocity("trapezoidal", step, 22)
            self.assertAlmostEqual(v[21] / v[20], expected, delta=within, msg=step)

    # Row 19: L-stable methods are at rest after ten steps; the trapezoidal rule is not.
    def test_what_l_stable_methods_leave_of_a_stiff_start(self):
        self.assertGreater(abs(self.link_velocity("trapezoidal", 1e-2, 10)[10]), 1e-3)
        for method, most in (("backward-euler", 1e-11), ("tr-bdf2", 1e-11), ("sdirk4", 1e-9), ("radau5", 1e-9)):
            self.assertLess(abs(self.link_velocity(method, 1e-2, 10)[10]), most, method)

    def study(self, scene, *arguments):
        ran = self.run_asgard("study", scene, *arguments)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return list(csv.DictReader(io.StringIO(ran.stdout)))

    def status(self, scene, method, step, *arguments):
        row, = self.study(scene, "--methods", method, "--steps", repr(step), "--accuracies", "", *arguments)
        return row["status"]

    # What `study` says where theory knows it.
    def test_study_names_the_failure(self):
        stretched = STRETCHED.replace("-finish 1", "-finish 0.5")
        self.assertEqual(self.status(OSCILLATOR, "symplectic-euler", 0.21), "unstable")
        self.assertEqual(self.status(OSCILLATOR, "rk4", 0.29), "unstable")
        self.assertEqual(self.status(OSCILLATOR, "rk4", 0.001), "ok")
        self.assertEqual(self.status(stretched, "trapezoidal", 1e-2), "ringing")
        self.assertEqual(self.status(stretched, "midpoint", 1e-2), "ringing")
        self.assertEqual(self.status(stretched, "backward-euler", 1e-2), "ok")
        self.assertEqual(self.status(stretched, "forward-euler", 2.1e-4), "unstable")
        self.assertEqual(self.status(OSCILLATOR, "forward-euler", 1e-7, "--limit", "0.1"), "too_slow")
        self.assertEqual(self.status(SWING, "radau5", 0.1), "newton")
        self.assertEqual(self.status(SWING, "trapezoidal", 0.1), "newton")
        self.assertEqual(self.status(SWING, "rodas4", 0.05), "unstable")
        self.assertEqual(self.status(SWING, "tr-bdf2", 0.001), "ok")

    # At fixed steps, an error in the first digit is no result; what is not finite is called so.
    def test_study_calls_nothing_ok_that_is_worthless(self):
        self.assertEqual(self.status(OSCILLATOR, "forward-euler", 0.001), "not_reached")  # 1.0001^5000 is 1.65
        force = OSCILLATOR + "force -body b -y {sqrt(0.5-t)}\n"
        self.assertEqual(self.status(force, "rk4", 0.001), "not_finite")

    # Steps at the edge of stability leave an error that goes to and fro, within the accuracy.
    def test_study_calls_no_adaptive_explicit_method_ringing(self):
        for row in self.study(SWING, "--methods", "dop853,tsit5", "--accuracies", "1e-2,1e-4", "--steps", ""):
            self.assertEqual(row["status"], "ok", row)

    # Energy is the scene's own only where it knows the potential: a pendulum on gravity alone.
    def test_study_sees_energy_drift(self):
        kepler = """simulator -start 0 -finish 20 -collisions 0
shape_set ball -desc {-sub {-sphere 0.1}}
body a ball -mass 1 -init_dpos {0.3 0 0}
link -body1 a -x 1 -y 0 -z 0 -tightness 10 -damping 0
"""
        self.assertEqual(self.status(kepler, "backward-euler", 0.01), "drift")
        self.assertEqual(self.status(kepler, "midpoint", 0.01), "ok")

    def test_study_marks_one_row_for_auto(self):
        rows = self.study(OSCILLATOR, "--methods", "auto,dop853,rk4", "--accuracies", "1e-3,1e-5", "--steps", "0.01")
        self.assertEqual(list(rows[0]), "method,accuracy,step,error,seconds,steps,evaluations,status,auto".split(","))
        self.assertEqual(len(rows), 2 + 3 + 3)
        self.assertEqual(sum(int(row["auto"]) for row in rows), 1)
        for row in rows:
            self.assertEqual(row["accuracy"] == "", row["step"] != "")
            self.assertGreater(int(row["evaluations"]), 0)


if __name__ == "__main__":
    ASGARD = os.path.abspath(sys.argv.pop(1))
    unittest.main()
