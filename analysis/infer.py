#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What the runs of a campaign say, with how surely they say it (Markdown; docs/statistics.md).

  infer.py RESULTS.db [--seed 1]
  infer.py RESULTS.db --planner hppm [--against LABEL]... [--group TEXT] [--level 0.95] [--seed 1]

The first decides the hypotheses that the experiment file declared, exactly these, by Holm's method at their level, and says
how the machine's speed drifted. The second looks around: what it finds is exploratory, to be declared and tested on new scenes.
Per group of scenes: how often each planner solves, how soon, and how `--planner` compares with each of the others instance
by instance. Probabilities are adjusted by Holm's method over all comparisons asked for by `--against`, by Benjamini and
Hochberg's over all there are if none was asked for.
"""

import argparse
import sys

import numpy as np
import report_rows
from inference import declared, multiplicity, paired, success, survival, trends


def number(value):
    """Three digits that count."""
    return "-" if np.isnan(value) else "never" if np.isinf(value) else f"{float(f'{value:.3g}'):.12g}"


def within(estimate):
    """Milliseconds with their interval."""
    return f"{number(1e3 * estimate.value)} ({number(1e3 * estimate.low)} to {number(1e3 * estimate.high)})"


def planner_rows(group, runs, level):
    limit = runs["limit_s"].min()
    for planner, rows in runs.groupby("planner", sort=True):
        times = survival.observations(rows, limit)
        solved, count = int(times["solved"].sum()), len(times)
        low, high = success.interval(solved, count, level)
        loss = success.detectable_difference(solved / count, count)
        yield (f"| {group} | {planner} | {solved}/{count} | {100 * low:.1f} to {100 * high:.1f} | "
               f"{'-' if np.isnan(loss) else f'{100 * loss:.1f}'} | {within(survival.median(times, level))} | "
               f"{within(survival.restricted_mean(times, limit, level))} |")


def comparisons(groups, planner, rivals, level, generator):
    """\\return (group, rival, comparison, log-rank probability) for every rival that shares instances with the planner"""
    found = []
    for group, runs in groups:
        present = set(runs["planner"])
        if planner not in present:
            continue
        limit = runs["limit_s"].min()
        for rival in sorted(present - {planner}) if not rivals else [r for r in rivals if r in present]:
            both = runs[runs["planner"].isin([planner, rival])]
            times = survival.observations(both, limit)
            rank = survival.log_rank(times, both["planner"], both["instance"])[1] if times["solved"].any() else np.nan
            found.append((group, rival, paired.compare(runs, planner, rival, limit, generator, level), rank))
    return found


def comparison_rows(found, adjust):
    times = adjust([comparison.time_p for _, _, comparison, _ in found])
    shares = adjust([comparison.success_p for _, _, comparison, _ in found])
    ranks = adjust([rank for _, _, _, rank in found])
    for (group, rival, comparison, _), time_p, success_p, rank_p in zip(found, times, shares, ranks):
        yield (f"| {group} | {rival} | {comparison.instances} | {comparison.only_first} : {comparison.only_second} | "
               f"{number(success_p)} | {number(comparison.ratio)} ({number(comparison.ratio_low)} to "
               f"{number(comparison.ratio_high)}) | {number(time_p)} | {number(rank_p)} |")


def decision_rows(decisions):
    yield "| hypothesis | verdict | p (Holm) | instances | what it hangs on |"
    yield "|---|---|---:|---:|---|"
    for decision in decisions:
        claim = decision.crucial
        what = f"{claim.instances} | `{claim.planner}` and {claim.rival}: {claim.effect}" if claim else "0 | no runs yet"
        yield (f"| {decision.name}: {decision.statement} | **{decision.verdict}** | {number(decision.adjusted)} | {what} |")


def machine(canaries):
    if len(canaries) < 3:
        return "Drift of the machine's speed: not watched (`canary`)."
    drift = trends.drift(canaries["cpu"])
    same = "always the same checks" if canaries["checks"].nunique() == 1 else "NOT the same checks: another program"
    return (f"Canary: {drift.runs} runs, {same}; median {number(1e3 * drift.median)} ms, quartiles "
            f"{number(1e3 * drift.low)} and {number(1e3 * drift.high)}; from first to last its time changed by a factor of "
            f"{number(drift.change)} ({number(drift.change_low)} to {number(drift.change_high)}).")


def declared_report(campaign, seed):
    if campaign.hypotheses:
        yield from decision_rows(declared.decide(campaign.hypotheses, campaign.runs, np.random.default_rng(seed)))
    else:
        yield "No hypothesis was declared: all there is to see is exploratory (`--planner`)."
    yield ""
    if campaign.untouched:
        yield f"NOT COMPLETE: {campaign.untouched} instances have no runs yet. These verdicts count only once all are done."
        yield ""
    yield machine(campaign.canaries)


def report(campaign, options):
    runs = campaign.runs.assign(instance=campaign.runs["experiment"])
    groups = [(name, rows) for name, rows in runs.groupby("group", sort=False) if options.group in name]
    yield "| scenes | planner | solved | % | finds a loss of % | median ms | mean ms up to the limit |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    for name, rows in groups:
        yield from planner_rows(name, rows, options.level)
    generator = np.random.default_rng(options.seed)
    found = comparisons(groups, options.planner, options.against, options.level, generator)
    yield ""
    yield f"| `{options.planner}` on | against | instances | solves alone | p | mean time ratio | p | log-rank p |"
    yield "|---|---|---:|---:|---:|---:|---:|---:|"
    yield from comparison_rows(found, multiplicity.holm if options.against else multiplicity.benjamini_hochberg)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    parser.add_argument("--planner", help="look around: label of the planner that the others are compared with")
    parser.add_argument("--against", action="append", default=[], help="a declared comparison; may be repeated")
    parser.add_argument("--group", default="", help="only groups of scenes whose name has this in it")
    parser.add_argument("--level", type=float, default=0.95, help="of intervals")
    parser.add_argument("--seed", type=int, default=1, help="of the bootstrap")
    options = parser.parse_args(arguments)
    try:
        campaign = report_rows.read_campaign(options.database)
    except ValueError as error:
        print(error, file=sys.stderr)
        return 2
    for line in report(campaign, options) if options.planner else declared_report(campaign, options.seed):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
