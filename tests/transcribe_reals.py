# SPDX-License-Identifier: MIT
"""Formulas in real numbers with roundings in them, as C in doubles.

A rounding can be written in C where it is that of one operation: a sum, product, quotient or
root of doubles, or a product with a double added, which is fma().  What a rounding leaves, x -
rnd x, is rest_of_sum() or rest_of_product() of transcription.h.  Anything else is no formula
of doubles, and refused.

A real number here is a Double, with its C; a Fraction; or a tuple as those of transcribe_infix:
not rounded yet.  A Pair is Coq's `Dd hi lo` or `(hi, lo)`, or a sum of two doubles that is left as it is.
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


# How it is written: C, and ACSL for its links (proofs/link_wp.h).
C = {"+": "{} + {}", "-": "{} - {}", "*": "{} * {}", "/": "{} / {}", "neg": "-{}",
     "scaled": "({} * {})", "sqrt": "sqrt({})", "abs": "fabs({})", "fma": "fma({}, {}, {})",
     "max": "fmax({}, {})", "min": "fmin({}, {})",
     "low sum": "rest_of_sum({}, {})", "low product": "rest_of_product({}, {})",
     "number": "{}", "line": "const double {} = {};",
     "=": "{} == {}", "<": "{} < {}", "if": "({} < {} ? {} : {})"}
ACSL = {"+": "\\add_double({}, {})", "-": "\\sub_double({}, {})", "*": "\\mul_double({}, {})",
        "/": "\\div_double({}, {})", "neg": "\\neg_double({})", "scaled": "\\mul_double({}, {})",
        "sqrt": "root_of({}).x", "abs": "size_of({}).x", "fma": "fma_of({}, {}, {}).x",
        "low product": "fma_of({0}, {1}, \\neg_double(\\mul_double({0}, {1}))).x",
        "number": "(double){}", "line": "\\let {} = {};",
        "=": "\\eq_double({}, {})", "<": "\\lt_double({}, {})"}


def negative(x):
    return -x if isinstance(x, Fraction) else ("neg", x)


BUILT_IN = {"rnd", "low"}  # whatever a file makes them of
OF_ONE = {"rnd", "d", "low", "Rabs", "sqrt", "hi", "lo", "fst", "snd", "pow"}
PART = {"hi": "hi", "lo": "lo", "fst": "hi", "snd": "lo"}
OF_NUMBERS = {"+": lambda x, y: x + y, "-": lambda x, y: x - y,
              "*": lambda x, y: x * y, "/": lambda x, y: x / y}


def combined(operator, x, y):
    if isinstance(x, Fraction) and isinstance(y, Fraction):
        return OF_NUMBERS[operator](x, y)
    return ("+", x, negative(y)) if operator == "-" else (operator, x, y)


class Code:
    """The lines of a function's body, as its formula is gone through."""

    def __init__(self, definitions, language):
        self.definitions = definitions
        self.language = language
        self.known = {}  # what those come to that are no functions
        self.lines = []
        self.rounds = {}  # a name of the lines, and what it is the rounding of

    def written(self, operation, *parts):
        if operation not in self.language:
            raise Refused(operation)
        return Double(self.language[operation].format(*[part.c for part in parts]))

    def named(self, of, operation, *parts):
        name = Double(f"x{len(self.lines)}")
        done = self.written(operation, *parts)
        self.lines.append(self.written("line", name, done).c)
        self.rounds[name] = of
        return name

    def double(self, x):
        """x where it is a double without being rounded, of any exponent; None."""
        if isinstance(x, Double):
            return x
        if isinstance(x, Fraction):
            is_one = abs(x) < 2 ** 1023 and float(x) == x
            return self.written("number", Double(float(x).hex())) if is_one else None
        if isinstance(x, tuple) and x[0] in ("neg", "abs", "max", "min"):
            parts = [self.double(y) for y in x[1:]]
            return self.written(x[0], *parts) if all(parts) else None
        if isinstance(x, tuple) and x[0] == "*":
            for power, y in (x[1:], x[:0:-1]):
                if is_power(power) and (y := self.double(y)):
                    return self.written("scaled", self.double(power), y)
        return None

    def factors(self, x):
        """Of an exact product of doubles, its sign with the first; None."""
        if isinstance(x, tuple) and x[0] == "neg" and (factors := self.factors(x[1])):
            return self.written("neg", factors[0]), factors[1]
        if isinstance(x, tuple) and x[0] == "*":
            factors = self.double(x[1]), self.double(x[2])
            return factors if all(factors) else None
        return None

    def lines_for(self, answer):
        """Those that an answer needs."""
        kept = []
        for number, line in reversed(list(enumerate(self.lines))):
            if re.search(rf"\bx{number}\b", " ".join([answer, *kept])):
                kept.insert(0, line)
        return kept

    def rounded(self, x):
        if double := self.double(x):
            return double
        if not isinstance(x, tuple):
            raise Refused(f"rnd {x}")
        if x[0] == "neg":
            return self.written("neg", self.rounded(x[1]))
        y, z = self.double(x[1]), self.double(x[-1])
        if x[0] == "sqrt" and y:
            return self.named(x, "sqrt", y)
        if x[0] == "+" and y and z and isinstance(x[2], tuple) and x[2][0] == "neg":
            return self.named(x, "-", y, self.double(x[2][1]))
        if x[0] in "+*/" and y and z:
            return self.named(x, x[0], y, z)
        if x[0] == "+":
            for factors, summand in (self.factors(x[1]), z), (self.factors(x[2]), y):
                if factors and summand:
                    return self.named(x, "fma", *factors, summand)
        raise Refused(f"rnd {x}")

    def low(self, x):
        """x - rnd x."""
        if self.double(x):
            return Fraction(0)
        if factors := self.factors(x):
            return self.named(None, "low product", *factors)
        if isinstance(x, tuple) and x[0] == "+":
            y, z = self.double(x[1]), self.double(x[2])
            if y and z:
                return self.named(None, "low sum", y, z)
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
        if x[0] == "pair":
            return self.pair(*parts)
        if x[0] == "if":
            return self.chosen(*parts)
        if x[0] in ("<", "<=", ">", ">=", "="):
            return self.compared(x[0], *parts)
        if x[0] == "-" and len(parts) == 2 and parts[0] == self.rounds.get(parts[1]):
            return self.low(parts[0])
        if len(parts) == 2:
            return combined(x[0], *parts)
        return negative(*parts) if x[0] == "-" else combined("/", Fraction(1), *parts)

    def chosen(self, x, y, one, other):
        """Of two pairs, each part."""
        if isinstance(one, Pair):
            return Pair(self.chosen(x, y, one.hi, other.hi), self.chosen(x, y, one.lo, other.lo))
        return self.written("if", *[self.rounded(z) for z in (x, y, one, other)])

    def pair(self, x, y):
        hi, lo = self.double(x), self.double(y)
        if not (hi and lo):
            raise Refused("a pair of what is not rounded")
        return Pair(hi, lo)

    def defined(self, name):
        if name not in self.known:
            definition = self.definitions.get(name)
            if not isinstance(definition, Definition) or definition.parameters:
                raise Refused(name)
            self.known[name] = self.value(definition.tree, {})
        return self.known[name]

    def compared(self, relation, x, y):
        x, y = self.double(x), self.double(y)
        if not (x and y):
            raise Refused("a comparison of what is not rounded")
        return Truth(self.written(relation, x, y).c)

    def call(self, function, arguments):
        if function in OF_ONE and len(arguments) != 1:
            raise Refused(function)
        if function in ("rnd", "d"):
            return self.rounded(*arguments)
        if function == "low":
            return self.low(*arguments)
        if function in ("Rabs", "Rmax", "Rmin", "sqrt"):
            return (function.removeprefix("R"), *arguments)
        if function == "Dd":
            return Pair(*[self.rounded(x) for x in arguments])
        if function in PART and isinstance(arguments[0], Pair):
            return getattr(arguments[0], PART[function])
        if function == "pow" and isinstance(arguments[0], Fraction):
            return Fraction(2) ** int(arguments[0])
        definition = self.definitions.get(function)
        if not isinstance(definition, Definition):
            raise Refused(str(function))
        return self.value(definition.tree, dict(zip(definition.parameters, arguments)))

    def answer(self, x):
        """Its type in C, and what it is in the language: of a pair, both."""
        if isinstance(x, Truth):
            return "int", [x.c]
        if double := self.double(x):
            return "double", [double.c]
        if isinstance(x, tuple) and x[0] == "+" and self.double(x[1]) and self.double(x[2]):
            x = Pair(self.double(x[1]), self.double(x[2]))
        if isinstance(x, Pair):
            return "dd", [x.hi.c, x.lo.c]
        raise Refused("it is not rounded")
