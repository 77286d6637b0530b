# SPDX-License-Identifier: BSD-3-Clause
"""Geometry of scenarios in space (`kind: spatial_arm`, docs/scenarios.md): surfaces of obstacles, poses of the arm."""

from dataclasses import dataclass

import numpy as np

from rotations import angle, rotation, turn, unit
from surfaces import Files, surface


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
    target: tuple | None  # (point, tolerance), or:
    tip_path: np.ndarray | None  # (n, 3) places for the tip, one after the other


def read_spatial_scene(data, folder):
    """The scene of a parsed scenario file. \\param folder where the files are that it names"""
    arm = read_arm(data["robot"])
    rail = None
    if arm.slide is not None:
        rail = arm.base + np.array(data["robot"]["base"]["slide"]["limits"], dtype=float)[:, None] * arm.slide
    goal = data["goal"]
    target = (np.array(goal["tip"], dtype=float), float(goal["tolerance"])) if "tip" in goal else None
    tip_path = np.array(goal["tip_path"], dtype=float) if "tip_path" in goal else None
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
        goal=arm.place(read_joints(goal, arm)) if "joints" in goal else None,
        target=target,
        tip_path=tip_path,
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
