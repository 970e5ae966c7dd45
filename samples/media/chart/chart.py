#!/usr/bin/python3 -EsB
"""A medium for charts: class CHART, storage DATA (see table.py). Speaks docs/medium-protocol.md and needs nothing but
Python's standard library; written as a stranger to the document host would write one.

Time runs a cursor along the axis, one row in half a second. Menus switch lines, bars and points.
"""
import base64
import ctypes
import mmap
import os
import resource
import signal
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.realpath(__file__)))

from picture import Chart
from table import read
from wire import Closed, Refusal, Wire

SECONDS_PER_ROW, FRAME_SECONDS = 0.5, 0.04
FAULTY, NOT_POSSIBLE, NO_VERSION, UNKNOWN = -32602, -32003, -32001, -32601
KINDS = ("lines", "bars", "points")


def number(params, name, low, high, default=None, whole=True):
    value = params.get(name, default)
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not low <= value <= high or (whole and value != int(value)):
        raise Refusal(FAULTY, f"{name} must be a {'whole ' if whole else ''}number from {low} to {high}")
    return int(value) if whole else float(value)


def text(params, name, default=None):
    value = params.get(name, default)
    if not isinstance(value, str):
        raise Refusal(FAULTY, f"{name} must be a string")
    return value


class Slot:
    """A picture's place in the host's memory."""

    def __init__(self, fd, total, offset, stride, height):
        if offset + stride * height > total:
            raise Refusal(FAULTY, "a slot reaches beyond the shared memory")
        first = offset // mmap.ALLOCATIONGRANULARITY * mmap.ALLOCATIONGRANULARITY
        self._start, self._stride = offset - first, stride
        self._map = mmap.mmap(fd, self._start + stride * height, offset=first)

    def put(self, canvas):
        row = 4 * canvas.width
        if row == self._stride:
            self._map[self._start:self._start + len(canvas.pixels)] = bytes(canvas.pixels)
            return
        for y in range(canvas.height):
            at = self._start + y * self._stride
            self._map[at:at + row] = bytes(canvas.pixels[y * row:(y + 1) * row])


class Rendition:
    def __init__(self):
        self.serial, self.waiting, self.visible, self.hovered = 0, {}, False, None
        self.shape(0, 0, 1.0, [])

    def shape(self, width, height, scale, slots):
        self.width, self.height, self.scale, self.slots = width, height, scale, slots
        self.waiting, self.chart, self.shown = {}, None, None

    def free_slot(self):
        taken = self.waiting.values()
        return next((i for i in (0, 1) if i not in taken), None)


class Medium:
    def __init__(self, wire):
        self.wire, self.frames, self.text, self.revision = wire, None, "", 0
        self.table, self.kinds, self.renditions, self.watched = read(""), {"lines"}, {}, {}
        self.now, self.playing, self.rate, self.loop, self.since = 0.0, False, 1.0, False, 0.0
        self.over = self.initialized = False

    # --- from the host -------------------------------------------------------------------------

    def handle(self, message):
        method, params = message.get("method"), message.get("params", {})
        if not isinstance(method, str):
            return  # an answer; this medium asks nothing
        try:
            if not isinstance(params, dict):
                raise Refusal(FAULTY, f"{method} must be an object")
            work = self.calls().get(method)
            if work is None:
                raise Refusal(UNKNOWN, f'no method "{method}"')
            if not self.initialized and method != "initialize":
                raise Refusal(-32600, "initialize comes first")
            result = work(params)
        except Refusal as refusal:
            result = refusal
        if "id" not in message:
            return
        if isinstance(result, Refusal):
            self.wire.send({"id": message["id"], "error": {"code": result.code, "message": str(result)}})
            self.over = self.over or result.code == NO_VERSION
        else:
            self.wire.send({"id": message["id"], "result": {} if result is None else result})

    def calls(self):
        return {
            "initialize": self.initialize, "ping": lambda p: None, "shutdown": lambda p: None, "exit": self.exit,
            "subdocument/load": self.load, "subdocument/edit": self.edit,
            "presentation/list": lambda p: [{"id": "chart", "label": "Chart"}], "presentation/size": self.size,
            "rendition/create": self.create, "rendition/resize": self.create, "rendition/destroy": self.destroy,
            "rendition/show": self.show, "rendition/hide": self.hide, "rendition/ack": self.acknowledge,
            "rendition/input": self.input, "rendition/snapshot": self.snapshot, "menu/invoke": self.invoke,
            "time/play": self.play, "time/pause": self.pause, "time/seek": self.seek, "time/rate": self.set_rate,
            "parameter/list": lambda p: [], "parameter/set": lambda p: None, "progress/cancel": lambda p: None,
            "value/list": self.offers, "value/read": self.values, "value/subscribe": self.subscribe,
            "value/unsubscribe": lambda p: self.watched.pop(p.get("id"), None) and None,
        }

    def initialize(self, p):
        versions, frames = p.get("protocol"), p.get("frames")
        numbers = isinstance(versions, list) and len(versions) == 2 and all(isinstance(v, int) for v in versions)
        if not numbers or not versions[0] <= 1 <= versions[1]:
            raise Refusal(NO_VERSION, "this medium speaks version 1")
        if frames is not None:
            self.frames = (number(frames, "fd", 0, 1 << 20), number(frames, "bytes", 0, 1 << 53))
        self.initialized = True
        return {"protocol": 1, "name": "Chart", "version": "1", "capabilities": ["time", "values", "snapshot"],
                "menus": self.menus()}

    def exit(self, _):
        self.over = True

    def load(self, p):
        self.text, self.revision = text(p, "text"), number(p, "revision", 0, 1 << 53)
        self.read_text()

    def edit(self, p):
        data, edits = self.text.encode(), p.get("edits")
        if not isinstance(edits, list):
            raise Refusal(FAULTY, "edits must be a list")
        end = len(data)
        for change in reversed(edits):
            first, last = number(change, "from", 0, 1 << 53), number(change, "to", 0, 1 << 53)
            if not first <= last <= end:
                raise Refusal(NOT_POSSIBLE, "an edit lies outside of the text, or overlaps the next")
            data, end = data[:first] + text(change, "text").encode() + data[last:], first
        self.text, self.revision = data.decode("utf-8", "replace"), number(p, "revision", 0, 1 << 53)
        self.read_text()

    def size(self, p):
        available = p.get("available")
        if not isinstance(available, dict):
            raise Refusal(FAULTY, "available must be an object")
        width = min(max(number(available, "width", 1, 1e6, whole=False), 120), 520)
        return {"width": width, "height": round(width * 0.6)}

    def create(self, p):
        width, height = number(p, "width", 1, 16384), number(p, "height", 1, 16384)
        slots = [self.slot(s, width, height) for s in p.get("slots") or []] if self.frames else []
        rendition = self.renditions.setdefault(number(p, "rendition", 0, 1 << 53), Rendition())
        rendition.shape(width, height, number(p, "scale", 1 / 64, 64, 1, whole=False), slots)

    def slot(self, p, width, height):
        stride = number(p, "stride", 4 * width, 1 << 20)
        return Slot(*self.frames, number(p, "offset", 0, self.frames[1]), stride, height)

    def destroy(self, p):
        if self.renditions.pop(p.get("rendition"), None) is None:
            raise Refusal(FAULTY, "no such rendition")

    def show(self, p):
        if rendition := self.renditions.get(p.get("rendition")):
            rendition.visible = True

    def hide(self, p):
        if rendition := self.renditions.get(p.get("rendition")):
            rendition.visible = False

    def acknowledge(self, p):
        if rendition := self.renditions.get(p.get("rendition")):
            rendition.waiting.pop(p.get("serial"), None)

    def input(self, p):
        rendition, kind = self.renditions.get(p.get("rendition")), p.get("type")
        if kind == "key-press" and p.get("key") == " ":
            (self.pause if self.playing else self.play)({})
        elif kind in ("key-press", "key-release") and p.get("key") != " ":
            self.wire.notify("rendition/unhandled", **p)
        elif rendition and rendition.chart and kind == "move":
            rendition.hovered = rendition.chart.place(number(p, "x", -1e6, 1e6, 0, whole=False))
        elif rendition and kind == "focus-out":
            rendition.hovered = None

    def snapshot(self, p):
        width, height = number(p, "width", 1, 16384), number(p, "height", 1, 16384)
        moment = self.now if p.get("time") is None else number(p, "time", -1e300, 1e300, whole=False)
        moment = min(max(moment, 0.0), self.finish())
        canvas = Chart(self.table, self.kinds, width, height, number(p, "scale", 1 / 64, 64, 1, whole=False)).picture(self.cursor(moment))
        if self.frames and p.get("offset") is not None:
            self.slot(p, width, height).put(canvas)
            return {"time": moment}
        return {"time": moment, "pixels": base64.b64encode(canvas.pixels).decode()}

    def invoke(self, p):
        name = text(p, "id")
        if name == "play":
            (self.pause if self.playing else self.play)({})
        elif name in KINDS and self.kinds ^ {name}:
            self.kinds = self.kinds ^ {name}
            self.redraw()
        elif name in KINDS:
            raise Refusal(NOT_POSSIBLE, "a chart needs lines, bars or points")
        else:
            raise Refusal(FAULTY, f'no menu entry "{name}"')
        self.tell_menus()

    # --- values: NAME now, NAME.min, NAME.max, NAME.mean ------------------------------------------

    def value(self, expression, moment):
        """A number and ""; else None and why."""
        name, _, what = expression.strip().rpartition(".") if "." in expression else (expression.strip(), "", "now")
        if name not in self.table.names:
            return None, f'there is no column "{name}" (columns here: {", ".join(self.table.names)})'
        column = [v for v in self.table.columns[self.table.names.index(name)] if v is not None]
        if what == "now":
            return self.table.at(self.table.names.index(name), moment / SECONDS_PER_ROW), ""
        known = {"min": min, "max": max, "mean": lambda c: sum(c) / len(c)}
        if what not in known:
            return None, f'a column has {name}.min, {name}.max and {name}.mean, not "{expression.strip()}"'
        return (known[what](column), "") if column else (None, "the column is empty")

    def read_values(self, expressions, moment):
        values, faults = zip(*(self.value(e, moment) for e in expressions)) if expressions else ((), ())
        return {"values": list(values), **({"faults": list(faults)} if any(faults) else {})}

    def values(self, p):
        moment = self.now if p.get("time") is None else number(p, "time", -1e300, 1e300, whole=False)
        return self.read_values(self.expressions(p), moment)

    def offers(self, _):
        """Each column now, its least and its largest value."""
        kinds = ("", "now"), (".min", "least"), (".max", "largest"), (".mean", "mean")
        return [{"expression": name + what, "label": f"{name}, {words}"} for name in self.table.names[:250] for what, words in kinds]

    def expressions(self, p):
        wanted = p.get("expressions")
        if not isinstance(wanted, list) or not all(isinstance(e, str) for e in wanted):
            raise Refusal(FAULTY, "expressions must be a list of strings")
        return wanted

    def subscribe(self, p):
        self.watched[number(p, "id", 0, 1 << 53)] = [self.expressions(p), None]

    # --- time --------------------------------------------------------------------------------------

    def finish(self):
        return max(len(self.table.rows) - 1, 0) * SECONDS_PER_ROW

    def cursor(self, moment):
        return moment / SECONDS_PER_ROW if moment > 0 or self.playing else None

    def play(self, _):
        if not self.finish():
            raise Refusal(NOT_POSSIBLE, "a chart of one row has no time")
        if self.now >= self.finish():
            self.now = 0.0
        self.playing, self.since = True, time.monotonic()
        self.tell_time()
        self.tell_menus()

    def pause(self, _):
        self.playing = False
        self.tell_time()
        self.tell_menus()

    def seek(self, p):
        self.now = min(max(number(p, "time", -1e300, 1e300, whole=False), 0.0), self.finish())
        self.tell_time()

    def set_rate(self, p):
        self.rate, self.loop = number(p, "rate", 1e-6, 1e6, whole=False), bool(p.get("loop", False))
        self.tell_time()

    def advance(self):
        moment = time.monotonic()
        if not self.playing or moment < self.since + FRAME_SECONDS:
            return
        self.now += (moment - self.since) * self.rate
        self.since = moment
        if self.now >= self.finish():
            self.playing = self.loop
            self.now = self.now % self.finish() if self.loop else self.finish()
            if not self.loop:
                self.tell_menus()
        self.tell_time()

    # --- to the host -------------------------------------------------------------------------------

    def menus(self):
        kinds = [{"id": k, "label": k.capitalize(), "checkable": True, "checked": k in self.kinds, "enabled": True,
                  "scope": "subdocument"} for k in KINDS]
        play = {"id": "play", "label": "Pause" if self.playing else "Play", "enabled": self.finish() > 0, "scope": "subdocument",
                "icon": "media-playback-pause" if self.playing else "media-playback-start"}
        return [play] + kinds

    def tell_menus(self):
        self.wire.notify("menu/changed", menus=self.menus())

    def tell_time(self):
        self.wire.notify("time/changed", time=self.now, playing=self.playing, rate=self.rate, loop=self.loop, start=0.0,
                         finish=self.finish(), computed=self.finish(), predictable=None, state="current")

    def tell_values(self):
        for name, watch in self.watched.items():
            read = self.read_values(watch[0], self.now)
            if read != watch[1]:
                watch[1] = read
                self.wire.notify("value/changed", id=name, time=self.now, **read)

    def read_text(self):
        table = read(self.text)
        if table.rows or not self.table.rows:  # a faulty text leaves the last picture
            self.kinds = {table.kind} if table.kind != self.table.kind else self.kinds
            self.table = table
            self.redraw()
        self.now = min(self.now, self.finish())
        self.playing = self.playing and self.finish() > 0
        self.wire.notify("diagnostics", revision=self.revision, items=[
            {"severity": "warning" if table.rows else "error", "line": line, "column": column, "endLine": line, "endColumn": end,
             "message": sentence} for line, column, end, sentence in table.faults[:200]])
        self.tell_time()
        self.tell_menus()

    def redraw(self):
        for rendition in self.renditions.values():
            rendition.chart = rendition.shown = None

    def draw(self):
        for name, rendition in self.renditions.items():
            state = (self.cursor(self.now), rendition.hovered)
            slot = rendition.free_slot()
            if not rendition.visible or slot is None or rendition.shown == state:
                continue
            rendition.chart = rendition.chart or Chart(self.table, self.kinds, rendition.width, rendition.height, rendition.scale)
            canvas, pixels = rendition.chart.picture(*state), {}
            if rendition.slots:
                rendition.slots[slot].put(canvas)
            else:
                pixels = {"pixels": base64.b64encode(canvas.pixels).decode()}
            rendition.serial += 1
            rendition.shown, rendition.waiting[rendition.serial] = state, slot
            self.wire.notify("rendition/frame", rendition=name, slot=slot, serial=rendition.serial, width=rendition.width,
                             height=rendition.height, time=self.now, **pixels)

    def run(self):
        while not self.over:
            due = max(0.0, self.since + FRAME_SECONDS - time.monotonic()) if self.playing else None
            for message in self.wire.receive(due):
                self.handle(message)
                if self.over:
                    return
            self.advance()
            self.tell_values()
            self.draw()


def confine():
    """What the standard library can give up: the process ends with the host, writes no files, keeps no core."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)
    for limit, value in ((resource.RLIMIT_CORE, 0), (resource.RLIMIT_FSIZE, 0), (resource.RLIMIT_NOFILE, 32), (resource.RLIMIT_NPROC, 0)):
        _, most = resource.getrlimit(limit)
        resource.setrlimit(limit, (value if most < 0 else min(value, most),) * 2)


def main():
    confine()
    try:
        Medium(Wire()).run()
    except Closed as reason:
        if str(reason):
            sys.exit(f"chart: {reason}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
