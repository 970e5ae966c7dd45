#!/usr/bin/env python3
"""Fails where a widget gets a text that Qt may take for HTML, for the mark of a key, or for a mark of changes.

usage: check_texts.py ROOT

Words of our own stand in the call, as tr("...") or another literal, or come through plain::ours. Whatever else is
shown goes through common/plain (plain::label, tip, caption, title, Message). Prints each violation as file:line: text.
"""
import os
import re
import sys

from lint import files, read, report

# The folders that make widgets.
FOLDERS = (os.path.join("host", "menus"), os.path.join("host", "window"), os.path.join("host", "panes"),
           os.path.join("host", "source"), os.path.join("host", "navigation"), os.path.join("host", "controls"), os.path.join("medium-asgard", "views"))
# The manuals are markup of our own, from the programs' resources.
MARKUP = {os.path.join("host", "window", "manual.cpp"), os.path.join("medium-asgard", "views", "frame", "manual_window.cpp"),
          os.path.join("medium-asgard", "views", "frame", "manual.cpp"),
          os.path.join("medium-asgard", "views", "frame", "help_page.cpp")}

NEVER = re.compile(r"""\bnew\ QLabel\b | \bQLabel\( | \bQLabel\ \w+[;({]
    | \bnew\ QMessageBox\b | \bQMessageBox\ \w+[;({] | \bQMessageBox::(about|critical|information|question|warning)\(
    | \bQStaticText\b | \bQErrorMessage\b | \bQWhatsThis\b | \bsetInformativeText\( | \bsetDetailedText\(
    | \bsetTextFormat\(""", re.VERBOSE)
ONLY_MARKUP = re.compile(r"\b(setHtml|setMarkdown|insertHtml|QTextBrowser\(|new QTextBrowser|new QTextEdit)\b")
# What takes a text, and which of its arguments that is.
TIP = re.compile(r"(?:->|\.|\b)(setToolTip|setWhatsThis|QToolTip::showText)\(")
TITLE = re.compile(r"(?:->|\.|\b)(setWindowTitle)\(")
BOXES = "QPushButton|QToolButton|QCheckBox|QRadioButton|QGroupBox|QAction|QMenu|QDockWidget|QCommandLinkButton"
CAPTION = re.compile(r"(?:->|\.|\b)(addMenu|setTitle|addTab|addButton|addRow|new (?:%s))\(" % BOXES)
ACTION = re.compile(r"(?:->|\.|\b)(addAction)\(")
DIALOG = re.compile(r"\b(QInputDialog::\w+|QProgressDialog)\(")
SET_TEXT = re.compile(r"(\w+|[bB]utton\([^()]*\))\s*(?:->|\.)setText\(")
DECLARED = re.compile(r"\b(?:const )?(?:%s)\s*\*\s*([\w, *={}]+?)\s*(?:[;=(){]|$)|"
                      r"\bauto\s*\*\s*(\w+)\s*=\s*new (?:%s)\b" % (BOXES, BOXES))

TR = r'(?:\w+::)*(?:tr|QStringLiteral|QLatin1String)\(\s*(?:"(?:[^"\\]|\\.)*"\s*)+\)|"(?:[^"\\]|\\.)*"'
LITERAL = re.compile(r"^\s*(?:%s|QString\(\))\s*$" % TR, re.DOTALL)
PARAMETER = re.compile(r"(?:const )?[\w:]+\s*[*&]\s*\w+")  # of a function that is declared


def arguments(text, opened):
    """The arguments of the call whose parenthesis is at `opened`, and where it ends."""
    parts, depth, at, begin = [], 0, opened, opened + 1
    while at < len(text):
        c = text[at]
        if c == '"':
            at += 1
            while at < len(text) and text[at] != '"':
                at += 2 if text[at] == "\\" else 1
        elif c == "'" and text[at + 2:at + 3] == "'":
            at += 2
        elif c in "([{":
            depth += 1
        elif c in ")]}":
            depth -= 1
            if depth == 0:
                parts.append(text[begin:at])
                return parts, at
        elif c == "," and depth == 1:
            parts.append(text[begin:at])
            begin = at + 1
        at += 1
    return parts, at


def is_ours(argument):
    """Literals, choices between them, and what went through the helper."""
    if "plain::" in argument or LITERAL.match(argument) or not argument.strip():
        return True
    choice = re.match(r"^(.*?)\s\?\s(.*)\s:\s(.*)$", argument, re.DOTALL)
    return bool(choice and "tr(" not in choice.group(1) and is_ours(choice.group(2)) and is_ours(choice.group(3)))


def without_comments(text):
    return re.sub(r"//[^\n]*", "", text)


def violations(path, text, header):
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        if NEVER.search(line) or (ONLY_MARKUP.search(line) and path not in MARKUP):
            yield number, line
    captions = set()
    for source in (text, header):
        for names, name in DECLARED.findall(source):
            captions.update(re.findall(r"\w+", re.sub(r"=\s*\w+|\{.*?\}", "", names) + " " + name))

    def calls(pattern):
        for found in pattern.finditer(text):
            parts, end = arguments(text, found.end() - 1)
            yield found, parts, text[end + 1:end + 3], text.count("\n", 0, found.start()) + 1

    for found, parts, _, number in calls(TIP):
        # Text is the last argument of an item's, the second of showText's.
        shown = parts[1] if found.group(1) == "QToolTip::showText" else parts[-1]
        if not is_ours(shown):
            yield number, lines[number - 1]
    for pattern in (TITLE, CAPTION):
        for found, parts, _, number in calls(pattern):
            first = parts[0].strip()
            # A widget, a menu or a standard button in the place of a text.
            pointer = pattern is CAPTION and first not in ("label", "name", "text", "title", "words") and re.fullmatch(
                r"&?\w+|\w+::\w+|&?\w+\(\)", first)
            if not is_ours(first) and not pointer and not PARAMETER.fullmatch(first):
                yield number, lines[number - 1]
    for found, parts, after, number in calls(ACTION):
        before = text[:found.start()].rsplit("\n", 1)[-1]
        # addAction(action): the one argument is no text, since nobody takes the action that is made.
        is_action = len(parts) == 1 and after.startswith(";") and "=" not in before and "return" not in before
        icon = parts[0].strip().startswith(("icon", "QIcon"))
        if not is_action and not is_ours(parts[1] if icon and len(parts) > 1 else parts[0]):
            yield number, lines[number - 1]
    for found, parts, _, number in calls(DIALOG):
        if any(".arg(" in part and "plain::" not in part for part in parts):
            yield number, lines[number - 1]
    for found, parts, _, number in calls(SET_TEXT):
        name = found.group(1)
        if (name in captions or name.endswith(")")) and not is_ours(parts[0]):
            yield number, lines[number - 1]


def sentences(root):
    def of(path, text):
        header = path[:-4] + ".h"
        beside = without_comments(read(root, header)) if path.endswith(".cpp") and os.path.exists(
            os.path.join(root, header)) else ""
        for number, line in sorted(set(violations(path, without_comments(text), beside))):
            yield number, line.strip() + ": a text of others goes through plain/plain.h"
    return of


if __name__ == "__main__":
    root = sys.argv[1]
    sources = [path for path in files(root, FOLDERS, (".h", ".cpp"))
               if not re.search(r"(^test_|_test\.|_testing\.)", os.path.basename(path))]
    sys.exit(report(root, sources, sentences(root), least=100))
