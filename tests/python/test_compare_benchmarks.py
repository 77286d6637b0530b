# SPDX-License-Identifier: BSD-3-Clause
"""bench/compare.py: paired ratios of two builds."""
import importlib.util
import pathlib

import pytest

PATH = pathlib.Path(__file__).parents[2] / "bench" / "compare.py"
spec = importlib.util.spec_from_file_location("compare_benchmarks", PATH)
compare = importlib.util.module_from_spec(spec)
spec.loader.exec_module(compare)


def test_the_median_and_its_order_statistics():
    # Of nine fair coins at most one shows heads with probability 10/512; twice that is below 0.05.
    assert compare.median_interval(range(1, 10)) == (5, 2, 8)


def test_few_values_have_no_interval():
    assert compare.median_interval([1.0, 2.0, 3.0, 4.0, 5.0]) == (3.0, float("-inf"), float("inf"))
    assert compare.median_interval([1, 2, 3, 4, 5, 6])[1:] == (1, 6)  # 2 / 64


def test_ratios_are_paired_by_round():
    # The machine is ten times slower in every other round; the ratio does not care.
    rounds = [({"a": 1.0 * slow, "b": 3.0}, {"a": 0.5 * slow, "b": 3.0}) for slow in [1.0, 10.0] * 4]
    assert compare.compare(rounds) == [("a", 0.5, 0.5, 0.5), ("b", 1.0, 1.0, 1.0)]


def test_only_what_both_have_is_compared():
    assert [row[0] for row in compare.compare([({"a": 1.0, "b": 1.0}, {"a": 1.0, "c": 1.0})])] == ["a"]


@pytest.mark.parametrize("lower, upper, word", [(0.4, 0.6, "faster"), (1.1, 1.2, "slower"),
                                                 (0.9, 1.1, "no difference shown")])
def test_verdicts(lower, upper, word):
    assert compare.verdict(lower, upper) == word
