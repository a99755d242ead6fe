#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The mutants' tool on a file of a few functions: what every mutant does in the one
text is what it does written out by itself, and there are all that there should be.

usage: mutants_check.py CC

Exit status 77: clang's Python module is not here.
"""
import pathlib
import subprocess
import sys
import tempfile

try:
    from mutants_find import Finder
except ImportError as reason:
    print(f"not tried: {reason}")
    sys.exit(77)
from mutants_schema import alone, mutants_of, schema

CODE = r"""
#include <stdint.h>
#include <stdio.h>
#define TWICE(x) ((x) + (x))
static const int table[3] = {7, 0, 9};
typedef double two __attribute__((vector_size(16)));

static int count(int a, int b) // several lines, and a comment
{
    int n = 0;
    for (int k = a; k < b; k++)
        if (k % 3 == 0 && // between
            !(k & 1))
            n += 2;
        else
            --n;
    if (n++ > 1)
        n += 4;
    return n;
}

static double part(double x, const double *y)
{
    const two v = {x, 0.5}, w = v * 2;
    double z = -y[1];
    if (x < 0 || *y != 0x1p-3) {
        z = TWICE(x - w[0]);
    } else {
        z -= 1;
    }
    if (z > 100)
        return 0;
    return z / 4;
}

int main(void)
{
    const double y[2] = {0.125, 3};
    uint64_t bits = UINT64_C(0x70) >> 2 | 1;
    printf("%d %d ", count(0, 20), table[1]);
    printf("%g %g %d", part(3, y), part(-3, y + 1), (int)bits);
}
"""
EXPECTED = 134  # gone through by hand, once


def output(program, mutant):
    done = subprocess.run([program], env={"BRINK_MUTANT": str(mutant),
                                          "BRINK_MUTANT_SECONDS": "1"},
                          capture_output=True, check=False)
    return done.returncode, done.stdout


def main():
    here = pathlib.Path(__file__).resolve().parent
    with tempfile.TemporaryDirectory() as folder:
        file, program = pathlib.Path(folder) / "a.c", pathlib.Path(folder) / "a"

        def build(text):
            file.write_text(text, encoding="ascii")
            return subprocess.run(
                [sys.argv[1], "-std=c17", "-w", "-O0", "-ffp-contract=off", file,
                 here / "mutants_switch.c", "-o", program],
                capture_output=True, text=True, check=False)

        file.write_text(CODE, encoding="ascii")
        found = Finder(file, file, ["-std=c17"])
        mutants = mutants_of(CODE, found.sites.values())
        together = [m for m in mutants if m.site.how != "own"]
        done = build(schema(CODE, together, found.functions))
        if done.returncode:
            sys.exit(done.stderr)
        right, wrong, killed = output(program, 0), 0, 0
        seen = {m: output(program, m.number) for m in together}
        for mutant in mutants:
            if build(alone(CODE, mutant)).returncode:
                print("does not compile:", mutant.was, "->", mutant.now)
                continue
            itself = output(program, 0)
            killed += itself != right
            if seen.get(mutant, itself) != itself:
                wrong += 1
                print(f"{mutant.line}: {mutant.was} -> {mutant.now}: "
                      f"{seen[mutant]}, by itself {itself}")
        print(f"{len(mutants)} mutants, {killed} told apart from the file as it is, "
              f"{wrong} not what they are by themselves")
        sys.exit(wrong != 0 or len(mutants) != EXPECTED)


main()
