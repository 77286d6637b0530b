# SPDX-License-Identifier: BSD-3-Clause
"""Poses of robots of every kind, for the page's kinematics to agree with.

  kinematics_cases.py OUT.json      writes analysis/viewer/test/kinematics.json anew
"""

import json
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "analysis"))

import numpy as np
from report_scenes import page_scene
from scene import read_scene
from spatial_scene import SpatialScene

PLACE = "start: {START}\ngoal: {START}\nobstacles: []\n"
ROBOTS = {
    "absolute chain": ("links: [{length: 1}, {length: 0.7}, {length: 0.4}]", "angles: [0, 0, 0]"),
    "relative chain on a rail": (
        "angles: relative\n  base: {origin: [0.2, -0.1], slide: {axis: [3, 4], limits: [-1, 1]}}\n"
        "  links: [{length: 1}, {length: 0.7}]",
        "slide: 0, angles: [0, 0]",
    ),
    "relative tree": (
        "angles: relative\n  radius: 0.05\n  links: [{length: 1}, {length: 0.7}, {length: 0.5, parent: 1}, {length: 0.3, parent: 3}]",
        "angles: [0, 0, 0, 0]",
    ),
    "universal chain on a rail": (
        "kind: spatial_arm\n  base: {origin: [1, 2, 3], slide: {axis: [1, 1, 0], limits: [-1, 1]}}\n"
        "  links: [{length: 1}, {length: 0.8}, {length: 0.6}]",
        "slide: 0, joints: [[0, 0], [0, 0], [0, 0]]",
    ),
    "Denavit-Hartenberg arm": (
        "kind: spatial_arm\n  joints: dh\n  base: {origin: [0.1, 0, 0.3], rotation: {axis: [1, 2, 3], angle: 40 deg}}\n"
        "  links: [{d: 0.4, alpha: 90 deg}, {a: 0.9, theta: 0.2}, {d: 0.1, a: 0.7, alpha: -30 deg}]",
        "joints: [0, 0, 0]",
    ),
}


def scenario(robot, start):
    return f"name: case\nrobot:\n  {robot}\n" + PLACE.replace("START", start)


def segments(scene, row):
    """Both ends of every link, whatever the robot."""
    placed = scene.arm.place(row)
    return placed if isinstance(scene, SpatialScene) else np.array(scene.arm.segments(placed))


def cases():
    random = np.random.default_rng(8)
    result = []
    for name, (robot, start) in ROBOTS.items():
        text = scenario(robot, start)
        scene = read_scene(text)
        for _ in range(3):
            row = random.uniform(-3.0, 3.0, scene.arm.dimension).tolist()
            result.append(
                {
                    "name": name,
                    "robot": page_scene(text)["robot"],
                    "row": row,
                    "segments": segments(scene, row).tolist(),
                }
            )
    return result


if __name__ == "__main__":
    Path(sys.argv[1]).write_text(json.dumps(cases(), indent=1) + "\n")
