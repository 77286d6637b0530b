# SPDX-License-Identifier: BSD-3-Clause
"""Hypotheses that a campaign declared before its first run (docs/experiments.md): confirmed, refuted, or undecided.

A hypothesis says of one or several planners that a quantity is more, or less, than that of each of their rivals, or than a
bound. It is confirmed only if every such claim holds (intersection-union test: the largest of the probabilities), and
refuted as soon as one fails clearly (union-intersection test: the smallest, times their number). Which of the two is
nearer is decided two-sidedly, and Holm's method allows for all hypotheses of the campaign at once.
"""

from dataclasses import dataclass

import numpy as np
from scipy import stats

from . import multiplicity, paired, success

COLUMNS = {"evaluations": "evaluations", "memory": "memory", "length": "length"}  # quantity: column of the runs


@dataclass
class Claim:
    """One planner against one rival, or against a bound."""

    planner: str
    rival: str  # or the bound
    instances: int
    effect: str
    p_for: float  # of so much evidence for the claim, or more, were it not so
    p_against: float


@dataclass
class Decision:
    name: str
    statement: str
    verdict: str  # confirmed | refuted | undecided
    p: float  # two-sided, of this hypothesis alone
    adjusted: float  # over all hypotheses of the campaign
    claims: list

    @property
    def crucial(self):
        """The claim that the verdict hangs on, nothing if there are no runs yet."""
        key = (lambda claim: claim.p_against) if self.verdict == "refuted" else (lambda claim: -claim.p_for)
        return min(self.claims, key=key, default=None)


def short(value):
    return f"{float(f'{value:.3g}'):.12g}"


def sides(test, more):
    """\\param test gives the probability of a one-sided alternative, "greater" or "less"
    \\return for and against the claim"""
    greater, less = float(test("greater")), float(test("less"))
    return (greater, less) if more else (less, greater)


def values(runs, planner, quantity):
    """Medians over solved runs, by instance."""
    rows = runs[(runs["label"] == planner) & runs["solved"].astype(bool)]
    return rows.groupby("instance")[COLUMNS[quantity]].median().dropna()


def ranks(difference, more):
    """Wilcoxon's signed ranks; instances without a difference say nothing."""
    difference = difference[difference != 0.0]
    if difference.size == 0:
        return 1.0, 1.0
    return sides(lambda side: stats.wilcoxon(difference, alternative=side).pvalue, more)


def counts(successes, trials, share, more):
    """The exact binomial test."""
    if trials == 0:
        return 1.0, 1.0
    return sides(lambda side: stats.binomtest(successes, trials, share, alternative=side).pvalue, more)


def against_rival(runs, planner, rival, quantity, more, limit, generator):
    if quantity in COLUMNS:
        both = (
            np.log(values(runs, planner, quantity))
            .to_frame("a")
            .join(np.log(values(runs, rival, quantity)).rename("b"), how="inner")
        )
        difference = (both["a"] - both["b"]).to_numpy()
        ratio = short(np.exp(np.median(difference))) if len(both) else "-"
        return Claim(planner, rival, len(both), f"median ratio {ratio}", *ranks(difference, more))
    named = runs.assign(planner=runs["label"])
    first, second = (paired.by_instance(named, label, limit) for label in (planner, rival))
    table = first.join(second, how="inner", lsuffix="_1", rsuffix="_2")
    if quantity == "success":
        only_first = int((table["solved_1"] & ~table["solved_2"]).sum())
        only_second = int((~table["solved_1"] & table["solved_2"]).sum())
        effect = f"{int(table['solved_1'].sum())} solved : {int(table['solved_2'].sum())}, alone {only_first} : {only_second}"
        return Claim(planner, rival, len(table), effect, *counts(only_first, only_first + only_second, 0.5, more))
    ratio, low, high = paired.mean_ratio(table["time_2"], table["time_1"], generator)
    difference = np.log(table["time_1"].to_numpy()) - np.log(table["time_2"].to_numpy())
    middle = short(np.exp(np.median(difference)))
    effect = f"median ratio {middle}, of means {short(ratio)} ({short(low)} to {short(high)})"
    return Claim(planner, rival, len(table), effect, *ranks(difference, more))


def against_bound(runs, planner, quantity, bound, more, limit):
    """Shares of instances: solved ones against a bound that is a share, else those above the bound against a half."""
    if quantity in COLUMNS:
        found = values(runs, planner, quantity)
        above, count, share = int((found > bound).sum()), int((found != bound).sum()), 0.5
        effect = f"median {short(found.median())}, {above} of {count} above" if count else "none solved"
        return Claim(planner, short(bound), count, effect, *counts(above, count, share, more))
    table = paired.by_instance(runs.assign(planner=runs["label"]), planner, limit)
    if quantity == "time":
        above = int((~table["solved"] | (table["time"] > bound)).sum())
        effect = f"median {short(table['time'].median())} s, {above} of {len(table)} above"
        return Claim(planner, short(bound), len(table), effect, *counts(above, len(table), 0.5, more))
    solved = int(table["solved"].sum())
    low, high = success.interval(solved, len(table), method="clopper_pearson")
    effect = f"{solved} of {len(table)} solved ({100 * low:.1f} to {100 * high:.1f} %)"
    return Claim(planner, short(bound), len(table), effect, *counts(solved, len(table), bound, more))


def claims(hypothesis, runs, generator):
    runs = runs[runs["full_group"].isin(hypothesis["groups"])]
    if runs.empty:
        return
    limit, more, quantity = runs["limit_s"].min(), hypothesis["direction"] == "more", hypothesis["quantity"]
    for planner in hypothesis["planners"]:
        if "bound" in hypothesis:
            yield against_bound(runs, planner, quantity, hypothesis["bound"], more, limit)
        for rival in hypothesis["against"]:
            yield against_rival(runs, planner, rival, quantity, more, limit, generator)


def decide(hypotheses, runs, generator):
    """\\param hypotheses dictionaries as the database keeps them
    \\param runs table with `instance`, `full_group`, `label`, `solved`, `cpu`, `limit_s`, `evaluations`, `memory`, `length`
    \\return a decision for each, at the level that they name"""
    if not hypotheses:
        return []
    found = [list(claims(hypothesis, runs, generator)) for hypothesis in hypotheses]
    for_all = [max((claim.p_for for claim in part), default=1.0) for part in found]
    against = [min([1.0, *(len(part) * claim.p_against for claim in part)]) for part in found]
    probabilities = [min(1.0, 2.0 * min(pair)) for pair in zip(for_all, against)]
    decisions = []
    for index, adjusted in enumerate(multiplicity.holm(probabilities)):
        hypothesis = hypotheses[index]
        verdict = "undecided"
        if adjusted <= hypothesis["alpha"]:
            verdict = "confirmed" if for_all[index] < against[index] else "refuted"
        decisions.append(
            Decision(
                hypothesis["name"],
                hypothesis["statement"],
                verdict,
                probabilities[index],
                float(adjusted),
                found[index],
            )
        )
    return decisions
