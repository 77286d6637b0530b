# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of a campaign by group and planner; every one is computed from the rows."""

import numpy as np
from inference import success


def middle(values):
    """(median, lower and upper quartile); None where nothing was measured."""
    values = values[np.isfinite(values)]
    if len(values) == 0:
        return None, None, None
    return tuple(float(value) for value in np.percentile(values, (50, 25, 75)))


def row_of(group, planner, runs):
    """One line of a table. Times are medians over solved runs, in CPU seconds."""
    solved = runs[runs["solved"]]
    low, high = success.interval(len(solved), len(runs))
    median, lower, upper = middle(solved["cpu"].to_numpy())
    return {
        "group": group,
        "planner": planner,
        "ours": bool(runs["ours"].iloc[0]),
        "prescribed": bool(runs["prescribed"].iloc[0]),
        "instances": int(runs["experiment"].nunique()),
        "runs": len(runs),
        "solved": len(solved),
        "share": len(solved) / len(runs),
        "low": low,
        "high": high,
        "cpu": median,
        "cpu_lower": lower,
        "cpu_upper": upper,
        "evaluations": middle(solved["evaluations"].to_numpy())[0],
        "checks": middle(solved["checks"].to_numpy())[0],
        "length": middle(solved["length"].to_numpy())[0],
        "clearance": middle(solved["clearance"].to_numpy())[0],
    }


def by_group(runs):
    return [row_of(group, planner, part) for (group, planner), part in runs.groupby(["group", "planner"], sort=False)]


def over_all(runs):
    return [row_of("all", planner, part) for planner, part in runs.groupby("planner", sort=False)]


def reasons(runs):
    """How many runs ended how, by planner: the outcome, and the reason where one is named."""
    why = runs["outcome"].where(runs["reason"] == "", runs["outcome"] + ": " + runs["reason"])
    counts = why.groupby([runs["planner"], why], sort=False).size()
    result = {}
    for (planner, name), count in counts.items():
        result.setdefault(planner, {})[name] = int(count)
    return result
