#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""VDSM's numbers and figures: what the paper prints beside what is measured (Machines 10 (2022) 1030, Section 6).

  vdsm.py PROGRAM SCENARIOS OUT     PROGRAM is 02_vdsm_tip_path, SCENARIOS the folder of vdsm_*.yaml

Runs the program on the paper's four environments, draws them into OUT and prints the table (Markdown).
"""

import argparse
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

import draw_spatial
from draw import save
from palette import OBSTACLE, TRACE
from scene import read_scene

BENT = 0.05  # degrees; a link angle below this is 0
FLAT_VIEWS = {"front": [0, 2], "side": [1, 2], "top": [0, 1]}


@dataclass
class Motion:
    """All poses of one run; one row each."""

    station: np.ndarray  # of the tip path, where it is reached, else 0
    slide: np.ndarray
    clearance: np.ndarray
    psi: np.ndarray  # degrees
    centres: np.ndarray  # (poses, links + 1, 3)
    cables: np.ndarray

    def at(self, point, last=False):
        """The link angles where the tip is at (y, z), for the first or the last time."""
        near = np.flatnonzero(np.linalg.norm(self.centres[:, -1, 1:] - point, axis=1) < 1.0)
        return self.psi[near[-1 if last else 0]]

    def bent(self, psi):
        return [i + 1 for i, value in enumerate(psi) if value > BENT]

    def turning_joints(self):
        return [i + 1 for i, value in enumerate(self.psi.max(axis=0)) if value > BENT]


def read_motion(file):
    table = np.genfromtxt(file, delimiter=",", names=True)
    columns = lambda part: np.column_stack([table[name] for name in table.dtype.names if name.startswith(part)])
    centres = columns("O")
    return Motion(
        np.nan_to_num(table["station"]),
        table["slide"],
        table["clearance"],
        columns("psi"),
        centres.reshape(len(table), -1, 3),
        columns("cable"),
    )


def axis_distance(motion, plane, centre):
    """Per pose: how near the arm's axis comes to a line, seen along it. \\param plane the two coordinates that show"""
    points = motion.centres[:, :, plane] - centre
    a, along = points[:, :-1], np.diff(points, axis=1)
    square = np.maximum(np.sum(along * along, axis=2), 1e-30)
    share = np.clip(-np.sum(a * along, axis=2) / square, 0.0, 1.0)
    return np.linalg.norm(a + share[..., None] * along, axis=2).min(axis=1)


@dataclass
class Environment:
    name: str
    parameters: list
    plane: list | None = None  # in which its obstacle is round, and where
    centre: tuple = ()


ENVIRONMENTS = [
    Environment("vdsm_none", []),
    Environment("vdsm_obs1", ["mode=paper_vertical"], [1, 2], (700, 600)),
    Environment("vdsm_obs1", [], [1, 2], (700, 600)),
    Environment("vdsm_obs2", [], [1, 2], (400, 400)),
    Environment("vdsm_obs3", [], [0, 1], (2126, 600)),
]


def label(environment):
    return environment.name + ("_" + environment.parameters[0].split("=")[1] if environment.parameters else "")


def numbers(joints):
    return " ".join(map(str, joints)) or "none"


def rows(environment, motion):
    """What the paper says, its figure, ours."""
    paper = {
        "vdsm_none": ("32", "465", "-98"),
        "vdsm_obs1": ("39", "538", "-98"),
        "vdsm_obs2": ("42", "", ""),
        "vdsm_obs3": ("30", "591", ""),
    }[environment.name]
    yield "largest link angle (degrees)", paper[0], f"{motion.psi.max():.1f}"
    yield "largest x0 (mm)", paper[1], f"{motion.slide.max():.1f}"
    yield "least x0 (mm)", paper[2], f"{motion.slide.min():.1f}"
    yield "joints that turn", {"vdsm_none": "1", "vdsm_obs3": "1 4 5 6"}.get(environment.name, ""), numbers(
        motion.turning_joints()
    )
    if environment.name == "vdsm_obs1":
        edge, corner = (1000, 600), (1000, 1300)
        yield "joints bent at A4", "1 7 8", numbers(motion.bent(motion.at(edge)))
        yield "joints bent at A5", "1 4 5 6 7 8", numbers(motion.bent(motion.at(edge, last=True)))
        yield "joints bent at A6", "1 4 5 6", numbers(motion.bent(motion.at(corner)))
    if environment.name == "vdsm_obs3":
        both = np.any((motion.psi[:, 3] > BENT) & (motion.psi[:, 5] > BENT))
        yield "joints 4 and 6 bent together", "never", "at times" if both else "never"
    if environment.plane:
        yield "distance of the axes (mm)", "> 265", f"{axis_distance(motion, environment.plane, environment.centre).min():.1f}"
    yield "clearance of the surfaces (mm)", "", f"{motion.clearance.min():.1f}"


def draw_flat(axes, scene, motion, plane):
    """A view along one axis. \\param plane the two coordinates that show"""
    low, high = bounds(motion)
    for faces in scene.surfaces.values():
        axes.add_collection(PolyCollection([face[:, plane] for face in faces], facecolor=OBSTACLE, edgecolor="none"))
    for pose in some_poses(motion):
        axes.plot(*motion.centres[pose][:, plane].T, color=TRACE, linewidth=0.6, alpha=0.35)
    for joint, colour in enumerate(joint_colours(motion)):
        axes.plot(*motion.centres[:, joint][:, plane].T, color=colour, linewidth=1.2)
    axes.set(xlim=(low[plane[0]], high[plane[0]]), ylim=(low[plane[1]], high[plane[1]]), aspect="equal")
    axes.set(xlabel=f"{'xyz'[plane[0]]} (mm)", ylabel=f"{'xyz'[plane[1]]} (mm)")


def draw_oblique(axes, scene, motion):
    corners = bounds(motion)
    draw_spatial.draw_scene(axes, scene, corners)
    for joint, colour in enumerate(joint_colours(motion)):
        axes.plot(*motion.centres[:, joint].T, color=colour, linewidth=1.0)
    for pose in some_poses(motion):
        arm = motion.centres[pose]
        draw_spatial.draw_arm(axes, np.stack([arm[:-1], arm[1:]], axis=1), color=TRACE, linewidth=0.6, alpha=0.4)
    draw_spatial.frame(axes, motion.centres[0][:, None, :], corners)


def bounds(motion):
    points = motion.centres.reshape(-1, 3)
    margin = 0.05 * np.ptp(points, axis=0).max()
    return points.min(axis=0) - margin, points.max(axis=0) + margin


def some_poses(motion):
    return np.linspace(0, len(motion.centres) - 1, 24, dtype=int)


def joint_colours(motion):
    return matplotlib.colormaps["viridis"](np.linspace(0.0, 0.9, motion.centres.shape[1]))


def draw_views(scene, motion, target):
    figure = plt.figure(figsize=(12, 8), layout="constrained")
    grid = figure.add_gridspec(2, 2)
    for cell, (name, plane) in zip(((0, 0), (0, 1), (1, 0)), FLAT_VIEWS.items()):
        axes = figure.add_subplot(grid[cell])
        draw_flat(axes, scene, motion, plane)
        axes.set_title(name, fontsize=10)
    axes = figure.add_subplot(grid[1, 1], projection="3d")
    draw_oblique(axes, scene, motion)
    axes.set_title("oblique", fontsize=10)
    save(figure, target)


def draw_curves(environment, motion, target):
    figure, grid = plt.subplots(2, 2, figsize=(12, 7), layout="constrained", sharex=True)
    pose = np.arange(len(motion.slide))
    for joint in range(motion.psi.shape[1]):
        grid[0, 0].plot(pose, motion.psi[:, joint], label=f"ψ{joint + 1}", linewidth=1.2)
    grid[0, 0].set(ylabel="link angles (degrees)")
    grid[0, 0].legend(ncols=8, fontsize=7, loc="lower center", bbox_to_anchor=(0.5, 1.0))
    grid[0, 1].plot(pose, motion.slide, color=TRACE)
    grid[0, 1].set(ylabel="x0 (mm)")
    if np.isfinite(motion.clearance).all():
        grid[1, 0].plot(pose, motion.clearance, label="least clearance (also of links from each other)")
    if environment.plane:
        grid[1, 0].plot(pose, axis_distance(motion, environment.plane, environment.centre), label="axis to axis")
    grid[1, 0].set(ylabel="distance to the obstacle (mm)", xlabel="pose")
    if grid[1, 0].lines:
        grid[1, 0].legend(fontsize=8)
    grid[1, 1].plot(pose, motion.cables - motion.cables[0], linewidth=0.8)
    grid[1, 1].set(ylabel="cables, change of length (mm)", xlabel="pose")
    for station in np.flatnonzero(motion.station):
        for axes in grid.flat:
            axes.axvline(station, color="#dddddd", linewidth=0.5, zorder=0)
    save(figure, target)


def main(arguments=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("program", "scenarios", "out"):
        parser.add_argument(name)
    given = parser.parse_args(arguments)
    out = Path(given.out)
    out.mkdir(parents=True, exist_ok=True)
    print("| environment | what | paper | measured |\n|---|---|---:|---:|")
    for environment in ENVIRONMENTS:
        name = label(environment)
        scenario = Path(given.scenarios) / f"{environment.name}.yaml"
        command = [given.program, str(scenario), str(out / f"{name}.csv"), *environment.parameters]
        print(subprocess.run(command, check=True, capture_output=True, text=True).stdout, end="", file=sys.stderr)
        motion = read_motion(out / f"{name}.csv")
        for what, paper, ours in rows(environment, motion):
            print(f"| {name} | {what} | {paper} | {ours} |")
        draw_views(read_scene(scenario.read_text(), scenario.parent), motion, out / f"{name}_views.svg")
        draw_curves(environment, motion, out / f"{name}_curves.svg")
    return 0


if __name__ == "__main__":
    sys.exit(main())
