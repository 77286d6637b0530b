# SPDX-License-Identifier: BSD-3-Clause
"""Success and cost against the width of a passage and the degrees of freedom of the arm."""

from dataclasses import dataclass

import numpy as np
import statsmodels.api as sm
from scipy import stats
from statsmodels.tools.sm_exceptions import PerfectSeparationError


@dataclass
class Phase:
    """logit P(solved) = intercept + width log10(half width) + dof (degrees of freedom), if `failure` is empty. Else it is
    why there is no such line: "all_alike" (all solved or none), "separated" (a line divides solved from unsolved, so that
    its place is not determined), "no_trend" (success does not grow with width)."""

    failure: str
    coefficients: np.ndarray = None
    covariance: np.ndarray = None

    def half_width(self, dof, level=0.95):
        """Where half of the runs are solved: (half width, low, high) for each of `dof`, by the delta method."""
        dof = np.asarray(dof, float)
        intercept, slope, per_dof = self.coefficients
        place = -(intercept + per_dof * dof) / slope
        gradient = np.stack([np.full_like(dof, -1.0 / slope), -place / slope, -dof / slope], axis=-1)
        variance = np.einsum("...i,ij,...j->...", gradient, self.covariance, gradient)
        half = stats.norm.ppf(0.5 + level / 2.0) * np.sqrt(variance)
        return 10.0**place, 10.0 ** (place - half), 10.0 ** (place + half)


def phase_line(solved, half_width, dof, instance):
    """Logistic regression; runs on one instance are not independent, which the covariance allows for (clusters)."""
    solved = np.asarray(solved, float)
    if solved.min() == solved.max():
        return Phase("all_alike")
    causes = np.column_stack([np.ones_like(solved), np.log10(np.asarray(half_width, float)), np.asarray(dof, float)])
    groups = np.unique(np.asarray(instance), return_inverse=True)[1]
    try:
        fit = sm.Logit(solved, causes).fit(disp=False, maxiter=200, cov_type="cluster", cov_kwds={"groups": groups})
    except (PerfectSeparationError, np.linalg.LinAlgError):
        return Phase("separated")
    if not fit.mle_retvals["converged"]:
        return Phase("separated")
    return Phase("no_trend" if fit.params[1] <= 0.0 else "", np.asarray(fit.params), np.asarray(fit.cov_params()))


@dataclass
class Slope:
    """cost ~ width^exponent over solved runs. If some runs were not solved (`unsolved` > 0) those that would have cost most
    are missing, and the exponent is too close to 0."""

    exponent: float
    low: float
    high: float
    solved: int
    unsolved: int


def cost_slope(cost, half_width, instance, level=0.95):
    """Least squares of log10(cost) on log10(half width), clusters of instances allowed for.

    \\param cost positive; NaN or infinite where not solved
    \\throws ValueError if the solved runs have less than two widths or instances
    """
    cost, half_width = np.asarray(cost, float), np.asarray(half_width, float)
    solved = np.isfinite(cost)
    widths = np.log10(half_width[solved])
    groups = np.unique(np.asarray(instance)[solved], return_inverse=True)[1]
    if np.unique(widths).size < 2 or np.unique(groups).size < 2:
        raise ValueError("takes runs that were solved at two widths and on two instances")
    fit = sm.OLS(np.log10(cost[solved]), sm.add_constant(widths)).fit(cov_type="cluster", cov_kwds={"groups": groups})
    low, high = fit.conf_int(alpha=1.0 - level)[1]
    return Slope(float(fit.params[1]), float(low), float(high), int(solved.sum()), int((~solved).sum()))


@dataclass
class Drift:
    """Of the machine's speed over a campaign, by runs that are all the same."""

    runs: int
    median: float  # CPU seconds
    low: float  # quartiles
    high: float
    change: float  # factor by which the time changed from the first to the last run
    change_low: float
    change_high: float


def drift(times, level=0.95):
    """Theil and Sen's line through the logarithms of the times, in order: the median of the slopes between all pairs.

    \\param times positive, at least three
    """
    logs = np.log(np.asarray(times, float))
    low, median, high = np.percentile(times, (25, 50, 75))
    slope, _, slope_low, slope_high = stats.theilslopes(logs, alpha=level)
    changes = np.exp(np.array([slope, slope_low, slope_high]) * (len(logs) - 1))
    return Drift(len(logs), float(median), float(low), float(high), *(float(change) for change in changes))
