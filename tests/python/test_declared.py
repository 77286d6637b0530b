# SPDX-License-Identifier: BSD-3-Clause
"""Declared hypotheses: exact probabilities by counting, and the right verdict as often as promised."""

import hashlib
import json
import math
import sqlite3

import infer
import numpy as np
import pandas
import pytest
import report_rows
from inference import declared, trends
from scipy import stats

EXACT = 1e-9
LIMIT = 1.0


def runs_of(times):
    """\\param times by label, a list by instance: seconds, or None for a timeout"""
    rows = []
    for label, column in times.items():
        for instance, time in enumerate(column):
            rows.append(
                {
                    "instance": instance,
                    "full_group": "g",
                    "label": label,
                    "planner": label,
                    "solved": time is not None,
                    "cpu": time or LIMIT,
                    "limit_s": LIMIT,
                    "evaluations": 10.0 * (time or LIMIT),
                    "memory": 100.0,
                    "length": 2.0,
                }
            )
    return pandas.DataFrame(rows)


def hypothesis(**changes):
    given = {
        "name": "h",
        "statement": "s",
        "planners": ["a"],
        "against": ["b"],
        "groups": ["g"],
        "quantity": "success",
        "direction": "more",
        "alpha": 0.05,
    }
    return {**given, **changes}


def decide(runs, *hypotheses):
    return declared.decide(list(hypotheses), runs, np.random.default_rng(1))


def test_success_is_a_sign_test_of_the_instances_that_differ():
    # 9 that only a solves, 1 that only b solves, 5 that both solve.
    runs = runs_of({"a": [0.1] * 14 + [None], "b": [None] * 9 + [0.1] * 6})
    (decision,) = decide(runs, hypothesis())
    (claim,) = decision.claims
    assert claim.p_for == pytest.approx((1 + 10) / 2**10, abs=EXACT)  # 9 or 10 heads of 10
    assert claim.p_against == pytest.approx(1.0 - 1 / 2**10, abs=EXACT)
    assert decision.p == pytest.approx(2 * 11 / 1024, abs=EXACT)
    assert (decision.verdict, claim.effect) == ("confirmed", "14 solved : 6, alone 9 : 1")


def test_the_opposite_is_refuted_and_too_little_is_undecided():
    runs = runs_of({"a": [0.1] * 14 + [None], "b": [None] * 9 + [0.1] * 6})
    assert decide(runs, hypothesis(direction="less"))[0].verdict == "refuted"
    few = runs[runs["instance"].isin([0, 1, 2, 3, 12])]
    assert decide(few, hypothesis())[0].verdict == "undecided"


def test_every_rival_must_be_beaten():
    runs = runs_of({"a": [0.1] * 20, "b": [None] * 20, "c": [0.1] * 20})
    both = hypothesis(against=["b", "c"])
    assert decide(runs, both)[0].verdict == "undecided"  # c is as good
    assert decide(runs, hypothesis())[0].verdict == "confirmed"
    worse = runs_of({"a": [None] * 20, "b": [None] * 20, "c": [0.1] * 20})
    (decision,) = decide(worse, both)
    assert (decision.verdict, decision.crucial.rival) == ("refuted", "c")
    assert decision.p == pytest.approx(2 * 2 / 2**20, abs=EXACT)  # one of two rivals would do, on either side


def test_time_is_wilcoxons_test_of_restricted_times():
    rng = np.random.default_rng(3)
    a, b = rng.lognormal(-3, 1, 30), rng.lognormal(-2.5, 1, 30)
    (decision,) = decide(runs_of({"a": a, "b": b}), hypothesis(quantity="time", direction="less"))
    expected = stats.wilcoxon(np.log(a.clip(max=1)) - np.log(b.clip(max=1)), alternative="less").pvalue
    assert decision.claims[0].p_for == pytest.approx(expected, abs=EXACT)


def test_lengths_are_compared_where_both_solved():
    runs = runs_of({"a": [0.1] * 10 + [None] * 10, "b": [0.1] * 20})
    runs.loc[runs["label"] == "a", "length"] = 1.0
    (decision,) = decide(runs, hypothesis(quantity="length", direction="less"))
    assert decision.claims[0].instances == 10 and decision.claims[0].effect == "median ratio 0.5"
    assert decision.claims[0].p_for == pytest.approx(1 / 2**10, abs=EXACT)


def test_bounds_are_binomial_tests():
    runs = runs_of({"a": [0.1] * 19 + [None]})
    given = {"against": [], "bound": 0.5}
    (claim,) = decide(runs, hypothesis(**given))[0].claims
    assert claim.p_for == pytest.approx(21 / 2**20, abs=EXACT) and claim.effect.startswith("19 of 20 solved")
    (claim,) = decide(runs, hypothesis(**{**given, "bound": 20.0}, quantity="memory"))[0].claims
    assert claim.p_for == pytest.approx(1 / 2**19, abs=EXACT) and claim.effect == "median 100, 19 of 19 above"
    (claim,) = decide(runs, hypothesis(**{**given, "bound": 0.2}, quantity="time", direction="less"))[0].claims
    assert claim.p_for == pytest.approx(21 / 2**20, abs=EXACT)  # the unsolved one is above


def test_holm_counts_the_hypotheses():
    # 2 / 2^6 alone is below 5 %, twice that is not.
    runs = runs_of({"a": [0.1] * 6, "b": [None] * 6})
    assert decide(runs, hypothesis())[0].verdict == "confirmed"
    two = decide(runs, hypothesis(), hypothesis(name="i"))
    assert [decision.verdict for decision in two] == ["undecided"] * 2
    assert [decision.adjusted for decision in two] == pytest.approx([4 / 2**6] * 2, abs=EXACT)


def test_without_runs_nothing_is_decided():
    runs = runs_of({"a": [0.1] * 6, "b": [None] * 6})
    none, some = decide(runs, hypothesis(groups=["elsewhere"]), hypothesis(name="i"))
    assert (none.verdict, none.p, none.crucial) == ("undecided", 1.0, None)
    assert some.adjusted == pytest.approx(4 / 2**6, abs=EXACT)  # it still counts among those asked


def test_equals_are_told_apart_in_five_percent_of_campaigns_at_most():
    rng = np.random.default_rng(11)
    wrong = 0
    for _ in range(1000):
        first, second = rng.random((2, 40)) < 0.6
        only_first, only_second = int((first & ~second).sum()), int((~first & second).sum())
        wrong += 2.0 * min(declared.counts(only_first, only_first + only_second, 0.5, True)) <= 0.05
    assert wrong <= 50 + 3.3 * math.sqrt(1000 * 0.05 * 0.95)


def test_a_planted_drift_is_found():
    rng = np.random.default_rng(5)
    times = 0.01 * np.exp(np.linspace(0.0, math.log(1.3), 100) + rng.normal(0.0, 0.02, 100))
    drift = trends.drift(times)
    assert drift.change_low < 1.3 < drift.change_high and drift.change == pytest.approx(1.3, rel=0.02)
    steady = trends.drift([0.01] * 10)
    assert (steady.change, steady.median, steady.runs) == (1.0, 0.01, 10)


@pytest.fixture
def database():
    connection = sqlite3.connect(":memory:")
    connection.row_factory = sqlite3.Row
    connection.execute("CREATE TABLE hypotheses (name TEXT, definition TEXT, sha256 TEXT, declared TEXT)")
    text = json.dumps(hypothesis())
    row = ("h", text, hashlib.sha256(text.encode()).hexdigest(), "2026-01-01 00:00:00")
    connection.execute("INSERT INTO hypotheses VALUES (?, ?, ?, ?)", row)
    return connection


def test_what_was_declared_is_read_only_as_it_was_and_when_it_was(database):
    sessions = [{"date": "2026-01-01 00:00:00"}]
    assert report_rows.read_hypotheses(database, sessions) == [hypothesis()]
    with pytest.raises(ValueError, match="declared after the first session"):
        report_rows.read_hypotheses(database, [{"date": "2025-12-31 23:59:59"}])
    database.execute("UPDATE hypotheses SET definition = replace(definition, 'more', 'less')")
    with pytest.raises(ValueError, match="not the one that its SHA-256 was taken of"):
        report_rows.read_hypotheses(database, sessions)


def test_the_table_names_verdict_and_claim():
    runs = runs_of({"a": [0.1] * 20, "b": [None] * 20})
    lines = list(infer.decision_rows(decide(runs, hypothesis())))
    assert lines[2] == "| h: s | **confirmed** | 1.91e-06 | 20 | `a` and b: 20 solved : 0, alone 20 : 0 |"
    assert infer.machine(pandas.DataFrame({"cpu": [0.01] * 3, "checks": [7, 7, 8]})).count("NOT the same") == 1
