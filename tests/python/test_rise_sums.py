# SPDX-License-Identifier: BSD-3-Clause
import numpy as np
import pytest
from rise_sums import Rises, Task, least_jerk, steps_of_jerk

X = np.linspace(0.0, 1.0, 201)


def powers(*degrees):
    """Rises x^d: easy to know, though they do not rest at the end."""
    value = np.column_stack([X**d for d in degrees])
    third = np.column_stack([d * (d - 1) * (d - 2) * X ** (d - 3) for d in degrees])
    return Rises(X, value, third)


def test_two_rises_leave_no_choice():
    # x^3 a + x^4 b: through 1/4 at 1/2 and 1 at 1 gives a = 3, b = -2; jerk 18 - 48 x in unit time.
    task = Task(start=10.0, via=10.25, goal=11.0, via_time=1.0, duration=2.0)
    parts, jerk = least_jerk(task, powers(3, 4), overshoot=1.0)
    assert parts == pytest.approx([3.0, -2.0], abs=1e-9)
    assert jerk == pytest.approx(30.0 / 8.0, abs=1e-9)


def test_more_rises_never_need_more_jerk():
    task = Task(start=0.0, via=0.6, goal=1.0, via_time=0.5, duration=1.0)
    jerks = [least_jerk(task, powers(*range(3, last)), overshoot=10.0)[1] for last in (5, 6, 8, 10)]
    assert all(better <= worse + 1e-9 for worse, better in zip(jerks, jerks[1:]))
    assert jerks[-1] < 0.9 * jerks[0]


def test_overshoot_is_a_bound_that_costs_jerk():
    task = Task(start=0.0, via=1.0, goal=0.2, via_time=0.5, duration=1.0)
    rises = powers(3, 4, 5, 6, 7, 8)
    free, bound = least_jerk(task, rises, overshoot=10.0), least_jerk(task, rises, overshoot=0.01)
    assert bound[1] > free[1]
    position = rises.value @ bound[0]
    assert position.max() <= 1.01 + 1e-7 and position.min() >= -0.01 - 1e-7


def test_what_cannot_be_done_is_refused():
    task = Task(start=0.0, via=5.0, goal=1.0, via_time=0.5, duration=1.0)
    with pytest.raises(ValueError):
        least_jerk(task, powers(3), overshoot=0.0)
    with pytest.raises(ValueError, match="sample"):
        least_jerk(Task(0.0, 0.5, 1.0, 0.5012, 1.0), powers(3, 4), overshoot=1.0)


def test_steps_of_jerk_reach_the_known_least():
    # A unit move from rest to rest in unit time: jerk +32, -32, -32, +32 for a quarter each, 1/2 at half time.
    task = Task(start=0.0, via=0.5, goal=1.0, via_time=0.5, duration=1.0)
    assert steps_of_jerk(task, overshoot=0.0, steps=40) == pytest.approx(32.0, rel=1e-7)
    with pytest.raises(ValueError, match="step"):
        steps_of_jerk(task, overshoot=0.0, steps=41)
