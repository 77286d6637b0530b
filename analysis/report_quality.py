# SPDX-License-Identifier: BSD-3-Clause
"""What stored paths are like: way of the tip, turning, and which way round the obstacles they go. Robots in the plane."""

import json
from contextlib import closing

import numpy as np
import yaml
from matplotlib.path import Path as Outline
from report_rows import open_database, scenario_texts
from scene import outline, read_arm
from rotations import angle

STEP = 0.02  # radians between the configurations that a path is looked at
EXPERIMENTS = 150  # scenes whose paths are looked at, spread over all


def finely(path, step=STEP):
    """The configurations of a polyline, `step` or less apart in every joint, its waypoints among them."""
    pieces = [path[:1]]
    for first, last in zip(path[:-1], path[1:]):
        count = max(1, int(np.ceil(np.abs(last - first).max() / step)))
        pieces.append(first + (last - first) * (np.arange(1, count + 1) / count)[:, None])
    return np.concatenate(pieces)


def tips(arm, rows):
    """Tips of all links of many configurations: (configurations, links, 2)."""
    slide = arm.slide is not None
    angles = rows[:, int(slide) :].copy()
    points = np.empty((*angles.shape, 2))
    base = arm.base + rows[:, :1] * arm.slide if slide else np.broadcast_to(arm.base, (len(rows), 2))
    for i, parent in enumerate(arm.parents):
        if arm.relative and parent >= 0:
            angles[:, i] += angles[:, parent]
        along = np.column_stack([np.cos(angles[:, i]), np.sin(angles[:, i])])
        points[:, i] = (points[:, parent] if parent >= 0 else base) + arm.lengths[i] * along
    return points


def turning(path):
    """Sum of the angles between a polyline's segments, radians."""
    along = np.diff(path, axis=0)
    along = along[np.linalg.norm(along, axis=1) > 0.0]
    unit = along / np.linalg.norm(along, axis=1)[:, None]
    return float(np.arccos(np.clip(np.sum(unit[1:] * unit[:-1], axis=1), -1.0, 1.0)).sum())


def curvature(path):
    """Turning by the way, in joint space: 0 if nothing moves."""
    way = float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
    return turning(path) / way if way > 0.0 else 0.0


def turns(points, center):
    """Full turns of every moving point about a fixed one, over and above the shortest that joins its ends.

    \\param points (configurations, points, 2), near to each other in turn compared with their distance from the center
    """
    place = np.arctan2(points[..., 1] - center[1], points[..., 0] - center[0])
    total = np.sum(np.angle(np.exp(1j * np.diff(place, axis=0))), axis=0)
    direct = np.angle(np.exp(1j * (place[-1] - place[0])))
    return np.rint((total - direct) / (2.0 * np.pi)).astype(int)


def homotopy_class(path, points, goal, centers):
    """Whole numbers that no motion of the path with fixed ends changes: paths with different ones are of different
    homotopy classes (those with the same ones may be). Turns of the joints beyond the goal's, and of every link's tip about
    a point inside each obstacle."""
    joints = np.rint((path[-1] - goal) / (2.0 * np.pi)).astype(int)
    return (*joints, *(number for center in centers for number in turns(points, center)))


class PlanarScene:
    """What a scenario's text says of it. \\throws KeyError, ValueError if it is of another kind"""

    def __init__(self, text):
        data = yaml.safe_load(text)
        if data["robot"]["kind"] == "spatial_arm":
            raise ValueError("not in the plane")
        self.arm = read_arm(data["robot"])
        shapes = [outline(obstacle) for obstacle in data["obstacles"]]
        # Turns about a point count only if no link can pass it.
        self.centers = [shape.mean(axis=0) for shape in shapes if Outline(shape).contains_point(shape.mean(axis=0))]
        goal = data["goal"]
        self.goal = None
        if "angles" in goal:
            slide = [float(goal.get("slide", 0.0))] if self.arm.slide is not None else []
            self.goal = np.array([*slide, *(angle(value) for value in goal["angles"])])

    def measure(self, path):
        """\\return the tip's way, the turning and the class (or nothing) of a path"""
        rows = finely(path)
        points = tips(self.arm, rows)
        way = float(np.linalg.norm(np.diff(points[:, -1], axis=0), axis=1).sum())
        kind = homotopy_class(path, points, self.goal, self.centers) if self.goal is not None else None
        return way, turning(path), kind


def chosen(experiments):
    """At most EXPERIMENTS of them, evenly."""
    places = np.unique(np.linspace(0, len(experiments) - 1, EXPERIMENTS).round().astype(int)) if experiments else []
    return [experiments[place] for place in places]


def measured(path, runs):
    """\\return by run: planner, experiment, way, turning, curvature, class"""
    found = {}
    solved = runs[runs["solved"]].set_index("id")[["planner", "experiment"]]
    with closing(open_database(path)) as database:
        stored = [
            row[0] for row in database.execute("SELECT DISTINCT experimentid FROM paths JOIN runs ON runs.id = runid")
        ]
        picked = chosen(sorted(stored))
        for experiment, (text, _) in scenario_texts(path, picked).items():
            try:
                scene = PlanarScene(text)
            except (KeyError, ValueError):
                continue
            query = "SELECT runid, angles FROM paths JOIN runs ON runs.id = runid WHERE experimentid = ? AND solved"
            for run, angles in database.execute(query, (experiment,)):
                planner, _ = solved.loc[run]
                rows = np.array(json.loads(angles), float)
                way, bends, kind = scene.measure(rows)
                found[run] = (planner, experiment, way, bends, curvature(rows), kind)
    return found


def uncommon(found):
    """Share of scenes, by planner, in which its path is not of the class that most planners' paths are of."""
    by_scene = {}
    for planner, experiment, *_, kind in found.values():
        if kind is not None:
            by_scene.setdefault(experiment, []).append((planner, kind))
    votes = {}
    for rows in by_scene.values():
        if len({planner for planner, _ in rows}) < 2:
            continue
        kinds = [kind for _, kind in rows]
        commonest = max(kinds, key=kinds.count)
        for planner, kind in rows:
            votes.setdefault(planner, []).append(kind != commonest)
    return {planner: float(np.mean(row)) for planner, row in votes.items()}


def median(values):
    values = np.asarray([value for value in values if value is not None], float)
    values = values[np.isfinite(values)]
    return float(np.median(values)) if values.size else None


def by_planner(path, runs):
    """\\return rows: planner, solved runs, median length, smoothness, clearance and joint step, paths that were looked at,
    median way of the tip, turning and curvature, share of scenes off the commonest class"""
    found = measured(path, runs)
    shares = uncommon(found)
    rows = []
    for planner, part in runs[runs["solved"]].groupby("planner", sort=False):
        mine = [row for row in found.values() if row[0] == planner]
        columns = [median(part[name]) for name in ("length", "smoothness", "clearance", "joint_step")]
        ways = [median([row[place] for row in mine]) for place in (2, 3, 4)]
        rows.append([planner, len(part), *columns, len(mine), *ways, shares.get(planner)])
    return rows
