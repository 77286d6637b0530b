#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Planners that see the model beside the best of those that do not, as the tables of docs/ show them (Markdown).

  compare.py RESULTS.db

Medians of CPU milliseconds over solved runs; (k/n) where not all n runs were solved; "4x": the best sampling
planner takes four times as long. That is the entry that solves most of a group, then the fastest.
"""

import argparse
import sqlite3
import sys
from contextlib import closing
from dataclasses import dataclass
from statistics import median

RUNS = """
SELECT json_extract(instances.options, '$.group') AS grp, plannerConfigs.name AS label, runs.uses_model AS ours,
       runs.prescribed AS prescribed, runs.solved AS solved, runs.cpu_time AS cpu
FROM runs JOIN instances USING (experimentid) JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid
ORDER BY runs.experimentid, runs.id
"""


def brief(value):
    """Two digits that count, without an exponent."""
    return f"{float(f'{value:.2g}'):.12g}"


@dataclass
class Entry:
    label: str
    ours: bool
    times: list  # CPU seconds of the solved runs
    runs: int

    def rank(self):
        return (-len(self.times), median(self.times) if self.times else float("inf"))

    def text(self):
        if not self.times:
            return f"none in {self.runs}"
        share = "" if len(self.times) == self.runs else f" ({len(self.times)}/{self.runs})"
        return brief(1000.0 * median(self.times)) + share


def read(path):
    """\\return entries by label, by group"""
    groups = {}
    with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as database:
        for group, label, ours, prescribed, solved, cpu in database.execute(RUNS):
            name = label + (" \\*" if prescribed else "")
            entry = groups.setdefault(group, {}).setdefault(name, Entry(name, bool(ours), [], 0))
            entry.runs += 1
            if solved:
                entry.times.append(cpu)
    return groups


def lead(entry, rival):
    """How many times faster than the rival."""
    if rival is None or not rival.times or not entry.times:
        return ""
    return f", {brief(median(rival.times) / median(entry.times))}x"


def table(groups):
    ours = sorted({entry.label for entries in groups.values() for entry in entries.values() if entry.ours})
    yield "| scenario | " + " | ".join([*ours, "best sampling planner"]) + " |"
    yield "|---|" + "---:|" * (len(ours) + 1)
    for group, entries in groups.items():
        best = min((entry for entry in entries.values() if not entry.ours), key=Entry.rank, default=None)
        cells = [entries[label].text() + lead(entries[label], best) if label in entries else "" for label in ours]
        cells.append("" if best is None else best.text() + (f" {best.label}" if best.times else ""))
        yield f"| {group} | " + " | ".join(cells) + " |"


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    for line in table(read(parser.parse_args(arguments).database)):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
