# SPDX-License-Identifier: BSD-3-Clause
"""Tables beyond the summary: declared hypotheses, how cost grows as passages close, path quality."""

import warnings

import numpy as np
import report_phase
import report_quality
from inference import trends

COSTS = {"cpu": "CPU time", "evaluations": "evaluations"}


def table(name, title, note, columns, rows):
    """\\param columns titles, or (title, hint)"""
    heads = [
        {"title": column} if isinstance(column, str) else dict(zip(("title", "hint"), column)) for column in columns
    ]
    return {"id": name, "title": title, "note": note, "columns": heads, "rows": rows}


def hypotheses(decisions):
    rows = []
    for decision in decisions:
        claim = decision.crucial
        what = f"{claim.planner} and {claim.rival}: {claim.effect}" if claim else "no runs yet"
        rows.append(
            [
                decision.name,
                decision.statement,
                decision.verdict,
                decision.adjusted,
                claim.instances if claim else 0,
                what,
            ]
        )
    return table(
        "hypotheses",
        "Declared before the first run",
        "Exactly these were declared, and stored with their SHA-256, before the first run; everything else on this page is "
        "exploratory. Against several planners a hypothesis must hold for each. Holm's method over all of them.",
        [
            "Name",
            "Hypothesis",
            "Verdict",
            "p (Holm)",
            "Scenes",
            ("What it hangs on", "the comparison nearest to failing"),
        ],
        rows,
    )


def slope_row(family, planner, runs, column):
    cost = runs[column].where(runs["solved"]).to_numpy(float)
    try:
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            slope = trends.cost_slope(cost, runs["half_width"], runs["experiment"])
    except ValueError:
        return None
    return [family, planner, COSTS[column], slope.exponent, slope.low, slope.high, slope.solved, slope.unsolved]


def slopes(runs):
    """Cost ~ width^exponent by family and planner; nothing where no width was swept."""
    rows = []
    for (family, planner), part in report_phase.placed(runs).groupby(["family", "planner"], sort=False):
        rows += [slope_row(family, planner, part, column) for column in COSTS]
    return table(
        "slopes",
        "How cost grows as passages close",
        "Cost ~ half width to this power, over solved runs (clusters of scenes allowed for). Where runs are missing because "
        "they were not solved, those would have cost most: the exponent is then too close to 0.",
        [
            "Family",
            "Planner",
            "Cost",
            "Exponent",
            "95 % from",
            "to",
            "Solved",
            ("Missing", "runs that were not solved"),
        ],
        [row for row in rows if row is not None],
    )


def quality(path, runs):
    table_of = report_quality.by_planner(path, runs)
    return table(
        "quality",
        "Path quality",
        "Medians over solved runs; the last five columns are computed from stored paths of up to 150 scenes. "
        "Turning: sum of the angles between segments in joint space. Classes: ways round the obstacles that are surely "
        "different (turns of every joint, and of every link about every obstacle), of scenes that several planners have "
        "paths for.",
        [
            "Planner",
            "Runs",
            ("Length", "joint space, rad"),
            "Smoothness",
            "Clearance",
            ("Joint step", "largest change of a " "joint between waypoints, rad"),
            ("Paths", "that are stored"),
            ("Tip's way", "length unit of the scenes"),
            ("Turning", "rad"),
            ("Curvature", "turning by the way in joint space"),
            ("Classes", "share of scenes where the path is not in the commonest class"),
        ],
        table_of,
    )


def all_tables(path, runs, decisions):
    """\\return those that have rows"""
    made = [hypotheses(decisions), slopes(runs), quality(path, runs)]
    return [one for one in made if one["rows"]]
