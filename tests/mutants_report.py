# SPDX-License-Identifier: MIT
"""What became of the mutants, and those that are known to make no difference.

tests/mutants.txt has paragraphs:

    FILE: the line as it is written
        what is there -> what stood there instead     one or more
        Why no test can, or need, tell them apart.

A paragraph that matches nothing is a fault: its line has changed.
"""


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
        counts = dict.fromkeys(("mutants", "killed", "same", "uncompilable",
                                "listed", "alive", "untried"), 0)
        lines = campaign.text.splitlines()
        self.files.add(campaign.name)
        for mutant in campaign.mutants:
            counts["mutants"] += 1
            what = (campaign.known(mutant) or "untried").split()[0]
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
        return 1 if self.faults() else 0

    def page(self):
        names = ("mutants", "killed", "same", "uncompilable", "listed", "alive",
                 "untried")
        heads = ("mutants", "killed", "same code", "no code", "listed", "alive",
                 "untried")
        rows = [(name, *(c[n] for n in names)) for name, c in self.counts]
        total = [sum(row[k] for row in rows) for k in range(1, len(names) + 1)]
        rows.append(("all", *total))
        page = "".join(f"{cell:{'<32' if k == 0 else '>10'}}"
                       for k, cell in enumerate(("", *heads))) + "\n"
        for row in rows:
            page += f"{row[0]:<32}" + "".join(f"{n:>10}" for n in row[1:]) + "\n"
        for name, line, (_, written, change), what in self.survivors:
            page += f"\n{name}:{line}: {what}\n    {written}\n    {change}\n"
        for fault in self.faults():
            page += f"\ntests/mutants.txt matches no survivor: {fault}\n"
        count = dict(zip(names, total))
        base = count["mutants"] - count["same"] - count["uncompilable"]
        # one that is listed is neither alive nor killed
        base -= count["listed"]
        share = 100 * count["killed"] / base if base else 100
        plain = 100 * count["killed"] / (base + count["listed"]) \
            if base + count["listed"] else 100
        return page + (f"\nkilled: {share:.1f} % of those that make a difference, "
                       f"{plain:.1f} % with those listed\n")
