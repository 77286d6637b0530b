# SPDX-License-Identifier: BSD-3-Clause
"""Where planners stop solving: success over the width of a passage and the number of links, as sweeps name them."""

import re
import warnings

import numpy as np
import pandas
from inference import trends
from statsmodels.tools.sm_exceptions import ConvergenceWarning

WIDTHS = ("half_width", "clearance")  # what families call the width of their passage (half of it)
SWEPT = re.compile(r"_(?P<name>" + "|".join(WIDTHS) + r")(?P<width>[0-9.]+(?:e[-+]?[0-9]+)?)(?=_|$)")
LINKS = re.compile(r"_links(?P<links>[0-9]+)(?=_|$)")


def placed(runs):
    """The runs whose group names a swept width, with `family`, `half_width` and `links` (0 where these are not swept)."""
    groups = pandas.Series(runs["group"].unique())
    swept, links = groups.str.extract(SWEPT), groups.str.extract(LINKS)
    table = pandas.DataFrame(
        {
            "group": groups,
            "half_width": pandas.to_numeric(swept["width"]),
            "links": pandas.to_numeric(links["links"]).fillna(0).astype(int),
            "family": [re.sub(LINKS, "", re.sub(SWEPT, "", group)) for group in groups],
        }
    ).dropna()
    return runs.merge(table, on="group")


def share(runs):
    return None if len(runs) == 0 else round(float(runs["solved"].mean()), 4)


def line_of(runs, rows):
    """The half widths at which half of the runs are solved, with 95 % bands, one per number of links; or why not."""
    # What is warned of comes back as a failure with a name.
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore", ConvergenceWarning)
        phase = trends.phase_line(runs["solved"], runs["half_width"], runs["links"], runs["instance"])
    if phase.failure:
        return [], phase.failure
    with np.errstate(over="ignore", invalid="ignore"):
        values = np.array(phase.half_width(rows)).T
    if not np.all(np.isfinite(values)) or not np.all(values > 0.0):
        return [], "separated"
    return [[float(f"{value:.4g}") for value in row] for row in values], ""


def panel(name, runs):
    """One planner in one family; None where less than two widths were tried."""
    columns, rows = sorted(runs["half_width"].unique()), sorted(int(links) for links in runs["links"].unique())
    if len(columns) < 2:
        return None
    cell = lambda links, width: runs[(runs["links"] == links) & (runs["half_width"] == width)]
    # With one number of links its coefficient has nothing to go by.
    line, failure = line_of(runs, rows) if len(rows) > 1 else ([], "one_row")
    return {
        "name": name,
        "rows": rows,
        "columns": columns,
        "shares": [[share(cell(links, width)) for width in columns] for links in rows],
        "runs": [[len(cell(links, width)) for width in columns] for links in rows],
        "line": line,
        "failure": failure,
    }


def panels(runs):
    """A panel per family and planner, the families in the order of the runs."""
    made = [
        panel(f"{family}: {planner}", part)
        for (family, planner), part in placed(runs).groupby(["family", "planner"], sort=False)
    ]
    return [one for one in made if one is not None]


def fastest(runs):
    """Least CPU seconds to a path, by instance; infinite where no planner has one."""
    return runs.groupby("experiment")["score"].min()


def leads(runs):
    """A row per instance that both kinds of planners ran on and either solved: `solved` says that a sampling planner was
    first. The fastest of each kind stands for it, which favours the kind with more entries."""
    runs = placed(runs[~runs["prescribed"]])
    ours, theirs = fastest(runs[runs["ours"]]), fastest(runs[~runs["ours"]])
    both = pandas.DataFrame({"ours": ours, "theirs": theirs}).dropna()
    both = both[np.isfinite(both.min(axis=1))]
    places = runs.drop_duplicates("experiment").set_index("experiment")[["family", "half_width", "links", "instance"]]
    return both.assign(solved=both["theirs"] < both["ours"]).join(places, how="inner")


def lead_panels(runs):
    """A panel per family: the share of scenes that a sampling planner is first in."""
    found = leads(runs)
    made = [panel(family, part) for family, part in found.groupby("family", sort=False)] if len(found) else []
    return [one for one in made if one is not None]


def cost_line(planner, runs, cost):
    """Medians by half width, runs without a path counting as dearer than all: none where half or more are missing."""
    medians = runs[cost].astype(float).where(runs["solved"], np.inf).groupby(runs["half_width"]).median()
    finite = medians[np.isfinite(medians)]
    numbers = lambda values: [float(f"{value:.4g}") for value in values]
    return {"name": planner, "ours": bool(runs["ours"].iloc[0]), "x": numbers(finite.index), "y": numbers(finite)}


def cost_panels(runs, costs):
    """A panel per family, number of links and cost, of those whose width was swept.

    \\param costs titles by column of the runs
    """
    made = []
    for (family, links), part in placed(runs).groupby(["family", "links"], sort=False):
        if part["half_width"].nunique() < 2:
            continue
        where = f"{family}, {links} links" if links else family
        for column, title in costs.items():
            known = part[part[column].notna()]
            lines = [cost_line(planner, mine, column) for planner, mine in known.groupby("planner", sort=False)]
            made.append({"name": f"{where}: {title}", "series": lines})
    return made
