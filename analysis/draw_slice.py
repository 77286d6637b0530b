#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A picture of the slice of joint space in which HPPM followed a curve.

  draw_slice.py SLICE.json OUT.svg      SLICE.json as `narrows plan --slice` writes it
"""

import argparse
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import to_rgba
from matplotlib.patches import Patch

from draw import save

FREE = "#ffffff"
CURVE = "#c0392b"


def mask(obstacle):
    """True where the obstacle is met, one row per value of s."""
    return np.array([[cell == "#" for cell in row] for row in obstacle["rows"]])


def answer(view):
    if view["joins"]:
        return f"the slice joins start and goal (bottleneck {view['bottleneck']:.3g})"
    return f"no way in this slice (spacing {view['spacing']:.2g})"


def draw(view, target):
    figure, axes = plt.subplots(figsize=(8, 6), layout="constrained")
    extent = [*view["lambda"], -view["deviation"], view["deviation"]]
    legend = []
    colours = plt.get_cmap("tab10")
    for index, obstacle in enumerate(view["obstacles"]):
        inside = mask(obstacle)
        if not inside.any():
            continue
        colour = to_rgba(colours(index % 10), 0.45)
        image = np.zeros((*inside.shape, 4))
        image[inside] = colour
        axes.imshow(image, extent=extent, origin="lower", aspect="auto", interpolation="nearest")
        legend.append(Patch(color=colour, label=obstacle["name"]))
    if view["path"]:
        axes.plot(*zip(*view["path"]), color="#2c7fb8", lw=1.2, ls="--", label="widest way")
    axes.plot(*zip(*view["curve"]), color=CURVE, lw=1.4, marker=".", ms=3, label="curve")
    if view["rejected"]:
        axes.plot(*zip(*view["rejected"]), color="black", ls="", marker="x", ms=4, mew=0.7, label="rejected steps")
    first, last = ("goal", "start") if view["traced_from"] == "goal" else ("start", "goal")
    for name, place in ((first, 0.0), (last, 1.0)):
        axes.plot([place], [0.0], "o", color="black", ms=6)
        axes.annotate(name, (place, 0.0), xytext=(6, 6), textcoords="offset points", fontweight="bold")
    axes.set(xlim=extent[:2], ylim=extent[2:], xlabel="λ", ylabel="s (rad)")
    axes.set_title(f"{view['scenario']}: {view['status']}; {answer(view)}", fontsize=10)
    handles, _ = axes.get_legend_handles_labels()
    axes.legend(handles=legend + handles, fontsize=8, loc="best")
    save(figure, target)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("slice")
    parser.add_argument("out")
    options = parser.parse_args(arguments)
    with open(options.slice, encoding="utf-8") as file:
        draw(json.load(file), options.out)
    return 0


if __name__ == "__main__":
    sys.exit(main())
