# SPDX-License-Identifier: BSD-3-Clause
"""The rows of a campaign's database, as reports read them (docs/database.md)."""

import hashlib
import json
import sqlite3
from contextlib import closing
from dataclasses import dataclass

import pandas

RUNS = """
SELECT runs.id AS id, runs.experimentid AS experiment, experiments.name AS instance, experiments.checker AS checker,
       experiments.timelimit AS limit_s,
       coalesce(json_extract(instances.options, '$.group'), experiments.name) AS grp, plannerConfigs.name AS label,
       plannerConfigs.settings AS settings, runs.run AS run, runs.seed AS seed, runs.outcome AS outcome,
       coalesce(runs.reason, '') AS reason, runs.solved AS solved, runs.uses_model AS ours,
       runs.prescribed AS prescribed, runs.cpu_time AS cpu, runs.evaluations AS evaluations,
       runs.state_checks AS checks, runs.solution_length AS length, runs.solution_clearance AS clearance,
       runs.peak_memory_kb AS memory, runs.solution_smoothness AS smoothness, runs.max_joint_step AS joint_step
FROM runs JOIN experiments ON experiments.id = runs.experimentid JOIN instances USING (experimentid)
     JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid
ORDER BY runs.experimentid, plannerConfigs.id, runs.run
"""

UNTOUCHED = "SELECT count(*) FROM experiments WHERE id NOT IN (SELECT experimentid FROM runs)"


@dataclass
class Campaign:
    """All that a report says about one database.

    `runs` has a row per run: id, experiment, instance, checker, limit_s, group, planner, settings, run, seed, outcome,
    reason, solved, ours, prescribed, cpu (seconds), evaluations, checks, length, clearance, smoothness, joint_step,
    memory (KB). What was not measured is NaN. `planner` is `label`; " *" at its end marks runs with the recipe that the scenario prescribes. `group`
    is `full_group` without the checker's name, if there is one checker.
    `score` is what planners are ranked by: CPU seconds to a verified path, infinite without one.
    """

    name: str
    seed: int
    engine: str
    sessions: list  # one dictionary per session of `narrows bench`
    runs: pandas.DataFrame
    hypotheses: list  # as they were declared before the first run, one dictionary each
    untouched: int  # instances that no run was done on yet: the campaign is not complete
    canaries: pandas.DataFrame  # session, cpu (seconds), checks: the same run again and again, in order


def open_database(path):
    """For reading only; a file that is not there is an error and not a new database."""
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    database.row_factory = sqlite3.Row
    return database


def read_campaign(path):
    """\\throws ValueError if the file is no campaign's database, or has no runs"""
    try:
        with closing(open_database(path)) as database:
            campaign = database.execute("SELECT name, seed, engine FROM campaign").fetchone()
            sessions = [dict(row) for row in database.execute("SELECT * FROM environments ORDER BY id")]
            rows = [dict(row) for row in database.execute(RUNS)]
            hypotheses = read_hypotheses(database, sessions)
            canaries = read_canaries(database)
            untouched = database.execute(UNTOUCHED).fetchone()[0]
    except sqlite3.Error as error:
        raise ValueError(f"{path}: not a database of `narrows bench` ({error})") from error
    if campaign is None or not rows:
        raise ValueError(f"{path}: the campaign has no runs yet")
    return Campaign(campaign["name"], campaign["seed"], campaign["engine"], sessions, frame_of(rows), hypotheses, untouched, canaries)


def has_table(database, name):
    return database.execute("SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?", (name,)).fetchone() is not None


def read_hypotheses(database, sessions):
    """\throws ValueError if one is not what it was when it was declared, or was declared after the first session"""
    if not has_table(database, "hypotheses"):
        return []
    hypotheses = []
    for row in database.execute("SELECT name, definition, sha256, declared FROM hypotheses ORDER BY rowid"):
        if hashlib.sha256(row["definition"].encode()).hexdigest() != row["sha256"]:
            raise ValueError(f"hypothesis {row['name']}: it is not the one that its SHA-256 was taken of")
        if sessions and row["declared"] > sessions[0]["date"]:
            raise ValueError(f"hypothesis {row['name']}: it was declared after the first session of runs")
        hypotheses.append({"against": [], **json.loads(row["definition"])})
    return hypotheses


def read_canaries(database):
    rows = []
    if has_table(database, "canaries"):
        query = "SELECT environmentid, cpu_time, state_checks FROM canaries WHERE outcome = 'solved' ORDER BY id"
        rows = [tuple(row) for row in database.execute(query)]
    return pandas.DataFrame(rows, columns=["session", "cpu", "checks"])


def frame_of(rows):
    runs = pandas.DataFrame(rows).rename(columns={"grp": "group"})
    for flag in ("solved", "ours", "prescribed"):
        runs[flag] = runs[flag].fillna(0).astype(bool)
    for number in ("cpu", "evaluations", "checks", "length", "clearance", "memory", "smoothness", "joint_step", "limit_s"):
        runs[number] = pandas.to_numeric(runs[number])
    runs["planner"] = runs["label"] + runs["prescribed"].map({True: " *", False: ""})
    runs["full_group"] = runs["group"]
    if runs["checker"].nunique() == 1:  # then it goes without saying
        runs["group"] = runs["group"].str.removesuffix("_" + runs["checker"].iloc[0])
    runs["score"] = runs["cpu"].where(runs["solved"], float("inf"))
    return runs


def scenario_texts(path, experiments):
    """\\return the scenario file and the options of each experiment, by its id"""
    with closing(open_database(path)) as database:
        marks = ", ".join("?" * len(experiments))
        query = f"SELECT experimentid, scenario, options FROM instances WHERE experimentid IN ({marks})"
        return {
            row["experimentid"]: (row["scenario"], json.loads(row["options"]))
            for row in database.execute(query, experiments)
        }
