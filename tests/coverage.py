#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the tests run of kernels/ and sim/, a line a file, and what they do not.

usage: coverage.py SOURCE EXPORT    (of `llvm-cov export -format=text`)

A file is compiled for several instruction sets and into many programs: a line or a way
of a branch is run if it is in any of them.  kernels/ must be run whole, lines and
branches, sim/ to 95 % of its lines, but for what tests/coverage.txt says cannot be
reached.  Prints what is missing; status 1 if it is too much, or the list is stale.
"""
import collections
import json
import pathlib
import sys

ROOT = pathlib.Path(sys.argv[1]).resolve()
NEEDED = {"kernels": {"line": 1.0, "branch": 1.0}, "sim": {"line": 0.95}}
# A counter that a killed process left behind its parts is the difference of two others,
# and negative.
NEGATIVE = 1 << 63


def times(count):
    return count if count < NEGATIVE else 0


def name_of(path):
    """As in the tree; None for what is not of interest."""
    path = pathlib.Path(path).resolve()
    if ROOT not in path.parents:
        return None
    name = path.relative_to(ROOT)
    return str(name) if name.parts[0] in NEEDED else None


class File:
    def __init__(self, name):
        self.name = name
        self.text = (ROOT / name).read_text().splitlines()
        self.line = collections.Counter()
        self.branch = collections.Counter()  # (line, column, way)
        self.function = collections.Counter()  # where it begins

    def add_region(self, first, last, count):
        for number in range(first, last + 1):
            self.line[number] += count

    def rate(self, kind):
        counts = getattr(self, kind)
        return sum(1 for count in counts.values() if count), len(counts)


def read_lines(function, files):
    """A line's count is that of the innermost region at its beginning, or the largest of
    those that begin in it."""
    regions = collections.defaultdict(list)
    for first, column, last, end, count, file, _, kind in function["regions"]:
        if kind in (0, 3) and file in files:  # code, and gaps between it
            regions[file].append((first, column, last, end, times(count), kind))
    for file, them in regions.items():
        lines = {}
        for first, column, last, end, count, kind in sorted(
                them, key=lambda r: (r[0], r[1], -r[2], -r[3])):
            text = files[file].text
            for number in range(first, last + 1):
                begins = number == first
                if begins and kind == 3:
                    continue
                if not begins or not text[number - 1][:column - 1].strip():
                    lines[number] = count
                else:
                    lines[number] = max(count, lines.get(number, 0))
        for number, count in lines.items():
            if files[file].text[number - 1].strip(" }{;"):
                files[file].line[number] += count


def read(export):
    files = {}
    for function in json.loads(pathlib.Path(export).read_text())["data"][0]["functions"]:
        mine = {}
        for number, path in enumerate(function["filenames"]):
            name = name_of(path)
            if name:
                mine[number] = files.setdefault(name, None) or File(name)
                files[name] = mine[number]
        read_lines(function, mine)
        for line, column, _, _, yes, no, file, *_ in function["branches"]:
            if file in mine:
                mine[file].branch[line, column, "true"] += times(yes)
                mine[file].branch[line, column, "false"] += times(no)
        if 0 in mine:
            begin = tuple(function["regions"][0][:2])
            mine[0].function[begin] += times(function["count"])
    return files


def read_excuses():
    """(file, text of the line, kind): what is excused, and what of it must be missing."""
    excuses, sure = set(), set()
    for line in (ROOT / "tests/coverage.txt").read_text().splitlines():
        if line and not line.startswith("#"):
            file, text, kind, _ = (part.strip() for part in line.split(" | "))
            excuses.add((file, text, kind.rstrip("?")))
            if not kind.endswith("?"):
                sure.add((file, text, kind))
    return excuses, sure


def missing_of(file, kind):
    for place in sorted(place for place, count in getattr(file, kind).items() if not count):
        number = place if kind == "line" else place[0]
        way = "" if kind == "line" else f" never {place[2]}, column {place[1]}"
        yield number, file.text[number - 1].strip(), way


def main():
    files = read(sys.argv[2])
    excuses, sure = read_excuses()
    used, faults = set(), 0
    plural = {"line": "lines", "branch": "branches"}
    totals = collections.defaultdict(lambda: [0, 0])
    print(f"{'file':34} {'lines':>14} {'branches':>14} {'functions':>12}")
    for name in sorted(files):
        file = files[name]
        folder = name.split("/")[0]
        row = [file.rate(kind) for kind in ("line", "branch", "function")]
        print(f"{name:34} {row[0][0]:>7}/{row[0][1]:<6} {row[1][0]:>7}/{row[1][1]:<6} "
              f"{row[2][0]:>6}/{row[2][1]:<5}")
        for kind, (run, there) in zip(("line", "branch"), row):
            excused = [(name, text, kind) for _, text, _ in missing_of(file, kind)
                       if (name, text, kind) in excuses]
            used.update(excused)
            totals[folder, kind][0] += run + len(excused)
            totals[folder, kind][1] += there
    for name in sorted(files):
        for kind in ("line", "branch"):
            for number, text, way in missing_of(files[name], kind):
                if (name, text, kind) not in excuses:
                    print(f"{name}:{number}: {kind} not run{way}: {text}")
    for (folder, kind), (run, there) in sorted(totals.items()):
        needed = NEEDED[folder].get(kind, 0)
        enough = run >= needed * there
        faults += not enough
        print(f"{folder}: {100 * run / there:.2f} % of {there} {plural[kind]}, excused ones "
              f"counted as run{'' if enough else f'; {100 * needed:.0f} % are needed'}")
    for excuse in sorted(sure - used):
        faults += 1
        print("tests/coverage.txt: stale:", *excuse, sep=" | ")
    return faults > 0


sys.exit(main())
