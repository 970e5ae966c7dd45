"""A person at the windows of programs: looks where things are, points, presses keys, chooses from menus.

The programs say themselves what their windows show and where (README.md), so nothing here knows a pixel, and nothing
sleeps: whoever asks the programs gets an answer once they have handled all keys and moves before it."""
import csv
import io
import json
import os
import re
import socket
import subprocess

from screen import LONGEST, Screen, until

PICTURES = os.environ.get("ASGARD_SCREENSHOTS")  # a folder that gets a picture of the screen for each step


class Seen(dict):
    """A window, widget, row or action; what it does not have is None."""
    __getattr__ = dict.get

    @property
    def middle(self):
        left, top, width, height = self.rect
        return left + width / 2, top + height / 2


def told(at, points):
    """What the process that listens there says of its windows; none when it is about to end."""
    answer = b""
    with socket.socket(socket.AF_UNIX) as process:
        process.settimeout(LONGEST)
        try:
            process.connect(at)
            process.sendall(json.dumps({"points": points}).encode() + b"\n")
            while piece := process.recv(1 << 20):
                answer += piece
        except (FileNotFoundError, ConnectionError):
            return []
    return json.loads(answer, object_hook=Seen).windows if answer else []


def same(label, text):
    """Menus say by three dots that they ask for more."""
    return label == text.removesuffix("…")


def isInside(rect, place, margin=0):
    return all(begin + margin <= x < begin + length - margin for begin, length, x in zip(rect[:2], rect[2:], place))


class Person:
    def __init__(self, test, folder, program, arguments, size="1500x1000x24"):
        self.test = test
        self.screen = Screen(folder, size)
        test.addCleanup(self.screen.close)
        self.places = os.path.join(folder, "places")
        os.mkdir(self.places)
        self.program = self.start(program, arguments)
        self.seen = 0
        test.addCleanup(self.look, "end")

    def start(self, program, arguments):
        """A program on this screen, until the test ends."""
        plugins = os.path.join(os.path.dirname(os.path.abspath(program)), os.pardir, "test-plugins")
        if not os.path.exists(os.path.join(plugins, "generic", "libplaces.so")):
            raise FileNotFoundError(f"{plugins}: the target `widget_places` is not built")
        started = subprocess.Popen(
            [program, *arguments], stdin=subprocess.DEVNULL,
            env=dict(self.screen.environment, QT_PLUGIN_PATH=plugins, QT_QPA_GENERIC_PLUGINS="places:" + self.places))
        self.test.addCleanup(started.wait)
        self.test.addCleanup(started.kill)
        return started

    # --- what there is to see
    def windows(self, points=()):
        """Of all processes, as they are when these have handled what was done before."""
        return [window for process in os.listdir(self.places)
                for window in told(os.path.join(self.places, process), points)]

    def find(self, name, points=()):
        """The window of that object name or title, or None."""
        for window in self.windows(points):
            if name in (window.name, window.title):
                return window
        return None

    def window(self, name, points=()):
        return until("there is a window " + name, lambda: self.find(name, points))

    def gone(self, name):
        until(f"the window {name} is gone", lambda: not self.find(name))

    def isModified(self, name):
        return self.window(name).modified

    def widget(self, window, name):
        """Once it can be used. Its places are pixels of the window."""
        def usable():
            return next((one for one in self.window(window).widgets if one.name == name and one.enabled), None)

        return until(f"{window} has {name}", usable)

    def row(self, window, name, begins):
        def listed():
            return next((one for one in self.widget(window, name).rows if one.text.startswith(begins)), None)

        return until(f"{name} of {window} has the row {begins}", listed)

    def action(self, window, *path):
        """The entry of the window's menus, open or not; None where there is none."""
        bar = next(one for one in self.window(window).widgets if one.type == "QMenuBar")
        found = bar
        for label in path:
            found = next((one for one in found.actions or [] if same(label, one.text)), None)
            if found is None:
                return None
        return found

    def scene(self, window, *points):
        """The picture in the window, and where it shows these points of its scene."""
        scene = next(one for one in self.window(window, points).widgets if one.points is not None)
        return scene, scene.points

    def point(self, window, *at):
        scene, [place] = self.scene(window, at)
        self.test.assertTrue(isInside(scene.rect, place), f"{at} is out of sight")
        return place

    def picture(self, window, name):
        """The pixels of a widget, or None while the window cannot be read."""
        return self.screen.picture(self.window(window).id, self.widget(window, name).rect)

    def look(self, name):
        self.seen += 1
        if PICTURES:
            self.windows()
            os.makedirs(PICTURES, exist_ok=True)
            self.screen.output("import", "-window", "root", os.path.join(PICTURES, f"{self.seen:02}-{name}.png"))

    # --- keys
    def activate(self, name):
        """Its process and the window manager both say so: Qt calls a window active for 400 ms after it lost the keys."""
        def active():
            window = self.find(name)
            has = window and window.active and self.screen.active() == window.id
            if window and not has:
                self.screen.output("xdotool", "windowactivate", window.id)
            return has

        until(f"the window {name} is active", active)

    def press(self, window, *keys):
        self.activate(window)
        self.screen.do("key", "--clearmodifiers", *keys)

    def type(self, text):
        self.screen.do("type", "--clearmodifiers", "--delay", 15, "--", text)

    def fill(self, window, text):
        """Types instead of what the field has that has the keyboard."""
        self.screen.do("key", "ctrl+a")
        self.type(text)
        until(f"a field of {window} says {text}",
              lambda: any(one.focus and text in (one.text, str(one.value)) for one in self.window(window).widgets))

    def answer(self, dialog, text):
        self.activate(dialog)
        self.fill(dialog, text)
        self.screen.do("key", "Return")
        self.gone(dialog)

    # --- pointer
    def at(self, window, place):
        return "mousemove", "--window", window.id, round(place[0]), round(place[1])

    def click(self, window, place, button=1, times=1):
        self.activate(window)
        self.screen.do(*self.at(self.window(window), place), "click", "--repeat", times, "--delay", 40, button)

    def clickOn(self, window, name, times=1):
        self.click(window, self.widget(window, name).middle, times=times)

    def hint(self, window, place, words):
        """Moves about the place until the window's hint has these words: what lies there is known by then."""
        def told():
            for nearby in (place[0] + 1, place[1]), place:
                self.screen.do(*self.at(self.window(window), nearby))
            return words in self.widget(window, "hint").text

        until(f"the hint of {window} speaks of {words}", told)

    def drag(self, window, start, end, key=None):
        """Looks around before it lets go: what it gives is what the windows were then."""
        self.activate(window)
        inside = self.window(window)
        self.screen.do(*self.at(inside, start), *(["keydown", key] if key else []), "mousedown", 1)
        for step in range(1, 9):
            self.screen.do(*self.at(inside, [a + (b - a) * step / 8 for a, b in zip(start, end)]))
            held = self.windows()
        self.screen.do("mouseup", 1, *(["keyup", key] if key else []))
        return held

    # --- menus
    def menus(self):
        return [window for window in self.windows() if window.type == "QMenu"]

    def offered(self, window, *path):
        """Waits until the entry can be chosen, of a menu that is not filled when it is opened."""
        def enabled():
            entry = self.action(window, *path)
            return entry and entry.enabled

        until(f"{window} has {' > '.join(path)}", enabled)

    def menu(self, window, title, *path):
        """From the bar of a window."""
        self.offered(window, title)
        self.click(window, self.action(window, title).middle)
        self.choose(*path)

    def choose(self, *path):
        """From the menu that is open or about to open."""
        used = set()
        for label in path:
            def entry():
                for menu in self.menus():
                    for action in menu.widgets[0].actions if menu.id not in used else []:
                        if same(label, action.text) and action.enabled:
                            return menu, action
                return None

            menu, action = until(f"a menu has {label}", entry)
            used.add(menu.id)
            self.screen.do(*self.at(menu, action.middle), "click", 1)
        until("the menus are closed", lambda: not self.menus())


class Author(Person):
    """Makes a scene with asgard alone. What the file says is what the windows show, once it is written."""

    def __init__(self, test, asgard, folder, text=b""):
        self.asgard = asgard
        self.file = os.path.join(folder, "scene.al")
        with open(self.file, "wb") as file:
            file.write(text)
        super().__init__(test, folder, asgard, [self.file])
        self.widget("graphicalViewer1", "text")

    def giveKeysTo(self, name):
        """The text or the picture has the keyboard then."""
        def given():
            if any(one.focus and one.name == name for one in self.window("graphicalViewer1").widgets):
                return True
            self.press("graphicalViewer1", "F6")
            return False

        until(f"{name} has the keyboard", given)

    def saved(self):
        def written():
            if self.isModified("graphicalViewer1"):
                self.press("graphicalViewer1", "ctrl+s")
                return False
            return True

        until("the scene is saved", written)
        with open(self.file, encoding="utf-8") as file:
            return file.read()

    def says(self, pattern):
        """The saved text has it; gives the match."""
        return until(f"the text says {pattern}", lambda: re.search(pattern, self.saved(), re.M))

    def append(self, pattern, text):
        """Writes at the end of the line that has it, and updates the scene."""
        line = self.saved()[:self.says(pattern).start()].count("\n") + 1
        self.giveKeysTo("text")
        self.press("graphicalViewer1", "ctrl+g")
        self.answer("Go to Line", str(line))
        self.press("graphicalViewer1", "End")
        self.type(text)
        self.press("graphicalViewer1", "ctrl+Return")
        self.giveKeysTo("scene")

    def exactly(self, element, *values):
        """Types the exact values of what is marked, which is of that element."""
        def asked():
            self.press("graphicalViewer1", "Return")
            if not self.isAsked():
                return False  # nothing is marked yet
            if element in self.widget("graphicalViewer1", "valueTitle").text:
                return True
            self.screen.do("key", "Escape")  # what is new is not marked yet
            until("nothing is asked", lambda: not self.isAsked())
            return False

        until(f"values of {element} are asked for", asked)
        for i, value in enumerate(values):
            until(f"value {i + 1} has the keyboard", lambda: self.widget("graphicalViewer1", f"value{i + 1}").focus)
            self.fill("graphicalViewer1", value)
            self.screen.do("key", "Tab" if i + 1 < len(values) else "Return")
        until("the values are taken", lambda: not self.isAsked())

    def motion(self, until_time, *quantities):
        """The saved scene's, every tenth of a second."""
        self.saved()
        table = subprocess.run([self.asgard, "simulate", self.file, "--at", f"0:0.1:{until_time}", "--only",
                                "--quantities", ",".join(quantities)], check=True, capture_output=True, text=True).stdout
        return [[float(cell) for cell in row] for row in list(csv.reader(io.StringIO(table)))[1:]]

    def isAsked(self):
        return any(one.name == "valueEntry" for one in self.window("graphicalViewer1").widgets)

    def colorBox(self):
        """The box about what has a colour in the picture: new bodies have one, the ground and the sky have none."""
        def found():
            picture = self.picture("graphicalViewer1", "scene")
            spots = picture and [(x, y) for y in range(0, picture.height - 4, 3) for x in range(0, picture.width - 4, 3)
                                 if all(picture.isColored(x + dx, y + dy) for dx, dy in ((0, 0), (4, 0), (0, 4), (4, 4)))]
            if not spots:
                return None
            xs, ys = zip(*spots)
            return min(xs), min(ys), max(xs) + 4, max(ys) + 4

        return until("something with a colour is seen", found)


class Newcomer:
    """An author who counts: an action is a click, a drag, a command's key, or a text that is typed."""

    def __init__(self, author, viewer="graphicalViewer1"):
        self.author = author
        self.viewer = viewer
        self.actions = 0

    def create(self, *path):
        self.author.menu(self.viewer, "Create", *path)
        self.actions += 1 + len(path)

    def createByTool(self, tool, entry):
        """From the tool bar's menu."""
        self.author.clickOn(self.viewer, "tool." + tool)
        self.author.choose(entry)
        self.actions += 2

    def accept(self, offer):
        """The button of what the picture offers."""
        self.author.clickOn(self.viewer, offer)
        self.actions += 1

    def click(self, *place, key=None):
        if key:
            self.author.screen.do("keydown", key)
        self.author.click(self.viewer, self.author.point(self.viewer, *place))
        if key:
            self.author.screen.do("keyup", key)
        self.actions += 1

    def type(self, text):
        self.author.type(text)
        self.author.screen.do("key", "Return")
        self.actions += 1

    def enter(self, field, *values):
        """A click selects what a field has; Tab leads to the next one."""
        self.author.clickOn(self.viewer, field)
        until(f"{field} has the keyboard", lambda: self.author.widget(self.viewer, field).focus)
        self.actions += 1
        for value in values[:-1]:
            self.author.type(value)
            self.author.screen.do("key", "Tab")
            self.actions += 1
        self.type(values[-1])

    def choose(self, box, letter):
        self.author.clickOn(self.viewer, box)
        self.author.screen.do("key", letter, "Return")
        self.actions += 2

    def frame(self, *ends):
        """The picture comes when it is drawn: these points are in it then."""
        self.author.giveKeysTo("scene")
        self.author.press(self.viewer, "f")
        self.actions += 1

        def framed():
            scene, places = self.author.scene(self.viewer, *ends)
            return all(isInside(scene.rect, place) for place in places)

        until("all is in sight", framed)

    def play(self, most):
        """With no more actions than these up to here."""
        before = self.author.colorBox()
        self.author.giveKeysTo("scene")
        self.author.press(self.viewer, "space")
        self.actions += 1
        until("it moves", lambda: self.author.colorBox() != before)
        self.author.look("played")
        test = self.author.test
        test.assertLessEqual(self.actions, most)
        print(f"{test.id().split('.')[-1]}: {self.actions} actions")
