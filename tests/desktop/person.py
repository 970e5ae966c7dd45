"""A person at the editor's windows: opens menus, types, drags, looks, and keeps pictures of what was seen.

ASGARD_SCREENSHOTS names a folder that gets a picture of the screen for each step."""
import os
import re
import subprocess
import time

from screen import Screen, until

PICTURES = os.environ.get("ASGARD_SCREENSHOTS")


class Person:
    def __init__(self, test, asgard, folder, text=b""):
        self.test, self.asgard = test, asgard
        self.file = os.path.join(folder, "scene.al")
        with open(self.file, "wb") as file:
            file.write(text)
        self.screen = Screen(folder, "1500x1000x24")
        test.addCleanup(self.screen.close)
        self.program = subprocess.Popen([asgard, self.file], env=self.screen.environment, stdin=subprocess.DEVNULL)
        test.addCleanup(self.program.wait)
        test.addCleanup(self.program.kill)
        self.language = self.window("Language Viewer")
        self.graphical = self.window("Graphical Viewer")
        self.panel = until("there is a control panel", lambda: self.screen.windows("^Asgard$"))[0]
        self.seen = 0
        test.addCleanup(self.look, "end")

    # --- windows
    def window(self, title):
        return until("there is a " + title, lambda: self.screen.windows(title))[0]

    def activate(self, window):
        def active():
            self.screen.output("xdotool", "windowactivate", window)
            return self.screen.output("xdotool", "getactivewindow").decode().strip() == window

        until("a window is active", active)

    def press(self, window, *keys):
        self.activate(window)
        self.screen.do("key", "--clearmodifiers", *keys)

    def type(self, text):
        self.screen.do("type", "--clearmodifiers", "--delay", 15, "--", text)

    def answer(self, title, text):
        """Types into a dialog."""
        dialog = self.window(title)
        self.activate(dialog)
        self.screen.do("key", "ctrl+a")
        self.type(text)
        self.screen.do("key", "Return")
        until(f"{title} is closed", lambda: not self.screen.windows(title))

    def changes(self, window, act):
        """Until the window shows something else."""
        self.activate(window)
        time.sleep(0.5)
        before = self.screen.output("import", "-window", window, "-depth", "8", "ppm:-")
        act()
        until("the window changes", lambda: self.screen.output("import", "-window", window, "-depth", "8", "ppm:-") != before)
        time.sleep(0.3)

    def menu(self, window, opens, *path):
        """Goes from menu to menu by keys; the last one chooses."""
        self.activate(window)
        for key in (opens, *path[:-1]):
            before = set(self.screen.windows())
            self.screen.do("key", key)
            until(f"a menu opens by {key}", lambda: set(self.screen.windows()) - before)
            time.sleep(0.2)
        for key in path[-1].split():
            self.screen.do("key", key)

    # --- pointer
    def to(self, window, at):
        self.screen.do("mousemove", "--window", window, round(at[0]), round(at[1]))

    def click(self, window, at, button=1, times=1):
        self.activate(window)
        self.to(window, at)
        time.sleep(0.1)
        self.screen.do("click", "--repeat", times, "--delay", 40, button)

    def drag(self, window, start, end, button=1, key="shift"):
        self.activate(window)
        self.to(window, start)
        if key:
            self.screen.do("keydown", key)
        self.screen.do("mousedown", button)
        for step in range(1, 9):
            self.to(window, [a + (b - a) * step / 8 for a, b in zip(start, end)])
            time.sleep(0.05)
        self.screen.do("mouseup", button)
        if key:
            self.screen.do("keyup", key)

    # --- what there is to see
    def saved(self):
        """What stands in the file, once it is written: it is what the windows show."""
        def written():
            self.press(self.language, "ctrl+s")
            time.sleep(0.2)
            return "*" not in self.title(self.language)

        until("the scene is saved", written)
        with open(self.file, encoding="utf-8") as file:
            return file.read()

    def title(self, window):
        return self.screen.output("xdotool", "getwindowname", window).decode()

    def says(self, pattern):
        """The saved text has it; gives the match."""
        def found():
            return re.search(pattern, self.saved(), re.M)

        return until(f"the text says {pattern}", found)

    def line(self, pattern):
        return self.saved()[:self.says(pattern).start()].count("\n") + 1

    def append(self, pattern, text):
        """Writes at the end of the line that has it, and updates the scene."""
        line = self.line(pattern)
        self.press(self.language, "ctrl+g")
        self.answer("Go to Line", str(line))
        self.press(self.language, "End")
        self.type(text)
        self.press(self.language, "ctrl+Return")

    def grey(self, window, area):
        """The box about what is grey in a part of a window: bodies without a colour."""
        def found():
            picture = self.screen.picture(window)
            if not picture:
                return None
            left, top, right, bottom = area
            spots = [(x, y) for y in range(top, bottom, 3) for x in range(left, right, 3)
                     if all(picture.isGrey(x + dx, y + dy) for dx, dy in ((0, 0), (4, 0), (0, 4), (4, 4)))]
            if not spots:
                return None
            xs, ys = zip(*spots)
            return min(xs), min(ys), max(xs) + 4, max(ys) + 4

        return until("something grey is seen", found)

    def look(self, name):
        self.seen += 1
        if PICTURES:
            time.sleep(1)
            os.makedirs(PICTURES, exist_ok=True)
            self.screen.output("import", "-window", "root", os.path.join(PICTURES, f"{self.seen:02}-{name}.png"))
