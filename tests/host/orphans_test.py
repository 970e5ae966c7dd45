#!/usr/bin/env python3
"""No medium outlives its host, and nothing that it started: the host is killed while its media compute, hang, and have
children that left their session and their parent."""
import os
import signal
import subprocess
import sys
import unittest

from running import ENSEMBLE, SOURCE, InFolder, main, memo, scripted

sys.path.insert(0, os.path.join(SOURCE, "tests", "desktop"))
from screen import until  # noqa: E402

ROUNDS = int(os.environ.get("KILLS", "3"))


def descendants(pid):
    children = []
    try:
        for task in os.listdir("/proc/%d/task" % pid):
            with open("/proc/%d/task/%s/children" % (pid, task), encoding="ascii") as f:
                children += [int(word) for word in f.read().split()]
    except (FileNotFoundError, ProcessLookupError):
        pass
    return children + [one for child in children for one in descendants(child)]


def sleeping(seconds):
    """The processes `sleep SECONDS`, whoever their parents are."""
    found = []
    for pid in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open("/proc/%s/cmdline" % pid, "rb") as f:
                if f.read().split(b"\0")[:2] == [b"sleep", b"%d" % seconds]:
                    found.append(int(pid))
        except (FileNotFoundError, ProcessLookupError):
            pass
    return found


def end_all(seconds):
    for pid in sleeping(seconds):
        os.kill(pid, signal.SIGKILL)


def status(pid):
    """The words of /proc/PID/stat from the state on; none when it is gone."""
    try:
        with open("/proc/%d/stat" % pid, encoding="utf-8") as f:
            return f.read().rsplit(")", 1)[1].split()
    except (FileNotFoundError, ProcessLookupError):
        return None


def alive(pid):
    words = status(pid)
    return words is not None and words[0] != "Z"


def computes(pid):
    """It has had a second of a processor: more than a medium needs to start."""
    words = status(pid)
    return words is not None and int(words[11]) > os.sysconf("SC_CLK_TCK")


class Orphans(InFolder):
    def test_killed_host(self):
        seconds = 3_000_000 + os.getpid()
        self.addCleanup(end_all, seconds)
        behaviours = ["behave daemon %d" % seconds, "behave daemon %d\nbehave busy" % seconds, "behave hang",
                      "behave stay", "behave flood"]
        self.write("a.ens", memo(*[scripted(text) for text in behaviours]))
        for _ in range(ROUNDS):
            host = subprocess.Popen([ENSEMBLE, "a.ens"], cwd=self.folder.name, stderr=subprocess.DEVNULL,
                                    env=self.environment(QT_QPA_PLATFORM="offscreen"))
            until("media have left processes behind", lambda: len(sleeping(seconds)) >= 2)
            until("one of them computes", lambda: any(map(computes, descendants(host.pid))))
            media = descendants(host.pid)
            self.assertGreaterEqual(len(media), 5)
            host.send_signal(signal.SIGKILL)
            host.wait()
            until("its media have ended", lambda: not any(map(alive, media)))
            until("what left them has ended", lambda: not sleeping(seconds))

    def test_a_host_that_ends_by_itself(self):
        seconds = 4_000_000 + os.getpid()
        self.addCleanup(end_all, seconds)
        self.write("a.ens", memo(scripted("behave daemon %d" % seconds)))
        self.assertEqual(self.ensemble("--convert-to", "pdf", "a.ens")[0], 0)
        self.assertEqual(sleeping(seconds), [])


if __name__ == "__main__":
    main()
