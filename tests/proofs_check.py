#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""proofs/README.md beside the tree that it is about.

Every bound that a public header states is in a row of its table, or named as not proved, with
the value that it has; what a row names is there; every proof and every mutant has a row, and
every mutant of a proof in Coq a counterexample or a word that it has none.  What README.md's
table calls proved names the claims behind it, and no number that they do not.

usage: proofs_check.py SOURCE

Prints what is wrong, one fault a line; status 1.
"""
import fnmatch
import re
import sys

from house_check import ROOT, public_kernels

sys.path.insert(0, str(ROOT / "proofs"))
import prove  # pylint: disable=wrong-import-position
import tools  # pylint: disable=wrong-import-position

PROOFS = {".v", ".g", ".smt2", ".c", ".cpp"}  # what else lies there serves them
NAMED = re.compile(r"\b(BRINK_[A-Z_]+)\b(?: (-?\w[\w.+-]*\w|\w))?")
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:\^-?\d+)?")
faults = []


def fault(where, what):
    faults.append(f"{where}: {what}")


def public_bounds():
    """Name -> value of every number that a public header defines."""
    bounds = {}
    for kernel in sorted(public_kernels()):
        text = (ROOT / f"kernels/{kernel}.h").read_text()
        bounds.update(re.findall(r"^#define (BRINK_\w+) +([-+.\w]+)$", text, re.MULTILINE))
    return bounds


def not_proved():
    text = (ROOT / "proofs/README.md").read_text()
    return text.partition("\n## What is not proved\n")[2].partition("\n## ")[0]


def check_named(where, text, bounds):
    """The bounds that a text names, each with its value."""
    named = set()
    for name, value in NAMED.findall(text):
        if name not in bounds:
            fault(where, f"names {name}, which no public header defines")
        elif value != bounds[name]:
            fault(where, f"names {name} {value}".rstrip() + f", which is {bounds[name]}")
        named.add(name)
    return named


def check_bounds(claims):
    bounds = public_bounds()
    named = check_named("what is not proved", not_proved(), bounds)
    for claim in claims:
        mine = check_named(claim.name, claim.says, bounds)
        path = ROOT / "proofs" / claim.file
        written = path.read_text() if path.exists() else ""
        for name in sorted(mine):
            if name not in written:
                fault(f"proofs/{claim.file}", f"does not name {name}, which {claim.name} does")
        named |= mine
    for path in proofs():
        for name, value in NAMED.findall(path.read_text()):
            if value[:1].isdigit() and bounds.get(name, value) != value:
                fault(f"proofs/{path.name}", f"names {name} {value}, which is {bounds[name]}")
    for name in sorted(bounds.keys() - named):
        fault(name, "is in no row of proofs/README.md, and not said to be not proved")


def proofs():
    return sorted(p for p in (ROOT / "proofs").iterdir() if p.suffix in PROOFS)


def check_source(claim):
    """The files of a row are there, and define the functions named after them."""
    words = [w for quoted in re.findall(r"`([^`]+)`", claim.source)
             for w in re.split(r"[:,;] *", quoted)]
    files, text = [], ""
    for word in words:
        if "/" not in word:
            if files and not re.search(rf"^\w[\w *]*\b{word}\(", text, re.MULTILINE):
                fault(claim.name, f"{word} is not defined in {' or '.join(files)}")
        elif (ROOT / word).exists():
            files.append(word)
            text += (ROOT / word).read_text()
        else:
            fault(claim.name, f"there is no {word}")
    if not any("/" in word for word in words):
        fault(claim.name, "names no source file")


def is_transcribed(file):
    """Whether a test sets a proof's formulas beside the source."""
    include = f'#include "transcribed/{file.replace(".", "_")}.h"'
    return any(include in test.read_text()
               for test in (ROOT / "tests").glob("*_transcription_test.c"))


def check_rows(claims):
    names = [claim.name for claim in claims]
    for claim in claims:
        check_source(claim)
        if names.count(claim.name) > 1:
            fault(claim.name, "has two rows")
        if claim.tool not in tools.TOOLS:
            fault(claim.name, f"{claim.tool} is none of {', '.join(tools.TOOLS)}")
        if not (ROOT / "proofs" / claim.file).exists():
            fault(claim.name, f"there is no proofs/{claim.file}")
        if not prove.mutants(claim.name):
            fault(claim.name, f"has no proofs/mutants/{claim.name}.*.patch")
        for other in re.findall(r"`(\w+-[\w-]+)`", claim.assumptions):
            if other not in names:
                fault(claim.name, f"there is no claim {other}")
        if ("compared" in claim.assumptions) != is_transcribed(claim.file):
            fault(claim.name, "is compared or included in a tests/*_transcription_test.c, not both")
    used = {claim.file for claim in claims}
    used.update(*[tools.options_of(ROOT / "proofs" / file) for file in used if file.endswith(".v")
                  and (ROOT / "proofs" / file).exists()])
    for path in proofs():
        if path.name not in used:
            fault(f"proofs/{path.name}", "is in no row")
    for path in sorted((ROOT / "proofs/mutants").glob("*.patch")):
        if path.name.split(".")[0] not in names:
            fault(f"proofs/mutants/{path.name}", "belongs to no row")


def check_counterexamples(claims):
    """Every mutant of a proof in Coq has one, or is named as without."""
    without = re.findall(r"`([\w-]+\.\w+)`", not_proved())
    used = set()
    for patch in [p for c in claims if c.tool == "coq" for p in prove.mutants(c.name)]:
        example = patch.with_suffix(".v")
        if example.exists() == (patch.stem in without):
            fault(f"proofs/mutants/{patch.name}", "has a counterexample or is named as without, "
                  "not both")
        if example.exists():
            used |= {example.name, *tools.options_of(example)}
    for path in sorted((ROOT / "proofs/mutants").glob("*.v")):
        if path.name not in used:
            fault(f"proofs/mutants/{path.name}", "is no mutant's")


def check_proved(kernel, proved, files, claims):
    """A cell of README.md's column, its phrases each followed by (`claim`, ...)."""
    known = {claim.name: claim for claim in claims}
    where = f"README.md: {kernel}"
    parts = re.split(r"\(((?:`[\w-]+`(?:, )?)+)\)", proved)
    for phrase, cited in zip(parts[::2], parts[1::2]):
        behind = [known.get(name) for name in re.findall(r"`([\w-]+)`", cited)]
        if None in behind:
            fault(where, f"there is no claim {cited}")
            continue
        for claim in behind:
            if not any(fnmatch.fnmatch(f"proofs/{claim.file}", f) for f in files):
                fault(where, f"{claim.name} is proved in none of {', '.join(files)}")
        said = NUMBER.findall(" ".join(claim.says for claim in behind))
        for number in NUMBER.findall(phrase):
            if number not in said:
                fault(where, f"{number} is not what {cited} says")
    if parts[-1].strip() or len(parts) == 1:
        fault(where, f"names no claim for: {parts[-1].strip()}")


def check_readme(claims):
    for line in (ROOT / "README.md").read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 7 and cells[0].startswith("`"):
            check_proved(cells[0], cells[2], re.findall(r"`([^`]+)`", cells[6]), claims)


def main():
    claims = prove.claims()
    check_bounds(claims)
    check_rows(claims)
    check_counterexamples(claims)
    check_readme(claims)
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"{len(claims)} claims, {len(faults)} faults")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())
