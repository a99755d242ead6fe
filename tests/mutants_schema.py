# SPDX-License-Identifier: MIT
"""All mutants of a file in one text, and each of them by itself.

In the one text, what a site evaluates to is chosen by a global integer:

    a < b    ({ __auto_type v1 = (a); __auto_type v2 = (b);
                brink_mutant == 17 ? v1 <= v2 : brink_mutant == 18 ? ... : v1 < v2; })

so that a file is compiled once for all its mutants.  No line moves.
"""
import collections
import dataclasses
import re

from mutants_find import Site


@dataclasses.dataclass(frozen=True)
class Mutant:
    number: int  # from 1, in its file
    site: Site
    other: str
    line: int    # where it stands
    was: str     # what is written there, in one line
    now: str

    @property
    def key(self):
        return f"{self.site.start}-{self.site.end} {self.now}"


def _flat(text):
    """In one line."""
    return re.sub(r"//.*", "", text).replace("\n", " ")


def _one_line(text):
    return re.sub(r"\s+", " ", _flat(text)).strip()


def _shown(form, holes):
    """As the report has it, for people."""
    if form == "(void)0":
        return "nothing"
    form = {"(void)({0})": "{0}", "{0} != 0": "if ({0})",
            "{0} && 0": "if ({0} && 0)"}.get(form, form)
    return form.format(*holes)


def mutants_of(text, sites):
    found, seen = [], collections.Counter()
    for site in sites:
        holes = [_one_line(text[slice(*hole)]) for hole in site.holes]
        line = text.count("\n", 0, site.start) + 1
        was = _shown(site.form, holes)
        for other in site.others:
            now = _shown(other, holes)
            seen[line, was, now] += 1
            if seen[line, was, now] > 1:
                now += f" ({seen[line, was, now]})"  # the line has it again
            found.append(Mutant(len(found) + 1, site, other, line, was, now))
    return found


def alone(text, mutant):
    """The file with this one mutant, as if somebody had written it."""
    site = mutant.site
    holes = ["(" + text[slice(*hole)] + ")" for hole in site.holes]
    new = mutant.other.format(*holes)
    if site.how != "block":
        new = "(" + new + ")" if site.holes or site.how != "own" else new
    # no line moves
    new += "\n" * (text[site.start:site.end].count("\n") - new.count("\n"))
    return text[:site.start] + new + text[site.end:]


def _chosen(mutants, site, holes):
    chain = "".join(f"brink_mutant == {m.number} ? ({m.other.format(*holes)}) : "
                    for m in mutants)
    return f"{chain}({site.form.format(*holes)})"


def _written(mutants, site, holes):
    """A site whose holes have been written."""
    first = mutants[0].number
    if site.how == "text":
        return f"({_chosen(mutants, site, holes)})"
    if site.how == "block":
        return f"{{ if (brink_mutant != {first}) {holes[0]} }}"
    names = [f"brink_v{first}_{k}" for k in range(len(holes))]
    if site.how == "logic":  # whether the first operand leaves it to the second
        leaves = "!=" if "&&" in site.form else "=="
        return (f"({{ int {names[0]} = ({holes[0]}) != 0; "
                f"({names[0]} {leaves} (brink_mutant == {first})) ? "
                f"({holes[1]}) != 0 : {names[0]}; }})")
    values = "".join(f"__auto_type {name} = ({hole}); "
                     for name, hole in zip(names, holes))
    return f"({{ {values}{_chosen(mutants, site, names)}; }})"


def schema(text, mutants, functions):
    """The file with all mutants to choose from, and its functions saying that
    they have been reached."""
    of_site = {}
    for mutant in mutants:
        of_site.setdefault(mutant.site, []).append(mutant)
    order = {site: k for k, site in enumerate(of_site)}  # outer ones are first
    sites = sorted(of_site, key=lambda s: (s.start, -s.end, order[s]))
    marks = {at: f" brink_reached[{k}] = 1; " for k, at in enumerate(functions)}

    def plain(start, end):
        out, at = "", start
        for mark in sorted(m for m in marks if start <= m < end):
            out, at = out + text[at:mark] + marks[mark], mark
        return out + text[at:end]

    def write(start, end, inside):
        out, at, rest = "", start, list(inside)
        while rest:
            site = rest.pop(0)
            if not (at <= site.start and site.end <= end):
                raise SystemExit(f"mutants: sites overlap at {site}")
            within = [s for s in rest if s.end <= site.end]
            rest = rest[len(within):]
            holes = [_flat(write(*hole, [s for s in within if hole[0] <= s.start
                                         and s.end <= hole[1]]))
                     for hole in site.holes]
            new = _written(of_site[site], site, holes)
            lines = text.count("\n", site.start, site.end) - new.count("\n")
            out += plain(at, site.start) + new + "\n" * lines
            at = site.end
        return out + plain(at, end)

    declared = "extern int brink_mutant; extern unsigned char *brink_reached; "
    return declared + write(0, len(text), sites)
