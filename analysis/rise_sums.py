# SPDX-License-Identifier: BSD-3-Clause
"""The sum of rises that goes through start, via and goal with the least jerk, and how little jerk any motion needs: two
linear programs (docs/iostv.md).

All rises last for the whole motion and rest at both ends, so does their sum; which sum it is, is linear in the parts.
What the program promises holds at its samples; between them, 05_via_point_figures certifies.
"""

from dataclasses import dataclass

import numpy as np
from scipy.optimize import linprog


@dataclass
class Task:
    """As the paper's: positions in degrees, times in seconds."""

    start: float
    via: float
    goal: float
    via_time: float
    duration: float


@dataclass
class Rises:
    """Samples over unit time: one row per sample, one column per rise."""

    x: np.ndarray
    value: np.ndarray
    third: np.ndarray



def read_rises(file):
    table = np.genfromtxt(file, delimiter=",", names=True)
    count = int(table["rise"].max()) + 1
    columns = lambda name: table[name].reshape(-1, count)
    return Rises(columns("x")[:, 0], columns("value"), columns("third"))


def least_jerk(task, rises, overshoot):
    """Parts c_i and the jerk J at samples: least J with |q'''| <= J, overshoot kept, via and goal met.

    Raises ValueError if no sum stays within the overshoot, or the via lies between samples.
    """
    at_via = np.flatnonzero(np.isclose(rises.x, task.via_time / task.duration, rtol=0.0, atol=1e-12))
    if at_via.size != 1:
        raise ValueError("the via's time must be a sample")
    jerk = rises.third / task.duration**3
    count = jerk.shape[1]
    low, high = min(task.start, task.via, task.goal), max(task.start, task.via, task.goal)
    bound = np.ones((len(rises.x), 1))
    nothing = np.zeros_like(bound)
    result = linprog(
        np.append(np.zeros(count), 1.0),
        A_ub=np.block([[jerk, -bound], [-jerk, -bound], [rises.value, nothing], [-rises.value, nothing]]),
        b_ub=np.concatenate(
            [
                np.zeros(2 * len(rises.x)),
                np.full(len(rises.x), high + overshoot - task.start),
                np.full(len(rises.x), task.start - low + overshoot),
            ]
        ),
        A_eq=np.block([[rises.value[at_via[0]], 0.0], [np.ones(count), 0.0]]),
        b_eq=[task.via - task.start, task.goal - task.start],
        bounds=[(None, None)] * count + [(0.0, None)],
        method="highs",
    )
    if result.status != 0:
        raise ValueError(result.message)
    return result.x[:-1], result.x[-1]


def steps_of_jerk(task, overshoot, steps=300):
    """The least jerk J of motions with evenly many steps of constant jerk, from rest to rest; their jerk jumps.

    A measure for what smooth motions could reach at best. Raises ValueError if the via lies within a step.
    """
    step = task.duration / steps
    via = task.via_time / step
    if abs(via - round(via)) > 1e-9:
        raise ValueError("the via's time must be a step's end")
    # A step of jerk 1 that ended a time t ago has left this in position, velocity and acceleration.
    ago = step * (np.arange(1, steps + 1)[:, None] - np.arange(steps)[None, :])
    inside = ago > 0.0
    left = lambda power, factor: np.where(inside, (ago**power - np.maximum(ago - step, 0.0) ** power) / factor, 0.0)
    position, velocity, acceleration = left(3, 6.0), left(2, 2.0), left(1, 1.0)
    low, high = min(task.start, task.via, task.goal), max(task.start, task.via, task.goal)
    ones, column = np.ones((steps, 1)), np.zeros((steps, 1))
    result = linprog(
        np.append(np.zeros(steps), 1.0),
        A_ub=np.block([[np.eye(steps), -ones], [-np.eye(steps), -ones], [position, column], [-position, column]]),
        b_ub=np.concatenate(
            [
                np.zeros(2 * steps),
                np.full(steps, high + overshoot - task.start),
                np.full(steps, task.start - low + overshoot),
            ]
        ),
        A_eq=np.hstack([[position[round(via) - 1], position[-1], velocity[-1], acceleration[-1]], np.zeros((4, 1))]),
        b_eq=[task.via - task.start, task.goal - task.start, 0.0, 0.0],
        bounds=[(None, None)] * steps + [(0.0, None)],
        method="highs",
    )
    if result.status != 0:
        raise ValueError(result.message)
    return result.x[-1]
