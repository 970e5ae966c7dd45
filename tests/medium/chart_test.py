#!/usr/bin/env python3
"""The chart medium: another language, the same protocol.

usage: chart_test.py PATH-TO-CHART.PY [unittest arguments]
"""
import os
import sys
import unittest

from small_host import SmallHost

CHART = None

RAIN = "title: Rain\nunit: mm\nMonth, Bergen, Oslo\nJan, 190, 49\nFeb, 152, 36\nMar, 170, 47\n"


def host(**options):
    return SmallHost([CHART], **options)


def color_count(pixels, wanted):
    return sum(1 for i in range(0, len(pixels), 4) if pixels[i:i + 3] == bytes(wanted))


class Chart(unittest.TestCase):
    def test_it_draws_its_series_and_plays_a_cursor(self):
        with host() as h:
            self.assertEqual(h.start(RAIN, "CHART"), [])
            h.create(1, 300, 200)
            _, first = h.still()
            for bgr in ((181, 105, 31), (14, 93, 214)):
                self.assertGreater(color_count(first, bgr), 100)
            h.call("time/play")
            self.assertNotEqual(bytes(h.frame()[1]), first)
            h.heard("time/changed", where=lambda p: not p["playing"] and p["time"] == 1.0)

    def test_bars_fill_more_than_lines(self):
        with host() as h:
            h.start(RAIN, "CHART")
            h.create(1, 300, 200)
            _, lines = h.still()
            h.call("menu/invoke", id="bars", rendition=None)
            self.assertTrue(next(e["checked"] for e in h.heard("menu/changed", where=lambda p: any(
                e["id"] == "bars" and e["checked"] for e in p["menus"]))["menus"] if e["id"] == "bars"))
            h.call("menu/invoke", id="lines", rendition=None)
            _, bars = h.still()
            self.assertGreater(color_count(bars, (181, 105, 31)), 3 * color_count(lines, (181, 105, 31)))
            self.assertEqual(h.refused("menu/invoke", id="bars", rendition=None)["code"], -32003)

    def test_faults_are_placed_and_the_rest_is_drawn(self):
        with host() as h:
            items = h.start(RAIN.replace("152", "15z"), "CHART")
            self.assertEqual([(i["severity"], i["line"], i["column"], i["endColumn"]) for i in items], [("warning", 5, 6, 9)])
            h.create(1, 300, 200)
            _, good = h.still()
            h.call("subdocument/edit", revision=2, edits=[{"from": 0, "to": len(RAIN), "text": ""}])
            self.assertEqual(h.heard("diagnostics")["items"][0]["severity"], "error")
            self.assertEqual([m for m in h.drain(0.4) if m.get("method") == "rendition/frame"], [])

    def test_edits_count_bytes(self):
        with host() as h:
            h.start("unit: °C\n" + RAIN.split("\n", 2)[2], "CHART")
            at = len("unit: °C\n".encode())
            h.call("subdocument/edit", revision=2, edits=[{"from": at, "to": at + 5, "text": "M"}])
            self.assertEqual(h.heard("diagnostics")["items"], [])

    def test_pointing_shows_a_row_and_values_are_read(self):
        with host() as h:
            h.start(RAIN, "CHART")
            h.create(1, 300, 200)
            _, before = h.still()
            h.notify("rendition/input", rendition=1, type="move", x=290, y=100)
            _, after = h.still()
            self.assertNotEqual(before, after)
            values = h.call("value/read", expressions=["Bergen", "Oslo.max", "Rome"], time=0.25)["values"]
            self.assertEqual(values, [171, 49, None])
            faults = h.call("value/read", expressions=["Rome", "Oslo.least"], time=0)["faults"]
            self.assertIn("Bergen", faults[0])
            self.assertIn("Oslo.min", faults[1])
            self.assertIn({"expression": "Oslo.max", "label": "Oslo, largest"}, h.call("value/list"))

    def test_wrong_requests_are_refused_and_nothing_else_happens(self):
        with host() as h:
            self.assertEqual(h.refused("subdocument/load", text="", revision=1)["code"], -32600)
            h.start(RAIN, "CHART")
            self.assertEqual(h.refused("fly")["code"], -32601)
            self.assertEqual(h.refused("time/seek", time="x")["code"], -32602)
            self.assertEqual(h.refused("rendition/create", rendition=1, presentation="", width=100, height=100,
                                       slots=[{"offset": 1 << 40, "stride": 400}] * 2)["code"], -32602)
            h.call("ping")

    def test_it_ends_with_its_pipe_and_on_garbage(self):
        with host() as h:
            h.start(RAIN, "CHART")
            h.process.stdin.close()
            self.assertEqual(h.process.wait(3), 0)
        with host() as h:
            h.initialize("CHART")
            h.send_bytes(b"nonsense\r\n\r\n")
            self.assertEqual(h.process.wait(3), 1)

    def test_a_table_of_any_values_is_drawn(self):
        tables = ["a,b\n1,5\n", "a,b\nx,1e14\ny,-1e14\n", "a,b\nx,0\ny,0\n", "kind: bars\na,b,c\nx,,\n", "a,b\n" + "x,1\n" * 3000,
                  "a,b\n\u00e9\u4e2d,1e-9\ny,2e-9\n", "title: " + "long " * 200 + "\na,b\nx,1\n"]
        with host() as h:
            h.initialize("CHART")
            for revision, table in enumerate(tables, 1):
                h.call("subdocument/load", text=table, revision=revision)
                for width, height in ((1, 1), (40, 30), (300, 200)):
                    slot = h.allocate(width, height)
                    h.call("rendition/snapshot", presentation="", width=width, height=height, scale=1, time=None, **slot)


if __name__ == "__main__":
    CHART = os.path.abspath(sys.argv.pop(1))
    unittest.main(verbosity=1)
