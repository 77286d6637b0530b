# SPDX-License-Identifier: BSD-3-Clause
"""The verdict in words. Every number in it comes from the tables."""

import report_phase
from inference import success
from report_verdict import count, headline

SIDES = {"ours": "theirs", "theirs": "ours"}
KIND = {"ours": "planners that see the model", "theirs": "planners that sample"}


def brief(value):
    """Two digits that count, without an exponent."""
    return f"{float(f'{value:.2g}'):.12g}"


def percent(share):
    return f"{100.0 * share:.1f}\u00a0%"


def counted(number, one, many):
    return f"{number} {one if number == 1 else many}"


def sizes(runs):
    entries = counted(runs["planner"].nunique(), "planner entry", "planner entries")
    instances = counted(runs["experiment"].nunique(), "instance", "instances")
    groups = counted(runs["group"].nunique(), "group", "groups")
    return (
        f"{counted(len(runs), 'run', 'runs')} of {entries} on {instances} in {groups}: "
        f"{int(runs['solved'].sum())} ended with a path that the verifier accepts."
    )


def score(found):
    return (
        f"Best against best, the planner that sees the model was ahead in {count(found, 'ours')} of "
        f"{counted(len(found), 'group', 'groups')}, the one that samples in {count(found, 'theirs')}, and "
        f"{count(found, 'undecided')} stayed undecided (5\u00a0% level, Holm's correction)."
    )


def side(contest, name):
    """A planner and how it did: "hppm (100.0 %, 0.3 ms)"."""
    cpu = getattr(contest, name + "_cpu")
    if cpu is None:
        return f"{KIND[name]} (none solved)"  # then none of them: the best had no path
    return f"{getattr(contest, name)} ({percent(getattr(contest, name + '_solved'))}, {brief(1000.0 * cpu)}\u00a0ms)"


def margin(contest, name):
    """How clear one side's lead is: first by what it solves more, then by how much faster it is."""
    more = getattr(contest, name + "_solved") - getattr(contest, SIDES[name] + "_solved")
    lead = contest.lead or 1.0
    return round(more, 2), lead if name == "ours" else 1.0 / lead


def clearest(found, name):
    """A sentence on one side's clearest lead, nothing if it won no group."""
    won = [contest for contest in found if contest.winner == name]
    if not won:
        return ""
    contest = max(won, key=lambda contest: margin(contest, name))
    return (
        f"The clearest lead of {KIND[name]} is in {contest.group}: {side(contest, name)} against "
        f"{side(contest, SIDES[name])}, shares solved and median CPU times of solved runs."
    )


def overall(totals):
    """Who solved the largest share on each side, with its interval. \\param totals rows of report_tables.over_all"""
    parts = []
    for ours, kind in ((True, KIND["ours"]), (False, KIND["theirs"])):
        rows = [row for row in totals if row["ours"] == ours and not row["prescribed"]]
        if rows:
            top = max(rows, key=lambda row: row["share"])
            parts.append(
                f"of {kind}, {top['planner']} solved most: {percent(top['share'])} of {top['runs']} runs "
                f"(95\u00a0% interval {percent(top['low'])} to {percent(top['high'])})"
            )
    return "Over all groups, " + "; ".join(parts) + "." if parts else ""


def resolution(totals):
    """What so many runs can tell apart."""
    rows = [row for row in totals if not row["prescribed"]]
    if not rows:
        return ""
    top = max(rows, key=lambda row: (row["share"], row["runs"]))
    drop = success.detectable_difference(top["share"], top["runs"])
    if not drop > 0.0:
        return f"{counted(top['runs'], 'run', 'runs')} of an entry are too few to tell success rates apart."
    return (
        f"With {top['runs']} independent runs an entry, success rates that differ by {brief(100.0 * drop)} points or more would be "
        "told apart four times in five; what differs by less may look equal here."
    )


def border(family, rows, line):
    """Up to where sampling is ahead. \\param line (half width, low, high) for each number of links"""
    parts = [
        f"{brief(width)} ({brief(low)} to {brief(high)}) with {links} links"
        for links, (width, low, high) in zip(rows, line)
    ]
    return f"In {family} a sampling planner is first in most scenes at half widths above " + "; ".join(parts) + "."


def regions(panels):
    """Sentences on where which kind of planner is first. \\param panels of report_phase.lead_panels"""
    for panel in panels:
        if panel["line"]:
            yield border(panel["name"], panel["rows"], panel["line"])
            continue
        cells = [cell for pair in zip(panel["shares"], panel["runs"]) for cell in zip(*pair) if cell[0] is not None]
        share = sum(share * runs for share, runs in cells) / sum(runs for _, runs in cells)
        yield f"In {panel['name']} a sampling planner is first in {percent(share)} of scenes, without a clear border in width."


def promised(decisions):
    """What became of the hypotheses that were declared."""
    if not decisions:
        return ""
    count = {verdict: sum(decision.verdict == verdict for decision in decisions) for verdict in ("confirmed", "refuted")}
    rest = len(decisions) - sum(count.values())
    return (
        f"Of {counted(len(decisions), 'hypothesis', 'hypotheses')} declared before the first run {count['confirmed']} came out "
        f"confirmed, {count['refuted']} refuted and {rest} undecided."
    )


def verdict(runs, found, totals, decisions=(), untouched=0):
    """\\return the headline the paragraph's sentences, and what to bear in mind with it"""
    sentences = [promised(decisions)]
    sentences += [score(found), clearest(found, "ours"), clearest(found, "theirs")] if found else []
    sentences += [*regions(report_phase.lead_panels(runs)), overall(totals), sizes(runs)]
    notes = [resolution(totals)]
    if untouched:
        missing = counted(untouched, "instance has", "instances have")
        notes.insert(0, f"The campaign is not complete: {missing} no runs yet. Verdicts count only once all are done.")
    if runs["prescribed"].any():
        notes.append("Entries marked * use the recipe that the scenario prescribes; they take no part in the verdict.")
    kept = {"sentences": sentences, "notes": notes}
    return {"headline": headline(found, runs), **{name: [text for text in part if text] for name, part in kept.items()}}
