#!/usr/bin/env python3
"""A medium that behaves, or misbehaves, as it is told: what the host's tests start.

usage: scripted_medium.py [BEHAVIOUR]

The text of its subdocument is lines of `WORD VALUES`:
  colour RRGGBB        what it draws, with a moving bar when it has a duration
  size W H             the size that it would like
  duration S           it has time, from 0 to S
  value NAME V RATE    the value of NAME: V, and RATE more in each second of its time
  slider               its menu has an entry that makes every value greater by 1 at once: another motion
  fault LINE COLUMN SENTENCE
  menu LABEL           one more entry of its menu, with an icon
  asks LABEL           one more entry of its menu, which asks for a number; it takes 1 to 9, appends it to its text,
                       and offers 5 in place of others
  thing LABEL          a release of the right button puts one more entry into its menu, a moment later
  behave BEHAVIOUR     as the argument, from the moment that the text is loaded
  windows N DRAFTS     says that it has N windows of its own, with drafts (1) or none (0)
  draft TEXT           says that TEXT was typed in a window; update-drafts asks the host to append it
  keep TEXT            when its editor is opened, TEXT is a draft there, which the host keeps for the next process; one that
                       is given a TEXT of BEHAVIOUR behaves so
  change TEXT          asks the host to append TEXT to the subdocument, once

A press of a button turns the rendition magenta; that is its state, which the next process is given.

Behaviours: normal, exit (at once), crash (a signal), crash-after S, hang (stops answering), stop (stops itself
by SIGSTOP), busy (computes, never reads), flood, garbage, truncated, slow MS (per answer), oversize,
wrong-version, silent (no answer to initialize), stay (ignores shutdown and the end of its input),
child (leaves a process behind), daemon S (leaves one that sleeps for S, in a session of its own and without a
parent), bad-frame (a frame outside of its slot), bad-reply (an answer to nothing), deaf (reads nothing more),
undo (asks for it, as its windows would), chatter (a menu, again and again, never many unread), take MIB (memory, for
good), lie WHAT COUNT BYTES (a message with a list of COUNT, each of them BYTES long: diagnostics, menu, icons, groups,
edits, title, state).
"""
import base64
import json
import mmap
import os
import signal
import subprocess
import sys
import threading
import time

out = sys.stdout.buffer
lock = threading.Lock()


def send(message):
    message["jsonrpc"] = "2.0"
    body = json.dumps(message).encode()
    with lock:
        out.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        out.flush()


def notify(method, **params):
    send({"method": method, "params": params})


def receive():
    length = None
    while True:
        line = sys.stdin.buffer.readline(1024)
        if not line:
            return None
        if not line.endswith(b"\n"):
            sys.exit("what is not the protocol")
        line = line.strip()
        if not line:
            break
        name, _, value = line.partition(b":")
        if name.lower() == b"content-length":
            length = int(value)
    body = sys.stdin.buffer.read(length)
    return json.loads(body)


def leave(command):
    """Starts a program as daemons do: no parent, a session of its own, and nothing open that its host knows."""
    first = os.fork()
    if first:
        os.waitpid(first, 0)
        return
    os.setsid()
    if os.fork():
        os._exit(0)
    os.closerange(0, 1000)
    os.open("/dev/null", os.O_RDWR)
    os.execvp(command[0], command)


class Impossible(Exception):
    pass


class Medium:
    def __init__(self):
        self.frames = None
        self.renditions = {}
        self.text, self.revision = "", 0
        self.colour, self.size, self.duration = (0x30, 0x60, 0xA0), (320, 200), 0.0
        self.time, self.playing, self.rate, self.loop = 0.0, False, 1.0, False
        self.handles = False
        self.draft, self.opened, self.keeps, self.notice = "", 0, "", ""
        self.label = ""
        self.thing = ""
        self.asks = ""
        self.has_slider, self.slid = False, 0
        self.values, self.watched, self.faulty = {}, {}, False
        self.stay = False
        self.slow = 0.0
        self.serial = 0
        self.mode = "play"
        self.state = threading.RLock()

    # --- behaviour -----------------------------------------------------------------------------

    def behave(self, words):
        what, rest = words[0], words[1:]
        if what == "exit":
            os._exit(3)
        elif what == "crash":
            os.kill(os.getpid(), signal.SIGSEGV)
        elif what == "crash-after":
            timer = threading.Timer(float(rest[0]), lambda: os.kill(os.getpid(), signal.SIGSEGV))
            timer.daemon = True
            timer.start()
        elif what == "hang" or what == "deaf":
            while True:
                time.sleep(100)
        elif what == "stop":
            os.kill(os.getpid(), signal.SIGSTOP)
        elif what == "busy":
            while True:
                pass
        elif what == "flood":
            body = json.dumps({"jsonrpc": "2.0", "method": "nothing/said", "params": {}}).encode()
            many = (b"Content-Length: %d\r\n\r\n" % len(body) + body) * 10000
            while True:
                out.write(many)
        elif what == "garbage":
            with lock:
                out.write(os.urandom(4096))
                out.flush()
        elif what == "truncated":
            with lock:
                out.write(b"Content-Length: 100\r\n\r\n{\"jsonrpc\":")
                out.flush()
            os._exit(0)
        elif what == "oversize":
            with lock:
                out.write(b"Content-Length: 99999999999999\r\n\r\n")
                out.flush()
        elif what == "slow":
            self.slow = float(rest[0]) / 1000
        elif what == "stay":
            self.stay = True
        elif what == "child":
            subprocess.Popen(["sleep", "1000"])
        elif what == "daemon":
            leave(["sleep", rest[0]])
        elif what == "bad-frame":
            for rendition in self.renditions:
                notify("rendition/frame", rendition=rendition, slot=1, serial=10 ** 6, width=self.renditions[rendition]["width"],
                       height=self.renditions[rendition]["height"], time=0, pixels="AAAA")
        elif what == "undo":
            send({"id": 3, "method": "edit/undo", "params": {}})
        elif what == "chatter":
            while True:
                notify("menu/changed", menus=[{"id": "%d" % i, "label": "%d" % time.monotonic_ns()} for i in range(100)])
                time.sleep(0.002)
        elif what == "take":
            self.taken = bytearray(os.urandom(4096)) * (256 * int(rest[0]))
        elif what == "lie":
            self.lie(rest[0], int(rest[1]), int(rest[2]))
        elif what == "bad-reply":
            send({"id": 987654, "result": {}})

    def lie(self, what, count, length):
        words = "x" * length
        if what == "diagnostics":
            notify("diagnostics", revision=self.revision, items=[
                {"severity": "error", "line": 10 ** 8 - i, "column": i, "endLine": 1, "endColumn": 1, "message": ("%d " % i).ljust(length, "x")}
                for i in range(count)])
        elif what in ("menu", "icons", "groups"):
            notify("menu/changed", menus=[dict({"id": "entry-%d" % i, "label": words}, **(
                {"icon": "no-such-%d" % i} if what == "icons" else {"group": "%d" % i} if what == "groups" else {})) for i in range(count)])
        elif what == "edits":
            send({"id": 4, "method": "subdocument/changed", "params": {"base": self.revision, "edits": [
                {"from": 0, "to": 0, "text": words}] * count}})
        elif what == "title":
            notify("progress/end", token=1, message=words)
        elif what == "values":
            for number in self.watched:
                notify("value/changed", id=number, values=[0.5] * count)
        elif what == "state":
            notify("rendition/state", rendition=1, state=words)

    # --- text ----------------------------------------------------------------------------------

    def read_text(self):
        faults, pending, changes, values = [], [], [], {}
        for number, line in enumerate(self.text.split("\n"), 1):
            words = line.split()
            if not words:
                continue
            if words[0] == "colour":
                value = int(words[1], 16)
                self.colour = (value >> 16, value >> 8 & 255, value & 255)
            elif words[0] == "size":
                self.size = (int(words[1]), int(words[2]))
            elif words[0] == "duration":
                self.duration = float(words[1])
            elif words[0] == "value":
                values[words[1]] = (float(words[2]), float(words[3]))
            elif words[0] == "fault":
                faults.append({"severity": "error", "line": int(words[1]), "column": int(words[2]), "endLine": int(words[1]),
                               "endColumn": int(words[2]) + 1, "message": " ".join(words[3:])})
            elif words[0] == "menu":
                self.label = " ".join(words[1:])
            elif words[0] == "asks":
                self.asks = " ".join(words[1:])
            elif words[0] == "chosen":
                pass
            elif words[0] == "thing":
                self.thing = " ".join(words[1:])
            elif words[0] == "behave":
                pending.append(words[1:])
            elif words[0] == "windows":
                notify("windows/changed", open=int(words[1]), drafts=words[2] == "1")
            elif words[0] == "draft":
                self.draft = " ".join(words[1:])
                notify("windows/changed", open=1, drafts=True)
            elif words[0] == "slider":
                self.has_slider = True
            elif words[0] == "keep":
                self.keeps = " ".join(words[1:])
            elif words[0] == "change":
                changes.append(" ".join(words[1:]))
            else:
                faults.append({"severity": "error", "line": number, "column": 1, "endLine": number,
                               "endColumn": 1 + len(words[0]), "message": 'unknown word "%s"' % words[0][:1000]})
        self.faulty = bool(faults)
        self.values = self.values if faults else values  # those of the last good text stay
        notify("diagnostics", revision=self.revision, items=faults)
        self.tell_time()
        self.tell_values()
        notify("menu/changed", menus=self.menus())
        for words in pending:
            self.behave(words)
        return changes

    def tell_time(self):
        if self.duration > 0:
            notify("time/changed", time=self.time, playing=self.playing, rate=self.rate, loop=self.loop, start=0.0,
                   finish=self.duration, computed=self.duration, predictable=None, state="current", motion=self.slid)

    def read_values(self, expressions, at):
        faults = ["" if e in self.values else 'there is no value "%s"' % e for e in expressions]
        values = [self.slid + self.values[e][0] + self.values[e][1] * at if e in self.values else None for e in expressions]
        return {"values": values, **({"faults": faults} if any(faults) else {})}

    def tell_values(self):
        for number, watch in self.watched.items():
            read = self.read_values(watch[0], self.time)
            if read != watch[1]:
                watch[1] = read
                notify("value/changed", id=number, time=self.time, **read)

    # --- pictures ------------------------------------------------------------------------------

    def pixels(self, width, height, at, state="", presentation=""):
        r, g, b = (255, 0, 255) if state == "magenta" else self.colour
        if presentation == "source":
            r, g, b = 255 - r, 255 - g, 255 - b
        row = bytearray(bytes((b, g, r, 255)) * width)
        if self.duration > 0:
            x = int((width - 8) * min(1.0, at / self.duration))
            row[4 * x:4 * (x + 8)] = b"\xff\xff\xff\xff" * 8
        return bytes(row)

    def write(self, offset, stride, width, height, at, state="", presentation=""):
        row = self.pixels(width, height, at, state, presentation)
        for y in range(height):
            self.frames[offset + y * stride:offset + y * stride + 4 * width] = row

    def draw(self, rendition):
        r = self.renditions.get(rendition)
        if not r or not r["shown"] or len(r["unacked"]) >= 2:
            return
        self.serial += 1
        slot = r["next"]
        r["next"] = 1 - slot
        r["unacked"].append(self.serial)
        width, height = r["width"], r["height"]
        message = dict(rendition=rendition, slot=slot, serial=self.serial, width=width, height=height, time=self.time)
        if self.frames is not None and r.get("slots"):
            place = r["slots"][slot]
            self.write(place["offset"], place["stride"], width, height, self.time, r["state"], r["presentation"])
        else:
            row = self.pixels(width, height, self.time, r["state"], r["presentation"])
            message["pixels"] = base64.b64encode(row * height).decode()
        notify("rendition/frame", **message)

    def draw_all(self):
        for rendition in list(self.renditions):
            self.draw(rendition)

    def play_loop(self):
        last = time.monotonic()
        while True:
            time.sleep(0.03)
            now = time.monotonic()
            with self.state:
                if self.playing:
                    self.time += (now - last) * self.rate
                    if self.time >= self.duration:
                        self.time = 0.0 if self.loop else self.duration
                        self.playing = self.loop
                    self.tell_time()
                    self.tell_values()
                    self.draw_all()
            last = now

    # --- messages ------------------------------------------------------------------------------

    def menus(self):
        menus = [
            {"id": "play", "label": "Play", "enabled": self.duration > 0, "scope": "subdocument", "group": "", "icon": "media-playback-start"},
            {"id": "handles", "label": "Show Handles", "checkable": True, "checked": self.handles, "enabled": True, "scope": "rendition", "shortcut": "Ctrl+Alt+H"},
            {"id": "crash", "label": "Crash", "enabled": True, "scope": "subdocument"},
            {"id": "editor", "label": "Open Editor", "enabled": True, "scope": "subdocument", "mode": "edit", "shortcut": "Ctrl+G"},
        ]
        if self.label:
            menus.append({"id": "more", "label": self.label, "icon": "view-refresh"})
        if self.asks:
            menus.append({"id": "ask", "label": self.asks})
        if self.has_slider:
            menus.append({"id": "slide", "label": "Slide"})
        if self.draft:
            menus.append({"id": "update-drafts", "label": "Update", "enabled": True})
        return menus

    def asked(self, value, trial=False):
        question = {"title": "How many", "note": "At most 9.", "fields": [{"label": "number", "value": value or "1"}],
                    "tries": True}
        if value is None:
            return {"question": question}
        if not (value.isdigit() and 1 <= int(value) <= 9):
            return {"question": dict(question, refusal="From 1 to 9, please.", ways=[{"id": "five", "label": "Take 5"}])}
        if trial:
            line = self.text.count("\n") + 2
            return {"question": dict(question, changes=[{"line": line, "before": "", "after": "chosen " + value}])}
        end = len(self.text.encode())
        send({"id": 3, "method": "subdocument/changed", "params": {"base": self.revision, "label": "Choose", "edits": [
            {"from": end, "to": end, "text": "\nchosen " + value}]}})
        self.text, self.revision = self.text + "\nchosen " + value, self.revision + 1
        return {}

    def answer(self, method, p):
        if method == "initialize":
            if p.get("frames"):
                self.frames = mmap.mmap(p["frames"]["fd"], p["frames"]["bytes"])
            self.mode = p["mode"]
            return {"protocol": 1, "name": "Scripted", "version": "1", "capabilities": ["time"], "menus": self.menus()}
        if method == "subdocument/load" or method == "subdocument/edit":
            if method == "subdocument/load":
                self.text = p["text"]
            else:
                data = self.text.encode()
                if any(e["to"] > len(data) for e in p["edits"]):
                    raise Impossible("the edit lies outside of the text")
                for e in reversed(p["edits"]):
                    data = data[:e["from"]] + e["text"].encode() + data[e["to"]:]
                self.text = data.decode()
            self.revision = p["revision"]
            changes = self.read_text()
            self.draw_all()
            if method == "subdocument/load":
                end = len(self.text.encode())
                for change in changes:
                    send({"id": 1, "method": "subdocument/changed", "params": {"base": self.revision, "label": "Append", "edits": [
                        {"from": end, "to": end, "text": change}]}})
            return {}
        if method == "presentation/list":
            return [{"id": "picture", "label": "Picture"}, {"id": "source", "label": "Source text"}]
        if method == "presentation/size":
            return {"width": self.size[0], "height": self.size[1] / (2 if p["presentation"] == "source" else 1)}
        if method in ("rendition/create", "rendition/resize"):
            old = self.renditions.get(p["rendition"], {"shown": False, "state": p.get("state", "")})
            self.renditions[p["rendition"]] = {"width": p["width"], "height": p["height"], "slots": p.get("slots"), "next": 0,
                                               "unacked": [], "shown": old["shown"], "state": old["state"], "presentation": p["presentation"]}
            self.after = lambda: self.draw(p["rendition"])
            return {}
        if method == "rendition/destroy":
            self.renditions.pop(p["rendition"], None)
            return {}
        if method == "rendition/snapshot":
            at = self.time if p.get("time") is None else p["time"]
            if p.get("offset") is None:
                row = self.pixels(p["width"], p["height"], at, presentation=p["presentation"])
                return {"time": at, "pixels": base64.b64encode(row * p["height"]).decode()}
            self.write(p["offset"], p["stride"], p["width"], p["height"], at, presentation=p["presentation"])
            return {"time": at}
        if method == "menu/invoke":
            if p["id"] == "crash":
                self.behave(["crash"])
            if p["id"] in ("ask", "five"):
                return self.asked("5" if p["id"] == "five" else p.get("values", [None])[0], p.get("trial", False))
            if p["id"] not in [entry["id"] for entry in self.menus()]:
                raise Impossible("there is no such command")
            if p["id"] == "play":
                self.playing = True
            if p["id"] == "slide":
                self.slid += 1
                self.tell_time()
                self.tell_values()
            if p["id"] == "editor":
                self.opened += 1
                self.draft = self.keeps
                notify("windows/changed", open=self.opened, drafts=self.draft != "")
                notify("session/keep", state=self.keeps)
            if p["id"] == "update-drafts":
                end = len(self.text.encode())
                send({"id": 2, "method": "subdocument/changed", "params": {"base": self.revision, "label": "Append", "edits": [
                    {"from": end, "to": end, "text": self.draft}]}})
                self.draft = ""
                notify("windows/changed", open=1, drafts=False)
            if p["id"] == "handles":
                self.handles = not self.handles
                notify("menu/changed", menus=self.menus())
            return {}
        if method == "time/play":
            self.playing = True
            self.tell_time()
            return {}
        if method == "time/pause":
            self.playing = False
            self.tell_time()
            return {}
        if method == "time/seek":
            self.time = min(max(p["time"], 0.0), self.duration)
            self.tell_time()
            self.tell_values()
            self.draw_all()
            return {}
        if method == "value/list":
            return [{"expression": name, "label": "the " + name} for name in self.values]
        if method == "value/read":
            if self.faulty:
                raise Impossible("the text is faulty")
            return self.read_values(p["expressions"], self.time if p.get("time") is None else p["time"])
        if method == "value/subscribe":
            self.watched[p["id"]] = [p["expressions"], None]
            self.after = self.tell_values
            return {}
        if method == "value/unsubscribe":
            self.watched.pop(p["id"], None)
            return {}
        if method == "time/rate":
            self.rate, self.loop = p["rate"], p.get("loop", False)
            self.tell_time()
            return {}
        if method in ("ping", "shutdown"):
            return {}
        return None

    def notified(self, method, p):
        if method == "rendition/show":
            if p["rendition"] in self.renditions:
                self.renditions[p["rendition"]]["shown"] = True
                self.draw(p["rendition"])
        elif method == "rendition/hide":
            if p["rendition"] in self.renditions:
                self.renditions[p["rendition"]]["shown"] = False
        elif method == "rendition/ack":
            r = self.renditions.get(p["rendition"])
            if r:
                r["unacked"] = [s for s in r["unacked"] if s != p["serial"]]
        elif method == "rendition/input":
            if p["type"] == "key-press" and p.get("key") != " ":
                notify("rendition/unhandled", **p)
            if p["type"] == "press" and p["rendition"] in self.renditions:
                self.renditions[p["rendition"]]["state"] = "magenta"
                notify("rendition/state", rendition=p["rendition"], state="magenta")
                self.draw(p["rendition"])
            if p["type"] == "release" and p.get("button") == "right" and self.thing:
                time.sleep(0.05)
                self.label = self.thing
                notify("menu/changed", menus=self.menus())
        elif method == "session/restore":
            words = p["state"].split()
            if words[0] == "behave":
                self.behave(words[1:])
            self.draft, self.opened, self.notice = p["state"], 1, p["notice"]
            notify("windows/changed", open=1, drafts=True)
            notify("menu/changed", menus=self.menus())
            notify("session/keep", state=self.draft)
        elif method == "exit":
            if not self.stay:
                os._exit(0)

    def handle(self, message):
        method, params = message.get("method"), message.get("params") or {}
        if method is None:
            return
        if "id" not in message:
            self.notified(method, params)
            return
        if self.slow:
            time.sleep(self.slow)
        self.after = None
        if method == "initialize" and (params["protocol"][0] > 1 or params["protocol"][1] < 1 or behaviour[0] == "wrong-version"):
            send({"id": message["id"], "error": {"code": -32001, "message": "only version 99 is spoken here"}})
            os._exit(0)
        try:
            result = self.answer(method, params)
        except Impossible as error:
            send({"id": message["id"], "error": {"code": -32003, "message": str(error)}})
            return
        except (KeyError, TypeError, ValueError) as error:
            send({"id": message["id"], "error": {"code": -32602, "message": "bad parameters: %r" % error}})
            return
        if result is None:
            send({"id": message["id"], "error": {"code": -32601, "message": "unknown method"}})
            return
        send({"id": message["id"], "result": result})
        if self.after:
            self.after()
        if method == "shutdown" and not self.stay:
            os._exit(0)


behaviour = sys.argv[1:] or ["normal"]
medium = Medium()


def main():
    if behaviour[0] == "silent":
        behaviour[0] = "hang"
    if behaviour[0] != "wrong-version":
        medium.behave(behaviour)
    threading.Thread(target=medium.play_loop, daemon=True).start()
    while True:
        message = receive()
        if message is None:
            if medium.stay:
                while True:
                    time.sleep(0.01)
            return
        with medium.state:
            medium.handle(message)


main()
