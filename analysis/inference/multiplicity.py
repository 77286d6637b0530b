# SPDX-License-Identifier: BSD-3-Clause
"""Many questions at once: some look answered by chance alone."""

import numpy as np
from statsmodels.stats.multitest import multipletests


def holm(probabilities):
    """For hypotheses declared before the runs: chances to be wrong about any of them at all."""
    return _adjusted(probabilities, "holm")


def benjamini_hochberg(probabilities):
    """For looking around: shares of the discoveries that may be false."""
    return _adjusted(probabilities, "fdr_bh")


def _adjusted(probabilities, method):
    """NaN, a question that could not be asked, stays and does not count."""
    values = np.asarray(probabilities, float)
    asked = ~np.isnan(values)
    result = np.full(values.shape, np.nan)
    if asked.any():
        result[asked] = multipletests(values[asked], method=method)[1]
    return result
