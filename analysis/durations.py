#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""How fast planners' paths can be followed under equal limits (Markdown), from a database whose experiment has `limits`.

  durations.py RESULTS.db

Medians over solved runs, in seconds: duration, then with stops at all corners; (k/n) where not all n runs were solved.
"""

import argparse
import sqlite3
import sys
from contextlib import closing

import pandas as pd

RUNS = """
SELECT json_extract(instances.options, '$.group') AS scenario, plannerConfigs.name AS planner, runs.solved AS solved,
       runs.duration AS duration, runs.stop_duration AS stops
FROM runs JOIN instances USING (experimentid) JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid
ORDER BY runs.experimentid, runs.id
"""


def cell(runs):
    solved = runs[runs["solved"] == 1]
    if solved.empty:
        return f"none in {len(runs)}"
    share = "" if len(solved) == len(runs) else f" ({len(solved)}/{len(runs)})"
    return f"{solved['duration'].median():.2f}, {solved['stops'].median():.2f}{share}"


def table(rows):
    """\\return lines of Markdown: scenarios down, planners across"""
    planners = list(dict.fromkeys(rows["planner"]))
    lines = ["| scenario | " + " | ".join(planners) + " |", "|---|" + "---:|" * len(planners)]
    for scenario, runs in rows.groupby("scenario", sort=False):
        cells = [cell(runs[runs["planner"] == planner]) if planner in set(runs["planner"]) else "" for planner in planners]
        lines.append(f"| {scenario} | " + " | ".join(cells) + " |")
    return lines


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Durations under equal limits")
    parser.add_argument("database")
    given = parser.parse_args(arguments)
    with closing(sqlite3.connect(f"file:{given.database}?mode=ro", uri=True)) as database:
        rows = pd.read_sql_query(RUNS, database)
    if rows["duration"].isna().all():
        print("No durations: the experiment has no limits, or nothing was solved.", file=sys.stderr)
        return 1
    print("\n".join(table(rows)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
