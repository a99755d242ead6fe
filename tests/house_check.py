#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The house: every room where it belongs, with all that belongs to it.

usage: house_check.py SOURCE [CC]

A room is a header and what shares its stem: code, test, fuzz target, proof.  A room may
have annexes, parts with a subject of their own: NAME_part belongs to NAME and stands on
its floor.  Prints what is wrong, one fault a line; status 1.
"""
import pathlib
import re
import subprocess
import sys

# Top to bottom, as in DESIGN; a room includes only what lies below it.
FLOORS = """
    main
    study explain
    conventional session
    report checkpoint observe start
    snapshot
    codec trajectory run
    scene
    neighbours
    cells calendar states
    system
    clock sum lists wall
    array
    event_time impulse
    step
    overlap quadratic
    root
    dyadic
    lanes
    exact path
"""

ROOT = pathlib.Path(sys.argv[1])
CC = sys.argv[2] if len(sys.argv) > 2 else "cc"
HEADER_ONLY = {"exact", "lanes", "path", "sum"}
LONGEST_LINE = 82
LONGEST_FILE = 400
TOP = set("""
    .ci .clang-format .clang-tidy .gitignore
    CHANGELOG.md CMakeLists.txt CMakePresets.json LICENSE README.md
    cmake fuzz kernels proofs run sim tests
""".split())
faults = []


def fault(where, what):
    faults.append(f"{where}: {what}")


def read_floors():
    """Room -> floor, counted from the top."""
    floors = enumerate(FLOORS.strip().splitlines())
    return {room: floor for floor, line in floors for room in line.split()}


ROOMS = read_floors()


def room_of(stem):
    """The room that a file is, or belongs to; None."""
    if stem in ROOMS:
        return stem
    whole = [room for room in ROOMS if re.match(rf"{room}(s$|_)", stem)]
    return max(whole, key=len) if whole else None


def check_includes(path):
    mine = room_of(path.stem)
    if mine is None:
        fault(path, "belongs to no room: give it a place in tests/house_check.py")
        return
    for include in re.findall(r'#include [<"](?:brink/)?(\w+)\.h[>"]', path.read_text()):
        theirs = room_of(include)
        if theirs not in (None, mine) and ROOMS[theirs] <= ROOMS[mine]:
            fault(path, f"includes {include}.h, which does not lie below it")


def check_top():
    """What lies at the top is in the list of it: nothing that a tool left behind."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True)
    top = {line.split("/")[0] for line in listed.stdout.splitlines()}
    for name in sorted(top - TOP):
        fault(name, "does not belong at the top")


def exists(folder, pattern):
    return any((ROOT / folder).glob(pattern))


def check_siblings(folder, stem, header, code):
    if not header and stem != "main":
        fault(f"{folder}/{stem}", "has no header")
    if not code and stem not in HEADER_ONLY:
        fault(f"{folder}/{stem}", "has no code")
    if not exists("tests", f"{stem}_test.*"):
        fault(f"{folder}/{stem}", f"has no tests/{stem}_test")


def check_rooms(folder):
    files = [p for p in (ROOT / folder).glob("*.[ch]")]
    stems = {p.stem for p in files}
    for path in files:
        check_includes(path)
    for stem in stems & ROOMS.keys():
        has = {p.suffix for p in files if p.stem == stem}
        check_siblings(folder, stem, ".h" in has, ".c" in has)


def public_kernels():
    """Rooms whose header is installed: all but those that CMake excludes."""
    text = (ROOT / "kernels/CMakeLists.txt").read_text()
    internal = re.search(r'EXCLUDE REGEX "(.+)"', text).group(1)
    headers = (ROOT / "kernels").glob("*.h")
    return {p.stem for p in headers if not re.search(internal, str(p))}


def check_readme():
    """Its table has a row a public kernel, with the files that there are."""
    rows = {}
    for line in (ROOT / "README.md").read_text().splitlines():
        cells = [c.strip() for c in line.strip("|").split("|")]
        kernel = re.fullmatch(r"`(\w+)`", cells[0])
        if kernel and len(cells) == 7:
            rows[kernel.group(1)] = cells
    public = public_kernels()
    for kernel in sorted(public ^ rows.keys()):
        fault("README.md", f"kernel {kernel} is in the table or in kernels/, not both")
    for kernel in sorted(public & rows.keys()):
        for column, pattern in ((4, "tests/{}_test.c"), (5, "fuzz/{}_fuzz.c"),
                                (6, "proofs/{}[._]*")):
            there = exists(".", pattern.format(kernel))
            if there != ("`" in rows[kernel][column]):
                fault("README.md", f"{kernel}: column {column + 1} is not as the tree")


def check_fuzz_and_proofs():
    for folder, pattern in (("fuzz", "{}_fuzz.c"), ("proofs", "{}[._]*")):
        if exists(folder, "*"):
            for kernel in sorted(public_kernels()):
                if not exists(folder, pattern.format(kernel)):
                    fault(f"kernels/{kernel}", f"has nothing in {folder}/")


def check_fuzz_table():
    """Every public function has a row, and what is fuzzed is what is said."""
    table = {}
    for line in (ROOT / "fuzz/README.md").read_text().splitlines():
        cells = [c.strip() for c in line.strip("|").split("|")]
        if len(cells) == 3 and cells[0].startswith("`"):
            for name in re.findall(r"`([\w/.]+)`", cells[0]):
                table.setdefault(name, []).extend(re.findall(r"`(\w+)`", cells[1]))
    declared = re.compile(r"^[\w ]+?[ *](brink_\w+)\(", re.MULTILINE)
    for kernel in sorted(public_kernels()):
        header = (ROOT / f"kernels/{kernel}.h").read_text()
        for name in declared.findall(header):
            if not table.get(name):
                fault("fuzz/README.md", f"{name} has no target in its table")
    for name, targets in table.items():
        for target in targets:
            path = ROOT / f"fuzz/{target}_fuzz.c"
            if not path.exists():
                fault("fuzz/README.md", f"{name}: there is no fuzz/{target}_fuzz.c")
    for path in (ROOT / "fuzz").glob("*.*"):
        if path.suffix in (".options", ".dict") and not path.with_suffix(".c").exists():
            fault(path, "is of no target")
    targets = {p.stem.removesuffix("_fuzz") for p in (ROOT / "fuzz").glob("*_fuzz.c")}
    for target in sorted(targets - {t for row in table.values() for t in row}):
        fault(f"fuzz/{target}_fuzz.c", "is in no row of fuzz/README.md")


def check_planted():
    """Every planted fault is in the table as it says itself, and can be planted."""
    said = re.findall(r"^\| (\d\d) (.+) \| `(\w+)` \|$",
                      (ROOT / "fuzz/README.md").read_text(), re.MULTILINE)
    there = []
    for path in sorted((ROOT / "fuzz/planted").glob("*.patch")):
        text = path.read_text()
        head = dict(re.findall(r"^(fault|target): (.+)$", text, re.MULTILINE))
        there.append((path.name[:2], head["fault"], head["target"]))
        tried = subprocess.run(["patch", "-s", "-p1", "--dry-run", "-f", "-d", str(ROOT)],
                               input=text, capture_output=True, text=True, check=False)
        if tried.returncode:
            fault(path, "cannot be planted in this tree")
    for name, what, target in sorted(set(said) ^ set(there)):
        fault("fuzz/README.md", f"{name} ({what}, {target}) is in its table or planted, not both")


def check_paths():
    """What is compiled for several paths is compared between them."""
    pathed = re.findall(r"BRINK_ON_PATH\((brink_\w+)\)",
                        (ROOT / "kernels/path.h").read_text())
    compared = "".join(p.read_text() for p in (ROOT / "tests").glob("*path*.[ch]"))
    for name in pathed:
        if not re.search(rf"PATHS_OF\(\w+, {name}\)", compared):
            fault(f"kernels/path.h: {name}", "is compared by no tests/*path*.[ch]")


def check_fast_math_is_refused():
    for path in sorted((ROOT / "kernels").glob("*.c")):
        tried = subprocess.run(
            [CC, "-std=c17", "-ffast-math", "-fsyntax-only", str(path)],
            capture_output=True, text=True, check=False)
        if tried.returncode == 0 or "do not compile it with -ffast-math" not in tried.stderr:
            fault(path, "does not refuse -ffast-math")


def check_lines():
    for folder in ("kernels", "sim", "tests", "fuzz", "proofs"):
        for path in sorted((ROOT / folder).rglob("*.[ch]")):
            lines = path.read_text().splitlines()
            if lines[0] != "// SPDX-License-Identifier: MIT":
                fault(path, "does not begin with its licence")
            for number, line in enumerate(lines, 1):
                if len(line) > LONGEST_LINE:
                    fault(f"{path}:{number}", f"is {len(line)} columns wide")
            if len(lines) > LONGEST_FILE:
                fault(path, f"has {len(lines)} lines: split it where its subjects part")


def check_merged():
    """Nothing that was written by people is half of one version and half of another."""
    written = {".md", ".txt", ".c", ".h", ".v", ".g", ".cpp", ".smt2", ".py", ".sh", ".yaml"}
    for path in sorted(p for name in TOP for p in ((ROOT / name), *(ROOT / name).rglob("*"))
                       if p.suffix in written):
        if re.search(r"^(<{7}|>{7}) ", path.read_text(errors="replace"), re.MULTILINE):
            fault(path, "was merged and has both versions in it")


def main():
    check_rooms("kernels")
    check_rooms("sim")
    check_top()
    check_readme()
    check_fuzz_and_proofs()
    check_fuzz_table()
    check_planted()
    check_paths()
    check_fast_math_is_refused()
    check_lines()
    check_merged()
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{len(faults)} faults")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
