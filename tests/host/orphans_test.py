#!/usr/bin/env python3
"""No medium outlives its host: the host is killed while its media compute, hang, have children of their own."""
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
    found = []
    try:
        for task in os.listdir("/proc/%d/task" % pid):
            with open("/proc/%d/task/%s/children" % (pid, task), encoding="ascii") as f:
                found += [int(word) for word in f.read().split()]
    except FileNotFoundError:
        pass
    return found


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
        behaviours = ["colour 102030", "behave busy", "behave hang", "behave stay", "behave flood"]
        self.write("a.ens", memo(*[scripted(text) for text in behaviours]))
        for _ in range(ROUNDS):
            host = subprocess.Popen([ENSEMBLE, "a.ens"], cwd=self.folder.name, stderr=subprocess.DEVNULL,
                                    env=self.environment(QT_QPA_PLATFORM="offscreen"))
            until("media have started", lambda: len(descendants(host.pid)) >= 3)
            until("one of them computes", lambda: any(map(computes, descendants(host.pid))))
            media = descendants(host.pid)
            host.send_signal(signal.SIGKILL)
            host.wait()
            until("its media have ended", lambda: not any(map(alive, media)))


if __name__ == "__main__":
    main()
