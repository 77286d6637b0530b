# SPDX-License-Identifier: BSD-3-Clause
"""Angles, axes and rotations as scenarios write them."""

import numpy as np


def angle(value):
    """A scenario's angle: radians, or a text such as "42.5 deg"."""
    if isinstance(value, str):
        return np.radians(float(value.removesuffix("deg")))
    return float(value)


def unit(axis):
    """A direction: x, y, z or a vector."""
    vector = np.eye(3)["xyz".index(axis)] if isinstance(axis, str) else np.array(axis, dtype=float)
    return vector / np.linalg.norm(vector)


def turn(axis, value):
    """Rotation about a unit vector (Rodrigues)."""
    x, y, z = axis
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(value) * cross + (1 - np.cos(value)) * cross @ cross


def rotation(entry):
    return turn(unit(entry["axis"]), angle(entry["angle"])) if entry else np.eye(3)
