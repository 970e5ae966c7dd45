#!/usr/bin/env python3
"""The commands of asgard without a window: what they write, where, and how they end.

usage: commands_test.py PATH-TO-ASGARD [unittest arguments]
"""
import csv
import io
import json
import os
import resource
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

ASGARD = None

FLYING = """simulator -start 0 -finish 2
parameter speed -value 1 -min 0 -max 3
shape_set ball -desc {-sub {-sphere 0.5 -color red}}
body b ball -init_pos {1 2 3} -init_dpos [list $speed 0 0]
body wall ball -init_pos {9 9 9} -fixed 1
"""
COLUMNS = "x y z dx dy dz qw qx qy qz wx wy wz".split()


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.scene = self.file("flying.al", FLYING)

    def file(self, name, text):
        path = os.path.join(self.folder, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def run_asgard(self, *arguments, text=None):
        return subprocess.run([ASGARD, *arguments], input=text, capture_output=True, text=True, timeout=300, cwd=self.folder,
                              env={"PATH": os.environ.get("PATH", "")})

    def simulate(self, *arguments, code=0, text=None):
        ran = self.run_asgard("simulate", *arguments, text=text)
        self.assertEqual(ran.returncode, code, ran.stderr)
        return list(csv.reader(io.StringIO(ran.stdout, newline=""))), ran.stderr

    def test_windows_without_a_display_are_refused_in_words(self):
        ran = self.run_asgard(self.scene)
        self.assertEqual(ran.returncode, 1)
        self.assertRegex(ran.stderr, r"^asgard: there is no display to open a window on; .*\n$")

    def test_a_display_that_does_not_answer_is_named(self):
        ran = subprocess.run([ASGARD, self.scene], capture_output=True, text=True, timeout=100, env={"DISPLAY": ":4711"})
        self.assertEqual((ran.returncode, ran.stderr.partition(";")[0]), (1, "asgard: the display :4711 does not answer"))

    # --- simulate --------------------------------------------------------------------------------

    def test_the_table_has_thirteen_columns_for_each_body_and_101_rows(self):
        rows, _ = self.simulate(self.scene)
        self.assertEqual(rows[0], ["t"] + [f"{b}.{c}" for b in ("b", "wall") for c in COLUMNS])
        self.assertEqual(len(rows), 102)
        self.assertEqual((float(rows[1][0]), float(rows[-1][0])), (0, 2))
        first = dict(zip(rows[0], map(float, rows[1])))
        self.assertEqual([first[f"b.{c}"] for c in COLUMNS], [1, 2, 3, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0])
        last = dict(zip(rows[0], map(float, rows[-1])))
        self.assertAlmostEqual(last["b.x"], 3, places=3)
        self.assertEqual(last["wall.x"], 9)

    def test_times_are_those_asked_for_in_their_order(self):
        rows, _ = self.simulate(self.scene, "--at", "0:0.1:0.3")
        self.assertEqual([r[0] for r in rows[1:]], ["0", "0.10000000000000001", "0.20000000000000001", "0.29999999999999999"])
        times = self.file("some.times", "2\n0.5, 1\n")
        rows, _ = self.simulate(self.scene, "--times", times)
        self.assertEqual([float(r[0]) for r in rows[1:]], [2, 0.5, 1])

    def test_a_scene_comes_from_standard_input_and_the_same_bytes_every_time(self):
        a, b = (self.run_asgard("simulate", "-", text=FLYING).stdout for _ in (0, 1))
        self.assertEqual(a, b)
        self.assertEqual(a, self.run_asgard("simulate", self.scene).stdout)

    def test_parameters_are_set_within_their_bounds(self):
        rows, _ = self.simulate(self.scene, "--at", "0:1:2", "--set", "speed=2.5")
        self.assertAlmostEqual(float(rows[-1][1]), 6, places=2)
        for setting, code in (("speed=4", 1), ("speed=-1", 1), ("sped=1", 1), ("speed", 2), ("speed=x", 2)):
            self.refused(code, "--set", setting)

    def test_statistics_have_every_key(self):
        out = os.path.join(self.folder, "stats.json")
        self.simulate(self.scene, "--stats", out)
        with open(out, encoding="utf-8") as file:
            statistics = json.load(file)
        wanted = ("seconds seconds_reading steps rejected_steps discarded_steps evaluations equation_evaluations factorisations "
                  "pair_tests collisions components largest_component history_bytes reached error_estimate predictable_until "
                  "stops component_list")
        self.assertEqual(sorted(statistics), sorted(wanted.split()))

    def test_statistics_tell_who_stopped_and_that_not_all_is_reached(self):
        scene = os.path.join(self.folder, "stops.al")
        out = os.path.join(self.folder, "stops.json")
        with open(scene, "w", encoding="utf-8") as file:
            file.write("simulator -finish 4\nshape_set s -desc {-sub {-sphere 0.5}}\n"
                       "body a s -mass 1\nforce -body a -x {1e-3*sqrt(1-t)}\n"
                       "body b s -mass 1 -init_pos {4 0 0} -init_dpos {-2 0 0}\n"
                       "body c s -mass 1 -init_pos {0 9 0}\n")
        said = self.simulate(scene, "--stats", out, code=1)[1]
        self.assertIn("Stopped at t = 1: the force on body \"a\"", said)
        self.assertIn('A meeting with a stopped body stops 1 more body: "b", at t = ', said)
        with open(out, encoding="utf-8") as file:
            statistics = json.load(file)
        self.assertEqual([stop["body"] for stop in statistics["stops"]], ["a", "b"])
        self.assertEqual(statistics["reached"], statistics["stops"][0]["time"])
        self.assertAlmostEqual(statistics["stops"][1]["time"], 1.5, places=3)
        self.assertIn("meets \"a\"", statistics["stops"][1]["sentence"])
        self.assertEqual(self.stopsAtOnce(out)["error_estimate"], None)

    def stopsAtOnce(self, out):
        scene = os.path.join(self.folder, "at_once.al")
        with open(scene, "w", encoding="utf-8") as file:
            file.write("shape_set s -desc {-sub {-sphere 0.5}}\nbody a s -mass 1\nforce -body a -x {sqrt(-t)}\n")
        self.simulate(scene, "--stats", out, code=1)
        with open(out, encoding="utf-8") as file:
            statistics = json.load(file)
        self.assertEqual(statistics["reached"], 0)
        return statistics

    def refused(self, code, *arguments, scene=None):
        """Nothing is written and something is said."""
        out = os.path.join(self.folder, "out.csv")
        ran = self.run_asgard("simulate", scene or self.scene, "--csv", out, *arguments)
        self.assertEqual(ran.returncode, code, (arguments, ran.stderr))
        self.assertFalse(os.path.exists(out), arguments)
        self.assertEqual(ran.stdout, "")
        self.assertNotEqual(ran.stderr.strip(), "")
        return ran.stderr

    def test_what_is_refused_writes_nothing(self):
        self.refused(1, "--at", "0:1:3")
        self.refused(1, "--finish", "-1")
        self.refused(1, "--times", "absent.times")
        self.refused(1, scene="absent.al")
        self.refused(1, scene=self.file("bad.al", "body b"))
        for usage in (("--at", "0:0:1"), ("--at", "x"), ("--accuracy", "0"), ("--accuracy", "x"), ("--fixed-step", "0.1"),
                      ("--only",), ("--bogus",), ("--threads", "0"), ("--method", "rk4", "--fixed-step", "-1")):
            self.refused(2, *usage)

    def test_a_file_that_cannot_be_written_is_a_failure(self):
        ran = self.run_asgard("simulate", self.scene, "--csv", "/absent/out.csv")
        self.assertEqual(ran.returncode, 1)
        self.assertIn("/absent/out.csv", ran.stderr)
        ran = self.run_asgard("simulate", self.scene, "--csv", "/dev/full")
        self.assertEqual(ran.returncode, 1)

    # --- what a run says ---------------------------------------------------------------------------

    BALL = "shape_set s -desc {-sub {-sphere 0.1}}\nbody b s -mass 1\n"

    def told(self, *lines, finish=10, arguments=(), code=1):
        scene = self.file("told.al", f"simulator -finish {finish}\n" + self.BALL + "\n".join(lines) + "\n")
        _, said = self.simulate(scene, "--csv", "out.csv", *arguments, code=code)
        return said.replace(self.folder + "/", "")

    def test_a_force_that_has_no_value_is_named_at_its_place(self):
        for force, reason in (("sqrt(1-t)", "is not finite: its x, \"sqrt(1-t)\", is not a number"),
                              ("1/(2-t)", "its x, \"1/(2-t)\", is "), ("1/(2-t)^2", "its x, \"1/(2-t)^2\", is "),
                              ("10*b.x^2+1", "its x, \"10*b.x^2+1\", is ")):
            said = self.told("", "force -body b \\", "  -x {" + force + "}")
            self.assertRegex(said, r"^told\.al:6:6: error: Stopped at t = [0-9.]+: ")
            self.assertIn("the force on body \"b\"", said)
            self.assertIn(reason, said)
            self.assertIn("let the motion finish before (-finish)", said)
            self.assertNotIn("predictable", said)

    def test_warnings_of_a_run_have_a_place(self):
        said = self.told("body c s -init_pos {0.1 0 0} -mass 1", code=0)
        self.assertRegex(said, r"^told\.al:3:1: warning: Bodies \"b\" and \"c\" overlap")

    def test_what_never_ends_says_so_soon(self):
        orbit = ("force -body b -x {-(b.x-1)/hypot(b.x-1,b.y)^3} -y {-b.y/hypot(b.x-1,b.y)^3+0.01*sin(t)}",)
        stats = os.path.join(self.folder, "stats.json")
        said = self.told(*orbit, arguments=("--finish", "1e99", "--memory", "2", "--stats", stats))
        self.assertIn("takes 2 MB, which is the limit", said)
        self.assertIn("takes 2 MB, which is the limit", self.told(*orbit, arguments=("--memory", "2"), finish="1e99"))
        self.assertEqual(self.simulate(self.scene, "--finish", "1e300", code=2)[1],
                         "asgard: --finish wants a number of at most 1e100\n")
        self.assertIn(":1:19: error: -finish of the simulator wants a number of at most 1e100", self.told(finish="1e300"))
        with open(stats, encoding="utf-8") as file:
            self.assertLess(json.load(file)["steps"], 300_000)  # of all runs

    def test_what_flies_over_all_bounds_ends_there(self):
        said = self.told("body far s -init_pos {5 0 0} -init_dpos {1e50 0 0}", finish="1e60")
        self.assertIn("Stopped at t = 1e+50: far.x grows over 1e100.", said)
        rows, _ = self.simulate(os.path.join(self.folder, "told.al"), "--at", "0:4e59:8e59", "--quantities", "far.x", code=1)
        self.assertEqual(rows[2][14:], [""] * 14)

    def test_a_method_that_is_asked_for_says_that_its_error_is_unknown(self):
        said = self.told("force -body b -x {-b.x}", code=0, arguments=("--method", "forward-euler", "--fixed-step", "10"))
        self.assertEqual(said, "asgard: the error of forward-euler at steps of 10 is not estimated; "
                         "only the method auto estimates its error\n")

    def test_a_motion_says_in_one_line_how_accurate_it_is(self):
        said = self.told("force -body b -x {-9*sin(b.x)-1}", code=0, arguments=("--accuracy", "1e-6"))
        self.assertRegex(said, r"^asgard: accurate to [0-9.]+e-[0-9]+ of [0-9.]+ m over 10 s, asked 1e-6\n$")
        said = self.told(code=0)
        self.assertEqual(said, "asgard: accurate to rounding over 10 s, asked 1e-4\n")

    def test_a_link_that_stretched_is_named_with_the_joint_that_would_not(self):
        scene = self.file("soft.al", "simulator -finish 2\nshape_set rod -desc {-sub {-box {1 0.1 0.1}}}\nbody a rod -init_pos {0.5 0 0}\n"
                          "link -body1 a -offset1 {-0.5 0 0} -x 0 -y 0 -z 0 -tightness 200\nforce -body a -gravitational {0 -9.81 0}\n")
        said = self.run_asgard("simulate", scene, "--csv", os.devnull).stderr
        self.assertRegex(said, r'^asgard: the link of body "a" \(line 4\) stretched by 0\.00[0-9]+ m; if it is meant as a hinge, '
                               r"a joint does not stretch: joint NAME -type ball -body1 a -offset1 {-0\.5 0 0}\n")

    def test_joints_are_closed_in_the_text(self):
        scene = self.file("open.al", "shape_set rod -desc {-sub {-box {1 0.1 0.1}}}\nset high 0.2 ;# kept\n"
                          "body a rod -init_pos [list 0.5 $high 0]\njoint pin -type hinge -body1 a -offset1 {-0.5 0 0} -offset2 {0 0 0}\n")
        self.assertIn("miss each other by 0.2", self.run_asgard("simulate", scene, "--csv", os.devnull).stderr)
        ran = self.run_asgard("assemble", scene)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        with open(scene, encoding="utf-8") as file:
            text = file.read()
        self.assertRegex(text, r"set high [0-9.e-]+ ;# kept\nbody a rod -init_pos \[list [0-9.]+ \$high 0\]")
        self.assertTrue(os.path.exists(scene + "~"))
        ran = self.run_asgard("simulate", scene, "--csv", os.devnull, "--verbose")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        self.assertIn("all joints are closed", self.run_asgard("assemble", scene).stderr)

    def test_places_that_a_loop_makes_are_the_authors(self):
        pendulums = ("shape_set rod -desc {-sub {-box {1 0.1 0.1}}}\nforeach {b x} {a 0.6 b 1.6} {\n    body $b rod -init_pos [list $x 0 0]\n}\n"
                     "joint pin -type hinge -body1 a -offset1 {-0.5 0 0} -offset2 {0 0 0}\n"
                     "joint next -type hinge -body1 b -offset1 {-0.5 0 0} -body2 a -offset2 {0.5 0 0}\n")
        said = self.run_asgard("simulate", self.file("loop.al", pendulums), "--csv", os.devnull).stderr
        self.assertIn('miss each other by 0.1 at the start; place them so that the joint closes, by hand, since line 3 makes "a" and other bodies at once', said)
        self.assertNotIn("asgard assemble", said)
        boxes = ("shape_set box -desc {-sub {-box {1 1 1}}}\nforeach {b x} {a 0 b 0.9} {\n    body $b box -init_pos [list $x 0 0]\n}\n")
        said = self.run_asgard("check", self.file("boxes.al", boxes)).stdout
        self.assertIn('place them apart, by hand, since line 3 makes "a" and other bodies at once.', said)

    def test_a_motion_says_in_one_line_up_to_when_it_is_accurate(self):
        chaos = ("-29.43*sin(a.x) - 9.81*sin(a.x-2*b.x) - 2*sin(a.x-b.x)*(b.dx^2+a.dx^2*cos(a.x-b.x))",
                 "2*sin(a.x-b.x)*(2*a.dx^2+19.62*cos(a.x)+b.dx^2*cos(a.x-b.x))")
        scene = self.file("chaos.al", "simulator -finish 40 -collisions 0\nshape_set s -desc {-sub {-sphere 0.1}}\n"
                          "body a s -mass 1 -init_pos {2.1 0 0}\nbody b s -mass 1 -init_pos {3 0 1}\n" +
                          "".join(f"force -body {body} -x {{({force})/(3-cos(2*a.x-2*b.x))}}\n" for body, force in zip("ab", chaos)))
        said = self.run_asgard("simulate", scene, "--csv", os.devnull).stderr.split("\n")[-2]
        self.assertRegex(said, r"^asgard: accurate to 1e-4 of [0-9.]+ m, as asked, only for the first [12][0-9.]+ s of 40 s; "
                               r"not predictable after that$")

    def test_what_needs_too_much_memory_stops_at_one_time(self):
        once = self.told("force -body b -x {sin(1e9*t)}", arguments=("--memory", "2"))
        self.assertRegex(once, r"^told\.al:3:1: error: Stopped at t = 0\.0[0-9]+: the motion up to here takes 2 MB, which is the limit, most of it for body \"b\"; ")
        self.assertEqual(once, self.told("force -body b -x {sin(1e9*t)}", arguments=("--memory", "2", "--threads", "1")))
        self.assertEqual(self.simulate(self.scene, "--memory", "0", code=2)[1], "asgard: --memory wants a number of MB, 1 to 1e9\n")

    def test_a_scene_without_bodies_says_so(self):
        ran = self.run_asgard("simulate", "-", text="simulator -finish 1\n")
        self.assertEqual((ran.returncode, ran.stderr), (0, "standard input: warning: the scene has no body, so nothing moves\n"))

    # --- wrong usage -------------------------------------------------------------------------------

    def test_wrong_usage_names_the_word_and_what_is_like_it(self):
        for arguments, sentence in (
                (("simulte", "a.al"), 'there is no command "simulte"; did you mean "simulate"?'),
                (("simulte",), 'there is no file and no command "simulte"; did you mean "simulate"?'),
                (("simulate", "a.al", "--acuracy", "1e-3"), 'simulate has no option "--acuracy"; did you mean "--accuracy"?'),
                (("simulate", "--acuracy=1e-3", "a.al"), 'simulate has no option "--acuracy"; did you mean "--accuracy"?'),
                (("simulate", "a.al", "-accuracy", "1e-3"), 'simulate has no option "-accuracy"; did you mean "--accuracy"?'),
                (("simulate", "a.al", "--accuracy", "abc"), '--accuracy wants a number, not "abc"'),
                (("simulate", "a.al", "--threads", "x"), '--threads wants a whole number, not "x"'),
                (("simulate", "a.al", "--accuracy"), "--accuracy wants a number, and nothing follows it"),
                (("simulate", "a.al", "--csv"), "--csv wants a value, and nothing follows it"),
                (("simulate", "a.al", "b.al"), 'simulate takes one SCENE, and "b.al" is one too many'),
                (("simulate",), "simulate wants SCENE, and it is not there"),
                (("render", "a.al"), "render wants --output, and it is not there"),
                (("simulate", "a.al", "--fixed-step", "1"), "--fixed-step wants --method beside it")):
            ran = self.run_asgard(*arguments)
            self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (2, "", f"asgard: {sentence}\n"), arguments)

    def test_every_method_is_one_of_a_scene_too(self):
        said = self.refused(1, "--method", "bogus")
        listed = said[said.index("methods here: ") + 14:said.rindex(")")].split(", ")
        self.assertEqual(len(listed), 16)
        scene = self.told("", finish="10 -method bogus")
        self.assertEqual(scene[scene.index("(methods: ") + 10:scene.rindex(")")].split(", "), listed)

    # --- check -----------------------------------------------------------------------------------

    def test_check_tells_every_fault_with_its_place(self):
        ran = self.run_asgard("check", self.scene)
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (0, "", ""))
        bad = self.file("bad.al", FLYING + "body c bell\nbody d ball -init_pos {1 2}\n")
        ran = self.run_asgard("check", bad)
        self.assertEqual(ran.returncode, 1)
        self.assertEqual(ran.stderr, "")
        places = [line for line in ran.stdout.split("\n") if ": error: " in line]
        self.assertEqual([p.split(": error: ")[0] for p in places], [f"{bad}:6:8", f"{bad}:7:23"])

    def test_check_doubts_what_is_hardly_meant(self):
        odd = self.file("odd.al", "shape_set q -desc {-sub {-sphere 1} -sub {-sphere 1} -sub {-box {1 1 1} -pos {5 0 0}}}\n"
                                  "shape_set two -desc {-sub {-box {1 1 1}} -sub {-box {1 1 1} -pos {1 0 0}}}\n"
                                  "body c two -fixed 1 -init_dpos {1 0 0}\nbody d q -init_pos {9 0 0} -inertia {1 1 3}\nbody e two -init_pos {0 9 0}\n"
                                  "shape_set ball -desc {-sub {-sphere 1} -sub {-sphere 0.1 -pos {1 0 0}}}\n"
                                  "body spotted ball -init_pos {0 0 9} -mass 1 -inertia {1 1 1} -center {0 0 0}\n")
        ran = self.run_asgard("check", odd)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        said = [line[len(odd):] for line in ran.stdout.split("\n") if ": warning: " in line]
        self.assertEqual([line.split(": warning: ")[0] for line in said], [":1:19", ":3:32", ":4:37"])
        self.assertIn('parts 1 and 2 of shape "q" overlap', said[0])
        self.assertIn('body "c" is fixed', said[1])
        self.assertIn('no body has such an inertia', said[2])

    def test_check_ends_what_does_not_end(self):
        ran = self.run_asgard("check", "-", text="while 1 {}")
        self.assertEqual(ran.returncode, 1)
        self.assertIn("standard input", ran.stdout)

    def test_an_input_without_end_is_refused_in_bounded_memory(self):
        os.mkfifo(os.path.join(self.folder, "pipe"))
        longest = "it is longer than 64 MB, and no more is read"
        for arguments, sentence in ((["check", "/dev/zero"], f"/dev/zero: {longest}"),
                                    (["simulate", "/dev/zero"], f"/dev/zero: {longest}"),
                                    (["simulate", self.scene, "--times", "/dev/zero"], f"/dev/zero: {longest}"),
                                    (["check", "-"], f"standard input: {longest}"),
                                    (["check", "pipe"], "pipe: it is a pipe into which nothing is written"),
                                    (["check", "."], ".: it is a folder")):
            with open("/dev/zero", "rb") as zeros:
                # A gigabyte of files' and programs' pages is there before anything is read.
                ran = subprocess.run([ASGARD, *arguments], stdin=zeros, capture_output=True, text=True, timeout=300, cwd=self.folder,
                                     env={"PATH": os.environ.get("PATH", "")},
                                     preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_DATA, (1 << 30, 1 << 30)))
            self.assertEqual((ran.returncode, ran.stderr), (1, f"asgard: {sentence}\n"), arguments)

    def test_a_pipe_is_an_input_like_a_file(self):
        ran = subprocess.run(["bash", "-c", f'"{ASGARD}" check <(cat "{self.scene}")'], capture_output=True, text=True, timeout=300)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""), ran.stdout)

    # --- render ----------------------------------------------------------------------------------

    def test_render_writes_png_and_ppm_of_the_size_asked(self):
        ran = self.run_asgard("render", self.scene, "--output", "a.png")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        width, height, pixels = read_png(os.path.join(self.folder, "a.png"))
        self.assertEqual((width, height), (640, 480))
        self.assertGreater(len(set(pixels)), 30)
        ran = self.run_asgard("render", self.scene, "--time", "1", "--size", "64x32", "--output", "a.ppm")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        with open(os.path.join(self.folder, "a.ppm"), "rb") as file:
            self.assertEqual(file.read(13), b"P6\n64 32\n255\n")
            self.assertEqual(len(file.read()), 64 * 32 * 3)

    def test_a_film_is_numbered_pictures(self):
        ran = self.run_asgard("render", self.scene, "--from", "0.5", "--to", "1.5", "--fps", "4", "--size", "40x30", "--output", "film/")
        self.assertEqual(ran.returncode, 0, ran.stderr)
        names = sorted(os.listdir(os.path.join(self.folder, "film")))
        self.assertEqual(names, [f"{i:05}.png" for i in range(1, 6)])
        pictures = {read_png(os.path.join(self.folder, "film", n)) for n in names}
        self.assertGreater(len(pictures), 1)

    def test_render_paints_the_values_beside_bodies(self):
        def picture(option, time):
            scene = self.file("told.al", FLYING + f"plot way -values {{{{b.x}}}} -labels {{Way}}{option}\n")
            ran = self.run_asgard("render", scene, "--time", time, "--output", "told.png")
            self.assertEqual((ran.returncode, ran.stderr), (0, ""))
            return read_png(os.path.join(self.folder, "told.png"))[2]

        without, there = picture("", "0"), picture(" -beside 1", "0")
        changed = sum(one != other for one, other in zip(without, there))
        self.assertGreater(changed, 300)
        self.assertLess(changed, len(without) / 20)
        self.assertEqual(there, picture(" -beside 1", "0"))
        self.assertNotEqual(picture(" -beside 1", "1"), picture("", "1"))

    def test_what_render_refuses(self):
        for code, arguments in ((1, ("--time", "3", "--output", "a.png")), (1, ("--view", "v", "--output", "a.png")),
                                (2, ("--output", "a.mp4")), (2, ("--output", "a.pdf")), (2, ("--size", "0x4", "--output", "a.png")),
                                (2, ("--size", "9", "--output", "a.png")), (2, ("--from", "0", "--output", "a.png")), (2, ()),
                                (1, ("--size", "1000000x2", "--output", "a.png"))):
            ran = self.run_asgard("render", self.scene, *arguments)
            self.assertEqual(ran.returncode, code, (arguments, ran.stderr))
            self.assertNotEqual(ran.stderr.strip(), "")
        self.assertEqual(os.listdir(self.folder), ["flying.al"])

    # --- the rest ----------------------------------------------------------------------------------

    def test_help_version_and_what_a_later_version_has(self):
        ran = self.run_asgard("--help")
        self.assertEqual(ran.returncode, 0)
        for word in ("simulate", "explain", "check", "render", "--medium"):
            self.assertIn(word, ran.stdout)
        self.assertEqual(self.run_asgard("--version").stdout.split()[0], "asgard")
        for command in (("export", self.scene, "--output", "a.glb"),):
            ran = self.run_asgard(*command)
            self.assertEqual(ran.returncode, 2)
            self.assertEqual(len(ran.stderr.strip().split("\n")), 1)
        self.assertEqual(self.run_asgard("--bogus").returncode, 2)


def read_png(path):
    """Width, height and the bytes of the rows, filters not undone."""
    with open(path, "rb") as file:
        data = file.read()
    width, height = struct.unpack(">II", data[16:24])
    packed, at = b"", 8
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        packed += data[at + 8:at + 8 + length] if kind == b"IDAT" else b""
        at += 12 + length
    return width, height, zlib.decompress(packed)


if __name__ == "__main__":
    ASGARD = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=1)
