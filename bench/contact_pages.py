"""The table and the charts of contact and joints, from the rows of the programs of bench/contacts."""
import math
import os

import pages

NAMES = dict(pages.NAMES, siconos="Siconos")
OURS, PLAIN = "asgard", "plain"
LEVELS = (1e-3, 1e-6)
SPANS = {"slope": 2, "ball slides": 2, "block on cart": 2, "bounce": 0.5, "rod slips back": 1.3, "rod slips forward": 1.5,
         "ladder": 0.8, "rod on stop": 2.5, "Bricard": 5, "torsion pendulum": 14, "car": 2, "walking machine": 2,
         "box tips": 0.5}  # seconds of motion; else 1


def span(scene):
    return SPANS.get(scene, SPANS.get(scene.split()[0], 1))


def cheapest(rows, level, chosen):
    found = [r for r in rows if r.error <= level and r.least > 0 and chosen(r)]
    return min(found, key=lambda r: r.least) if found else None


def work(row):
    """How many steps the row's run took: of the delivered motion, for us."""
    words = row.note.split()
    return words[words.index("delivered") - 1] if "delivered" in words else words[0]


def cell(row):
    if not row:
        return "-"
    name = "" if row.program == OURS else f"{NAMES[row.program]} {row.setting} "
    return f"{name}{pages.time_text(row.least / span(row.scene))}, {work(row)} steps"


def ours(setting):
    return lambda r: r.program == OURS and r.setting == setting


def least_error(rows):
    reached = [r.error for r in rows if math.isfinite(r.error)]
    return f"{min(reached):.0e}" if reached else "-"


def table(rows):
    lines = ["| case | error | our motion | with its error and set-up | best other engine | other / motion | other / all | "
             "our least error | others' |", "|---|---|---|---|---|---|---|---|---|"]
    for scene in dict.fromkeys(r.scene for r in rows if r.scene != "calibration"):
        own = [r for r in rows if r.scene == scene]
        for level in LEVELS:
            motion, everything = (cheapest(own, level, ours(s)) for s in ("motion", "all"))
            other = cheapest(own, level, lambda r: r.program not in (OURS, PLAIN))
            cells = [cell(motion), pages.time_text(everything.least / span(scene)) if everything else "-", cell(other)]
            for row in (motion, everything):
                cells.append(pages.ratio_text(other and other.least, row and row.least))
            first = level == LEVELS[0]
            for chosen in (lambda r: r.program == OURS, lambda r: r.program not in (OURS, PLAIN)):
                cells.append(least_error([r for r in own if chosen(r)]) if first else "")
            lines.append(f"| {scene if first else ''} | {level:g} | " + " | ".join(cells) + " |")
    return "\n".join(lines)


def loops(rows):
    """Our engine beside the loops written by hand, at the errors that both reach."""
    lines = ["| case | error | hand-written loop | our motion | with its error and set-up | motion / loop | error of the loop | ours |",
             "|---|---|---|---|---|---|---|---|"]
    for scene in dict.fromkeys(r.scene for r in rows if r.program == PLAIN and r.scene != "calibration"):
        own = [r for r in rows if r.scene == scene]
        name = scene
        for level in LEVELS:
            loop = cheapest(own, level, lambda r: r.program == PLAIN)
            motion, everything = (cheapest(own, level, ours(s)) for s in ("motion", "all"))
            if not loop or not motion or not everything:
                continue
            cells = [f"{pages.time_text(loop.least / span(scene))} {loop.setting} @{loop.parameter:.3g}", cell(motion),
                     pages.time_text(everything.least / span(scene)), pages.ratio_text(motion.least, loop.least),
                     f"{loop.error:.0e}", f"{motion.error:.0e}"]
            lines.append(f"| {name} | {level:g} | " + " | ".join(cells) + " |")
            name = ""
    return "\n".join(lines)


SERIES = (("our motion", ours("motion")), ("with its error*", ours("with estimate")),
          *((NAMES[name], lambda r, name=name: r.program.split("_")[0] == name)
            for name in ("siconos", "mujoco", "simbody", "ode", "bullet", "dart")))
CASES = {"slope slides": "A block slides up a slope and stops, 2 s", "ball rolls": "A ball slides, then rolls, 1 s",
         "rod slips back": "A rod tips and its foot slips, 1.3 s", "rod on stop": "A rod on a hinge meets a stop, 2.5 s",
         "Bricard": "Bricard's mechanism, five rods, 5 s", "torsion pendulum": "Spring and dry friction, 14 s",
         "box tips": "A box tips over its edge, 0.5 s", "slider-crank": "A slider-crank, three turns in 1 s",
         "car": "A car rolls down a slope, 2 s", "walking machine": "A machine walks on eight legs, 2 s"}
SIZES = {"stack": "Boxes at rest on each other", "chain": "Rods on hinges, let go level"}


def charts(out, folder, rows):
    for scene, title in CASES.items():
        own = [r for r in rows if r.scene == scene]
        points = [(name, *point) for name, chosen in SERIES for point in pages.front([r for r in own if chosen(r)], span(scene))]
        pages.chart(folder, os.path.join(out, "contacts-" + scene.replace(" ", "-") + ".svg"), title, "the cheapest run for each error",
                    "processor seconds per simulated second", "error, m", rows=points)
    for kind, title in SIZES.items():
        points = []
        for name, chosen in SERIES:
            for scene in dict.fromkeys(r.scene for r in rows if r.scene.startswith(kind + " ")):
                row = cheapest([r for r in rows if r.scene == scene], LEVELS[0], chosen)
                if row:
                    points.append((name, scene.split()[1], row.least))
        pages.chart(folder, os.path.join(out, f"contacts-{kind}s.svg"), title, "every centre within 1e-3 m", "bodies",
                    "processor seconds per simulated second", rows=points)


def write(source, folder, rows):
    """Rows of the loops and our engine alone leave what other engines have as it is."""
    out = os.path.join(source, "docs", "performance")
    file = os.path.join(source, "docs", "performance.md")
    with open(file, encoding="utf-8") as stream:
        page = stream.read()
    programs = {r.program for r in rows}
    if PLAIN in programs:
        beside = [r for r in rows if r.program in (PLAIN, OURS) and r.scene in {p.scene for p in rows if p.program == PLAIN}]
        pages.write_rows(os.path.join(out, "contacts-loops.csv"), pages.ROW_HEADER, pages.row_texts(beside))
        page = pages.put(page, "contacts loops", loops(rows))
        page = pages.put(page, "contacts loops machine", pages.machine(beside))
    if programs - {PLAIN, OURS}:
        engines = [r for r in rows if r.program != PLAIN]
        pages.write_rows(os.path.join(out, "contacts.csv"), pages.ROW_HEADER, pages.row_texts(engines))
        charts(out, folder, engines)
        page = pages.put(page, "contacts", table(engines))
        page = pages.put(page, "contacts machine", pages.machine(engines))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(page)
