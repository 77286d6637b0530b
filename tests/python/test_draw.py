# SPDX-License-Identifier: BSD-3-Clause
import json
import sqlite3

import draw
import pytest
from conftest import ROOT
from scene import read_scene

FILES = sorted((ROOT / "experiments" / "scenarios").glob("*.yaml"))
SCENARIOS = [file for file in FILES if "\ngenerate:" not in file.read_text()]  # the program writes out the others

# The columns that pictures need; `narrows bench` makes more (docs/database.md).
TABLES = """
CREATE TABLE experiments (id INTEGER PRIMARY KEY, name TEXT, scenario TEXT, checker TEXT);
CREATE TABLE instances (experimentid INTEGER, scenario TEXT, options TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, solved INTEGER, cpu_time REAL,
  solution_length REAL, prescribed INTEGER);
CREATE TABLE paths (runid INTEGER, angles TEXT);
"""


def panels_in(svg):
    return svg.count('<g id="axes_')


def some_path(scene, waypoints=4):
    return [[0.1 * i] * scene.arm.dimension for i in range(waypoints)]


@pytest.mark.parametrize("file", SCENARIOS, ids=lambda file: file.stem)
def test_every_scenario_is_drawn(file, tmp_path):
    path = some_path(read_scene(file.read_text(), file.parent))
    record = {"planner": "rrt", "outcome": "solved", "reason": "", "cpu_s": 0.0015, "path": {"angles": path}}
    (tmp_path / "record.json").write_text(json.dumps(record))
    draw.main(["run", str(file), str(tmp_path / "record.json"), str(tmp_path / "out.svg")])
    svg = (tmp_path / "out.svg").read_text()
    assert panels_in(svg) == 1
    assert "solved, CPU 1.5 ms" in svg


def test_a_run_without_a_path_is_drawn(tmp_path):
    record = {"planner": "rrt", "outcome": "crash", "reason": "SIGSEGV", "cpu_s": None, "path": None}
    (tmp_path / "record.json").write_text(json.dumps(record))
    draw.main(["run", str(SCENARIOS[0]), str(tmp_path / "record.json"), str(tmp_path / "out.svg")])
    svg = (tmp_path / "out.svg").read_text()
    assert "crash (SIGSEGV), CPU no time" in svg
    assert "no path" in svg


@pytest.fixture
def database(tmp_path):
    """Two scenarios; on the first, three planners: one solves twice, one once with a recipe, one never."""
    file = tmp_path / "results.db"
    connection = sqlite3.connect(file)
    connection.executescript(TABLES)
    first, second = (ROOT / "experiments" / "scenarios" / name for name in ("hppm_case1.yaml", "gripper_slide.yaml"))
    for number, (name, scenario) in enumerate([("first", first), ("second", second)], start=1):
        connection.execute("INSERT INTO experiments VALUES (?, ?, ?, 'analytic')", (number, name, name))
        options = json.dumps({"group": name})
        connection.execute("INSERT INTO instances VALUES (?, ?, ?)", (number, scenario.read_text(), options))
    connection.executemany("INSERT INTO plannerConfigs VALUES (?, ?)", enumerate(["twice", "recipe", "never"], start=1))
    runs = [
        (1, 1, 1, 1, 0.004, 9.0, 0),
        (2, 1, 1, 1, 0.002, 5.0, 0),
        (3, 1, 2, 1, 0.001, 4.0, 1),
        (4, 1, 3, 0, 0.5, None, 0),
        (5, 2, 1, 1, 0.003, 6.0, 0),
    ]
    connection.executemany("INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?, ?)", runs)
    paths = [(1, first, 3), (2, first, 5), (3, first, 4), (5, second, 4)]
    for run, scenario, waypoints in paths:
        path = some_path(read_scene(scenario.read_text()), waypoints)
        connection.execute("INSERT INTO paths VALUES (?, ?)", (run, json.dumps(path)))
    connection.commit()
    connection.close()
    return file


def test_a_campaign_has_one_picture_per_scenario_and_one_panel_per_planner(database, tmp_path):
    draw.main(["campaign", str(database), "-o", str(tmp_path / "pictures")])
    pictures = {file.name: file.read_text() for file in (tmp_path / "pictures").iterdir()}
    assert sorted(pictures) == ["first.svg", "second.svg"]
    first = pictures["first.svg"]
    assert panels_in(first) == 3
    assert panels_in(pictures["second.svg"]) == 1
    assert "2/2 solved, CPU median 3 ms" in first
    assert "0/1 solved" in first
    assert "<!-- recipe* -->" in first
    assert first.count("no verified path") == 1


def test_a_sweep_of_seeds_has_one_picture(database, tmp_path):
    connection = sqlite3.connect(database)
    connection.execute("UPDATE instances SET options = ?", (json.dumps({"group": "both"}),))
    connection.commit()
    connection.close()
    draw.main(["campaign", str(database), "-o", str(tmp_path / "pictures")])
    assert [file.name for file in (tmp_path / "pictures").iterdir()] == ["first.svg"]


def test_the_shortest_path_is_shown(database):
    connection = sqlite3.connect(database)
    connection.row_factory = sqlite3.Row
    runs = [run for run in connection.execute(draw.RUNS) if run["label"] == "twice" and run["scenario"] == "first"]
    assert len(draw.panel_of(connection, "twice", runs).path) == 5
    connection.close()


def test_the_same_results_give_the_same_file(database, tmp_path):
    for folder in ("a", "b"):
        draw.main(["campaign", str(database), "-o", str(tmp_path / folder)])
    assert (tmp_path / "a" / "first.svg").read_bytes() == (tmp_path / "b" / "first.svg").read_bytes()
