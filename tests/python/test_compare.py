# SPDX-License-Identifier: BSD-3-Clause
import json
import sqlite3

import compare
import pytest

# The columns that comparisons need; `narrows bench` makes more (docs/database.md).
TABLES = """
CREATE TABLE instances (experimentid INTEGER, options TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, uses_model INTEGER,
  prescribed INTEGER, solved INTEGER, cpu_time REAL);
"""
PLANNERS = {"hppm": 1, "slice": 2, "rrt": 3, "prm": 4}


@pytest.fixture
def database(tmp_path):
    """\\return makes a file from rows (group, planner, CPU seconds or None if not solved)"""

    def write(rows):
        file = tmp_path / "results.db"
        connection = sqlite3.connect(file)
        connection.executescript(TABLES)
        groups = list(dict.fromkeys(group for group, _, _ in rows))
        for number, group in enumerate(groups):
            connection.execute("INSERT INTO instances VALUES (?, ?)", (number, json.dumps({"group": group})))
        connection.executemany("INSERT INTO plannerConfigs VALUES (?, ?)", [(i, name) for name, i in PLANNERS.items()])
        for group, planner, cpu in rows:
            run = (groups.index(group), PLANNERS[planner], planner in ("hppm", "slice"), planner == "slice", cpu is not None, cpu)
            connection.execute("INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?, ?)", run)
        connection.commit()
        connection.close()
        return str(file)

    return write


def printed(path, capsys):
    assert compare.main([path]) == 0
    return capsys.readouterr().out.splitlines()


def test_the_rival_is_who_solves_most_then_who_is_fastest(database, capsys):
    rows = [("wide", "hppm", t) for t in (0.001, 0.002, 0.004)]
    rows += [("wide", "rrt", t) for t in (0.0001, 0.0001, None)] + [("wide", "prm", t) for t in (0.008, 0.009, 0.007)]
    assert printed(database(rows), capsys)[2:] == ["| wide | 2, 4x | 8 prm |"]


def test_unsolved_runs_are_counted_and_recipes_are_marked(database, capsys):
    rows = [("a", "hppm", 0.002), ("a", "hppm", None), ("a", "slice", 0.0005), ("a", "rrt", None)]
    rows += [("b", "hppm", None), ("b", "rrt", 0.001)]
    assert printed(database(rows), capsys) == [
        "| scenario | hppm | slice \\* | best sampling planner |",
        "|---|---:|---:|---:|",
        "| a | 2 (1/2) | 0.5 | none in 1 |",
        "| b | none in 1 |  | 1 rrt |",
    ]
