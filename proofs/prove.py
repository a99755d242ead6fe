#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Re-proves, from nothing, all that proofs/README.md claims.

usage: prove.py [--build FOLDER] [CLAIM...]

The table there is the list: a row a claim, its third column the tool and its file.  Each is
handed to its tool (tools.py) on this tree, and then on a copy with a fault in it for every
patch proofs/mutants/CLAIM*.patch, which must not be proved.  A line a claim; status 1 if one
is open, or a mutant is proved, or a claim has no mutant.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import tools

TREE = pathlib.Path(__file__).resolve().parent.parent
ROW = re.compile(r"\| `(?P<name>[\w-]+)` (?P<says>.*?) \|.*?\| (?P<tool>\w+): `(?P<file>[^`]+)` ")


def claims():
    """(name, tool, file) of every row of the table, as the README has them."""
    text = (TREE / "proofs/README.md").read_text()
    found = [ROW.match(line) for line in text.splitlines()]
    return [(m["name"], m["tool"], m["file"]) for m in found if m]


def mutants(name):
    return sorted((TREE / "proofs/mutants").glob(f"{name}.*.patch"))


def prove(tree, build, tool, file):
    """Whether it is proved, and what the tool said."""
    build.mkdir(parents=True, exist_ok=True)
    try:
        return tools.TOOLS[tool](tree, build, tree / "proofs" / file)
    except subprocess.TimeoutExpired as late:
        return False, str(late)


def mutated(build, patch):
    """A copy of what is proved, with the patch applied."""
    tree = build / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    for folder in ("kernels", "sim", "proofs"):
        shutil.copytree(TREE / folder, tree / folder)
    subprocess.run(["patch", "-s", "-p1", "-d", tree, "-i", patch], check=True)
    return tree


def judge(job):
    """(good, line) of a claim on the tree, or of one of its mutants."""
    name, tool, file, patch, build = job
    begun = time.monotonic()
    if patch is None:
        proved, said = prove(TREE, build, tool, file)
        good, word = proved, "proved" if proved else "OPEN"
    else:
        proved, said = prove(mutated(build, patch), build, tool, file)
        good, word = not proved, "PROVED, AND IS FALSE" if proved else "rejected"
    (build / "said").write_text(said)
    what = name if patch is None else patch.stem
    line = f"{word:<8} {what} ({tool}, {time.monotonic() - begun:.0f} s)"
    return good, line if good else f"{line}: see {build / 'said'}"


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--build", type=pathlib.Path, default=TREE / "build/proofs")
    options.add_argument("claims", nargs="*", metavar="CLAIM")
    asked = options.parse_args()
    known = claims()
    unknown = set(asked.claims) - {name for name, _, _ in known}
    if unknown:
        sys.exit(f"prove: no such claim: {', '.join(sorted(unknown))}")
    chosen = [c for c in known if not asked.claims or c[0] in asked.claims]

    begun = time.monotonic()
    build = asked.build.resolve()
    shutil.rmtree(build, ignore_errors=True)
    bad = 0
    jobs = []
    for name, tool, file in chosen:
        jobs.append((name, tool, file, None, build / name))
        if not mutants(name):
            bad += 1
            print(f"OPEN     {name}: has no proofs/mutants/{name}.*.patch")
        for patch in mutants(name):
            jobs.append((name, tool, file, patch, build / patch.stem))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for good, line in pool.map(judge, jobs):
            bad += not good
            print(line, flush=True)
    minutes = (time.monotonic() - begun) / 60
    print(f"{len(chosen)} claims, {len(jobs) - len(chosen)} mutants, {bad} bad, {minutes:.1f} min")
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
