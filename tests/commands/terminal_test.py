#!/usr/bin/env python3
"""Nothing that a document, a scene, a medium or a name brings reaches the terminal as a command to it.

usage: terminal_test.py PATH-TO-ASGARD PATH-TO-ENSEMBLE SOURCE [unittest arguments]
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

ASGARD = ENSEMBLE = SOURCE = None

# What a terminal obeys, or what orders the letters of our words from right to left.
CONTROL = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f]")
DIRECTION = re.compile("[\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]")

OWNED = b"\x1b]0;owned\x07"
# An escape, C1 as a character and as a byte, what is no UTF-8, from right to left, a forged message.
HOSTILE = OWNED + b"\xc2\x9b31m\x9b31m\xff\xe2\x80\xae\x7f\x08\rX\nforged.al:1:1: error: forged"
IN_TCL = r'"\033\]0;owned\007\u009b31m\u202e\u007f\u0008\u000dX\nforged.al:1:1: error: forged"'
BALL = "simulator -finish 1\nshape_set ball -desc {-sub {-sphere 0.5}}\n"
NAME = '"ba\\033\\]0;owned\\007ll\\u009b\\u202e"'


class Terminal(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.mkdir(self.path("run"), 0o700)

    def path(self, name):
        return os.path.join(self.folder, name)

    def file(self, name, content):
        where = os.path.join(os.fsencode(self.folder), name if isinstance(name, bytes) else name.encode())
        with open(where, "wb") as file:
            file.write(content if isinstance(content, bytes) else content.encode())
        return where

    def fit_for_a_terminal(self, said, directions=False):
        text = said.decode()  # it is UTF-8
        self.assertNotRegex(text, CONTROL)
        if not directions:
            self.assertNotRegex(text, DIRECTION)
        for line in text.split("\n"):
            self.assertFalse(line.startswith("forged"), text)
        return text

    def run_one(self, program, *arguments, text=None, directions=False):
        environment = {"PATH": os.environ["PATH"], "HOME": self.folder, "XDG_RUNTIME_DIR": self.path("run"), "LC_ALL": "C.UTF-8",
                       "ENSEMBLE_MEDIA": os.path.join(SOURCE, "tests", "media")}
        ran = subprocess.run([program, *arguments], input=text, capture_output=True, timeout=120, cwd=self.folder, env=environment)
        out, error = (self.fit_for_a_terminal(said, directions) for said in (ran.stdout, ran.stderr))
        return ran.returncode, out, error

    def asgard(self, *arguments, **more):
        return self.run_one(ASGARD, *arguments, **more)

    def ensemble(self, *arguments, **more):
        return self.run_one(ENSEMBLE, *arguments, **more)

    # --- asgard ----------------------------------------------------------------------------------

    def test_the_error_of_a_script(self):
        self.file("a.al", "error " + IN_TCL)
        for command in (("check",), ("simulate",), ("explain",), ("study",), ("render", "--output", "a.png")):
            code, out, error = self.asgard(command[0], "a.al", *command[1:])
            self.assertEqual(code, 1)
            self.assertIn("␛]0;owned␇", out + error, command)

    def test_the_line_that_a_message_shows(self):
        self.file("a.al", b"body b spere " + HOSTILE.replace(b"\n", b" ") + b"\n")
        code, out, _ = self.asgard("check", "a.al")
        self.assertEqual(code, 1)
        self.assertIn("body b spere ?]0;owned?", out)

    def test_names_in_a_scene(self):
        # Names are refused that are no words; labels are not.
        self.file("a.al", BALL + "body " + NAME + " ball\n")
        self.assertIn("␛]0;owned␇", self.asgard("check", "a.al")[1])
        self.assertIn("␛]0;owned␇", self.asgard("simulate", "a.al")[2])
        self.file("b.al", BALL + "parameter k -value 1 -label " + NAME + "\nbody b ball -mass 1\nforce -body b -x {sqrt(0.5-t)}\n"
                  "plot p -values {b.x} -labels [list " + NAME + "] -title " + NAME + "\n")
        for command in (("check",), ("simulate",), ("simulate", "--stats", "-", "--csv", "a.csv"),
                        ("simulate", "--quantities", "nobody.x\x1b[2J"), ("explain",), ("explain", "--all"), ("explain", "--json", "-"),
                        ("study", "--methods", "rk4", "--accuracies", "1e-2"), ("render", "--view", "\x1bc", "--output", "a.png")):
            self.asgard(command[0], "b.al", *command[1:])

    def test_names_of_files(self):
        for name in (OWNED + b".al", b"x\nforged.al", b"\xff\xc2\x9b.al"):
            self.asgard("check", name)  # it is not there
            where = self.file(name, "body b")
            for command in ("check", "simulate", "explain", "study"):
                self.assertEqual(self.asgard(command, where)[0], 1)
            self.asgard("simulate", where, "--csv", b"absent/" + name)
            self.asgard("render", where, "--output", b"absent/" + name)

    def test_what_is_typed(self):
        self.file("a.al", BALL + "body b ball\n")
        odd = "\x1b]0;owned\x07\nforged"
        for arguments in ((odd,), (odd, "a.al"), ("--" + odd,), ("simulate", "a.al", "--" + odd), ("simulate", "a.al", "--method", odd),
                          ("simulate", "a.al", "--set", odd + "=1"), ("simulate", "a.al", "--at", odd), ("simulate", "a.al", odd),
                          ("simulate", "a.al", "--accuracy", odd), ("study", "a.al", "--methods", odd), ("render", "a.al", "--size", odd,
                          "--output", "a.png"), ("render", "a.al", "--output", "a." + odd), ("explain", "a.al", "--expressions", odd)):
            self.assertNotEqual(self.asgard(*arguments)[0], 0, arguments)

    def test_a_file_of_times_and_a_table_of_places(self):
        self.file("a.al", BALL + "body b ball -init_dpos {1 0 0}\n")
        self.file("t.times", b"0 " + HOSTILE)
        self.file("r.csv", b"t,b.x,b.y,b.z\n" + HOSTILE)
        self.assertEqual(self.asgard("simulate", "a.al", "--times", "t.times")[0], 1)
        self.asgard("study", "a.al", "--methods", "rk4", "--accuracies", "1e-2", "--reference", "r.csv")

    # --- ensemble --------------------------------------------------------------------------------

    def document(self, *paragraphs):
        return b"DOCUMENT CMEMO\n<CMEMO>\n<SUBJECT>{Test}</SUBJECT>\n<BODY>\n" + b"".join(paragraphs) + b"</BODY>\n</CMEMO>\n"

    def scripted(self, text, attributes=b""):
        return (b'<PARAGRAPH><DOCUMENT>\nDOCUMENT SCRIPTED\n<SCRIPTED WIDTH="300" HEIGHT="200" ' + attributes + b"><SCRIPT>{" + text +
                b"}</SCRIPT></SCRIPTED>\n</DOCUMENT></PARAGRAPH>\n")

    def test_a_document_s_text_keeps_its_letters_and_loses_what_is_obeyed(self):
        hebrew = "\u202bשלום\u202c".encode()
        self.file("a.ens", self.document(b"<PARAGRAPH><TEXT>{a " + OWNED + b" \xc2\x9b \xff \x08 b " + hebrew + b"}</TEXT></PARAGRAPH>\n"
                                         b"<VERBATIM>{\r" + OWNED + b"}</VERBATIM><TABLE><ROW><CELL>{" + OWNED + b"}</CELL></ROW></TABLE>\n"))
        code, out, _ = self.ensemble("--convert-to", "text", "--output", "-", "a.ens", directions=True)
        self.assertIn("␛]0;owned␇", out)
        self.assertIn("שלום", out)
        self.ensemble("--convert-to", "text", "a.ens", directions=True)
        with open(self.path("a.txt"), "rb") as file:
            self.fit_for_a_terminal(file.read(), directions=True)

    def test_faults_of_a_document(self):
        self.file("a.ens", self.document(b"<" + HOSTILE + b">{x}</" + HOSTILE + b">\n", b"<NO" + OWNED + b">{x}</NO" + OWNED + b">\n",
                                         b'<PARAGRAPH ID="' + HOSTILE + b'" A\x1b="1"><REF TO="' + HOSTILE + b'"></REF></PARAGRAPH>\n',
                                         b'<FIGURE><IMAGE FILE="' + HOSTILE + b'"></IMAGE></FIGURE>\n'))
        for command in (("--check",), ("--convert-to", "pdf"), ("--convert-to", "text"), ("--convert-to", "png")):
            self.ensemble(*command, "a.ens")
        self.assertNotEqual(self.ensemble("--check", "a.ens")[1], "")

    def test_what_a_medium_says(self):
        self.file("a.ens", self.document(self.scripted(b"fault 1 1 " + OWNED + b"\xe2\x80\xae\xc2\x9b\n" + OWNED + b"word"),
                                         self.scripted(b"behave " + OWNED), self.scripted(b"\x1b[2J\x7f")))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("␛]0;owned␇", out)
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("␛]0;owned␇", error)

    def test_the_error_of_a_scene_in_a_document(self):
        scene = ("error " + IN_TCL).encode()
        self.file("a.ens", self.document(b"<PARAGRAPH><DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION><ASGARD>{" + scene +
                                         b"}</ASGARD></ANIMATION>\n</DOCUMENT></PARAGRAPH>\n"))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("␛]0;owned␇", out)

    def test_names_of_documents_and_words_of_the_command(self):
        for name in (OWNED + b".ens", b"x\nforged.ens", b"\xff\xc2\x9b.ens"):
            self.ensemble("--check", name)
            where = self.file(name, self.document(b"<NOSUCH>{x}</NOSUCH>\n"))
            for command in (("--check",), ("--convert-to", "text", "--output", b"absent/" + name), ("--convert-to", "pdf")):
                self.ensemble(*command, where)
        odd = "\x1b]0;owned\x07\nforged"
        for arguments in (("--" + odd,), ("--convert-to", odd, "a.ens"), ("--check-medium", odd), ("--check",), (odd,)):
            self.assertNotEqual(self.ensemble(*arguments)[0], 0, arguments)

    def test_what_the_conformance_test_tells(self):
        # A medium that introduces itself with what a terminal obeys, and answers all else by an error of the same.
        self.file("odd.py", '''import json, sys
odd = "\\x1b]0;owned\\x07\\u009b\\u202e\\nforged"
while True:
    length = 0
    while (line := sys.stdin.buffer.readline()).strip():
        if line.lower().startswith(b"content-length:"):
            length = int(line[15:])
    if not line:
        break
    call = json.loads(sys.stdin.buffer.read(length))
    if "id" not in call:
        continue
    error = {"code": -32003, "message": odd}
    body = json.dumps({"jsonrpc": "2.0", "id": call["id"], "error": error}).encode()
    sys.stdout.buffer.write(b"Content-Length: %d\\r\\n\\r\\n" % len(body) + body)
    sys.stdout.buffer.flush()
''')
        code, out, _ = self.ensemble("--check-medium", "python3", "odd.py")
        self.assertEqual(code, 1)
        self.assertIn("␛]0;owned␇", out)

    def test_manifests_and_schemas_that_are_faulty(self):
        os.mkdir(self.path("media"))
        self.file("media/odd.medium.json", b'{"name": "' + OWNED + b'"')
        self.file("media/" + "two\x1b]0;owned\x07.medium.json", json.dumps({"name": OWNED.decode(), "class": "\x1b"}))
        os.makedirs(self.path(".local/share/ensemble"))
        self.file(".local/share/ensemble/" + "o\x1bdd.presentation", b"memo { \x1b]0;owned\x07: 1 }")
        self.file("a.ens", self.document())
        environment = {"PATH": os.environ["PATH"], "HOME": self.folder, "ENSEMBLE_MEDIA": self.path("media")}
        ran = subprocess.run([ENSEMBLE, "--check", "a.ens"], capture_output=True, timeout=120, cwd=self.folder, env=environment)
        for said in (ran.stdout, ran.stderr):
            self.fit_for_a_terminal(said)
        self.assertIn("odd.medium.json", ran.stderr.decode())

    def test_a_pdf_is_not_for_a_terminal(self):
        self.file("a.ens", self.document())
        import pty
        leader, follower = pty.openpty()
        ran = subprocess.run([ENSEMBLE, "--convert-to", "pdf", "--output", "-", "a.ens"], stdout=follower, stderr=subprocess.PIPE,
                             timeout=120, cwd=self.folder, env={"PATH": os.environ["PATH"], "HOME": self.folder})
        os.close(follower)
        os.close(leader)
        self.assertEqual(ran.returncode, 1)
        self.assertIn("not for a terminal", ran.stderr.decode())


if __name__ == "__main__":
    ASGARD, ENSEMBLE, SOURCE = (os.path.abspath(sys.argv.pop(1)) for _ in range(3))
    unittest.main(verbosity=1)
