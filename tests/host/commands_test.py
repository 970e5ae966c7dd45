#!/usr/bin/env python3
"""The batch commands of ensemble: what they write, what they say, how they exit; all without a display."""
import os
import re
import shutil
import subprocess
import unittest

from running import InFolder, main, memo, scripted


class Convert(InFolder):
    def test_pdf_has_the_picture_at_print_resolution(self):
        self.write("a.ens", memo("<PARAGRAPH><TEXT>{Words}</TEXT></PARAGRAPH>\n", scripted("duration 4\ncolour 20A040")))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens"), (0, b"", ""))
        images = subprocess.run(["pdfimages", "-list", self.path("a.pdf")], capture_output=True, check=True).stdout.decode()
        # 300 x 200 at 300 dots to the inch instead of 96
        self.assertRegex(images, r"\s938\s+625\s")
        text = subprocess.run(["pdftotext", self.path("a.pdf"), "-"], capture_output=True, check=True).stdout.decode()
        self.assertIn("Words", text)

    def test_poster_is_the_time_of_the_picture(self):
        pictures = []
        for poster in ("0", "4"):
            # The medium's bar stands at the left at first, at the right in the end.
            self.write("a.ens", memo(scripted("duration 4\ncolour 000000", 'POSTER="%s"' % poster)))
            self.assertEqual(self.ensemble("--convert-to", "png", "--output", "a.png", "a.ens")[0], 0)
            with open(self.path("a.png"), "rb") as f:
                pictures.append(f.read())
        self.assertNotEqual(pictures[0], pictures[1])

    def test_a_failing_medium_is_a_box_and_exit_1_and_the_file_is_written(self):
        self.write("a.ens", memo(scripted("behave crash"), scripted("colour 20A040")))
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("was ended by signal 11", error)
        text = subprocess.run(["pdftotext", self.path("a.pdf"), "-"], capture_output=True, check=True).stdout.decode()
        self.assertIn("was ended by signal 11", text)

    def test_a_faulty_text_is_a_box_with_its_line(self):
        self.write("a.ens", memo(scripted("colur 1")))
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn('line 7: unknown word "colur"', error)

    def test_text(self):
        self.write("a.ens", memo("<PARAGRAPH><TEXT>{One }</TEXT><EMPH>{two}</EMPH></PARAGRAPH>\n", scripted("colour 0", 'ALT="A colour"')))
        code, out, _ = self.ensemble("--convert-to", "text", "--output", "-", "a.ens")
        self.assertEqual(code, 0)
        self.assertIn("One two\n", out.decode())
        self.assertIn("[A colour]", out.decode())

    def test_pages_as_png_are_numbered(self):
        self.write("a.ens", memo(*["<PARAGRAPH><TEXT>{line}</TEXT></PARAGRAPH>\n"] * 100))
        self.assertEqual(self.ensemble("--convert-to", "png", "a.ens")[0], 0)
        self.assertTrue(os.path.exists(self.path("a-1.png")) and os.path.exists(self.path("a-2.png")))

    def test_standard_input_and_output(self):
        code, out, _ = self.ensemble("--convert-to", "pdf", "--output", "-", "-", input=memo().encode())
        self.assertEqual(code, 0)
        self.assertEqual(out[:5], b"%PDF-")

    def test_wrong_usage_is_2(self):
        for arguments in (["--convert-to", "gif", "x.ens"], ["--convert-to", "html", "x.ens"], ["--convert-to", "pdf"],
                          ["--no-such"], ["--check"], ["--check-medium"]):
            self.assertEqual(self.ensemble(*arguments)[0], 2, arguments)

    def test_a_missing_file_is_1(self):
        code, _, error = self.ensemble("--convert-to", "pdf", "no.ens")
        self.assertEqual(code, 1)
        self.assertIn("no.ens", error)

    def test_what_is_no_file_or_has_no_end_is_refused(self):
        os.mkfifo(self.path("pipe.ens"))
        for name in ("pipe.ens", "/dev/zero"):
            self.assertEqual(self.ensemble("--check", name)[::2], (1, "%s cannot be read: it is not a file.\n" % os.path.basename(name)))
        with open("/dev/zero", "rb") as zeros:
            code, _, error = self.ensemble("--convert-to", "text", "-", stdin=zeros)
        self.assertEqual((code, error), (1, "standard input cannot be read: it is longer than 256 MB, and no more is read.\n"))


class Check(InFolder):
    def test_faults_of_document_and_subdocuments_in_order(self):
        self.write("a.ens", memo(scripted("colour 0\n\\{\\} colur 1"), "<NOSUCH>{x}</NOSUCH>\n"))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        lines = out.decode().splitlines()
        self.assertIn('a.ens:8:1: error: unknown word "{}"', lines)
        self.assertTrue(any(re.match(r"a\.ens:10:\d+: warning: ", line) for line in lines), lines)

    def test_a_sound_document_is_silent(self):
        self.write("a.ens", memo(scripted("colour 0")))
        self.assertEqual(self.ensemble("--check", "a.ens"), (0, b"", ""))

    def test_a_medium_that_dies_is_an_error_at_its_place(self):
        self.write("a.ens", memo(scripted("behave crash")))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        self.assertRegex(out.decode(), r"a\.ens:5:12: error: .*signal 11")


class Version(InFolder):
    def test_help_and_version(self):
        code, out, error = self.ensemble("--help")
        self.assertEqual((code, error), (0, ""))
        self.assertIn(b"--convert-to", out)
        self.assertRegex(self.ensemble("--version")[1].decode(), r"^ensemble \d+\.\d+\.\d+\n$")

    def test_no_display_is_said(self):
        self.write("a.ens", memo())
        code, _, error = self.ensemble("a.ens")
        self.assertEqual(code, 1)
        self.assertIn("no display", error)


assert shutil.which("pdfimages"), "poppler-utils is needed"
if __name__ == "__main__":
    main()
