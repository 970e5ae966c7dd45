"""A document host of one subdocument, small enough to read: starts a medium, speaks docs/medium-protocol.md, keeps what came.

Everything waits with a limit and fails by saying what was awaited and what came instead.
"""
import fcntl
import json
import mmap
import os
import select
import signal
import subprocess
import time

FRAME_BYTES = 1 << 28
PAGE = 4096


class Died(AssertionError):
    pass


class SmallHost:
    def __init__(self, command, environment=None, frames=True):
        self.fd = os.memfd_create("frames", os.MFD_ALLOW_SEALING | os.MFD_CLOEXEC)
        os.ftruncate(self.fd, FRAME_BYTES)
        fcntl.fcntl(self.fd, 1033, 0x2 | 0x4)  # F_ADD_SEALS: F_SEAL_SHRINK, F_SEAL_GROW
        self.memory = mmap.mmap(self.fd, FRAME_BYTES)
        self.frames, self.free = frames, 0
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                        pass_fds=[self.fd], env=environment or {})
        os.set_blocking(self.process.stdout.fileno(), False)
        self.bytes, self.inbox, self.last_id, self.slots = bytearray(), [], 0, {}
        self.log = b""

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            try:
                pipe.close()
            except BrokenPipeError:
                pass
        self.memory.close()
        os.close(self.fd)

    # --- messages ------------------------------------------------------------------------------

    def send_bytes(self, data):
        os.write(self.process.stdin.fileno(), data)

    def _send(self, **message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.send_bytes(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def notify(self, method, **params):
        self._send(method=method, params=params)

    def ask(self, method, **params):
        """Sends a request; its number."""
        self.last_id += 1
        self._send(id=self.last_id, method=method, params=params)
        return self.last_id

    def answer(self, number, seconds=60.0):
        """The whole answer to a request."""
        return self.until(lambda m: m.get("id") == number and "method" not in m, seconds, f"the answer to request {number}")

    def call(self, method, seconds=60.0, **params):
        """The result of a request; an error fails the test."""
        answer = self.answer(self.ask(method, **params), seconds)
        assert "result" in answer, f"{method} was refused: {answer['error']}"
        return answer["result"]

    def refused(self, method, **params):
        """The error of a request; a result fails the test."""
        answer = self.answer(self.ask(method, **params))
        assert "error" in answer, f"{method} was not refused"
        return answer["error"]

    def heard(self, method, seconds=60.0, where=lambda params: True):
        """The parameters of the next notification of that name for which `where` holds."""
        found = self.until(lambda m: m.get("method") == method and where(m.get("params", {})), seconds, method)
        return found["params"]

    def until(self, wanted, seconds, what):
        end = time.monotonic() + seconds
        while True:
            for i, message in enumerate(self.inbox):
                if wanted(message):
                    return self.inbox.pop(i)
            if not self.receive(end - time.monotonic()):
                came = [m.get("method", "an answer") for m in self.inbox[-8:]]
                raise AssertionError(f"waited {seconds} s for {what}; came: {came}")

    def receive(self, seconds):
        """Reads what has come within that time; False when nothing came."""
        if seconds <= 0 or not select.select([self.process.stdout], [], [], seconds)[0]:
            return False
        data = self.process.stdout.read(1 << 20)
        if not data:
            self.process.wait(5)
            raise Died(f"the medium ended ({self.process.returncode}): {self.process.stderr.read().decode()}")
        self.bytes += data
        while (end := self.bytes.find(b"\r\n\r\n")) >= 0:
            length = int(self.bytes[:end].split(b":")[1])
            if len(self.bytes) < end + 4 + length:
                break
            self.inbox.append(json.loads(self.bytes[end + 4:end + 4 + length]))
            del self.bytes[:end + 4 + length]
        return True

    def drain(self, seconds):
        """Everything that comes within that time."""
        end = time.monotonic() + seconds
        while (rest := end - time.monotonic()) > 0:
            self.receive(rest)
        came, self.inbox = self.inbox, []
        return came

    # --- what every test begins with -----------------------------------------------------------

    def initialize(self, document_class="ANIMATION", mode="play"):
        frames = {"fd": self.fd, "bytes": FRAME_BYTES} if self.frames else None
        return self.call("initialize", protocol=[1, 1], mode=mode, frames=frames, locale="en", **{"class": document_class})

    def start(self, text, document_class="ANIMATION", mode="play"):
        """Initialized, the text loaded, and what is wrong with it."""
        self.initialize(document_class, mode)
        self.call("subdocument/load", text=text, revision=1)
        return self.heard("diagnostics")["items"]

    def allocate(self, width, height):
        stride = 4 * width
        slot = {"offset": self.free, "stride": stride}
        self.free += (stride * height + PAGE - 1) // PAGE * PAGE
        return slot

    def create(self, rendition, width=200, height=150, show=True, presentation=""):
        slots = [self.allocate(width, height) for _ in (0, 1)] if self.frames else []
        self.slots[rendition] = slots
        self.call("rendition/create", rendition=rendition, presentation=presentation, width=width, height=height, scale=1, slots=slots)
        if show:
            self.notify("rendition/show", rendition=rendition)

    def frame(self, rendition=1, seconds=60.0, acknowledge=True):
        """The next frame's message and its pixels."""
        frame = self.heard("rendition/frame", seconds, lambda p: p["rendition"] == rendition)
        slot = self.slots[rendition][frame["slot"]]
        pixels = self.memory[slot["offset"]:slot["offset"] + slot["stride"] * frame["height"]]
        if acknowledge:
            self.acknowledge(frame)
        return frame, pixels

    def acknowledge(self, frame):
        self.notify("rendition/ack", rendition=frame["rendition"], serial=frame["serial"])

    def still(self, rendition=1, seconds=60.0):
        """The last frame, once none follows though the medium had every occasion."""
        frame, pixels = self.frame(rendition, seconds)
        while True:
            kept = self.inbox
            self.inbox = []
            came = self.drain(0.5)
            for _ in (0, 1):  # what is due when the first comes is done before the second
                self.call("ping")
            self.inbox = kept + came + self.inbox
            if not any(m.get("method") == "rendition/frame" and m["params"]["rendition"] == rendition for m in self.inbox):
                return frame, pixels
            frame, pixels = self.frame(rendition, seconds)

    def cpu_seconds(self):
        """Of the medium's process."""
        return cpu_seconds(self.process.pid)


def cpu_seconds(pid):
    """What a process has had so far; 0 when it is gone."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            fields = file.read().rsplit(")", 1)[1].split()
    except (FileNotFoundError, ProcessLookupError):
        return 0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def running(pid):
    """Whether that process exists and is no zombie."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            return file.read().rsplit(")", 1)[1].split()[0] != "Z"
    except FileNotFoundError:
        return False


def children(pid):
    """The processes below that one."""
    below = set()
    for name in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{name}/stat") as file:
                parent = int(file.read().rsplit(")", 1)[1].split()[1])
        except (FileNotFoundError, ProcessLookupError):
            continue
        if parent == pid:
            below |= {int(name)} | children(int(name))
    return below


def end_by_kill(pid):
    os.kill(pid, signal.SIGKILL)
