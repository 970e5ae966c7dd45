"""A display of its own with a window manager, and what a person does at it: look, point, press keys.

Whatever is waited for is polled for, with a limit that only a hang reaches, so that load changes no verdict."""
import os
import subprocess
import time

LONGEST = 120.0


class Picture:
    """What a window shows, as rows of RGB bytes."""

    def __init__(self, ppm):
        magic, size, most, self.pixels = ppm.split(b"\n", 3)
        assert (magic, most) == (b"P6", b"255"), (magic, most)
        self.width, self.height = (int(word) for word in size.split())

    def isGrey(self, x, y):
        red, green, blue = self.pixels[3 * (y * self.width + x):][:3]
        return max(red, green, blue) - min(red, green, blue) < 8 and 70 < green < 215

    def isColored(self, x, y):
        rgb = self.pixels[3 * (y * self.width + x):][:3]
        return max(rgb) - min(rgb) > 60

    def greySpots(self, side=16, step=8):
        """Places of grey squares: the memo's balls are the only large grey things in its window."""
        corners = [(0, 0), (side, 0), (0, side), (side, side), (side // 2, side // 2)]
        return {(x + side // 2, y + side // 2)
                for y in range(0, self.height - side, step) for x in range(0, self.width - side, step)
                if all(self.isGrey(x + dx, y + dy) for dx, dy in corners)}


class Screen:
    def __init__(self, folder, size="1100x1000x24"):
        reading, writing = os.pipe()
        # Without -noreset the server begins anew whenever its last client leaves, and throws out who comes at that moment.
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writing), "-screen", "0", size, "-nolisten", "tcp", "-noreset"],
            pass_fds=[writing], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as f:
            display = ":" + f.readline().strip()
        run = os.path.join(folder, "run")
        os.mkdir(run, 0o700)
        self.environment = {"PATH": os.environ["PATH"], "HOME": folder, "DISPLAY": display, "XDG_RUNTIME_DIR": run,
                            "LC_ALL": "C.UTF-8"}
        self.words = os.path.join(folder, "window-manager")
        with open(self.words, "wb") as f:
            self.manager = subprocess.Popen(["openbox"], env=self.environment, stdout=f, stderr=f)
        until("the window manager runs", self.isManaged)

    def isManaged(self):
        if self.manager.poll() is not None:
            with open(self.words) as f:
                raise AssertionError(f"the window manager ended ({self.manager.returncode}): {f.read()}")
        return b"window id" in self.output("xprop", "-root", "_NET_SUPPORTING_WM_CHECK")

    def close(self):
        for process in (self.manager, self.server):
            process.terminate()
            process.wait()

    def output(self, *command):
        return subprocess.run([str(word) for word in command], env=self.environment, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL).stdout

    def windows(self, title=""):
        return self.output("xdotool", "search", "--onlyvisible", "--name", title).decode().split()

    def active(self):
        """The window that the window manager gave the keys; None where none has them."""
        number = self.output("xdotool", "getactivewindow").strip()
        return int(number) if number else None

    def picture(self, window, rect=None):
        """Of a window or a part of it; None while it cannot be read."""
        part = ["-crop", "%dx%d+%d+%d" % (rect[2], rect[3], rect[0], rect[1]), "+repage"] if rect else []
        ppm = self.output("import", "-window", window, *part, "-depth", "8", "ppm:-")
        return Picture(ppm) if ppm else None

    def do(self, *words):
        subprocess.run(["xdotool", *[str(word) for word in words]], env=self.environment, check=True,
                       stdout=subprocess.DEVNULL)


def until(what, probe):
    """Polls until `probe` gives something true, and gives it."""
    deadline = time.monotonic() + LONGEST
    while True:
        found = probe()
        if found:
            return found
        if time.monotonic() > deadline:
            raise AssertionError("in vain waited until " + what)
        time.sleep(0.1)
