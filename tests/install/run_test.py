#!/usr/bin/env python3
"""`./run` in a copy of the scripts and samples, with the programs of this build: what is written and said without a display."""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE, PROGRAMS = sys.argv[1], sys.argv[2]


class RunWithoutDisplay(unittest.TestCase):
    def test_the_memo_is_written_and_its_place_said(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("run", "packaging/install.sh", "packaging/packages.txt", "samples/memo.ens"):
                os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
                shutil.copy(os.path.join(SOURCE, name), os.path.join(folder, name))
            os.makedirs(os.path.join(folder, "build", "release"))
            os.symlink(PROGRAMS, os.path.join(folder, "build", "release", "bin"))
            # A build that has nothing left to do stands for the build: this test is itself part of one.
            with open(os.path.join(folder, "build", "release", "build.ninja"), "w", encoding="utf-8") as f:
                f.write("build all: phony\n")
            environment = {"PATH": os.path.join(folder, "stand-in") + ":" + os.environ["PATH"], "HOME": folder}
            os.mkdir(os.path.join(folder, "stand-in"))
            with open(os.path.join(folder, "stand-in", "cmake"), "w", encoding="utf-8") as f:
                f.write("#!/bin/sh\nexit 0\n")
            os.chmod(f.name, 0o755)
            done = subprocess.run(["bash", "run"], cwd=folder, env=environment, stdin=subprocess.DEVNULL, capture_output=True, timeout=200)
            self.assertEqual((done.returncode, done.stderr.decode()), (0, ""))
            # A display that is only a name is none.
            again = subprocess.run(["bash", "run"], cwd=folder, env=dict(environment, DISPLAY=":4711"), stdin=subprocess.DEVNULL,
                                   capture_output=True, timeout=200)
            self.assertEqual((again.returncode, again.stdout, again.stderr), (0, done.stdout, done.stderr))
            memo = os.path.join(os.path.realpath(folder), "memo.pdf")
            self.assertIn("There is no display, so samples/memo.ens is written as " + memo, done.stdout.decode())
            images = subprocess.run(["pdfimages", "-list", memo], capture_output=True, check=True).stdout.decode()
            self.assertIn(" image ", images)
            text = subprocess.run(["pdftotext", memo, "-"], capture_output=True, check=True).stdout.decode()
            self.assertIn("Thanks to Vance for putting this example together", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
