#!/usr/bin/env python3
"""No medium outlives its host: the host is killed while its media compute, hang, have children of their own."""
import os
import signal
import subprocess
import time
import unittest

from running import ENSEMBLE, InFolder, main, memo, scripted

ROUNDS = int(os.environ.get("KILLS", "3"))


def descendants(pid):
    found = []
    try:
        for task in os.listdir("/proc/%d/task" % pid):
            with open("/proc/%d/task/%s/children" % (pid, task), encoding="ascii") as f:
                found += [int(word) for word in f.read().split()]
    except FileNotFoundError:
        pass
    return found


def alive(pid):
    try:
        with open("/proc/%d/stat" % pid, encoding="utf-8") as f:
            return f.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


class Orphans(InFolder):
    def test_killed_host(self):
        behaviours = ["colour 102030", "behave busy", "behave hang", "behave stay", "behave flood"]
        self.write("a.ens", memo(*[scripted(text) for text in behaviours]))
        for _ in range(ROUNDS):
            host = subprocess.Popen([ENSEMBLE, "a.ens"], cwd=self.folder.name, stderr=subprocess.DEVNULL,
                                    env=self.environment(QT_QPA_PLATFORM="offscreen"))
            deadline = time.monotonic() + 120
            media = []
            while len(media) < 3 and time.monotonic() < deadline:
                time.sleep(0.05)
                media = descendants(host.pid)
            self.assertGreaterEqual(len(media), 3)
            time.sleep(0.5)
            media = descendants(host.pid)
            host.send_signal(signal.SIGKILL)
            host.wait()
            # A second on an idle machine; how long the dead wait for a processor is not theirs to say.
            deadline = time.monotonic() + 20
            while any(alive(pid) for pid in media) and time.monotonic() < deadline:
                time.sleep(0.02)
            self.assertEqual([pid for pid in media if alive(pid)], [])


if __name__ == "__main__":
    main()
