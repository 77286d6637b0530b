# SPDX-License-Identifier: BSD-3-Clause
"""Geometry of scenarios (`narrows/scenario/1`, docs/scenarios.md); in the plane: outlines of obstacles, poses of the arm."""

from dataclasses import dataclass

import numpy as np
import yaml

from rotations import angle
from spatial_scene import read_spatial_scene

OUTLINE_POINTS = 160


@dataclass
class Arm:
    """A tree of links; `parents` are 0-based with -1 for the base."""

    base: np.ndarray
    slide: np.ndarray | None
    lengths: list
    parents: list
    relative: bool
    radius: float

    @property
    def dimension(self):
        return len(self.lengths) + (self.slide is not None)

    def absolute(self, row):
        """A configuration in the scenario's own convention -> (slide value, absolute link angles)."""
        row = np.asarray(row, dtype=float)
        slide, angles = (row[0], row[1:].copy()) if self.slide is not None else (0.0, row.copy())
        if self.relative:
            for i, parent in enumerate(self.parents):
                if parent >= 0:
                    angles[i] += angles[parent]
        return slide, angles

    def place(self, row):
        """Tips of all links, the base first: an array of shape (links + 1, 2)."""
        slide, angles = self.absolute(row)
        points = [self.base + (slide * self.slide if self.slide is not None else 0.0)]
        for length, parent, angle in zip(self.lengths, self.parents, angles):
            points.append(points[parent + 1] + length * np.array([np.cos(angle), np.sin(angle)]))
        return np.array(points)

    def segments(self, points):
        """One (2, 2) array per link of a placed arm: its base and its tip."""
        return [points[[parent + 1, i + 1]] for i, parent in enumerate(self.parents)]

    def branches(self, points):
        """A placed arm as few polylines: the first from the base, every other from the link where it branches off."""
        chains = []
        last = -1  # the link that the chain at hand ends with
        for i, parent in enumerate(self.parents):
            if i == 0 or parent != last:
                chains.append([parent + 1])
            chains[-1].append(i + 1)
            last = i
        return [points[chain] for chain in chains]


@dataclass
class Scene:
    name: str
    arm: Arm
    outlines: dict  # obstacle name -> (n, 2) vertices
    rail: np.ndarray | None  # both ends of the base's way
    start: np.ndarray  # a placed arm
    goal: np.ndarray | None  # a placed arm, unless only a tip is asked for:
    target: tuple | None  # (point, tolerance)


def read_scene(text, folder="."):
    """The scene of a scenario file's text. The program has checked the file; errors here are ours.

    \\param folder where the files are that it names
    """
    data = yaml.safe_load(text)
    if "generate" in data:
        raise ValueError("a scenario of a family: `narrows generate` writes the file that can be drawn")
    if data["robot"].get("kind") == "spatial_arm":
        return read_spatial_scene(data, folder)
    outlines = {
        obstacle.get("name", f"obstacle {i + 1}"): outline(obstacle) for i, obstacle in enumerate(data["obstacles"])
    }
    arm = read_arm(data["robot"])
    goal = data["goal"]
    target = (np.array(goal["tip"], dtype=float), float(goal["tolerance"])) if "tip" in goal else None
    return Scene(
        name=data["name"],
        arm=arm,
        outlines=outlines,
        rail=read_rail(data["robot"], arm),
        start=read_pose(data["start"], arm),
        goal=read_pose(goal, arm) if target is None else None,
        target=target,
    )


def read_pose(state, arm):
    """Where the base and the tips are in a start or goal, given by angles or by points."""
    slide = float(state.get("slide", 0.0))
    if "points" in state:
        base = arm.base + (slide * arm.slide if arm.slide is not None else 0.0)
        return np.vstack([base, np.array(state["points"], dtype=float)])
    angles = [angle(value) for value in state["angles"]]
    return arm.place(angles if arm.slide is None else [slide, *angles])


def read_rail(robot, arm):
    if arm.slide is None:
        return None
    limits = np.array(robot["base"]["slide"]["limits"], dtype=float)
    return arm.base + limits[:, None] * arm.slide


def read_arm(robot):
    base = robot.get("base", [0, 0])
    slide = None
    if isinstance(base, dict):
        if "slide" in base:
            slide = np.array(base["slide"]["axis"], dtype=float)
            slide /= np.linalg.norm(slide)
        base = base["origin"]
    links = robot["links"]
    parents = [link.get("parent", i) - 1 for i, link in enumerate(links)]
    return Arm(
        base=np.array(base, dtype=float),
        slide=slide,
        lengths=[float(link["length"]) for link in links],
        parents=parents,
        relative=robot.get("angles", "absolute") == "relative",
        radius=float(robot.get("radius", 0.0)),
    )


def outline(obstacle):
    """Vertices around an obstacle."""
    kind = obstacle["kind"]
    if kind == "polygon":
        return np.array(obstacle["vertices"], dtype=float)
    if kind == "box":
        (left, bottom), (right, top) = obstacle["min"], obstacle["max"]
        return np.array([[left, bottom], [right, bottom], [right, top], [left, top]], dtype=float)
    turn = np.linspace(0.0, 2.0 * np.pi, OUTLINE_POINTS, endpoint=False)
    unit = np.column_stack([np.cos(turn), np.sin(turn)])
    center = np.array(obstacle["center"], dtype=float)
    if kind == "circle":
        return center + obstacle["radius"] * unit
    if kind == "superellipse":
        power = 2.0 / obstacle.get("exponent", 4)
        return center + np.array(obstacle["half_extents"]) * np.sign(unit) * np.abs(unit) ** power
    raise ValueError(f"obstacle kind {kind!r} has no outline")


def capsule(segment, radius):
    """Outline of all points within `radius` of a segment."""
    along = segment[1] - segment[0]
    turn = np.arctan2(along[1], along[0]) + np.linspace(-0.5, 0.5, 17) * np.pi
    arc = radius * np.column_stack([np.cos(turn), np.sin(turn)])
    return np.vstack([segment[1] + arc, segment[0] - arc])


def poses(path, count):
    """`count` configurations spread evenly over a path's length in joint space, both ends included."""
    path = np.asarray(path, dtype=float)
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    along = np.concatenate([[0.0], np.cumsum(steps)])
    if along[-1] == 0.0:
        return path[:1]
    wanted = np.linspace(0.0, along[-1], count)
    return np.column_stack([np.interp(wanted, along, column) for column in path.T])
