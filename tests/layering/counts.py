#!/usr/bin/env python3
"""Counts what makes code of one folder hard to enter: large classes, folders with many files, circles of includes.

usage: counts.py ROOT [FOLDER]        (medium-asgard/engine)

Prints, of FOLDER and all folders in it:
    folders     sources and headers without tests, their lines, and the folders that they include
    circles     folders that include each other; files that do, a header and the sources named after it as one
    classes     those with more than 15 data members, or whose functions stand in more than two sources
Constants (static constexpr) are no data members; a function counts once for each declaration.
"""
import collections
import os
import re
import sys

from lint import files, read

MOST_MEMBERS, MOST_SOURCES = 15, 2
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.S)
CLASS = re.compile(r"(?<!enum )\b(?:class|struct)\s+([A-Za-z_][\w:]*)\s*(?:final\s*)?(?::(?!:)[^{};()]*)?\{")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)
NO_MEMBER = re.compile(r"^(using|friend|typedef|static_assert|enum|static constexpr|static inline constexpr)\b")
BODY = re.compile(r"^(?![ \t#}/]).*?\b(\w+(?:::\w+)*)::(?:~?\w+|operator[^\w\s(]+)\s*\(", re.M)


def bare(text):
    """The code without comments, strings and lines of the preprocessor."""
    return re.sub(r"^\s*#.*$", "", COMMENT.sub(lambda m: " " if m.group().startswith("/") else '""', text), flags=re.M)


def closing(text, at):
    """The place behind the brace that closes the one at AT."""
    depth = 0
    for place in range(at, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place + 1
    return len(text)


def without_arguments(text):
    """The declaration without what stands in angle brackets."""
    while (shorter := re.sub(r"<[^<>]*>", "", text)) != text:
        text = shorter
    return text


def statements(body):
    """Declarations of a class: (text before any brace or initialiser, whether a body follows)."""
    at = start = 0
    while at < len(body):
        if body[at] == "{":
            end = closing(body, at)
            rest = re.match(r"\s*([^;{}]*);", body[end:])
            if rest and not re.match(r"\s*(public|private|protected)\b", rest.group(1)) and "(" not in rest.group(1):
                yield body[start:at], rest.group(1)
                end += rest.end()
            else:
                yield body[start:at], ""
            at = start = end
        elif body[at] == ";":
            yield body[start:at], ""
            at = start = at + 1
        else:
            at += 1


def members(body):
    """(data members, functions) that a class declares, without those of classes in it."""
    data = functions = 0
    for text, names in statements(body):
        text = re.sub(r"\b(public|private|protected)\s*:", " ", text)
        text = re.sub(r"\[\[\w+\]\]", " ", text).strip()
        if re.match(r"^(template\s*<.*>\s*)?(class|struct|enum)\b", text, re.S) and "(" not in text:
            data += len([n for n in names.split(",") if n.strip()])
            continue
        if not text or NO_MEMBER.match(text):
            continue
        if "operator" in text:
            functions += 1
            continue
        declared = without_arguments(re.split(r"(?<![<>=!])=(?!=)", text, maxsplit=1)[0])
        if "(" in declared:
            functions += 1
        else:
            rest = without_arguments(text + names)
            data += 1 + len(re.findall(r",\s*[A-Za-z_]\w*\s*(?=[=,{]|$)", rest))
    return data, functions


def classes(text, outer=""):
    """(name, data members, functions) of the classes in bare code, those in classes too."""
    at = 0
    while match := CLASS.search(text, at):
        end = closing(text, match.end() - 1)
        body = text[match.end():end - 1]
        name = outer + match.group(1)
        yield (name, *members(body))
        yield from classes(body, name + "::")
        at = end


def circles(arrows):
    """Sets of two or more nodes that reach each other (Tarjan)."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(arrows.get(node, ())):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            circle = []
            while node not in circle:
                circle.append(stack.pop())
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in sorted(arrows):
        if node not in index:
            visit(node)
    return found


def unit(path, headers):
    """A source belongs to the longest-named header whose name its own begins with."""
    stem = os.path.splitext(path)[0]
    while stem not in headers and "_" in os.path.basename(stem):
        stem = stem.rsplit("_", 1)[0]
    return stem if stem in headers else os.path.splitext(path)[0]


def included(paths):
    """What an include names: paths by each of their ends."""
    ends = {}
    for path in paths:
        parts = path.split("/")
        for first in range(len(parts) - 1):
            ends.setdefault("/".join(parts[first:]), path)
    return ends


def main():
    sys.setrecursionlimit(10_000)
    root, folder = sys.argv[1], (sys.argv[2:] or ["medium-asgard/engine"])[0].rstrip("/")
    paths = [p for p in files(root, [folder], (".h", ".cpp")) if not re.search(r"_(test|testing)\.|/testing\.h", p)]
    texts = {path: read(root, path) for path in paths}
    ends = included(paths)
    headers = {os.path.splitext(p)[0] for p in paths if p.endswith(".h")}
    counts, lines = collections.Counter(), collections.Counter()
    of_folders, of_files = collections.defaultdict(set), collections.defaultdict(set)
    found, sources = [], collections.defaultdict(set)
    for path in paths:
        here = os.path.dirname(path)
        counts[here] += 1
        lines[here] += texts[path].count("\n")
        of_folders[here], of_files[unit(path, headers)]
        for target in filter(None, map(ends.get, INCLUDE.findall(texts[path]))):
            if os.path.dirname(target) != here:
                of_folders[here].add(os.path.dirname(target))
            if unit(target, headers) != unit(path, headers):
                of_files[unit(path, headers)].add(unit(target, headers))
        code = bare(texts[path])
        found += [(path, *of_class) for of_class in classes(code)]
        if path.endswith(".cpp"):
            for name in BODY.findall(code):
                sources[here, name].add(path)

    def short(path):
        return os.path.relpath(path, folder)

    print(f"{'folder':34} files  lines  includes")
    for here in sorted(counts):
        print(f"{short(here):34} {counts[here]:5}  {lines[here]:5}  {' '.join(sorted(map(short, of_folders[here])))}")
    for what, arrows in (("folders", of_folders), ("files", of_files)):
        rings = circles(arrows)
        print(f"\ncircles of {what}: {len(rings)}")
        for ring in rings:
            print("   ", " ".join(map(short, ring)))
    print(f"\nclasses above {MOST_MEMBERS} data members or {MOST_SOURCES} sources")
    print(f"{'class':40} members  functions  sources")
    large = 0
    for path, name, data, functions in sorted(found, key=lambda c: -c[2]):
        own = len(sources[os.path.dirname(path), name])
        if data > MOST_MEMBERS or own > MOST_SOURCES:
            large += 1
            print(f"{short(os.path.dirname(path)) + ' ' + name:40} {data:7}  {functions:9}  {own:7}")
    print(f"{large} of {len(found)} classes")


if __name__ == "__main__":
    main()
