# SPDX-License-Identifier: BSD-3-Clause
"""Two planners on the same instances. Instances are the sample: repeated runs on one tell how sure its value is, and are
averaged before planners are compared, never counted as more instances."""

from dataclasses import dataclass

import numpy as np
from scipy import stats
from statsmodels.stats.contingency_tables import mcnemar

RESAMPLES = 9999


@dataclass
class Comparison:
    """Of a first planner with a second one. Ratios are second by first: 2 says that the second takes twice as long."""

    instances: int
    only_first: int  # instances that the first planner solves (more often than not) and the second one does not
    only_second: int
    success_p: float  # McNemar's exact test
    ratio: float  # of mean restricted times
    ratio_low: float
    ratio_high: float
    time_p: float  # Wilcoxon's signed ranks of the logarithms of restricted times, instance by instance


def by_instance(runs, planner, limit):
    """\\param runs table with `instance`, `planner`, `solved`, `cpu`
    \\return table by instance: `solved`, whether more than half of the runs were within the limit, and `time`, their mean
    restricted time in seconds (a run that did not solve counts with the limit, whatever it ended by)"""
    rows = runs[runs["planner"] == planner]
    solved = rows["solved"].astype(bool) & (rows["cpu"] <= limit)
    table = rows.assign(within=solved, time=rows["cpu"].where(solved, limit)).groupby("instance")
    return table.agg(solved=("within", lambda column: column.mean() > 0.5), time=("time", "mean"))


def success_probability(only_first, only_second):
    """Of so uneven a split, or a more uneven one, if neither planner were better."""
    return float(mcnemar([[0, only_first], [only_second, 0]], exact=True).pvalue) if only_first + only_second else 1.0


def time_probability(first, second):
    """Wilcoxon's signed-rank test of log(second / first); instances without a difference say nothing."""
    difference = np.log(np.asarray(second, float)) - np.log(np.asarray(first, float))
    difference = difference[difference != 0.0]
    return float(stats.wilcoxon(difference).pvalue) if difference.size else 1.0


def mean_ratio(first, second, generator, level=0.95, resamples=RESAMPLES):
    """mean(second) / mean(first) with its interval: bootstrap over instances (bias-corrected and accelerated).

    \\return (ratio, low, high); the bounds are NaN where all instances say the same or there are less than two
    """
    first, second = np.asarray(first, float), np.asarray(second, float)

    def statistic(a, b, axis):
        return np.log(np.mean(b, axis=axis)) - np.log(np.mean(a, axis=axis))

    ratio = float(np.exp(statistic(first, second, 0)))
    if first.size < 2 or np.ptp(second / first) == 0.0:
        return ratio, float("nan"), float("nan")
    result = stats.bootstrap((first, second), statistic, paired=True, vectorized=True, confidence_level=level,
                             n_resamples=resamples, method="BCa", random_state=generator)
    return ratio, float(np.exp(result.confidence_interval.low)), float(np.exp(result.confidence_interval.high))


def compare(runs, first, second, limit, generator, level=0.95):
    """Two planners of a table of runs, on the instances that both were run on.

    \\throws ValueError if there is none
    """
    table = by_instance(runs, first, limit).join(by_instance(runs, second, limit), how="inner", lsuffix="_1", rsuffix="_2")
    if table.empty:
        raise ValueError(f"no instance was given to both {first} and {second}")
    only_first = int((table["solved_1"] & ~table["solved_2"]).sum())
    only_second = int((~table["solved_1"] & table["solved_2"]).sum())
    ratio, low, high = mean_ratio(table["time_1"], table["time_2"], generator, level)
    return Comparison(len(table), only_first, only_second, success_probability(only_first, only_second), ratio, low, high,
                      time_probability(table["time_1"], table["time_2"]))
