# SPDX-License-Identifier: BSD-3-Clause
"""Tuning draws what it says, ranks as it says, and leaves the experiment files' other sections alone."""

import math
from pathlib import Path

import numpy as np
import pandas
import pytest
import tune

ROOT = Path(tune.__file__).resolve().parents[1]


def runs_of(label, times, limit=0.1):
    return pandas.DataFrame(
        {
            "label": label,
            "planner": label,
            "instance": range(len(times)),
            "solved": [time is not None for time in times],
            "outcome": ["timeout" if time is None else "solved" for time in times],
            "cpu": [time or limit for time in times],
            "limit_s": limit,
        }
    )


def test_settings_stay_in_their_ranges_and_repeat_with_the_seed():
    for planner in ["sbl", *tune.SPACE]:
        settings = [tune.drawn(planner, np.random.default_rng(seed)) for seed in range(50)]
        assert settings[7] == tune.drawn(planner, np.random.default_rng(7))
        for name, (kind, low, high) in tune.SPACE.get(planner, tune.RANGE).items():
            values = [float(setting[name]) for setting in settings]
            assert low * 0.99 <= min(values) and max(values) <= high * 1.01
            assert kind != "log" or 1 / 1.6 < np.median(values) / math.sqrt(low * high) < 1.6
            assert kind != "integer" or all(value == int(value) for value in values)


def test_the_most_solved_wins_then_the_soonest():
    candidates = {"a": [("a 0", {}), ("a 1", {"range": "1"}), ("a 2", {"range": "2"})]}
    runs = pandas.concat(
        [runs_of("a 0", [0.01, None]), runs_of("a 1", [0.09, 0.09]), runs_of("a 2", [0.05, 0.08])], ignore_index=True
    )
    assert tune.best(runs, candidates) == {"a": ("a 2", {"range": "2"})}
    tie = pandas.concat([runs_of("a 0", [0.01]), runs_of("a 1", [0.01]), runs_of("a 2", [0.02])], ignore_index=True)
    assert tune.best(tie, candidates) == {"a": ("a 0", {})}  # the default, if nothing is better


def test_the_files_of_the_study_are_read_and_written_back():
    head, planners = tune.split((ROOT / "experiments/tuning_training.cfg").read_text())
    other_head, others = tune.split((ROOT / "experiments/tuning_held_out.cfg").read_text())
    assert planners == others and len(planners) >= 12
    seeds = [
        line for part in (head, other_head) for line in part.splitlines() if "seed = " in line and "generate" in line
    ]
    assert len(set(seeds)) == 4  # no scene is in both
    text = head + tune.entries([("sbl", "sbl 1", {"range": "0.5"})])
    assert text.endswith("\n[planner]\nsbl =\nsbl.name = sbl 1\nsbl.range = 0.5\n")


def test_scenario_files_are_found_from_elsewhere(tmp_path):
    head = "[problem]\nscenario = scenarios/a.yaml, b.yaml\n[benchmark]\noutput = ../results"
    text = tune.relocated(head, tmp_path / "experiments" / "x.cfg", tmp_path / "out")
    assert f"scenario = {tmp_path}/experiments/scenarios/a.yaml, {tmp_path}/experiments/b.yaml" in text
    assert f"output = {tmp_path}/out" in text


def test_what_cannot_be_tuned_is_refused(tmp_path, capsys):
    with pytest.raises(ValueError, match="no .planner. section"):
        tune.split("[problem]\n")
    with pytest.raises(ValueError, match="not `sbl.range = 1`"):
        tune.split("\n[planner]\nsbl =\nsbl.range = 1\n")
    assert tune.main([str(tmp_path / "no.cfg"), str(tmp_path / "no.cfg"), "-o", str(tmp_path)]) == 1
    assert "no.cfg" in capsys.readouterr().err


def test_the_table_gives_the_gain_with_its_interval():
    rng = np.random.default_rng(2)
    slow = rng.uniform(0.02, 0.08, 30)
    runs = pandas.concat([runs_of("sbl", list(slow)), runs_of("sbl tuned", list(slow / 2))], ignore_index=True)
    lines = list(tune.table(runs, {"sbl": ("sbl 3", {"range": "0.5"})}))
    assert lines[2].startswith("| sbl | 30/30 | ") and "| range 0.5 | 2 (" in lines[2]
