# SPDX-License-Identifier: MIT
"""Where a C file can be mutated, from clang's syntax tree.

A Site is a piece of the file with holes: `{0} < {1}`, and what might stand there
instead.  Sites nest; every other form of every site is a mutant.
"""
import ctypes
import dataclasses
import re

from clang import cindex
from clang.cindex import CursorKind as Kind
from clang.cindex import TypeKind

RELATIONS = ("<", "<=", ">", ">=", "==", "!=")
ARITHMETIC = ("+", "-", "*", "/")
OTHERS = {op: [o for o in RELATIONS if o != op] for op in RELATIONS}
OTHERS |= {op: [o for o in ARITHMETIC if o != op] for op in ARITHMETIC}
OTHERS |= {"%": ["*"], "<<": [">>"], ">>": ["<<"], "&": ["|"], "|": ["&"],
           "^": ["&", "|"], "&&": ["||"], "||": ["&&"]}
FLOATING = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}
NUMBER = re.compile(r"[0-9.]|U?INT\d+_C\(")
UNEVALUATED = {Kind.CXX_UNARY_EXPR, Kind.STATIC_ASSERT, Kind.PARM_DECL,
               Kind.ASM_STMT}


@dataclasses.dataclass(frozen=True)
class Site:
    """text[start:end] is `form` with its holes filled in.

    how  value  the holes are evaluated once, then the form is chosen
         text   the form is chosen, then what is in it evaluated
         logic  && or ||
         block  a statement in braces
         own    a constant that the compiler must know: one build a mutant
    """
    start: int
    end: int
    holes: tuple
    form: str
    others: tuple
    how: str


def _file_location(where):
    """File and offset; of a macro's argument where it is written."""
    locate = cindex.conf.lib.clang_getFileLocation
    locate.argtypes = [cindex.SourceLocation] + [ctypes.c_void_p] * 4
    file, offset = cindex.c_object_p(), ctypes.c_uint()
    locate(where, ctypes.byref(file), None, None, ctypes.byref(offset))
    return (cindex.File(file).name if file else None), offset.value


def _is_floating(kind):
    kind = kind.get_canonical()
    if kind.kind == TypeKind.VECTOR:
        kind = kind.element_type.get_canonical()
    return kind.kind in FLOATING


def _is_pointer(cursor):
    return cursor.type.get_canonical().kind in (TypeKind.POINTER,
                                                TypeKind.CONSTANTARRAY)


def _unwrapped(cursor):
    """Without the conversions that the compiler has put around it."""
    while cursor.kind == Kind.UNEXPOSED_EXPR:
        inside = list(cursor.get_children())
        if len(inside) != 1:
            break
        cursor = inside[0]
    return cursor


class Finder:
    def __init__(self, path, unit, arguments):
        """`unit` is the file that is compiled: `path`, or one that includes it."""
        self.path = str(path)
        self.text = path.read_bytes().decode("latin-1")  # a byte a character
        self.sites = {}
        self.functions = []  # where their bodies begin, behind the brace
        options = cindex.TranslationUnit.PARSE_DETAILED_PROCESSING_RECORD
        parsed = cindex.Index.create().parse(str(unit), args=arguments,
                                             options=options)
        faults = [d for d in parsed.diagnostics if d.severity > 2]
        if faults:
            raise SystemExit(f"mutants: {faults[0]}")
        for cursor in parsed.cursor.get_children():
            if _file_location(cursor.location)[0] == self.path:
                if cursor.kind == Kind.MACRO_DEFINITION:
                    self.macro(cursor)
                else:
                    self.visit(cursor, not cursor.kind == Kind.FUNCTION_DECL)

    # --- What is written where -----------------------------------------------

    def span(self, cursor):
        """Its place in the file; None where a macro has made it."""
        begin, start = _file_location(cursor.extent.start)
        finish, end = _file_location(cursor.extent.end)
        here = begin == finish == self.path and start < end
        return (start, end) if here else None

    def add(self, span, holes, form, others, how):
        if others:
            site = Site(*span, tuple(holes), form, tuple(others), how)
            self.sites.setdefault((span, form), site)

    # --- Declarations --------------------------------------------------------

    def macro(self, cursor):
        """Numbers in what a macro stands for."""
        tokens = list(cursor.get_tokens())[1:]
        for token in tokens:
            if token.kind == cindex.TokenKind.LITERAL:
                span = token.extent.start.offset, token.extent.end.offset
                self.number(span, constant=True)

    def visit(self, cursor, constant):
        kind = cursor.kind
        if kind in UNEVALUATED:
            return
        handler = getattr(self, kind.name.lower(), None)
        if handler:
            handler(cursor, constant)
        else:
            self.children(cursor, constant)

    def children(self, cursor, constant):
        for child in cursor.get_children():
            self.visit(child, constant)

    def function_decl(self, cursor, _):
        for child in cursor.get_children():
            if child.kind == Kind.COMPOUND_STMT:
                self.functions.append(self.span(child)[0] + 1)
                self.visit(child, False)

    def var_decl(self, cursor, constant):
        is_static = constant or cursor.storage_class == cindex.StorageClass.STATIC
        _, name = _file_location(cursor.location)
        name_end = name + len(cursor.spelling)
        bracket = re.match(r"(\s*\[[^\]]*\])*", self.text[name_end:]).end()
        for child in cursor.get_children():
            span = self.span(child)
            is_size = span and name_end <= span[0] < name_end + bracket
            if not is_static and not is_size:
                self.negation(child)
            self.visit(child, is_static or is_size)

    # --- Statements ----------------------------------------------------------

    def statement(self, cursor, constant):
        """One that may stand alone."""
        inside, span = _unwrapped(cursor), self.span(cursor)
        acts = inside.kind in (Kind.CALL_EXPR, Kind.COMPOUND_ASSIGNMENT_OPERATOR,
                               Kind.UNARY_OPERATOR)
        if inside.kind == Kind.BINARY_OPERATOR:
            acts = self.operator(list(inside.get_children())) == "="
        if acts and span:
            self.add(span, [span], "(void)({0})", ["(void)0"], "text")
        self.visit(cursor, constant)

    def compound_stmt(self, cursor, constant):
        for child in cursor.get_children():
            self.statement(child, constant)

    def if_stmt(self, cursor, constant):
        condition, *bodies = cursor.get_children()
        span = self.span(condition)
        if span and len(bodies) == 1:
            self.add(span, [span], "{0} != 0", ["{0} && 0"], "value")
        for body in bodies:
            where = self.span(body)
            if where and len(bodies) == 2 and body.kind == Kind.COMPOUND_STMT:
                self.add(where, [where], "{0}", ["{{}}"], "block")
        self.visit(condition, constant)
        for body in bodies:
            self.statement(body, constant)

    def while_stmt(self, cursor, constant):
        condition, body = cursor.get_children()
        self.visit(condition, constant)
        self.statement(body, constant)

    def for_stmt(self, cursor, constant):
        *head, body = cursor.get_children()
        for child in head:
            self.visit(child, constant)
        self.statement(body, constant)

    def case_stmt(self, cursor, constant):
        label, body = cursor.get_children()
        self.visit(label, True)
        self.statement(body, constant)

    def return_stmt(self, cursor, constant):
        for child in cursor.get_children():
            self.negation(child)
            self.visit(child, constant)

    # --- Expressions ---------------------------------------------------------

    def operator(self, sides):
        """What is written between two operands, and nothing else."""
        spans = [self.span(side) for side in sides]
        if len(spans) != 2 or None in spans:
            return None
        between = self.text[spans[0][1]:spans[1][0]]
        return re.sub(r"/\*.*?\*/|//.*", "", between).strip()

    def negation(self, cursor):
        """A minus before a floating value."""
        span, inside = self.span(cursor), _unwrapped(cursor)
        plain = inside.kind not in (Kind.INIT_LIST_EXPR, Kind.FLOATING_LITERAL,
                                    Kind.INTEGER_LITERAL)
        if span and plain and cursor.kind.is_expression() \
                and _is_floating(cursor.type) \
                and not re.match(r"-|.*\bNAN$", self.text[slice(*span)]):
            self.add(span, [span], "{0}", ["-{0}"], "value")

    def binary_operator(self, cursor, constant):
        sides = list(cursor.get_children())
        operator = self.operator(sides)
        if operator == "=":
            self.negation(sides[1])
        others = OTHERS.get(operator, [])
        pointers = sum(map(_is_pointer, sides))
        if pointers and operator in ARITHMETIC:
            others = ["+", "-"] if pointers == 1 and _is_pointer(sides[0]) else []
            others = [o for o in others if o != operator]
        span = self.span(cursor)
        if others and span:
            how = "own" if constant else \
                "logic" if operator in ("&&", "||") else "value"
            self.add(span, map(self.span, sides), f"{{0}} {operator} {{1}}",
                     [f"{{0}} {o} {{1}}" for o in others], how)
        self.children(cursor, constant)

    def compound_assignment_operator(self, cursor, constant):
        sides = list(cursor.get_children())
        operator, span = self.operator(sides), self.span(cursor)
        others = OTHERS.get(operator[:-1], []) if operator else []
        if _is_pointer(sides[0]):
            others = [o for o in others if o in "+-"]
        if span:
            self.add(span, map(self.span, sides), f"{{0}} {operator} {{1}}",
                     [f"{{0}} {o}= {{1}}" for o in others], "text")
        self.children(cursor, constant)

    def unary_operator(self, cursor, constant):
        span, (inside,) = self.span(cursor), cursor.get_children()
        hole = self.span(inside)
        if span and hole:
            text = self.text
            before = text[span[0]:hole[0]].strip()
            after = text[hole[1]:span[1]].strip()
            turned = {"++": "--", "--": "++"}
            if before in turned:
                self.add(span, [hole], before + "{0}", [turned[before] + "{0}"],
                         "text")
            elif after in turned:
                self.add(span, [hole], "{0}" + after, ["{0}" + turned[after]],
                         "text")
            elif before in ("-", "~", "!"):
                others = ["{0}" if before != "!" else "!!{0}"]
                self.add(span, [hole], before + "{0}", others,
                         "own" if constant else "value")
        self.children(cursor, constant)

    def number(self, span, constant):
        text = self.text[slice(*span)]
        if not NUMBER.match(text):
            return  # a macro's
        digits = re.sub(r"(?i)^u?int\d+_c\((.*)\)$", r"\1", text).rstrip("uUlL")
        try:
            value = int(digits, 0)
            others = [f"({text} - 1)", f"({text} + 1)"] if value else ["1"]
            if digits == text and digits.isdecimal() and value:
                others = [str(value - 1), str(value + 1)]
        except ValueError:
            is_zero = float.fromhex(digits) == 0 if "x" in digits.lower() \
                else float(digits) == 0
            others = ["1.0"] if is_zero else [f"(2 * {text})", f"({text} / 2)"]
        self.add(span, [], text, others, "own" if constant else "text")

    def integer_literal(self, cursor, constant):
        span = self.span(cursor)
        if span:
            self.number(span, constant)

    floating_literal = integer_literal
