#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""One page of a campaign: verdict, tables, figures and moving arms (docs/report.md).

  report.py RESULTS.db -o DIR      writes DIR/index.html, which needs no other file and no network
"""

import argparse
import html
import json
import math
import sys
from contextlib import closing
from pathlib import Path

import numpy as np
import pandas
from inference import declared

import report_extra
import report_figures
import report_motions
import report_slices
from ompl_log import write_logs
from report_paper import write_paper
from report_prose import verdict
from report_rows import open_database, read_campaign
from report_tables import by_group, over_all, reasons
from report_verdict import as_row, contests

VIEWER = Path(__file__).resolve().parent / "viewer" / "dist"
ROWS = 20000  # runs listed on the page; all count in its numbers

PAGE = """<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="narrows report">
<title>{title}</title>
<link rel="icon" href="data:,">
<style>{style}</style>
</head>
<body>
<main id="page"></main>
<noscript><h1>{title}</h1><p>{summary}</p><p>Tables, figures and motions need JavaScript.</p></noscript>
<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
"""


def finite(value):
    """JSON has no NaN and no infinity: None, what was not measured."""
    if isinstance(value, dict):
        return {key: finite(part) for key, part in value.items()}
    if isinstance(value, (list, tuple)):
        return [finite(part) for part in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value


def embedded(data):
    """JSON that may stand in a script element."""
    text = json.dumps(finite(data), ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c").replace("\u2028", "\\u2028").replace("\u2029", "\\u2029")


def listed(runs):
    """The runs that the page lists: all, or the first of every instance and planner."""
    if len(runs) <= ROWS:
        return runs
    place = runs.groupby(["experiment", "planner"], sort=False).cumcount()
    return runs.assign(place=place).sort_values(["place", "id"]).head(ROWS).sort_values("id")


def digits(values, count):
    return [None if not math.isfinite(value) else float(f"{value:.{count}g}") for value in values]


def columns(runs):
    """Columns with a number for every text, so that the page stays small."""
    result = {"id": runs["id"].tolist(), "run": runs["run"].tolist(), "seed": runs["seed"].tolist()}
    for name in ("instance", "planner", "outcome", "reason"):
        codes, texts = pandas.factorize(runs[name])
        result[name] = {"texts": texts.tolist(), "codes": codes.tolist()}
    for name in ("cpu", "evaluations", "checks", "length", "clearance"):
        result[name] = digits(runs[name].astype(float), 5)
    result["limit"] = runs["limit_s"].tolist()
    result["solved"] = [int(value) for value in runs["solved"]]
    return result


def entries(runs):
    """What every planner entry is."""
    firsts = runs.drop_duplicates("planner")
    return [{"name": row.planner, "ours": bool(row.ours), "settings": row.settings} for row in firsts.itertuples()]


def collect(path, options):
    """All that the page is told."""
    campaign = read_campaign(path)
    runs = campaign.runs
    decisions = declared.decide(campaign.hypotheses, runs, np.random.default_rng(1))
    rows, totals, found = by_group(runs), over_all(runs), contests(runs)
    collection, left_out = report_motions.collect(path, runs, options.motion_megabytes)
    with closing(open_database(path)) as database:
        slices, candidates = report_slices.collect(database, path, collection.motions, options.program, options.slices)
    shown = listed(runs)
    with_motion = {motion["run"] for motion in collection.motions}
    missing = runs[runs["id"].isin(with_motion) & ~runs["id"].isin(shown["id"])]
    shown = pandas.concat([shown, missing]).sort_values("id")
    return {
        "campaign": {"name": campaign.name, "seed": campaign.seed, "engine": campaign.engine, "file": Path(path).name},
        "sessions": campaign.sessions,
        "verdict": verdict(runs, found, totals, decisions, campaign.untouched),
        "contests": [as_row(contest) for contest in found],
        "tables": report_extra.all_tables(path, runs, decisions),
        "entries": entries(runs),
        "groups": rows,
        "totals": totals,
        "runs": columns(shown),
        "figures": report_figures.all_figures(runs, rows, totals, reasons(runs)),
        "scenes": collection.scenes,
        "motions": [{**motion, "slice": slices.get(number)} for number, motion in enumerate(collection.motions)],
        "leftOut": {
            **left_out,
            "runs": len(runs) - len(shown),
            "slices": candidates - len(slices),
            "panels": max(0, runs["group"].nunique() - report_figures.PANELS),
        },
    }


def page(data):
    """The page's text."""
    return PAGE.format(
        title=html.escape(f"{data['campaign']['name']}: report"),
        summary=html.escape(" ".join([data["verdict"]["headline"] + ".", *data["verdict"]["sentences"]])),
        style=(VIEWER / "viewer.css").read_text(encoding="utf-8"),
        data=embedded(data),
        script=(VIEWER / "viewer.js").read_text(encoding="utf-8"),
    )


def write(options):
    """\\return the files that were written"""
    folder = Path(options.output)
    data = collect(options.database, options)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(page(data), encoding="utf-8")
    written = [folder / "index.html"]
    if options.paper:
        written += write_paper(data, folder / "paper")
    if options.ompl_log:
        written += write_logs(options.database, folder / "ompl")
    return written


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("database")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--program", help="narrows itself: traces HPPM's slices again; without it there are none")
    parser.add_argument("--slices", type=int, default=12, help="how many slices (default 12)")
    parser.add_argument("--motion-megabytes", type=float, default=8.0, help="room for motions (default 8)")
    parser.add_argument("--paper", action="store_true", help="also DIR/paper: figures as PDF, tables as LaTeX")
    parser.add_argument("--ompl-log", action="store_true", help="also DIR/ompl: logs for ompl_benchmark_statistics")
    options = parser.parse_args(arguments)
    try:
        written = write(options)
    except (ValueError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    print(*written, sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
