# SPDX-License-Identifier: BSD-3-Clause
"""What stored paths are like, against closed forms."""

import math

import numpy as np
import pytest
import report_quality
from report_quality import PlanarScene, curvature, finely, homotopy_class, tips, turning, turns

SCENE = """
name: made
robot: {kind: planar_arm, links: [{length: 1}, {length: 0.5}]}
obstacles:
  - {kind: circle, center: [0.2, 0.7], radius: 0.05}
  - {kind: polygon, vertices: [[3, 0], [4, 0], [4, 1], [3.9, 1], [3.9, 0.1], [3.1, 0.1], [3.1, 1], [3, 1]]}
start: {angles: [0, 0]}
goal: {angles: [90 deg, 90 deg]}
"""


def test_a_quarter_turn_of_a_straight_arm():
    way, bends, kind = PlanarScene(SCENE).measure(np.array([[0.0, 0.0], [math.pi / 2, math.pi / 2]]))
    assert way == pytest.approx(1.5 * math.pi / 2, rel=1e-4)  # chords of an arc, 0.02 rad each
    assert bends == 0.0
    assert kind == (
        0,
        0,
        0,
        0,
    )  # two joints; two links about the circle. The middle of the U is free: it does not count


def test_the_long_way_round_is_another_class():
    scene = PlanarScene(SCENE)
    short = np.array([[0.0, 0.0], [math.pi / 2, math.pi / 2]])
    long = np.array([[0.0, 0.0], [-1.5 * math.pi, -1.5 * math.pi]])
    joints = scene.measure(long)[2]
    assert joints[:2] == (-1, -1) and joints != scene.measure(short)[2]
    # More waypoints, another place of them: the same class.
    detour = np.array([[0.0, 0.0], [0.3, -0.4], [1.0, 0.2], [math.pi / 2, math.pi / 2]])
    assert scene.measure(detour)[2] == scene.measure(short)[2]


def test_turns_count_from_the_shortest_way():
    around = np.linspace(0.0, 2.0 * math.pi + 0.5, 200)
    circle = np.column_stack([np.cos(around), np.sin(around)])[:, None]
    assert list(turns(circle, np.zeros(2))) == [1]
    assert list(turns(circle[::-1], np.zeros(2))) == [-1]
    assert list(turns(circle, np.array([3.0, 0.0]))) == [0]


def test_turning_sums_the_corners():
    square = np.array([[0, 0], [1, 0], [1, 0], [1, 1], [0, 1]], float)  # a waypoint twice turns nowhere
    assert turning(square) == pytest.approx(math.pi, abs=1e-12)
    assert curvature(square) == pytest.approx(math.pi / 3.0, abs=1e-12)


def test_curvature_is_that_of_the_circle_and_0_at_rest():
    turn = np.linspace(0.0, 1.5, 400)
    assert curvature(2.5 * np.column_stack([np.cos(turn), np.sin(turn)])) == pytest.approx(1.0 / 2.5, rel=0.01)
    assert curvature(np.zeros((2, 3))) == 0.0


def test_fine_paths_keep_their_waypoints_and_the_step():
    path = np.array([[0.0, 0.0], [0.05, -0.01], [0.05, 1.0]])
    rows = finely(path)
    assert np.abs(np.diff(rows, axis=0)).max() <= report_quality.STEP + 1e-12
    for waypoint in path:
        assert (np.abs(rows - waypoint).max(axis=1) < 1e-12).any()


def test_tips_are_where_the_arm_places_them():
    for extra in ("", "angles: relative, ", "base: {origin: [1, 2], slide: {axis: [1, 1], limits: [-1, 1]}}, "):
        text = SCENE.replace("kind: planar_arm, ", "kind: planar_arm, " + extra)
        if extra.startswith("base"):
            text = text.replace("{angles: [0, 0]}", "{slide: 0, angles: [0, 0]}")
        scene = PlanarScene(text)
        row = np.array([0.3, 0.7, -0.2][: scene.arm.dimension])
        assert np.allclose(tips(scene.arm, row[None])[0], scene.arm.place(row)[1:], atol=1e-12)


def test_the_class_needs_a_goal_of_angles():
    scene = PlanarScene(SCENE.replace("{angles: [90 deg, 90 deg]}", "{tip: [0, 1.5], tolerance: 0.1}"))
    assert scene.measure(np.zeros((2, 2)))[2] is None
    assert homotopy_class(np.zeros((2, 2)), np.ones((2, 2, 2)), np.zeros(2), []) == (0, 0)


def test_the_uncommon_class_is_counted_by_scene():
    found = {1: ("a", 1, 0, 0, (0,)), 2: ("b", 1, 0, 0, (0,)), 3: ("c", 1, 0, 0, (1,)), 4: ("c", 2, 0, 0, (5,))}
    assert report_quality.uncommon(found) == {"a": 0.0, "b": 0.0, "c": 1.0}
