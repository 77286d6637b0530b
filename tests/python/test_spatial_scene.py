# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest
from conftest import ROOT
from draw_spatial import clipped
from mesh_file import read_faces
from numpy.testing import assert_allclose
from scene import read_scene
from surfaces import SIDES

MESHES = ROOT / "tests" / "data" / "meshes"

CHAIN = """
name: chain
robot:
  kind: spatial_arm
  base: {origin: [1, 2, 3], slide: {axis: [0, 0, 2], limits: [-1, 4]}}
  links: [{length: 2}, {length: 1}]
  radius: 0.1
obstacles: []
start: {slide: 2, joints: [[-90 deg, 0], [0, 90 deg]]}
goal: {tip: [0, 0, 0], tolerance: 0.1}
"""

ELBOW = """
name: elbow
robot:
  kind: spatial_arm
  joints: dh
  base: {origin: [1, 0, 0], rotation: {axis: z, angle: 90 deg}}
  links: [{d: 2, alpha: 90 deg, radius: 0.3}, {alpha: 0}, {theta: 90 deg, a: 1, d: 0.5}]
  radius: 0.1
obstacles: []
start: {joints: [0, 0, 0]}
goal: {joints: [0, 0, -90 deg]}
"""

OBSTACLES = """
  - {name: ball, kind: sphere, center: [1, 2, 3], radius: 2}
  - {name: pill, kind: capsule, from: [0, 0, 0], to: [0, 0, 4], radius: 1}
  - {name: rod, kind: cylinder, axis: [0, 3, 4], center: [0, 0, 0], radius: 0.5, length: 10}
  - {name: line, kind: cylinder, axis: x, center: [50, 1, 1], radius: 0.5, length: inf}
  - {name: crate, kind: box, min: [0, 0, 0], max: [2, 4, 6], rotation: {axis: z, angle: 90 deg}}
  - {name: roof, kind: prism, axis: y, vertices: [[0, 0], [4, 0], [2, 3]], center: [1, 2, 3], length: 10}
  - {name: wedge, kind: prism, axis: x, vertices: [[0, 0], [4, 0], [2, 3]], length: inf}
  - {kind: mesh, file: cube.obj, scale: 2, position: [5, 0, 0], rotation: {axis: z, angle: 90 deg}}
"""


def surfaces(folder=MESHES):
    return read_scene(CHAIN.replace(" []", OBSTACLES), folder).surfaces


def test_places_a_chain_on_a_slide():
    # The slide lifts the base by 2; pitch turns about y, so that -90 degrees point upwards; yaw then turns to the left.
    scene = read_scene(CHAIN)
    assert_allclose(scene.start, [[[1, 2, 5], [1, 2, 7]], [[1, 2, 7], [1, 3, 7]]], atol=1e-15)
    assert_allclose(scene.rail, [[1, 2, 2], [1, 2, 7]])
    assert scene.goal is None and scene.arm.dimension == 5
    assert_allclose(scene.target[0], [0, 0, 0])


def test_places_an_arm_by_denavit_and_hartenberg():
    scene = read_scene(ELBOW)
    up = [[1, 0, 0], [1, 0, 2]]
    # The first joint's x axis is the world's y; after alpha the third joint's z is the world's x.
    assert_allclose(scene.start, [up, [[1, 0, 2], [1.5, 0, 2]], [[1.5, 0, 2], [1.5, 0, 3]]], atol=1e-15)
    assert_allclose(scene.goal, [up, [[1, 0, 2], [1.5, 0, 2]], [[1.5, 0, 2], [1.5, 1, 2]]], atol=1e-15)
    assert scene.arm.radii == [0.3, 0.1, 0.1] and scene.arm.dimension == 3


def test_surfaces_lie_on_the_obstacles():
    faces = {name: np.vstack(parts) for name, parts in surfaces().items()}
    assert_allclose(np.linalg.norm(faces["ball"] - [1, 2, 3], axis=1), 2)
    on_axis = np.clip(faces["pill"][:, 2:], 0, 4) * [0, 0, 1]
    assert np.all(np.linalg.norm(faces["pill"] - on_axis, axis=1) <= 1 + 1e-12)
    height = faces["rod"] @ [0, 0.6, 0.8]
    assert_allclose(np.abs(height), 5)
    assert np.max(np.linalg.norm(faces["rod"] - height[:, None] * [0, 0.6, 0.8], axis=1)) == pytest.approx(0.5)
    assert_allclose(faces["crate"].min(axis=0), [-1, 1, 0], atol=1e-12)
    assert_allclose(faces["crate"].max(axis=0), [3, 3, 6])
    assert_allclose(faces["obstacle 8"].min(axis=0), [3, 0, 0], atol=1e-12)
    assert_allclose(faces["obstacle 8"].max(axis=0), [5, 2, 2])
    assert_allclose(np.unique(faces["roof"], axis=0), [[1, y, 3] for y in (-3, 7)] + [[3, y, 6] for y in (-3, 7)]
                    + [[5, y, 3] for y in (-3, 7)], atol=1e-12)
    wedge = faces["wedge"]
    assert_allclose(np.unique(wedge[:, 1:], axis=0), [[0, 0], [2, 3], [4, 0]], atol=1e-12)
    assert wedge[:, 0].min() < -3 and wedge[:, 0].max() > 5
    line = faces["line"]
    assert line[:, 0].min() < -3 and line[:, 0].max() > 5, "it goes past all of the arm"
    assert np.all(np.hypot(line[:, 1] - 1, line[:, 2] - 1) <= 0.5 + 1e-12)


def test_a_box_has_six_faces_and_round_things_have_many():
    parts = surfaces()
    assert len(parts["crate"]) == 6
    assert len(parts["rod"]) == 3 * SIDES
    assert len(parts["roof"]) == 5


@pytest.mark.parametrize("axis", ["x", "y", "z", "[0, 3, 4]", "[1, 1, 0]", "[0, 0, -1]"])
def test_a_section_is_level_and_upright(axis):
    text = CHAIN.replace(" []", f"\n  - {{kind: prism, axis: {axis}, vertices: [[0, 0], [4, 0], [0, 3]], length: 2}}")
    low, high = read_scene(text).surfaces["obstacle 1"][:2]
    across, up = low[1] - low[0], low[2] - low[0]
    assert across[2] == 0 and max(across[:2], key=abs) > 0
    assert up[2] > 0 or (up[2] == 0 and up[1] > 0)
    assert_allclose([np.linalg.norm(across), np.linalg.norm(up), across @ up], [4, 3, 0], atol=1e-12)
    assert_allclose(high - low, np.tile(high[0] - low[0], (3, 1)), atol=1e-12)
    assert abs(np.cross(across, up) @ (high[0] - low[0])) == pytest.approx(4 * 3 * 2)


def test_a_tip_path_takes_the_place_of_a_goal():
    scene = read_scene(CHAIN.replace("{tip: [0, 0, 0]", "{tip_path: [[0, 0, 0], [1, 0, 3]]"))
    assert scene.goal is None and scene.target is None
    assert_allclose(scene.tip_path, [[0, 0, 0], [1, 0, 3]])


def test_an_unknown_obstacle_is_an_error():
    with pytest.raises(ValueError, match="'blob'"):
        read_scene(CHAIN.replace(" []", OBSTACLES).replace("sphere", "blob"), MESHES)


def test_a_mesh_may_be_kept_in_the_scenario():
    off = (MESHES / "tetrahedron.off").read_text()
    text = CHAIN.replace("[]", "[{kind: mesh, file: part.stl}]") + "files:\n  part.stl: |\n"
    text += "".join(f"    {line}\n" for line in off.splitlines())
    assert len(read_scene(text, "no such folder").surfaces["obstacle 1"]) == 4


@pytest.mark.parametrize("name", ["tetrahedron.obj", "tetrahedron.off", "tetrahedron.stl", "tetrahedron_binary.STL"])
def test_reads_meshes_of_all_formats(name):
    file = MESHES / name
    faces = read_faces(file.read_bytes(), file.suffix)
    assert_allclose(faces[0], [[0, 0, 0], [0, 1, 0], [1, 0, 0]])
    assert_allclose(faces[3], [[0, 1, 0], [0, 0, 0], [0, 0, 1]])
    assert len(faces) == 4


def test_negative_numbers_in_obj_count_backwards():
    assert_allclose(read_faces(b"v 1 0 0\nv 2 0 0\nv 3 0 0\nf -3 -2 -1\n", ".obj")[0][:, 0], [1, 2, 3])


def test_faces_are_clipped_to_what_is_shown():
    square = np.array([[-2, -2, 0.5], [2, -2, 0.5], [2, 2, 0.5], [-2, 2, 0.5]])
    inside = clipped(square, np.zeros(3), np.ones(3))
    assert_allclose(inside.min(axis=0), [0, 0, 0.5])
    assert_allclose(inside.max(axis=0), [1, 1, 0.5])
    assert len(inside) == 4
    assert len(clipped(square + [0, 0, 3], np.zeros(3), np.ones(3))) == 0
