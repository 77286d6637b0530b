# SPDX-License-Identifier: BSD-3-Clause
"""Geometry of scenarios in space (`kind: spatial_arm`, docs/scenarios.md): surfaces of obstacles, poses of the arm."""

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from mesh_file import read_faces

SIDES = 24  # of what is round


def angle(value):
    """A scenario's angle: radians, or a text such as "42.5 deg"."""
    if isinstance(value, str):
        return np.radians(float(value.removesuffix("deg")))
    return float(value)


def unit(axis):
    """A direction: x, y, z or a vector."""
    vector = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else np.array(axis, dtype=float)
    return vector / np.linalg.norm(vector)


def turn(axis, value):
    """Rotation about a unit vector (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(value) * cross + (1 - np.cos(value)) * cross @ cross


def rotation(entry):
    return turn(unit(entry["axis"]), angle(entry["angle"])) if entry else np.eye(3)


@dataclass
class UniversalChain:
    """Links with pitch about y, then yaw about z, stretched along x at zero; a configuration is [slide,] pitch, yaw, ..."""

    base: np.ndarray
    slide: np.ndarray | None
    lengths: list
    radii: list

    @property
    def dimension(self):
        return 2 * len(self.lengths) + (self.slide is not None)

    def place(self, row):
        """Both ends of every link: an array of shape (links, 2, 3)."""
        row = np.asarray(row, dtype=float)
        point, frame = self.base, np.eye(3)
        if self.slide is not None:
            point, row = point + row[0] * self.slide, row[1:]
        segments = []
        for length, (pitch, yaw) in zip(self.lengths, row.reshape(-1, 2)):
            frame = frame @ turn(unit("y"), pitch) @ turn(unit("z"), yaw)
            segments.append([point, point + length * frame[:, 0]])
            point = segments[-1][1]
        return np.array(segments)


@dataclass
class DenavitHartenbergArm:
    """Rz(q + theta) Tz(d) Tx(a) Rx(alpha) per row; links along d and a where these are not 0."""

    base: np.ndarray
    frame: np.ndarray
    rows: list  # (theta, d, a, alpha)
    radii: list  # one per link
    slide = None

    @property
    def dimension(self):
        return len(self.rows)

    def place(self, row):
        """Both ends of every link: an array of shape (links, 2, 3)."""
        point, frame = self.base, self.frame
        segments = []
        for value, (theta, d, a, alpha) in zip(row, self.rows):
            frame = frame @ turn(unit("z"), value + theta)
            for step in (d * frame[:, 2], a * frame[:, 0]):
                if np.any(step != 0.0):
                    segments.append([point, point + step])
                    point = point + step
            frame = frame @ turn(unit("x"), alpha)
        return np.array(segments)


@dataclass
class SpatialScene:
    name: str
    arm: UniversalChain | DenavitHartenbergArm
    surfaces: dict  # obstacle name -> list of (n, 3) faces
    rail: np.ndarray | None  # both ends of the base's way
    start: np.ndarray  # a placed arm
    goal: np.ndarray | None  # a placed arm, unless only a tip is asked for:
    target: tuple | None  # (point, tolerance)


def read_spatial_scene(data, folder):
    """The scene of a parsed scenario file. \\param folder where the files are that it names"""
    arm = read_arm(data["robot"])
    rail = None
    if arm.slide is not None:
        rail = arm.base + np.array(data["robot"]["base"]["slide"]["limits"], dtype=float)[:, None] * arm.slide
    goal = data["goal"]
    target = (np.array(goal["tip"], dtype=float), float(goal["tolerance"])) if "tip" in goal else None
    start = arm.place(read_joints(data["start"], arm))
    files = Files(data.get("files"), folder)
    far = 2.0 * sum(np.linalg.norm(start[:, 1] - start[:, 0], axis=1)) + (0 if rail is None else np.ptp(rail))
    return SpatialScene(
        name=data["name"],
        arm=arm,
        surfaces={
            obstacle.get("name", f"obstacle {i + 1}"): surface(obstacle, files, arm.base, far)
            for i, obstacle in enumerate(data["obstacles"])
        },
        rail=rail,
        start=start,
        goal=arm.place(read_joints(goal, arm)) if target is None else None,
        target=target,
    )


def read_joints(state, arm):
    values = [angle(value) for value in np.ravel(np.array(state["joints"], dtype=object))]
    return values if arm.slide is None else [float(state["slide"]), *values]


def read_arm(robot):
    base = robot.get("base", [0, 0, 0])
    base = base if isinstance(base, dict) else {"origin": base}
    origin = np.array(base["origin"], dtype=float)
    radius = float(robot.get("radius", 0.0))
    links = robot["links"]
    if robot.get("joints", "universal") == "universal":
        slide = unit(base["slide"]["axis"]) if "slide" in base else None
        return UniversalChain(origin, slide, [float(link["length"]) for link in links], [radius] * len(links))
    rows = [
        (angle(link.get("theta", 0)), float(link.get("d", 0)), float(link.get("a", 0)), angle(link.get("alpha", 0)))
        for link in links
    ]
    radii = [float(link.get("radius", radius)) for link, row in zip(links, rows) for part in row[1:3] if part != 0.0]
    return DenavitHartenbergArm(origin, rotation(base.get("rotation")), rows, radii)


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
