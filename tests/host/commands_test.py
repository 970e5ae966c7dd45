#!/usr/bin/env python3
"""The batch commands of ensemble: what they write, what they say, how they exit; all without a display."""
import os
import re
import shutil
import subprocess
import unittest

from running import ENSEMBLE, InFolder, main, memo, scripted


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

    def test_a_text_that_no_message_holds_is_refused_at_its_place_and_the_rest_lives(self):
        self.write("a.ens", memo(scripted("\x01" * 14_700_000), scripted("colour 20A040"), scripted("colur 1")))
        sentence = "Scripted is not started: this text has 14.0 MiB, and it may have 8 MiB at most. Make it shorter."
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual((code, out.decode()), (1, "a.ens:5:12: error: %s\na.ens:15:46: error: unknown word \"colur\"\n" % sentence))
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn(sentence, error)
        images = subprocess.run(["pdfimages", "-list", self.path("a.pdf")], capture_output=True, check=True).stdout.decode()
        self.assertEqual(len(re.findall(r"\s938\s+625\s", images)), 1, images)

    def test_a_faulty_text_is_a_box_with_its_line(self):
        self.write("a.ens", memo(scripted("colur 1")))
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn('line 7: unknown word "colur"', error)

    def test_a_sentence_about_a_picture_stands_below_it_and_covers_nothing(self):
        self.write("a.ens", memo(scripted("duration 4"), scripted("duration 4\ncolur 1")))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens")[0], 1)
        images = subprocess.run(["pdfimages", "-list", self.path("a.pdf")], capture_output=True, check=True).stdout.decode()
        resolutions = [int(found) for found in re.findall(r"\s938\s+625\s.*?\s(\d+)\s+\d+\s+\S+\s+\S+$", images, re.M)]
        self.assertEqual(len(resolutions), 2, images)
        self.assertEqual(resolutions[0], 300)
        self.assertGreater(resolutions[1], 330)  # smaller, above its sentence

    def test_a_figure_without_a_text_is_a_box_that_says_so_and_no_failure(self):
        self.write("a.ens", memo(scripted(" \n", 'ALT="What falls"')))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens"), (0, b"", ""))
        text = subprocess.run(["pdftotext", self.path("a.pdf"), "-"], capture_output=True, check=True).stdout.decode()
        self.assertIn("Coloured Box: still empty\nWhat falls", text)

    def test_text(self):
        self.write("a.ens", memo("<PARAGRAPH><TEXT>{One }</TEXT><EMPH>{two}</EMPH></PARAGRAPH>\n", scripted("colour 0", 'ALT="A colour"')))
        code, out, _ = self.ensemble("--convert-to", "text", "--output", "-", "a.ens")
        self.assertEqual(code, 0)
        self.assertIn("One two\n", out.decode())
        self.assertIn("[SCRIPTED: A colour]", out.decode())

    def test_a_value_of_a_figure_stands_in_the_text_on_paper_and_as_text(self):
        value = '<PARAGRAPH><TEXT>{It is }</TEXT><VALUE OF="f" EXPRESSION="%s" FORMAT="2 decimals"%s></VALUE><TEXT>{ m.}</TEXT></PARAGRAPH>\n'
        formula = "<PARAGRAPH><FORMULA>{h = \\value[1 decimal, at 3 s]{f}{height}}</FORMULA></PARAGRAPH>\n"
        figure = scripted("duration 4\nvalue height 1 2", 'ID="f" POSTER="1.5"')
        self.write("a.ens", memo(value % ("height", ""), value % ("height", ' TIME="4 s"'), formula, figure))
        self.assertEqual(self.ensemble("--check", "a.ens"), (0, b"", ""))
        code, out, _ = self.ensemble("--convert-to", "text", "--output", "-", "a.ens")
        self.assertEqual(code, 0)
        for words in ("It is 4.00 m.", "It is 9.00 m.", "h = 7.0"):
            self.assertIn(words, out.decode())
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens"), (0, b"", ""))
        text = subprocess.run(["pdftotext", self.path("a.pdf"), "-"], capture_output=True, check=True).stdout.decode()
        self.assertIn("It is 4.00 m.", text)
        self.assertIn("It is 9.00 m.", text)

    def test_a_value_that_is_not_known_is_a_fault_and_never_a_number(self):
        value = '<PARAGRAPH><TEXT>{It is }</TEXT><VALUE OF="%s" EXPRESSION="%s"></VALUE><TEXT>{ m.}</TEXT></PARAGRAPH>\n'
        self.write("a.ens", memo(value % ("f", "width"), value % ("g", "x"), scripted("value height 1 2", 'ID="f"'),
                                 scripted("behave crash", 'ID="g"')))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn('a.ens:5:33: error: there is no number here: there is no value "width"\n', out.decode())
        self.assertIn("a.ens:6:33: error: there is no number here: Scripted was ended by signal 11", out.decode())
        code, out, error = self.ensemble("--convert-to", "text", "--output", "-", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("It is [width] m.", out.decode())
        self.assertIn('a.ens: error: line 5: there is no number here: there is no value "width"', error)
        code, _, error = self.ensemble("--convert-to", "pdf", "a.ens")
        self.assertEqual(code, 1)
        self.assertIn("line 5: there is no number here", error)

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


class Files(InFolder):
    """Pictures that are files, and texts that are longer than a page."""

    def words(self, file):
        text = subprocess.run(["pdftotext", self.path(file), "-"], capture_output=True, check=True).stdout.decode()
        return text.split()

    def test_a_picture_is_in_the_pdf_once_and_what_is_no_file_is_said(self):
        with open(self.path("a.ppm"), "wb") as f:
            f.write(b"P6 400 300 255\n" + os.urandom(400 * 300 * 3))
        subprocess.run(["convert", "a.ppm", "a.png"], check=True, cwd=self.path("."))
        os.mkfifo(self.path("fifo.png"))
        figure = '<FIGURE><IMAGE FILE="%s" ALT=""></IMAGE><CAPTION>{c}</CAPTION></FIGURE>\n'
        self.write("a.ens", memo(figure % "a.png" * 20))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens"), (0, b"", ""))
        images = subprocess.run(["pdfimages", "-list", self.path("a.pdf")], capture_output=True, check=True).stdout.decode()
        objects = {line.split()[10] for line in images.splitlines()[2:]}
        self.assertEqual((len(images.splitlines()) - 2, len(objects)), (20, 1))
        self.write("b.ens", memo(figure % "fifo.png" + figure % "/dev/zero" + figure % "none.png"))
        code, _, error = self.ensemble("--convert-to", "pdf", "b.ens")
        self.assertEqual(code, 1)
        self.assertIn("fifo.png is no file that can be read", error)
        self.assertIn("not in the document's folder", error)
        _, out, _ = self.ensemble("--check", "b.ens")
        self.assertEqual([line.split(":")[1] for line in out.decode().splitlines()], ["5", "6", "7"], out)

    def test_all_words_are_printed(self):
        def words(count, name):
            return " ".join("%s%d" % (name, i) for i in range(count))
        self.write("a.ens", memo(
            "<TABLE><ROW><CELL>{%s}</CELL><CELL>{%s}</CELL></ROW></TABLE>\n" % (words(3000, "a"), words(20, "b")),
            "<PARAGRAPH><TEXT>{%s}</TEXT><FOOTNOTE>{%s}</FOOTNOTE></PARAGRAPH>\n" % (words(50, "c"), words(3000, "d"))))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens"), (0, b"", ""))
        printed = self.words("a.pdf")
        for name, count in (("a", 3000), ("c", 49), ("d", 3000)):
            found = {word for word in printed if re.fullmatch(name + r"\d+", word)}
            self.assertTrue(found >= {name + str(i) for i in range(count)}, name)


class Check(InFolder):
    def test_faults_of_document_and_subdocuments_in_order(self):
        self.write("a.ens", memo(scripted("colour 0\n\\{\\} colur 1"), "<NOSUCH>{x}</NOSUCH>\n"))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        lines = out.decode().splitlines()
        self.assertIn('a.ens:8:1: error: unknown word "{}"', lines)
        self.assertTrue(any(re.match(r"a\.ens:10:\d+: warning: ", line) for line in lines), lines)

    def test_what_is_not_there_is_said_with_its_line(self):
        self.write("a.ens", memo(
            scripted("colour 0", 'ID="s"'), '<PARAGRAPH><REF TO="no"></REF></PARAGRAPH>\n', '<IMAGE FILE="no.png" ALT=""></IMAGE>\n',
            '<PARAGRAPH><SLIDER OF="s" NAME="speed"></SLIDER></PARAGRAPH>\n'))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 0) # all of it can be shown
        lines = {int(line.split(":")[1]): line for line in out.decode().splitlines()}
        self.assertEqual(len(lines), 3, lines)
        said = [lines[number] for number in sorted(lines)]
        self.assertIn("nothing has the ID no", said[0])
        self.assertIn("There is no picture no.png", said[1])
        self.assertIn('no parameter "speed"', said[2])

    def test_a_sound_document_is_silent(self):
        self.write("a.ens", memo(scripted("colour 0")))
        self.assertEqual(self.ensemble("--check", "a.ens"), (0, b"", ""))

    def test_a_medium_that_dies_is_an_error_at_its_place(self):
        self.write("a.ens", memo(scripted("behave crash")))
        code, out, _ = self.ensemble("--check", "a.ens")
        self.assertEqual(code, 1)
        self.assertRegex(out.decode(), r"a\.ens:5:12: error: .*signal 11")


class Keeper(InFolder):
    def test_without_the_program_that_keeps_media_none_is_started_and_it_is_said(self):
        shutil.copy(ENSEMBLE, self.path("ensemble"))
        self.write("a.ens", memo(scripted("colour 0")))
        done = subprocess.run([self.path("ensemble"), "--check", "a.ens"], cwd=self.folder.name, env=self.environment(), capture_output=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("a.ens:5:12: error: Scripted could not be started: the program %s, which ends what media leave behind, is missing; "
                      "install Ensemble again.\n" % os.path.realpath(self.path("medium-keeper")), done.stdout.decode())


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
