#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every planner tuned with the same budget: random search on training scenes, judged on others (docs/study.md).

  tune.py TRAINING.cfg HELD_OUT.cfg -o DIR [--program narrows] [--settings 8] [--seed 1] [--jobs 1]

Both files are experiment files that list the planners with their defaults. For every planner `--settings` settings are tried
on the training scenes, the default among them, the others drawn from SPACE. The one that solves most, then is fastest in the
mean up to the limit, goes to the held-out scenes beside the default. Writes DIR/training.cfg, DIR/held_out.cfg, their
databases, and prints the table (Markdown). What is there already is not run again.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import report_rows
from inference import paired, success, survival

# Ranges to draw from, uniform in the logarithm for "log". A planner without an entry has `range` alone.
RANGE = {"range": ("log", 0.03, 3.0)}
BIAS = {"goal_bias": ("uniform", 0.0, 0.5)}
SPACE = {
    "rrtconnect": {**RANGE, "intermediate_states": ("choice", 0, 1)},
    "bkpiece1": {**RANGE, "border_fraction": ("uniform", 0.5, 1.0), "min_valid_path_fraction": ("uniform", 0.05, 0.9)},
    "lbkpiece1": {**RANGE, "border_fraction": ("uniform", 0.5, 1.0)},
    "kpiece1": {**RANGE, **BIAS, "border_fraction": ("uniform", 0.5, 1.0)},
    "est": {**RANGE, **BIAS},
    "stride": {**RANGE, **BIAS, "min_valid_path_fraction": ("uniform", 0.05, 0.9)},
    "rrt": {**RANGE, **BIAS, "intermediate_states": ("choice", 0, 1)},
    "prm": {"max_nearest_neighbors": ("integer", 8, 30)},
    "hppm": {"repulsion": ("log", 1e-3, 0.1), "max_deviation": ("log", 4.0, 100.0), "max_steps": ("integer", 50, 1000)},
    "threader": {
        "gap_width": ("log", 0.005, 0.3),
        "slice_dimensions": ("integer", 2, 8),
        "slice_box": ("log", 1.0, 6.0),
    },
}
PLANNER_LINE = re.compile(r"^([a-z0-9]+)\s*=\s*$")


def drawn(planner, rng):
    """One setting: text by parameter."""
    setting = {}
    for name, (kind, low, high) in SPACE.get(planner, RANGE).items():
        if kind == "choice":
            setting[name] = str(rng.choice([low, high]))
        elif kind == "integer":
            setting[name] = str(rng.integers(low, high + 1))
        else:
            value = np.exp(rng.uniform(np.log(low), np.log(high))) if kind == "log" else rng.uniform(low, high)
            setting[name] = f"{value:.3g}"
    return setting


def split(text):
    """\\return what precedes the [planner] section of an experiment file, and the planners that it lists with defaults
    \\throws ValueError if there is none, or one is listed with parameters"""
    head, mark, section = text.partition("\n[planner]\n")
    if not mark:
        raise ValueError("there is no [planner] section")
    planners = []
    for line in (line.split(";")[0].strip() for line in section.splitlines()):
        found = PLANNER_LINE.match(line)
        if line and not found:
            raise ValueError(f"expected planners with their defaults, not `{line}`")
        if found:
            planners.append(found[1])
    return head, planners


def entries(settings):
    """The lines of a [planner] section. \\param settings (planner, label, parameters)"""
    lines = ["", "[planner]"]
    for planner, label, parameters in settings:
        lines += [f"{planner} =", f"{planner}.name = {label}"]
        lines += [f"{planner}.{name} = {value}" for name, value in parameters.items()]
    return "\n".join(lines) + "\n"


def campaign(program, file, head, settings, jobs):
    """Runs what is missing. \\return its runs"""
    file.write_text(head + entries(settings), encoding="utf-8")
    database = file.with_suffix(".db")
    command = [program, "bench", str(file), "--db", str(database), "--resume", "--jobs", str(jobs)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return report_rows.read_campaign(str(database)).runs


def relocated(head, source, folder):
    """Scenario files are named relative to the experiment file, which is written elsewhere."""

    def absolute(match):
        names = [name.strip() for name in match[2].split(",")]
        paths = [str((source.parent / name).resolve()) for name in names]
        return match[1] + ", ".join(paths)

    head = re.sub(r"^(output\s*=\s*).*$", rf"\g<1>{folder.resolve()}", head, flags=re.M)
    return re.sub(r"^(scenario\s*=\s*)(.*)$", absolute, head, flags=re.M)


def merit(runs):
    """What settings are ranked by: the more solved the better, then the sooner."""
    limit = runs["limit_s"].min()
    return -runs["solved"].mean(), runs["cpu"].where(runs["solved"], limit).mean()


def best(runs, candidates):
    """\\param candidates by planner a list of (label, parameters) \\return the best of each"""
    return {
        planner: min(rows, key=lambda row: merit(runs[runs["label"] == row[0]])) for planner, rows in candidates.items()
    }


def number(value):
    return "never" if np.isinf(value) else f"{float(f'{value:.3g}'):.12g}"


def table(runs, chosen, level=0.95):
    yield "| planner | default: solved | median ms | tuned: solved | % | median ms | tuned to | mean time, default by tuned |"
    yield "|---|---:|---:|---:|---:|---:|---|---:|"
    limit, rng = runs["limit_s"].min(), np.random.default_rng(1)
    rows = []
    for planner, (_, parameters) in chosen.items():
        cells = []
        for label in (planner, f"{planner} tuned"):
            part = survival.observations(runs[runs["label"] == label], limit)
            cells.append((int(part["solved"].sum()), len(part), 1e3 * survival.median(part, level).value))
        low, high = success.interval(cells[1][0], cells[1][1], level)
        ratio = "-"
        if parameters:
            found = paired.compare(runs, f"{planner} tuned", planner, limit, rng, level)
            ratio = f"{number(found.ratio)} ({number(found.ratio_low)} to {number(found.ratio_high)})"
        text = ", ".join(f"{name} {value}" for name, value in parameters.items()) or "the default"
        rows.append(
            (
                cells[1],
                f"| {planner} | {cells[0][0]}/{cells[0][1]} | {number(cells[0][2])} | "
                f"{cells[1][0]}/{cells[1][1]} | {100 * low:.0f} to {100 * high:.0f} | {number(cells[1][2])} | {text} | "
                f"{ratio} |",
            )
        )
    yield from (line for _, line in sorted(rows, key=lambda row: (-row[0][0], row[0][2])))


def tune(options):
    folder = Path(options.output)
    folder.mkdir(parents=True, exist_ok=True)
    training, held_out = Path(options.training), Path(options.held_out)
    head, planners = split(training.read_text(encoding="utf-8"))
    other_head, others = split(held_out.read_text(encoding="utf-8"))
    if planners != others:
        raise ValueError("the two files list different planners")
    rng = np.random.default_rng(options.seed)
    candidates = {}
    for planner in planners:
        settings = [{}, *(drawn(planner, rng) for _ in range(options.settings - 1))]
        candidates[planner] = [(f"{planner} {place}", setting) for place, setting in enumerate(settings)]
    listed = [(planner, *row) for planner, rows in candidates.items() for row in rows]
    runs = campaign(options.program, folder / "training.cfg", relocated(head, training, folder), listed, options.jobs)
    chosen = best(runs, candidates)
    listed = [(planner, planner, {}) for planner in planners]
    listed += [(planner, f"{planner} tuned", setting) for planner, (_, setting) in chosen.items()]
    other_head = relocated(other_head, held_out, folder)
    runs = campaign(options.program, folder / "held_out.cfg", other_head, listed, options.jobs)
    yield from table(runs, chosen)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("training")
    parser.add_argument("held_out")
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--program", default="build/release/narrows")
    parser.add_argument("--settings", type=int, default=8, help="tried per planner, the default among them")
    parser.add_argument("--seed", type=int, default=1, help="of the settings that are drawn")
    parser.add_argument("--jobs", type=int, default=1)
    try:
        for line in tune(parser.parse_args(arguments)):
            print(line)
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
