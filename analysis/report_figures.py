# SPDX-License-Identifier: BSD-3-Clause
"""Figures as data: the page draws them (analysis/viewer/src/charts). Each has panels: all groups together, then each."""

import numpy as np
import pandas
import report_phase
from inference import profiles, survival

POINTS = 120  # of one curve
PANELS = 60  # of one figure; groups beyond have tables only


def panels(runs):
    """(name, runs) for all groups together and for each of the first ones."""
    yield "all groups", runs
    groups = list(runs.groupby("group", sort=False))
    if len(groups) > 1:
        yield from groups[:PANELS]


def incidence(runs):
    """Share of runs solved by a CPU time. \\return times and shares, rising"""
    return rises_of(survival.observations(runs, float(runs["limit_s"].min())))


def effort(runs):
    """The same by evaluations: a timeout is censored at those it had made, any other failure never solves."""
    runs = runs[runs["evaluations"].notna()]
    ends = runs["solved"] | (runs["outcome"] == survival.CENSORED)
    times = runs["evaluations"].where(ends, runs["evaluations"].max())
    return rises_of(pandas.DataFrame({"time": times.clip(lower=1.0), "solved": runs["solved"]}))


def rises_of(observations):
    estimate = survival.kaplan_meier(observations)
    if estimate is None:
        return [], []
    shares = 1.0 - estimate.surv_prob
    rises = np.flatnonzero(np.diff(np.concatenate([[0.0], shares])) > 0.0)
    if len(rises) > POINTS:
        rises = rises[np.unique(np.linspace(0, len(rises) - 1, POINTS).astype(int))]
    return short(estimate.surv_times[rises]), short(shares[rises])


def short(values):
    return [float(f"{value:.4g}") for value in values]


def curves(runs, of, end):
    series = []
    for planner, part in runs.groupby("planner", sort=False):
        x, y = of(part)
        series.append({"name": planner, "ours": bool(part["ours"].iloc[0]), "x": x, "y": y})
    return {"series": series, "end": float(end)}


def profile(runs):
    """Share of instances on which a planner's median time is within a factor of the best one's (Dolan and Moré)."""
    scores = runs.groupby(["experiment", "planner"], sort=False)["score"].median().unstack()
    ratios = profiles.performance_ratios(scores)
    ours = runs.groupby("planner", sort=False)["ours"].first()
    series = []
    for planner in ratios.columns:
        entered = scores[planner].notna().sum()
        values = np.sort(ratios[planner][np.isfinite(ratios[planner])].to_numpy())
        x, counts = np.unique(values, return_counts=True)
        y = np.cumsum(counts) / entered
        series.append({"name": planner, "ours": bool(ours[planner]), "x": short(x), "y": short(y)})
    return {"series": series, "end": max((line["x"][-1] for line in series if line["x"]), default=1.0)}


def figure(name, title, kind, note, x, y, made):
    return {"id": name, "title": title, "kind": kind, "note": note, "x": x, "y": y, "panels": made}


def intervals(rows):
    """\\param rows of report_tables.row_of"""
    keys = ("planner", "ours", "share", "low", "high", "solved", "runs")
    return {"rows": [{key: row[key] for key in keys} for row in rows]}


def heat(rows):
    """Median CPU milliseconds and shares by group and planner."""
    groups = list(dict.fromkeys(row["group"] for row in rows))
    planners = list(dict.fromkeys(row["planner"] for row in rows))
    cells = {(row["group"], row["planner"]): row for row in rows}
    table = [[cells.get((group, planner)) for planner in planners] for group in groups]
    return {
        "rows": groups,
        "columns": planners,
        "shares": [[None if cell is None else round(cell["share"], 4) for cell in line] for line in table],
        "values": [
            [None if cell is None or cell["cpu"] is None else 1e3 * cell["cpu"] for cell in line] for line in table
        ],
    }


def all_figures(runs, rows, totals, reasons):
    """\\param rows, totals, reasons what report_tables says of the runs"""
    of_group = {"all groups": totals}
    for row in rows:
        of_group.setdefault(row["group"], []).append(row)
    parts = list(panels(runs))
    named = lambda make: [{"name": name, **make(name, part)} for name, part in parts]
    figures = [
        figure(
            "success",
            "Share of runs solved",
            "intervals",
            "Wilson's 95 % intervals. Solved: an exact path that the verifier accepts.",
            "share of runs",
            "",
            named(lambda name, _: intervals(of_group[name])),
        ),
        figure(
            "time",
            "Solved by a CPU time",
            "steps",
            "Kaplan and Meier's estimate: timeouts are censored, every other end without a path counts as never.",
            "CPU seconds",
            "share of runs",
            named(lambda _, part: curves(part, incidence, part["limit_s"].max())),
        ),
        figure(
            "effort",
            "Solved by a number of evaluations",
            "steps",
            "The same on an axis that no machine has a part in: configurations examined, and evaluations of a homotopy.",
            "evaluations",
            "share of runs",
            named(lambda _, part: curves(part, effort, np.nanmax([1.0, *part["evaluations"]]))),
        ),
        figure(
            "profile",
            "Performance profile",
            "steps",
            "Share of instances on which a planner's median time is within a factor of the best planner's. The ratios depend on who took part.",
            "times the best planner's CPU time",
            "share of instances",
            named(lambda _, part: profile(part)),
        ),
        figure(
            "ends",
            "How runs ended",
            "stacked",
            "Outcomes, with the planner's own reason where it names one.",
            "share of runs",
            "",
            [
                {
                    "name": "all groups",
                    "rows": [{"planner": planner, "counts": counts} for planner, counts in reasons.items()],
                }
            ],
        ),
        figure(
            "heat",
            "Median CPU time, group by planner",
            "heat",
            "Milliseconds, over solved runs; paler where fewer than all runs were solved.",
            "",
            "",
            [{"name": "all groups", **heat(rows)}],
        ),
    ]
    costs = report_phase.cost_panels(runs, {"cpu": "CPU seconds", "evaluations": "evaluations"})[:PANELS]
    if costs:
        figures.insert(
            4,
            figure(
                "cost",
                "Cost over width",
                "trend",
                "Medians; a run without a path counts as dearer than all, so a line ends where half of the runs are missing.",
                "half width",
                "median cost",
                costs,
            ),
        )
    leads = report_phase.lead_panels(runs)
    if leads:
        figures.insert(
            2,
            figure(
                "lead",
                "Where sampling planners are first",
                "phase",
                "Share of scenes in which the fastest sampling planner has its path before the fastest planner that sees the "
                "model; scenes that nobody solved are left out. The line is where a logistic model gives each kind half, with "
                "its 95 % band: to its right sampling is ahead.",
                "half width",
                "links",
                leads,
            ),
        )
    phases = report_phase.panels(runs)[:PANELS]
    if phases:
        figures.insert(
            2,
            figure(
                "phase",
                "Success over width and links",
                "phase",
                "Share of runs solved by half width of the passage and number of links. The line is where a logistic model has "
                "half of the runs solved, with its 95 % band (clusters of instances).",
                "half width",
                "links",
                phases,
            ),
        )
    return figures
