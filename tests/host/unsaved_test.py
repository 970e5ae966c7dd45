#!/usr/bin/env python3
"""What is not saved outlives the host: it is killed after edits, and the next start offers what they made.

usage: unsaved_test.py PATH-TO-ENSEMBLE SOURCE-FOLDER

The scripted medium asks for a change of its text as soon as it is loaded, so every start has an edit. UNSAVED_KILLS
kills as many hosts (default 3), each of which has opened what the one before had not saved."""
import os
import random
import signal
import subprocess
import sys
import time
import unittest

from running import ENSEMBLE, SOURCE, InFolder, main, memo, scripted

sys.path.insert(0, os.path.join(SOURCE, "tests", "desktop"))
from screen import Screen, until  # noqa: E402

KILLS = int(os.environ.get("UNSAVED_KILLS", "3"))


class Unsaved(InFolder):
    def setUp(self):
        super().setUp()
        os.rmdir(self.path("run"))
        self.screen = Screen(self.folder.name, size="1300x1100x24")
        self.addCleanup(self.screen.close)
        self.hosts = []
        self.addCleanup(lambda: [host.kill() or host.wait() for host in self.hosts])

    def start(self, *arguments):
        environment = dict(self.screen.environment, ENSEMBLE_MEDIA=os.path.join(SOURCE, "tests", "media"))
        self.hosts.append(subprocess.Popen([ENSEMBLE, *arguments], cwd=self.folder.name, env=environment,
                                           stderr=subprocess.DEVNULL))
        return self.hosts[-1]

    def kill(self, host):
        host.send_signal(signal.SIGKILL)
        host.wait()
        self.hosts.remove(host)
        until("its windows are gone", lambda: not self.screen.windows("Ensemble") and not self.screen.windows("Recover"))

    def journal(self):
        return os.path.join(self.folder.name, ".local", "state", "ensemble", "unsaved")

    def kept(self):
        """The bytes of every text in the journal."""
        found = []
        for name in os.listdir(self.journal()) if os.path.isdir(self.journal()) else []:
            if name.endswith(".kept"):
                try:
                    with open(os.path.join(self.journal(), name), "rb") as file:
                        found.append(file.read())
                except FileNotFoundError:
                    pass  # it was replaced meanwhile
        return found

    def changes(self):
        """How many of the medium's changes are in the journal."""
        return [text.count(b"# more") - 1 for text in self.kept()]

    def question(self):
        return until("the next start asks", lambda: self.screen.windows("^Recover$"))[0]

    def answer(self, key):
        question = self.question()

        def active():
            self.screen.output("xdotool", "windowactivate", question)
            return self.screen.output("xdotool", "getactivewindow").decode().strip() == question

        until("the question has the keyboard", active)
        self.screen.do("key", "--clearmodifiers", key)
        until("it is answered", lambda: not self.screen.windows("^Recover$"))

    def test_what_a_killed_host_had_not_saved_is_offered(self):
        # Each process of the medium appends a line once; the host that opens what was recovered gets another.
        self.write("a.ens", memo(scripted("change # more\n")))
        with open(self.path("a.ens"), "rb") as file:
            saved = file.read()
        generator = random.Random(1)
        host = self.start("a.ens")
        until("the first edit is on the disk", lambda: self.changes() == [1])
        for count in range(1, KILLS + 1):
            time.sleep(generator.random() * 0.3)  # whatever it is doing then
            before = max(self.changes())
            self.kill(host)
            self.assertGreaterEqual(before, count)
            host = self.start()
            self.answer("alt+r")
            until("what was recovered is edited on", lambda: self.changes() and max(self.changes()) > before)
            self.assertEqual(len(self.kept()), 1)
            with open(self.path("a.ens"), "rb") as file:
                self.assertEqual(file.read(), saved)
        print("%d kills, %d changes kept" % (KILLS, max(self.changes())))

    def test_two_hosts_leave_each_others_texts_alone(self):
        self.write("a.ens", memo(scripted("change # more\n")))
        self.write("b.ens", memo(scripted("change # more\n")))
        one = self.start("a.ens")
        until("the edit is on the disk", lambda: self.changes() == [1])
        two = self.start("b.ens")
        until("both edits are on the disk", lambda: self.changes() == [1, 1])
        self.assertEqual(self.screen.windows("^Recover$"), [])  # the second one was asked for nothing
        two.send_signal(signal.SIGKILL)
        two.wait()
        self.hosts.remove(two)
        three = self.start()
        self.answer("alt+d")  # Discard: of the dead one's alone
        until("one is left", lambda: self.changes() == [1])
        for host in (one, three):
            host.kill()
            host.wait()
        self.hosts.clear()
        self.assertEqual(self.changes(), [1])
        self.assertIn(b"a.ens", self.kept()[0])


if __name__ == "__main__":
    main()
