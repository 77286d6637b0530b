# SPDX-License-Identifier: BSD-3-Clause
"""How soon a planner has its first verified path.

A timeout says that it would have taken longer: it is censored at the limit. A run that gave up, crashed or claimed what
the verifier refused will not solve later: it stays unsolved for ever, which makes one minus Kaplan and Meier's estimate
the cumulative incidence of solutions. Both stand in a table as rows with `time` and `solved`.
"""

from dataclasses import dataclass

import numpy as np
import pandas
from scipy import stats
from statsmodels.duration.survfunc import SurvfuncRight, survdiff

CENSORED = "timeout"


@dataclass
class Estimate:
    value: float
    low: float
    high: float


def observations(runs, limit):
    """Times to a solution, as the estimators take them.

    \\param runs table with `solved`, `outcome` and `cpu` in seconds
    \\param limit seconds: what is asked is who solves within them. Never more than the limit of the runs
    \\return table with the index of `runs` and `time`, `solved`: solved later counts as not solved, a timeout is censored
    when it came and at most at the limit, any other failure lasts to the limit
    """
    if not limit > 0.0:
        raise ValueError(f"limit: must be positive, not {limit}")
    cpu = runs["cpu"].astype(float)
    solved = runs["solved"].astype(bool) & (cpu <= limit)
    waits = solved | (runs["outcome"] == CENSORED)
    return pandas.DataFrame({"time": cpu.where(waits, limit).clip(upper=limit), "solved": solved})


def kaplan_meier(table):
    """\\return statsmodels' estimate of the share that is not solved yet, or nothing if no run was solved"""
    return SurvfuncRight(table["time"], table["solved"].astype(int)) if table["solved"].any() else None


def median(table, level=0.95):
    """Seconds until half of the runs are solved: infinite, or bounded by infinity, where the estimate does not get there."""
    curve = kaplan_meier(table)
    if curve is None:
        return Estimate(np.inf, np.inf, np.inf)
    value = curve.quantile(0.5)
    with np.errstate(divide="ignore", invalid="ignore"):  # log(-log(0)) after the last solution
        low, high = curve.quantile_ci(0.5, alpha=1.0 - level)
    return Estimate(*(float(np.inf if np.isnan(x) else x) for x in (value, low, high)))


def restricted_mean(table, limit, level=0.95):
    """Mean seconds to a solution or to the limit, whichever comes first: the area under Kaplan and Meier's curve.

    Its variance is Greenwood's: sum over times t of (area after t)^2 d / (n (n - d)), d of n at risk being solved at t.
    """
    curve = kaplan_meier(table)
    if curve is None:
        return Estimate(limit, limit, limit)
    times = np.concatenate([[0.0], curve.surv_times, [limit]])
    shares = np.concatenate([[1.0], curve.surv_prob])
    areas = shares * np.diff(times)
    after = areas[::-1].cumsum()[::-1][1:]
    events, at_risk = np.asarray(curve.n_events, float), np.asarray(curve.n_risk, float)
    terms = np.divide(after**2 * events, at_risk * (at_risk - events), out=np.zeros_like(after), where=at_risk > events)
    half = stats.norm.ppf(0.5 + level / 2.0) * np.sqrt(terms.sum())
    mean = areas.sum()
    return Estimate(float(mean), float(max(0.0, mean - half)), float(min(limit, mean + half)))


def log_rank(table, planner, instance):
    """Do planners differ in how soon they solve? Compared within instances, which differ from each other much more.

    \\param planner, instance columns, one entry per row of `table`
    \\return (chi squared, probability of that much if they do not)
    """
    statistic, probability = survdiff(
        np.asarray(table["time"]), np.asarray(table["solved"], int), np.asarray(planner), strata=np.asarray(instance)
    )
    return float(statistic), float(probability)
