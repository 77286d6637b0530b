#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""IOSTV's numbers and figures: what the paper prints beside what is measured (Appl. Sci. 13 (2023) 1142).

  iostv.py PROGRAM OUT     PROGRAM is 05_via_point_figures

Runs the program, finds the sums of rises with the least jerk, draws the figures into OUT and prints the tables
(Markdown).
"""

import argparse
import csv
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from draw import save
from rise_sums import Task, least_jerk, read_rises, steps_of_jerk

OVERSHOOT = 0.4  # degrees
QUANTITIES = {"position": "°", "velocity": "°/s", "acceleration": "°/s²", "jerk": "°/s³"}
COLOURS = {"full": "#0072B2", "sum of rises": "#009E73"}
PAPER_COLOURS = ["#D55E00", "#CC79A7", "#E69F00"]

# (problem, method, name, printed). Names are those of numbers.csv.
PRINTED = [
    ("1", "Fig. 1", "position after 1 s", "1"),
    ("A", "Fig. 2", "S_v", "-11.9635"),
    ("A", "Fig. 2", "zeta_v", "5.4327"),
    ("A", "Fig. 2", "zeta", "-4.0586"),
    ("A", "Fig. 2", "iterations from S_f", "40"),
    ("A", "Fig. 3", "S_v", "-27.2749"),
    ("B", "Fig. 4", "zeta_v", "-16.6294"),
    ("B", "Fig. 4", "zeta", "-14.8052"),
    ("B", "Fig. 4", "iterations from q_0", "7067"),
    ("B", "Fig. 6", "S_v", "-21.2603"),
    ("B", "Fig. 6", "zeta_v", "-0.7130"),
    ("B", "Fig. 6", "zeta", "-1.0328"),
    ("B", "Fig. 6", "iterations from theta_v", "58"),
    ("C", "sixth order", "highest position", "185.4"),
    ("C", "sixth order", "time of highest position", "1.74"),
    ("C", "sixth order", "highest jerk", "1693"),
    ("C", "sixth order", "lowest jerk", "-1294"),
    ("C", "Eq. 27 as printed", "last position", "120"),
    ("C", "Fig. 8", "zeta_v", "-6.0657"),
    ("C", "Fig. 8", "zeta", "-0.9204"),
    ("C", "Fig. 8", "iterations from q_0", "12"),
    ("C", "Fig. 8", "velocity's jump at the via", "0"),
    ("C", "Fig. 8", "acceleration's jump at the via", "219.824"),
    ("C", "Fig. 8", "highest position", "180.4"),
    ("C", "Fig. 9", "zeta_v", "-3.0399"),
    ("C", "Fig. 9", "zeta", "-2.6193"),
    ("C", "Fig. 9", "iterations from theta_v", "28"),
    ("C", "Fig. 9", "acceleration's jump at the via", "0"),
    ("C", "Fig. 9", "highest jerk", "1394"),
    ("C", "Fig. 9", "lowest jerk", "-1177"),
]

# What each picture shows besides `full` and the sum; Fig. 5 has no printed parameters.
PICTURES = {
    "fig2": ("A", ["Fig. 2"]),
    "fig3": ("A", ["Fig. 3"]),
    "fig4": ("B", ["Fig. 4"]),
    "fig6": ("B", ["Fig. 6"]),
    "fig7": ("C", ["sixth order"]),
    "fig8": ("C", ["Fig. 8"]),
    "fig9": ("C", ["Fig. 9"]),
    "problem-a": ("A", ["Fig. 2", "Fig. 3", "quintic spline"]),
    "problem-b": ("B", ["Fig. 6", "quintic spline"]),
    "problem-c": ("C", ["Fig. 8", "Fig. 9", "sixth order"]),
}


def run(program, out, *sums):
    subprocess.run([program, str(out), *map(str, sums)], check=True)


def read_tasks(file):
    with open(file, newline="", encoding="utf-8") as rows:
        return {row.pop("problem"): Task(**dict(zip(row, map(float, row.values())))) for row in csv.DictReader(rows)}


def write_sums(tasks, out):
    rises = read_rises(out / "rises.csv")
    rows = [[name, *least_jerk(task, rises, OVERSHOOT)[0]] for name, task in tasks.items()]
    with open(out / "sums.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([[name, *map(repr, map(float, parts))] for name, *parts in rows])
    return out / "sums.csv"


def read_numbers(file):
    numbers = {}
    with open(file, newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            numbers[row["problem"], row["method"], row["name"]] = float(row["value"])
    return numbers


def read_samples(file):
    """(problem, method) -> array with time and the four quantities in its columns."""
    samples = defaultdict(list)
    with open(file, newline="", encoding="utf-8") as rows:
        for row in csv.DictReader(rows):
            samples[row["problem"], row["method"]].append([float(row[name]) for name in ("time", *QUANTITIES)])
    return {key: np.array(values) for key, values in samples.items()}


def printed_table(numbers):
    yield "| figure | what | printed | measured |"
    yield "|---|---|---:|---:|"
    for problem, method, name, printed in PRINTED:
        yield f"| {method} | {name} | {printed} | {numbers[problem, method, name]:.6g} |"


def infinite_if(jump, scale, value):
    return "∞" if jump > 1e-6 * scale else f"{value:.1f}"


def comparison_table(tasks, numbers):
    """Where a derivative jumps, the next one is infinite, however finite it is beside the jump."""
    yield "| problem | method | velocity | acceleration | jerk | overshoot | speed at the end |"
    yield "|---|---|---:|---:|---:|---:|---:|"
    for problem in tasks:
        for method in dict.fromkeys(method for own, method, _ in numbers if own == problem):
            value = lambda name: numbers[problem, method, name]
            jumps = [value(f"largest jump of {name}") for name in QUANTITIES]
            peaks = [value(f"largest {name}") for name in QUANTITIES]
            speed = infinite_if(jumps[0], peaks[0], peaks[1])
            force = infinite_if(max(jumps[0], jumps[1]), peaks[1], peaks[2])
            jerk = infinite_if(max(jumps[1] / peaks[1], jumps[2] / peaks[2]), 1.0, peaks[3])
            yield (
                f"| {problem} | {method} | {speed} | {force} | {jerk} | {value('overshoot'):.3g} "
                f"| {abs(value('last velocity')):.3g} |"
            )


def jerk_table(tasks, numbers):
    yield "| problem | full | sum of rises | 300 steps of constant jerk |"
    yield "|---|---:|---:|---:|"
    for problem, task in tasks.items():
        own = [numbers[problem, method, "largest jerk"] for method in ("full", "sum of rises")]
        yield f"| {problem} | {own[0]:.1f} | {own[1]:.1f} | {steps_of_jerk(task, OVERSHOOT):.1f} |"


def draw(task, samples, problem, methods, target):
    figure, grid = plt.subplots(2, 2, figsize=(10, 6.4), layout="constrained", sharex=True)
    curves = [(method, colour, 1.4) for method, colour in zip(methods, PAPER_COLOURS)]
    curves += [(method, colour, 1.4) for method, colour in COLOURS.items() if (problem, method) in samples]
    for axes, (column, (quantity, unit)) in zip(grid.flat, enumerate(QUANTITIES.items(), 1)):
        for method, colour, width in curves:
            table = samples[problem, method]
            axes.plot(table[:, 0], table[:, column], color=colour, linewidth=width, label=method)
        axes.set(ylabel=f"{quantity} ({unit})")
        if quantity != "position":
            axes.axhline(0.0, color="#bbbbbb", linewidth=0.6, zorder=0)
        axes.axvline(task.via_time, color="#bbbbbb", linewidth=0.6, zorder=0)
    times, points = [0.0, task.via_time, task.duration], [task.start, task.via, task.goal]
    grid[0, 0].plot(times, points, "o", color="black", markersize=4)
    for axes in grid[1]:
        axes.set(xlabel="time (s)")
    grid[0, 0].legend(fontsize=8, frameon=False)
    with plt.rc_context({"svg.fonttype": "none"}):  # letters as text: smaller files
        save(figure, target)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("out")
    given = parser.parse_args(arguments)
    out = Path(given.out)
    run(given.program, out)
    tasks = read_tasks(out / "problems.csv")
    run(given.program, out, write_sums(tasks, out))
    numbers, samples = read_numbers(out / "numbers.csv"), read_samples(out / "samples.csv")
    for line in (*printed_table(numbers), "", *comparison_table(tasks, numbers), "", *jerk_table(tasks, numbers)):
        print(line)
    for name, (problem, methods) in PICTURES.items():
        draw(tasks[problem], samples, problem, methods, out / f"iostv-{name}.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
