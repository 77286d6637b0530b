# SPDX-License-Identifier: BSD-3-Clause
import json
import sqlite3

import pytest
import tight
import tight_meshes

TABLES = """
CREATE TABLE instances (experimentid INTEGER, options TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, solved INTEGER, reason TEXT,
  outcome TEXT, cpu_time REAL);
"""


@pytest.fixture
def table(tmp_path, capsys):
    """\\return what the script prints for rows (group, planner, solved, reason)"""

    def show(rows, *options):
        file = tmp_path / "results.db"
        connection = sqlite3.connect(file)
        connection.executescript(TABLES)
        names = list(dict.fromkeys(name for _, name, _, _ in rows))
        connection.executemany("INSERT INTO plannerConfigs VALUES (?, ?)", enumerate(names))
        for number, (group, name, solved, reason) in enumerate(rows):
            connection.execute("INSERT INTO instances VALUES (?, ?)", (number, json.dumps({"group": group})))
            connection.execute("INSERT INTO runs VALUES (NULL, ?, ?, ?, ?, 'no_solution', 0.5)",
                               (number, names.index(name), solved, reason))
        connection.commit()
        connection.close()
        tight.main([str(file), *options])
        return capsys.readouterr().out.splitlines()

    return show


def test_longest_solved_length_and_its_index(table):
    rows = [("ladder_shapeU40_length400_analytic", "relax", 1, None), ("ladder_shapeU40_length425_analytic", "relax", 1, None),
            ("ladder_shapeU40_length435_analytic", "relax", 0, "jump"), ("ladder_shapeU40_length400_analytic", "beams", 0, "jump"),
            ("boxes_length84_analytic", "relax", 1, None)]
    assert table(rows)[2:] == ["| U40 | none | 425 (0.988) | 430, exact |", "| boxes |  | 84 | not known |"]


def test_star_where_a_shorter_length_was_not_solved(table):
    rows = [("bends_length50_analytic", "beams", 1, None), ("bends_length60_analytic", "beams", 0, "jump"),
            ("bends_length70.5_analytic", "beams", 1, None)]
    assert table(rows)[2] == "| bends | 70.5 (0.681)\\* | 103.48, of a flat bend |"


def test_random_scenes_with_their_reasons(table):
    rows = [("ducts_index0.8_analytic", "tight", 1, None), ("ducts_index0.8_analytic", "tight", 0, "jump"),
            ("ducts_index0.8_analytic", "tight", 0, None)]
    assert table(rows, "--random")[2] == "| ducts_index0.8_analytic | tight | 1 of 3 | 0.5 | jump 1, no_solution 1 |"


def test_other_campaigns_are_refused(table):
    with pytest.raises(SystemExit, match="no link length"):
        table([("slab", "hppm", 1, None)])


@pytest.mark.parametrize("mesh", [tight_meshes.turbine(), tight_meshes.vessel()], ids=["turbine", "vessel"])
def test_meshes_are_closed(mesh):
    edges = [(face[i - 1], face[i]) for face in mesh.faces for i in range(3)]
    assert len(set(edges)) == len(edges)
    assert {(b, a) for a, b in edges} == set(edges)
