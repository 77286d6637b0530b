#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One campaign by both engines, side by side (Markdown): medians over the runs of an instance and planner.

  engines.py ISOLATED.db OMPL.db

Times in ms, memory in MB. "memory" is what each engine says a run took: the run's own growth when it is isolated, the
size of the whole process in OMPL's benchmark (from its logs beside the database).
"""

import argparse
import pathlib
import sqlite3
import sys
from contextlib import closing
from statistics import median

RUNS = """
SELECT experiments.name, plannerConfigs.name, solved, time, cpu_time, state_checks, memory
FROM runs JOIN experiments ON experiments.id = experimentid JOIN plannerConfigs ON plannerConfigs.id = plannerid
"""


def read(database):
    """By instance and label: lists of the columns' values."""
    cells = {}
    with closing(sqlite3.connect(f"file:{database}?mode=ro", uri=True)) as connection:
        for instance, label, *values in connection.execute(RUNS):
            lists = cells.setdefault((instance, label), ([], [], [], [], []))
            for numbers, value in zip(lists, values):
                if value is not None:
                    numbers.append(value)
    return cells


def log_memory(database):
    """By instance and label: the memory column of OMPL's logs."""
    cells = {}
    database = pathlib.Path(database)
    for log in sorted(database.parent.glob(database.stem + "_*.log")):
        lines = iter(log.read_text(errors="replace").splitlines())
        instance = label = column = None
        for line in lines:
            if line.startswith("Experiment "):
                instance = line.split()[-1]
            elif line.endswith(" properties for each run") and " progress " not in line:
                names = [next(lines) for _ in range(int(line.split()[0]))]
                column = names.index("memory REAL")
            elif line.endswith(" runs") and column is not None:
                rows = [next(lines).split("; ") for _ in range(int(line.split()[0]))]
                cells[(instance, label)] = [float(row[column]) for row in rows]
                column = None
            elif line.endswith(" common properties"):
                # OMPL's class names; its batch planners call themselves after their way to find neighbours.
                label = previous.removeprefix("geometric_").lower().replace("kbitstar", "bitstar")
            previous = line
    return cells


def text(numbers, scale=1.0):
    return f"{scale * median(numbers):.3g}" if numbers else ""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("isolated")
    parser.add_argument("ompl")
    options = parser.parse_args()
    isolated, ompl = read(options.isolated), read(options.ompl)
    memory = log_memory(options.ompl)
    print("| instance | planner | solved | | time | | CPU time | | state checks | | memory | |")
    print("|" + "---|" * 12)
    print("| | |" + " isolated | ompl |" * 5)
    for key in sorted(isolated.keys() & ompl.keys()):
        ours, theirs = isolated[key], ompl[key]
        row = [f"{sum(ours[0])}/{len(ours[0])}", f"{sum(theirs[0])}/{len(theirs[0])}"]
        for column, scale in ((1, 1e3), (2, 1e3), (3, 1.0)):
            row += [text(ours[column], scale), text(theirs[column], scale)]
        row += [text(ours[4]), text(memory.get(key, []))]
        print("| " + " | ".join([*key, *row]) + " |")
    return 0


if __name__ == "__main__":
    sys.exit(main())
