#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the meshes of the scenes tight_turbine.yaml and tight_vessel.yaml: closed surfaces of triangles, in mm.

  tight_meshes.py FOLDER
"""

import math
import sys
from pathlib import Path

CORNERS = 32  # of what is round


class Mesh:
    def __init__(self):
        self.points, self.faces = [], []

    def add(self, points, faces):
        """A body. \\param faces lists of its points, counted from 0, of three or four corners"""
        first = len(self.points)
        self.points += points
        for face in faces:
            corners = [first + i for i in face]
            self.faces += [corners[:3]] if len(face) == 3 else [corners[:3], [corners[0], corners[2], corners[3]]]

    def write(self, path):
        lines = [f"v {x:.6g} {y:.6g} {z:.6g}" for x, y, z in self.points]
        lines += ["f " + " ".join(str(i + 1) for i in face) for face in self.faces]
        path.write_text("# written by analysis/tight_meshes.py\n" + "\n".join(lines) + "\n")


def circle(radius):
    return [(radius * math.cos(2 * math.pi * i / CORNERS), radius * math.sin(2 * math.pi * i / CORNERS))
            for i in range(CORNERS)]


def square(half):
    """As many points on a square as on a circle, in the same directions; its corners are among them."""
    return [(half * u / max(abs(u), abs(v)), half * v / max(abs(u), abs(v))) for u, v in circle(1.0)]


def ring(mesh, inner, outer, lower, upper, place):
    """What lies between two outlines, extruded. \\param place from (u, v, height) to space"""
    n = len(inner)
    points = [place(u, v, w) for w in (lower, upper) for outline in (inner, outer) for u, v in outline]
    faces = []
    for i in range(n):
        j = (i + 1) % n
        inside, outside, above = 0, n, 2 * n
        faces += [[inside + j, inside + i, outside + i, outside + j],
                  [above + i, above + j, above + outside + j, above + outside + i],
                  [inside + i, inside + j, above + j, above + i],
                  [outside + j, outside + i, above + outside + i, above + outside + j]]
    mesh.add(points, faces)


def blade(mesh, x, angle, staggers, radii, chord, thickness):
    """A blade that twists from its root to its tip. \\param staggers against the axis, at every radius"""
    points = []
    for stagger, radius in zip(staggers, radii):
        for along, across in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            a, c = 0.5 * along * chord, 0.5 * across * thickness
            side = a * math.sin(stagger) + c * math.cos(stagger)
            points.append((x + a * math.cos(stagger) - c * math.sin(stagger),
                           radius * math.cos(angle) - side * math.sin(angle),
                           radius * math.sin(angle) + side * math.cos(angle)))
    last = 4 * (len(radii) - 1)
    faces = [[3, 2, 1, 0], [last, last + 1, last + 2, last + 3]]
    for section in range(0, last, 4):
        faces += [[section + i, section + (i + 1) % 4, section + 4 + (i + 1) % 4, section + 4 + i] for i in range(4)]
    mesh.add(points, faces)


def turbine():
    mesh = Mesh()
    ring(mesh, circle(150), circle(165), 0, 400, lambda u, v, w: (w, u, v))
    degree = math.pi / 180
    for x, sign, phase in ((120, 1, 0.5), (230, -1, 0.0)):
        for i in range(12):
            staggers = [sign * s * degree for s in (25, 35, 45)]
            blade(mesh, x, 2 * math.pi * (i + phase) / 12, staggers, (64, 105, 144), 45, 5)
    return mesh


def vessel():
    mesh = Mesh()
    ring(mesh, circle(30), circle(45), 0, 99, lambda u, v, w: (w, u, v))
    ring(mesh, circle(30), square(300), 100, 120, lambda u, v, w: (w, u, v))
    ring(mesh, circle(40), square(140), -110, -100, lambda u, v, w: (300 + u, 60 + v, w))
    return mesh


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    turbine().write(folder / "turbine.obj")
    vessel().write(folder / "vessel.obj")


if __name__ == "__main__":
    main()
