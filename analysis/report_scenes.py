# SPDX-License-Identifier: BSD-3-Clause
"""Scenes as the report's page draws them: robots with what their kinematics needs, obstacles as outlines or triangles."""

import numpy as np
import yaml

from scene import read_scene
from spatial_scene import SpatialScene, UniversalChain

TRIANGLES = 20000  # of one scene; obstacles beyond are not shown
DIGITS = 6  # that count, of coordinates


def rounded(values):
    """Nested lists with numbers of DIGITS digits."""
    array = np.asarray(values, dtype=float)
    return (
        np.vectorize(lambda value: float(f"{value:.{DIGITS}g}"), otypes=[float])(array).tolist() if array.size else []
    )


def page_scene(text):
    """\\return a dictionary for analysis/viewer/src/model.ts (Scene)"""
    scene = read_scene(text)
    data = yaml.safe_load(text)
    page = spatial_page(scene) if isinstance(scene, SpatialScene) else planar_page(scene, data)
    page["name"] = scene.name
    page["dimension"] = scene.arm.dimension
    if scene.rail is not None:
        page["rail"] = rounded(scene.rail)
    if scene.target is not None:
        page["target"] = {"point": rounded(scene.target[0]), "tolerance": scene.target[1]}
    return page


def planar_page(scene, data):
    arm = scene.arm
    robot = {"kind": "planar", "base": arm.base.tolist(), "lengths": arm.lengths, "parents": arm.parents}
    robot.update({"relative": arm.relative, "radii": [arm.radius] * len(arm.lengths)})
    if arm.slide is not None:
        robot["slide"] = arm.slide.tolist()
    obstacles = []
    for obstacle, (name, outline) in zip(data["obstacles"], scene.outlines.items()):
        if obstacle["kind"] == "circle":
            shape = {"circle": [*rounded(obstacle["center"]), float(obstacle["radius"])]}
        else:
            shape = {"outline": rounded(outline)}
        obstacles.append({"name": name, **shape})
    return {"robot": robot, "obstacles": obstacles, "leftOut": 0}


def spatial_page(scene):
    obstacles, triangles, left_out = [], 0, 0
    for name, faces in scene.surfaces.items():
        mesh = triangulated(faces)
        triangles += len(mesh["triangles"])
        if triangles > TRIANGLES:
            left_out += 1
        else:
            obstacles.append({"name": name, **mesh})
    page = {"robot": spatial_robot(scene.arm), "obstacles": obstacles, "leftOut": left_out}
    if scene.tip_path is not None:
        page["tipPath"] = rounded(scene.tip_path)
    return page


def spatial_robot(arm):
    if isinstance(arm, UniversalChain):
        robot = {"kind": "universal", "base": arm.base.tolist(), "lengths": arm.lengths, "radii": arm.radii}
        return {**robot, "slide": arm.slide.tolist()} if arm.slide is not None else robot
    # In full: these are multiplied along the arm.
    return {
        "kind": "dh",
        "base": arm.base.tolist(),
        "frame": arm.frame.tolist(),
        "rows": [list(row) for row in arm.rows],
        "radii": arm.radii,
    }


def triangulated(faces):
    """Corners without repeats, and triangles of their numbers. The faces are convex, so each is a fan."""
    corners = np.array(rounded(np.vstack(faces)))
    vertices, numbers = np.unique(corners, axis=0, return_inverse=True)
    triangles, at = [], 0
    for face in faces:
        fan = numbers[at : at + len(face)]
        triangles += [[int(fan[0]), int(a), int(b)] for a, b in zip(fan[1:], fan[2:])]
        at += len(face)
    kept = [triangle for triangle in triangles if len(set(triangle)) == 3]
    return {"vertices": vertices.tolist(), "triangles": kept}
