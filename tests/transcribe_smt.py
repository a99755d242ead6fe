# SPDX-License-Identifier: MIT
"""The functions that an .smt2 file defines, of doubles, bits and truths, as C."""
import re

TYPES = {"Double": "double", "Bool": "int"}  # any other is some bits
CALLS = {
    "fp.add": "({1} + {2})", "fp.sub": "({1} - {2})", "fp.mul": "({1} * {2})",
    "fp.div": "({1} / {2})", "fp.sqrt": "sqrt({1})",  # {0} is how they are rounded: RNE
    "fp.abs": "fabs({0})", "fp.neg": "(-{0})",
    "fp.lt": "({0} < {1})", "fp.leq": "({0} <= {1})", "fp.gt": "({0} > {1})",
    "fp.geq": "({0} >= {1})", "fp.eq": "({0} == {1})",
    "ite": "({0} ? {1} : {2})", "and": "({0} && {1})", "or": "({0} || {1})", "not": "(!{0})",
    "bvult": "({0} < {1})", "bvule": "({0} <= {1})",
    "bvadd": "({0} + {1})", "bvsub": "({0} - {1})", "bvneg": "(-{0})",
    "bvand": "({0} & {1})", "bvor": "({0} | {1})", "bvnot": "(~{0})",
    "bvlshr": "({0} >> {1})", "bvshl": "({0} << {1})",
}


def expressions(text):
    """What stands in parentheses, as lists of lists and words."""
    text = re.sub(r";.*", "", text)
    stack = [[]]
    for token in re.findall(r"[()]|[^\s()]+", text):
        if token == "(":
            stack.append([])
        elif token == ")":
            closed = stack.pop()
            stack[-1].append(closed)
        else:
            stack[-1].append(token)
    return stack[0]


def literal(x):
    """C of a number that is written out; None."""
    if isinstance(x, str) and x.startswith("#b"):
        return f"UINT64_C({int(x[2:], 2)})"
    if isinstance(x, list) and x[0] == "_" and x[1].startswith("bv"):
        return f"UINT64_C({x[1][2:]})"
    return "0.0" if isinstance(x, list) and x[:2] == ["_", "+zero"] else None


class Script:
    """Its functions one after the other; what is declared is a parameter of those it is in."""

    def __init__(self, text, prefix):
        self.prefix = prefix
        self.free = {}
        self.functions = {}  # name -> the free names that are passed on to it
        self.used = set()
        self.c = []
        for statement in expressions(text):
            if statement[0] == "declare-const":
                self.free[statement[1]] = TYPES.get(str(statement[2]), "uint64_t")
            elif statement[0] == "define-fun":
                self.define(*statement[1:])

    def define(self, name, parameters, kind, body):
        self.used = set()
        c = self.written(body, {p[0] for p in parameters})
        passed = [f for f in self.free if f in self.used]
        self.functions[name] = passed
        declared = [f"{self.free[f]} {f}" for f in passed]
        declared += [f"{TYPES.get(str(p[1]), 'uint64_t')} {p[0]}" for p in parameters]
        self.c.append(f"static inline {TYPES.get(str(kind), 'uint64_t')} {self.prefix}_{name}"
                      f"({', '.join(declared) or 'void'})\n{{\n    return {c};\n}}\n")

    def written(self, x, local):
        if number := literal(x):
            return number
        if isinstance(x, str):
            if x in local or x in self.free:
                self.used |= {x} - local
                return x
            return x if x == "RNE" else self.called(x, [])
        if isinstance(x[0], list):  # ((_ to_fp 11 53) bits), ((_ extract last first) bits)
            return self.indexed(x[0], self.written(x[1], local))
        parts = [self.written(y, local) for y in x[1:]]
        if x[0] == "fp":
            sign, exponent, mantissa = parts
            return f"double_of({sign} << 63 | {exponent} << 52 | {mantissa})"
        return CALLS[x[0]].format(*parts) if x[0] in CALLS else self.called(x[0], parts)

    def called(self, name, arguments):
        self.used |= set(self.functions[name])
        return f"{self.prefix}_{name}({', '.join(self.functions[name] + arguments)})"

    @staticmethod
    def indexed(operator, bits):
        if operator[1] == "to_fp":
            return f"double_of({bits})"
        last, first = int(operator[2]), int(operator[3])
        return f"({bits} >> {first} & UINT64_C({2 ** (last - first + 1) - 1}))"
