# SPDX-License-Identifier: BSD-3-Clause
"""Who was ahead: the best planner that sees the model against the best that samples, group by group.

Planners with a recipe that the scenario prescribes take no part. Each side's best is the entry that solves most, then the
fastest; both are picked on the runs that are judged, which flatters the side with more entries. Time to a verified path
is compared, never where there is none. With at least PAIRS instances in a group the pairs are instances (their medians; a
sign test), else all runs of the group are ranked (Mann and Whitney). Holm's correction over the groups.
"""

from dataclasses import asdict, dataclass

import numpy as np
from inference import multiplicity
from scipy import stats

LEVEL = 0.05
PAIRS = 6  # below this many, no sign test can reach the level


@dataclass
class Contest:
    group: str
    ours: str
    theirs: str
    ours_solved: float  # share of the runs
    theirs_solved: float
    ours_cpu: float | None  # median seconds over solved runs
    theirs_cpu: float | None
    pairs: int  # instances if they are paired, else 0
    p: float
    winner: str = "undecided"  # or "ours" or "theirs"
    adjusted: float = 1.0

    @property
    def lead(self):
        """How many times faster the model planner was, None if one of the two solved nothing."""
        return self.theirs_cpu / self.ours_cpu if self.ours_cpu and self.theirs_cpu else None


def best(runs):
    """The entry's runs that lead one side of a group, None if the side did not run."""
    entries = [part for _, part in runs.groupby("planner", sort=False)]
    return min(entries, key=lambda part: (-part["solved"].mean(), part["score"].median()), default=None)


def sign_of(ours, theirs):
    """+1 where ours is sooner, -1 where later, 0 where neither is; infinite scores are equal."""
    return np.where(ours < theirs, 1, 0) - np.where(ours > theirs, 1, 0)


def compare(ours, theirs):
    """\\return pairs, p, and which way the difference points (+1: ours sooner)"""
    a = ours.groupby("experiment")["score"].median()
    b = theirs.groupby("experiment")["score"].median()
    common = a.index.intersection(b.index)
    if len(common) >= PAIRS:
        signs = sign_of(a[common].to_numpy(), b[common].to_numpy())
        wins, losses = int(np.sum(signs > 0)), int(np.sum(signs < 0))
        p = stats.binomtest(wins, wins + losses).pvalue if wins + losses else 1.0
        return len(common), float(p), int(np.sign(wins - losses))
    # Ranks only: what was never solved comes after everything that was.
    x, y = (np.nan_to_num(part["score"].to_numpy(), posinf=1e300) for part in (ours, theirs))
    if np.ptp(np.concatenate([x, y])) == 0.0:
        return 0, 1.0, 0
    test = stats.mannwhitneyu(x, y, alternative="two-sided")
    return 0, float(test.pvalue), int(np.sign(len(x) * len(y) / 2.0 - test.statistic))


def median_cpu(runs):
    solved = runs.loc[runs["solved"], "cpu"]
    return float(solved.median()) if len(solved) else None


def contests(runs):
    """\\return one per group in which both sides ran"""
    found, directions = [], []
    for group, part in runs[~runs["prescribed"]].groupby("group", sort=False):
        ours, theirs = best(part[part["ours"]]), best(part[~part["ours"]])
        if ours is None or theirs is None:
            continue
        pairs, p, direction = compare(ours, theirs)
        names = ours["planner"].iloc[0], theirs["planner"].iloc[0]
        shares = float(ours["solved"].mean()), float(theirs["solved"].mean())
        found.append(Contest(group, *names, *shares, median_cpu(ours), median_cpu(theirs), pairs, p))
        directions.append(direction)
    if found:
        adjusted = multiplicity.holm([contest.p for contest in found])
        for contest, direction, value in zip(found, directions, adjusted):
            contest.adjusted = float(value)
            if value < LEVEL and direction:
                contest.winner = "ours" if direction > 0 else "theirs"
    return found


def count(found, winner):
    return sum(contest.winner == winner for contest in found)


def headline(found, runs):
    if not found and runs["ours"].nunique() == 2:
        return "No verdict: one kind of planner ran with prescribed recipes only, or elsewhere than the other"
    if not found:
        return "No verdict: only one kind of planner ran"
    ours, theirs = count(found, "ours"), count(found, "theirs")
    if ours and not theirs:
        return "Planners that see the model are ahead" + (
            " everywhere" if ours == len(found) else " wherever it is decided"
        )
    if theirs and not ours:
        return "Sampling planners are ahead" + (" everywhere" if theirs == len(found) else " wherever it is decided")
    if not ours and not theirs:
        return "Undecided: the runs do not tell the two kinds of planners apart"
    return "Neither kind of planner is ahead everywhere"


def as_row(contest):
    return {**asdict(contest), "lead": contest.lead}
