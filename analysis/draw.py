#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of arms among obstacles.

  draw.py run SCENARIO.yaml RECORD.json OUT.svg     one run, as `narrows plan --json` writes it
  draw.py campaign RESULTS.db -o DIR                one picture per group of scenarios (a sweep's seeds are one),
                                                  of its first one; one panel per planner: its best run
"""

import argparse
import json
import math
import sqlite3
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import draw_planar
import draw_spatial
from palette import GOAL, START
from scene import read_scene
from spatial_scene import SpatialScene

COLUMNS = 4


@dataclass
class Panel:
    title: str
    caption: str
    path: list
    missing: str = "no verified path"


def view_of(scene):
    """The module that draws it."""
    return draw_spatial if isinstance(scene, SpatialScene) else draw_planar


def draw_panel(axes, scene, panel, corners):
    view = view_of(scene)
    axes.set_title(panel.title, fontsize=10, fontweight="bold")
    view.draw_scene(axes, scene, corners)
    start, goal = scene.start, scene.goal
    if panel.path:
        view.draw_sweep(axes, scene, panel.path, corners)
        start, goal = scene.arm.place(panel.path[0]), scene.arm.place(panel.path[-1])
    view.draw_end(axes, scene, start, START, corners)
    if goal is not None:
        view.draw_end(axes, scene, goal, GOAL, corners)
    view.frame(axes, start, corners)
    view.label(axes, panel.caption)
    if not panel.path:
        axes.figure.text(0.5, 0.03, panel.missing, transform=axes.transAxes, ha="center", fontsize=10)


def save(figure, target):
    target = Path(target)
    target.parent.mkdir(parents=True, exist_ok=True)
    # A fixed salt and no date: the same run gives the same file.
    with plt.rc_context({"svg.hashsalt": "narrows"}):
        figure.savefig(target, metadata={"Date": None} if target.suffix == ".svg" else None)
    plt.close(figure)


def draw_panels(scene, panels, target, heading=None):
    columns = min(COLUMNS, len(panels))
    rows = math.ceil(len(panels) / columns)
    view = view_of(scene)
    corners = view.extent(scene, [panel.path for panel in panels if panel.path])
    shape = view.shape(corners)
    flat = view.PROJECTION is None
    width = 3.2 if columns > 1 else 6.4
    labels = 0.62  # inches for a panel's title and caption
    figure, grid = plt.subplots(
        rows,
        columns,
        figsize=(width * columns, (0.93 * width * shape + labels) * rows + (0.6 if heading else 0.0)),
        squeeze=False,
        sharex=flat,
        sharey=flat,
        layout="constrained",
        subplot_kw={"projection": view.PROJECTION},
    )
    for axes, panel in zip(grid.flat, panels):
        draw_panel(axes, scene, panel, corners)
        if flat:
            axes.tick_params(labelbottom=True)
    for axes in list(grid.flat)[len(panels) :]:
        axes.set_visible(False)
    if heading:
        figure.suptitle(heading, fontsize=11 if columns > 2 else 8)
    save(figure, target)


def milliseconds(seconds):
    return "no time" if seconds is None else f"{1000.0 * seconds:.3g} ms"


def draw_run(scenario, record, target):
    scene = read_scene(Path(scenario).read_text(), Path(scenario).parent)
    data = json.loads(Path(record).read_text())
    path = (data.get("path") or {}).get("angles") or []
    caption = data["outcome"] + (f" ({data['reason']})" if data.get("reason") else "")
    caption += f", CPU {milliseconds(data.get('cpu_s'))}"
    draw_panels(scene, [Panel(f"{data['planner']} on {scene.name}", caption, path, missing="no path")], target)


RUNS = """
SELECT experiments.scenario AS scenario, instances.scenario AS text,
       json_extract(instances.options, '$.group') AS family, plannerConfigs.name AS label, runs.id AS id,
       runs.solved AS solved, runs.cpu_time AS cpu, runs.solution_length AS length, runs.prescribed AS prescribed,
       experiments.checker AS checker
FROM runs JOIN experiments ON experiments.id = runs.experimentid JOIN instances USING (experimentid)
     JOIN plannerConfigs ON plannerConfigs.id = runs.plannerid
ORDER BY experiments.id, runs.id
"""


def panel_of(database, label, runs):
    """The shortest verified path of a planner's runs on one scenario, and how it did under the first checker."""
    first = [run for run in runs if run["checker"] == runs[0]["checker"]]
    times = sorted(run["cpu"] for run in first if run["solved"])
    caption = f"{len(times)}/{len(first)} solved"
    if times:
        caption += f", CPU median {milliseconds(float(np.median(times)))}"
    path = []
    for run in sorted((run for run in runs if run["solved"]), key=lambda run: run["length"]):
        row = database.execute("SELECT angles FROM paths WHERE runid = ?", (run["id"],)).fetchone()
        if row is not None:
            path = json.loads(row["angles"])
            break
    return Panel(label + ("*" if runs[0]["prescribed"] else ""), caption, path)


def draw_campaign(path, folder):
    """\\return the files that were written."""
    database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    database.row_factory = sqlite3.Row
    scenarios, shown = {}, {}
    for run in database.execute(RUNS):
        if shown.setdefault(run["family"], run["scenario"]) != run["scenario"]:
            continue
        scenario = scenarios.setdefault(run["scenario"], {"text": run["text"], "labels": {}})
        scenario["labels"].setdefault(run["label"], []).append(run)
    written = []
    for name, scenario in scenarios.items():
        panels = [panel_of(database, label, runs) for label, runs in scenario["labels"].items()]
        panels.sort(key=lambda panel: panel.title)
        starred = any(panel.title.endswith("*") for panel in panels)
        checker = next(iter(scenario["labels"].values()))[0]["checker"]
        heading = f"{name}: shortest verified path of each planner, start blue, goal orange (checker {checker})"
        if starred:
            heading += "\n* uses the recipe prescribed for this scenario"
        target = Path(folder) / f"{name}.svg"
        draw_panels(read_scene(scenario["text"]), panels, target, heading)
        written.append(target)
    database.close()
    return written


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Pictures of arms among obstacles")
    commands = parser.add_subparsers(dest="command", required=True)
    run = commands.add_parser("run", help="one run, as `narrows plan --json` writes it")
    run.add_argument("scenario")
    run.add_argument("record")
    run.add_argument("out")
    campaign = commands.add_parser("campaign", help="one picture per group of scenarios")
    campaign.add_argument("database")
    campaign.add_argument("-o", "--output", required=True)
    given = parser.parse_args(arguments)
    if given.command == "run":
        draw_run(given.scenario, given.record, given.out)
    else:
        for target in draw_campaign(given.database, given.output):
            print(target)


if __name__ == "__main__":
    sys.exit(main())
