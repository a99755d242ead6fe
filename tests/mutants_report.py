# SPDX-License-Identifier: MIT
"""What became of the mutants, and those that are known to make no difference.

tests/mutants.txt has paragraphs:

    FILE: the line as it is written
        what is there -> what stood there instead     one or more
        Why no test can, or need, tell them apart.

A paragraph that matches nothing is a fault: its line has changed, or a test has come
that kills it.  The report has its survivors in the same form.
"""


KINDS = {"mutants": "mutants", "killed": "killed", "same": "same code",
         "uncompilable": "no code", "listed": "listed", "alive": "alive",
         "untried": "untried"}
ENOUGH = 97  # percent


def _words(text):
    return " ".join(text.split())


class Report:
    def __init__(self, path):
        self.entries = {}  # (file, line, change) -> is it needed
        self.counts, self.survivors = [], []
        paragraphs = path.read_text(encoding="utf-8").split("\n\n") \
            if path.exists() else []
        for paragraph in paragraphs:
            lines = [line for line in paragraph.splitlines()
                     if line and not line.startswith("#")]
            if not lines:
                continue
            file, _, written = lines[0].partition(": ")
            for line in lines[1:]:
                if " -> " in line:
                    self.entries[file, _words(written), _words(line)] = False
        self.files = set()

    def add(self, campaign):
        counts = dict.fromkeys(KINDS, 0)
        lines = campaign.text.splitlines()
        self.files.add(campaign.name)
        for mutant in sorted(campaign.mutants, key=lambda m: m.line):
            counts["mutants"] += 1
            what = (campaign.known(mutant) or "untried").split()[0]
            what = "untried" if what == "standing" else what
            entry = (campaign.name, _words(lines[mutant.line - 1]),
                     _words(f"{mutant.was} -> {mutant.now}"))
            if what == "alive" and entry in self.entries:
                self.entries[entry] = True
                what = "listed"
            counts[what] += 1
            if what in ("alive", "untried"):
                self.survivors.append((campaign.name, mutant.line, entry, what))
        self.counts.append((campaign.name, counts))

    def faults(self):
        return [" | ".join(entry) for entry, needed in self.entries.items()
                if not needed and entry[0] in self.files]

    def status(self):
        return 1 if self.faults() or self.score() < ENOUGH else 0

    def total(self):
        return {kind: sum(counts[kind] for _, counts in self.counts) for kind in KINDS}

    def score(self):
        """The share that is killed, of those that can be, in percent."""
        total = self.total()
        there = total["killed"] + total["alive"]
        return 100 * total["killed"] / there if there else 100

    def table(self):
        """And the score."""
        rows = [(name, *counts.values()) for name, counts in self.counts]
        rows.append(("all", *self.total().values()))
        lines = [("", *KINDS.values()), *rows]
        page = "".join(f"{line[0]:<32}" + "".join(f"{c:>10}" for c in line[1:])
                       + "\n" for line in lines)
        return page + f"\n{self.score():.1f} % killed of those that make a difference; " \
                      f"{ENOUGH} are asked for\n"

    def page(self):
        page = self.table()
        at = None
        for name, line, (_, written, change), what in self.survivors:
            if at != (name, line):
                page += f"\n# line {line}\n{name}: {written}\n"
                at = name, line
            page += f"    {change}{'  # untried' if what == 'untried' else ''}\n"
        for fault in self.faults():
            page += f"\n# tests/mutants.txt matches no survivor: {fault}\n"
        return page
