# SPDX-License-Identifier: BSD-3-Clause
"""A committed database as Planner Arena reads it, and broken copies of it."""

import shutil
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from planner_arena import Arena

DATABASE = Path(__file__).resolve().parents[2] / "docs" / "results" / "study.db"


@pytest.fixture(name="arena", scope="module")
def arena_of_the_study():
    return Arena(DATABASE)


def value(query):
    with closing(sqlite3.connect(DATABASE)) as database:
        return database.execute(query).fetchone()[0]


def test_every_run_is_shown_once(arena):
    assert len(arena.extended) == value("SELECT count(*) FROM runs") > 10000
    assert arena.extended["experiment"].nunique() == value("SELECT count(*) FROM experiments")
    assert arena.extended["planner"].nunique() == value("SELECT count(*) FROM plannerConfigs")
    assert arena.parameters == ["scenario", "checker", "motion"]


def test_all_numbers_of_runs_can_be_plotted(arena):
    left_out = set(arena.attributes) - set(arena.plotted)
    texts = {"outcome", "reason", "cpus", "parameters", "measures", "recipe", "output"}
    empty = {name for name in arena.attributes if name in arena.extended and arena.extended[name].isna().all()}
    assert left_out - empty == {"seed", *texts} - empty  # `experiments` has a seed too, and the join renames both
    assert {"time", "memory", "status", "solved", "cpu_time", "solution_length", "evaluations"} <= set(arena.plotted)


def test_boxes_hold_what_the_database_has(arena):
    name = value("SELECT name FROM experiments ORDER BY id LIMIT 1")
    time = value(
        "SELECT time FROM runs WHERE plannerid = (SELECT id FROM plannerConfigs WHERE name = 'hppm') "
        f"AND experimentid = (SELECT id FROM experiments WHERE name = '{name}')"
    )
    assert arena.values(name, "hppm", "time") == [time]


@pytest.mark.parametrize(
    "change, reason",
    [
        ("DROP TABLE progress", "progress"),
        ("ALTER TABLE experiments RENAME COLUMN setup TO arrangement", "experiments: begins with"),
        ("ALTER TABLE runs RENAME COLUMN time TO wall_time", "no time"),
        ("DELETE FROM plannerConfigs WHERE name = 'hppm'", "of no planner"),
        ("DELETE FROM enums WHERE value = 4", "status"),
        ("UPDATE experiments SET name = 'two words' WHERE id = 1", "one word"),
        ("UPDATE experiments SET version = 'OMPL unknown' WHERE id = 1", "version"),
    ],
)
def test_what_it_would_stumble_over_is_named(tmp_path, change, reason):
    copy = tmp_path / "broken.db"
    shutil.copy(DATABASE, copy)
    with closing(sqlite3.connect(copy, isolation_level=None)) as database:
        database.execute("PRAGMA foreign_keys = OFF")
        for view in ("bestPlannerConfigsPerExperiment", "bestPlannerConfigs"):
            database.execute(f"DROP VIEW {view}")
        database.execute(change)
    with pytest.raises(ValueError, match=reason):
        Arena(copy)
