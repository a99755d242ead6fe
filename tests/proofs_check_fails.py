#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""That proofs_check.py fails: faults of every kind, each planted in a copy of the tree's texts,
each complained of in so many words.

usage: proofs_check_fails.py SOURCE
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

# What is complained of | in which file | what stands there | what is put in its place.
TABLE = "proofs/README.md"
PLANTED = [
    ("BRINK_NEW_ULP: is in no row of proofs/README.md, and not said to be not proved",
     "kernels/overlap.h", "#define BRINK_OVERLAP_ULP 1\n",
     "#define BRINK_OVERLAP_ULP 1\n#define BRINK_NEW_ULP 2\n"),
    ("BRINK_IMPULSE_BALANCE: is in no row of proofs/README.md, and not said to be not proved",
     TABLE, "BRINK_IMPULSE_BALANCE 0x1p-96", "2^-96"),
    ("event-time-meeting: names BRINK_EVENT_TIME_ULP 8, which is 7",
     "kernels/event_time.h", "BRINK_EVENT_TIME_ULP 8\n", "BRINK_EVENT_TIME_ULP 7\n"),
    ("impulse-rim: names BRINK_RIM_ANGLE, which is 0x1p-24",
     TABLE, "the angle BRINK_RIM_ANGLE 0x1p-24", "the angle BRINK_RIM_ANGLE"),
    ("what is not proved: names BRINK_EVENT_TIME_GAP 9, which is 8",
     TABLE, "within BRINK_EVENT_TIME_GAP 8:", "within BRINK_EVENT_TIME_GAP 9:"),
    ("what is not proved: names BRINK_EVENT_TIME_GAPS, which no public header defines",
     TABLE, "within BRINK_EVENT_TIME_GAP 8:", "within BRINK_EVENT_TIME_GAPS 8:"),
    ("proofs/event_time_meeting.g: names BRINK_EVENT_TIME_ULP 9, which is 8",
     "proofs/event_time_meeting.g", "BRINK_EVENT_TIME_ULP 8", "BRINK_EVENT_TIME_ULP 9"),
    ("proofs/event_time_meeting.g: does not name BRINK_EVENT_TIME_ULP, "
     "which event-time-meeting does",
     "proofs/event_time_meeting.g", "BRINK_EVENT_TIME_ULP 8", "8 ulp"),
    ("proofs/mutants/quadratic-roots.two_ulp.patch: has a counterexample or is named as without, "
     "not both",
     TABLE, "## What is not proved\n", "## What is not proved\n\n`quadratic-roots.two_ulp`\n"),
    ("step-states: there is no kernels/steps.c",
     TABLE, "`kernels/step.c`: all of it", "`kernels/steps.c`: all of it"),
    ("step-states: names no source file",
     TABLE, "`kernels/step.c`: all of it", "all of it"),
    ("event-time-meeting-nan: time_of_meeting is not defined in kernels/event_time_meeting.h",
     "kernels/event_time_meeting.h", "double time_of_meeting(", "double meeting_time("),
    ("event-time-bits: there is no proofs/event_time_bit.smt2",
     TABLE, "cvc5: `event_time_bits.smt2`", "cvc5: `event_time_bit.smt2`"),
    ("event-time-bits: cvc4 is none of coq, gappa, wp, eva, cvc5, small",
     TABLE, "cvc5: `event_time_bits.smt2`", "cvc4: `event_time_bits.smt2`"),
    ("exact-dd-mul-d: there is no claim exact-chain",
     TABLE, "| compared, `exact-link`; no overflow", "| compared, `exact-chain`; no overflow"),
    ("exact-told: is compared or included in a tests/*_transcription_test.c, not both",
     "tests/exact_transcription_test.c", "transcribed/exact_v.h", "transcribed/exact.h"),
    ("proofs/new.v: is in no row",
     "proofs/new.v", None, "Theorem t : True. exact I. Qed.\n"),
    ("proofs/mutants/new.of_nothing.patch: belongs to no row",
     "proofs/mutants/new.of_nothing.patch", None, ""),
    ("overlap-small: has no proofs/mutants/overlap-small.*.patch",
     "proofs/mutants/overlap-small.of_the_difference.patch", "", None),
    ("overlap-small: has two rows",
     TABLE, "| `overlap-sign-filter` ", "| `overlap-small` "),
    ("README.md: `event_time`: 7 is not what `event-time-meeting` says",
     "README.md", "meetings within 8 ulp (", "meetings within 7 ulp ("),
    ("README.md: `event_time`: 7.2 is not what `event-time-far` says",
     TABLE, "later root within 7.2u", "later root within 7.3u"),
    ("README.md: `step`: there is no claim `step-state`",
     "README.md", "(`step-states`, ", "(`step-state`, "),
    ("README.md: `step`: names no claim for: all of it, as compiled",
     "README.md", "as compiled (`step-states`, `step-decreases`)", "as compiled"),
    ("README.md: `step`: quadratic-count is proved in none of proofs/step_*",
     "README.md", "(`step-states`, ", "(`step-states`, `quadratic-count`, "),
    ("prove: no row of a claim: | `step-states` ",
     TABLE, "wp: `step_wp.c`", "wp `step_wp.c`"),
]


def write(path, text):
    """None is no file."""
    if text is None:
        path.unlink()
    else:
        path.write_text(text)


def planted(path, old, new):
    """What the file is to be, and what it was."""
    was = path.read_text() if path.exists() else None
    if not old:
        return new, was
    if old not in was:
        sys.exit(f"proofs_check_fails: {path} has no '{old}' any more")
    return was.replace(old, new), was


def complaints(tree):
    checked = subprocess.run([sys.executable, tree / "tests/proofs_check.py", tree],
                             capture_output=True, text=True, check=False)
    return checked.returncode, (checked.stdout + checked.stderr).splitlines()


def copied(source, tree):
    for folder in ("kernels", "sim", "proofs", "tests"):
        shutil.copytree(source / folder, tree / folder, ignore=shutil.ignore_patterns(
            "scenes", "__pycache__", "*_test.sh", "*.svg"))
    shutil.copy(source / "README.md", tree)


def main():
    source = pathlib.Path(sys.argv[1])
    missed = 0
    with tempfile.TemporaryDirectory() as scratch:
        tree = pathlib.Path(scratch)
        copied(source, tree)
        for complaint, file, old, new in PLANTED:
            fault, was = planted(tree / file, old, new)
            write(tree / file, fault)
            status, said = complaints(tree)
            write(tree / file, was)
            if status == 0 or not any(line.startswith(complaint) for line in said):
                missed += 1
                print(f"not complained of: {complaint}", *said, sep="\n    ")
        status, said = complaints(tree)
    print(f"{len(PLANTED)} faults planted, {missed} missed; without them {said[-1]}")
    return missed != 0 or status != 0


if __name__ == "__main__":
    sys.exit(main())
