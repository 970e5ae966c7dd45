#!/usr/bin/env python3
"""The medium's process as a host sees it: frames and their flow, time, faults, and how it ends.

usage: asgard_test.py PATH-TO-ASGARD [unittest arguments]
"""
import os
import signal
import subprocess
import sys
import time
import unittest

from small_host import SmallHost, children, cpu_seconds, end_by_kill, running

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "desktop"))
from screen import until  # noqa: E402

ASGARD = None

FLYING = """simulator -finish 4
shape_set ball -desc {-sub {-sphere 0.5 -color red}}
body b ball -init_pos {-2 0 0} -init_dpos {1 0 0}
"""
BRAKED = "parameter speed -value 1 -min 0 -max 2 -label Speed -unit m/s\n" + FLYING.replace("{1 0 0}", "[list $speed 0 0]")
ENDLESS = "while 1 {}"
# A gas in a closed box, for so long that no machine computes it while a test waits.
GAS = """simulator -finish 2000 -accuracy 1e-8
shape_set ball -desc {-sub {-sphere 0.3}}
shape_set wall -desc {-sub {-box {12 0.5 12}} -sub {-pos {0 10 0} -box {12 0.5 12}} -sub {-pos {-5 5 0} -box {0.5 9.5 12}}
    -sub {-pos {5 5 0} -box {0.5 9.5 12}} -sub {-pos {0 5 -5} -box {9.5 9.5 0.5}} -sub {-pos {0 5 5} -box {9.5 9.5 0.5}}}
body box wall -fixed 1
for {set i 0} {$i < 27} {incr i} {
    body b$i ball -init_pos [list [expr {2*($i%3)-2}] [expr {2*($i/3%3)+3}] [expr {2*($i/9)-2}]] \\
        -init_dpos [list [expr {1+0.1*$i}] [expr {2-0.13*$i}] [expr {0.3*$i-1}]]
    force -body b$i -x 0 -y "sin(b$i.y)-1" -z "sin(t)"
}
"""


def host(**options):
    return SmallHost([ASGARD, "--medium"], **options)


class Frames(unittest.TestCase):
    def test_a_loaded_scene_is_shown_and_plays(self):
        with host() as h:
            self.assertEqual(h.start(FLYING), [])
            h.create(1)
            _, first = h.still()
            self.assertGreater(len(set(first)), 20, "the picture is blank")
            h.call("time/play")
            pictures = {bytes(h.frame()[1]) for _ in range(6)}
            self.assertGreater(len(pictures), 3, "the picture does not move")

    def test_time_follows_the_clock_and_stops_at_the_finish(self):
        with host() as h:
            h.start(FLYING.replace("-finish 4", "-finish 0.6"))
            h.create(1)
            h.frame()
            begin = time.monotonic()
            h.call("time/play")
            h.heard("time/changed", where=lambda p: not p["playing"] and p["time"] == 0.6)
            self.assertGreaterEqual(time.monotonic() - begin, 0.59)

    def test_at_most_two_frames_are_unacknowledged(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.still()
            h.call("time/play")
            frames = [h.frame(acknowledge=False)[0] for _ in (0, 1)]
            self.assertEqual({f["slot"] for f in frames}, {0, 1})
            self.assertEqual([m for m in h.drain(0.6) if m.get("method") == "rendition/frame"], [])
            h.acknowledge(frames[0])
            frame, _ = h.frame(acknowledge=False)
            self.assertEqual(frame["slot"], frames[0]["slot"])
            self.assertEqual(frame["serial"], frames[1]["serial"] + 1)

    def test_a_hidden_rendition_draws_nothing_and_a_still_one_costs_nothing(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.still()
            used = [h.cpu_seconds() + 1]  # a while after the first picture it prepares for moving ones
            came = [None]
            while (came or used[-1] - used[-2] > 0.01) and len(used) < 60:
                came = h.drain(1.0)
                used.append(h.cpu_seconds())
            self.assertEqual(came, [])
            self.assertLessEqual(used[-1] - used[-2], 0.01)
            h.notify("rendition/hide", rendition=1)
            h.call("time/play")
            self.assertEqual([m for m in h.drain(1.0) if m.get("method") == "rendition/frame"], [])
            h.notify("rendition/show", rendition=1)
            self.assertGreater(h.frame()[0]["time"], 0.9)

    def test_two_renditions_have_their_own_views_and_sizes(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.create(2, 320, 200)
            h.still(1)
            _, before = h.still(2)
            h.notify("rendition/input", rendition=2, type="press", x=100, y=100, button="left", buttons=["left"])
            h.notify("rendition/input", rendition=2, type="move", x=160, y=130, buttons=["left"])
            h.notify("rendition/input", rendition=2, type="release", x=160, y=130, button="left")
            frame, after = h.still(2)
            self.assertEqual((frame["width"], frame["height"]), (320, 200))
            self.assertNotEqual(before, after)
            self.assertEqual([m for m in h.drain(0.3) if m.get("method") == "rendition/frame"], [])

    def test_its_presentations_are_picture_charts_and_text(self):
        with host() as h:
            scene = FLYING + "plot p -title Way -values {b.x {2*b.x}}\n" + "# one more line\n" * 40
            h.start(scene)
            names = [each["id"] for each in h.call("presentation/list")]
            self.assertEqual(names, ["picture", "chart", "text"])
            sizes = {name: h.call("presentation/size", presentation=name, available={"width": 600, "height": None})
                     for name in names}
            self.assertGreater(sizes["text"]["height"], 500)  # room for all lines
            self.assertLess(sizes["chart"]["height"], 300)
            h.call("subdocument/load", text="# a line\n" * 3000 + "for {set i 0} {$i < 300} {incr i} {plot p$i -values t}", revision=2)
            for name in names:  # as high as the protocol allows
                size = h.call("presentation/size", presentation=name, available={"width": 600, "height": None})
                self.assertLessEqual(size["height"], 16384)
            h.call("subdocument/load", text=scene, revision=3)
            pictures = {}
            for number, name in enumerate(names, 1):
                h.create(number, 300, 200, presentation=name)
                pictures[name] = h.still(number)[1]
            self.assertEqual(len(set(pictures.values())), 3)
            for name in "chart", "text":
                self.assertEqual(pictures[name][-4:-1], b"\xff\xff\xff")  # paper
                self.assertGreater(len(set(pictures[name])), 20)  # letters with smooth edges
            # The wheel moves the text; a button on the chart takes time there.
            h.notify("rendition/input", rendition=3, type="wheel", x=9, y=9, dx=0, dy=-5)
            self.assertNotEqual(h.still(3)[1], pictures["text"])
            h.notify("rendition/input", rendition=2, type="press", x=175, y=100, button="left", buttons=["left"])
            self.assertNotEqual(h.still(2)[1], pictures["chart"])
            time = h.heard("time/changed", where=lambda told: told["time"] > 0)["time"]
            self.assertTrue(1 < time < 3, time)
            # On paper, larger; and in another presentation in the same slots.
            taken = [h.call("rendition/snapshot", presentation=name, width=600, height=400, scale=4, time=1,
                            **h.allocate(600, 400)) for name in ("chart", "text")]
            self.assertEqual([each["time"] for each in taken], [1, 1])
            h.call("rendition/resize", rendition=1, presentation="text", width=300, height=200, scale=1,
                   slots=h.slots[1])
            self.assertEqual(h.still(1)[1], pictures["text"])
            self.assertEqual(h.refused("rendition/create", rendition=9, presentation="film", width=9, height=9,
                                       slots=[])["code"], -32602)

    def test_a_faulty_text_is_shown_as_text(self):
        with host() as h:
            self.assertTrue(h.start("body b nothing\n"))
            h.create(1, 300, 200, presentation="text")
            faulty = h.still(1)[1]
            h.call("subdocument/load", text="shape_set nothing -desc {-sub {-sphere 1}}\nbody b nothing\n", revision=2)
            self.assertNotEqual(h.still(1)[1], faulty)

    def test_a_resized_rendition_goes_on_in_its_new_slots(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            last, _ = h.still()
            slots = h.slots[1] = [h.allocate(100, 90), h.allocate(100, 90)]
            h.call("rendition/resize", rendition=1, presentation="picture", width=100, height=90, scale=1, slots=slots)
            frame, pixels = h.frame()
            self.assertEqual((frame["width"], frame["height"]), (100, 90))
            self.assertGreater(frame["serial"], last["serial"])
            self.assertGreater(len(set(pixels)), 20)

    def test_without_shared_memory_pixels_come_in_the_message(self):
        with host(frames=False) as h:
            h.start(FLYING)
            h.create(1, 60, 40)
            frame = h.heard("rendition/frame")
            self.assertEqual(len(frame["pixels"]), 4 * ((60 * 40 * 4 + 2) // 3))
            snapshot = h.call("rendition/snapshot", presentation="picture", width=30, height=20, scale=1, time=1.5)
            self.assertEqual(snapshot["time"], 1.5)
            self.assertEqual(len(snapshot["pixels"]), 4 * ((30 * 20 * 4 + 2) // 3))

    def test_a_slot_beyond_the_memory_is_refused(self):
        with host() as h:
            h.start(FLYING)
            for offset, stride in ((1 << 28, 400), ((1 << 28) - 100, 400), (9007199254740991, 400), (0, 396)):
                slots = [{"offset": 0, "stride": 400}, {"offset": offset, "stride": stride}]
                error = h.refused("rendition/create", rendition=1, presentation="", width=100, height=100, slots=slots)
                self.assertEqual(error["code"], -32602)
            h.create(1, 100, 100)
            h.frame()

    def test_a_snapshot_shows_the_time_that_was_asked_for(self):
        with host() as h:
            h.start(FLYING, mode="batch")
            pictures = []
            for moment in (0, 2, 4):
                slot = h.allocate(200, 150)
                taken = h.call("rendition/snapshot", presentation="", width=200, height=150, scale=1, time=moment, **slot)
                self.assertEqual(taken["time"], moment)
                pictures.append(bytes(h.memory[slot["offset"]:slot["offset"] + 200 * 150 * 4]))
            self.assertEqual(len(set(pictures)), 3)


class Text(unittest.TestCase):
    def test_a_faulty_edit_keeps_the_last_picture_and_says_what_is_wrong(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.still()
            at = FLYING.index("ball -init_pos")
            h.call("subdocument/edit", revision=2, edits=[{"from": at, "to": at + 4, "text": "bell"}], label="Typing")
            told = h.heard("diagnostics")
            self.assertEqual(told["revision"], 2)
            self.assertEqual([(i["severity"], i["line"]) for i in told["items"]], [("error", 3)])
            self.assertIn("ball", told["items"][0]["message"])  # the suggestion
            h.heard("time/changed", where=lambda p: p["state"] == "stale")
            self.assertEqual([m for m in h.drain(0.5) if m.get("method") == "rendition/frame"], [])
            h.call("subdocument/edit", revision=3, edits=[{"from": at, "to": at + 4, "text": "ball"}], label="Undo")
            self.assertEqual(h.heard("diagnostics")["items"], [])
            h.heard("time/changed", where=lambda p: p["state"] == "current")

    def test_an_edit_changes_the_picture_and_keeps_the_time(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.call("time/seek", time=2)
            _, before = h.still()
            at = FLYING.index("red")
            h.call("subdocument/edit", revision=2, edits=[{"from": at, "to": at + 3, "text": "blue"}])
            frame, after = h.still()
            self.assertEqual(frame["time"], 2)
            self.assertNotEqual(before, after)

    def test_edits_outside_the_text_are_refused_and_change_nothing(self):
        with host() as h:
            h.start(FLYING)
            for edits in ([{"from": 0, "to": 1000, "text": ""}], [{"from": 5, "to": 4, "text": ""}],
                          [{"from": 5, "to": 9, "text": ""}, {"from": 8, "to": 10, "text": ""}]):
                self.assertEqual(h.refused("subdocument/edit", revision=2, edits=edits)["code"], -32003)
            h.call("subdocument/edit", revision=2, edits=[])
            self.assertEqual(h.heard("diagnostics"), {"revision": 2, "items": []})

    def test_an_endless_script_ends_in_a_message_and_pings_are_answered_meanwhile(self):
        with host() as h:
            h.initialize()
            h.call("subdocument/load", text=ENDLESS, revision=1)
            answered = 0
            begin = time.monotonic()
            while not any(m.get("method") == "diagnostics" for m in h.inbox):
                h.call("ping", 60.0)
                answered += 1
                h.receive(0.05)
                self.assertLess(time.monotonic() - begin, 60, "the script has no end")
            self.assertEqual(h.heard("diagnostics")["items"][0]["severity"], "error")
            # Answered one after the other while the script ran, not all of them when it had ended.
            self.assertGreater(answered, 5)
            # The next text is not held up by the last.
            h.call("subdocument/load", text=ENDLESS, revision=2)
            h.call("subdocument/load", text=FLYING, revision=3)
            self.assertEqual(h.heard("diagnostics")["revision"], 3)

    def test_pings_are_answered_and_pictures_drawn_while_a_heavy_motion_is_computed(self):
        with host() as h:
            self.assertEqual(h.start(GAS), [])
            h.create(1)
            h.call("time/play")
            answered = 0
            for _ in range(30):
                h.call("ping", 60.0)
                answered += 1
                h.receive(0.05)
            self.assertEqual(answered, 30)
            times = [h.frame(seconds=60)[0]["time"] for _ in range(4)]
            self.assertGreater(times[-1], times[0])
            self.assertEqual(h.call("script/evaluate", script="state")["result"], "computing")
            # Cancelled, it keeps what it has; a new text does not wait for it.
            h.notify("progress/cancel", token=h.heard("progress/begin")["token"])
            kept = h.heard("time/changed", where=lambda p: p["state"] == "failed")
            self.assertGreater(kept["computed"], 0)
            h.call("menu/invoke", id="recompute", rendition=None)
            h.call("subdocument/load", text=FLYING, revision=2)
            h.heard("time/changed", where=lambda p: p["state"] == "current" and p["finish"] == 4)

    def test_pings_are_answered_while_a_large_picture_is_drawn(self):
        with host() as h:
            h.start(FLYING)
            h.create(1, 4000, 4000, show=False)
            h.heard("time/changed", where=lambda p: p["state"] == "current")
            h.notify("rendition/show", rendition=1)
            answered = 0
            while not any(m.get("method") == "rendition/frame" for m in h.inbox):
                h.call("ping", seconds=2)
                answered += 1
                time.sleep(0.01)
            self.assertGreater(answered, 5)

    def test_parameters_are_set_without_editing_the_text(self):
        with host() as h:
            h.start(BRAKED)
            self.assertEqual(h.call("parameter/list"), [{"name": "speed", "value": 1, "min": 0, "max": 2, "label": "Speed", "unit": "m/s"}])
            h.create(1)
            h.call("time/seek", time=4)
            _, before = h.still()
            h.notify("parameter/set", name="speed", value=7)  # beyond its bounds: the nearest
            _, after = h.still()
            self.assertNotEqual(before, after)
            self.assertEqual(h.call("parameter/list")[0]["value"], 2)
            # The override outlives the parameter's removal, and comes back with it.
            h.call("subdocument/load", text=FLYING, revision=2)
            self.assertEqual(h.heard("diagnostics", where=lambda p: p["revision"] == 2)["items"], [])


    def test_values_are_read_and_told_while_it_plays(self):
        with host() as h:
            h.start(FLYING)
            read = h.call("value/read", expressions=["b.x", "c.x", "2*t"], time=1)
            self.assertAlmostEqual(read["values"][0], -1, places=6)
            self.assertEqual(read["values"][1:], [None, 2])
            self.assertEqual([bool(fault) for fault in read["faults"]], [False, True, False])
            self.assertIn("c.x", read["faults"][1])
            offers = h.call("value/list")
            self.assertIn({"expression": "b.dx", "label": "b: velocity x"}, offers)
            values = h.call("value/read", expressions=[offer["expression"] for offer in offers], time=0)
            self.assertNotIn("faults", values, "what is offered can be read")
            h.create(1)
            h.call("value/subscribe", id=3, expressions=["b.x"])
            self.assertEqual(h.heard("value/changed", where=lambda p: p["id"] == 3)["values"], [-2])
            h.call("time/seek", time=4)
            told = h.heard("value/changed", where=lambda p: p["time"] == 4)
            self.assertAlmostEqual(told["values"][0], 2, places=6)
            self.assertNotIn("faults", told)


class Controls(unittest.TestCase):
    def test_keys_that_are_not_used_go_back(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            h.frame()
            h.notify("rendition/input", rendition=1, type="key-press", key="q", text="q")
            self.assertEqual(h.heard("rendition/unhandled")["key"], "q")
            h.notify("rendition/input", rendition=1, type="key-press", key=" ", text=" ")
            h.heard("time/changed", where=lambda p: p["playing"])
            h.notify("rendition/input", rendition=1, type="key-press", key="Home")
            h.notify("rendition/input", rendition=1, type="key-press", key=" ", text=" ", modifiers=["control"])
            self.assertEqual(h.heard("rendition/unhandled")["modifiers"], ["control"])
            h.notify("rendition/input", rendition=1, type="key-press", key=" ", text=" ")
            h.heard("time/changed", where=lambda p: not p["playing"])
            h.notify("rendition/input", rendition=1, type="key-press", key="End")
            h.heard("time/changed", where=lambda p: p["time"] == 4)

    def test_bodies_that_overlap_are_moved_apart_from_the_menu(self):
        with host() as h:
            h.start(FLYING + "body b2 ball -init_pos {-1.8 0 0}\n")
            h.heard("menu/changed", where=lambda p: p["menus"][0]["id"] == "close-joints")
            h.call("menu/invoke", id="close-joints", rendition=None)
            change = h.heard("subdocument/changed")
            self.assertEqual(change["label"], "Move Bodies Apart")
            self.assertTrue(change["edits"])

    def test_an_exact_value_is_asked_for(self):
        with host() as h:
            h.start(FLYING)
            h.create(1)
            frame, picture = h.still()
            red = [i // 4 for i in range(0, len(picture), 4) if picture[i + 2] > 120 and picture[i] < 60]
            at = red[len(red) // 2]
            for kind in ("press", "release"):
                h.notify("rendition/input", rendition=1, type=kind, x=at % frame["width"], y=at // frame["width"], button="left")
            menu = h.heard("menu/changed", where=lambda p: any(e["label"] == "Position\u2026" for e in p["menus"]))["menus"]
            entry = next(e["id"] for e in menu if e["label"] == "Position\u2026")
            question = h.call("menu/invoke", id=entry, rendition=1)["question"]
            self.assertEqual([f["value"] for f in question["fields"]], ["-2", "0", "0"])
            again = h.call("menu/invoke", id=entry, rendition=1, values=["far", "0", "0"])["question"]
            self.assertIn("numbers", again["refusal"])
            self.assertEqual(h.call("menu/invoke", id=entry, rendition=1, values=["-2.5", "0", "0"]), {})
            edit = h.heard("subdocument/changed")["edits"][0]
            self.assertEqual(FLYING[:edit["from"]] + edit["text"] + FLYING[edit["to"]:], FLYING.replace("{-2 0 0}", "{-2.5 0 0}"))

    def test_the_menu_says_what_is_switched_on(self):
        with host() as h:
            menu = {e["id"]: e for e in h.initialize()["menus"]}
            for wanted in ("play pause stop step loop position-handles velocity-handles wireframe axes grid trails "
                           "recompute open-graphical-viewer open-language-viewer rate-0.1 rate-4").split():
                self.assertIn(wanted, menu)
            self.assertEqual(menu["open-graphical-viewer"]["mode"], "edit")
            self.assertFalse(menu["play"]["enabled"])
            h.call("subdocument/load", text=FLYING, revision=1)
            h.heard("menu/changed", where=lambda p: any(e["id"] == "play" and e["enabled"] for e in p["menus"]))
            h.create(1)
            _, before = h.still()
            h.call("menu/invoke", id="wireframe", rendition=None)
            changed = h.heard("menu/changed")["menus"]
            self.assertTrue(next(e["checked"] for e in changed if e["id"] == "wireframe"))
            _, after = h.still()
            self.assertNotEqual(before, after)
            h.call("menu/invoke", id="rate-0.25", rendition=None)
            self.assertEqual(h.heard("time/changed", where=lambda p: p["rate"] != 1)["rate"], 0.25)
            self.assertEqual(h.refused("menu/invoke", id="open-language-viewer", rendition=None)["code"], -32003)
            self.assertEqual(h.refused("menu/invoke", id="fly", rendition=None)["code"], -32602)

    def test_its_own_commands(self):
        with host() as h:
            h.start(FLYING)
            h.heard("time/changed", where=lambda p: p["state"] == "current")
            self.assertEqual(h.call("script/evaluate", script="bodies")["result"], "b")
            self.assertEqual(h.call("script/evaluate", script=" time 1.25 ")["result"], "1.25")
            self.assertEqual(h.call("script/evaluate", script="state")["result"], "current")
            self.assertIn("play", h.refused("script/evaluate", script="fly")["message"])


class Endings(unittest.TestCase):
    def wait(self, h, seconds=60):
        return h.process.wait(seconds)

    def test_exit_and_the_end_of_the_pipe_end_it(self):
        with host() as h:
            h.start(FLYING)
            h.call("shutdown")
            h.notify("exit")
            self.assertEqual(self.wait(h), 0)
        with host() as h:
            h.start(FLYING)
            h.process.stdin.close()
            self.assertEqual(self.wait(h), 0)

    def test_what_is_not_the_protocol_ends_it_with_a_sentence(self):
        for garbage in (b"GET / HTTP/1.1\r\n\r\n", b"\x00" * 50, b"Content-Length: 99999999999\r\n\r\n",
                        b"Content-Length: 4\r\n\r\n[1,2", b"Content-Length: 2\r\n\r\n[]", b"x" * 2000):
            with host() as h:
                h.initialize()
                h.send_bytes(garbage)
                self.assertEqual(self.wait(h), 1)
                self.assertIn(b"the host sent", h.process.stderr.read())

    def test_no_common_version_ends_it(self):
        with host() as h:
            error = h.refused("initialize", protocol=[2, 9], mode="play", frames=None, **{"class": "ANIMATION"})
            self.assertEqual(error["code"], -32001)
            self.assertEqual(self.wait(h), 0)

    def test_nothing_is_served_before_initialize_and_pings_are(self):
        with host() as h:
            h.call("ping")
            self.assertEqual(h.refused("subdocument/load", text="", revision=1)["code"], -32600)
            self.assertEqual(h.refused("fly")["code"], -32601)
            self.assertEqual(h.refused("initialize", protocol="1")["code"], -32602)

    def test_it_does_not_outlive_its_host_even_while_it_reads_or_computes(self):
        for text in (ENDLESS, GAS):
            with self.subTest(text=text):
                self.outlived(text)

    def outlived(self, text):
        starter = (
            "import sys, time; sys.path.insert(0, sys.argv[1])\n"
            "from small_host import SmallHost\n"
            "h = SmallHost([sys.argv[2], '--medium']); h.initialize()\n"
            "h.call('subdocument/load', text=sys.argv[3], revision=1)\n"
            "print(h.process.pid, flush=True); time.sleep(600)\n")
        parent = subprocess.Popen([sys.executable, "-c", starter, os.path.dirname(os.path.abspath(__file__)), ASGARD, text],
                                  stdout=subprocess.PIPE)
        try:
            medium = int(parent.stdout.readline())
            before = cpu_seconds(medium)
            until("it reads or computes",
                  lambda: sum(map(cpu_seconds, {medium} | children(medium))) > before + 0.3)
            family = {medium} | children(medium)
            self.assertGreaterEqual(len(family), 2, "the evaluator server is missing")
            end_by_kill(parent.pid)
            parent.wait()
            until("its medium has ended", lambda: not any(map(running, family)))
        finally:
            parent.stdout.close()

    def test_a_stopped_host_is_not_sent_more_than_it_can_take(self):
        with host(frames=False) as h:
            h.start(FLYING.replace("-finish 4", "-finish 1000"))
            h.create(1, 400, 300)
            h.call("time/play")
            for _ in range(2):
                h.heard("rendition/frame", 60.0)
            time.sleep(1.5)  # nothing is read or acknowledged
            h.call("ping", 60.0)
            self.assertEqual([m for m in h.drain(0.5) if m.get("method") == "rendition/frame"], [])


if __name__ == "__main__":
    ASGARD = os.path.abspath(sys.argv.pop(1))
    signal.signal(signal.SIGPIPE, signal.SIG_IGN)
    unittest.main(verbosity=1)
