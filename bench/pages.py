"""Writes what bench/run.py measured: docs/performance/*.csv and *.svg, and the tables of docs/performance.md."""
import csv
import math
import os
import re
import subprocess
import sys
import textwrap

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "scenes"))
import chain  # noqa: E402

# Hand-written loops measured before this folder was written, on another day: microseconds per simulated second (S5: in all).
EARLIER = {"S1": {1e-2: 0.15, 1e-4: 0.292, 1e-6: 0.503, 1e-9: 0.999}, "S2a": {1e-2: 22.5, 1e-4: 22.5, 1e-6: 22.5, 1e-9: 93.9},
           "S2b": {1e-2: 1.91, 1e-4: 2.98, 1e-6: 5.71, 1e-9: 10.6},
           "S3 N=10 ratio 1": 6.91, "S3 N=10 ratio 10": 15.8, "S3 N=10 ratio 100": 138, "S3 N=10 ratio 1000": 2090,
           "S3 N=100 ratio 1": 68.2, "S3 N=100 ratio 10": 92.3, "S3 N=100 ratio 100": 234, "S3 N=100 ratio 1000": 2140,
           "S3 N=1000 ratio 1": 669, "S3 N=1000 ratio 10": 858, "S3 N=1000 ratio 100": 1110, "S3 N=1000 ratio 1000": 3600,
           "S4": 2790, "S5 n=0": 0.401, "S5 n=1": 0.571, "S5 n=2": 2.06, "S5 n=3": 17.2, "S5 n=4": 169}
NAMES = {"sundials": "SUNDIALS", "mujoco": "MuJoCo", "simbody": "Simbody", "ode": "ODE", "dart": "DART", "bullet": "Bullet",
         "bullet_double": "Bullet (double)"}


def time_text(seconds):
    for factor, unit in ((1, "s"), (1e3, "ms"), (1e6, "µs")):
        if seconds * factor >= 0.9995:
            return f"{seconds * factor:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def earlier(scene, level):
    known = EARLIER.get(scene)
    known = known.get(level) if isinstance(known, dict) else known
    return known and known * 1e-6


def ratio_text(a, b):
    return f"{a / b:.2g}" if a and b and a / b < 99 else f"{a / b:.0f}" if a and b else "-"


def comparison_table(compared, spans, kind):
    lines = ["| scene | error | hand-written loop | earlier loop | our motion | with its error | and set-up | best other engine | "
             "SUNDIALS | motion / loop | with error / loop | best other / motion |",
             "|---|---|---|---|---|---|---|---|---|---|---|---|"]
    for scene, level, found in compared:
        span = spans[kind(scene)]
        seconds = {name: row.least / span if row else None for name, row in found.items()}
        cells = []
        for name in ("hand-written", "earlier", "our motion", "with its error", "all", "best engine", "SUNDIALS"):
            value = earlier(scene, level) if name == "earlier" else seconds[name]
            text = time_text(value) if value else "-"
            row = found.get(name)
            if row and name in ("hand-written", "best engine", "SUNDIALS"):
                text += " " + (NAMES[row.program] + " " if name == "best engine" else "") + row.setting
                text += f" @{row.parameter:.3g}" if row.parameter else ""
                text += " (" + row.note + ")" if row.note.startswith("scaled") else ""
            cells.append(text)
        others = [seconds[name] for name in ("best engine", "SUNDIALS") if seconds[name]]
        cells.append(ratio_text(seconds["our motion"], seconds["hand-written"]))
        cells.append(ratio_text(seconds["with its error"], seconds["hand-written"]))
        cells.append(ratio_text(min(others, default=None), seconds["our motion"]))
        lines.append(f"| {scene} | {'exact' if level == 0 else f'{level:g}'} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def chart(folder, file, title, subtitle, x, *y, rows):
    text = "".join("\t".join(str(field) for field in row) + "\n" for row in rows)
    subprocess.run([os.path.join(folder, "bin", "bench_chart"), file, title, subtitle, x, *y], input=text, text=True, check=True)


def front(rows, span):
    """What no other run beats in both error and time, dearest last."""
    points, best = [], math.inf
    for row in sorted((r for r in rows if math.isfinite(r.least) and r.error > 0), key=lambda r: r.least):
        if row.error < best:
            best = row.error
            points.append((row.least / span, max(row.error, 1e-16)))
    return points


SERIES = (("hand-written loop", lambda r: r.program == "plain"),
          ("our motion", lambda r: r.program == "asgard" and r.setting == "motion"),
          ("with its error*", lambda r: r.program == "asgard" and r.setting == "with estimate"),
          ("SUNDIALS", lambda r: r.program == "sundials"), ("MuJoCo", lambda r: r.program == "mujoco"),
          ("Simbody", lambda r: r.program == "simbody"), ("ODE", lambda r: r.program == "ode"),
          ("Bullet, DART", lambda r: r.program in ("bullet", "bullet_double", "dart")))


def charts(out, folder, rows, compared, spans, kind):
    titles = {"S1": "S1: a free body that turns over, 60 s", "S2a": "S2a: two rods on soft links, 5 s",
              "S2b": "S2b: two rods on exact pins, 5 s", "S4": "S4: 512 elastic balls"}
    for scene, title in titles.items():
        own = [r for r in rows if r.scene == scene]
        points = [(name, *point) for name, chosen in SERIES for point in front([r for r in own if chosen(r)], spans[scene])]
        if points:
            chart(folder, os.path.join(out, scene.lower() + ".svg"), title,
                  "the cheapest run for each error; median error at 0.25 s" if scene == "S4" else "the cheapest run for each error",
                  "processor seconds per simulated second", "error", rows=points)
    points = []
    for name in ("hand-written", "our motion", "with its error", "SUNDIALS", "best engine"):
        for scene, _, found in compared:
            if scene.startswith("S3 N=1000 ") and found[name]:
                points.append((name + ("*" if name == "with its error" else ""), scene.split()[-1], found[name].least / 10))
    if points:
        chart(folder, os.path.join(out, "s3.svg"), "S3: 1000 pendulums, one of them faster", "every angle within 1e-4",
              "how many times faster one of them is", "processor seconds per simulated second", rows=points)
    bars = []
    for scene, level, found in compared:
        base = found["hand-written"]
        if not base or scene.split()[-1] in ("10", "100") or "N=100 " in scene:
            continue
        group = scene if kind(scene) in ("S3", "S5") else f"{scene} to {level:g}"
        for name in ("our motion", "with its error"):
            bars.append((group, name, found[name].least / base.least if found[name] else 0))
        others = [found[n].least for n in ("best engine", "SUNDIALS") if found[n]]
        bars.append((group, "best other", min(others) / base.least if others else 0))
    chart(folder, os.path.join(out, "ratios.svg"), "Processor time over the hand-written loop's",
          "red line: twice the loop's, the goal for our motion; no bar: it did not come so near", "times the loop's", "--bars", "2",
          rows=bars)


def write_rows(file, header, rows):
    with open(file, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


ROW_HEADER = ("program", "scene", "setting", "parameter", "error", "seconds", "least", "note")


def row_texts(rows):
    return [(*r[:3], f"{r.parameter:.6g}", f"{r.error:.3e}", f"{r.seconds:.6e}", f"{r.least:.6e}", r.note) for r in rows]


def read_rows(file):
    with open(file, encoding="utf-8") as stream:
        return list(csv.reader(stream))[1:]


FIGURE_HEADER = ("bodies", "ratio_or_method", "case", "seconds", "equation_evaluations", "steps", "discarded", "collisions", "history_bytes")


def figure_files(out, folder, figures, anew):
    asgard = os.path.join(folder, "bin", "asgard")
    for name, make in (("figure-5-7", figures.figure_5_7), ("figure-5-11", figures.figure_5_11)):
        file = os.path.join(out, name + ".csv")
        if anew or not os.path.exists(file):
            write_rows(file, FIGURE_HEADER, [(*row[:3], *row[3]) for row in make(asgard)])
    seven, eleven = (read_rows(os.path.join(out, f"figure-5-{n}.csv")) for n in ("7", "11"))
    chart(folder, os.path.join(out, "figure-5-7.svg"), "Figure 5.7 again: ten pendulums, one of them faster", "10 s",
          "how many times faster one of them is", "equations evaluated",
          rows=[(r[2], r[1], r[4]) for r in sorted(seven, key=lambda r: r[2]) if r[0] == "10"])
    for method, file in (("auto", "figure-5-11.svg"), ("original", "figure-5-11-original.svg")):
        chart(folder, os.path.join(out, file), "Figure 5.11 again: " + ("today" if method == "auto" else "the dissertation's own rule"),
              "two pendulums, a ball that hits them three times, and other bodies", "bodies", "processor seconds",
              rows=[(r[2], r[0], r[3]) for r in sorted(eleven, key=lambda r: r[2]) if r[1] == method])
    return seven, eleven


def figure_5_7_goal(seven):
    """The dearest of all (N, R): partitioned over the sum of separate runs, in evaluations and in seconds."""
    worst = [0, 0]
    for count, ratio in {(r[0], r[1]) for r in seven}:
        case = {r[2]: r for r in seven if r[:2] == [count, ratio]}
        if "partitioned, today" in case:
            together, apart = case["partitioned, today"], case["sum of separate runs"]
            worst = [max(worst[0], float(together[4]) / float(apart[4])), max(worst[1], float(together[3]) / float(apart[3]))]
    return worst


def figure_5_11_goal(eleven):
    """Exponent of the cost from 100 to 10000 bodies, and the share of steps that collisions threw away."""
    own = {int(r[0]): r for r in eleven if r[1] == "auto" and r[2].startswith("4")}
    most, least = max(own), 100
    exponents = [math.log(float(own[most][k]) / float(own[least][k])) / math.log(most / least) for k in (3, 4)]
    return most, exponents, max(float(r[6]) / (float(r[5]) + float(r[6])) for r in own.values())


def bytes_per_step(rows):
    """Of the history, for each step and body, over the scenes: (scene, accuracy, bytes)."""
    worst = (0, "")
    for r in rows:
        if r.program == "asgard" and r.setting == "motion" and kind_of(r.scene) in ("S1", "S2a", "S2b", "S3"):
            found = re.search(r"(\d+) delivered .* (\d+) bytes", r.note)
            if found and int(found.group(1)):
                bodies = 2 if r.scene == "S2a" else 1 # of one component
                worst = max(worst, (int(found.group(2)) / int(found.group(1)) / bodies, f"{r.scene} at {r.parameter:g}"))
    return worst


def kind_of(scene):
    return scene.split()[0]


def goals_table(source, folder, rows, compared, spans, seven, eleven, figures):
    asgard = os.path.join(folder, "bin", "asgard")
    edits = subprocess.run([os.path.join(folder, "bin", "bench_edits"), os.path.join(source, "samples", "pend.al"), "--budget", "0.5"],
                           stdout=subprocess.PIPE, text=True, check=True).stdout
    edit = {(f[1], f[2]): float(f[6]) for f in csv.reader(edits.splitlines())}
    links = min((figures.cost(asgard, chain.scene(20, 1e8), ("--accuracy", "1e-6"), 120) for _ in range(5)), key=lambda c: c.seconds)
    step, where = bytes_per_step(rows)
    energy = [r for r in rows if r.program == "asgard" and r.scene == "S4 energy"]
    counts = [r for r in rows if r.program == "asgard" and r.scene.startswith("S5") and r.setting == "motion"]
    evaluations, seconds = figure_5_7_goal(seven)
    most, exponents, discarded = figure_5_11_goal(eleven)
    per_second = {(scene, level): found for scene, level, found in compared}

    def motion(scene, level):
        found = per_second.get((scene, level), {}).get("our motion")
        return time_text(found.least / spans[kind_of(scene)]) if found else "not reached"

    text = edit[("Figure 4.6", "reading")] + edit[("Figure 4.6", "all motion")]
    lines = ["| goal | to reach | reached |", "|---|---|---|"]
    for goal, wanted, reached in (
            ("S1 at 1e-6, per simulated second", "1 µs", motion("S1", 1e-6)),
            ("S2a at 1e-4", "45 µs", motion("S2a", 1e-4)),
            ("S3, N = 1000, ratio 1000", "7 ms", motion("S3 N=1000 ratio 1000", 1e-4)),
            ("S4", "6 ms", motion("S4", 1e-9)),
            ("S5, n = 4, in all", "0.35 ms", motion("S5 n=4", 0)),
            ("Figure 4.6's scene, from text to motion", "10 ms",
             f"{time_text(text)} (reading {time_text(edit[('Figure 4.6', 'reading')])}; first to see after "
             f"{time_text(edit[('Figure 4.6', 'first motion to see')])} of computing)"),
            ("the motion of an edit on it", "2 ms", time_text(edit[("Figure 4.6", "motion of an edit")])),
            ("20 rods, k = 1e8, at 1e-6, per simulated second", "35 ms", time_text(links.seconds) + " with its error and set-up"),
            ("Figure 5.7: all over the sum of separate runs", "1.2",
             f"{evaluations:.3g} in evaluations, {seconds:.2g} in processor time, at worst"),
            (f"Figure 5.11: exponent from 100 to {most} bodies", "1.1", f"{exponents[1]:.2f} in evaluations, {exponents[0]:.2f} in processor time"),
            ("Figure 5.11: steps thrown away by collisions", "5 %", f"{100 * discarded:.2g} %"),
            ("512 elastic balls, 10 s: change of energy", "1e-12", f"{energy[0].error:.1e}" if energy else "not reached"),
            ("Galperin's billiard, n = 0 to 5", "3, 31, 314, 3141, 31415, 314159",
             ", ".join(("right" if r.error == 0 else "wrong" if math.isfinite(r.error) else "stopped") for r in counts)),
            ("an edit to one of 1000 components", "1 ms and its own",
             f"{time_text(edit[('1000 components', 'motion of an edit to one')])}; its own "
             f"{time_text(edit[('1000 components', 'that one alone')])}"),
            ("history, bytes for each step and body", "200", f"{step:.0f} at worst ({where})")):
        lines.append(f"| {goal} | {wanted} | {reached} |")
    return "\n".join(lines)


def machine(rows):
    """How long the loop of sines took, at the start and the end of each program: how quiet the machine was."""
    loops = [r.least for r in rows if r.scene == "calibration"]
    return textwrap.fill(f"A fixed loop (2000 sines and divisions) took {time_text(min(loops))} to {time_text(max(loops))} "
                         "between the programs.", width=118)


def put(page, name, text):
    """The page with `text` between the marks of that name."""
    page, marks = re.subn(rf"(<!-- {name} -->\n).*?(\n<!-- end -->)", lambda m: m.group(1) + text + m.group(2), page, flags=re.S)
    assert marks == 1, f"docs/performance.md has {marks} marks <!-- {name} --> on lines of their own, and needs one"
    return page


def write(source, folder, rows, compared, spans, kind, figures, anew):
    out = os.path.join(source, "docs", "performance")
    os.makedirs(out, exist_ok=True)
    write_rows(os.path.join(out, "measurements.csv"), ROW_HEADER, row_texts(rows))
    charts(out, folder, rows, compared, spans, kind)
    seven, eleven = figure_files(out, folder, figures, anew)
    file = os.path.join(source, "docs", "performance.md")
    with open(file, encoding="utf-8") as stream:
        page = stream.read()
    page = put(page, "comparison", comparison_table(compared, spans, kind))
    page = put(page, "machine", machine(rows))
    page = put(page, "goals", goals_table(source, folder, rows, compared, spans, seven, eleven, figures))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(page)
