# SPDX-License-Identifier: BSD-3-Clause
"""Many planners over many instances (Dolan and More, Math. Program. 91, 2002). A performance profile depends on which
planners are in it: never read one alone. A data profile does not."""

import numpy as np


def performance_ratios(costs):
    """\\param costs table, a row per instance, a column per planner; positive, infinite or NaN where it did not solve
    \\return cost by the least cost of the instance, infinite where not solved"""
    costs = costs.fillna(np.inf)
    best = costs.min(axis=1)
    return costs.div(best.where(np.isfinite(best), 1.0), axis=0)


def profile(values, points):
    """Shares of the instances, per planner, whose value is at most each of the points: of performance ratios a performance
    profile, of costs a data profile.

    \\return table, a row per point, a column per planner
    """
    finite = values.fillna(np.inf)
    return finite.apply(lambda column: np.searchsorted(np.sort(column), points, side="right") / len(column)).set_index(
        np.asarray(points)
    )
