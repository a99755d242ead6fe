# SPDX-License-Identifier: MIT
"""Formulas in real numbers with roundings in them, as C in doubles.

A rounding can be written in C where it is that of one operation: a sum, product, quotient or
root of doubles, or a product with a double added, which is fma().  What a rounding leaves, x -
rnd x, is rest_of_sum() or rest_of_product() of transcription.h.  Anything else is no formula
of doubles, and refused.

A real number here is a Double, with its C; a Fraction; or a tuple as those of transcribe_infix:
not rounded yet.  A Pair is Coq's `Dd hi lo`, or a sum of two doubles that is left as it is.
"""
import dataclasses
import re
from fractions import Fraction


@dataclasses.dataclass(frozen=True)
class Double:
    c: str


@dataclasses.dataclass(frozen=True)
class Pair:
    hi: Double
    lo: Double


@dataclasses.dataclass(frozen=True)
class Truth:
    c: str


@dataclasses.dataclass(frozen=True)
class Definition:
    """A function's parameters and tree; of what is no function, none."""
    parameters: tuple
    tree: object


class Refused(Exception):
    """It is no formula of doubles."""


def is_power(x):
    return isinstance(x, Fraction) and x > 0 and all(
        part & (part - 1) == 0 for part in (x.numerator, x.denominator))


def as_double(x):
    """x where it is a double without being rounded, of any exponent; None."""
    if isinstance(x, Double):
        return x
    if isinstance(x, Fraction):
        return Double(float(x).hex()) if Fraction(float(x)) == x else None
    if isinstance(x, tuple) and x[0] in ("neg", "abs") and (y := as_double(x[1])):
        return Double(f"-{y.c}" if x[0] == "neg" else f"fabs({y.c})")
    if isinstance(x, tuple) and x[0] == "*":
        for power, y in (x[1:], x[:0:-1]):
            if is_power(power) and (y := as_double(y)):
                return Double(f"({as_double(power).c} * {y.c})")
    return None


def negative(x):
    return -x if isinstance(x, Fraction) else ("neg", x)


BUILT_IN = {"rnd", "low"}  # whatever a file makes them of
OF_NUMBERS = {"+": lambda x, y: x + y, "-": lambda x, y: x - y,
              "*": lambda x, y: x * y, "/": lambda x, y: x / y}


def combined(operator, x, y):
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return OF_NUMBERS[operator](x, y)
    return ("+", x, negative(y)) if operator == "-" else (operator, x, y)


def factors_of(x):
    """Of an exact product of doubles, its sign with the first; None."""
    if isinstance(x, tuple) and x[0] == "neg" and (factors := factors_of(x[1])):
        return Double(f"-{factors[0].c}"), factors[1]
    if isinstance(x, tuple) and x[0] == "*":
        factors = as_double(x[1]), as_double(x[2])
        return factors if all(factors) else None
    return None


class Code:
    """The lines of a function's body, as its formula is gone through."""

    def __init__(self, definitions):
        self.definitions = definitions
        self.known = {}  # what those come to that are no functions
        self.lines = []
        self.rounds = {}  # a name of the lines, and what it is the rounding of

    def named(self, c, of=None):
        name = Double(f"x{len(self.lines)}")
        self.lines.append(f"const double {name.c} = {c};")
        self.rounds[name] = of
        return name

    def lines_for(self, answer):
        """Those that an answer needs."""
        kept = []
        for number, line in reversed(list(enumerate(self.lines))):
            if re.search(rf"\bx{number}\b", " ".join([answer, *kept])):
                kept.insert(0, line)
        return kept

    def rounded(self, x):
        if double := as_double(x):
            return double
        if not isinstance(x, tuple):
            raise Refused(f"rnd {x}")
        if x[0] == "neg":
            return Double(f"-{self.rounded(x[1]).c}")
        y, z = as_double(x[1]), as_double(x[-1])
        if x[0] == "sqrt" and y:
            return self.named(f"sqrt({y.c})")
        if x[0] in "+*/" and y and z:
            return self.named(f"{y.c} {x[0]} {z.c}", x)
        if x[0] == "+":
            for factors, summand in (factors_of(x[1]), z), (factors_of(x[2]), y):
                if factors and summand:
                    return self.named(f"fma({factors[0].c}, {factors[1].c}, {summand.c})")
        raise Refused(f"rnd {x}")

    def low(self, x):
        """x - rnd x."""
        if as_double(x):
            return Fraction(0)
        if factors := factors_of(x):
            return self.named(f"rest_of_product({factors[0].c}, {factors[1].c})")
        if isinstance(x, tuple) and x[0] == "+":
            y, z = as_double(x[1]), as_double(x[2])
            if y and z:
                return self.named(f"rest_of_sum({y.c}, {z.c})")
        raise Refused(f"low {x}")

    def value(self, x, local):
        """What a tree comes to, with what the names in it stand for."""
        if isinstance(x, Fraction):
            return x
        if isinstance(x, str):
            return local[x] if x in local else self.defined(x)
        if x[0] == "let":
            return self.value(x[3], {**local, x[1]: self.value(x[2], local)})
        if x[0] == "call":
            return self.call(x[1], [self.value(y, local) for y in x[2:]])
        parts = [self.value(y, local) for y in x[1:]]
        if x[0] in ("<", "<=", ">", ">=", "="):
            return self.compared(x[0], *parts)
        if x[0] == "-" and len(parts) == 2 and parts[0] == self.rounds.get(parts[1]):
            return self.low(parts[0])
        if len(parts) == 2:
            return combined(x[0], *parts)
        return negative(*parts) if x[0] == "-" else combined("/", Fraction(1), *parts)

    def defined(self, name):
        if name not in self.known:
            definition = self.definitions.get(name)
            if not isinstance(definition, Definition) or definition.parameters:
                raise Refused(name)
            self.known[name] = self.value(definition.tree, {})
        return self.known[name]

    @staticmethod
    def compared(relation, x, y):
        x, y = as_double(x), as_double(y)
        if not (x and y):
            raise Refused("a comparison of what is not rounded")
        return Truth(f"{x.c} {'==' if relation == '=' else relation} {y.c}")

    def call(self, function, arguments):
        if function in ("rnd", "d"):
            return self.rounded(*arguments)
        if function == "low":
            return self.low(*arguments)
        if function in ("Rabs", "sqrt"):
            return (function.removeprefix("R"), *arguments)
        if function == "Dd":
            return Pair(*[self.rounded(x) for x in arguments])
        if function in ("hi", "lo") and isinstance(arguments[0], Pair):
            return getattr(arguments[0], function)
        if function == "pow" and isinstance(arguments[0], Fraction):
            return Fraction(2) ** int(arguments[0])
        definition = self.definitions.get(function)
        if not isinstance(definition, Definition):
            raise Refused(str(function))
        return self.value(definition.tree, dict(zip(definition.parameters, arguments)))

    @staticmethod
    def answer(x):
        """C's type of it, and how it is written there."""
        if isinstance(x, Truth):
            return "int", x.c
        if double := as_double(x):
            return "double", double.c
        if isinstance(x, tuple) and x[0] == "+" and as_double(x[1]) and as_double(x[2]):
            x = Pair(as_double(x[1]), as_double(x[2]))
        if isinstance(x, Pair):
            return "dd", f"(dd){{{x.hi.c}, {x.lo.c}}}"
        raise Refused("it is not rounded")
