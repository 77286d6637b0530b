# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scene import capsule, poses, read_scene

GRIPPER = """
name: gripper
robot:
  base: {{origin: [1, 2], slide: {{axis: [0, 2], limits: [-1, 3]}}}}
  links:
    - {{length: 2}}
    - {{length: 1}}
    - {{length: 0.5, parent: 1}}
  angles: {angles}
obstacles: []
start: {{slide: 0, angles: [0, 0, 0]}}
goal: {{tip: [0, 0], tolerance: 0.1}}
"""

CHAIN = """
name: chain
robot: {links: [{length: 2}, {length: 1}]}
obstacles:
  - {name: disc, kind: circle, center: [1, 1], radius: 2}
  - {name: egg, kind: superellipse, center: [1, 1], half_extents: [3, 2], exponent: 6}
  - {name: crate, kind: box, min: [0, 1], max: [2, 5]}
  - {kind: polygon, vertices: [[0, 0], [1, 0], [0, 1]]}
start: {points: [[2, 0], [2, 1]]}
goal: {angles: [90 deg, 0]}
"""


def test_places_a_gripper_on_a_slide():
    # The slide lifts the base by 1 along its unit axis; the first link points up, the second to the left, the third,
    # which begins at the tip of the first, to the right.
    expected = [[1, 3], [1, 5], [0, 5], [1.5, 5]]
    absolute = read_scene(GRIPPER.format(angles="absolute")).arm
    assert_allclose(absolute.place([1, np.pi / 2, np.pi, 0]), expected, atol=1e-15)
    relative = read_scene(GRIPPER.format(angles="relative")).arm
    assert_allclose(relative.place([1, np.pi / 2, np.pi / 2, -np.pi / 2]), expected, atol=1e-15)


def test_a_configuration_is_left_as_it_was():
    row = np.array([1.0, 0.1, 0.2, 0.3])
    read_scene(GRIPPER.format(angles="relative")).arm.place(row)
    assert_allclose(row, [1.0, 0.1, 0.2, 0.3])


def test_branches_cover_every_link_once():
    arm = read_scene(GRIPPER.format(angles="absolute")).arm
    points = arm.place([0, 0.3, 1, -1])
    branches = arm.branches(points)
    assert [len(branch) for branch in branches] == [3, 2]
    drawn = [branch[i : i + 2] for branch in branches for i in range(len(branch) - 1)]
    assert_allclose(drawn, arm.segments(points))


def test_reads_start_goal_and_rail():
    scene = read_scene(CHAIN)
    assert_allclose(scene.start, [[0, 0], [2, 0], [2, 1]])
    assert_allclose(scene.goal, [[0, 0], [0, 2], [1, 2]], atol=1e-15)
    assert scene.rail is None and scene.target is None
    sliding = read_scene(GRIPPER.format(angles="absolute"))
    assert_allclose(sliding.rail, [[1, 1], [1, 5]])
    assert sliding.goal is None
    assert_allclose(sliding.target[0], [0, 0])


def test_outlines_lie_on_the_obstacles():
    outlines = read_scene(CHAIN).outlines
    assert_allclose(np.linalg.norm(outlines["disc"] - [1, 1], axis=1), 2)
    assert_allclose(np.sum(np.abs((outlines["egg"] - [1, 1]) / [3, 2]) ** 6, axis=1), 1)
    assert_allclose(outlines["crate"], [[0, 1], [2, 1], [2, 5], [0, 5]])
    assert len(outlines["obstacle 4"]) == 3


def test_an_unknown_obstacle_is_an_error():
    with pytest.raises(ValueError, match="'blob'"):
        read_scene(CHAIN.replace("circle", "blob"))


def test_a_capsule_is_as_thick_as_its_radius():
    outline = capsule(np.array([[1.0, 1.0], [3.0, 1.0]]), 0.5)
    nearest = np.column_stack([np.clip(outline[:, 0], 1, 3), np.ones(len(outline))])
    assert_allclose(np.linalg.norm(outline - nearest, axis=1), 0.5)


def test_poses_are_evenly_spaced_along_the_path():
    path = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0]]
    assert_allclose(poses(path, 5), [[0, 0], [1, 0], [2, 0], [3, 0], [3, 1]])
    assert_allclose(poses([[1.0, 2.0], [1.0, 2.0]], 5), [[1, 2]])
