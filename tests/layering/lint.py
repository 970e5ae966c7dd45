"""The frame of the lints: reads files of the project, prints their violations, and tells the exit code."""
import os


def files(root, tops, ends):
    """Paths below ROOT of the files in the folders TOPS whose names end in ENDS, in order; builds and hidden folders
    hold none of ours."""
    found = []
    for top in tops:
        for here, folders, names in os.walk(os.path.join(root, top)):
            at_root = os.path.relpath(here, root) == "."
            folders[:] = [f for f in folders if not f.startswith(".") and not (at_root and f in ("build", "shared"))]
            found += [os.path.relpath(os.path.join(here, name), root) for name in names if name.endswith(ends)]
    return sorted(found)


def read(root, path):
    with open(os.path.join(root, path), encoding="utf-8") as f:
        return f.read()


def report(root, paths, violations, least):
    """Prints file:line: sentence for each (line, sentence) of violations(path, text); 1 if there is one.

    A lint that finds fewer than LEAST files looks in the wrong place."""
    assert len(paths) >= least, f"{root} is no root of the project"
    faults = 0
    for path in paths:
        for number, sentence in violations(path, read(root, path)):
            print(f"{path}:{number}: {sentence}")
            faults += 1
    return 1 if faults else 0
