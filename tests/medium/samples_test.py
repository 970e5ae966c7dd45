#!/usr/bin/env python3
"""What a medium's manifest proposes to begin with: sound scenes, which move, and show something.

usage: samples_test.py PATH-TO-ASGARD MANIFEST
"""
import collections
import json
import os
import subprocess
import sys
import tempfile
import unittest

ASGARD, MANIFEST = sys.argv[1], sys.argv[2]


class Samples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(MANIFEST, encoding="utf-8") as f:
            cls.manifest = json.load(f)
        cls.folder = tempfile.TemporaryDirectory()
        new = os.path.join(cls.folder.name, "new.al")
        with open(new, "w", encoding="utf-8") as f:
            f.write(cls.manifest["newText"])
        beside = os.path.dirname(MANIFEST)
        cls.scenes = [(new, 1.2)] + [(os.path.join(beside, one["file"]), one["time"]) for one in cls.manifest["samples"]]

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def picture(self, scene, time):
        """The bytes of its pixels, as the host would show it."""
        width, height = self.manifest["size"]
        file = os.path.join(self.folder.name, "picture.ppm")
        subprocess.run([ASGARD, "render", scene, "--time", str(time), "--size", f"{width}x{height}", "--output", file], check=True,
                       capture_output=True, timeout=100)
        with open(file, "rb") as f:
            return f.read()

    def test_they_are_sound_without_a_warning(self):
        self.assertGreaterEqual(len(self.scenes), 9)
        for scene, _ in self.scenes:
            done = subprocess.run([ASGARD, "check", scene], capture_output=True, timeout=100)
            self.assertEqual((done.returncode, done.stdout + done.stderr), (0, b""), scene)

    def test_each_moves_and_has_more_to_show_than_a_dot(self):
        for scene, time in self.scenes:
            first, later = self.picture(scene, 0), self.picture(scene, time)
            self.assertTrue(first != later, f"{scene} stands still")
            pixels = collections.Counter(later[i:i + 3] for i in range(15, len(later) - 3, 3))
            drawn = sum(pixels.values()) - max(pixels.values())  # what is not the ground
            self.assertGreater(drawn, (len(later) - 15) / 3 / 50, scene)

    def test_their_motion_is_computed_as_exactly_as_was_asked(self):
        for scene, _ in self.scenes:
            done = subprocess.run([ASGARD, "simulate", scene], capture_output=True, timeout=100)
            self.assertEqual(done.returncode, 0, scene)
            self.assertNotIn(b"warning", done.stderr, scene)

    def test_each_has_a_name_and_a_line(self):
        for sample in self.manifest["samples"]:
            self.assertTrue(sample["title"] and sample["about"])
            self.assertLess(len(sample["about"]), 50)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
