# SPDX-License-Identifier: BSD-3-Clause
"""How often a planner solves: k of n independent runs."""

import numpy as np
from scipy import optimize
from statsmodels.stats.proportion import power_proportions_2indep, proportion_confint

METHODS = {"wilson": "wilson", "clopper_pearson": "beta"}


def interval(solved, runs, level=0.95, method="wilson"):
    """Bounds on the probability of success. Clopper-Pearson's cover at least as often as `level` says, whatever the truth;
    Wilson's are shorter and do so on average.

    \\param method wilson | clopper_pearson
    \\throws ValueError if there are no runs, or more solved ones than runs
    """
    if runs < 1 or not 0 <= solved <= runs:
        raise ValueError(f"{solved} of {runs} runs")
    low, high = proportion_confint(solved, runs, alpha=1.0 - level, method=METHODS[method])
    return float(low), float(high)


def power(rate, other_rate, runs, alpha=0.05):
    """How often a two-sided test of two proportions with `runs` runs each finds this difference."""
    if rate == other_rate:
        return alpha
    if abs(rate - other_rate) == 1.0:
        return 1.0  # no run of either contradicts it
    return float(power_proportions_2indep(other_rate - rate, rate, runs, alpha=alpha, return_results=False))


def detectable_difference(rate, runs, chance=0.8, alpha=0.05):
    """The smallest loss from `rate` that as many runs of another planner show with this chance; NaN if not even a planner
    that never solves would be told apart."""

    def surplus(loss):
        return power(rate, rate - loss, runs, alpha) - chance

    if rate <= 0.0 or surplus(rate) < 0.0:
        return float("nan")
    return float(optimize.brentq(surplus, 1e-9, rate, xtol=1e-12))


def needed_runs(rate, other_rate, chance=0.8, alpha=0.05):
    """Runs of each planner that show this difference with this chance.

    \\throws ValueError if there is no difference
    """
    if rate == other_rate:
        raise ValueError("no number of runs shows a difference that is not there")
    runs = 2
    while power(rate, other_rate, runs, alpha) < chance:
        runs *= 2
    return int(np.ceil(optimize.brentq(lambda n: power(rate, other_rate, n, alpha) - chance, 1.0, runs)))
