# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces of obstacles in space, as lists of faces: (n, 3) arrays of corners."""

from pathlib import Path

import numpy as np

from mesh_file import read_faces
from rotations import rotation, unit

SIDES = 24  # of what is round


class Files:
    """The files that a scenario names: kept in it as OFF, or beside it."""

    def __init__(self, kept, folder):
        self.kept = kept
        self.folder = Path(folder)

    def faces(self, name):
        if self.kept is not None:
            return read_faces(self.kept[name].encode(), ".off")
        path = self.folder / name
        return read_faces(path.read_bytes(), path.suffix)


def surface(obstacle, files, middle, far):
    """Faces of an obstacle. \\param middle, far what is endless is shown this far around there"""
    kind = obstacle["kind"]
    if kind == "sphere":
        return ball(np.array(obstacle["center"], dtype=float), obstacle["radius"])
    if kind == "capsule":
        ends = np.array([obstacle["from"], obstacle["to"]], dtype=float)
        return tube(*ends, obstacle["radius"]) + ball(ends[0], obstacle["radius"]) + ball(ends[1], obstacle["radius"])
    if kind == "cylinder":
        return cylinder(obstacle, middle, far)
    if kind == "box":
        return box(obstacle)
    if kind == "prism":
        return prism(obstacle, middle, far)
    if kind == "mesh":
        frame, scale = rotation(obstacle.get("rotation")), float(obstacle.get("scale", 1.0))
        position = np.array(obstacle.get("position", [0, 0, 0]), dtype=float)
        return [position + scale * face @ frame.T for face in files.faces(obstacle["file"])]
    raise ValueError(f"obstacle kind {kind!r} has no surface")


def across(axis):
    """Two unit vectors perpendicular to a third and to each other."""
    first = np.cross(axis, np.eye(3)[np.argmin(np.abs(axis))])
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)


def rings(centers, radii, axis, sides=SIDES):
    """Faces between circles around an axis, from one to the next."""
    u, v = across(axis)
    around = np.linspace(0.0, 2.0 * np.pi, sides, endpoint=False)
    circle = np.cos(around)[:, None] * u + np.sin(around)[:, None] * v
    loops = [center + radius * circle for center, radius in zip(centers, radii)]
    return [
        np.array([low[i], low[(i + 1) % sides], high[(i + 1) % sides], high[i]])
        for low, high in zip(loops, loops[1:])
        for i in range(sides)
    ]


def tube(start, end, radius, sides=SIDES):
    return rings([start, end], [radius, radius], (end - start) / np.linalg.norm(end - start), sides)


def ball(center, radius):
    height = np.linspace(-0.5 * np.pi, 0.5 * np.pi, SIDES // 2 + 1)
    axis = unit("z")
    return rings(center + radius * np.sin(height)[:, None] * axis, radius * np.cos(height), axis)


def cylinder(obstacle, middle, far):
    axis, radius = unit(obstacle["axis"]), obstacle["radius"]
    center, half = np.array(obstacle["center"], dtype=float), float(obstacle["length"]) / 2.0
    if not np.isfinite(half):
        center, half = center + (middle - center) @ axis * axis, far
    ends = [center - half * axis, center + half * axis]
    return rings([ends[0], *ends, ends[1]], [0.0, radius, radius, 0.0], axis)


def box(obstacle):
    low, high = np.array(obstacle["min"], dtype=float), np.array(obstacle["max"], dtype=float)
    middle, frame = (low + high) / 2.0, rotation(obstacle.get("rotation"))
    faces = []
    for axis in range(3):
        for side in (low[axis], high[axis]):
            corners = np.empty((4, 3))
            corners[:, axis] = side
            corners[:, (axis + 1) % 3] = [low[(axis + 1) % 3], high[(axis + 1) % 3]] * 2
            corners[:, (axis + 2) % 3] = np.repeat([low[(axis + 2) % 3], high[(axis + 2) % 3]], 2)
            faces.append(middle + (corners[[0, 1, 3, 2]] - middle) @ frame.T)
    return faces


def section_frame(axis):
    """The plane that a prism's section lies in: x level, towards growing world x or y, and y as upright as can be."""
    level = np.array([-axis[1], axis[0], 0.0]) if np.any(axis[:2] != 0.0) else unit("x")
    level *= np.sign(level[np.argmax(np.abs(level))]) / np.linalg.norm(level)
    up = np.cross(axis, level)
    return level, up if (up[2], up[1]) > (0.0, 0.0) else -up


def prism(obstacle, middle, far):
    axis = unit(obstacle["axis"])
    center, half = np.array(obstacle.get("center", [0, 0, 0]), dtype=float), float(obstacle["length"]) / 2.0
    if not np.isfinite(half):
        center, half = center + (middle - center) @ axis * axis, far
    section = center + np.array(obstacle["vertices"], dtype=float) @ np.array(section_frame(axis))
    low, high = section - half * axis, section + half * axis
    sides = zip(low, np.roll(low, -1, axis=0), np.roll(high, -1, axis=0), high)
    return [low, high, *(np.array(side) for side in sides)]
