#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A proof's transcription as C, so that a test can set it beside the source it was written from.

Where a proof is about formulas written down again, a claim rests on their being the source's.
Here its file itself is read, a script of Gappa or cvc5 or Coq's definitions: what it defines of
doubles becomes functions of C, FILE_EXTENSION_NAME, of what it leaves open.  A rounding there
is one operation here, in the same order; what is no formula of doubles is left out.

usage: transcribe.py PROOF HEADER [acsl]   # acsl: logic functions, for links by WP
"""
import pathlib
import re
import sys
from fractions import Fraction

from transcribe_infix import Formula
from transcribe_reals import ACSL, BUILT_IN, C, Code, Definition, Double, Pair, Refused
from transcribe_smt import Script

PARTS = {"double": (), "dd": ("hi", "lo"), "product": ("x", "y")}


class Open:
    """A name that a file leaves open: a parameter of the functions that it is in."""

    def __init__(self, name, kind="double"):
        self.name = name
        self.kind = kind

    def doubles(self, language):
        """What it is made of."""
        between = "." if language is C else "_"
        return [self.name + between + part for part in PARTS[self.kind]] or [self.name]

    def declared(self, language):
        if language is C:
            return f"{self.kind} {self.name}"
        return ", ".join(f"double {double}" for double in self.doubles(language))

    def value(self, language):
        parts = [Double(double) for double in self.doubles(language)]
        if self.kind == "dd":
            return Pair(*parts)
        return ("*", *parts) if self.kind == "product" else parts[0]

    def is_in(self, text, language):
        return any(re.search(rf"\b{re.escape(double)}\b", text)
                   for double in self.doubles(language))


def each_rounded(tree):
    """Gappa's `x d= tree`: every operation in it is rounded."""
    if not isinstance(tree, tuple):
        return tree
    first = 2 if tree[0] == "call" else 1
    return ("call", "d", (*tree[:first], *[each_rounded(part) for part in tree[first:]]))


def power(text):
    """Gappa's number 3b-53."""
    digits, exponent = (text + "b0").split("b")[:2]
    return float(Fraction(digits) * Fraction(2) ** int(exponent)).hex()


def products_of(text):
    """The names that a file says stand for exact products of doubles."""
    return " ".join(re.findall(r"products: ([\w ]+)", text)).split()


def gappa(text):
    """Definitions, and the range that is assumed of what is open."""
    products = products_of(text)
    text = re.sub(r"#.*", "", text)
    script, _, goal = text.partition("{")
    definitions, ranges = {}, {}
    for name, rounds, formula in re.findall(r"(?<!@)\b(\w+) (d?)= ([^;]+);", script):
        tree = Formula(formula).whole()
        source = tree[2] if tree[0] == "call" and tree[1] == "d" else None
        if name in products:
            definitions[name] = Open(name, "product")
        elif isinstance(source, str) and source not in definitions:  # d(x): any double
            definitions[name] = Open(name)
            assumed = re.search(rf"(-?)\|?\b(?:{name}|{source})\b\|? in \[(\S+), (\S+)\]", goal)
            if assumed:
                low, high = power(assumed[2]), power(assumed[3])
                ranges[name] = (f"-{high}", f"-{low}") if assumed[1] else (low, high)
        else:
            definitions[name] = Definition((), each_rounded(tree) if rounds else tree)
    return definitions, ranges


def coq(text):
    """Definitions, those of a section of its variables, and the kinds of their parameters."""
    products = products_of(text)
    text = re.sub(r"\(\*.*?\*\)", "", text, flags=re.DOTALL)
    definitions, kinds = {}, {}
    for what, said in re.findall(r"^(Variables|Definition|Let) (.*?)\.\s", text,
                                 re.DOTALL | re.MULTILINE):
        if what == "Variables":
            names, _, kind = said.partition(" : ")
            definitions.update((name, Open(name, kind if kind == "dd" else "double"))
                               for name in names.split())
            continue
        head, _, body = said.partition(":=")
        if not body:
            continue  # a lemma
        name, _, rest = head.strip().partition(" ")
        rest = re.sub(r":[^()]*$", "", rest)  # the type of it all
        parameters = {}
        for names, kind, bare in re.findall(r"\(([\w ]+) : ([\w* ]+)\)|(\w+)", rest):
            for parameter in (names or bare).split():
                parameters[parameter] = ("dd" if kind in ("dd", "R * R") else
                                         "product" if parameter in products else "double")
        try:
            definitions[name] = Definition(tuple(parameters), Formula(body).whole())
            kinds[name] = parameters
        except SyntaxError:
            continue  # of integers, or a type
    return definitions, kinds


def function(name, prefix, definitions, kinds, language):
    """A definition in a language."""
    definition = definitions[name]
    code = Code(definitions, language)
    mine = [Open(p, kind) for p, kind in kinds.items()]
    code.known = {n: o.value(language) for n, o in definitions.items() if isinstance(o, Open)}
    value = code.value(definition.tree, {p.name: p.value(language) for p in mine})
    kind, answer = code.answer(value)
    lines = code.lines_for(" ".join(answer))
    text = " ".join([*lines, *answer])
    free = [o for o in definitions.values() if isinstance(o, Open) and o.name not in kinds
            and o.is_in(text, language)]
    declared = ", ".join(o.declared(language) for o in free + mine)
    if language is C:
        result = f"(dd){{{', '.join(answer)}}}" if kind == "dd" else answer[0]
        body = "\n    ".join([*lines, f"return {result};"])
        return (f"static inline {kind} {prefix}_{name}({declared or 'void'})\n"
                f"{{\n    {body}\n}}\n")
    if not declared:
        raise Refused("a constant")
    what = "predicate" if kind == "int" else "logic double"
    return "".join(f"/*@ {what} {prefix}_{name}{part}({declared}) =\n  @     "
                   + "\n  @     ".join([*code.lines_for(term), f"{term};"]) + "\n  @*/\n"
                   for part, term in zip(("_hi", "_lo") if kind == "dd" else ("",), answer))


def functions(own, prefix, definitions, kinds, language):
    for name in own:
        if isinstance(definitions[name], Definition) and name not in BUILT_IN:
            try:
                yield function(name, prefix, definitions, kinds.get(name, {}), language)
            except Refused as reason:
                yield f"// {name}: {reason}\n"


def transcribed(proof, prefix, language):
    text = proof.read_text()
    if proof.suffix == ".smt2":
        return Script(text, prefix).c
    if proof.suffix == ".g":
        definitions, ranges = gappa(text)
        limits = [f"static const double {prefix}_{name}_range[2] = {{{low}, {high}}};\n"
                  for name, (low, high) in ranges.items() if language is C]
        return limits + list(functions(definitions, prefix, definitions, {}, language))
    definitions = {}
    for other in " ".join(re.findall(r"with: ([\w. ]+)", text)).split():
        theirs = coq((proof.parent / other).read_text())[0]
        definitions.update((n, d) for n, d in theirs.items() if isinstance(d, Definition))
    own, kinds = coq(text)
    definitions.update(own)
    return list(functions(own, prefix, definitions, kinds, language))


def main():
    proof, header = map(pathlib.Path, sys.argv[1:3])
    language = ACSL if sys.argv[3:] == ["acsl"] else C
    prefix = proof.name.replace(".", "_")
    parts = [f"// From proofs/{proof.name}, by tests/transcribe.py.\n",
             f"#ifndef {prefix.upper()}\n#define {prefix.upper()}\n"]
    if language is C:
        parts.append('#include "transcription.h"\n')
    header.parent.mkdir(parents=True, exist_ok=True)
    header.write_text("\n".join([*parts, *transcribed(proof, prefix, language), "#endif\n"]))


if __name__ == "__main__":
    main()
