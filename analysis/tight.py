#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The longest links that were certified, by scene and method (Markdown), as docs/tight.md shows them.

  tight.py INDEX.db ...       tables of experiments/tight_index.cfg and tight_index_space.cfg
  tight.py --random RANDOM.db solved scenes by index, and why the others were not

Lengths are those of the sweep, with the share of the longest link that geometry allows, where that is known. A length
counts if the independent verifier accepts the whole motion. A star marks scenes in which a shorter length of the sweep
was not solved.
"""

import argparse
import re
import sqlite3
import sys
from collections import Counter, defaultdict
from contextlib import closing

# The longest link that geometry allows, and how that is known (docs/tight.md).
LONGEST = {
    "L": (541.5, "exact"),
    "U40": (430.0, "exact"),
    "S3": (430.0, "exact"),
    "Z300": (508.0, "excluded from here on"),
    "Z600": (439.0, "excluded from here on"),
    "trap22": (818.75, "excluded from here on"),
    "corner200x115": (415.6, "exact"),
    "bends": (103.48, "of a flat bend"),
}

RUNS = """
SELECT runs.experimentid, json_extract(instances.options, '$.group') AS grp, plannerConfigs.name, runs.solved,
       runs.reason, runs.outcome, runs.cpu_time
FROM runs JOIN instances USING (experimentid) JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid
ORDER BY runs.experimentid, runs.id
"""


def read(paths):
    for path in paths:
        with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as database:
            yield from database.execute(RUNS)


def split(group):
    """Scene and link length of a group's name, such as ladder_shapeL_length540_analytic."""
    length = re.search(r"_length([0-9.]+)", group)
    shape = re.search(r"_shape([^_]+)", group)
    if length is None:
        raise ValueError(f"{group}: no link length in it; this table is for tight_index*.cfg")
    return (shape or re.match(r"([a-z]+)", group)).group(1), float(length.group(1))


def longest(rows):
    """Lengths and whether they were solved, by scene and method."""
    runs = defaultdict(lambda: defaultdict(dict))
    for _, group, method, solved, *_ in rows:
        scene, length = split(group)
        runs[scene][method][length] = bool(solved)
    return runs


def cell(lengths, limit):
    best = max((length for length, solved in lengths.items() if solved), default=None)
    if best is None:
        return "none"
    gaps = any(not solved for length, solved in lengths.items() if length < best)
    index = "" if limit is None else f" ({best / limit:.3f})"
    return f"{best:g}{index}" + ("\\*" if gaps else "")


def index_table(rows):
    runs = longest(rows)
    methods = sorted({method for scene in runs.values() for method in scene})
    yield "| scene | " + " | ".join(methods) + " | longest |"
    yield "|---|" + "---:|" * len(methods) + "---|"
    for scene, entries in runs.items():
        limit, known = LONGEST.get(scene, (None, "not known"))
        cells = [cell(entries[method], limit) if method in entries else "" for method in methods]
        yield f"| {scene} | " + " | ".join(cells) + f" | {'' if limit is None else f'{limit:g}, '}{known} |"


def random_table(rows):
    groups = defaultdict(lambda: (Counter(), []))
    for _, group, method, solved, reason, outcome, cpu in rows:
        outcomes, times = groups[group, method]
        outcomes["solved" if solved else reason or outcome] += 1
        if solved:
            times.append(cpu)
    yield "| scenes | method | solved | median s | the others |"
    yield "|---|---|---:|---:|---|"
    for (group, method), (outcomes, times) in groups.items():
        total, solved = sum(outcomes.values()), outcomes.pop("solved", 0)
        middle = f"{sorted(times)[len(times) // 2]:.2g}" if times else ""
        others = ", ".join(f"{name} {count}" for name, count in outcomes.most_common())
        yield f"| {group} | {method} | {solved} of {total} | {middle} | {others} |"


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("databases", nargs="+")
    parser.add_argument("--random", action="store_true")
    options = parser.parse_args(arguments)
    rows = read(options.databases)
    try:
        for line in random_table(rows) if options.random else index_table(rows):
            print(line)
    except (sqlite3.Error, ValueError) as error:
        sys.exit(f"tight.py: {error}")


if __name__ == "__main__":
    main()
