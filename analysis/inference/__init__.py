# SPDX-License-Identifier: BSD-3-Clause
"""What may be concluded from the runs of a campaign, and how surely.

success       how often: intervals, and what difference so many runs can show
survival      how soon: timeouts are censored, failures never happen
paired        two planners on the same instances
multiplicity  many questions asked at once
profiles      many planners over many instances (Dolan and More)
declared      hypotheses that were declared before the runs
trends        success and cost against width and degrees of freedom; drift of the machine's speed

Everything random takes a numpy Generator, so that the same seed says the same. What pandas, scipy and statsmodels have is
taken from there. docs/statistics.md says why these methods and not others.
"""
