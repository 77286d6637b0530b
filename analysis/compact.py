#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A campaign's database made small enough to keep beside the code: all rows, the paths of one scene per group.

  compact.py RESULTS.db SMALL.db

Every number about runs stays what it was. Paths of other scenes are dropped: nothing is left to recheck or to show there,
and path quality is computed from fewer. Runs can be done again one by one (`narrows replay`).
"""

import argparse
import sqlite3
import sys
from contextlib import closing
from pathlib import Path

KEPT = """
SELECT min(instances.experimentid) FROM instances JOIN experiments ON experiments.id = instances.experimentid
GROUP BY coalesce(json_extract(options, '$.group'), experiments.name)
"""


def compact(source, target):
    """\\return how many paths were kept, and how many there were
    \\throws ValueError if the target exists or the source is no database of ours"""
    if Path(target).exists():
        raise ValueError(f"{target}: exists already; nothing was overwritten")
    try:
        with closing(sqlite3.connect(f"file:{source}?mode=ro", uri=True)) as database:
            total = database.execute("SELECT count(*) FROM paths").fetchone()[0]
            database.execute("VACUUM INTO ?", (str(target),))
        with closing(sqlite3.connect(target, isolation_level=None)) as database:
            database.execute("PRAGMA journal_mode = DELETE")
            database.execute(
                f"DELETE FROM paths WHERE runid NOT IN (SELECT id FROM runs WHERE experimentid IN ({KEPT}))"
            )
            database.execute("VACUUM")
            return database.execute("SELECT count(*) FROM paths").fetchone()[0], total
    except sqlite3.Error as error:
        raise ValueError(f"{source}: {error}") from error


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    options = parser.parse_args(arguments)
    try:
        kept, total = compact(options.source, options.target)
    except ValueError as error:
        print(error, file=sys.stderr)
        return 1
    print(f"{options.target}: {kept} of {total} paths, {Path(options.target).stat().st_size / 1e6:.1f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main())
