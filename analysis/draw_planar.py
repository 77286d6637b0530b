# SPDX-License-Identifier: BSD-3-Clause
"""Panels with arms in the plane, for draw.py."""

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection, PolyCollection

from palette import EDGE, GOAL, LONG, OBSTACLE, POSES, SWEEP, TIPS, TRACE
from scene import capsule, poses

PROJECTION = None


def draw_scene(axes, scene, _corners):
    for vertices in scene.outlines.values():
        axes.add_patch(plt.Polygon(vertices, closed=True, facecolor=OBSTACLE, edgecolor=EDGE, linewidth=0.8))
    if scene.rail is not None:
        axes.plot(*scene.rail.T, color=EDGE, linewidth=1.0, marker="|", zorder=1)
    if scene.target is not None:
        point, tolerance = scene.target
        axes.add_patch(plt.Circle(point, tolerance, facecolor="none", edgecolor=GOAL, linewidth=1.2, zorder=4))


def draw_arm(axes, scene, points, **style):
    axes.add_collection(LineCollection(scene.arm.branches(points), capstyle="round", joinstyle="round", **style))


def draw_end(axes, scene, points, colour, _corners):
    """The arm at the start or the goal, as thick as it is."""
    if scene.arm.radius > 0.0:
        outlines = [capsule(segment, scene.arm.radius) for segment in scene.arm.segments(points)]
        axes.add_collection(PolyCollection(outlines, facecolor=colour, edgecolor="none", alpha=0.35, zorder=2))
    draw_arm(axes, scene, points, color=colour, linewidth=2.2, zorder=3)


def draw_sweep(axes, scene, path, _corners):
    """The arm on its way, dark first, and where its last tip goes."""
    shown = poses(path, POSES)
    for row, colour in zip(shown, matplotlib.colormaps[SWEEP](np.linspace(0.1, 0.9, len(shown)))):
        draw_arm(axes, scene, scene.arm.place(row), color=colour, linewidth=0.9, alpha=0.55)
    tips = np.array([scene.arm.place(row)[-1] for row in poses(path, TIPS)])
    axes.plot(tips[:, 0], tips[:, 1], color=TRACE, linewidth=0.8, linestyle=":")


def extent(scene, paths):
    """Corners of everything that is drawn, with a margin; of the obstacles alone, if the arm reaches LONG times as far."""
    arm = [part for part in (scene.start, scene.goal, scene.rail) if part is not None]
    for path in paths:
        arm += [scene.arm.place(row) for row in poses(path, POSES)]
    obstacles = list(scene.outlines.values())
    points = np.vstack(arm + obstacles)
    if obstacles and np.max(np.ptp(points, axis=0)) > LONG * np.max(np.ptp(np.vstack(obstacles), axis=0)):
        points = np.vstack(obstacles)
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.04 * max(high - low) + scene.arm.radius
    return low - margin, high + margin


def shape(corners):
    """Height of a panel over its width."""
    low, high = corners
    return (high[1] - low[1]) / (high[0] - low[0])


def label(axes, caption):
    axes.set_xlabel(caption, fontsize=8)


def frame(axes, start, corners):
    """Marks the base and sets the view."""
    axes.plot(*start[0], marker="o", color="black", markersize=4, zorder=4)
    low, high = corners
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal")
    axes.tick_params(labelsize=7)
