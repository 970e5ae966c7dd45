#!/usr/bin/env python3
"""Installs the build into an empty prefix and works with what is there, with nothing else of the build or of the user."""
import glob
import os
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

CMAKE, BUILD = sys.argv[1], sys.argv[2]


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = os.path.join(cls.folder.name, "prefix")
        cls.empty = os.path.join(cls.folder.name, "empty")
        os.mkdir(cls.empty)
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.prefix], check=True, stdout=subprocess.DEVNULL)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def under(self, *parts):
        return os.path.join(self.prefix, *parts)

    def share(self, *parts):
        return self.under("share", *parts)

    def call(self, *command):
        """A program with no environment but what finds python3 and keeps it off the user's files."""
        return subprocess.run(command, cwd=self.empty, env={"PATH": "/usr/bin:/bin", "HOME": self.empty}, capture_output=True, timeout=200)

    def ensemble(self, *arguments):
        done = self.call(self.under("bin", "ensemble"), *arguments)
        self.assertEqual((done.returncode, done.stderr.decode()), (0, ""))
        return done.stdout.decode()

    def pictures(self, pdf):
        listed = subprocess.run(["pdfimages", "-list", pdf], capture_output=True, check=True).stdout.decode()
        return len([line for line in listed.splitlines()[2:] if line.split()[2] == "image"])

    def test_sample_documents_become_paper_with_the_pictures_of_their_media(self):
        for name, pictures in (("memo", 1), ("report", 3), ("chart", 1)):
            pdf = os.path.join(self.empty, name + ".pdf")
            self.ensemble("--convert-to", "pdf", "--output", pdf, self.share("ensemble", "samples", name + ".ens"))
            self.assertGreaterEqual(self.pictures(pdf), pictures, name)

    def test_a_schema_that_is_changed_where_it_was_installed_changes_documents(self):
        schema = self.share("ensemble", "schemas", "CMEMO.default.presentation")
        memo = self.share("ensemble", "samples", "memo.ens")
        with open(schema, encoding="utf-8") as f:
            before = f.read()
        self.assertIn("Memorandum", before)
        try:
            with open(schema, "w", encoding="utf-8") as f:
                f.write(before.replace("Memorandum", "Note to Readers"))
            self.assertIn("Note to Readers", self.ensemble("--convert-to", "text", "--output", "-", memo))
        finally:
            with open(schema, "w", encoding="utf-8") as f:
                f.write(before)

    def test_sample_scenes_are_sound(self):
        scenes = glob.glob(self.share("ensemble", "samples", "*.al"))
        self.assertGreater(len(scenes), 5)
        for scene in scenes:
            done = self.call(self.under("bin", "asgard"), "check", scene)
            self.assertEqual((done.returncode, done.stdout.decode()), (0, ""), scene)

    def test_a_desktop_can_find_them(self):
        for name in ("ensemble", "asgard"):
            entry = self.share("applications", name + ".desktop")
            done = subprocess.run(["desktop-file-validate", entry], capture_output=True)
            self.assertEqual((done.returncode, done.stdout.decode()), (0, ""))
            with open(entry, encoding="utf-8") as f:
                keys = dict(line.strip().split("=", 1) for line in f if "=" in line)
            self.assertTrue(os.access(self.under("bin", keys["Exec"].split()[0]), os.X_OK))
            self.assertTrue(os.path.exists(self.share("icons", "hicolor", "scalable", "apps", keys["Icon"] + ".svg")))
            self.assertTrue(os.path.exists(self.share("man", "man1", name + ".1")))
            declared = ElementTree.parse(self.share("mime", "packages", "ensemble.xml")).getroot()
            self.assertIn(keys["MimeType"].rstrip(";"), [kind.get("type") for kind in declared])
        ElementTree.parse(self.share("metainfo", "ensemble.metainfo.xml"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
