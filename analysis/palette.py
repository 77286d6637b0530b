# SPDX-License-Identifier: BSD-3-Clause
"""What pictures in the plane and in space have in common."""

# Okabe and Ito's colours, told apart by colour-blind readers too.
START, GOAL, OBSTACLE, EDGE, TRACE = "#0072B2", "#D55E00", "#B0B0B0", "#606060", "#333333"
SWEEP = "viridis"
POSES = 28  # of the arm on its way
TIPS = 400  # of its last tip
LONG = 2.5  # an arm that reaches so many times as far as all obstacles is shown among them only
