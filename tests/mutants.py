#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Mutation testing: are there changes of the code that no test notices?

usage: mutants.py [-j JOBS] [-t TEST]... SOURCE FOLDER [FILE]...

Every relation, arithmetic or logical operator, constant, sign and statement of the
FILEs is changed, one at a time, and the tests are run until one fails.  Each file is
compiled once with all of its mutants (mutants_schema.py); what is a constant to the
compiler has a build of its own.  A test is run if without a mutant it reaches the
function; those that kill most in least time come first.  A crash, more than 2 GiB or
more than ten times the test's time and 2 s is a kill.  What then stands is compiled
by itself, to see whether it makes any difference to the code, and is tried once
more with sanitizers.

FOLDER/results.txt has a line a mutant and is gone on from: kills and what makes no
difference to the code hold as long as the file is the same, survivors as long as
the tests are as well.  FOLDER/report.txt has the counts and every survivor.
tests/mutants.txt has those known to be equivalent, and why.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import re
import sys
import threading

import mutants_report
from mutants_build import Build
from mutants_find import Finder
from mutants_schema import alone, mutants_of, schema

FILES = """
    kernels/step.c kernels/quadratic.c kernels/overlap.c kernels/overlap_value.c
    kernels/impulse.c kernels/root.c kernels/dyadic.c kernels/lanes.h kernels/exact.h
    sim/states.c sim/lists.c sim/calendar.c sim/cells.h sim/cells_block.h sim/cells.c
    sim/cells_stay.c sim/run.c
    kernels/event_time.c kernels/event_time_batch.c kernels/event_time_fast.c
    kernels/event_time_slow.c kernels/event_time_halfspace.c
    kernels/event_time_fast.h kernels/event_time_lanes.h
    kernels/event_time_meeting.h kernels/event_time_parting.h
    kernels/event_time_sums.h
"""
# The tests that are asked: those near by.  What studies, scenes and pages test is too
# far above to be built for every file.
NEAR = {
    "kernels": """step quadratic overlap impulse root dyadic lanes exact event_time
        path wall cells states run_test run_rim physics""",
    "sim": """states lists calendar cells run neighbours snapshot conservation
        sequence conventional_test plain_simulator reference longrun lanes system
        checkpoint clock start_test physics memory""",
}
# Of other rooms, those that take no more seconds than this; of its own, ten times.
SECONDS = 0.8
# Whose tests are its own besides those by its name.
ALSO = {"run": ["sequence_test", "conservation_test", "snapshot_test",
                "memory_test"],
        "exact": ["lanes_test"], "root": ["quadratic_test", "event_time_test"],
        "dyadic": ["root_test"], "lanes": ["quadratic_test"]}


def digest(*contents):
    return hashlib.sha1(b"\0".join(contents)).hexdigest()[:12]


def near(source, folder):
    names = NEAR[folder].split()
    return sorted(p.stem for p in source.glob("tests/*_test.c")
                  if any(p.stem.startswith(name) for name in names))


def is_own(test, stem):
    """By its name, or because it is of no room."""
    room = test.removesuffix("_test")
    return test in ALSO.get(stem, []) or stem.startswith(room) \
        or room.startswith(stem)


class Results:
    """What is known of mutants, in a file."""

    def __init__(self, path):
        self.path, self.of, self.lock = path, {}, threading.Lock()
        if path.exists():
            for line in path.read_text(encoding="latin-1").splitlines():
                words = line.split("\t")
                if len(words) == 3:  # one cut off by the end of a run is not
                    self.of[words[0], words[1]] = words[2]

    def put(self, content, mutant, what):
        with self.lock, self.path.open("a", encoding="latin-1") as file:
            self.of[content, mutant.key] = what
            print(content, mutant.key, what, sep="\t", file=file)


class Campaign:
    """All mutants of one file."""

    def __init__(self, build, sanitized, name, results, tests, jobs):
        self.build, self.sanitized = build, sanitized
        self.name, self.results, self.jobs = name, results, jobs
        self.stem = pathlib.Path(name).stem
        self.tests = tests
        build.restore(name)
        self.units = build.units(name)
        found = Finder(build.tree / name, self.units[0],
                       build.arguments(self.units[0]))
        self.text, self.functions = found.text, found.functions
        self.mutants = mutants_of(found.text, found.sites.values())
        self.content = digest(found.text.encode("latin-1"))
        tests_now = digest(*(
            p.read_bytes() for p in sorted((build.tree / "tests").iterdir())
            if p.suffix in (".c", ".h", ".wc")))
        # of those that no test has killed yet, and of those that are through
        self.standing, self.alive = f"standing {tests_now}", f"alive {tests_now}"
        self.took, self.reach, self.kills = {}, {}, {}

    def known(self, mutant):
        what = self.results.of.get((self.content, mutant.key), "")
        is_final = what == "same" or what.startswith(("killed", "uncompilable"))
        return what if is_final or what in (self.standing, self.alive) else ""

    def put(self, mutant, what):
        self.results.put(self.content, mutant, what)

    def run(self):
        todo = [m for m in self.mutants if not self.known(m)]
        self.say(f"{len(todo)} of {len(self.mutants)} mutants to try")
        try:
            self.try_in_one([m for m in todo if m.site.how != "own"])
            # and those of which the compiler had to know
            for mutant in (m for m in todo if not self.known(m)):
                self.try_alone(mutant)
            self.sort_out()
            self.try_sanitized()
        finally:
            self.build.restore(self.name)

    def those(self, what):
        return [m for m in self.mutants if self.known(m) == what]

    def say(self, what):
        print(f"{self.name}: {what}", file=sys.stderr, flush=True)

    # --- Trying --------------------------------------------------------------

    def measure(self, build):
        """Which tests pass, what they reach, how long it takes."""
        self.took, self.reach = {}, {}

        def one(test):
            most = SECONDS * (10 if is_own(test, self.stem) else 1)
            return test, most, build.reached(test, 3 * most)

        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            for test, most, answer in pool.map(one, self.tests):
                if answer and answer[0] <= most:
                    self.took[test], self.reach[test] = answer

    def order(self, tests):
        def worth(test):
            first = 10 if is_own(test, self.stem) else 1
            return (self.kills.get(test, 0) + first) / (self.took[test] + 0.005)
        return sorted(tests, key=worth, reverse=True)

    def function_of(self, mutant):
        """The last that begins before it; in none, where a constant stands."""
        before = [k for k, at in enumerate(self.functions)
                  if at <= mutant.site.start]
        return before[-1] if before else None

    def verdict(self, build, mutant, number, make=None):
        where = self.function_of(mutant)
        tests = [t for t in self.took if make or where in self.reach[t]]
        for test in self.order(tests):
            if make and make(test):
                return "uncompilable"
            if not build.passes(test, number, 10 * self.took[test] + 2):
                self.kills[test] = self.kills.get(test, 0) + 1
                return f"killed {test}"
        return self.standing

    def build_all(self, build, mutants):
        """In one text; those that do not compile there are left out."""
        while True:
            build.write(self.name, schema(self.text, mutants, self.functions))
            errors = build.make(self.tests, self.jobs)
            if not errors:
                self.measure(build)
                return mutants
            file = re.escape(self.name)
            lines = {int(n) for n in re.findall(rf"{file}:(\d+):\d+: error", errors)}
            keep = [m for m in mutants if m.line not in lines]
            if len(keep) == len(mutants):
                raise SystemExit(errors)
            mutants = keep

    def try_each(self, build, mutants):
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            def one(mutant):
                return mutant, self.verdict(build, mutant, mutant.number)
            for k, (mutant, verdict) in enumerate(pool.map(one, mutants), 1):
                self.put(mutant, verdict)
                if k % 100 == 0:
                    self.say(f"{k} tried")

    def try_in_one(self, mutants):
        if mutants:
            self.try_each(self.build, self.build_all(self.build, mutants))

    def try_alone(self, mutant):
        if not self.took:
            self.build_all(self.build, [])
        self.build.write(self.name, alone(self.text, mutant))
        self.put(mutant, self.verdict(
            self.build, mutant, 0, lambda test: self.build.make([test], self.jobs)))

    def sort_out(self):
        """Of those standing, the ones that make no difference to the code."""
        standing = self.those(self.standing)
        self.build.restore(self.name)
        code = {unit: self.build.code(unit) for unit in self.units if standing}
        for mutant in standing:
            self.build.write(self.name, alone(self.text, mutant))
            if all(self.build.code(unit) == code[unit] for unit in self.units):
                self.put(mutant, "same")

    def try_sanitized(self):
        """The rest with sanitizers, under which every test is run as well."""
        standing = self.those(self.standing)
        if any(m.site.how != "own" for m in standing):
            self.say(f"{len(standing)} mutants to try with sanitizers")
            self.try_each(self.sanitized, self.build_all(
                self.sanitized, [m for m in standing if m.site.how != "own"]))
            self.sanitized.restore(self.name)
        for mutant in self.those(self.standing):
            self.put(mutant, self.alive)


def main():
    options = argparse.ArgumentParser(usage=__doc__.split("\n")[2].removeprefix("usage: "))
    options.add_argument("-j", type=int, default=os.cpu_count(), dest="jobs")
    options.add_argument("-t", action="append", dest="tests")
    options.add_argument("source", type=pathlib.Path)
    options.add_argument("folder", type=pathlib.Path)
    options.add_argument("files", nargs="*", metavar="file")
    given = options.parse_intermixed_args()
    source, folder = given.source.resolve(), given.folder.resolve()
    build = Build(source, folder / "plain")
    sanitized = Build(source, folder / "sanitized", "-DBRINK_SANITIZE=ON")
    results = Results(folder / "results.txt")
    build.make(["brinksim"], given.jobs)  # so that it is known what includes what
    report = mutants_report.Report(source / "tests/mutants.txt")
    for name in given.files or FILES.split():
        tests = given.tests or near(source, name.split("/")[0])
        campaign = Campaign(build, sanitized, name, results, tests, given.jobs)
        campaign.run()
        report.add(campaign)
        (folder / "report.txt").write_text(report.page(), encoding="utf-8")
    print(report.table(), end="")
    print(f"what is alive: {folder / 'report.txt'}")
    build.clear()
    sanitized.clear()
    return report.status()


sys.exit(main())
