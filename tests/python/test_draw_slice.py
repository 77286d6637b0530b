# SPDX-License-Identifier: BSD-3-Clause
import json

import draw_slice
import pytest

VIEW = {
    "scenario": "corridor",
    "status": "reached_goal",
    "joins": True,
    "bottleneck": 0.0123,
    "spacing": 0.05,
    "traced_from": "start",
    "lambda": [-0.1, 1.1],
    "deviation": 1.0,
    "obstacles": [{"name": "C1", "rows": ["....", ".##.", "...."]}, {"name": "C2", "rows": ["....", "....", "...."]}],
    "path": [[0.0, 0.0], [0.5, 0.4], [1.0, 0.0]],
    "curve": [[0.0, 0.0], [0.5, 0.5], [1.0, 0.0]],
    "rejected": [[0.4, 0.3]],
}


def drawn(view, tmp_path):
    (tmp_path / "slice.json").write_text(json.dumps(view))
    draw_slice.main([str(tmp_path / "slice.json"), str(tmp_path / "out.svg")])
    return (tmp_path / "out.svg").read_text()


def test_a_slice_shows_obstacles_curve_and_way(tmp_path):
    svg = drawn(VIEW, tmp_path)
    for text in ("corridor: reached_goal", "bottleneck 0.0123", "C1", "curve", "widest way", "rejected steps"):
        assert text in svg
    assert "C2" not in svg  # is nowhere in this slice


def test_a_slice_that_does_not_join_its_ends_says_so(tmp_path):
    svg = drawn({**VIEW, "joins": False, "path": [], "rejected": [], "status": "turned_back"}, tmp_path)
    assert "no way in this slice (spacing 0.05)" in svg
    assert "widest way" not in svg
    assert "rejected steps" not in svg


@pytest.mark.parametrize("end, other", [("start", "goal"), ("goal", "start")])
def test_ends_are_named_by_where_the_curve_is_traced_from(end, other, tmp_path):
    svg = drawn({**VIEW, "traced_from": end}, tmp_path)
    assert svg.index(f"<!-- {end} -->") < svg.index(f"<!-- {other} -->")


def test_masks_are_true_inside():
    assert draw_slice.mask(VIEW["obstacles"][0]).sum() == 2
