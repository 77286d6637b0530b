# SPDX-License-Identifier: BSD-3-Clause
"""Panels with arms in space, for draw.py."""

import matplotlib
import numpy as np
from mpl_toolkits.mplot3d.art3d import Line3DCollection, Poly3DCollection

from palette import EDGE, GOAL, LONG, OBSTACLE, POSES, SWEEP, TIPS, TRACE
from scene import poses
from surfaces import ball, tube

PROJECTION = "3d"
LINK_SIDES = 8
ROOM = 1.2  # how far around the arm obstacles are shown, over the arm's own size


def extent(scene, paths):
    """Corners of the arm's room, with the obstacles as far as they are near it."""
    arms = [part for part in (scene.start, scene.goal, scene.rail) if part is not None]
    arms += [scene.arm.place(row) for path in paths for row in poses(path, POSES)]
    arms += [] if scene.tip_path is None else [scene.tip_path]
    arm = np.vstack([part.reshape(-1, 3) for part in arms])
    middle = (arm.min(axis=0) + arm.max(axis=0)) / 2.0
    size = ROOM * np.max(arm.max(axis=0) - arm.min(axis=0)) / 2.0
    faces = [face for faces in scene.surfaces.values() for face in faces]
    points = np.vstack([arm, *faces])
    if faces and np.max(np.ptp(points, axis=0)) > LONG * np.max(np.ptp(np.vstack(faces), axis=0)):
        return around(np.vstack(faces))
    low = np.maximum(points.min(axis=0), np.minimum(middle - size, arm.min(axis=0)))
    high = np.minimum(points.max(axis=0), np.maximum(middle + size, arm.max(axis=0)))
    margin = 0.03 * max(high - low) + max(scene.arm.radii)
    return low - margin, high + margin


def around(points):
    low, high = points.min(axis=0), points.max(axis=0)
    margin = 0.1 * max(high - low)
    return low - margin, high + margin


def within(segments, corners):
    """Which of an arm's links lie in the box: a picture in space does not cut off what sticks out."""
    low, high = corners
    return ((segments >= low) & (segments <= high)).all(axis=(1, 2))


def clipped(face, low, high):
    """The part of a polygon within a box (Sutherland and Hodgman); may have no corners."""
    for axis in range(3):
        for sign, bound in ((1, high[axis]), (-1, -low[axis])):
            inside = sign * face[:, axis] <= bound
            corners = []
            for i in range(len(face)):
                a, b = face[i - 1], face[i]
                if inside[i - 1] != inside[i]:
                    corners.append(a + (sign * bound - a[axis]) / (b[axis] - a[axis]) * (b - a))
                if inside[i]:
                    corners.append(b)
            face = np.array(corners).reshape(-1, 3)
    return face


def add_surface(axes, faces, **style):
    axes.add_collection3d(Poly3DCollection(faces, **style))


def draw_scene(axes, scene, corners):
    for faces in scene.surfaces.values():
        shown = [face for face in (clipped(face, *corners) for face in faces) if len(face) > 2]
        if shown:
            add_surface(axes, shown, facecolor=OBSTACLE, edgecolor=EDGE + "50", linewidth=0.2, alpha=0.22)
    if scene.rail is not None:
        axes.plot(*scene.rail.T, color=EDGE, linewidth=1.0)
    if scene.tip_path is not None:
        axes.plot(*scene.tip_path.T, color=GOAL, linewidth=1.0, marker=".", markersize=2.5)
    if scene.target is not None:
        add_surface(axes, ball(*scene.target), facecolor=GOAL, edgecolor="none", alpha=0.3)


def draw_arm(axes, segments, **style):
    axes.add_collection3d(Line3DCollection(segments, capstyle="round", **style))


def draw_end(axes, scene, segments, colour, corners):
    """The arm at the start or the goal, as thick as it is."""
    shown = within(segments, corners)
    links = [(ends, radius) for ends, radius in zip(segments[shown], np.array(scene.arm.radii)[shown]) if radius > 0.0]
    bodies = [face for ends, radius in links for face in tube(*ends, radius, LINK_SIDES)]
    if bodies:
        add_surface(axes, bodies, facecolor=colour, edgecolor="none", alpha=0.3)
    draw_arm(axes, segments[shown], color=colour, linewidth=2.6)


def draw_sweep(axes, scene, path, corners):
    """The arm on its way, dark first, and where its last tip goes."""
    shown = poses(path, POSES)
    for row, colour in zip(shown, matplotlib.colormaps[SWEEP](np.linspace(0.1, 0.9, len(shown)))):
        links = scene.arm.place(row)
        draw_arm(axes, links[within(links, corners)], color=colour, linewidth=1.1, alpha=0.6)
    tips = np.array([scene.arm.place(row)[-1, 1] for row in poses(path, TIPS)])
    tips = tips[((tips >= corners[0]) & (tips <= corners[1])).all(axis=1)]
    axes.plot(*tips.T, color=TRACE, linewidth=0.8, linestyle=":")


def shape(_corners):
    """Height of a panel over its width."""
    return 0.9


def label(axes, caption):
    axes.text2D(0.5, -0.06, caption, transform=axes.transAxes, ha="center", fontsize=8)


def frame(axes, start, corners):
    """Marks the base and sets the view."""
    low, high = corners
    if np.all((start[0, 0] >= low) & (start[0, 0] <= high)):
        axes.plot(*start[0, :1].T, marker="o", color="black", markersize=4)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(high - low, zoom=0.93)
    axes.view_init(elev=24, azim=-58)
    axes.tick_params(labelsize=6, pad=-2)
