#!/usr/bin/env python3
"""How long does a document take to appear? From the start of `ensemble` to its text, and to its last change of picture.

usage: first_page.py ENSEMBLE [DOCUMENT] [--pages N] [--runs N] [--display :N]

Without a document it writes a report of 1,000 pages, each with an animation. The goal is the text within 1 s.

Starts Xvfb with its frame buffer in a file and looks at that every few milliseconds: `text` is when dark pixels first show on
the page, `settled` is the last change of any pixel within the time watched. Each run also times a fixed loop of arithmetic
(`loop`), so that a slow or busy machine shows. Prints each run and the medians. Nothing is asserted.
"""
import argparse
import mmap
import os
import statistics
import struct
import subprocess
import tempfile
import time

WIDTH, HEIGHT = 1280, 900


def report(pages):
    """Each page has a heading, words and an animation of its own."""
    text = ["DOCUMENT REPORT\n<REPORT>\n<TITLE>{A long report}</TITLE>\n"]
    for page in range(pages):
        words = " ".join(f"word{(page * 31 + i * 17) % 997}" for i in range(150))
        text.append(f"<SECTION><HEADING>{{Section number {page}}}</HEADING>\n<PARAGRAPH><TEXT>{{{words}}}</TEXT></PARAGRAPH>\n"
                    "<PARAGRAPH><DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION WIDTH=\"300\" HEIGHT=\"200\"><ASGARD>"
                    "{simulator -finish 10\nshape_set s -desc \\{-sub \\{-sphere 0.5\\}\\}\nbody b s -init_pos \\{1 0 0\\}\n"
                    f"force -body b -x \\{{-{page + 1}*b.x\\}}\n}}</ASGARD></ANIMATION>\n</DOCUMENT></PARAGRAPH>\n"
                    "<PAGEBREAK></PAGEBREAK>\n</SECTION>\n")
    return "".join(text) + "</REPORT>\n"


def calibration():
    begin, x = time.perf_counter(), 0.0
    for i in range(2_000_000):
        x += i * 1e-9
    return time.perf_counter() - begin


def watch(screen, seconds, begin):
    header = struct.unpack(">I", screen[:4])[0]
    colors = struct.unpack(">I", screen[76:80])[0] * 12
    pixels = header + colors
    previous, text, settled = None, None, None
    while time.perf_counter() - begin < seconds:
        now = time.perf_counter() - begin
        picture = screen[pixels:pixels + WIDTH * HEIGHT * 4]
        if picture != previous:
            previous, settled = picture, now
            # The green channel of every third row: dark on a light page is text.
            rows = b"".join(picture[y * WIDTH * 4 + 1:(y + 1) * WIDTH * 4:4] for y in range(200, HEIGHT - 60, 3))
            light = sum(rows.count(v) for v in range(240, 256))
            dark = sum(rows.count(v) for v in range(1, 90))
            if text is None and light > len(rows) // 4 and dark > 300:
                text = now
        time.sleep(0.004)
    return text, settled


def run(options, folder):
    screen_file = os.path.join(folder, "Xvfb_screen0")
    server = subprocess.Popen(["Xvfb", options.display, "-screen", "0", f"{WIDTH}x{HEIGHT}x24", "-fbdir", folder],
                              stderr=subprocess.DEVNULL)
    try:
        while not os.path.exists(screen_file) or os.path.getsize(screen_file) < WIDTH * HEIGHT * 4:
            time.sleep(0.05)
        time.sleep(0.5)
        loop = calibration()
        environment = dict(os.environ, DISPLAY=options.display, QT_QPA_PLATFORM="xcb")
        with open(screen_file, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as screen:
            begin = time.perf_counter()
            program = subprocess.Popen([options.ensemble, options.document], env=environment,
                                       stderr=subprocess.DEVNULL)
            text, settled = watch(screen, options.watch, begin)
            program.terminate()
            program.wait()
        return text, settled, loop
    finally:
        server.terminate()
        server.wait()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("ensemble")
    parser.add_argument("document", nargs="?")
    parser.add_argument("--pages", type=int, default=1000)
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--watch", type=float, default=6.0)
    parser.add_argument("--display", default=":91")
    options = parser.parse_args()
    results = []
    own = tempfile.TemporaryDirectory()
    if not options.document:
        options.document = os.path.join(own.name, "report.ens")
        with open(options.document, "w", encoding="utf-8") as file:
            file.write(report(options.pages))
    for i in range(options.runs):
        with tempfile.TemporaryDirectory() as folder:
            result = run(options, folder)
        results.append(result)
        print("run %d: text %s s, settled %s s, loop %.3f s" % (
            i + 1, *("none" if v is None else "%.2f" % v for v in result[:2]), result[2]), flush=True)
    for name, column in zip(("text", "settled", "loop"), zip(*results)):
        known = [v for v in column if v is not None]
        if known:
            print(f"median {name} {statistics.median(known):.3f} s")


if __name__ == "__main__":
    main()
