#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Re-proves, from nothing, all that proofs/README.md claims.

usage: prove.py [--build FOLDER] [CLAIM...]

The table there is the list: a row a claim, its third column the tool and its file.  Each file
is handed to its tool (tools.py) on this tree, and on a copy with a fault in it for every
patch proofs/mutants/CLAIM.*.patch, which must not be proved; as many at once as there are
processors.  A patch of a proof in Coq may have a file of the same name beside it, .v, with a
counterexample: then it is also proved that what the mutant says is false.  A patch that says
`with: OPTIONS` first has those in place of the file's, to have no more proved again than what it
changes.  A line a claim; status 1 if one is open, or a mutant is not rejected, or a claim has none.
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
import typing

import tools

TREE = pathlib.Path(__file__).resolve().parent.parent


class Claim(typing.NamedTuple):
    """A row of the table."""
    name: str
    says: str
    source: str
    tool: str
    file: str
    assumptions: str
    seconds: str


ROW = re.compile(r"\| `([\w-]+)` (.*?) \| (.*?) \| (\w+): `([\w.]+)` \| (.*?) \| (\d+) \|")


def claims():
    """Every row of the README's table."""
    text = (TREE / "proofs/README.md").read_text()
    rows = [line for line in text.splitlines() if line.startswith("| `")]
    found = [ROW.fullmatch(line.replace(r"\|", "/")) for line in rows]
    if not all(found):
        sys.exit(f"prove: no row of a claim: {rows[found.index(None)]}")
    return [Claim(*row.groups()) for row in found]


def mutants(name):
    return sorted((TREE / "proofs/mutants").glob(f"{name}.*.patch"))


def prove(tree, build, tool, file, patch):
    """Whether it is proved, None if it could not be read, and what the tool said."""
    build.mkdir(parents=True, exist_ok=True)
    path = tree / "proofs" / file
    options = patch and tools.options_of(patch) or tools.options_of(path)
    try:
        return tools.TOOLS[tool](tree, build, path, options)
    except subprocess.TimeoutExpired as late:
        return False, str(late)
    except tools.Unread as broken:
        return None, str(broken)


def refute(tree, build, file, patch):
    """Whether it is proved to be false, if that is to be tried, and what the tool said."""
    refutation = patch.with_suffix(".v")
    if not refutation.exists():
        return None, ""
    (build / "refuted").mkdir()
    path = TREE / "proofs" / file
    try:
        return tools.refuted(TREE, tree, build / "refuted", path, refutation)
    except tools.Unread as broken:
        return False, str(broken)


def mutated(build, patch):
    """A copy of what is proved, with the patch applied."""
    tree = build / "tree"
    shutil.rmtree(tree, ignore_errors=True)
    for folder in ("kernels", "sim", "proofs"):
        shutil.copytree(TREE / folder, tree / folder)
    subprocess.run(["patch", "-s", "-p1", "-d", tree, "-i", patch], check=True)
    return tree


def judge(job):
    """(good, lines) of a proof on the tree, with all that is claimed of it, or of a mutant."""
    claims_of_it, patch, build = job
    tool, file = claims_of_it[0].tool, claims_of_it[0].file
    begun = time.monotonic()
    tree = TREE if patch is None else mutated(build, patch)
    proved, said = prove(tree, build, tool, file, patch)
    false, more = refute(tree, build, file, patch) if patch and proved is False else (None, "")
    (build / "said").write_text(said + more)
    took = f"({tool}, {time.monotonic() - begun:.0f} s)"
    good = proved is (patch is None) and false is not False
    if patch is None:
        word = "proved" if proved else "OPEN"
    elif false is not None:
        word = "refuted" if false else "NOT REFUTED"
    else:
        word = {True: "PROVED, AND IS FALSE", False: "rejected", None: "NOT READ"}[proved]
    names = [patch.stem] if patch else [claim.name for claim in claims_of_it]
    see = "" if good else f": see {build / 'said'}"
    return good, [f"{word:<8} {name} {took}{see}" for name in names]


def jobs_of(chosen, build):
    """A proof once, whatever claims rest on it, the long ones first; and the mutants."""
    proofs = {}
    for claim in chosen:
        proofs.setdefault((claim.tool, claim.file), []).append(claim)
    jobs = [(int(rows[0].seconds), (rows, None, build / file))
            for (_, file), rows in proofs.items()]
    jobs += [(int(claim.seconds), ([claim], patch, build / patch.stem))
             for claim in chosen for patch in mutants(claim.name)]
    return [job for _, job in sorted(jobs, key=lambda job: -job[0])]


def main():
    options = argparse.ArgumentParser()
    options.add_argument("--build", type=pathlib.Path, default=TREE / "build/proofs")
    options.add_argument("claims", nargs="*", metavar="CLAIM")
    asked = options.parse_args()
    known = claims()
    unknown = set(asked.claims) - {claim.name for claim in known}
    if unknown:
        sys.exit(f"prove: no such claim: {', '.join(sorted(unknown))}")
    chosen = [claim for claim in known if not asked.claims or claim.name in asked.claims]

    begun = time.monotonic()
    build = asked.build.resolve()
    shutil.rmtree(build, ignore_errors=True)
    bad = 0
    for claim in chosen:
        if not mutants(claim.name):
            bad += 1
            print(f"OPEN     {claim.name}: has no proofs/mutants/{claim.name}.*.patch")
    jobs = jobs_of(chosen, build)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done in concurrent.futures.as_completed([pool.submit(judge, job) for job in jobs]):
            good, lines = done.result()
            bad += not good
            print(*lines, sep="\n", flush=True)
    minutes = (time.monotonic() - begun) / 60
    tried = sum(patch is not None for _, patch, _ in jobs)
    print(f"{len(chosen)} claims, {tried} mutants, {bad} bad, {minutes:.1f} min")
    return bad != 0


if __name__ == "__main__":
    sys.exit(main())
