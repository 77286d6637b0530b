# SPDX-License-Identifier: BSD-3-Clause
import json
import math
import sqlite3

import compact
import kinematics_cases
import numpy as np
import pandas
import pytest
import report
import report_figures
import report_motions
import report_phase
import report_prose
import report_rows
import report_slices
import report_tables
import report_verdict

TABLES = """
CREATE TABLE experiments (id INTEGER PRIMARY KEY, name TEXT, timelimit REAL, checker TEXT);
CREATE TABLE instances (experimentid INTEGER, scenario TEXT, options TEXT);
CREATE TABLE plannerConfigs (id INTEGER PRIMARY KEY, name TEXT, settings TEXT);
CREATE TABLE campaign (name TEXT, configuration TEXT, digest TEXT, seed INTEGER, engine TEXT);
CREATE TABLE environments (id INTEGER PRIMARY KEY, cpu TEXT);
CREATE TABLE paths (runid INTEGER PRIMARY KEY, angles TEXT);
CREATE TABLE runs (id INTEGER PRIMARY KEY, experimentid INTEGER, plannerid INTEGER, run INTEGER, seed INTEGER, outcome TEXT,
  reason TEXT, solved INTEGER, uses_model INTEGER, prescribed INTEGER, cpu_time REAL, evaluations INTEGER,
  state_checks INTEGER, solution_length REAL, solution_clearance REAL, recipe TEXT, peak_memory_kb REAL,
  solution_smoothness REAL, max_joint_step REAL);
"""
SCENARIO = """
name: {name}
robot: {{links: [{{length: 1}}, {{length: 1}}]}}
start: {{angles: [0, 0]}}
goal: {{angles: [1, 1]}}
obstacles: [{{kind: circle, center: [{x}, 3], radius: 0.5}}]
"""


@pytest.fixture
def database(tmp_path):
    """\\return makes a file from rows (group, instance, planner, ours, CPU seconds or None for a timeout)"""

    def write(rows):
        file = tmp_path / "results.db"
        file.unlink(missing_ok=True)
        connection = sqlite3.connect(file)
        connection.executescript(TABLES)
        connection.execute("INSERT INTO campaign VALUES ('made', '', '', 5, 'isolated')")
        connection.execute("INSERT INTO environments VALUES (1, 'a </script> CPU')")
        instances = list(dict.fromkeys((group, instance) for group, instance, *_ in rows))
        for number, (group, instance) in enumerate(instances, 1):
            connection.execute(
                "INSERT INTO experiments VALUES (?, ?, 1.0, 'analytic')", (number, f"{instance}_analytic")
            )
            options = json.dumps({"group": f"{group}_analytic"})
            connection.execute(
                "INSERT INTO instances VALUES (?, ?, ?)", (number, SCENARIO.format(name=instance, x=number), options)
            )
        planners = list(dict.fromkeys(planner for _, _, planner, *_ in rows))
        connection.executemany(
            "INSERT INTO plannerConfigs VALUES (?, ?, 'planner=x;space=absolute;')", enumerate(planners, 1)
        )
        for count, (group, instance, planner, ours, cpu) in enumerate(rows, 1):
            outcome = "timeout" if cpu is None else "solved"
            ids = instances.index((group, instance)) + 1, planners.index(planner) + 1
            values = (
                count,
                *ids,
                count,
                count,
                outcome,
                "",
                cpu is not None,
                ours,
                0,
                cpu or 1.0,
                7,
                3,
                2.0,
                0.1,
                "{}",
                100.0,
                0.5,
                0.4,
            )
            connection.execute("INSERT INTO runs VALUES (" + ", ".join("?" * 19) + ")", values)
            if cpu is not None:
                connection.execute("INSERT INTO paths VALUES (?, '[[0, 0], [0.4, 0.5], [1, 1]]')", (count,))
        connection.commit()
        connection.close()
        return file

    return write


def paired(group, ours, theirs):
    """One run of each side on every instance."""
    rows = [(group, f"{group}{i}", "hppm", True, cpu) for i, cpu in enumerate(ours)]
    return rows + [(group, f"{group}{i}", "rrt", False, cpu) for i, cpu in enumerate(theirs)]


def contests_of(file):
    return report_verdict.contests(report_rows.read_campaign(file).runs)


def test_pairs_are_decided_by_signs(database):
    (contest,) = contests_of(database(paired("a", [0.001] * 6, [0.002] * 6)))
    assert (contest.winner, contest.pairs, contest.group) == ("ours", 6, "a")
    assert contest.p == contest.adjusted == pytest.approx(2 * 0.5**6, abs=1e-12)
    assert contest.lead == pytest.approx(2.0)


def test_the_verdict_falls_the_other_way_too(database):
    file = database(paired("a", [None] * 8, [0.002] * 8))
    (contest,) = contests_of(file)
    assert (contest.winner, contest.lead) == ("theirs", None)
    runs = report_rows.read_campaign(file).runs
    assert report_verdict.headline([contest], runs) == "Sampling planners are ahead everywhere"
    text = " ".join(report_prose.verdict(runs, [contest], report_tables.over_all(runs))["sentences"])
    assert "planners that see the model (none solved)" in text and "16 runs of 2 planner entries on 8 instances in 1 group: 8 ended" in text


def test_five_pairs_are_never_enough_alone_but_runs_may_be(database):
    # 5 instances: all runs are ranked, 10 against 10, fully apart.
    rows = paired("a", [0.001] * 5, [0.002] * 5) * 2
    (contest,) = contests_of(database(rows))
    assert contest.pairs == 0 and contest.winner == "ours"


def test_what_neither_solves_is_undecided(database):
    (contest,) = contests_of(database(paired("a", [None] * 9, [None] * 9)))
    assert (contest.winner, contest.p) == ("undecided", 1.0)


def test_holm_counts_the_groups(database):
    # p = 1/32 in each of two groups: decided alone, not together.
    rows = paired("a", [0.001] * 6, [0.002] * 6) + paired("b", [0.001] * 6, [0.002] * 6)
    found = contests_of(database(rows))
    assert [contest.adjusted for contest in found] == pytest.approx([1 / 16, 1 / 16])
    assert report_verdict.headline(found, pandas.DataFrame()).startswith("Undecided")


def test_prescribed_recipes_take_no_part(database):
    file = database(paired("a", [0.001] * 6, [0.002] * 6))
    with sqlite3.connect(file) as connection:
        connection.execute("UPDATE runs SET prescribed = uses_model")
    runs = report_rows.read_campaign(file).runs
    assert report_verdict.contests(runs) == []
    assert report_verdict.headline([], runs).startswith("No verdict: one kind of planner ran with prescribed recipes")
    assert set(runs["planner"]) == {"hppm *", "rrt"}


def test_incidence_without_early_censoring_is_the_share_solved(database):
    file = database([("a", "a", "rrt", False, cpu) for cpu in (0.1, 0.2, 0.2, 0.4, None)])
    x, y = report_figures.incidence(report_rows.read_campaign(file).runs)
    assert x == [0.1, 0.2, 0.4] and y == pytest.approx([0.2, 0.6, 0.8])


def test_a_profile_counts_instances_within_a_factor(database):
    rows = paired("a", [0.001, 0.004, None], [0.002, 0.001, 0.003])
    panel = report_figures.profile(report_rows.read_campaign(database(rows)).runs)
    assert {line["name"]: (line["x"], list(line["y"])) for line in panel["series"]} == {
        "hppm": ([1.0, 4.0], pytest.approx([1 / 3, 2 / 3], abs=1e-4)),
        "rrt": ([1.0, 2.0], pytest.approx([2 / 3, 1.0], abs=1e-4)),
    }


def test_a_phase_diagram_reads_the_sweeps_names(database):
    rows = []
    for width, share in (("1e-3", 0), ("1e-2", 4), ("0.1", 10)):
        for links in (3, 6):
            for i in range(10):
                name = f"slab_links{links}_half_width{width}"
                rows.append((name, f"{name}_seed{i}", "rrt", False, 0.1 if i < share - (links == 6) else None))
    rows.append(("gap", "gap", "rrt", False, 0.1))
    (panel,) = report_phase.panels(report_rows.read_campaign(database(rows)).runs)
    assert (panel["name"], panel["rows"], panel["columns"]) == ("slab: rrt", [3, 6], [1e-3, 1e-2, 0.1])
    assert panel["shares"] == [[0.0, 0.4, 1.0], [0.0, 0.3, 0.9]] and panel["runs"] == [[10] * 3] * 2
    # More links need more width, and the line lies where the shares cross a half.
    (narrow, *_), (wide, low, high) = panel["line"]
    assert 1e-2 < narrow < wide < 0.1 and low < wide < high


def test_one_width_is_no_diagram_and_one_row_has_no_line(database):
    assert report_phase.panels(report_rows.read_campaign(database([("a", "a", "rrt", False, 0.1)])).runs) == []
    rows = [(f"tube_clearance{w}", f"tube_clearance{w}", "rrt", False, t) for w, t in (("0.1", 0.1), ("4e-4", None))]
    (panel,) = report_phase.panels(report_rows.read_campaign(database(rows)).runs)
    assert (panel["columns"], panel["rows"], panel["line"], panel["failure"]) == ([4e-4, 0.1], [0], [], "one_row")


def test_cost_over_width_is_a_median_that_counts_what_is_missing(database):
    rows = []
    for width, times in (("1e-3", (0.2, None, None)), ("1e-2", (0.1, 0.3, None)), ("0.1", (0.01, 0.02, 0.03))):
        for i, time in enumerate(times):
            group = f"slab_links3_half_width{width}"
            rows.append((group, f"{group}_seed{i}", "rrt", False, time))
    rows.append(("gap", "gap", "rrt", False, 0.1))
    runs = report_rows.read_campaign(database(rows)).runs
    panel, by_evaluations = report_phase.cost_panels(runs, {"cpu": "CPU seconds", "evaluations": "evaluations"})
    assert panel["name"] == "slab, 3 links: CPU seconds" and by_evaluations["name"] == "slab, 3 links: evaluations"
    # Two of three are missing at 1e-3: their median is beyond the limit.
    assert panel["series"] == [{"name": "rrt", "ours": False, "x": [0.01, 0.1], "y": [0.3, 0.02]}]
    assert report_phase.cost_panels(runs[runs["group"] == "gap"], {"cpu": "CPU seconds"}) == []


def test_thinning_keeps_the_ends_and_the_tolerance():
    turn = np.linspace(0.0, 2.0, 500)
    path = np.column_stack([np.cos(turn), np.sin(turn), 1.0 / 3.0 + turn])
    rows, stored = report_motions.page_path(path.tolist(), 0.5)
    assert stored == 500 and 10 < len(rows) < 120
    assert rows[0] == path[0].tolist() and rows[-1] == path[-1].tolist()
    kept = np.array(rows)
    for point in path:
        along = np.diff(kept, axis=0)
        share = np.clip(np.sum((point - kept[:-1]) * along, axis=1) / np.sum(along * along, axis=1), 0.0, 1.0)
        assert np.linalg.norm(kept[:-1] + share[:, None] * along - point, axis=1).min() < 1.01e-3


def test_narrow_ways_are_thinned_less():
    turn = np.linspace(0.0, 2.0, 500)
    path = np.column_stack([np.cos(turn), np.sin(turn)]).tolist()
    wide, narrow = (report_motions.page_path(path, clearance)[0] for clearance in (0.5, 1e-4))
    assert len(narrow) > 3 * len(wide)


def test_groups_take_turns():
    pairs = [(1, "a"), (2, "a"), (3, "b"), (4, "a"), (5, "b")]
    assert report_motions.in_turn(pairs) == [1, 3, 2, 5, 4]


def options(**changes):
    given = {"motion_megabytes": 8.0, "program": None, "slices": 12, **changes}
    return type("Options", (), given)()


def test_motions_stop_at_the_budget(database):
    file = str(database(paired("a", [0.001] * 6, [0.002] * 6)))
    everything = report.collect(file, options())
    assert len(everything["scenes"]) == 6 and len(everything["motions"]) == 12
    assert everything["leftOut"] == {"paths": 0, "instances": 0, "shown": 6, "runs": 0, "slices": 0, "panels": 0}
    cost = len(json.dumps([everything["scenes"][0], everything["motions"][:2]]))
    some = report.collect(file, options(motion_megabytes=2.5 * cost / 1e6))
    assert len(some["scenes"]) == 2 and some["leftOut"]["paths"] == 8 and some["leftOut"]["instances"] == 4


def test_at_most_three_motions_of_a_planner_and_an_instance(database):
    file = str(database([("a", "a", "rrt", False, cpu) for cpu in (0.3, 0.1, 0.2, 0.4, None)]))
    with sqlite3.connect(file) as connection:
        connection.execute("UPDATE runs SET solution_length = 5 - id")
        connection.execute("INSERT INTO paths VALUES (5, '[[0, 0], [1, 1]]')")
    motions = report.collect(file, options())["motions"]
    assert [(motion["run"], motion["why"]) for motion in motions] == [
        (4, "shortest"),
        (3, "median time"),
        (5, "not accepted"),
    ]


def test_runs_beyond_the_limit_are_counted_but_not_listed(database, monkeypatch):
    monkeypatch.setattr(report, "ROWS", 6)
    rows = [("a", "a", planner, ours, 0.1) for planner, ours in (("hppm", True), ("rrt", False)) for _ in range(10)]
    data = report.collect(str(database(rows)), options())
    listed = {
        name: data["runs"]["planner"]["codes"].count(code) for code, name in enumerate(data["runs"]["planner"]["texts"])
    }
    assert data["leftOut"]["runs"] == 20 - sum(listed.values())
    assert data["groups"][0]["runs"] == data["groups"][1]["runs"] == 10
    # The runs whose motions are shown are listed, wherever they are.
    assert {motion["run"] for motion in data["motions"]} <= set(data["runs"]["id"])


def test_the_page_stands_alone_and_its_data_come_back(database, tmp_path):
    file = str(database(paired("a", [0.001] * 6, [0.002] * 6)))
    assert report.main([file, "-o", str(tmp_path / "out")]) == 0
    text = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    assert text.count("</script>") == 2  # the machine's name closes none
    data = json.loads(text.split('id="data">')[1].split("</script>")[0])
    assert data["sessions"][0]["cpu"] == "a </script> CPU"
    assert data["verdict"]["headline"] == "Planners that see the model are ahead everywhere"
    assert report.main([file, "-o", str(tmp_path / "again")]) == 0
    assert (tmp_path / "again" / "index.html").read_text(encoding="utf-8") == text


def test_a_file_that_is_no_campaign_is_said_to_be_none(tmp_path, capsys):
    (tmp_path / "x.db").write_text("not SQLite")
    assert report.main([str(tmp_path / "x.db"), "-o", str(tmp_path)]) == 1
    assert report.main([str(tmp_path / "absent.db"), "-o", str(tmp_path)]) == 1
    assert capsys.readouterr().err.count("not a database of `narrows bench`") == 2
    assert not (tmp_path / "absent.db").exists()


def test_nothing_that_is_not_finite_reaches_the_page():
    assert report.finite({"a": [float("nan"), (1.0, float("inf"))]}) == {"a": [None, [1.0, None]]}


def test_a_slices_picture_is_packed_bit_by_bit():
    bits, picture = report_slices.packed(["#.##....", ".#......"])
    assert bits == "sEA=" and picture.sum() == 4  # 0b10110000, 0b01000000


def test_the_pages_kinematics_are_tested_against_these_poses():
    stored = json.loads((kinematics_cases.ROOT / "analysis/viewer/test/kinematics.json").read_text())
    fresh = kinematics_cases.cases()
    assert [case["name"] for case in stored] == [case["name"] for case in fresh]
    for old, new in zip(stored, fresh):
        assert old["robot"] == new["robot"] and old["row"] == new["row"]
        assert np.allclose(old["segments"], new["segments"], rtol=0.0, atol=1e-12)


def test_leads_say_where_sampling_is_first(database):
    rows = []
    for width, ours, theirs in (("1e-3", 0.1, None), ("1e-2", 0.1, 0.2), ("0.1", 0.1, 0.01)):
        for links in (3, 6):
            for i in range(4):
                name = f"slab_links{links}_half_width{width}"
                rows.append((name, f"{name}_seed{i}", "hppm", True, ours))
                rows.append((name, f"{name}_seed{i}", "rrt", False, 0.2 if i == 0 and width == "0.1" else theirs))
    rows += [("slab_links3_half_width1e-3", "slab_links3_half_width1e-3_seed9", name, name == "hppm", None) for name in ("hppm", "rrt")]
    runs = report_rows.read_campaign(database(rows)).runs
    (panel,) = report_phase.lead_panels(runs)
    assert (panel["name"], panel["rows"], panel["columns"]) == ("slab", [3, 6], [1e-3, 1e-2, 0.1])
    assert panel["shares"] == [[0.0, 0.0, 0.75]] * 2
    assert panel["runs"] == [[4, 4, 4]] * 2  # what nobody solved says nothing


def test_the_verdict_names_the_border():
    line = [[0.04, 0.03, 0.05], [0.02, 0.01, 0.03]]
    panels = [
        {"name": "slab", "rows": [3, 6], "line": line, "shares": [], "runs": []},
        {"name": "tube", "rows": [4], "line": [], "shares": [[0.0, 0.5, None]], "runs": [[10, 30, 0]]},
    ]
    assert list(report_prose.regions(panels)) == [
        "In slab a sampling planner is first in most scenes at half widths above 0.04 (0.03 to 0.05) with 3 links; "
        "0.02 (0.01 to 0.03) with 6 links.",
        "In tube a sampling planner is first in 37.5\u00a0% of scenes, without a clear border in width.",
    ]


def test_effort_is_counted_in_evaluations(database):
    runs = report_rows.read_campaign(database([("a", "a", "rrt", False, cpu) for cpu in (0.1, 0.2, 0.3, None)])).runs
    runs["evaluations"] = [10.0, 40.0, 20.0, 30.0]
    # The timeout had made 30 when it ended: it is not counted at 40.
    assert report_figures.effort(runs) == ([10.0, 20.0, 40.0], pytest.approx([0.25, 0.5, 1.0]))
    runs["outcome"] = ["solved"] * 3 + ["no_solution"]
    assert report_figures.effort(runs)[1] == pytest.approx([0.25, 0.5, 0.75])


def test_tables_of_the_page_name_their_columns(database):
    rows = []
    for width, cpu in (("1e-3", 0.4), ("1e-2", 0.04)):
        for i in range(3):
            name = f"slab_links3_half_width{width}"
            rows.append((name, f"{name}_seed{i}", "rrt", False, cpu))
    file = str(database(rows))
    tables = {table["id"]: table for table in report.collect(file, options())["tables"]}
    assert set(tables) == {"slopes", "quality"}
    by_time = tables["slopes"]["rows"][0]
    assert by_time[:3] == ["slab", "rrt", "CPU time"] and by_time[3] == pytest.approx(-1.0, abs=1e-9)
    assert by_time[6:] == [6, 0]
    (quality,) = tables["quality"]["rows"]
    assert quality[:3] == ["rrt", 6, 2.0] and len(quality) == len(tables["quality"]["columns"])


def test_a_compact_database_keeps_every_row_and_one_scenes_paths(database, tmp_path, capsys):
    rows = paired("a", [0.001] * 6, [0.002] * 6) + paired("b", [0.001] * 2, [None] * 2)
    source, target = str(database(rows)), tmp_path / "small.db"
    assert compact.compact(source, target) == (3, 14)  # a0 by both, b0 by the one that solved it
    before, after = (report_rows.read_campaign(str(file)).runs for file in (source, target))
    assert before.equals(after)
    assert compact.main([source, str(target)]) == 1
    assert compact.main([str(tmp_path / "absent.db"), str(tmp_path / "x.db")]) == 1
    assert "exists already" in capsys.readouterr().err


def test_a_campaign_that_is_not_complete_says_so(database):
    file = str(database(paired("a", [0.001] * 6, [0.002] * 6)))
    assert report_rows.read_campaign(file).untouched == 0
    with sqlite3.connect(file) as connection:
        connection.execute("DELETE FROM runs WHERE experimentid = 6")
    data = report.collect(file, options())
    assert data["verdict"]["notes"][0].startswith("The campaign is not complete: 1 instance has no runs yet.")
