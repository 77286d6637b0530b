# SPDX-License-Identifier: BSD-3-Clause
import json
import sqlite3

import durations
import pytest

# The columns that durations need; `narrows bench` makes more (docs/database.md).
TABLES = """
CREATE TABLE instances (experimentid INTEGER, options TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, solved INTEGER, duration REAL,
  stop_duration REAL);
"""


@pytest.fixture
def database(tmp_path):
    """\\return makes a file from rows (experiment, planner, duration and with stops, or None if not solved)"""

    def write(rows):
        file = tmp_path / "results.db"
        connection = sqlite3.connect(file)
        connection.executescript(TABLES)
        for number in {row[0] for row in rows}:
            connection.execute("INSERT INTO instances VALUES (?, ?)", (number, json.dumps({"group": f"scene{number}"})))
        connection.executemany("INSERT INTO plannerConfigs VALUES (?, ?)", [(1, "viapoint"), (2, "rrtconnect")])
        for experiment, planner, duration, stops in rows:
            run = (experiment, planner, duration is not None, duration, stops)
            connection.execute("INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, ?)", run)
        connection.commit()
        connection.close()
        return str(file)

    return write


def test_medians_of_solved_runs(database, capsys):
    rows = [(1, 1, 4.0, 5.0), (1, 1, 1.0, 9.0), (1, 1, 2.0, 6.0), (1, 2, 3.0, 4.0), (1, 2, None, None), (2, 1, None, None)]
    assert durations.main([database(rows)]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "| scenario | viapoint | rrtconnect |",
        "|---|---:|---:|",
        "| scene1 | 2.00, 6.00 | 3.00, 4.00 (1/2) |",
        "| scene2 | none in 1 |  |",
    ]


def test_without_limits_there_is_nothing_to_say(database, capsys):
    assert durations.main([database([(1, 1, None, None)])]) == 1
    assert "no limits" in capsys.readouterr().err
