"""Runs ensemble on documents made for a test, with the scripted medium and nothing of the user's."""
import os
import subprocess
import sys
import tempfile
import unittest

ENSEMBLE, SOURCE = sys.argv[1], sys.argv[2]


def scripted(text, attributes=""):
    return ('<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED WIDTH="300" HEIGHT="200" %s><SCRIPT>{%s}</SCRIPT></SCRIPTED>\n'
            "</DOCUMENT></PARAGRAPH>\n" % (attributes, text))


def memo(*paragraphs):
    return "DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Test}</SUBJECT>\n<BODY>\n%s</BODY>\n</CMEMO>\n" % "".join(paragraphs)


class InFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        os.mkdir(self.path("run"), 0o700)

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as f:
            f.write(text)
        return self.path(name)

    def environment(self, **more):
        """No display, and nothing of the user's."""
        return dict({"PATH": os.environ["PATH"], "HOME": self.folder.name, "XDG_RUNTIME_DIR": self.path("run"),
                     "ENSEMBLE_MEDIA": os.path.join(SOURCE, "tests", "media")}, **more)

    def ensemble(self, *arguments, **more):
        done = subprocess.run([ENSEMBLE, *arguments], cwd=self.folder.name, env=self.environment(), capture_output=True, timeout=120, **more)
        return done.returncode, done.stdout, done.stderr.decode()


def main():
    unittest.main(argv=sys.argv[:1])
