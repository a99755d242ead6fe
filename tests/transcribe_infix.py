# SPDX-License-Identifier: MIT
"""Formulas of Coq and of Gappa as trees: what stands between `:=`, or `=`, and the period.

A tree is a name, a Fraction, or a tuple of what is done and to what: ("+", x, y), ("-", x),
("call", function, x, ...), ("let", name, x, body), ("if", x, y, then, else), ("pair", x, y),
("<", x, y).
"""
import fractions
import re

TOKEN = re.compile(r"\s*(?:(\d+(?:\.\d+)?)|([A-Za-z_]\w*)|(:=|<=|>=|.))", re.DOTALL)


class Formula:
    """Reads one, from its text."""

    def __init__(self, text):
        self.tokens = [m.group(m.lastindex) for m in TOKEN.finditer(text.strip())]
        self.at = 0

    def next(self, *wanted):
        """The next token, if it is wanted."""
        token = self.tokens[self.at] if self.at < len(self.tokens) else None
        if token in wanted:
            self.at += 1
            return token
        return None

    def need(self, wanted):
        if not self.next(wanted):
            raise SyntaxError(f"{wanted} is wanted before {self.tokens[self.at:]}")

    def whole(self):
        tree = self.any()
        if self.at < len(self.tokens):
            raise SyntaxError(f"{self.tokens[self.at:]} is left")
        return tree

    def any(self):
        if self.next("let"):
            name = self.tokens[self.at]
            self.at += 1
            self.need(":=")
            bound = self.any()
            self.need("in")
            return ("let", name, bound, self.any())
        if self.next("if"):
            self.need("Rlt_dec")
            compared = self.atom(), self.atom()
            self.need("then")
            chosen = self.any()
            self.need("else")
            return ("if", *compared, chosen, self.any())
        left = self.sum()
        relation = self.next("<", "<=", ">", ">=", "=")
        return (relation, left, self.sum()) if relation else left

    def sum(self):
        left = self.product()
        while operator := self.next("+", "-"):
            left = (operator, left, self.product())
        return left

    def product(self):
        left = self.signed()
        while operator := self.next("*", "/"):
            left = (operator, left, self.signed())
        return left

    def signed(self):
        operator = self.next("-", "/")
        return (operator, self.signed()) if operator else self.applied()

    def applied(self):
        function = self.atom()
        arguments = []
        while (argument := self.atom()) is not None:
            arguments.append(argument)
        return ("call", function, *arguments) if arguments else function

    def atom(self):
        """A name, a number, what stands in parentheses, two with a comma; None."""
        token = self.tokens[self.at] if self.at < len(self.tokens) else ")"
        if self.next("("):
            inner = self.any()
            if self.next(","):
                inner = ("pair", inner, self.any())
            self.need(")")
            return inner
        if token not in ("in", "then", "else") and re.match(r"\w", token):
            self.at += 1
            return fractions.Fraction(token) if token[0].isdigit() else token
        return None
